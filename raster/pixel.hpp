// Pixels of the picture plane as the two-dimensional algorithms see them.
//
// In a lesson a pixel *is* its centre: whole coordinates are pixel centres, x to the right, y down. (The
// window of the three-dimensional pipeline has the same centre at +0.5.) Coverage counts in 1/65536 of a
// pixel's area.
#pragma once
#include <cstdint>

namespace relevo::raster {

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

inline constexpr int full_coverage = 65536;

}  // namespace relevo::raster
