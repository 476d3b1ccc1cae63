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
//   static void adjust(sample, a, b, t, warp)   what it does to a sample at t between a and b that was
//                                               interpolated perspective-correctly, its row carried along
//   carries_row                                 whether pass 2 takes the row that was carried; else it
//                                               finds the row by itself, from the displacement
#pragma once
#include <span>

#include "pipeline/probe.hpp"
#include "relief/prewarp_memory.hpp"
#include "relief/resample_column.hpp"

namespace relevo::relief {

// A row of the source is resampled: its samples in the columns of the window.
template <bool maps>
struct RowResampled {
    int row;
    const SampleLines<maps>& samples;
    int line;  // of them
    RowSample<maps> at(int x) const { return samples.at(x, line); }
};

// So many rows are resampled before the columns take them: what lies between the passes stays in the cache,
// where a whole picture of it would not (1024 x 1024: 45 MB).
inline constexpr int rows_between_passes = 64;

template <bool maps, class Method, class Probe = const pipeline::NoProbe>
void resample_two_passes(Method, const PreparedRelief& relief, const Warp& warp,
                         const PrewarpSettings& settings, Prewarped& result, PrewarpMemory::Parts& memory,
                         Probe&& probe = {}) {
    const DepthWarp constants(warp);
    const OcclusionOrder order = occlusion_order(warp, settings.painting);
    const Window& window = result.window;
    const int rows = relief.camera.height;
    // Two blocks of rows in turn: the columns still hold the last row of the one before.
    SampleLines<maps>& samples = memory.template samples_for<maps>();
    samples.fit(window.width, 2 * rows_between_passes);
    std::array<raster::Span, 2 * rows_between_passes> spans;  // of each row's samples
    raster::fast::Workers& workers = memory.workers_for(settings.threads);
    // Of columns; narrow ones cost more than they balance.
    const int bands = settings.threads > 1 ? 2 * settings.threads : 1;
    const auto cut = [&](int band) { return static_cast<int>(std::int64_t{window.width} * band / bands); };
    std::vector<std::unique_ptr<WarpedRow>> warped;  // one a thread
    for (int i = 0; i < workers.count(); ++i) warped.push_back(make_warped_row());
    std::vector<ColumnResampler<maps>> columns;  // one a band
    columns.reserve(static_cast<std::size_t>(bands));
    for (int band = 0; band < bands; ++band)
        columns.emplace_back(relief, constants, Painter<maps>(result, settings.depth_test), window, cut(band),
                             cut(band + 1), false);

    const auto pass_1 = [&](int y, int line_number, WarpedRow& row) {
        const SampleLine<maps> line = samples.clear_row(line_number);
        spans[static_cast<std::size_t>(line_number)] = {0, 0};
        if (y < 0 || y >= rows) return;
        warp_row(relief, warp, window, y, row);
        resample_row<maps, Method>(relief, row, constants, order, window, [line](int x, auto&& sample) {
            line.count[x] = 1, line.set(x, sample());
        });
        spans[static_cast<std::size_t>(line_number)] = occupied(line.count, window.width);
    };
    const auto pass_2 = [&](int band, std::span<const RowStep> steps, int line_number) {
        const int first = cut(band), last = cut(band + 1);
        using Line = typename ColumnResampler<maps>::Line;
        columns[static_cast<std::size_t>(band)].run(steps, [&](int y, Line& line) {
            const auto [x0, x1] = spans[static_cast<std::size_t>(line_number)];
            line.samples = samples.row(line_number++).from(first);
            line.span = {std::clamp(x0, first, last) - first, std::clamp(x1, first, last) - first};
            if (Method::carries_row) return;
            for (int x = line.span.x0; x < line.span.x1; ++x)
                if (line.samples.count[x] != 0)
                    line.samples.v[x] = warped_v(static_cast<Scalar>(y) + Scalar(0.5),
                                                 line.samples.carried[x].depth(), constants) -
                                        static_cast<Scalar>(window.y0);
        });
    };

    const std::vector<RowStep> all = row_steps(order, rows);
    int half = 0;
    for (std::span<const RowStep> left(all); !left.empty(); half = rows_between_passes - half) {
        const auto steps = left.first(std::min(left.size(), std::size_t{rows_between_passes}));
        const int count = static_cast<int>(steps.size());
        workers.run(count, [&](int i, int worker) {
            pass_1(steps[static_cast<std::size_t>(i)].row, half + i, *warped[std::size_t(worker)]);
        });
        for (int i = 0; i < count; ++i)
            if (const int y = steps[static_cast<std::size_t>(i)].row; 0 <= y && y < rows)
                pipeline::note<RowResampled<maps>>(probe, y, samples, half + i);
        workers.run(bands, [&](int band, int) { pass_2(band, steps, half); });
        left = left.subspan(steps.size());
    }
}

}  // namespace relevo::relief
