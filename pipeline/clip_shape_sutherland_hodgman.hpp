// Polygon clipping, one side of the window after the other (Sutherland and Hodgman 1974; textbook section
// 4.3.1, figures 4.6 to 4.8).
//
// Against the line of one side, every edge of the polygon is of one of four kinds, and leaves points:
//
//   inside    its destination          leaving   the crossing
//   outside   nothing                  entering  the crossing and its destination
//
// A destination on the line is kept once: an edge that ends or starts there is not crossed. The points that a
// side leaves are the polygon for the next one. clip_shape_pipeline.hpp does the same without the lists in
// between.
//
// in:  a polygon, in either winding; it may be concave or cross itself. A window: a box, a convex polygon, or
//      its sides.
// out: one polygon of the same winding. Where a concave polygon falls apart, edges that lie upon each other
//      along the border of the window connect the pieces (fig. 4.9): split_bridges.hpp removes them. Signed
//      area is that of the polygon inside the window, so parts that a crossing polygon winds round twice
//      count twice. Repeated points come out once; fewer than three are nothing.
//
// A corner made by clipping remembers the two lines that it lies on. So sides are decided exactly for all
// finite floats, however many sides came before, and each coordinate is rounded once. Points or windows that
// are not finite, boxes with low > high and windows that are not convex are refused: nothing is left.
#pragma once
#include <algorithm>

#include "pipeline/clip_plane.hpp"

namespace relevo::pipeline {

enum class EdgeKind { Entering, Inside, Leaving, Outside };  // fig. 4.7

struct ShapeEdgeClassified {  // event: one edge against one side
    std::size_t side;         // of the window's list
    glm::vec2 from, to;
    EdgeKind kind;
};
struct ShapePointEmitted {  // event: fig. 4.8
    std::size_t side;
    glm::vec2 point;
    bool crossing;  // or a corner of the polygon before
};
struct ShapeSideDone {  // event: the polygon after a side (fig. 4.6)
    std::size_t side;
    ClipLine line;
    std::vector<glm::vec2> polygon;
};

// A polygon cut at a window. Edge i goes from point i - 1 to point i.
struct ClippedRing {
    std::vector<glm::vec2> points;
    std::vector<int> edge_side;   // the side of the window on whose line edge i runs, -1 for none
    std::vector<int> point_side;  // a side on whose line point i lies, -1 for none
};

// A corner on its way through the sides. It is a point of the polygon, or the crossing of `along` and `cut`.
struct ShapeCorner {
    glm::vec2 point;   // rounded, when it is a crossing
    ClipLine arrives;  // the line of the edge that ends here
    std::size_t edge;  // the edge of the polygon that it comes from; edge i ends in point i
    int edge_side = -1, point_side = -1;
    bool is_crossing = false;
    ClipLine along{}, cut{};
};

// On which side of the line: 1 inside, 0 on it, -1 outside. Exact for crossings, too: with the crossing
// p = top / bottom, the sign of (to - from) x (p - from) is that of (to - from) x (top - from bottom) bottom.
inline int side_of(const ClipLine& line, const ShapeCorner& corner) {
    if (!corner.is_crossing) return side_of(line, corner.point);
    const Segment along{corner.along.from, corner.along.to};
    const int bottom = sign_of_cross(corner.cut.from, corner.cut.to, along.a, along.b);
    return bottom * sign_of([&](auto n) {
               const auto [x, w] = meeting(n, along, corner.cut, 0);
               const auto y = meeting(n, along, corner.cut, 1).top;
               return (n(line.to.x) - n(line.from.x)) * (y - n(line.from.y) * w) -
                      (n(line.to.y) - n(line.from.y)) * (x - n(line.from.x) * w);
           });
}

// One edge against one side: emit(corner) is called 0, 1 or 2 times. This is the algorithm; the two forms
// only differ in where they keep what is emitted.
template <class Emit, class Probe>
void clip_shape_edge(const ShapeCorner& from, int from_side, const ShapeCorner& to, int to_side,
                     const ClipLine& line, std::size_t side, Emit&& emit, Probe& probe) {
    const bool starts = from_side >= 0, stays = to_side >= 0;
    const EdgeKind kind = starts ? (stays ? EdgeKind::Inside : EdgeKind::Leaving)
                                 : (stays ? EdgeKind::Entering : EdgeKind::Outside);
    note<ShapeEdgeClassified>(probe, side, from.point, to.point, kind);
    if (from_side * to_side < 0) {
        ShapeCorner crossing{meeting_point({to.arrives.from, to.arrives.to}, line),
                             starts ? to.arrives : line,
                             to.edge,
                             starts ? to.edge_side : static_cast<int>(side),
                             static_cast<int>(side),
                             true,
                             to.arrives,
                             line};
        note<ShapePointEmitted>(probe, side, crossing.point, true);
        emit(crossing);
    }
    if (!stays) return;
    ShapeCorner kept = to;
    if (to_side == 0) kept.point_side = static_cast<int>(side);
    if (to_side == 0 && from_side <= 0) kept.arrives = line, kept.edge_side = static_cast<int>(side);
    note<ShapePointEmitted>(probe, side, kept.point, false);
    emit(kept);
}

// The corners of a polygon as the first side takes them.
inline ShapeCorner shape_corner(std::span<const glm::vec2> polygon, std::size_t i) {
    const glm::vec2 &before = polygon[i == 0 ? polygon.size() - 1 : i - 1], &point = polygon[i];
    return {point, {before, point}, i};
}

// The corners as points, of equal neighbours only one. Every side starts its list one edge later; here it is
// turned back, so that a polygon that is not cut comes out as it went in.
class RingBuilder {
  public:
    void push(const ShapeCorner& corner) {
        if (!corners_.empty() && corner.point == corners_.back().point)
            merge(corners_.back(), corner);
        else
            corners_.push_back({corner.point, corner.edge, corner.edge_side, corner.point_side});
    }
    ClippedRing finished() && {
        while (corners_.size() > 1 && corners_.back().point == corners_.front().point) {
            merge(corners_.front(), corners_.back());
            corners_.front().edge_side = corners_.back().edge_side;
            corners_.pop_back();
        }
        ClippedRing ring;
        if (corners_.size() < 3) return ring;
        const auto later = [](const Corner& a, const Corner& b) { return a.edge > b.edge; };
        const auto last = std::ranges::adjacent_find(corners_, later);
        if (last != corners_.end()) std::rotate(corners_.begin(), last + 1, corners_.end());
        for (const Corner& corner : corners_) {
            ring.points.push_back(corner.point);
            ring.edge_side.push_back(corner.edge_side);
            ring.point_side.push_back(corner.point_side);
        }
        return ring;
    }

