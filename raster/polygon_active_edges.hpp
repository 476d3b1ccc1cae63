// Any polygon row by row: an edge table, and the list of the edges that cross the row.
//
// Source: textbook section 5.4 (rows, half-open ends), figures 5.8 and 5.9; Wylie, Romney, Evans and Erdahl
// 1967 (edges sorted by row); Foley, van Dam, Feiner and Hughes 1990, section 3.6 (the two lists).
//
// The table holds the edges sorted by the first row whose centres they cross; level edges cross none. From
// row to row the list of active edges drops those that end, takes in those that begin, moves each along its
// slope in whole numbers (scan_edge.hpp) and puts them in order from left to right. Walking along the row,
// each edge adds its winding (+1 downwards, -1 upwards); a pixel is inside when the sum is not 0 (non-zero
// rule) or odd (even-odd rule).
//
// A centre on an edge belongs to the area on its right, one on a level edge to the area below it
// (FillRule::TopLeft) or above it (FillRule::Book): triangles are covered bit for bit as by
// triangle_scan.hpp, and polygons that fill the plane cover every centre once.
//
// Rings are closed by themselves; several rings make one polygon. Repeated points, edges over one another
// and rings that cross themselves are welcome. Fewer than three points, or no area, cover nothing. A point
// beyond +-2^23 subpixels (32768 pixels) refuses the whole polygon: nothing is drawn.
//
// Cost: O(n log n) for n points, and O(c log c) for the c crossings of a row inside the box; edges above,
// below or right of the box cost nothing more. Memory is taken twice, never in a row.
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "pipeline/probe.hpp"
#include "raster/scan_edge.hpp"

namespace relevo::raster {

// An edge of the table. Edges are numbered in the order of the points, ring after ring.
struct TableEdge {
    SnappedPoint upper, lower;
    int first, end;  // the rows it crosses: first <= y < end, cut at the box
    int number;
    int winding;  // +1: the outline runs down here; -1: up
};

struct ActiveEdge {
    ScanEdge at;
    int end, number, winding;
};

// The table, sorted by first row.
struct EdgeTableBuilt {
    std::span<const TableEdge> edges;
};
struct EdgeEnters {
    int y;
    const TableEdge& edge;
};
struct EdgeLeaves {
    int y;  // the first row that it does not cross
    const ActiveEdge& edge;
};
// The edges that cross row y, from left to right.
struct RowCrossed {
    int y;
    std::span<const ActiveEdge> edges;
};
struct PolygonSpan {
    int y, x0, x1;
    int winding;  // of its first pixel
};

// From left to right. The order is nearly right from the row above, so that insertion is quick; where many
// edges cross one another it gives up and sorts.
inline void sort_active(std::vector<ActiveEdge>& edges) {
    const auto before = [](const ActiveEdge& a, const ActiveEdge& b) {
        if (a.at.x != b.at.x) return a.at.x < b.at.x;
        const Int128 left = Int128{a.at.rest} * b.at.run, right = Int128{b.at.rest} * a.at.run;
        return left > right || (left == right && a.number < b.number);
    };
    std::size_t moves = 16 * edges.size();
    for (std::size_t i = 1; i < edges.size(); ++i) {
        if (!before(edges[i], edges[i - 1])) continue;
        const ActiveEdge moving = edges[i];
        std::size_t k = i;
        for (; k > 0 && before(moving, edges[k - 1]) && moves > 0; --k, --moves) edges[k] = edges[k - 1];
        edges[k] = moving;
        if (moves == 0) return std::sort(edges.begin(), edges.end(), before);
    }
}

// Calls span(y, x0, x1) for pixels x0 <= x < x1, from top to bottom and left to right, no pixel twice.
template <class SpanSink, class Probe = pipeline::NoProbe>
void polygon_active_edges(std::span<const std::vector<SnappedPoint>> rings, InsideRule inside, FillRule rule,
                          const PixelBox& box, SpanSink&& span, Probe&& probe = {}) {
    const PixelBox seen = reachable(box);
    std::size_t points = 0;
    for (const std::vector<SnappedPoint>& ring : rings) {
        points += ring.size();
        if (!std::all_of(ring.begin(), ring.end(), within_reach)) return;
    }
    if (seen.empty()) return;

    std::vector<TableEdge> table;
    table.reserve(points);
    int number = 0;
    for (const std::vector<SnappedPoint>& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i, ++number) {
            const SnappedPoint &from = ring[i], &to = ring[i + 1 < ring.size() ? i + 1 : 0];
            const bool down = from.y < to.y;
            const SnappedPoint &upper = down ? from : to, &lower = down ? to : from;
            const int first = std::max(first_row(upper.y, rule), seen.y0),
                      end = std::min(first_row(lower.y, rule), seen.y1 + 1);
            // no centre of the box lies at or right of an edge that begins right of its last centre
            if (first < end && std::min(upper.x, lower.x) <= seen.x1 * 256 + 128)
                table.push_back({upper, lower, first, end, number, down ? 1 : -1});
        }
    std::sort(table.begin(), table.end(), [](const TableEdge& a, const TableEdge& b) {
        return a.first < b.first || (a.first == b.first && a.number < b.number);
    });
    pipeline::note<EdgeTableBuilt>(probe, std::span<const TableEdge>(table));

    std::vector<ActiveEdge> active;
    std::size_t next = 0;
    for (int y = seen.y0; next < table.size() || !active.empty(); ++y) {
        if (active.empty()) y = table[next].first;
        for (; next < table.size() && table[next].first == y; ++next) {
            const TableEdge& edge = table[next];
            pipeline::note<EdgeEnters>(probe, y, edge);
            active.push_back({ScanEdge(edge.upper, edge.lower, y), edge.end, edge.number, edge.winding});
        }
        sort_active(active);
        pipeline::note<RowCrossed>(probe, y, std::span<const ActiveEdge>(active));

        const int mask = inside == InsideRule::EvenOdd ? 1 : -1;
        int winding = 0, x0 = 0, winding_there = 0;
        for (const ActiveEdge& edge : active) {
            const bool was_inside = (winding & mask) != 0;
            winding += edge.winding;
            const bool is_inside = (winding & mask) != 0;
            if (!was_inside && is_inside) x0 = std::max(edge.at.x, seen.x0), winding_there = winding;
            if (was_inside && !is_inside) {
                const int x1 = std::min(edge.at.x, seen.x1 + 1);
                if (x0 >= x1) continue;
                pipeline::note<PolygonSpan>(probe, y, x0, x1, winding_there);
                span(y, x0, x1);
            }
        }
        if ((winding & mask) != 0 && x0 <= seen.x1) {  // what closes the span lies right of the box
            pipeline::note<PolygonSpan>(probe, y, x0, seen.x1 + 1, winding_there);
            span(y, x0, seen.x1 + 1);
        }

        std::size_t kept = 0;
        for (ActiveEdge& edge : active) {
            if (edge.end == y + 1) {
                pipeline::note<EdgeLeaves>(probe, y + 1, edge);
                continue;
            }
            edge.at.next_row();
            active[kept++] = edge;
        }
        active.resize(kept);
    }
}

}  // namespace relevo::raster
