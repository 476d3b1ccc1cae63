// The words of two-dimensional clipping: segments, windows and their sides, and the two exact questions that
// all clippers ask: on which side of a line is a point, and where does a segment cross a line?
//
// Any coordinates, as a lesson has them: x to the right, y down, so the top of a window is its smallest y.
// Coordinates are floats. Decisions are those of rational arithmetic for all finite values, and crossings are
// correctly rounded (exact_sum.hpp), so the answer depends neither on the algorithm nor on the direction.
// A coordinate that is zero may come out as +0 where -0 went in.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "pipeline/exact_sum.hpp"
#include "pipeline/probe.hpp"
#include "pipeline/result.hpp"

namespace relevo::pipeline {

struct Segment {
    glm::vec2 a, b;
    friend bool operator==(const Segment&, const Segment&) = default;
};

enum class Side { Left, Right, Bottom, Top };  // of a window, as seen in the picture
constexpr bool is_upright(Side side) { return side == Side::Left || side == Side::Right; }

// The window low.x <= x <= high.x, low.y <= y <= high.y; it may be a line or a point.
struct ClipBox {
    glm::vec2 low, high;
    float at(Side side) const {
        return side == Side::Left ? low.x : side == Side::Right ? high.x : side == Side::Top ? low.y : high.y;
    }
};

// A line as the border of a half-plane: inside is where (to - from) x (p - from) >= 0, so the sides of a
// window run clockwise as seen.
struct ClipLine {
    glm::vec2 from, to;
    friend bool operator==(const ClipLine&, const ClipLine&) = default;
};

// The order of points along a line, and whether a line runs with it: to the right, or straight down.
inline bool comes_before(const glm::vec2& a, const glm::vec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}
inline bool points_right(const ClipLine& line) { return comes_before(line.from, line.to); }

// How a segment passes a side's line (fig. 4.5): it may enter there, or leave, or never does.
enum class Passage { Entering, Leaving, ParallelInside, ParallelOutside };

// Why a clipper refuses to answer. Nothing is visible then.
enum class Refusal {
    NotFinite,  // a coordinate is infinite or not a number
    EmptyBox,   // low.x > high.x or low.y > high.y
    NoArea,     // a window polygon with all corners on one line, or with fewer than three
    NotConvex,  // a window polygon with a dent, or one that crosses itself
};
struct ClipRefused {  // event
    Refusal reason;
};

inline bool is_finite(const glm::vec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }
inline bool is_finite(const Segment& s) { return is_finite(s.a) && is_finite(s.b); }
inline bool is_finite(std::span<const glm::vec2> points) {
    for (const glm::vec2& p : points)
        if (!is_finite(p)) return false;
    return true;
}

// ---------------------------------------------------------------------------------- exact questions

// u x v of two vectors u = b - a, v = d - c. For any kind of number.
template <class As>
auto cross(As n, const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, const glm::vec2& d) {
    return (n(b.x) - n(a.x)) * (n(d.y) - n(c.y)) - (n(b.y) - n(a.y)) * (n(d.x) - n(c.x));
}
inline int sign_of_cross(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, const glm::vec2& d) {
    return sign_of([&](auto n) { return cross(n, a, b, c, d); });
}

// 1 inside, 0 on the line, -1 outside.
inline int side_of(const ClipLine& line, const glm::vec2& p) {
    return sign_of_cross(line.from, line.to, line.from, p);
}

// Where two lines that are not parallel meet, one coordinate (0: x, 1: y) as a fraction. With the distances
// g(p) = (to - from) x (p - from) of the ends of s, which the line cuts in the ratio g(a) : -g(b),
//   p = (a g(b) - b g(a)) / (g(b) - g(a)).
template <class As>
auto meeting(As n, const Segment& s, const ClipLine& line, int axis) {
    const auto ga = cross(n, line.from, line.to, line.from, s.a),
               gb = cross(n, line.from, line.to, line.from, s.b);
    return Fraction{n(s.a[axis]) * gb - n(s.b[axis]) * ga, cross(n, line.from, line.to, s.a, s.b)};
}
inline glm::vec2 meeting_point(const Segment& s, const ClipLine& line) {
    const auto coordinate = [&](int axis) {
        return nearest_float([&](auto n) { return meeting(n, s, line, axis); });
    };
    return {coordinate(0), coordinate(1)};
}

// ------------------------------------------------------------------------------------------ windows

inline bool is_window(const ClipBox& box) {  // false for what is not a number, too
    return is_finite(box.low) && is_finite(box.high) && box.low.x <= box.high.x && box.low.y <= box.high.y;
}
inline Refusal refusal_of(const ClipBox& box) {
    return is_finite(box.low) && is_finite(box.high) ? Refusal::EmptyBox : Refusal::NotFinite;
}

inline ClipLine line_of(const ClipBox& box, Side side) {
    switch (side) {
        case Side::Top:
            return {{0, box.low.y}, {1, box.low.y}};
        case Side::Right:
            return {{box.high.x, 0}, {box.high.x, 1}};
        case Side::Bottom:
            return {{1, box.high.y}, {0, box.high.y}};
        default:
            return {{box.low.x, 1}, {box.low.x, 0}};
    }
}

// The sides in the order of fig. 4.6.
inline std::array<ClipLine, 4> lines_of(const ClipBox& box) {
    return {line_of(box, Side::Top), line_of(box, Side::Right), line_of(box, Side::Bottom),
            line_of(box, Side::Left)};
}

// The sides of a convex polygon in clockwise order as seen. Either winding will do; repeated corners and
// corners on a straight side do no harm. Decided exactly.
//
// A ring is convex when it never turns to the other side, never turns back on itself, and goes round once:
// then it has one leftmost and one rightmost corner (of equal ones the upper, the lower), that is, two
// changes of direction. A pentagram always turns to the same side, but has more.
inline Result<std::vector<ClipLine>, Refusal> convex_window(std::span<const glm::vec2> polygon) {
    if (!is_finite(polygon)) return Refusal::NotFinite;
    std::vector<ClipLine> sides;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::vec2 &from = polygon[i], &to = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        if (from != to) sides.push_back({from, to});
    }
    int winding = 0, changes = 0;
    bool dented = false, folded = false;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const ClipLine &before = sides[i], &after = sides[i + 1 == sides.size() ? 0 : i + 1];
        const bool change = points_right(before) != points_right(after);
        const int turn = sign_of_cross(before.from, before.to, after.from, after.to);
        changes += change;
        folded = folded || (turn == 0 && change);
        dented = dented || turn * winding < 0;
        if (turn != 0) winding = turn;
    }
    if (winding == 0) return Refusal::NoArea;
    if (dented || folded || changes != 2) return Refusal::NotConvex;
    if (winding < 0) {
        for (ClipLine& side : sides) std::swap(side.from, side.to);
        std::reverse(sides.begin(), sides.end());
    }
    return sides;
}
inline bool is_convex(std::span<const glm::vec2> polygon) { return bool(convex_window(polygon)); }

