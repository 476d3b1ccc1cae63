// The share of a pixel's square that lies to the right of an edge: what area_coverage.hpp is summed from.
//
// Corners lie on a grid of 1/65536 pixel. In a row of pixels, let p <= q be the ends of the edge's piece, t
// its height and m = |dy / dx| its steepness. The area between the piece and a vertical line at X to its
// right is
//
//   G(X) = m u^2 / 2 + t max(X - q, 0),     u = X - p, not below 0, not above q - p
//
// (a triangle as long as the line cuts the piece, then a rectangle beside the whole triangle), and the share
// of the pixel between the verticals X and X + 1 is  G(X + 1) - G(X), rounded to 1/65536 of the pixel (ties
// to even). Whoever follows an outline adds the shares of the edges that go down and subtracts those that go
// up. Neighbours that share an edge have the same share with opposite signs, so nothing is lost between them.
//
// The products are computed in double with an error below 2^-18 of a unit. A result closer than that to a tie
// is computed again in integers of 128 bits: the share is always the exact one, rounded once.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "raster/pixel.hpp"

namespace relevo::raster {

// Twice as far as shapes reach, so that the outlines of wide lines are never too far out.
inline constexpr double largest_corner = 2 * largest_place;
// Columns and rows are counted from pixel (-65536, -65536), so that none is negative.
inline constexpr int grid_origin = 65536;
inline constexpr std::int64_t grid_pixel = 65536;  // a pixel in grid units

// |c| <= largest_corner, which refuses what is not finite, too.
inline bool on_grid(const glm::dvec2& p) {
    return std::abs(p.x) <= largest_corner && std::abs(p.y) <= largest_corner;
}
inline bool on_grid(std::span<const std::vector<glm::dvec2>> rings) {
    for (const auto& ring : rings)
        for (const glm::dvec2& p : ring)
            if (!on_grid(p)) return false;
    return true;
}
// Grid units: pixel centres are at halves of a pixel.
inline std::int64_t to_grid(double c) {
    return std::llrint(c * 65536) + grid_pixel / 2 + grid_pixel * grid_origin;
}
inline double from_grid(std::int64_t c) {
    return static_cast<double>(c - grid_pixel / 2) * 0x1p-16 - grid_origin;
}

// The pixels of a box that coordinates up to largest_corner can reach, in columns and rows of the grid.
inline PixelBox grid_box(const PixelBox& box) {
    const auto cell = [](int c) { return std::clamp(c, -grid_origin, grid_origin - 1) + grid_origin; };
    if (box.empty()) return {0, 0, -1, -1};
    return {cell(box.x0), cell(box.y0), cell(box.x1), cell(box.y1)};
}

// From the upper end (x0, y0) to the lower one: y0 < y1. Grid units.
struct CoverageEdge {
    std::int64_t x0, y0, x1, y1;
    int sign;          // 1: the outline goes down here, -1: up
    double slope;      // pixels of x for a grid unit of y
    double steepness;  // grid units of y for a pixel of x; 0 for a vertical edge

