// Outlines of any size, row by row: the edges that cross a row, and a row of pixels in which they leave their
// shares.
//
// What an edge adds to a pixel reaches all pixels to its right, too. So the row holds differences: each edge
// writes where its share changes, and the sum from the left is the winding number of the pixel, averaged over
// its area, in 1/65536. Only the touched parts of the row are walked; between them the sum is constant, which
// makes one run.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "raster/pixel.hpp"
#include "raster/shape.hpp"

namespace relevo::raster {

// The covered part of a pixel from its average winding number, both in 1/65536. Exact where the winding
// numbers in the pixel are 0 and 1, or 0 and -1; by the even-odd rule where they are any two neighbours.
// Where outlines cross or lie upon each other inside one pixel, only the average is known: the rule is then
// applied to the average.
inline int covered_part(std::int64_t winding, InsideRule inside) {
    const std::int64_t size = std::abs(winding);
    if (inside == InsideRule::NonZero) return static_cast<int>(std::min<std::int64_t>(size, full_coverage));
    const std::int64_t turn = size % (2 * full_coverage);
    return static_cast<int>(std::min(turn, 2 * full_coverage - turn));
}

// Calls visit(row, edges) for the rows first..last that edges cross, with the edges as a span of pointers. An
// Edge has first_row(), last_row(), and start(row), which is called once, for the first row that is visited.
template <class Edge, class Visit>
void for_each_row(std::vector<Edge>& edges, int first, int last, Visit&& visit) {
    std::erase_if(edges, [&](const Edge& e) { return e.last_row() < first || e.first_row() > last; });
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return a.first_row() < b.first_row(); });
    std::vector<Edge*> active;
    std::size_t next = 0;
    for (int row = first; row <= last; ++row) {
        if (active.empty()) {
            if (next == edges.size()) return;
            row = std::max(row, edges[next].first_row());
        }
        for (; next < edges.size() && edges[next].first_row() <= row; ++next) {
            edges[next].start(row);
            active.push_back(&edges[next]);
        }
        visit(row, std::span<Edge* const>(active));
        std::erase_if(active, [row](const Edge* e) { return e->last_row() <= row; });
    }
}

class CoverageRow {
  public:
    // For the columns first..last.
    CoverageRow(int first, int last)
        : first_(first), last_(last), change_(static_cast<std::size_t>(last - first) + 2, 0) {}

    // Shares of the columns from..to are share(column); left of them it is 0, right of them `beyond`.
    template <class Share>
    void add(int from, int to, int sign, std::int64_t beyond, Share&& share) {
        if (from > last_) return;
        from = std::max(from, first_);
        const int end = std::min(to, last_);
        std::int64_t before = 0;
        for (int column = from; column <= end; ++column) {
            const std::int64_t here = share(column);
            at(column) += sign * (here - before);
            before = here;
        }
        const int after = std::max(end + 1, first_);
        at(after) += sign * (beyond - before);  // one place beyond the row takes what no pixel wants
        touched_.push_back({from, after});
    }

    // Calls run(x0, x1, winding) for all columns that an edge touched or that have a winding number, x0 < x1,
    // and empties the row.
    template <class Run>
    void sweep(Run&& run) {
        std::sort(touched_.begin(), touched_.end(), [](Span a, Span b) { return a.x0 < b.x0; });
        std::int64_t winding = 0;
        int column = first_;
        for (const Span& part : touched_) {
            if (column < part.x0) {
                if (winding != 0) run(column, part.x0, winding);
                column = part.x0;
            }
            for (; column <= std::min(part.x1, last_); ++column) {
                winding += at(column);
                at(column) = 0;
                run(column, column + 1, winding);
            }
        }
        if (winding != 0 && column <= last_) run(column, last_ + 1, winding);
        at(last_ + 1) = 0;
        touched_.clear();
    }

  private:
    std::int64_t& at(int column) { return change_[static_cast<std::size_t>(column - first_)]; }

    int first_, last_;
    std::vector<std::int64_t> change_;
    std::vector<Span> touched_;
};

}  // namespace relevo::raster
