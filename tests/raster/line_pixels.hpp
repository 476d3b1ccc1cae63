// Pixels of lines in tests.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <ostream>
#include <vector>

#include "raster/pixel.hpp"
#include "tests/support/drawing.hpp"

namespace relevo::raster {
inline void PrintTo(const Pixel& p, std::ostream* out) { *out << "(" << p.x << "," << p.y << ")"; }
}  // namespace relevo::raster

namespace relevo::tests {

using raster::Pixel;
using raster::PixelBox;
using Pixels = std::vector<Pixel>;

inline constexpr PixelBox all_pixels{std::numeric_limits<int>::min(), std::numeric_limits<int>::min(),
                                     std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};

inline Pixels within(const Pixels& pixels, const PixelBox& box) {
    Pixels kept;
    for (const Pixel& p : pixels)
        if (box.holds(p.x, p.y)) kept.push_back(p);
    return kept;
}

// Each pixel is one of the eight neighbours of the one before.
inline bool connected(const Pixels& pixels) {
    for (std::size_t i = 1; i < pixels.size(); ++i) {
        const int dx = std::abs(pixels[i].x - pixels[i - 1].x), dy = std::abs(pixels[i].y - pixels[i - 1].y);
        if (std::max(dx, dy) != 1) return false;
    }
    return true;
}

inline Drawing drawing_of_pixels(const Pixels& pixels, int width, int height) {
    Drawing rows(std::size_t(height), std::string(std::size_t(width), '.'));
    for (const Pixel& p : pixels)
        if (p.x >= 0 && p.y >= 0 && p.x < width && p.y < height)
            rows[std::size_t(p.y)][std::size_t(p.x)] = '#';
    return rows;
}

}  // namespace relevo::tests
