// The exact area of a polygon inside a pixel's square, in rational numbers: the outline is cut at the four
// sides one after the other, and what is left is summed up by the shoelace formula. Nothing is shared with
// raster/area_coverage.hpp, which never cuts a polygon.
#pragma once
#include <boost/multiprecision/cpp_int.hpp>
#include <span>
#include <vector>

namespace relevo::tests::exact {

using Rational = boost::multiprecision::cpp_rational;

struct RationalPoint {
    Rational x, y;
};
using RationalRing = std::vector<RationalPoint>;

// What lies on the side of (nx, ny) . p <= limit.
inline RationalRing cut(const RationalRing& ring, int nx, int ny, const Rational& limit) {
    RationalRing kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RationalPoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const Rational out_a = nx * a.x + ny * a.y - limit, out_b = nx * b.x + ny * b.y - limit;
        if (out_a <= 0) kept.push_back(a);
        if ((out_a < 0 && out_b > 0) || (out_a > 0 && out_b < 0)) {
            const Rational t = out_a / (out_a - out_b);
            kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
    }
    return kept;
}

// Positive for an outline that turns clockwise on the page (y down); what is wound twice counts twice.
inline Rational signed_area(const RationalRing& ring) {
    Rational twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RationalPoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

inline Rational area_in_pixel(const RationalRing& ring, int x, int y) {
    const Rational half(1, 2);
    return signed_area(
        cut(cut(cut(cut(ring, 1, 0, x + half), -1, 0, half - x), 0, 1, y + half), 0, -1, half - y));
}

// Of corners that doubles hold exactly (here: multiples of 1/65536).
template <class Points>
RationalRing rational(const Points& points) {
    RationalRing ring;
    for (const auto& p : points) ring.push_back({Rational(p.x), Rational(p.y)});
    return ring;
}

}  // namespace relevo::tests::exact
