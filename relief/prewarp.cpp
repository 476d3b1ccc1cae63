#include "relief/prewarp.hpp"

#include "relief/resample_asymmetric.hpp"
#include "relief/resample_compensated.hpp"
#include "relief/resample_interleaved.hpp"
#include "relief/resample_mesh.hpp"
#include "relief/resample_one_dimensional.hpp"
#include "relief/splat.hpp"

namespace relevo::relief {
namespace {

template <class Pixel>
void fit(Image<Pixel>& image, int width, int height) {
    if (image.width() != width || image.height() != height) image = Image<Pixel>(width, height);
}

template <bool maps>
void resample(const PreparedRelief& relief, const Warp& warp, const PrewarpSettings& settings,
              Prewarped& result, PrewarpMemory::Parts& memory) {
    switch (settings.resampler) {
        case Resampler::Splat:
            return splat<maps>(relief, warp, settings, result);
        case Resampler::OneDimensional:
            return resample_picture<maps>(OneDimensionalMethod{}, relief, warp, settings, result, memory);
        case Resampler::Asymmetric:
            return resample_picture<maps>(AsymmetricMethod{}, relief, warp, settings, result, memory);
        case Resampler::Compensated:
            return resample_picture<maps>(CompensatedMethod{}, relief, warp, settings, result, memory);
        case Resampler::Interleaved:
            return resample_picture<maps>(InterleavedMethod{}, relief, warp, settings, result, memory);
        case Resampler::Mesh:
            return MeshResampler<maps>(relief, warp, result).run();
    }
}

}  // namespace

PrewarpMemory::PrewarpMemory() : parts_(std::make_unique<Parts>()) {}
PrewarpMemory::~PrewarpMemory() = default;
PrewarpMemory::PrewarpMemory(PrewarpMemory&&) noexcept = default;
PrewarpMemory& PrewarpMemory::operator=(PrewarpMemory&&) noexcept = default;

void prewarp(const PreparedRelief& relief, const Warp& warp, const Window& window,
             const PrewarpSettings& settings, Prewarped& result, PrewarpMemory& memory) {
    assert(warp.projection == relief.camera.projection);
    assert(0 < window.width && window.width <= pipeline::max_picture_size);
    assert(0 < window.height && window.height <= pipeline::max_picture_size);
    assert(settings.threads >= 1);
    result.window = window;
    const int width = window.width, height = window.height, map_width = settings.maps ? width : 0,
              map_height = settings.maps ? height : 0;
    fit(result.color, width, height), fit(result.normal, width, height), fit(result.depth, width, height);
    fit(result.coverage, width, height);
    fit(result.source, map_width, map_height), fit(result.kind, map_width, map_height);
    fit(result.writes, map_width, map_height);
    settings.maps ? resample<true>(relief, warp, settings, result, memory.parts())
                  : resample<false>(relief, warp, settings, result, memory.parts());
}

void prewarp(const PreparedRelief& relief, const Warp& warp, const Window& window,
             const PrewarpSettings& settings, Prewarped& result) {
    PrewarpMemory memory;
    prewarp(relief, warp, window, settings, result, memory);
}

Prewarped prewarp(const ReliefTexture& texture, const Warp& warp, const Window& window,
                  const PrewarpSettings& settings) {
    Prewarped result;
    prewarp(prepare(texture, settings.jump, settings.jump_depth), warp, window, settings, result);
    return result;
}

}  // namespace relevo::relief
