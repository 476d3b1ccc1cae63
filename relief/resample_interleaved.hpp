// The interleaved resampler: one pass over the source (Clua 2004, 8.2.3; Oliveira, "Relief texture
// mapping", dissertation, UNC 2000).
//
// Each sample of a row goes to its column at once, so nothing of the horizontal result is stored but one
// line, and a row that folds loses nothing: every sample is drawn, where the two-pass forms keep one a
// column.
#pragma once
#include "relief/resample_asymmetric.hpp"

namespace relevo::relief {

template <bool maps>
void resample_interleaved(const PreparedRelief& relief, const Warp& warp, const PrewarpSettings& settings,
                          Prewarped& result) {
    const DepthWarp constants(warp);
    const OcclusionOrder order = occlusion_order(warp, settings.painting);
    const Window& window = result.window;
    const int rows = relief.camera.height;
    const std::unique_ptr<WarpedRow> row = make_warped_row();
    using Columns = ColumnResampler<maps>;
    Columns columns(relief, constants, Painter<maps>(result, settings.depth_test), window, 0, window.width,
                    true);
    columns.run(order, rows, [&](int y, typename Columns::Line& line) {
        line.clear();
        if (y < 0 || y >= rows) return;
        warp_row(relief, warp, window, y, *row);
        resample_row<maps, AsymmetricMethod>(relief, *row, constants, order, window,
                                             [&line](int x, auto&& sample) {
                                                 if (line.samples.count[x] != 0) return line.add(x, sample());
                                                 line.samples.count[x] = 1, line.samples.set(x, sample());
                                             });
        line.span = occupied(line.samples.count, window.width);
    });
}

}  // namespace relevo::relief
