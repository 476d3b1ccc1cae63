// Pixels of the picture plane as the two-dimensional algorithms see them.
//
// In a lesson a pixel *is* its centre: whole coordinates are pixel centres, x to the right, y down. (The
// window of the three-dimensional pipeline has the same centre at +0.5.) Coverage counts in 1/65536 of a
// pixel's area.
#pragma once
#include <cmath>
#include <cstdint>

#include "pipeline/scalar.hpp"

namespace relevo::raster {

__extension__ using Int128 = __int128;

struct Pixel {
    std::int32_t x = 0, y = 0;
    friend constexpr bool operator==(const Pixel&, const Pixel&) = default;
};

// The pixels x0..x1 by y0..y1, both ends included; empty when x0 > x1 or y0 > y1.
struct PixelBox {
    int x0, y0, x1, y1;
    constexpr bool empty() const { return x0 > x1 || y0 > y1; }
    constexpr bool holds(std::int64_t x, std::int64_t y) const {
        return x0 <= x && x <= x1 && y0 <= y && y <= y1;
    }
};

// Pixels x0 <= x < x1 of a row.
struct Span {
    int x0, x1;
};

// A point on the grid of 1/256 pixel on which areas are exact, as triangle_edge.hpp has it: pixel (i, j)
// covers [256 i, 256 i + 256), so the place (x, y) of a lesson is (256 x + 128, 256 y + 128), ties to even.
// Lessons snap places up to largest_place, so that differences and products of two stay exact in 64 bits.
struct SnappedPoint {
    std::int32_t x = 0, y = 0;
    friend constexpr bool operator==(const SnappedPoint&, const SnappedPoint&) = default;
};
inline constexpr int largest_place = 32767;
inline SnappedPoint snapped(double x, double y) {
    return {static_cast<std::int32_t>(std::lrint(256 * x + 128)),
            static_cast<std::int32_t>(std::lrint(256 * y + 128))};
}

inline constexpr int full_coverage = 65536;

}  // namespace relevo::raster
