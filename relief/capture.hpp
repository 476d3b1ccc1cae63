// Where relief textures come from. A capture is anything that can be asked for the relief texture of a
// camera:
//
//   capture(camera) -> Result<ReliefTexture>
//
// so that warps, boxes of six faces and impostors need not know whether rays were cast (RayCapture), the
// rasterizer was run (RasterCapture, capture_raster.hpp), or something else was: a volume, a scanner.
#pragma once
#include <concepts>
#include <utility>

#include "relief/ray_cast.hpp"

namespace relevo::relief {

template <class C>
concept Capture = requires(const C& capture, const ReliefCamera& camera) {
    { capture(camera) } -> std::same_as<Result<ReliefTexture>>;
};

// By casting rays; the surface is borrowed. Refused: a camera that `refusal` refuses.
template <RayCastable Surface>
struct RayCapture {
    const Surface& surface;
    Result<ReliefTexture> operator()(const ReliefCamera& camera) const {
        if (auto error = refusal(camera)) return *std::move(error);
        return ray_cast(surface, camera);
    }
};
template <class Surface>
RayCapture(const Surface&) -> RayCapture<Surface>;

}  // namespace relevo::relief
