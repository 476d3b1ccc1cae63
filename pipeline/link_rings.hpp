// Links directed pieces of outline into rings, as the last step of clipping a polygon into several.
//
// Every piece goes from one point to another, and as many pieces arrive at each point as leave it. The inside
// of a ring is on the right-hand side of its pieces, as seen in the picture. Where several pieces leave a
// point, a ring goes on with the one that turns most sharply to its inside, so rings that touch in a point
// are separate (Weiler and Atherton 1977 walk in the same way).
#pragma once
#include <algorithm>
#include <numeric>

#include "pipeline/clip_plane.hpp"

namespace relevo::pipeline {

struct RingPiece {
    std::size_t from, to;      // numbers of points
    ClipLine leaves, arrives;  // the directions in which the piece begins and ends
};

// Whether a ring that arrives in this direction should rather go on with b than with c. Exact; straight back
// comes last.
inline bool turns_sooner(const ClipLine& arrives, const ClipLine& b, const ClipLine& c) {
    const auto turn = [](const ClipLine& u, const ClipLine& v) {
        return sign_of_cross(u.from, u.to, v.from, v.to);
    };
    const auto sector = [&](const ClipLine& leaves) {  // to the right, straight on, to the left, back
        const int right = turn(arrives, leaves);
        if (right != 0) return right > 0 ? 0 : 2;
        return points_right(arrives) == points_right(leaves) ? 1 : 3;
    };
    const int sector_b = sector(b), sector_c = sector(c);
    return sector_b != sector_c ? sector_b < sector_c : turn(c, b) > 0;
}

// Rings as lists of indices of `pieces`. Each piece is used once; what does not close is left out. Time
// n log n for few pieces a point.
inline std::vector<std::vector<std::size_t>> link_rings(std::span<const RingPiece> pieces) {
    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return pieces[i].from; });
    std::vector<char> used(pieces.size(), 0);
    std::vector<std::vector<std::size_t>> rings;
    for (std::size_t start = 0; start < pieces.size(); ++start) {
        if (used[start]) continue;
        std::vector<std::size_t> ring;
        const std::size_t none = pieces.size();
        std::size_t at = start;
        do {
            used[at] = 1;
            ring.push_back(at);
            std::size_t next = none;
            const auto starts_at = [&](std::size_t i) { return pieces[i].from; };
            auto leaving = std::ranges::lower_bound(order, pieces[at].to, {}, starts_at);
            for (; leaving != order.end() && starts_at(*leaving) == pieces[at].to; ++leaving)
                if ((*leaving == start || !used[*leaving]) &&
                    (next == none ||
                     turns_sooner(pieces[at].arrives, pieces[*leaving].leaves, pieces[next].leaves)))
                    next = *leaving;
            at = next;
        } while (at != start && at != none);
        if (at == start) rings.push_back(std::move(ring));
    }
    return rings;
}

}  // namespace relevo::pipeline