// --------------------------------------------------------------------------- outcodes (fig. 4.2)

// One bit a side that the point lies beyond. Written as in fig. 4.2: above, below, right, left.
using Outcode = std::uint8_t;
constexpr Outcode outcode_of(Side side) {
    return side == Side::Top ? 8 : side == Side::Bottom ? 4 : side == Side::Right ? 2 : 1;
}

// From the order of a coordinate to the sides it lies between: negative below it, 0 on it, positive above.
constexpr Outcode outcode_of(int to_left, int to_right, int to_top, int to_bottom) {
    return static_cast<Outcode>((to_top < 0 ? 8 : 0) | (to_bottom > 0 ? 4 : 0) | (to_right > 0 ? 2 : 0) |
                                (to_left < 0 ? 1 : 0));
}
inline Outcode outcode(const ClipBox& box, const glm::vec2& p) {
    const auto order = [](float a, float b) { return int(a > b) - int(a < b); };
    return outcode_of(order(p.x, box.low.x), order(p.x, box.high.x), order(p.y, box.low.y),
                      order(p.y, box.high.y));
}

// Where the line through a segment crosses the line of a side, and the outcode of that place. The outcode is
// that of the exact place, which lies on the side's line; the point is rounded. The segment is not parallel
// to the side.
//
//   x = w:  y = (a.y (b.x - w) + b.y (w - a.x)) / (b.x - a.x)          y = w: with x and y exchanged
struct SideCrossing {
    glm::vec2 point;
    Outcode code;
};
inline SideCrossing cross_side(const Segment& s, const ClipBox& box, Side side) {
    const int fixed = is_upright(side) ? 0 : 1, moving = 1 - fixed;
    const float w = box.at(side);
    const auto place = [&](auto n) {
        return Fraction{n(s.a[moving]) * (n(s.b[fixed]) - n(w)) + n(s.b[moving]) * (n(w) - n(s.a[fixed])),
                        n(s.b[fixed]) - n(s.a[fixed])};
    };
    const float rounded = nearest_float(place);
    // Rounding keeps the order, so only where it ends on the limit itself the exact place must be asked.
    const auto order = [&](float limit) {
        if (rounded != limit) return rounded < limit ? -1 : 1;
        const int direction = s.a[fixed] < s.b[fixed] ? 1 : -1;
        return direction * sign_of([&](auto n) {
                   const auto [top, bottom] = place(n);
                   return top - n(limit) * bottom;
               });
    };
    SideCrossing crossing;
    crossing.point[fixed] = w + 0.0f;
    crossing.point[moving] = rounded;
    crossing.code = fixed == 0 ? outcode_of(0, 0, order(box.low.y), order(box.high.y))
                               : outcode_of(order(box.low.x), order(box.high.x), 0, 0);
    return crossing;
}

}  // namespace relevo::pipeline
