// The test object `plane_step`: the plane z = 0 over [-1, 1]^2, raised to z = step where x > 0.1, with the
// riser between them. Checkered in squares of 1/8; red lines, 1/32 wide, run straight across the step at y =
// -0.5, 0 and 0.5, and two at a slant, y = x/2 +- 1/4.
#pragma once
#include <cmath>

#include "relief/surface.hpp"

namespace relevo::relief {

struct PlaneStep {
    double step = 0.5;  // > 0
    static constexpr double edge = 0.1;
};

namespace plane_step_detail {

inline LinearRgb plate_color(double x, double y) {
    constexpr double half_width = 1.0 / 64;
    const double slant = y - x / 2;
    for (const double distance : {y, y - 0.5, y + 0.5, slant - 0.25, slant + 0.25})
        if (std::fabs(distance) <= half_width) return {Scalar(0.8), Scalar(0.05), Scalar(0.05)};
    return checker_color(x, y);
}

}  // namespace plane_step_detail

inline std::optional<SurfaceHit> first_hit(const PlaneStep& plane, const Ray& ray) {
    if (!is_finite(ray.direction)) return {};
    using plane_step_detail::plate_color;
    const glm::dvec3 o = ray.origin, d = ray.direction;
    std::optional<SurfaceHit> nearest;
    const auto within = [](double c) { return -1 <= c && c <= 1; };
    const auto plate = [&](double z, bool raised) {
        const double t = (z - o.z) / d.z, x = o.x + t * d.x, y = o.y + t * d.y;
        if (within(x) && within(y) && (x > PlaneStep::edge) == raised)
            keep_nearest(nearest, {t, {0, 0, 1}, plate_color(x, y)}, ray);
    };
    plate(0, false), plate(plane.step, true);
    const double t = (PlaneStep::edge - o.x) / d.x, y = o.y + t * d.y, z = o.z + t * d.z;
    if (within(y) && 0 <= z && z <= plane.step)
        keep_nearest(nearest, {t, {-1, 0, 0}, plate_color(PlaneStep::edge, y)}, ray);
    return nearest;
}

}  // namespace relevo::relief
