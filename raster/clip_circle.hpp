// Circles cut at a box: only the pixels inside are visited, and what is outside costs nothing.
//
// Source: textbook section 4.2: test the whole circle, then its quadrants, then its octants; only an octant
// that crosses the border of the box is looked at closer. The textbook then tests pixel by pixel. Here the
// columns of the octant inside the box are solved for instead: along an octant y falls, so they are one run,
// and both its ends are found by bisection on
//
//   y(x) >= y  <=>  the midpoint (x, y - 1/2) lies inside the circle  <=>  x^2 + y^2 - y < R^2
//
// (1/4 is missing on the left: all else is whole). The algorithm then starts at the first of them with the
// decision variable that it would have had there: the same pixels as drawing everything and discarding.
//
// An octant is the one from (0, R) to the diagonal x = y, centre at (0, 0), mirrored. Pixels on the axes and
// the diagonals belong to one octant each. All tests are in 64 bits: centre + radius may leave 32.
#pragma once
#include <cstdint>
#include <utility>

#include "pipeline/probe.hpp"
#include "raster/pixel.hpp"

namespace relevo::raster {

using pipeline::NoProbe;
using pipeline::note;

inline constexpr int largest_circle_radius = 1 << 30;

// Event: an algorithm begins.
struct CircleStarted {
    Pixel center;
    int radius;
};

// Event: what the clipper says about a part of the circle or ellipse. `low` and `high` are the corners of the
// part's box. An octant to cut (or a quadrant of an ellipse) goes on with the pixels inside the box only.
struct CirclePart {
    enum Part { Whole, Quadrant, Octant } part;
    int sign_x, sign_y;  // where it lies from the centre; 0, 0: all around
    bool swapped;        // octants: x and y have changed places
    enum Fate { Accepted, Rejected, Cut } fate;
    std::int64_t low_x, low_y, high_x, high_y;
};

// The last whole number in low..high of which `holds` is true, when it is true up to some number and false
// after it; low - 1 when it is never true.
template <class Holds>
constexpr std::int64_t last_that(std::int64_t low, std::int64_t high, Holds&& holds) {
    while (low <= high) {
        const std::int64_t middle = low + (high - low) / 2;
        if (holds(middle))
            low = middle + 1;
        else
            high = middle - 1;
    }
    return high;
}

// Whole numbers low..high; empty when low > high.
struct Range {
    std::int64_t low, high;
    constexpr bool empty() const { return low > high; }
    constexpr bool holds(const Range& r) const { return low <= r.low && r.high <= high; }
};
constexpr Range common(const Range& a, const Range& b) {
    return {a.low > b.low ? a.low : b.low, a.high < b.high ? a.high : b.high};
}
// The box's columns or rows as seen from the centre in the direction of the sign.
constexpr Range seen_from(int center, int sign, int low, int high) {
    if (sign > 0) return {std::int64_t{low} - center, std::int64_t{high} - center};
    return {std::int64_t{center} - high, std::int64_t{center} - low};
}

// The octant from (0, R) to the diagonal without walking along it. R >= 1.
struct CircleOctant {
    std::int64_t radius;

