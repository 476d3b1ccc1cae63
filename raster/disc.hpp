// Filled circles and ellipses: the pixels of the midpoint outline and all between them, a span a row.
//
// Source: textbook sections 5.2 and 5.3, row by row as its section 5.4 fills triangles.
//
// The outline is walked once, for a quarter (an octant of a circle). Wherever it leaves a row, the x it had
// there is the half width of that row and of its mirror image. In the octant from (0, R) to the diagonal
// each column is a row, too, with x and y changed: its half width is y. A disc that leaves the box at the
// top or at the bottom is not walked: the half width of each of its visible rows is solved for.
#pragma once
#include <cstdint>

#include "raster/circle_midpoint.hpp"
#include "raster/ellipse_midpoint.hpp"

namespace relevo::raster {

// Event: a row of the disc before it is cut at the box: x0 <= x < x1. 64 bits: it may leave the picture.
struct DiscRow {
    std::int64_t y, x0, x1;
};

// Calls row(y, half width) once for each y = 0..R of a circle's outline, R >= 1. Any order.
template <class Row>
constexpr void circle_half_widths(int radius, Row&& row) {
    NoProbe none;
    CircleMidpoint s = CircleMidpoint::at(0, radius, radius);
    while (s.x < s.y) {
        row(s.x, s.y);
        const int x = s.x, y = s.y;
        s.step(none);
        if (s.y != y) row(y, x);
    }
    if (s.x == s.y) row(s.x, s.y);
}

// The half width of row 0 <= y <= R alone.
constexpr std::int64_t circle_half_width(const CircleOctant& octant, std::int64_t diagonal, std::int64_t y) {
    if (y <= diagonal) return octant.row(y);
    return last_that(0, diagonal, [&](std::int64_t x) { return octant.reaches(x, y); });
}

// The same for ellipses, a, b >= 1.
template <class Row>
constexpr void ellipse_half_widths(const EllipseArc& arc, Row&& row) {
    NoProbe none;
    const int turn = static_cast<int>(arc.region1_end());
    EllipseMidpoint s = EllipseMidpoint::region1(arc, 0, arc.b);
    while (s.x < turn && s.y > 0) {
        const int x = s.x, y = s.y;
        s.east_or_south_east(none);
        if (s.y != y) row(y, x);
    }
    if (s.y == 0) return row(0, static_cast<int>(arc.a));
    row(s.y, s.x);
    s = EllipseMidpoint::region2(arc, s.x, s.y, none);
    while (s.y > 0) s.south_or_south_east(none), row(s.y, s.x);
}
constexpr std::int64_t ellipse_half_width(const EllipseArc& arc, std::int64_t turn, std::int64_t turn_row,
                                          std::int64_t y) {
    if (y == 0) return arc.a;
    if (y < turn_row) return arc.column(y);
    return last_that(0, turn, [&](std::int64_t x) { return arc.reaches_row(x, y); });
}

// Calls span(y, x0, x1), x0 <= x < x1, once for each row of the disc in the box, in no order worth relying
// on. a is the horizontal radius, b the vertical one; a = b fills circle_midpoint(), others fill
// ellipse_midpoint(), with their limits: false, and nothing drawn, when refused; nothing for a negative
// radius; a line when one of them is 0. The box ends before pixel 2^31 - 1.
template <class FillSpan, class Probe = NoProbe>
constexpr bool disc(Pixel center, int a, int b, const PixelBox& box, FillSpan&& span,
                    Probe&& probe = NoProbe{}) {
    const bool round = a == b;
    if (round ? a > largest_circle_radius : a > largest_ellipse_radius || b > largest_ellipse_radius)
        return false;
    if (a < 0 || b < 0 || box.empty()) return true;
    const std::int64_t cx = center.x, cy = center.y;
    const auto fill = [&](std::int64_t y, std::int64_t half) {
        note<DiscRow>(probe, y, cx - half, cx + half + 1);
        const Range run = common({cx - half, cx + half}, {box.x0, box.x1});
        if (!run.empty())
            span(static_cast<int>(y), static_cast<int>(run.low), static_cast<int>(run.high) + 1);
    };
    if (common({cx - a, cx + a}, {box.x0, box.x1}).empty()) return true;
    const Range rows = common({cy - b, cy + b}, {box.y0, box.y1});
    if (rows.empty()) return true;

    if (a == 0 || b == 0) {
        for (std::int64_t y = rows.low; y <= rows.high; ++y) fill(y, a);
    } else if (rows.low == cy - b && rows.high == cy + b) {
        const auto both = [&](std::int64_t y, std::int64_t half) {
            fill(cy + y, half);
            if (y != 0) fill(cy - y, half);
        };
        if (round)
            circle_half_widths(a, both);
        else
            ellipse_half_widths({a, b}, both);
    } else if (round) {
        const CircleOctant octant{a};
        const std::int64_t diagonal = octant.last_column(true);
        for (std::int64_t y = rows.low; y <= rows.high; ++y)
            fill(y, circle_half_width(octant, diagonal, y < cy ? cy - y : y - cy));
    } else {
        const EllipseArc arc{a, b};
        const std::int64_t turn = arc.region1_end(), turn_row = arc.row(turn);
        for (std::int64_t y = rows.low; y <= rows.high; ++y)
            fill(y, ellipse_half_width(arc, turn, turn_row, y < cy ? cy - y : y - cy));
    }
    return true;
}

}  // namespace relevo::raster
