// Takes a clipped polygon apart where it is only held together by edges along the border of the window
// (textbook section 4.3.1, figure 4.9: the unwanted edges that clipping a concave polygon leaves).
//
// 1. Along each side of the window, cut its edges at every point of the polygon that lies on it. Two pieces
//    of edge that lie upon each other in opposite directions are a bridge: both go. What remains is the true
//    border of the shape, each piece once.
// 2. Link what is left into rings again. Where several edges leave a point, take the one that turns most
//    sharply to the inside: pieces that touch in a point are separate polygons.
//
// in:  what clip_ring_sutherland_hodgman or clip_ring_pipeline returns
// out: polygons of the winding of the whole, none with fewer than three points. Their areas sum to that of
//      the input, since edges are only removed in opposite pairs (on a slanted side up to the rounding of its
//      points); this holds for polygons that cross themselves, too, whose pieces may cross each other. Time
//      n log n.
//
// Points on a side come in the order of the exact ones, since rounding keeps the order along a line; no
// decision depends on a rounded point lying on a slanted side.
#pragma once
#include <algorithm>
#include <utility>

#include "pipeline/clip_shape_sutherland_hodgman.hpp"
#include "pipeline/link_rings.hpp"

namespace relevo::pipeline {

struct BridgeRemoved {  // event: two edges that lay upon each other
    std::size_t side;
    glm::vec2 from, to;
};
struct PieceFound {  // event
    std::vector<glm::vec2> polygon;
};

// A part of the outline that stays together: a piece of a side of the window, or the polygon's own edges
// between two points on the border.
struct OutlinePart {
    glm::vec2 from, to;
    ClipLine leaves, arrives;
    int side = -1;                          // of the window; -1: the polygon's own edges,
    std::size_t first_edge = 0, edges = 1;  // these
};

// The edges on one side of the window, which points cut into pieces.
class BorderSide {
  public:
    void cut_at(const glm::vec2& point) { cuts_.push_back(point); }
    void add(const glm::vec2& from, const glm::vec2& to) { edges_.push_back({from, to}); }

    template <class Probe>
    void remove_bridges(int side, std::vector<OutlinePart>& remaining, Probe& probe) {
        std::ranges::sort(cuts_, comes_before);
        cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
        std::vector<int> there(cuts_.size()), back(cuts_.size());  // edges that begin less those that end
        for (const auto& [from, to] : edges_) {
            const bool forward = comes_before(from, to);
            auto& passes = forward ? there : back;
            ++passes[index_of(forward ? from : to)], --passes[index_of(forward ? to : from)];
        }
        int forth = 0, opposite = 0;
        for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
            const glm::vec2 &a = cuts_[i], &b = cuts_[i + 1];
            forth += there[i], opposite += back[i];
            for (int k = std::min(forth, opposite); k > 0; --k)
                note<BridgeRemoved>(probe, std::size_t(side), a, b);
            for (int k = opposite; k < forth; ++k) remaining.push_back({a, b, {a, b}, {a, b}, side});
            for (int k = forth; k < opposite; ++k) remaining.push_back({b, a, {b, a}, {b, a}, side});
        }
    }

  private:
    std::size_t index_of(const glm::vec2& p) const {
        return std::size_t(std::ranges::lower_bound(cuts_, p, comes_before) - cuts_.begin());
    }
    struct Edge {
        glm::vec2 from, to;
    };
    std::vector<glm::vec2> cuts_;
    std::vector<Edge> edges_;
};

template <class Probe = const NoProbe>
std::vector<std::vector<glm::vec2>> split_bridges(const ClippedRing& clipped, Probe&& probe = {}) {
    const auto& [points, edge_side, point_side] = clipped;
    const std::size_t count = points.size();
    if (count < 3) return {};
    const auto point = [&](std::size_t i) { return clipped.points[i % count]; };
    const auto start =
        std::size_t(std::ranges::find_if(point_side, [](int s) { return s >= 0; }) - point_side.begin());
    if (start == count) {  // nothing on the border: one piece
        note<PieceFound>(probe, points);
        return {points};
    }

    std::vector<OutlinePart> parts;
    std::vector<BorderSide> sides(
        std::size_t(std::max(std::ranges::max(edge_side), std::ranges::max(point_side)) + 1));
    double area = 0;  // only for its sign
    for (std::size_t i = start; i < start + count; ++i) {
        const glm::vec2 &from = point(i), &to = point(i + 1);
        const auto [x0, y0] = std::pair<double, double>(points[0].x, points[0].y);
        area += (from.x - x0) * (to.y - y0) - (to.x - x0) * (from.y - y0);
        if (const int side = point_side[i % count]; side >= 0) sides[std::size_t(side)].cut_at(from);
        if (const int side = edge_side[(i + 1) % count]; side >= 0) {
            sides[std::size_t(side)].cut_at(from), sides[std::size_t(side)].cut_at(to);
            sides[std::size_t(side)].add(from, to);
        } else if (point_side[i % count] >= 0) {
            parts.push_back({from, to, {from, to}, {from, to}, -1, i, 1});
        } else {
            parts.back().to = to, parts.back().arrives = {from, to}, ++parts.back().edges;
        }
    }
    for (std::size_t side = 0; side < sides.size(); ++side)
        sides[side].remove_bridges(static_cast<int>(side), parts, probe);

    const bool clockwise = area > 0;
    std::vector<glm::vec2> places;
    for (const OutlinePart& part : parts) places.push_back(part.from);
    std::ranges::sort(places, comes_before);
    const auto number_of = [&](const glm::vec2& p) {
        return std::size_t(std::ranges::lower_bound(places, p, comes_before) - places.begin());
    };
    std::vector<RingPiece> pieces;  // backwards when the inside is on the left
    for (const auto& [from, to, leaves, arrives, side, first, edges] : parts)
        pieces.push_back(
            clockwise
                ? RingPiece{number_of(from), number_of(to), leaves, arrives}
                : RingPiece{
                      number_of(to), number_of(from), {arrives.to, arrives.from}, {leaves.to, leaves.from}});

    std::vector<std::vector<glm::vec2>> found;
    for (std::vector<std::size_t> ring : link_rings(pieces)) {
        if (!clockwise) std::ranges::reverse(ring);
        std::vector<glm::vec2> polygon;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const OutlinePart &before = parts[ring[i == 0 ? ring.size() - 1 : i - 1]], &part = parts[ring[i]];
            const bool straight = part.side >= 0 && part.side == before.side &&
                                  points_right(before.arrives) == points_right(part.leaves);
            if (!straight) polygon.push_back(part.from);
            for (std::size_t k = 1; k < part.edges; ++k) polygon.push_back(point(part.first_edge + k));
        }
        if (polygon.size() < 3) continue;
        note<PieceFound>(probe, polygon);
        found.push_back(std::move(polygon));
    }
    return found;
}

}  // namespace relevo::pipeline