    // Whether the curve passes above (x, y - 1/2): pixel y or a higher one is chosen in column x.
    constexpr bool reaches(std::int64_t x, std::int64_t y) const {
        return y <= 0 || x * x + y * y - y < radius * radius;
    }
    constexpr std::int64_t row(std::int64_t x) const {
        return last_that(0, radius, [&](std::int64_t y) { return reaches(x, y); });
    }
    // The last column with x <= y(x); without the diagonal: with x < y(x).
    constexpr std::int64_t last_column(bool with_diagonal) const {
        return last_that(0, radius, [&](std::int64_t x) { return reaches(x, with_diagonal ? x : x + 1); });
    }
    // The part of `columns` whose pixels lie in `rows`.
    constexpr Range inside(const Range& columns, const Range& rows) const {
        if (columns.empty() || rows.empty() || rows.high < 0) return {0, -1};
        const auto below = [&](std::int64_t x) { return rows.high < radius && reaches(x, rows.high + 1); };
        const auto above = [&](std::int64_t x) { return rows.low <= radius && reaches(x, rows.low); };
        return {last_that(columns.low, columns.high, below) + 1, last_that(columns.low, columns.high, above)};
    }
};

// The box of a part against the box of the picture.
constexpr CirclePart::Fate fate_of(const Range& x, const Range& y, const Range& box_x, const Range& box_y) {
    if (common(x, box_x).empty() || common(y, box_y).empty()) return CirclePart::Rejected;
    return box_x.holds(x) && box_y.holds(y) ? CirclePart::Accepted : CirclePart::Cut;
}

// `x` and `y` are what the part spans, seen from the centre in the direction of its signs.
template <class Probe>
constexpr void note_part(Probe& probe, Pixel center, CirclePart::Part part, int sx, int sy, bool swapped,
                         CirclePart::Fate fate, const Range& x, const Range& y) {
    const std::int64_t cx = center.x, cy = center.y;
    note<CirclePart>(probe, part, sx, sy, swapped, fate, cx + (sx > 0 ? x.low : -x.high),
                     cy + (sy > 0 ? y.low : -y.high), cx + (sx > 0 ? x.high : -x.low),
                     cy + (sy > 0 ? y.high : -y.low));
}

// Calls quadrant(sign_x, sign_y, fate) for the quadrants of a circle or ellipse that touch the box, or
// whole() when all of it lies inside. Columns x = 0 belong to the right side, rows y = 0 to the lower one.
template <class Whole, class Quadrant, class Probe>
constexpr void clip_quadrants(Pixel center, int a, int b, const PixelBox& box, Whole&& whole,
                              Quadrant&& quadrant, Probe& probe) {
    if (box.empty()) return;
    const std::int64_t cx = center.x, cy = center.y;
    const CirclePart::Fate all =
        fate_of({cx - a, cx + a}, {cy - b, cy + b}, {box.x0, box.x1}, {box.y0, box.y1});
    note<CirclePart>(probe, CirclePart::Whole, 0, 0, false, all, cx - a, cy - b, cx + a, cy + b);
    if (all == CirclePart::Rejected) return;
    if (all == CirclePart::Accepted) return whole();
    for (const int sy : {1, -1})
        for (const int sx : {1, -1}) {
            const Range x{sx > 0 ? 0 : 1, a}, y{sy > 0 ? 0 : 1, b};
            if (x.empty() || y.empty()) continue;
            const CirclePart::Fate fate = fate_of(x, y, seen_from(center.x, sx, box.x0, box.x1),
                                                  seen_from(center.y, sy, box.y0, box.y1));
            note_part(probe, center, CirclePart::Quadrant, sx, sy, false, fate, x, y);
            if (fate != CirclePart::Rejected) quadrant(sx, sy, fate);
        }
}

// The eight octants of the pixels that `Steps` walks along: Steps::at(x, y, radius) is the state at a pixel
// of the octant, step(probe) goes to the next column. Refused (false, nothing drawn): a radius above the
// largest. A negative radius draws nothing.
template <class Steps, class Plot, class Probe>
constexpr bool clip_circle(Pixel center, int radius, const PixelBox& box, Plot&& plot, Probe& probe) {
    if (radius > largest_circle_radius) return false;
    if (radius < 0) return true;
    note<CircleStarted>(probe, center, radius);
    if (radius == 0) {
        if (box.holds(center.x, center.y)) plot(int{center.x}, int{center.y});
        return true;
    }
    const auto whole = [&] {
        const int cx = center.x, cy = center.y;
        plot(cx, cy + radius), plot(cx, cy - radius), plot(cx + radius, cy), plot(cx - radius, cy);
        Steps s = Steps::at(0, radius, radius);
        s.step(probe);
        for (; s.x < s.y; s.step(probe)) {
            plot(cx + s.x, cy + s.y), plot(cx - s.x, cy + s.y);
            plot(cx + s.x, cy - s.y), plot(cx - s.x, cy - s.y);
            plot(cx + s.y, cy + s.x), plot(cx - s.y, cy + s.x);
            plot(cx + s.y, cy - s.x), plot(cx - s.y, cy - s.x);
        }
        if (s.x != s.y) return;
        plot(cx + s.x, cy + s.x), plot(cx - s.x, cy + s.x);
        plot(cx + s.x, cy - s.x), plot(cx - s.x, cy - s.x);
    };
    const CircleOctant octant{radius};
    const auto cut = [&](int sx, int sy, bool swapped, bool accepted_already) {
        const std::int64_t cx = center.x, cy = center.y;
        const bool second = (swapped ? sy : sx) < 0;  // an axis belongs to the other one
        const Range columns{second ? 1 : 0, octant.last_column(!swapped)};
        if (columns.empty()) return;
        const Range rows{octant.row(columns.high), radius};
        const Range seen_x = seen_from(center.x, sx, box.x0, box.x1),
                    seen_y = seen_from(center.y, sy, box.y0, box.y1);
        const Range &across = swapped ? seen_y : seen_x, &down = swapped ? seen_x : seen_y;
        const CirclePart::Fate fate =
            accepted_already ? CirclePart::Accepted : fate_of(columns, rows, across, down);
        const Range &x = swapped ? rows : columns, &y = swapped ? columns : rows;
        note_part(probe, center, CirclePart::Octant, sx, sy, swapped, fate, x, y);
        if (fate == CirclePart::Rejected) return;
        const Range run =
            fate == CirclePart::Accepted ? columns : octant.inside(common(columns, across), down);
        if (run.empty()) return;
        Steps s = Steps::at(static_cast<int>(run.low), static_cast<int>(octant.row(run.low)), radius);
        for (;; s.step(probe)) {
            const std::int64_t px = swapped ? s.y : s.x, py = swapped ? s.x : s.y;
            plot(static_cast<int>(sx > 0 ? cx + px : cx - px), static_cast<int>(sy > 0 ? cy + py : cy - py));
            if (s.x == run.high) break;
        }
    };
    clip_quadrants(
        center, radius, radius, box, whole,
        [&](int sx, int sy, CirclePart::Fate fate) {
            cut(sx, sy, false, fate == CirclePart::Accepted);
            cut(sx, sy, true, fate == CirclePart::Accepted);
        },
        probe);
    return true;
}

}  // namespace relevo::raster
