// The interleaved resampler: one pass over the source (Clua 2004, 8.2.3; Oliveira, "Relief texture
// mapping", dissertation, UNC 2000).
//
// Each sample of a row goes to its column at once, so nothing of the horizontal result is stored but one
// line, and a row that folds loses no surface: every sample is drawn, where the two-pass forms keep one a
// column. (Skins and half texels that fold back are behind what they hang from: no form draws them.)
#pragma once
#include "pipeline/probe.hpp"
#include "relief/resample_asymmetric.hpp"

namespace relevo::relief {

// A sample of row `row` of the source goes to its column x: in the order in which they are drawn.
template <bool maps>
struct SampleSent {
    int x, row;
    const RowSample<maps>& sample;
};
// All samples of the row are sent. What lies between them and those of the row before is painted next.
struct RowSent {
    int row;
};

template <bool maps, class Probe = const pipeline::NoProbe>
void resample_interleaved(const PreparedRelief& relief, const Warp& warp, const PrewarpSettings& settings,
                          Prewarped& result, Probe&& probe = {}) {
    const DepthWarp constants(warp);
    const OcclusionOrder order = occlusion_order(warp, settings.painting);
    const Window& window = result.window;
    const int rows = relief.camera.height;
    const std::unique_ptr<WarpedRow> row = make_warped_row();
    using Columns = ColumnResampler<maps>;
    Columns columns(relief, constants, Painter<maps>(result, settings.depth_test), window, 0, window.width,
                    true);
    columns.run(row_steps(order, rows), [&](int y, typename Columns::Line& line) {
        line.clear();
        if (y < 0 || y >= rows) return;
        warp_row(relief, warp, window, y, *row);
        resample_row<maps, AsymmetricMethod>(relief, *row, constants, order, window,
                                             [&](int x, auto&& sample) {
                                                 if constexpr (pipeline::Wants<Probe, SampleSent<maps>>)
                                                     pipeline::note<SampleSent<maps>>(probe, x, y, sample());
                                                 if (line.samples.count[x] != 0) return line.add(x, sample());
                                                 line.samples.count[x] = 1, line.samples.set(x, sample());
                                             });
        line.span = occupied(line.samples.count, window.width);
        pipeline::note<RowSent>(probe, y);
    });
}

}  // namespace relevo::relief
