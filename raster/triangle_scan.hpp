// A triangle row by row between its long edge and the two others.
//
// Source: textbook section 5.4, algorithm 5.2, figures 5.8 to 5.10.
//
// The long edge spans all rows of the triangle; edge 2 leads from the top corner to the middle one and edge 3
// on to the bottom, both on the other side of it. So a row lies between the long edge and edge 2, further
// down between the long edge and edge 3. Each edge knows the first pixel at or right of it (scan_edge.hpp):
// the row is closed on the left and open on the right, and so is the whole in rows (fig. 5.8). Neighbours
// that share an edge or a corner therefore share no pixel and leave none out (fig. 5.9).
//
//   FillRule::TopLeft  closed above, open below: bit for bit the coverage of triangle_edge.hpp
//   FillRule::Book     open above, closed below, as fig. 5.8 has it
//
// Corners in any order. A triangle without area covers nothing; one with a corner beyond +-2^23 subpixels
// (32768 pixels) is refused and draws nothing, too. Rows outside of the box cost nothing.
#pragma once
#include <utility>

#include "pipeline/probe.hpp"
#include "raster/scan_edge.hpp"

namespace relevo::raster {

enum class TriangleEdge { Long, Two, Three };

// The corners from top to bottom (at equal height from left to right).
struct TriangleClassified {
    SnappedPoint top, middle, bottom;
    bool long_is_left;
};

// An edge starts to bound the row y.
struct TriangleEdgeStarted {
    TriangleEdge edge;
    int y;
    const ScanEdge& at;
};

// A row between two edges; x0 >= x1 when no centre of the box lies between them.
struct TriangleRow {
    int y;
    TriangleEdge left, right;
    const ScanEdge &left_at, &right_at;
    int x0, x1;
};

// Calls span(y, x0, x1) for each row with pixels x0 <= x < x1, from top to bottom.
template <class SpanSink, class Probe = pipeline::NoProbe>
constexpr void triangle_scan(const SnappedPoint (&corners)[3], FillRule rule, const PixelBox& box,
                             SpanSink&& span, Probe&& probe = {}) {
    SnappedPoint top = corners[0], middle = corners[1], bottom = corners[2];
    if (!within_reach(top) || !within_reach(middle) || !within_reach(bottom)) return;
    const auto above = [](const SnappedPoint& p, const SnappedPoint& q) {
        return p.y < q.y || (p.y == q.y && p.x < q.x);
    };
    if (above(middle, top)) std::swap(top, middle);
    if (above(bottom, middle)) std::swap(middle, bottom);
    if (above(middle, top)) std::swap(top, middle);

    const std::int64_t side = std::int64_t{bottom.x - top.x} * (middle.y - top.y) -
                              std::int64_t{bottom.y - top.y} * (middle.x - top.x);
    if (side == 0) return;
    const bool long_is_left = side < 0;
    pipeline::note<TriangleClassified>(probe, top, middle, bottom, long_is_left);

    const PixelBox seen = reachable(box);
    int y = std::max(first_row(top.y, rule), seen.y0);
    const int turn = std::min(first_row(middle.y, rule), seen.y1 + 1),
              end = std::min(first_row(bottom.y, rule), seen.y1 + 1);
    if (y >= end || seen.x0 > seen.x1) return;

    ScanEdge longest(top, bottom, y);
    pipeline::note<TriangleEdgeStarted>(probe, TriangleEdge::Long, y, longest);
    const auto between = [&](TriangleEdge number, const SnappedPoint& from, const SnappedPoint& to,
                             int last) {
        if (y >= last) return;
        const ScanEdge other(from, to, y);
        pipeline::note<TriangleEdgeStarted>(probe, number, y, other);
        ScanEdge left = long_is_left ? longest : other, right = long_is_left ? other : longest;
        for (; y < last; ++y) {
            const int x0 = std::max(left.x, seen.x0), x1 = std::min(right.x, seen.x1 + 1);
            pipeline::note<TriangleRow>(probe, y, long_is_left ? TriangleEdge::Long : number,
                                        long_is_left ? number : TriangleEdge::Long, left, right, x0, x1);
            if (x0 < x1) span(y, x0, x1);
            left.next_row();
            right.next_row();
        }
        longest = long_is_left ? left : right;
    };
    between(TriangleEdge::Two, top, middle, turn);
    between(TriangleEdge::Three, middle, bottom, end);
}

}  // namespace relevo::raster