  private:
    struct Corner {
        glm::vec2 point;
        std::size_t edge;
        int edge_side, point_side;
    };
    static void merge(Corner& kept, const auto& dropped) {
        kept.edge = std::min(kept.edge, dropped.edge);
        kept.point_side = std::max(kept.point_side, dropped.point_side);
    }
    std::vector<Corner> corners_;
};

// The polygon inside all lines, in passes.
template <class Probe = const NoProbe>
ClippedRing clip_ring_sutherland_hodgman(std::span<const glm::vec2> polygon, std::span<const ClipLine> window,
                                         Probe&& probe = {}) {
    if (!is_finite(polygon)) return note<ClipRefused>(probe, Refusal::NotFinite), ClippedRing{};
    std::vector<ShapeCorner> corners, next;
    corners.reserve(polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i) corners.push_back(shape_corner(polygon, i));
    for (std::size_t side = 0; side < window.size(); ++side) {
        const ClipLine& line = window[side];
        const auto emit = [&](const ShapeCorner& corner) { next.push_back(corner); };
        const int first_side = corners.empty() ? 0 : side_of(line, corners.front());
        int from_side = first_side;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const bool last = i + 1 == corners.size();
            const ShapeCorner& to = corners[last ? 0 : i + 1];
            const int to_side = last ? first_side : side_of(line, to);
            clip_shape_edge(corners[i], from_side, to, to_side, line, side, emit, probe);
            from_side = to_side;
        }
        std::swap(corners, next);
        next.clear();
        if constexpr (Wants<Probe, ShapeSideDone>) {
            std::vector<glm::vec2> points;
            for (const ShapeCorner& corner : corners) points.push_back(corner.point);
            note<ShapeSideDone>(probe, side, line, std::move(points));
        }
    }
    RingBuilder ring;
    for (const ShapeCorner& corner : corners) ring.push(corner);
    return std::move(ring).finished();
}

// A form of the algorithm, for windows of any kind: calls clip(lines) when the window is one.
template <class Clip, class Probe>
ClippedRing with_window(const ClipBox& box, Clip&& clip, Probe& probe) {
    if (!is_window(box)) return note<ClipRefused>(probe, refusal_of(box)), ClippedRing{};
    return clip(std::span<const ClipLine>(lines_of(box)));
}
template <class Clip, class Probe>
ClippedRing with_window(std::span<const glm::vec2> polygon, Clip&& clip, Probe& probe) {
    const auto window = convex_window(polygon);
    if (!window) return note<ClipRefused>(probe, window.error()), ClippedRing{};
    return clip(std::span<const ClipLine>(*window));
}

template <class Probe = const NoProbe>
ClippedRing clip_ring_sutherland_hodgman(std::span<const glm::vec2> polygon, const ClipBox& window,
                                         Probe&& probe = {}) {
    return with_window(
        window, [&](auto lines) { return clip_ring_sutherland_hodgman(polygon, lines, probe); }, probe);
}
template <class Probe = const NoProbe>
ClippedRing clip_ring_sutherland_hodgman(std::span<const glm::vec2> polygon,
                                         std::span<const glm::vec2> window, Probe&& probe = {}) {
    return with_window(
        window, [&](auto lines) { return clip_ring_sutherland_hodgman(polygon, lines, probe); }, probe);
}

// Only the points. `window` is a ClipBox, the corners of a convex polygon, or lines.
template <class Window, class Probe = const NoProbe>
std::vector<glm::vec2> clip_shape_sutherland_hodgman(std::span<const glm::vec2> polygon, const Window& window,
                                                     Probe&& probe = {}) {
    return clip_ring_sutherland_hodgman(polygon, window, probe).points;
}

}  // namespace relevo::pipeline
