// Whether the outline of a polygon crosses or touches itself, which clip_shape_greiner_hormann.hpp does not
// take: a point of an outline knows one pair of edges of the other polygon, and where an outline meets itself
// there are two.
#pragma once
#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "pipeline/clip_plane.hpp"

namespace relevo::pipeline {

// Whether two edges have a point in common, ends included. Decided exactly.
inline bool edges_meet(const ClipLine& e, const ClipLine& f) {
    for (const int axis : {0, 1}) {
        const auto [e_low, e_high] = std::minmax(e.from[axis], e.to[axis]);
        const auto [f_low, f_high] = std::minmax(f.from[axis], f.to[axis]);
        if (e_high < f_low || f_high < e_low) return false;
    }
    return side_of(e, f.from) * side_of(e, f.to) <= 0 && side_of(f, e.from) * side_of(f, e.to) <= 0;
}

// The first two edges that meet anywhere but in the corner they share, or that fold back on one another, each
// by the number of the corner it begins at. Coordinates are finite.
//
// Corners on a straight edge and repeated corners do no harm. A polygon with all corners on one line has no
// outline to cross.
// Time: one step for each corner of a convex polygon, n n / 2 pairs of edges for others.
inline std::optional<std::pair<std::size_t, std::size_t>> crossing_of(std::span<const glm::vec2> ring) {
    const auto convex = convex_window(ring);
    if (convex || convex.error() == Refusal::NoArea) return std::nullopt;
    struct Edge {
        std::size_t first;
        ClipLine line;
    };
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const ClipLine line{ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]};
        if (line.from != line.to) edges.push_back({i, line});
    }
    const auto folded = [](const ClipLine& before, const ClipLine& after) {
        return points_right(before) != points_right(after) && side_of(before, after.to) == 0;
    };
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const ClipLine &e = edges[i].line, &f = edges[j].line;
            const bool closes = i == 0 && j + 1 == edges.size();
            const bool wrong = j == i + 1 ? folded(e, f) : closes ? folded(f, e) : edges_meet(e, f);
            if (wrong) return std::pair(edges[i].first, edges[j].first);
        }
    return std::nullopt;
}

}  // namespace relevo::pipeline
