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
#include "pipeline/probe.hpp"
#include "relief/prewarp_memory.hpp"
#include "relief/resample_column.hpp"

namespace relevo::relief {

// The horizontal pass is complete: the picture between the passes, window.width by rows of the source.
template <bool maps>
struct RowsResampled {
    const SampleLines<maps>& samples;
    const Window& window;
};

template <bool maps, class Method, class Probe = const pipeline::NoProbe>
void resample_two_passes(Method, const PreparedRelief& relief, const Warp& warp,
                         const PrewarpSettings& settings, Prewarped& result, PrewarpMemory::Parts& memory,
                         Probe&& probe = {}) {
    const DepthWarp constants(warp);
    const OcclusionOrder order = occlusion_order(warp, settings.painting);
    const Window& window = result.window;
    const int rows = relief.camera.height;
    SampleLines<maps>& samples = memory.template samples_for<maps>();
    samples.fit(window.width, rows);
    std::vector<raster::Span> spans(static_cast<std::size_t>(rows),
                                    raster::Span{0, 0});  // of each row's samples
    raster::fast::Workers& workers = memory.workers_for(settings.threads);
    const int bands = settings.threads > 1 ? 8 * settings.threads : 1;
    const auto cut = [&](int band, int size) { return static_cast<int>(std::int64_t{size} * band / bands); };

    workers.run(bands, [&](int band, int) {
        const std::unique_ptr<WarpedRow> row = make_warped_row();
        for (int y = cut(band, rows); y < cut(band + 1, rows); ++y) {
            const SampleLine<maps> line = samples.clear_row(y);
            warp_row(relief, warp, window, y, *row);
            resample_row<maps, Method>(relief, *row, constants, order, window, [line](int x, auto&& sample) {
                line.count[x] = 1, line.set(x, sample());
            });
            spans[static_cast<std::size_t>(y)] = occupied(line.count, window.width);
        }
    });
    pipeline::note<RowsResampled<maps>>(probe, samples, window);

    workers.run(bands, [&](int band, int) {
        const int first = cut(band, window.width), last = cut(band + 1, window.width);
        const Scalar y0 = static_cast<Scalar>(window.y0);
        SampleLines<maps> none;
        none.fit(last - first, 1), none.clear_row(0);
        using Columns = ColumnResampler<maps>;
        Columns columns(relief, constants, Painter<maps>(result, settings.depth_test), window, first, last,
                        false);
        columns.run(order, rows, [&](int y, typename Columns::Line& line) {
            line.samples = none.row(0), line.span = {0, 0};
            if (y < 0 || y >= rows) return;
            const auto [x0, x1] = spans[static_cast<std::size_t>(y)];
            line.samples = samples.row(y).from(first);
            line.span = {std::clamp(x0, first, last) - first, std::clamp(x1, first, last) - first};
            if (Method::carries_row) return;
            for (int x = line.span.x0; x < line.span.x1; ++x)
                if (line.samples.count[x] != 0)
                    line.samples.v[x] = warped_v(static_cast<Scalar>(y) + Scalar(0.5),
                                                 line.samples.carried[x].depth(), constants) -
                                        y0;
        });
    });
}

}  // namespace relevo::relief
