// Areas of clipped polygons in rational numbers, and polygons to clip.
#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "pipeline/elementary.hpp"
#include "tests/pipeline/clip_oracle.hpp"

namespace relevo::tests::exact {

using Ring = std::vector<RationalPoint>;
using Points = std::vector<glm::vec2>;

inline Points corners(const ClipBox& b) { return {b.low, {b.high.x, b.low.y}, b.high, {b.low.x, b.high.y}}; }

// Convex polygons only.
inline Ring clipped(Ring ring, const RationalHalf& half) {
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RationalPoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const Rational at_a = half.at(a), at_b = half.at(b);
        if (at_a >= 0) kept.push_back(a);
        if (at_a * at_b < 0) {
            const Rational t = at_a / (at_a - at_b);
            kept.push_back({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t});
        }
    }
    return kept;
}

// A polygon is the sum of the triangles that its edges make with its first corner, each with a sign. So the
// area of what two polygons share is a sum over pairs of triangles, which are convex. Points that a polygon
// winds round twice count twice. Twice the area, positive when both wind in the same sense.
inline Rational twice_common_area(const Points& p, const Points& q) {
    Rational sum = 0;
    for (std::size_t j = 1; j + 1 < q.size(); ++j) {
        const Points window{q[0], q[j], q[j + 1]};
        const Rational window_area = twice_area(window);
        if (window_area == 0) continue;
        const auto halves = halves_of(window);
        for (std::size_t i = 1; i + 1 < p.size(); ++i) {
            Ring triangle{rational(p[0]), rational(p[i]), rational(p[i + 1])};
            for (const RationalHalf& half : halves) triangle = clipped(triangle, half);
            sum += window_area.sign() * twice_area(triangle);
        }
    }
    return sum;
}

inline Rational twice_area_of_all(const std::vector<Points>& rings) {
    Rational sum = 0;
    for (const Points& ring : rings) sum += twice_area(ring);
    return sum;
}

// How far twice the area of rings can be off when each coordinate is off by half a unit in the last place.
inline double area_slack(const std::vector<Points>& rings) {
    double slack = 0;
    for (const Points& ring : rings) {
        double reach = 0, length = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 a(ring[i]), b(ring[(i + 1) % ring.size()]);
            reach = std::max({reach, std::abs(a.x), std::abs(a.y)});
            length += std::abs(b.x - a.x) + std::abs(b.y - a.y);
        }
        slack += 2 * length * (reach * 0x1p-24 + 0x1p-149) * 1.01;
    }
    return slack;
}

}  // namespace relevo::tests::exact

namespace relevo::tests::hard {

using Points = std::vector<glm::vec2>;

// Around (0, 0), with corners on multiples of 1/grid; simple, and mostly concave.
inline Points star(Random& r, int points, double radius, double grid) {
    std::vector<std::pair<double, glm::vec2>> found;
    for (int i = 0; i < points; ++i) {
        const double degrees = 360.0 * (i + 0.8 * r.unit()) / points, far = radius * r.between(0.2, 1);
        const auto x = std::nearbyint(grid * far * pipeline::cos(pipeline::Degrees{degrees})) / grid,
                   y = std::nearbyint(grid * far * pipeline::sin(pipeline::Degrees{degrees})) / grid;
        found.push_back({degrees, {x, y}});
    }
    // Rounding may have moved corners past one another: keep those that still go round, exactly.
    Points polygon;
    const auto turns = [](const glm::vec2& a, const glm::vec2& b) {
        return double{a.x} * b.y - double{a.y} * b.x > 0;
    };
    for (const auto& [degrees, p] : found)
        if (polygon.empty() ? p != glm::vec2(0, 0) : turns(polygon.back(), p)) polygon.push_back(p);
    while (polygon.size() > 2 && !turns(polygon.back(), polygon.front())) polygon.pop_back();
    if (r.coin()) std::ranges::reverse(polygon);
    return polygon;
}

// Any corners at all: it crosses itself as often as not.
inline Points tangle(Random& r, int points, int reach) {
    Points polygon;
    for (int i = 0; i < points; ++i) polygon.emplace_back(whole(r, -reach, reach), whole(r, -reach, reach));
    return polygon;
}

// Teeth that hang into the box 0..4 teeth - 1 by 0..6 from above: fig. 4.9 many times.
inline Points comb(int teeth) {
    Points polygon{{0, -3}, {static_cast<float>(4 * teeth - 2), -3}};
    for (int i = teeth - 1; i >= 0; --i) {
        const auto x = static_cast<float>(4 * i);
        polygon.insert(polygon.end(), {{x + 2, 4}, {x, 4}});
        if (i > 0) polygon.insert(polygon.end(), {{x, -1}, {x - 2, -1}});
    }
    return polygon;
}

}  // namespace relevo::tests::hard
