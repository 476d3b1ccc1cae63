// The quarter of an ellipse from (0, b) to (a, 0) as pixels, without walking along it: what the midpoint
// algorithms start from, and what they are cut at a box with.
//
// Source: textbook sections 5.3 and 4.2.
//
// Region 1 has one pixel a column, the nearest to the curve in it: row y with (x, y - 1/2) inside the ellipse
// and (x, y + 1/2) not. Region 2 has one pixel a row, likewise. Region 1 may only go on to column x + 1 as
// long as the curve falls by at most one row from column x to x + 1, else a pixel between the two is missing:
//
//   Y(x) - Y(x + 1) <= 1   <=>   q <= 0  or  q^2 <= 4 a^2 b^2 (a^2 - (x + 1)^2),    q = b^2 (2x + 1) - a^2
//
// (with Y^2(x) - Y^2(x + 1) = b^2 (2x + 1) / a^2). The ellipse is convex, so this is true up to some column
// and false from there on; and where it is false, X falls by less than one column a row: region 2 is right.
// The textbook asks for the gradient at the midpoint instead. That is a column early or late for three of a
// hundred ellipses: ellipse_textbook.hpp.
//
// Everything is exact: 128 bits for a, b up to 2^20.
#pragma once
#include <cstdint>

#include "raster/clip_circle.hpp"
#include "raster/pixel.hpp"

namespace relevo::raster {

inline constexpr int largest_ellipse_radius = 1 << 20;

// a, b >= 1.
struct EllipseArc {
    std::int64_t a, b;

    // Whether (x, y - 1/2) and (x - 1/2, y) lie inside the ellipse; the axes count as inside.
    constexpr bool reaches_row(std::int64_t x, std::int64_t y) const {
        return y <= 0 || inside(2 * x, 2 * y - 1);
    }
    constexpr bool reaches_column(std::int64_t x, std::int64_t y) const {
        return x <= 0 || inside(2 * x - 1, 2 * y);
    }
    constexpr std::int64_t row(std::int64_t x) const {
        return last_that(0, b, [&](std::int64_t y) { return reaches_row(x, y); });
    }
    constexpr std::int64_t column(std::int64_t y) const {
        return last_that(0, a, [&](std::int64_t x) { return reaches_column(x, y); });
    }
    constexpr bool falls_gently(std::int64_t x) const {  // by at most one row from x to x + 1
        if (x >= a) return false;
        const Int128 q = Int128{b * b} * (2 * x + 1) - a * a;
        return q <= 0 || q * q <= 4 * (Int128{a * a} * (b * b)) * (a * a - (x + 1) * (x + 1));
    }
    // The last column of region 1.
    constexpr std::int64_t region1_end() const {
        return last_that(0, a - 1, [&](std::int64_t x) { return falls_gently(x); }) + 1;
    }
    // The columns of region 1 (rows of region 2) out of a range that are in the rows (columns) given.
    constexpr Range columns_inside(const Range& columns, const Range& rows) const {
        if (columns.empty() || rows.empty() || rows.high < 0 || rows.low > b) return {0, -1};
        const auto below = [&](std::int64_t x) { return rows.high < b && reaches_row(x, rows.high + 1); };
        const auto above = [&](std::int64_t x) { return reaches_row(x, rows.low); };
        return {last_that(columns.low, columns.high, below) + 1, last_that(columns.low, columns.high, above)};
    }
    constexpr Range rows_inside(const Range& rows, const Range& columns) const {
        return EllipseArc{b, a}.columns_inside(rows, columns);  // the mirror image at the diagonal
    }