    // In pixels, with an error below 2^-34.
    double x_at(std::int64_t y) const {
        if (y == y1) return static_cast<double>(x1) * 0x1p-16;
        return static_cast<double>(x0) * 0x1p-16 + static_cast<double>(y - y0) * slope;
    }
    int first_row() const { return static_cast<int>(y0 >> 16); }
    int last_row() const { return static_cast<int>((y1 - 1) >> 16); }
};

// Between two places on the grid. False for a horizontal edge: it has no right.
inline bool make_edge(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by,
                      CoverageEdge& edge) {
    if (ay == by) return false;
    const bool down = ay < by;
    if (!down) std::swap(ax, bx), std::swap(ay, by);
    const auto dx = static_cast<double>(bx - ax), dy = static_cast<double>(by - ay);
    edge = {ax, ay, bx, by, down ? 1 : -1, dx * 0x1p-16 / dy, ax == bx ? 0 : dy * 65536 / std::abs(dx)};
    return true;
}

// The part of an edge in a row of pixels.
struct EdgePiece {
    const CoverageEdge* edge;
    std::int64_t y0, y1;      // its ends, grid units
    double p, q;              // its smallest and largest x, pixels
    double t, width, half_m;  // t, q - p, m/2
    int height, first, last;  // t; the columns that it touches
};

// `x_above` is edge.x_at(y0) and may come from the row above; `x_below` is left for the row below.
inline EdgePiece make_piece(const CoverageEdge& edge, std::int64_t y0, std::int64_t y1, double x_above,
                            double& x_below) {
    x_below = edge.x_at(y1);
    const double p = std::min(x_above, x_below), q = std::max(x_above, x_below);
    const auto height = static_cast<int>(y1 - y0);
    return {&edge,
            y0,
            y1,
            p,
            q,
            static_cast<double>(height),
            q - p,
            0.5 * edge.steepness,
            height,
            static_cast<int>(p),
            static_cast<int>(q)};
}

// The share in integers. With E(X) = (X - x(y0)) dy and F(X) = (x(y1) - X) dy, the triangles that a vertical
// cuts off above and below are E^2 / (2 dx dy) and F^2 / (2 dx dy); an edge that leans to the left is
// mirrored.
inline int exact_share(const EdgePiece& piece, int column) {
    const CoverageEdge& edge = *piece.edge;
    const bool mirrored = edge.x1 < edge.x0;
    const Int128 x0 = mirrored ? -edge.x0 : edge.x0, dx = mirrored ? edge.x0 - edge.x1 : edge.x1 - edge.x0;
    const Int128 dy = edge.y1 - edge.y0, height = piece.height, row = height * grid_pixel;
    const Int128 left = mirrored ? -(Int128(column) + 1) * grid_pixel : Int128(column) * grid_pixel;
    const Int128 right = left + grid_pixel;
    const auto e = [&](Int128 x) { return (x - x0) * dy - (piece.y0 - edge.y0) * dx; };
    const auto f = [&](Int128 x) { return (piece.y1 - edge.y0) * dx - (x - x0) * dy; };
    Int128 above, below;  // the right part in 1/2^32 pixel, a fraction
    if (e(right) <= 0)
        above = 0, below = 1;
    else if (f(left) <= 0)
        above = row, below = 1;
    else if (e(left) <= 0 && f(right) <= 0)
        above = height * (e(right) - f(right)), below = 2 * dy;
    else if (e(left) <= 0)
        above = e(right) * e(right), below = 2 * dx * dy;
    else if (f(right) <= 0)
        below = 2 * dx * dy, above = row * below - f(left) * f(left);
    else
        above = e(right) * e(right) - e(left) * e(left), below = 2 * dx * dy;
    if (mirrored) above = row * below - above;
    below *= grid_pixel;
    const Int128 whole = above / below, rest = 2 * (above - whole * below);
    return static_cast<int>(whole + (rest > below || (rest == below && whole % 2 != 0) ? 1 : 0));
}

// G(X) in 1/65536 of a pixel.
inline double area_left_of(double x, const EdgePiece& piece) {
    const double u = std::min(std::max(x - piece.p, 0.0), piece.width);
    return piece.half_m * u * u + piece.t * std::max(x - piece.q, 0.0);
}

// `share` = G(column + 1) - G(column), rounded.
inline int rounded_share(double share, const EdgePiece& piece, int column) {
    const auto rounded = static_cast<int>(std::lrint(share));
    constexpr double near_tie = 0.5 - 0x1p-12;
    return std::abs(share - rounded) < near_tie ? rounded : exact_share(piece, column);
}

// In 1/65536 of the pixel in this column, 0..height of the piece.
inline int edge_share(const EdgePiece& piece, int column) {
    if (column < piece.first) return 0;
    if (column > piece.last) return piece.height;
    return rounded_share(area_left_of(column + 1.0, piece) - area_left_of(column, piece), piece, column);
}

}  // namespace relevo::raster
