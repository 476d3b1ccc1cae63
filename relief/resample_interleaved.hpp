// The interleaved resampler: one pass over the source (Clua 2004, 8.2.3; Oliveira, "Relief texture mapping",
// dissertation, UNC 2000).
//
// Each sample of a row goes to its column at once, so nothing of the horizontal result is stored but one
// line, and a row that folds loses nothing: every sample is drawn, where the two-pass forms keep one a
// column.
#pragma once
#include "relief/resample_column.hpp"

namespace relevo::relief {

template <bool maps>
void resample_interleaved(const ReliefTexture& texture, const Warp& warp, const PrewarpSettings& settings,
                          Prewarped& result) {
    const DepthWarp constants(warp);
    const OcclusionOrder order = occlusion_order(warp, settings.painting);
    const Window& window = result.window;
    const RowWarper<maps> warp_row(texture, warp, window, settings);
    const int rows = texture.camera.height;
    WarpedRow<maps> row(texture.camera.width);
    ColumnResampler<maps> columns(constants, settings, Painter<maps>(result, settings.depth_test), window, 0,
                                  window.width);
    columns.run(order, rows, [&](int y, auto&& sink) {
        if (y < 0 || y >= rows) return;
        warp_row(y, row);
        resample_row(
            row, constants, order, window,
            [&](int k, Scalar t) { return lerp(row.carried[k], row.carried[k + 1], t); }, sink);
    });
}

}  // namespace relevo::relief
