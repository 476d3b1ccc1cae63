// Antialiasing by samples: n x n points a pixel, in the centres of the squares of a grid n times as fine (the
// "sampling points" of Crow 1977, "The aliasing problem in computer-generated shaded images").
//
// Coverage is the number of points inside, of n^2. Each point is decided exactly as a pixel's centre is
// decided without antialiasing: corners lie on 1/256 pixel, and a point on an edge belongs to the area to its
// right or below it (triangle_edge.hpp). So every point belongs to exactly one piece of a tiling, and n = 1
// is no antialiasing at all.
//
// A row of points is walked as a row of pixels would be: edges leave their winding numbers where they cross
// it (coverage_row.hpp), and the runs inside are counted into the pixels.
//
// n = 1..16. Coordinates: |c| <= 65534. With another n or coordinate, or one that is not finite, nothing is
// drawn. Coverage is 65536 count / n^2, rounded to nearest: exact for n = 1, 2, 4, 8, 16.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "raster/area_coverage.hpp"
#include "raster/scan_edge.hpp"

namespace relevo::raster {

inline constexpr int most_samples = 16;

// Points x0 <= x < x1 of a row of points are inside. Point (x, y) belongs to pixel (floor(x / n), floor(y /
// n)).
struct SamplesInside {
    int y, x0, x1;
};

// `inside_run(y, x0, x1)` for the runs of points inside, row by row from the top; `row_done(y)` after the
// last run of pixel row y. The pixels are those of the box.
template <class Run, class RowDone>
void for_each_sample_run(int n, std::span<const std::vector<glm::dvec2>> rings, InsideRule inside,
                         const PixelBox& box, Run&& inside_run, RowDone&& row_done);

template <class Cover, class Probe = NoProbe>
void supersample(int n, std::span<const std::vector<glm::dvec2>> rings, InsideRule inside,
                 const PixelBox& box, Cover&& cover, Probe&& probe = Probe{}) {
    const PixelBox grid = grid_box(box);
    if (grid.empty()) return;
    CoverageRow counts(grid.x0, grid.x1);
    for_each_sample_run(
        n, rings, inside, box,
        [&](int y, int x0, int x1) {
            note<SamplesInside>(probe, y, x0, x1);
            const auto count_from = [&](int x, int sign) {  // the points at and to the right of x
                const int column = x + n * grid_origin, pixel = column / n;
                counts.add(pixel, pixel, sign, n, [&](int) { return n * (pixel + 1) - column; });
            };
            count_from(x0, 1), count_from(x1, -1);
        },
        [&](int y) {
            counts.sweep([&](int from, int to, std::int64_t count) {
                const auto coverage = static_cast<int>((2 * full_coverage * count + n * n) / (2 * n * n));
                emit_run(y + grid_origin, from, to, coverage, cover, probe);
            });
        });
}

// ---- the rest is how ----

// An edge between corners in 1/256 of the finer grid, on its way down the rows of points.
struct SampleWalk {
    SnappedPoint upper, lower;
    int sign;
    ScanEdge at{};

    int first_row() const { return raster::first_row(upper.y, FillRule::TopLeft); }
    int last_row() const { return raster::first_row(lower.y, FillRule::TopLeft) - 1; }
    void start(int row) { at = ScanEdge(upper, lower, row); }
};

template <class Run, class RowDone>
void for_each_sample_run(int n, std::span<const std::vector<glm::dvec2>> rings, InsideRule inside,
                         const PixelBox& box, Run&& inside_run, RowDone&& row_done) {
    if (n < 1 || n > most_samples || box.empty() || !on_grid(rings)) return;
    const auto cell = [](int c) { return std::clamp(c, -grid_origin, grid_origin - 1); };
    const PixelBox points{n * cell(box.x0), n * cell(box.y0), n * cell(box.x1) + n - 1,
                          n * cell(box.y1) + n - 1};
    std::vector<SampleWalk> edges;
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 &from = ring[i], &to = ring[i + 1 == ring.size() ? 0 : i + 1];
            SnappedPoint a = snapped(from.x, from.y), b = snapped(to.x, to.y);
            a = {a.x * n, a.y * n}, b = {b.x * n, b.y * n};
            const SampleWalk walk{a.y < b.y ? a : b, a.y < b.y ? b : a, a.y < b.y ? 1 : -1};
            if (walk.first_row() <= walk.last_row()) edges.push_back(walk);
        }
    CoverageRow windings(points.x0, points.x1);
    int done = -grid_origin - 1;  // the pixel row of the points before
    for_each_row(edges, points.y0, points.y1, [&](int row, std::span<SampleWalk* const> active) {
        const auto pixel_row = static_cast<int>((row + std::int64_t{n} * grid_origin) / n) - grid_origin;
        if (done != pixel_row && done >= -grid_origin) row_done(done);
        done = pixel_row;
        for (SampleWalk* walk : active) {
            windings.add(walk->at.x, walk->at.x - 1, walk->sign, 1, [](int) { return 1; });
            walk->at.next_row();
        }
        int from = points.x0, to = points.x0;  // runs that touch are one
        windings.sweep([&](int x0, int x1, std::int64_t winding) {
            if (inside == InsideRule::NonZero ? winding == 0 : winding % 2 == 0) return;
            if (x0 != to && from < to) inside_run(row, from, to);
            if (x0 != to) from = x0;
            to = x1;
        });
        if (from < to) inside_run(row, from, to);
    });
    if (done >= -grid_origin) row_done(done);
}

}  // namespace relevo::raster
