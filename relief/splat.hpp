// The simplest of pre-warps: every texel paints the pixel that it falls into, nearest last. It leaves holes
// where the picture is stretched, and shows the order of painting undisguised.
#pragma once
#include "relief/resample_column.hpp"

namespace relevo::relief {

template <bool maps>
void splat(const ReliefTexture& texture, const Warp& warp, const PrewarpSettings& settings,
           Prewarped& result) {
    const Window& window = result.window;
    const Painter<maps> painter(result, settings.depth_test);
    const RowWarper<maps> warp_row(texture, warp, window, settings);
    WarpedRow<maps> row(texture.camera.width);
    row.y = -1;
    for_each_in_order(
        occlusion_order(warp, settings.painting), texture.camera.width, texture.camera.height,
        [&](int x, int y) {
            if (row.y != y) warp_row(y, row);
            const Scalar u = row.u[x], v = row.v[x];
            if (!texture.coverage.row(y)[x] || !(u >= 0 && u < static_cast<Scalar>(window.width)) ||
                !(v >= 0 && v < static_cast<Scalar>(window.height)))
                return;
            painter.paint(static_cast<int>(u), static_cast<int>(v), row.carried[x], Kind::Sampled);
        });
}

}  // namespace relevo::relief