  private:
    constexpr bool inside(std::int64_t x2, std::int64_t y2) const {  // twice the place
        return Int128{b * b} * (x2 * x2) + Int128{a * a} * (y2 * y2) < 4 * (Int128{a * a} * (b * b));
    }
};

// Calls plot for every pixel x0..x1 of row y that lies in the box.
template <class Plot>
constexpr void plot_row(std::int64_t x0, std::int64_t x1, std::int64_t y, const PixelBox& box, Plot&& plot) {
    if (y < box.y0 || y > box.y1) return;
    const Range run = common({x0, x1}, {box.x0, box.x1});
    for (std::int64_t x = run.low; x <= run.high; ++x) plot(static_cast<int>(x), static_cast<int>(y));
}
// The same along column x.
template <class Plot>
constexpr void plot_column(std::int64_t x, std::int64_t y0, std::int64_t y1, const PixelBox& box,
                           Plot&& plot) {
    if (x < box.x0 || x > box.x1) return;
    const Range run = common({y0, y1}, {box.y0, box.y1});
    for (std::int64_t y = run.low; y <= run.high; ++y) plot(static_cast<int>(x), static_cast<int>(y));
}

// The pixels of an ellipse in the box, once each. `Steps` walks: Steps::region1(arc, x, y) and region2(arc,
// x, y) are its states at a pixel, east_or_south_east(probe) and south_or_south_east(probe) its steps. Where
// region 1 comes down to y = 0, row 0 goes on to x = a: there nothing is left to decide.
template <class Steps, class Plot, class Probe>
constexpr void clip_ellipse(Pixel center, const EllipseArc& arc, const PixelBox& box, Plot&& plot,
                            Probe& probe) {
    const int a = static_cast<int>(arc.a), b = static_cast<int>(arc.b);
    const int turn = static_cast<int>(arc.region1_end());
    const auto whole = [&] {
        const int cx = center.x, cy = center.y;
        const auto four = [&](int x, int y) {
            plot(cx + x, cy + y);
            if (x != 0) plot(cx - x, cy + y);
            if (y != 0) plot(cx + x, cy - y);
            if (x != 0 && y != 0) plot(cx - x, cy - y);
        };
        Steps s = Steps::region1(arc, 0, b);
        four(0, b);
        while (s.x < turn && s.y > 0) s.east_or_south_east(probe), four(s.x, s.y);
        for (int x = s.x + 1; x <= turn; ++x) four(x, 0);
        if (s.y == 0) return;
        s = Steps::region2(arc, s.x, s.y, probe);
        while (s.y > 0) s.south_or_south_east(probe), four(s.x, s.y);
    };
    const auto quadrant = [&](int sx, int sy, CirclePart::Fate) {
        const std::int64_t cx = center.x, cy = center.y;
        const auto one = [&](int x, int y) {
            plot(static_cast<int>(cx + sx * x), static_cast<int>(cy + sy * y));
        };
        const Range across = seen_from(center.x, sx, box.x0, box.x1),
                    down = seen_from(center.y, sy, box.y0, box.y1);
        // an axis belongs to one side
        const Range own_x{sx > 0 ? 0 : 1, a}, own_y{sy > 0 ? 0 : 1, b};
        const Range visible_x = common(across, own_x), visible_y = common(down, own_y);
        const Range columns = arc.columns_inside(common({0, turn}, visible_x), visible_y);
        if (!columns.empty()) {
            const int first = static_cast<int>(columns.low), last = static_cast<int>(columns.high);
            Steps s = Steps::region1(arc, first, static_cast<int>(arc.row(first)));
            one(s.x, s.y);
            while (s.x < last && s.y > 0) s.east_or_south_east(probe), one(s.x, s.y);
            for (int x = s.x + 1; x <= last; ++x) one(x, 0);
        }
        const Range rows = arc.rows_inside(common({0, arc.row(turn) - 1}, visible_y), visible_x);
        if (!rows.empty()) {
            const int first = static_cast<int>(rows.high), last = static_cast<int>(rows.low);
            Steps s = Steps::region2(arc, static_cast<int>(arc.column(first)), first, probe);
            one(s.x, s.y);
            while (s.y > last) s.south_or_south_east(probe), one(s.x, s.y);
        }
    };
    clip_quadrants(center, a, b, box, whole, quadrant, probe);
}

}  // namespace relevo::raster
