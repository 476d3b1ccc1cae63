// The part of the plane that the warped picture can reach. Texels leave the square of the source towards
// the viewer's side whenever the viewer's foot lies outside of it; a picture of the source's size would
// cut them off (from 40 degrees a third of a sphere; the thesis does not mention it).
//
// For a given depth the warp keeps the order of places, and for a given place it runs one way with the
// depth: the four extreme maps (first and last border, nearest and deepest texel) bound all others.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "relief/warp.hpp"

namespace relevo::relief {

// Texels x0 <= x < x0 + width by y0 <= y < y0 + height of the source plane's grid.
struct Window {
    int x0 = 0, y0 = 0, width = 0, height = 0;
    friend constexpr bool operator==(const Window&, const Window&) = default;
};
inline Window source_window(const ReliefCamera& camera) { return {0, 0, camera.width, camera.height}; }

// The smallest and the largest depth (displacement or disparity) of the covered texels.
struct DepthRange {
    Scalar low = 0, high = 0;
    bool empty = true;  // no texel is covered
};
inline DepthRange depth_range(const ReliefTexture& texture) {
    DepthRange range;
    const auto& covered = texture.coverage.pixels();
    const auto& depth = texture.depth.pixels();
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (covered[i] == 0) continue;
        range.low = range.empty ? depth[i] : std::min(range.low, depth[i]);
        range.high = range.empty ? depth[i] : std::max(range.high, depth[i]);
        range.empty = false;
    }
    return range;
}

// The window that holds the source's square and every warped texel whole; the square alone when there is
// none. An error when it would be larger than max_picture_size: the viewer then sees the plane too
// nearly edge-on.
inline Result<Window> target_window(const ReliefCamera& camera, const Warp& warp, const DepthRange& range) {
    if (range.empty) return source_window(camera);
    double low[2] = {0, 0}, high[2] = {double(camera.width), double(camera.height)};
    const auto include = [&](const WarpedPoint& p) {
        low[0] = std::min(low[0], p.u), high[0] = std::max(high[0], p.u);
        low[1] = std::min(low[1], p.v), high[1] = std::max(high[1], p.v);
    };
    for (const Scalar depth : {range.low, range.high})
        for (const int share : {0, 1}) {
            const double u = share * camera.width, v = share * camera.height;
            include(warp.projection == Projection::Orthographic ? warp_point(warp, u, v, Displacement{depth})
                                                                : warp_point(warp, u, v, Disparity{depth}));
        }
    constexpr double most = pipeline::max_picture_size;
    for (int k = 0; k < 2; ++k) {
        low[k] = std::floor(low[k]), high[k] = std::ceil(high[k]);
        if (!(high[k] - low[k] <= most))
            return pipeline::Error{"the warped picture would be more than " +
                                   std::to_string(pipeline::max_picture_size) +
                                   " texels a side: the viewer is too close to the relief's plane"};
    }
    return Window{int(low[0]), int(low[1]), int(high[0] - low[0]), int(high[1] - low[1])};
}

}  // namespace relevo::relief
