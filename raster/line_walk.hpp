// The walk along a line between two pixels, and the part of it that lies in a box.
//
// A line is walked along its longer side, the major coordinate: x for flat lines, y for steep ones; the
// diagonal counts as flat. The walk starts at the end with the smaller major coordinate, whichever of the two
// ends was given first, so that a line from A to B and one from B to A are the same pixels.
//
// After k steps the true line has moved k minor / major across, and the nearest pixel is
//
//     offset(k) = ceil((2 k minor - major) / (2 major))         half way between two pixels: the nearer to
//                                                               the start of the walk
// so the pixels of the whole line are known without walking it. The line enters a row at the first step with
// offset(k) >= j, which is k = floor(major (2 j - 1) / (2 minor)) + 1: two divisions say which steps lie in a
// box. They are the steps of the *uncut* line. (Cutting the ends first and walking between the cut ends gives
// other pixels: the classic trap.)
//
// Any two pixels are fine: spans reach 2^32 - 1, products 2^66, so divisions are done in 128 bits.
#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>

#include "raster/pixel.hpp"

namespace relevo::raster {

struct LineWalk {
    Pixel from, to;             // `from` has the smaller major coordinate
    bool steep;                 // the major coordinate is y
    int side;                   // the way of the minor coordinate: 1 or -1
    std::int64_t major, minor;  // spans, 0 <= minor <= major < 2^32
};

constexpr LineWalk line_walk(Pixel a, Pixel b) {
    const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
    const std::int64_t width = dx < 0 ? -dx : dx, height = dy < 0 ? -dy : dy;
    const bool steep = height > width;
    const bool backwards = steep ? dy < 0 : dx < 0;
    const int side = ((steep ? dx : dy) < 0) != backwards ? -1 : 1;
    if (backwards) std::swap(a, b);
    return {a, b, steep, side, steep ? height : width, steep ? width : height};
}

constexpr Int128 floor_divide(Int128 a, Int128 b) {  // b > 0
    const Int128 quotient = a / b;
    return quotient * b > a ? quotient - 1 : quotient;
}

// How many pixels the line has moved across after `step` steps, 0..minor.
constexpr std::int64_t line_offset(const LineWalk& walk, std::int64_t step) {
    if (step == 0) return 0;
    return static_cast<std::int64_t>(
        -floor_divide(walk.major - 2 * Int128{step} * walk.minor, 2 * walk.major));
}

// The first step with line_offset >= offset; 1 <= offset <= minor.
constexpr std::int64_t first_step(const LineWalk& walk, std::int64_t offset) {
    return static_cast<std::int64_t>(floor_divide(Int128{walk.major} * (2 * offset - 1), 2 * walk.minor)) + 1;
}

struct LineSteps {
    std::int64_t first, last;  // both included
    constexpr bool empty() const { return first > last; }
};

// The steps whose pixels lie in the box.
constexpr LineSteps steps_in(const LineWalk& walk, const PixelBox& box) {
    const auto& [from, to, steep, side, major, minor] = walk;
    if (box.holds(from.x, from.y) && box.holds(to.x, to.y)) return {0, major};
    if (box.empty()) return {0, -1};
    const std::int64_t start = steep ? from.y : from.x, start_across = steep ? from.x : from.y;
    LineSteps steps{std::max<std::int64_t>((steep ? box.y0 : box.x0) - start, 0),
                    std::min((steep ? box.y1 : box.x1) - start, major)};
    const std::int64_t low = (steep ? box.x0 : box.y0) - start_across,
                       high = (steep ? box.x1 : box.y1) - start_across;
    const std::int64_t least = side > 0 ? low : -high, most = side > 0 ? high : -low;  // offsets in the box
    if (least > minor || most < 0) return {0, -1};
    if (least > 0) steps.first = std::max(steps.first, first_step(walk, least));
    if (most < minor) steps.last = std::min(steps.last, first_step(walk, most + 1) - 1);
    return steps;
}

// The pixel after `step` steps with this offset.
constexpr Pixel line_pixel(const LineWalk& walk, std::int64_t step, std::int64_t offset) {
    const std::int64_t x = walk.from.x + (walk.steep ? walk.side * offset : step);
    const std::int64_t y = walk.from.y + (walk.steep ? step : walk.side * offset);
    return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
}

// A neighbour or twice a pixel: room for any of them.
struct GridPoint {
    std::int64_t x, y;
    friend constexpr bool operator==(const GridPoint&, const GridPoint&) = default;
};

}  // namespace relevo::raster
