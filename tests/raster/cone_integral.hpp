// The weight of a cone over a rectangle, numerically: the oracle of weighted line drawing.
#pragma once
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

namespace relevo::tests {

// The integral of a cone of radius 1 and volume 1 around the origin over u0..u1 by v0..v1: the slices along v
// by their formula, the sum over u by Gauss' rule between the places where a slice changes its kind. Right to
// about 1e-9.
inline double cone_over_rectangle(double u0, double u1, double v0, double v1) {
    const auto slice = [&](double u) {
        const double reach = std::sqrt(std::max(0.0, 1 - u * u));
        const double low = std::clamp(v0, -reach, reach), high = std::clamp(v1, -reach, reach);
        const auto primitive = [u](double v) {
            const double r = std::hypot(u, v);
            return v - (v * r + (u == 0 ? 0 : u * u * std::asinh(v / std::abs(u)))) / 2;
        };
        return 3 / std::numbers::pi * (primitive(high) - primitive(low));
    };
    std::vector<double> cuts{std::clamp(u0, -1.0, 1.0), std::clamp(u1, -1.0, 1.0)};
    const auto cut = [&](double u) {
        if (cuts[0] < u && u < cuts[1]) cuts.push_back(u);
    };
    cut(0);
    for (const double v : {v0, v1})
        if (std::abs(v) < 1) cut(std::sqrt(1 - v * v)), cut(-std::sqrt(1 - v * v));
    for (const double u : {-0.9, -0.5, 0.5, 0.9}) cut(u);
    std::sort(cuts.begin(), cuts.end());
    double sum = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i)
        sum += boost::math::quadrature::gauss<double, 20>::integrate(slice, cuts[i - 1], cuts[i]);
    return sum;
}

// What a pixel at (x, y) sees of the line from (ax, ay) to (bx, by).
inline double cone_over_line(double x, double y, double ax, double ay, double bx, double by, double width) {
    const double length = std::hypot(bx - ax, by - ay), cosine = (bx - ax) / length,
                 sine = (by - ay) / length;
    const double along = (x - ax) * cosine + (y - ay) * sine, across = (y - ay) * cosine - (x - ax) * sine;
    return cone_over_rectangle(-width / 2 - across, width / 2 - across, -along, length - along);
}

}  // namespace relevo::tests
