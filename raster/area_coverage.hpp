// The covered area of each pixel: antialiasing by unweighted area sampling (textbook section 8.1; Catmull
// 1978, "A hidden-surface algorithm with anti-aliasing").
//
// Pixel (i, j) is the square [i - 1/2, i + 1/2) x [j - 1/2, j + 1/2): its coverage is the area of the shape
// inside, 0..65536. It is a sum over the outline: every edge gives its signed share (edge_share.hpp) to the
// pixels that it touches, and the height of its piece of the row to all pixels to the right. Between the
// edges of a row the sum stands still, so a run of whole pixels costs as much as one.
//
// Coordinates: |c| <= 65534, rounded to 1/65536 pixel; if one is larger or not finite, nothing is drawn. Each
// edge's share of a pixel is exact and rounded once, so with corners on the grid of 1/65536 pixel
//
//   * the coverage of a pixel that k edges touch is within k / 2^17 of its exact area, where the inside rule
//     is exact (covered_part in coverage_row.hpp);
//   * the coverages of the pieces of a tiling sum to exactly 65536 in every pixel, since an edge counts once
//     forward and once backward. (A piece covering less than k / 2^17 of a pixel, or lacking less, can reach
//     below 0 or above 65536 by its rounding, and is then kept within.)
//
// Both cannot be had with a smaller error: three edges that cut three corners off a pixel are rounded with
// three neighbours that know nothing of each other.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/probe.hpp"
#include "raster/coverage_row.hpp"
#include "raster/edge_share.hpp"

namespace relevo::raster {

using pipeline::NoProbe;
using pipeline::note;

// An edge gives its share to pixel (x, y): the part of the square to its right, negative for an edge that
// goes up. Pixels further to the right get `beyond` of it.
struct EdgeShared {
    glm::dvec2 from, to;
    int x, y;
    int share, beyond;
};

// Pixels x0 <= x < x1 of row y are covered alike.
struct RunCovered {
    int y, x0, x1;
    int coverage;
};

// The outline of any number of rings, closed by themselves; rings with less than three corners have no area.
template <class Cover, class Probe = NoProbe>
void area_coverage(std::span<const std::vector<glm::dvec2>> rings, InsideRule inside, const PixelBox& box,
                   Cover&& cover, Probe&& probe = Probe{});

// One convex polygon, without taking memory up to eight corners. (A polygon that is not convex is drawn by
// the non-zero rule.)
template <class Cover, class Probe = NoProbe>
void area_coverage(std::span<const glm::dvec2> convex, const PixelBox& box, Cover&& cover,
                   Probe&& probe = Probe{});

// ---- the rest is how ----

template <class Probe>
void note_share(Probe& probe, const CoverageEdge& e, int column, int row, int share, int beyond) {
    if constexpr (pipeline::Wants<Probe, EdgeShared>) {
        const glm::dvec2 upper{from_grid(e.x0), from_grid(e.y0)}, lower{from_grid(e.x1), from_grid(e.y1)};
        note<EdgeShared>(probe, e.sign > 0 ? upper : lower, e.sign > 0 ? lower : upper, column - grid_origin,
                         row - grid_origin, e.sign * share, e.sign * beyond);
    }
}

template <class Cover, class Probe>
[[gnu::always_inline]] inline void emit_run(int row, int column, int end, int coverage, Cover& cover,
                                            Probe& probe) {
    if (coverage == 0) return;
    const int y = row - grid_origin, x0 = column - grid_origin, x1 = end - grid_origin;
    note<RunCovered>(probe, y, x0, x1, coverage);
    cover(y, x0, x1, coverage);
}

// An edge on its way down the rows.
struct EdgeWalk {
    CoverageEdge edge;
    double x = 0;  // at the upper end of its piece in the next row

    int first_row() const { return edge.first_row(); }
    int last_row() const { return edge.last_row(); }
    void start(int row) { x = edge.x_at(std::max(edge.y0, row * grid_pixel)); }
    EdgePiece piece(int row) {
        return make_piece(edge, std::max(edge.y0, row * grid_pixel),
                          std::min(edge.y1, (row + 1) * grid_pixel), x, x);
    }
};

// The edges of closed rings, but for the horizontal ones.
template <class Walk>
std::vector<Walk> edges_of(std::span<const std::vector<glm::dvec2>> rings) {
    std::vector<Walk> edges;
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 &a = ring[i], &b = ring[i + 1 == ring.size() ? 0 : i + 1];
            CoverageEdge edge;
            if (make_edge(to_grid(a.x), to_grid(a.y), to_grid(b.x), to_grid(b.y), edge))
                edges.push_back({edge});
        }
    return edges;
}

