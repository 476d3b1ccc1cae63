// Weighted area sampling: what is near a pixel's centre counts more (textbook section 8.2; Feibush, Levoy and
// Cook 1980, "Synthetic texturing using digital filters", filter polygons so).
//
// A pixel sees the shape through a cone that stands on its centre, with radius 1 and height 3/pi, so that its
// volume is 1 (the textbook leaves the height open): its coverage is the volume of the cone over the shape. A
// shape that passes within a pixel's length gives it light, whether it touches the pixel's square or not.
//
// The volume is exact. As in area_coverage.hpp, edges add up: each gives the volume over what lies to its
// right in its rows. Around a centre O, the volume over the triangle O p q depends on where the line p q
// runs. With h its distance from O, s the place along it and R = sqrt(h^2 + s^2) <= 1, it is f(h, s_q) - f(h,
// s_p),
//
//   f(h, s) = (h s (3 - R) - h^3 ln((s + R) / h)) / 2 pi
//
// and the strip to the right of an edge from a to b is the sum of such triangles: from a along the row to the
// right, from there back to b, and from b to a. Rows that an edge passes at the left of the cone have the
// volume of a slice between two parallel lines (cone_half_plane in cone_table.hpp); an edge all across the
// cone cuts it in two.
//
// Coordinates as area_coverage.hpp. The volume is computed with an error below 1e-9 an edge and rounded to
// 1/65536 at the end (not edge by edge: at the rim of the cone lie many pixels with next to no weight). So
// the parts of a tiling sum to 65536 in every pixel up to half a unit each. Inside a shape, a pixel's length
// from its outline, coverage is 65536. The sum over the frame is the area of the shape only as far as its
// pixels sample it evenly: a place is seen by several cones, with a sum between 0.9549 (on a centre) and
// 1.1187 (where four pixels meet), and 1 on average.
#pragma once
#include <cmath>

#include "pipeline/elementary.hpp"
#include "raster/area_coverage.hpp"
#include "raster/cone_table.hpp"

namespace relevo::raster {

// The outline of any number of rings, closed by themselves. Runs from top to bottom and left to right.
template <class Cover, class Probe = NoProbe>
void weighted_coverage(std::span<const std::vector<glm::dvec2>> rings, InsideRule inside, const PixelBox& box,
                       Cover&& cover, Probe&& probe = Probe{});

// ---- the rest is how ----

// f(h, s); h and s may be negative: a triangle seen from the other side counts negative.
inline double cone_over_triangle(double h, double s) {
    constexpr double ln2 = 0x1.62e42fefa39efp-1;
    const double size_h = std::abs(h), size_s = std::abs(s), r = std::sqrt(h * h + s * s);
    const double logarithm = size_h < 0x1p-60 ? 0 : ln2 * pipeline::log2((size_s + r) / size_h);
    return (h * s * (3 - r) - h * h * h * std::copysign(logarithm, s)) / (2 * pipeline::pi);
}

// An edge as the cone on (0, 0) sees it, in pixels: down from a to b, unit direction d.
struct ConeEdge {
    glm::dvec2 a, b, d;
    double slice_a, slice_b;  // volume of the cone above a and above b
};

// The triangles from p along its row to the right. p is in the cone.
inline double cone_over_row(const glm::dvec2& p, double slice) {
    return cone_over_triangle(p.y, p.x) - (slice - 0.5) / 2;
}

// Volume over the points to the right of the edge, below a and above b.
inline double cone_right_of(const ConeEdge& e) {
    const double h = e.a.x * e.d.y - e.a.y * e.d.x;  // > 0: the line passes at the right of the centre
    const double s_a = e.a.x * e.d.x + e.a.y * e.d.y, s_b = e.b.x * e.d.x + e.b.y * e.d.y;
    const bool starts = e.a.x * e.a.x + e.a.y * e.a.y < 1, ends = e.b.x * e.b.x + e.b.y * e.b.y < 1;
    if (!starts && !ends) {
        if (std::abs(h) < 1 && s_a < 0 && s_b > 0)  // all across
            return cone_half_plane(-h) - (e.a.x < 0 ? e.slice_a : 0) - (e.b.x < 0 ? 1 - e.slice_b : 0);
        return e.a.x + e.b.x < 0 ? e.slice_b - e.slice_a : 0;
    }
    const double chord = std::sqrt(std::max(0.0, (1 - h) * (1 + h)));
    const double from = starts ? s_a : -chord, to = ends ? s_b : chord;
    double volume = cone_over_triangle(h, from) - cone_over_triangle(h, to);
    const auto on_rim = [&](double s) { return glm::dvec2{h * e.d.y + s * e.d.x, -h * e.d.x + s * e.d.y}; };
    if (starts) {
        volume += cone_over_row(e.a, e.slice_a);
    } else {
        const glm::dvec2 p = on_rim(from);
        const double slice = cone_half_plane(p.y);
        volume += cone_over_row(p, slice) + (p.x < 0 ? slice - e.slice_a : 0);
    }
    if (ends) {
        volume -= cone_over_row(e.b, e.slice_b);
    } else {
        const glm::dvec2 p = on_rim(to);
        const double slice = cone_half_plane(p.y);
        volume -= cone_over_row(p, slice) + (p.x < 0 ? slice - e.slice_b : 0);
    }
    return volume;
}

// An edge on its way down the rows. A row's cones reach a pixel up and down from its middle.
struct ConeWalk {
    CoverageEdge edge;

