// The exact area of an ellipse in a pixel, by numerical integration in the angle: nothing is shared with
// raster/curve_coverage.hpp.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

namespace relevo::tests {

using Real = long double;

// The area of the ellipse in u0..u1 by v0..v1, both from the centre: Gauss-Legendre in the angle, cut where
// the arc crosses a side, so that every piece is smooth.
inline Real exact_area(Real a, Real b, Real u0, Real u1, Real v0, Real v1) {
    const Real low = std::max(v0, -b), high = std::min(v1, b);
    if (low >= high) return 0;
    // Convex: with its four corners inside, all of a square is; with its nearest point outside, nothing.
    const auto inside = [&](Real u, Real v) { return u * u / (a * a) + v * v / (b * b) <= 1; };
    if (inside(u0, v0) && inside(u0, v1) && inside(u1, v0) && inside(u1, v1)) return (u1 - u0) * (v1 - v0);
    if (!inside(std::clamp(Real(0), u0, u1), std::clamp(Real(0), v0, v1))) return 0;
    std::vector<Real> cuts{low, high};
    for (const Real u : {u0, u1})
        if (std::abs(u) < a) {
            const Real v = b / a * std::sqrt((a - u) * (a + u));
            for (const Real cut : {v, -v})
                if (cut > low && cut < high) cuts.push_back(cut);
        }
    std::sort(cuts.begin(), cuts.end());
    const Real node[] = {0.1488743389816312108848L, 0.4333953941292471907993L, 0.6794095682990244062343L,
                         0.8650633666889845107321L, 0.9739065285171717200780L};
    const Real weight[] = {0.2955242247147528701739L, 0.2692667193099963550912L, 0.2190863625159820439955L,
                           0.1494513491505805931458L, 0.0666713443086881375936L};
    Real sum = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        const auto angle = [&](Real v) { return std::asin(std::clamp(v / b, Real(-1), Real(1))); };
        const int parts = 3;
        const Real from = angle(cuts[i - 1]), step = (angle(cuts[i]) - from) / parts;
        for (int part = 0; part < parts; ++part)
            for (int k = 0; k < 5; ++k)
                for (const int sign : {-1, 1}) {
                    const Real t = from + step * (part + Real(0.5) + sign * node[k] / 2);
                    const Real x = a * std::cos(t);
                    sum += weight[k] * step / 2 * b * std::cos(t) *
                           std::max(Real(0), std::min(x, u1) - std::max(-x, u0));
                }
    }
    return sum;
}
inline Real exact_pixel(glm::dvec2 c, Real a, Real b, int x, int y) {
    const Real u = x - c.x, v = y - c.y;
    return exact_area(a, b, u - Real(0.5), u + Real(0.5), v - Real(0.5), v + Real(0.5));
}

}  // namespace relevo::tests
