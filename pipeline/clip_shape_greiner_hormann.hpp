// Clipping one polygon at another, both of any shape (Weiler and Atherton 1977; Greiner and Hormann 1998; for
// polygons that touch: Foster, Hormann and Popa 2019, "Clipping simple polygons with degenerate
// intersections"). What Sutherland and Hodgman do for convex windows, for concave ones too.
//
// 1. Find where the outlines meet, and put these points into both of them.
// 2. Between two of these points an outline stays on one side of the other polygon: inside, outside, or along
//    its border. At a meeting point where the polygon goes inside it enters, where it goes outside it leaves.
// 3. Walk: along the polygon from where it enters to where it leaves, then on along the window, until the
//    ring closes. Repeat for what was not walked yet.
//
// Which side an outline goes to is decided by the directions of the edges at the point: inside of the corner
// of the other polygon, outside, or along one of its edges. So corners on edges, shared corners and shared
// edges need no special treatment; the part along a shared edge is taken once, and only where both polygons
// lie on the same side of it. All decisions are exact for finite floats, and so is the order of meeting
// points along an edge; each coordinate is rounded once.
//
// in:  two simple polygons in any winding. Repeated points do no harm. What is not finite is refused, and a
//      window without area is.
// out: keep = Inside: what of the polygon lies in the window: rings with the winding of the polygon, that do
//      not overlap. Polygon in window: itself; window in polygon: the window.
//      keep = Outside: what lies outside of it. A window in the middle of the polygon is a hole then: the
//      rings are the polygon, and the window in the opposite winding.
//      Polygons that cross or touch themselves (simple_polygon.hpp) give rings, too, but what these cover is
//      not defined.
// Time: every edge meets every edge of the window, n m comparisons.
#pragma once
#include <algorithm>
#include <iterator>
#include <limits>

#include "pipeline/link_rings.hpp"

namespace relevo::pipeline {

enum class ClipKeep { Inside, Outside };
enum class MeetingKind { Enters, Leaves, Touches };

struct OutlinesMeet {  // event, in order along the polygon
    glm::vec2 point;
    MeetingKind kind;
};
struct OutlineWalked {  // event: a stretch of a ring of the answer
    std::size_t ring;
    glm::vec2 from, to;
    bool along_window;
};

// Where an outline lies, seen from the other polygon.
enum class Whereabouts { Inside, Outside, AlongWith, AlongAgainst };

inline constexpr std::size_t no_edge = std::numeric_limits<std::size_t>::max();

// A point of an outline: a corner, or a meeting point within an edge.
struct OutlineNode {
    std::size_t number;  // of the point; the same in both outlines
    glm::vec2 point;
    std::size_t edge;  // of its own polygon: the one that leaves here
    bool is_corner;
    std::size_t other_in = no_edge, other_out = no_edge;  // the other's edges that arrive and leave here
    ClipLine other{};                                     // the other's edge that crosses, if no corner
    Whereabouts leaves = Whereabouts::Outside;            // the stretch that begins here
    bool meets() const { return other_in != no_edge; }
};

// The corners of a polygon, clockwise as seen, without repetitions; and the nodes in order.
struct Outline {
    std::vector<glm::vec2> corners;
    bool reversed = false;
    std::vector<OutlineNode> nodes;

    std::size_t before(std::size_t i) const { return i == 0 ? corners.size() - 1 : i - 1; }
    std::size_t after(std::size_t i) const { return i + 1 == corners.size() ? 0 : i + 1; }
    ClipLine edge(std::size_t i) const { return {corners[i], corners[after(i)]}; }
};

inline int sign_of_area(std::span<const glm::vec2> ring) {
    return sign_of([&](auto n) {
        auto sum = n(0);
        for (std::size_t i = 2; i < ring.size(); ++i)
            sum = sum + cross(n, ring[0], ring[i - 1], ring[0], ring[i]);
        return sum;
    });
}

// No corners when the polygon has no area.
inline Outline outline_of(std::span<const glm::vec2> polygon) {
    Outline outline;
    std::ranges::unique_copy(polygon, std::back_inserter(outline.corners));
    while (outline.corners.size() > 1 && outline.corners.back() == outline.corners.front())
        outline.corners.pop_back();
    const int winding = sign_of_area(outline.corners);
    outline.reversed = winding < 0;
    if (outline.reversed) std::ranges::reverse(outline.corners);
    if (winding == 0) outline.corners.clear();
    return outline;
}

// Where a direction leads from a point on the outline of `polygon`, at which edge `in` arrives and edge `out`
// leaves.
inline Whereabouts whereabouts(const Outline& polygon, std::size_t in, std::size_t out,
                               const ClipLine& direction) {
    const auto turn = [](const ClipLine& u, const ClipLine& v) {
        return sign_of_cross(u.from, u.to, v.from, v.to);
    };
    const ClipLine arriving = polygon.edge(in), leaving = polygon.edge(out);
    const int from_in = turn(arriving, direction), from_out = turn(leaving, direction);
    if (from_out == 0 && points_right(leaving) == points_right(direction)) return Whereabouts::AlongWith;
    if (from_in == 0 && points_right(arriving) != points_right(direction)) return Whereabouts::AlongAgainst;
    const bool reflex = turn(arriving, leaving) < 0;
    const bool inside = reflex ? from_in > 0 || from_out > 0 : from_in > 0 && from_out > 0;
    return inside ? Whereabouts::Inside : Whereabouts::Outside;
}

// Whether the point, which is not on the outline, lies within: a ray to the left crosses an odd number of
// edges.
inline bool holds(const Outline& polygon, const glm::vec2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const ClipLine edge = polygon.edge(i);
        if ((edge.from.y <= p.y) == (edge.to.y <= p.y)) continue;
        const bool down = edge.from.y < edge.to.y;
        if (side_of(edge, p) == (down ? -1 : 1)) inside = !inside;
    }
    return inside;
}