template <class Cover, class Probe>
void area_coverage(std::span<const std::vector<glm::dvec2>> rings, InsideRule inside, const PixelBox& box,
                   Cover&& cover, Probe&& probe) {
    const PixelBox grid = grid_box(box);
    if (grid.empty() || !on_grid(rings)) return;
    auto edges = edges_of<EdgeWalk>(rings);
    CoverageRow sums(grid.x0, grid.x1);
    for_each_row(edges, grid.y0, grid.y1, [&](int row, std::span<EdgeWalk* const> active) {
        for (EdgeWalk* walk : active) {
            const EdgePiece piece = walk->piece(row);
            sums.add(piece.first, piece.last, walk->edge.sign, piece.height, [&](int column) {
                const int share = edge_share(piece, column);
                note_share(probe, *piece.edge, column, row, share, piece.height);
                return share;
            });
        }
        sums.sweep([&](int from, int to, std::int64_t winding) {
            emit_run(row, from, to, covered_part(winding, inside), cover, probe);
        });
    });
}

// A row of a polygon with few edges: every pixel sums its shares where it stands.
template <class Cover, class Probe>
void cover_row(std::span<const EdgePiece> pieces, int row, const PixelBox& grid, Cover& cover, Probe& probe) {
    int column = grid.x1 + 1, end = grid.x0 - 1;
    for (const EdgePiece& piece : pieces)
        column = std::min(column, piece.first), end = std::max(end, piece.last);
    column = std::max(column, grid.x0), end = std::min(end, grid.x1);
    while (column <= end) {
        int winding = 0, next = end + 1;
        for (const EdgePiece& piece : pieces) {
            const int share = edge_share(piece, column);
            if (piece.first <= column && column <= piece.last)
                next = column + 1, note_share(probe, *piece.edge, column, row, share, piece.height);
            else if (piece.first > column)
                next = std::min(next, piece.first);
            winding += piece.edge->sign * share;
        }
        emit_run(row, column, next, covered_part(winding, InsideRule::NonZero), cover, probe);
        column = next;
    }
}

// The usual row of a convex polygon: a piece on the left and one on the right. False: it is another row.
template <class Cover, class Probe>
bool cover_between(const EdgePiece* left, const EdgePiece* right, int row, const PixelBox& grid, Cover& cover,
                   Probe& probe) {
    if (left->p + left->q > right->p + right->q) std::swap(left, right);
    if (left->first > right->first || left->last > right->last) return false;
    const auto clipped = [&](int column) { return std::clamp(column, grid.x0, grid.x1 + 1); };
    const int full = left->height, begin = clipped(left->first), inner = clipped(left->last + 1),
              outer = clipped(right->first), end = clipped(right->last + 1);
    const auto share = [&](const EdgePiece* piece, int column, double& area) {
        const double next = area_left_of(column + 1.0, *piece);
        const int result = rounded_share(next - area, *piece, column);
        area = next;
        note_share(probe, *piece->edge, column, row, result, piece->height);
        return result;
    };
    double area_l = begin == left->first ? 0 : area_left_of(begin, *left),
           area_r = outer == right->first ? 0 : area_left_of(outer, *right);
    for (int column = begin, next; column < end; column = next) {
        const bool between = inner <= column && column < outer;
        next = between ? outer : column + 1;
        int coverage = column < inner ? share(left, column, area_l) : full;
        if (column >= outer) coverage -= share(right, column, area_r);
        // a bow tie may change sides in this row
        emit_run(row, column, next, std::abs(coverage), cover, probe);
    }
    return true;
}

template <class Cover, class Probe>
void area_coverage(std::span<const glm::dvec2> convex, const PixelBox& box, Cover&& cover, Probe&& probe) {
    constexpr std::size_t most = 8;
    if (convex.size() > most) {
        const std::vector<glm::dvec2> ring(convex.begin(), convex.end());
        return area_coverage(std::span{&ring, 1}, InsideRule::NonZero, box, cover, probe);
    }
    const PixelBox grid = grid_box(box);
    if (grid.empty() || convex.empty()) return;
    std::int64_t x[most + 1], y[most + 1];
    for (std::size_t i = 0; i < convex.size(); ++i) {
        if (!on_grid(convex[i])) return;
        x[i] = to_grid(convex[i].x), y[i] = to_grid(convex[i].y);
    }
    x[convex.size()] = x[0], y[convex.size()] = y[0];
    EdgeWalk edges[most];
    Span rows[most];
    std::size_t count = 0;
    int row = grid.y1 + 1, last = grid.y0 - 1;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        CoverageEdge& edge = edges[count].edge;
        if (!make_edge(x[i], y[i], x[i + 1], y[i + 1], edge)) continue;
        rows[count++] = {edge.first_row(), edge.last_row()};
        row = std::min(row, edge.first_row()), last = std::max(last, edge.last_row());
    }
    row = std::max(row, grid.y0), last = std::min(last, grid.y1);
    for (std::size_t i = 0; i < count; ++i) edges[i].start(row);
    EdgePiece pieces[most];
    for (; row <= last; ++row) {
        std::size_t here = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (rows[i].x0 <= row && row <= rows[i].x1) pieces[here++] = edges[i].piece(row);
        if (here != 2 || !cover_between(&pieces[0], &pieces[1], row, grid, cover, probe))
            cover_row(std::span<const EdgePiece>{pieces, here}, row, grid, cover, probe);
    }
}

}  // namespace relevo::raster