    static constexpr std::int64_t reach = grid_pixel, half = grid_pixel / 2;
    static std::int64_t middle(int row) { return row * grid_pixel + half; }
    int first_row() const { return static_cast<int>((edge.y0 - reach - half) >> 16) + 1; }
    int last_row() const { return static_cast<int>((edge.y1 + reach - half - 1) >> 16); }
    void start(int) {}
};

template <class Cover, class Probe>
void weighted_coverage(std::span<const std::vector<glm::dvec2>> rings, InsideRule inside, const PixelBox& box,
                       Cover&& cover, Probe&& probe) {
    const PixelBox grid = grid_box(box);
    if (grid.empty() || !on_grid(rings)) return;
    auto edges = edges_of<ConeWalk>(rings);
    CoverageRow sums(grid.x0, grid.x1);
    // Summed in 1/2^32: the heights of the corners cancel out exactly.
    const auto fine = [](double volume) -> std::int64_t { return std::llrint(0x1p32 * volume); };
    const auto unit = [](std::int64_t sum) { return (sum + 32768) >> 16; };
    for_each_row(edges, grid.y0, grid.y1, [&](int row, std::span<ConeWalk* const> active) {
        const std::int64_t middle = ConeWalk::middle(row);
        for (const ConeWalk* walk : active) {
            const CoverageEdge& e = walk->edge;
            const std::int64_t top = std::max(e.y0, middle - ConeWalk::reach),
                               bottom = std::min(e.y1, middle + ConeWalk::reach);
            const double x_top = e.x_at(top), x_bottom = e.x_at(bottom);
            const double dx = static_cast<double>(e.x1 - e.x0), dy = static_cast<double>(e.y1 - e.y0),
                         length = std::sqrt(dx * dx + dy * dy);
            ConeEdge seen{{0, static_cast<double>(top - middle) * 0x1p-16},
                          {0, static_cast<double>(bottom - middle) * 0x1p-16},
                          {dx / length, dy / length},
                          0,
                          0};
            seen.slice_a = cone_half_plane(seen.a.y), seen.slice_b = cone_half_plane(seen.b.y);
            const std::int64_t beyond = fine(seen.slice_b) - fine(seen.slice_a);
            const auto [left, right] = std::minmax(x_top, x_bottom);
            sums.add(static_cast<int>(left - 0.5), static_cast<int>(right + 0.5), e.sign, beyond,
                     [&](int column) {
                         seen.a.x = x_top - (column + 0.5), seen.b.x = x_bottom - (column + 0.5);
                         const std::int64_t share = fine(cone_right_of(seen));
                         note_share(probe, e, column, row, static_cast<int>(unit(share)),
                                    static_cast<int>(unit(beyond)));
                         return share;
                     });
        }
        sums.sweep([&](int from, int to, std::int64_t winding) {
            emit_run(row, from, to, covered_part(unit(winding), inside), cover, probe);
        });
    });
}

}  // namespace relevo::raster