// Step 1.
inline void find_meetings(Outline& polygon, Outline& window) {
    const std::size_t count = polygon.corners.size(), window_count = window.corners.size();
    std::vector<OutlineNode> corners, window_corners, within, window_within;
    for (std::size_t i = 0; i < count; ++i) corners.push_back({i, polygon.corners[i], i, true});
    for (std::size_t j = 0; j < window_count; ++j)
        window_corners.push_back({count + j, window.corners[j], j, true});
    std::size_t next_number = count + window_count;
    const auto apart = [](const ClipLine& e, const ClipLine& f) {
        const auto [ex0, ex1] = std::minmax(e.from.x, e.to.x);
        const auto [ey0, ey1] = std::minmax(e.from.y, e.to.y);
        const auto [fx0, fx1] = std::minmax(f.from.x, f.to.x);
        const auto [fy0, fy1] = std::minmax(f.from.y, f.to.y);
        return ex1 < fx0 || fx1 < ex0 || ey1 < fy0 || fy1 < ey0;
    };
    // For a point on the line of the edge; the edge's end is the start of the next one.
    const auto on_edge = [](const glm::vec2& p, const ClipLine& e) {
        if (p == e.to) return false;
        const auto between = [](float v, float a, float b) {
            return std::min(a, b) <= v && v <= std::max(a, b);
        };
        return between(p.x, e.from.x, e.to.x) && between(p.y, e.from.y, e.to.y);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const ClipLine e = polygon.edge(i);
        for (std::size_t j = 0; j < window_count; ++j) {
            const ClipLine f = window.edge(j);
            if (apart(e, f)) continue;
            const int e_from = side_of(f, e.from), e_to = side_of(f, e.to), f_from = side_of(e, f.from),
                      f_to = side_of(e, f.to);
            if (e_from * e_to < 0 && f_from * f_to < 0) {
                const glm::vec2 point = meeting_point({e.from, e.to}, f);
                within.push_back({next_number, point, i, false, j, j, f});
                window_within.push_back({next_number, point, j, false, i, i, e});
                ++next_number;
            }
            if (e_from == 0 && e.from == f.from) {
                corners[i].other_in = window.before(j), corners[i].other_out = j;
                window_corners[j].other_in = polygon.before(i), window_corners[j].other_out = i;
                window_corners[j].number = i;
            } else if (e_from == 0 && on_edge(e.from, f)) {
                corners[i].other_in = corners[i].other_out = j;
                window_within.push_back({i, e.from, j, false, polygon.before(i), i});
            } else if (f_from == 0 && on_edge(f.from, e)) {
                window_corners[j].other_in = window_corners[j].other_out = i;
                within.push_back({count + j, f.from, i, false, window.before(j), j});
            }
        }
    }
    // The nodes within an edge in the order of t, as a fraction.
    const auto merge = [](Outline& outline, std::vector<OutlineNode>& outline_corners,
                          std::vector<OutlineNode>& inner) {
        const auto fraction = [](auto n, const ClipLine& edge, const OutlineNode& node) {
            const ClipLine& line = node.other;
            if (line.from != line.to)
                return Fraction{cross(n, line.from, line.to, edge.from, line.from),
                                cross(n, line.from, line.to, edge.from, edge.to)};
            const int axis = edge.from.x != edge.to.x ? 0 : 1;
            return Fraction{n(node.point[axis]) - n(edge.from[axis]), n(edge.to[axis]) - n(edge.from[axis])};
        };
        std::ranges::stable_sort(inner, [&](const OutlineNode& a, const OutlineNode& b) {
            if (a.edge != b.edge) return a.edge < b.edge;
            const ClipLine edge = outline.edge(a.edge);
            const auto bottom = [&](const OutlineNode& node) {
                return sign_of([&](auto n) { return fraction(n, edge, node).bottom; });
            };
            const auto difference = [&](auto n) {
                const auto s = fraction(n, edge, a), t = fraction(n, edge, b);
                return s.top * t.bottom - t.top * s.bottom;
            };
            return sign_of(difference) * bottom(a) * bottom(b) < 0;
        });
        auto next = inner.begin();
        for (const OutlineNode& corner : outline_corners) {
            outline.nodes.push_back(corner);
            for (; next != inner.end() && next->edge == corner.edge; ++next) outline.nodes.push_back(*next);
        }
    };
    merge(polygon, corners, within), merge(window, window_corners, window_within);
}

