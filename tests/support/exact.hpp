// Which pixels a polygon covers, exactly, written from the definition of the top-left rule.
//
// The rule is a sample point that is moved from the pixel's centre to the right by an infinitesimal e, and
// down by e^2: a centre on a left edge then lies inside, on a right edge outside, and on a horizontal edge it
// depends on whether the inside is below (a top edge) or above. So a centre is covered when an odd number of
// edges crosses the row at y + e^2 at or left of it. No edge function, no corner order, no winding, and any
// polygon will do: nothing here is shared with raster/triangle_edge.hpp.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>

namespace relevo::tests::exact {

__extension__ typedef __int128 Int128;

struct Site {  // 1/256 pixel, y down
    std::int64_t x, y;
    friend bool operator==(const Site&, const Site&) = default;
};
using Triangle = std::array<Site, 3>;

constexpr Site centre(int x, int y) { return {256 * std::int64_t{x} + 128, 256 * std::int64_t{y} + 128}; }

// Whether the edge a b crosses the row e^2 below y.
constexpr bool crosses(Site a, Site b, std::int64_t y) { return (a.y <= y) != (b.y <= y); }

// The crossing of an edge with a row, as a fraction with a positive denominator.
struct Fraction {
    Int128 numerator, denominator;
};
constexpr Fraction crossing(Site a, Site b, std::int64_t y) {
    if (a.y > b.y) std::swap(a, b);
    return {Int128(a.x) * (b.y - a.y) + Int128(y - a.y) * (b.x - a.x), Int128(b.y - a.y)};
}

inline bool covers(std::span<const Site> polygon, Site p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Site a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        if (!crosses(a, b, p.y)) continue;
        const Fraction x = crossing(a, b, p.y);
        if (x.numerator <= p.x * x.denominator) inside = !inside;
    }
    return inside;
}

// The pixels first <= x < end of row y that a triangle covers, in a picture without borders.
struct Row {
    std::int64_t first, end;
    bool empty() const { return first >= end; }
};
inline Row covered_row(const Triangle& t, int y) {
    std::int64_t found[2] = {0, 0};
    int n = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Site a = t[i], b = t[(i + 1) % 3];
        const std::int64_t row = centre(0, y).y;
        if (!crosses(a, b, row)) continue;
        // the first centre at or right of the crossing: ceil((x - 128) / 256)
        const Fraction x = crossing(a, b, row);
        const Int128 top = x.numerator - 128 * x.denominator, bottom = 256 * x.denominator;
        const Int128 quotient = top / bottom;
        found[n++] = static_cast<std::int64_t>(quotient + (quotient * bottom < top ? 1 : 0));
    }
    return {std::min(found[0], found[1]), std::max(found[0], found[1])};
}

}  // namespace relevo::tests::exact
