// Rows, then columns: the frame of the one-dimensional, the asymmetric and the compensated resampler
// (Oliveira, Bishop and McAllister 2000; Clua 2004, 8.2).
//
// Pass 1 takes every row of the source to pixel columns, pass 2 every column to pixels. Rows do not know
// of one another, nor do columns; so both passes are shared among threads, with a barrier between them,
// and the number of threads changes no byte (the thesis's cut into bands, 8.7, has no rows between the
// bands and tests no depth where they overlap). Between the passes a column holds one sample of a row:
// where a row folds, the nearest.
//
// A method is a struct with
//   static void adjust(sample, a, b, t, warp)  what it does to a sample at t between a and b that was
//   interpolated
//                                              perspective-correctly, with its row carried along
//   carries_row                                whether pass 2 takes the row that was carried; else it finds
//   the
//                                              row by itself, from the displacement
#pragma once
#include "raster/fast/workers.hpp"
#include "relief/resample_column.hpp"

namespace relevo::relief {

// The picture between the passes: window.width by rows of the source. Kind::Empty: no sample.
template <bool maps>
using RowSamples = Image<RowSample<maps>>;

// The horizontal pass is complete.
template <bool maps>
struct RowsResampled {
    const RowSamples<maps>& samples;
    const Window& window;
};

template <bool maps, class Method, class Probe = const pipeline::NoProbe>
void resample_two_passes(Method, const PreparedRelief& relief, const Warp& warp,
                         const PrewarpSettings& settings, Prewarped& result, Probe&& probe = {}) {
    const DepthWarp constants(warp);
    const OcclusionOrder order = occlusion_order(warp, settings.painting);
    const Window& window = result.window;
    const int rows = relief.camera.height;
    RowSamples<maps> samples(window.width, rows);
    raster::fast::Workers workers(settings.threads, false);
    const int bands = settings.threads > 1 ? 8 * settings.threads : 1;
    const auto cut = [&](int band, int size) { return static_cast<int>(std::int64_t{size} * band / bands); };

    workers.run(bands, [&](int band, int) {
        WarpedRow row(relief.camera.width);
        for (int y = cut(band, rows); y < cut(band + 1, rows); ++y) {
            RowSample<maps>* const to = samples.row(y);
            warp_row(relief, warp, window, y, row);
            resample_row<maps, Method>(relief, row, constants, order, window,
                                       [&](int x) -> RowSample<maps>& { return to[x]; });
        }
    });
    pipeline::note<RowsResampled<maps>>(probe, samples, window);

    workers.run(bands, [&](int band, int) {
        const int first = cut(band, window.width), last = cut(band + 1, window.width);
        const Scalar y0 = static_cast<Scalar>(window.y0);
        ColumnResampler<maps> columns(relief, constants, Painter<maps>(result, settings.depth_test), window,
                                      first, last);
        columns.run(order, rows, [&](int y, auto&& emit) {
            if (y < 0 || y >= rows) return;
            const RowSample<maps>* const from = samples.row(y);
            for (int x = first; x < last; ++x) {
                if (from[x].kind == Kind::Empty) continue;
                RowSample<maps>& sample = emit(x);
                sample = from[x];
                if (!Method::carries_row)
                    sample.v =
                        warped_v(static_cast<Scalar>(y) + Scalar(0.5), sample.carried.depth(), constants) -
                        y0;
            }
        });
    });
}

}  // namespace relevo::relief