// Step 2: where each stretch of the outline lies.
inline void find_whereabouts(Outline& outline, const Outline& other) {
    auto& nodes = outline.nodes;
    const auto first = std::size_t(std::ranges::find_if(nodes, &OutlineNode::meets) - nodes.begin());
    const bool meets = first < nodes.size();
    Whereabouts now = meets || !holds(other, nodes[0].point) ? Whereabouts::Outside : Whereabouts::Inside;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        OutlineNode& node = nodes[(first + k) % nodes.size()];
        if (node.meets()) now = whereabouts(other, node.other_in, node.other_out, outline.edge(node.edge));
        node.leaves = now;
    }
}

// Step 3, for stretches that have been chosen.
struct Stretch {
    OutlineNode from, to;
    ClipLine line;  // of its edge, in the direction of the walk
    bool along_window;
};

template <class Probe = const NoProbe>
std::vector<std::vector<glm::vec2>> clip_shape_greiner_hormann(std::span<const glm::vec2> polygon_points,
                                                               std::span<const glm::vec2> window_points,
                                                               ClipKeep keep = ClipKeep::Inside,
                                                               Probe&& probe = {}) {
    if (!is_finite(polygon_points) || !is_finite(window_points))
        return note<ClipRefused>(probe, Refusal::NotFinite), std::vector<std::vector<glm::vec2>>{};
    Outline polygon = outline_of(polygon_points), window = outline_of(window_points);
    if (window.corners.empty())
        return note<ClipRefused>(probe, Refusal::NoArea), std::vector<std::vector<glm::vec2>>{};
    if (polygon.corners.empty()) return {};
    find_meetings(polygon, window);
    find_whereabouts(polygon, window), find_whereabouts(window, polygon);

    std::vector<Stretch> stretches;
    const auto choose = [&](const Outline& outline, bool along_window, auto&& wanted) {
        for (std::size_t k = 0; k < outline.nodes.size(); ++k) {
            const OutlineNode& from = outline.nodes[k];
            const OutlineNode& to = outline.nodes[(k + 1) % outline.nodes.size()];
            if (wanted(from.leaves)) stretches.push_back({from, to, outline.edge(from.edge), along_window});
        }
    };
    using enum Whereabouts;
    const bool inside = keep == ClipKeep::Inside;
    choose(polygon, false, [&](Whereabouts w) {
        return inside ? w == Inside || w == AlongWith : w == Outside || w == AlongAgainst;
    });
    choose(window, true, [&](Whereabouts w) { return w == Inside; });
    if (!inside)  // what is cut out is walked round the other way
        for (Stretch& s : stretches)
            if (s.along_window) std::swap(s.from, s.to), std::swap(s.line.from, s.line.to);
    if constexpr (Wants<Probe, OutlinesMeet>) {
        Whereabouts before = polygon.nodes.back().leaves;
        for (const OutlineNode& node : polygon.nodes) {
            const bool enters = before != Inside && node.leaves == Inside,
                       leaves = before == Inside && node.leaves != Inside;
            if (node.meets())
                note<OutlinesMeet>(probe, node.point,
                                   enters   ? MeetingKind::Enters
                                   : leaves ? MeetingKind::Leaves
                                            : MeetingKind::Touches);
            before = node.leaves;
        }
    }

    std::vector<RingPiece> pieces;
    for (const Stretch& s : stretches) pieces.push_back({s.from.number, s.to.number, s.line, s.line});
    std::vector<std::vector<glm::vec2>> rings;
    for (const auto& linked : link_rings(pieces)) {
        std::vector<glm::vec2> ring;
        const Stretch* before = &stretches[linked.back()];
        for (const std::size_t index : linked) {
            const Stretch& s = stretches[index];
            note<OutlineWalked>(probe, rings.size(), s.from.point, s.to.point, s.along_window);
            const bool straight_on = !s.from.is_corner && before->along_window == s.along_window;
            if (!straight_on && (ring.empty() || ring.back() != s.from.point)) ring.push_back(s.from.point);
            before = &s;
        }
        while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
        if (ring.size() < 3) continue;
        if (polygon.reversed) std::ranges::reverse(ring);
        rings.push_back(std::move(ring));
    }
    return rings;
}

// The same for a box; one without area holds nothing.
template <class Probe = const NoProbe>
std::vector<std::vector<glm::vec2>> clip_shape_greiner_hormann(std::span<const glm::vec2> polygon,
                                                               const ClipBox& box,
                                                               ClipKeep keep = ClipKeep::Inside,
                                                               Probe&& probe = {}) {
    if (!is_window(box))
        return note<ClipRefused>(probe, refusal_of(box)), std::vector<std::vector<glm::vec2>>{};
    const glm::vec2 corners[] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    return clip_shape_greiner_hormann(polygon, std::span<const glm::vec2>(corners), keep, probe);
}

}  // namespace relevo::pipeline
