// Sprites with depth: a warp in two passes, the depths forwards, the colours backwards (Shade, Gortler, He
// and Szeliski, "Layered depth images", SIGGRAPH 1998, section 4; Clua 2004, 3.2).
//
//   1  every texel's displacement is painted where the texel goes, in the painter's order; a pixel that none
//      falls into, between two that have one, takes their mean
//   2  every pixel asks the source for the colour of the place that its displacement says it comes from
//
// Displacement is smooth, so that holes and rounding of the first pass show little, and colour is read once,
// bilinearly.
#pragma once
#include <algorithm>
#include <utility>

#include "relief/prewarp.hpp"
#include "relief/texel_shares.hpp"

namespace relevo::relief {

namespace sprite_detail {

// Where no texel fell between two that did, the mean of the two; of several pairs the nearest.
inline void fill_holes(Prewarped& picture) {
    const Image<std::uint8_t> covered = picture.coverage;
    const Image<Scalar> depth = picture.depth;
    const auto holds = [&](int x, int y) { return covered.holds(x, y) && covered.at(x, y); };
    for (int y = 0; y < covered.height(); ++y)
        for (int x = 0; x < covered.width(); ++x) {
            if (covered.at(x, y)) continue;
            for (const auto& [i, j] : {std::pair(1, 0), {0, 1}, {1, 1}, {1, -1}}) {
                if (!holds(x - i, y - j) || !holds(x + i, y + j)) continue;
                const Scalar mean = (depth.at(x - i, y - j) + depth.at(x + i, y + j)) / 2;
                const bool first = !picture.coverage.at(x, y);
                picture.coverage.at(x, y) = 1;
                picture.depth.at(x, y) = first ? mean : std::min(picture.depth.at(x, y), mean);
            }
        }
}

}  // namespace sprite_detail

// The warped picture on the source's plane. The source is orthographic; `jump` as in texel_shares.hpp, world
// units.
inline Prewarped warp_sprite_with_depth(const ReliefTexture& texture, const Warp& warp, const Window& window,
                                        double jump = 0.1) {
    assert(warp.projection == Projection::Orthographic);
    Prewarped picture = prewarp(texture, warp, window, {.resampler = Resampler::Splat});
    sprite_detail::fill_holes(picture);
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x) {
            if (!picture.coverage.at(x, y)) continue;
            const glm::dvec2 from = unwarp_point(warp, window.x0 + x + 0.5, window.y0 + y + 0.5,
                                                 Displacement{picture.depth.at(x, y)});
            const auto shares = texel_shares(
                texture.camera.width, texture.camera.height, from.x, from.y, Reading::Bilinear, jump,
                [&](int i, int j) { return texture.coverage.at(i, j) != 0; },
                [&](int i, int j) { return double{texture.depth.at(i, j)}; });
            picture.coverage.at(x, y) = shares.has_value();
            if (!shares) continue;
            picture.color.at(x, y) = weighted_sum(*shares, LinearRgb{}, [&](int i, int j, double share) {
                return static_cast<Scalar>(share) * texture.color.at(i, j);
            });
            picture.normal.at(x, y) = weighted_sum(*shares, Vec3(0), [&](int i, int j, double share) {
                return static_cast<Scalar>(share) * texture.normal.at(i, j);
            });
        }
    return picture;
}

}  // namespace relevo::relief
