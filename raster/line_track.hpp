// The middle of a line between real ends, column by column, in fixed point; antialiased lines run along it.
//
// Columns are pixels along the major coordinate, x for flat lines, y for steep ones (the diagonal is flat);
// the track says where across the line passes the middle of a column. The ends are put in order of the major
// coordinate first, so A to B is B to A.
//
//     position(column) = position(first) + (column - first) slope       64 bits for the pixel, 64 below it
//
// A sum of integers is the same however it is reached: a box is entered by one multiplication, with exactly
// the position that the uncut line has there. The slope is a double, so the position is right to 2^-53 a
// column, less than 2^-39 pixel on a picture of 8192 columns, and less than 2^-21 anywhere.
//
// Ends are any finite numbers up to largest_line_place; others have no track, and nothing is drawn.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>

#include "raster/line_walk.hpp"

namespace relevo::raster {

inline constexpr double largest_line_place = 1 << 29;

using Fixed = Int128;           // in 2^-64 pixel
inline Fixed fixed(double x) {  // |x| < 2^62; exact but for what is below 2^-64
    const double whole = std::floor(x);
    return (Fixed{static_cast<std::int64_t>(whole)} << 64) + static_cast<std::uint64_t>((x - whole) * 0x1p64);
}
constexpr Fixed one_pixel = Fixed{1} << 64;
constexpr std::int64_t pixel_of(Fixed x) { return static_cast<std::int64_t>(x >> 64); }  // rounds down

struct LineTrack {
    glm::dvec2 from, to;  // (along, across), from.x <= to.x
    bool steep;           // along is y
    double slope;         // -1..1
    std::int64_t first;   // the column whose square holds `from`
    Fixed at_first, step;

    Fixed position(std::int64_t column) const { return at_first + (column - first) * step; }
};

inline std::optional<LineTrack> line_track(glm::dvec2 a, glm::dvec2 b) {
    for (const double c : {a.x, a.y, b.x, b.y})
        if (!(std::fabs(c) <= largest_line_place)) return std::nullopt;
    const bool steep = std::fabs(b.y - a.y) > std::fabs(b.x - a.x);
    if (steep) a = {a.y, a.x}, b = {b.y, b.x};
    if (a.x > b.x) std::swap(a, b);
    const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0, first = std::floor(a.x + 0.5);
    return LineTrack{a,
                     b,
                     steep,
                     slope,
                     static_cast<std::int64_t>(first),
                     fixed(a.y) + fixed(slope * (first - a.x)),
                     fixed(slope)};
}

struct Columns {
    std::int64_t first, last;  // both included
    constexpr bool empty() const { return first > last; }
};

// Of these columns, the ones where the position is from low to high, both included.
inline Columns columns_within(const LineTrack& track, Columns columns, Fixed low, Fixed high) {
    if (columns.empty()) return columns;
    const Fixed p = track.position(columns.first), q = track.position(columns.last);
    if (std::min(p, q) >= low && std::max(p, q) <= high) return columns;
    if (std::max(p, q) < low || std::min(p, q) > high) return {0, -1};
    // low <= p + k step <= high; a falling line is a rising one seen in a mirror.
    const bool rises = track.step > 0;
    const Fixed step = rises ? track.step : -track.step;
    const Fixed to_low = rises ? low - p : p - high, to_high = rises ? high - p : p - low;
    Columns within = columns;
    if (to_low > 0) within.first = columns.first - static_cast<std::int64_t>(floor_divide(-to_low, step));
    if (to_high < step * (columns.last - columns.first))
        within.last = columns.first + static_cast<std::int64_t>(floor_divide(to_high, step));
    return within;
}

}  // namespace relevo::raster
