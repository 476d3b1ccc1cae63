// A union of balls: the test objects `sphere`, `bumpy` and `complex`.
//
// The point where a ray enters a ball, or leaves it when it starts inside: with the foot of the centre on the
// ray, the discriminant r^2 - |foot|^2 is no difference of large squares (Haines et al., "Precision
// improvements for ray/sphere intersection", Ray Tracing Gems 2019). Of several balls the nearest point
// counts; colour is wave_color.
#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "relief/surface.hpp"

namespace relevo::relief {

struct Sphere {
    glm::dvec3 centre;
    double radius;  // > 0
};
struct Spheres {
    std::vector<Sphere> sphere;
};

inline std::optional<double> first_hit(const Sphere& sphere, const Ray& ray) {
    const glm::dvec3 o = ray.origin - sphere.centre;
    const double a = glm::dot(ray.direction, ray.direction), b = -glm::dot(o, ray.direction);
    const glm::dvec3 foot = o + (b / a) * ray.direction;
    const double rest = sphere.radius * sphere.radius - glm::dot(foot, foot);
    if (!(rest >= 0)) return {};
    const double c = glm::dot(o, o) - sphere.radius * sphere.radius;
    const double root = std::sqrt(a * rest);
    const double q = b + (b < 0 ? -root : root);
    const double t0 = c / q, t1 = q / a;  // q = 0 only when both are 0 or not a number
    const double near = std::fmin(t0, t1), far = std::fmax(t0, t1);
    if (near >= ray.from) return near;
    if (far >= ray.from) return far;
    return {};
}

inline std::optional<SurfaceHit> first_hit(const Spheres& spheres, const Ray& ray) {
    double nearest = std::numeric_limits<double>::infinity();
    const Sphere* hit = nullptr;
    for (const Sphere& sphere : spheres.sphere)
        if (const auto t = first_hit(sphere, ray); t && *t < nearest) nearest = *t, hit = &sphere;
    if (!hit) return {};
    const glm::dvec3 p = ray.origin + nearest * ray.direction;
    return SurfaceHit{nearest, (p - hit->centre) / hit->radius, wave_color(p)};
}

}  // namespace relevo::relief
