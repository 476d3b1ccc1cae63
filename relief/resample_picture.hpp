// Rows, then columns: the frame of the four resamplers (Oliveira, Bishop and McAllister 2000; Clua
// 2004, 8.2).
//
// A row of the source goes to pixel columns; then each column paints the pixels between its sample of this
// row and that of the row before. A column knows nothing of its neighbours. So the window is cut into bands
// of columns, one a thread, that share nothing but the source and do not wait for one another: where the
// bands are cut changes no byte (the thesis cuts the source into bands of rows, 8.7; nothing is drawn between
// those, and no depth tested where they overlap).
//
//     source row y  ->  Line: samples 0..columns-1  ->  pixels between it and the line before
//
// A method is a struct with
//   static void adjust(sample, a, b, t, warp)   what it does to a sample at t between a and b that was
//                                               interpolated perspective-correctly, its row carried along
//   carries_row                                 whether columns take the row that was carried; else they
//                                               find the row by themselves, from the displacement
//   keeps_all                                   whether a column that a folded row reaches several times
//                                               keeps all samples; else only the nearest, painted last
#pragma once
#include <numeric>

#include "pipeline/probe.hpp"
#include "relief/prewarp_memory.hpp"
#include "relief/resample_column.hpp"

namespace relevo::relief {

// A sample of row `row` of the source goes to its column x: in the order of painting.
template <bool maps>
struct SampleSent {
    int x, row;
    const RowSample<maps>& sample;
};
// The samples of a row are complete. What lies between them and those of the row before is painted next.
template <bool maps>
struct RowResampled {
    int row;
    const SampleLine<maps>& samples;
    RowSample<maps> at(int x) const { return samples.at(x); }  // the first to come there
};

// The columns at which the window is cut, so that the bands have about as much work: a sample counts as three
// texels, with which the times of two bands come out alike.
inline std::vector<int> cuts_between_bands(const PreparedRelief& relief, const Warp& warp,
                                           const Window& window, int bands, WarpedRow& row) {
    if (bands == 1) return {0, window.width};
    const int every = std::max(relief.camera.height / 16, 1);  // row is asked
    std::vector<std::int64_t> work(std::size_t(window.width) + 1);
    row.y = -1;
    for (int y = every / 2; y < relief.camera.height; y += every) {
        warp_row(relief, warp, window, whole(window), y, row);
        const Gap* const gaps = relief.gap.row(y) + 1;
        for (const raster::Span& texels : row.wanted)
            for (int k = texels.x0; k < texels.x1; ++k) {
                const int column = static_cast<int>(row.column[k]);
                ++work[std::size_t(column)];
                if (sticks_out(gaps[k])) continue;
                for (int x = column; x < static_cast<int>(row.column[k + 1]); ++x) work[std::size_t(x)] += 3;
            }
    }
    const std::int64_t all = std::accumulate(work.begin(), work.end(), std::int64_t{0});
    std::vector<int> cuts{0};
    std::int64_t before = 0;
    for (int x = 0; x < window.width; before += work[std::size_t(x++)])
        while (std::ssize(cuts) < bands && before * bands > all * std::ssize(cuts)) cuts.push_back(x);
    cuts.resize(std::size_t(bands) + 1, window.width);
    return cuts;
}

template <bool maps, class Method, class Probe = const pipeline::NoProbe>
void resample_picture(Method, const PreparedRelief& relief, const Warp& warp, const PrewarpSettings& settings,
                      Prewarped& result, PrewarpMemory::Parts& memory, Probe&& probe = {}) {
    constexpr bool told_samples = pipeline::Wants<Probe, SampleSent<maps>>,
                   told_rows = pipeline::Wants<Probe, RowResampled<maps>>;
    const DepthWarp constants(warp);
    const OcclusionOrder order = occlusion_order(warp, settings.painting);
    const Window& window = result.window;
    const int rows = relief.camera.height, bands = told_samples || told_rows ? 1 : settings.threads;
    const std::vector<RowStep> steps = row_steps(order, rows);
    memory.fit(bands);
    const std::vector<int> cuts = cuts_between_bands(relief, warp, window, bands, *memory.rows[0]);

    memory.workers->run(bands, [&](int i, int) {
        const Band band{cuts[std::size_t(i)], cuts[std::size_t(i) + 1]};
        if (band.first == band.last) return;
        clear_columns(result, band.first, band.last);
        WarpedRow& row = *memory.rows[std::size_t(i)];
        row.y = -1;
        ColumnResampler<maps> columns(relief, constants, Painter<maps>(result, settings.depth_test), window,
                                      band.first, band.last);
        columns.run(steps, [&](int y, typename ColumnResampler<maps>::Line& line) {
            line.clear();
            if (y < 0 || y >= rows) return;
            warp_row(relief, warp, window, band, y, row);
            resample_row<maps, Method>(relief, row, constants, order, window, band,
                                       [&](int x, auto&& sample) {
                                           if constexpr (told_samples)
                                               pipeline::note<SampleSent<maps>>(probe, x, y, sample());
                                           const int column = x - band.first;
                                           if (Method::keeps_all && line.samples.count[column] != 0)
                                               return line.add(column, sample());
                                           line.samples.count[column] = 1, line.samples.set(column, sample());
                                       });
            line.span = occupied(line.samples.count, band.last - band.first);
            if (!Method::carries_row)
                for (int x = line.span.x0; x < line.span.x1; ++x)
                    if (line.samples.count[x] != 0)
                        line.samples.v[x] = warped_v(static_cast<Scalar>(y) + Scalar(0.5),
                                                     line.samples.carried[x].depth(), constants) -
                                            static_cast<Scalar>(window.y0);
            pipeline::note<RowResampled<maps>>(probe, y, line.samples);
        });
    });
}

}  // namespace relevo::relief
