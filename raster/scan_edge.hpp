// A straight edge followed from row to row in whole numbers: what the scanline algorithms for triangles and
// polygons share.
//
// Source: textbook section 5.4 ("preferably with integer arithmetic only, as a line is rasterized").
//
// In row y the edge from (ax, ay) down to (bx, by) stands at  ax + (256 y + 128 - ay) dx / dy  subpixels.
// The first pixel whose centre lies at or right of that place, and how far right, is
//
//   x = ceil(N / run),   rest = x run - N,   run = 256 dy,   N = (ax - 128) dy + (256 y + 128 - ay) dx
//
// A row further down N grows by 256 dx: x by the quotient floor(dx / dy), and rest shrinks by 256 times the
// remainder; when rest falls below 0, x is one too small. Nothing is ever rounded, so an edge that two
// shapes share stands at the same place for both, from whichever row it is followed.
//
// Limits: coordinates up to +-2^23 subpixels (the machine's guard band), so |N| < 2^50.
#pragma once
#include <algorithm>
#include <cstdint>

#include "raster/pixel.hpp"
#include "raster/shape.hpp"

namespace relevo::raster {

inline constexpr std::int32_t largest_snapped = 1 << 23;

constexpr bool within_reach(const SnappedPoint& p) {
    return -largest_snapped <= p.x && p.x <= largest_snapped && -largest_snapped <= p.y &&
           p.y <= largest_snapped;
}

// The first row whose centres count as below this y. A centre at the same height is below it by the top-left
// rule (an area owns its top row), and above it by the book's (an area owns its bottom row).
constexpr int first_row(std::int32_t y, FillRule rule) {
    return (y + (rule == FillRule::TopLeft ? 127 : 128)) >> 8;
}

// The part of a box that shapes can reach. Its ends plus one still fit.
constexpr PixelBox reachable(const PixelBox& box) {
    constexpr int reach = (largest_snapped >> 8) + 1;
    return {std::max(box.x0, -reach), std::max(box.y0, -reach), std::min(box.x1, reach),
            std::min(box.y1, reach)};
}

struct ScanEdge {
    std::int64_t rest, rest_step;  // the centre of pixel x lies rest / run pixels right of the edge
    std::int64_t run;
    std::int32_t x, x_step;

    // The edge in row y. It must cross that row's centres: upper.y <= 256 y + 128 <= lower.y, not level.
    constexpr ScanEdge(const SnappedPoint& upper, const SnappedPoint& lower, int y)
        : rest(0), rest_step(0), run(0), x(0), x_step(0) {
        const std::int32_t dx = lower.x - upper.x, dy = lower.y - upper.y;
        const std::int64_t n =
            (std::int64_t{upper.x} - 128) * dy + (std::int64_t{y} * 256 + 128 - upper.y) * std::int64_t{dx};
        run = std::int64_t{dy} * 256;
        const std::int64_t quotient = n / run, remainder = n % run;  // towards zero
        x = static_cast<std::int32_t>(quotient) + (remainder > 0);
        rest = remainder > 0 ? run - remainder : -remainder;
        x_step = dx / dy - (dx % dy < 0);
        rest_step = (std::int64_t{dx} - std::int64_t{x_step} * dy) * 256;
    }
    constexpr ScanEdge() : rest(0), rest_step(0), run(1), x(0), x_step(0) {}

    constexpr void next_row() {
        rest -= rest_step;
        const std::int64_t below_zero = rest >> 63;  // -1 or 0
        rest += run & below_zero;
        x += x_step - static_cast<std::int32_t>(below_zero);
    }

    // For captions: where the edge stands, in pixels (whole numbers are centres).
    constexpr double place() const { return x - static_cast<double>(rest) / static_cast<double>(run); }
};

}  // namespace relevo::raster
