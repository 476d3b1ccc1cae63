// What the tests of circles and ellipses share: pixels gathered, and the laws that an outline keeps.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "raster/pixel.hpp"
#include "tests/support/drawing.hpp"

namespace relevo::tests {

using raster::Pixel;
using raster::PixelBox;
using Pixels = std::vector<Pixel>;

inline constexpr PixelBox everywhere{-2147483647, -2147483647, 2147483646, 2147483646};

inline bool before(const Pixel& p, const Pixel& q) { return p.x != q.x ? p.x < q.x : p.y > q.y; }

// Sorted by x, then by falling y. `draw` is called with a plot.
template <class Draw>
Pixels gather(Draw&& draw) {
    Pixels pixels;
    draw([&](int x, int y) { pixels.push_back({x, y}); });
    std::sort(pixels.begin(), pixels.end(), before);
    return pixels;
}

inline bool has_twins(const Pixels& sorted) {
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

inline Pixels inside(const Pixels& pixels, const PixelBox& box) {
    Pixels some;
    for (const Pixel& p : pixels)
        if (box.holds(p.x, p.y)) some.push_back(p);
    return some;
}

template <class Map>
Pixels mapped(Pixels pixels, Map&& map) {
    for (Pixel& p : pixels) p = map(p);
    std::sort(pixels.begin(), pixels.end(), before);
    return pixels;
}

// An outline around (0, 0) is closed when it is symmetric and its quarter is a chain of neighbours (sides or
// corners) from (0, b) to (a, 0).
inline std::string fault_of_outline(const Pixels& sorted, int a, int b) {
    if (has_twins(sorted)) return "a pixel twice";
    if (mapped(sorted, [](Pixel p) { return Pixel{-p.x, p.y}; }) != sorted) return "left is not right";
    if (mapped(sorted, [](Pixel p) { return Pixel{p.x, -p.y}; }) != sorted) return "top is not bottom";
    Pixels quarter;
    for (const Pixel& p : sorted)
        if (p.x >= 0 && p.y >= 0) quarter.push_back(p);
    if (quarter.empty() || !(quarter.front() == Pixel{0, b})) return "does not start at (0, b)";
    if (!(quarter.back() == Pixel{a, 0})) return "does not end at (a, 0)";
    for (std::size_t i = 1; i < quarter.size(); ++i) {
        const Pixel p = quarter[i - 1], q = quarter[i];
        if (q.x - p.x > 1 || p.y - q.y > 1 || q.y > p.y)
            return "a gap after " + std::to_string(p.x) + ", " + std::to_string(p.y);
    }
    return "";
}

inline Drawing drawing_of(const Pixels& pixels, const PixelBox& view) {
    Drawing rows(std::size_t(view.y1 - view.y0 + 1), std::string(std::size_t(view.x1 - view.x0 + 1), '.'));
    for (const Pixel& p : pixels)
        if (view.holds(p.x, p.y)) rows[std::size_t(p.y - view.y0)][std::size_t(p.x - view.x0)] = '#';
    return rows;
}

}  // namespace relevo::tests
