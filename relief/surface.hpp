// Surfaces that a ray can be cast at exactly, with a colour for each of their points: the test objects whose
// truth is known.
//
// Each is a struct of numbers and an overload
//   std::optional<SurfaceHit> first_hit(const TheSurface&, const Ray&)
// that gives the nearest point in front of the ray's origin (t > 0), entering or leaving. All of it is
// computed in double; a ray that is not finite or has no direction hits nothing.
//
//   Spheres       the union of balls: `sphere`, `bumpy` and `complex` of the test scenes
//   PlaneStep     two plates and the riser between them, checkered, with straight lines drawn across
//   CheckerCube   a cube, turned, checkered
//   MeshSurface   triangles (Moller and Trumbore 1997), any mesh
#pragma once
#include <array>
#include <cmath>
#include <concepts>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "pipeline/color.hpp"
#include "pipeline/elementary.hpp"
#include "pipeline/mesh.hpp"

namespace relevo::relief {

using pipeline::LinearRgb;
using pipeline::Scalar;

struct Ray {
    glm::dvec3 origin, direction;  // world; the direction may have any length but zero
};

struct SurfaceHit {
    double t;           // origin + t direction, t > 0
    glm::dvec3 normal;  // of length 1, outwards
    LinearRgb color;    // unlit
};

template <class Surface>
concept RayCastable = requires(const Surface& surface, const Ray& ray) {
    { first_hit(surface, ray) } -> std::same_as<std::optional<SurfaceHit>>;
};

// ------------------------------------------------------------------------------------------- colours
// A colour that tells every point from its neighbours, smooth so that interpolating it is fair:
// (w(9x + 3y), w(9y + 2z), w(9z + 3x)) with w(t) = 1/2 + 1/2 sin t, in linear light.
inline LinearRgb wave_color(glm::dvec3 p) {
    const auto w = [](double t) {
        return static_cast<Scalar>(0.5 + 0.5 * pipeline::sin(pipeline::Degrees{t * (180 / pipeline::pi)}));
    };
    return {w(9 * p.x + 3 * p.y), w(9 * p.y + 2 * p.z), w(9 * p.z + 3 * p.x)};
}

// Squares of side 1/8, light where the sum of their numbers is even.
inline LinearRgb checker_color(double s, double t) {
    const bool light = std::fmod(std::fabs(std::floor(8 * s) + std::floor(8 * t)), 2) == 0;
    return light ? LinearRgb{Scalar(0.9), Scalar(0.85), Scalar(0.7)}
                 : LinearRgb{Scalar(0.1), Scalar(0.15), Scalar(0.3)};
}

// ------------------------------------------------------------------------------------------- spheres
struct Sphere {
    glm::dvec3 centre;
    double radius;  // > 0
};
struct Spheres {
    std::vector<Sphere> sphere;
};

// Where the ray enters the ball, or leaves it when it starts inside. With b = o.d and the foot of the centre
// on the ray, the discriminant r^2 - |o - (b/a) d|^2 has no cancellation between large squares (Hearn and
// Baker; Haines et al., Ray Tracing Gems, chapter 7).
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
    if (near > 0) return near;
    if (far > 0) return far;
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

// ------------------------------------------------------------------------------------------- plane with step
// The plane z = 0 over [-1, 1]^2, raised to z = step where x > 0.1, with the riser between them. Checkered in
// squares of 1/8; red lines, 1/32 wide, run straight across the step at y = -0.5, 0 and 0.5, and two at a
// slant, y = x/2 +- 1/4.
struct PlaneStep {
    double step = 0.5;  // > 0
    static constexpr double edge = 0.1;
};

namespace surface_detail {

inline LinearRgb plate_color(double x, double y) {
    constexpr double half_width = 1.0 / 64;
    const double slant = y - x / 2;
    for (const double distance : {y, y - 0.5, y + 0.5, slant - 0.25, slant + 0.25})
        if (std::fabs(distance) <= half_width) return {Scalar(0.8), Scalar(0.05), Scalar(0.05)};
    return checker_color(x, y);
}

inline void keep_nearest(std::optional<SurfaceHit>& nearest, const SurfaceHit& hit) {
    if (hit.t > 0 && (!nearest || hit.t < nearest->t)) nearest = hit;
}

}  // namespace surface_detail

inline std::optional<SurfaceHit> first_hit(const PlaneStep& plane, const Ray& ray) {
    using namespace surface_detail;
    const auto [o, d] = ray;
    std::optional<SurfaceHit> nearest;
    const auto within = [](double c) { return -1 <= c && c <= 1; };
    const auto plate = [&](double z, bool raised) {
        const double t = (z - o.z) / d.z, x = o.x + t * d.x, y = o.y + t * d.y;
        if (within(x) && within(y) && (x > PlaneStep::edge) == raised)
            keep_nearest(nearest, {t, {0, 0, 1}, plate_color(x, y)});
    };
    plate(0, false), plate(plane.step, true);
    const double t = (PlaneStep::edge - o.x) / d.x, y = o.y + t * d.y, z = o.z + t * d.z;
    if (within(y) && 0 <= z && z <= plane.step)
        keep_nearest(nearest, {t, {-1, 0, 0}, plate_color(PlaneStep::edge, y)});
    return nearest;
}

// ------------------------------------------------------------------------------------------- cube
// A cube of side 1.1 round the origin, turned by 30 degrees about (1, 1, 0), checkered in squares of 1/8 of a
// side.
struct CheckerCube {
    static constexpr double side = 1.1;
    // Columns: the cube's own axes in the world. Rodrigues' formula for the axis (1, 1, 0) / sqrt 2, with
    // cos 30 = sqrt(3) / 2 and sin 30 = 1 / 2.
    glm::dmat3 world_from_cube = [] {
        const double c = std::sqrt(3.0) / 2, k = std::sqrt(0.5), s = 0.5 * k, m = (1 - c) / 2;
        return glm::dmat3{{c + m, m, -s}, {m, c + m, s}, {s, -s, c}};
    }();
};

inline std::optional<SurfaceHit> first_hit(const CheckerCube& cube, const Ray& ray) {
    const glm::dmat3 cube_from_world = glm::transpose(cube.world_from_cube);
    const glm::dvec3 o = cube_from_world * ray.origin, d = cube_from_world * ray.direction;
    constexpr double half = CheckerCube::side / 2;
    std::optional<SurfaceHit> nearest;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            const int i = (axis + 1) % 3, j = (axis + 2) % 3;
            const double t = (sign * half - o[axis]) / d[axis];
            const double s = o[i] + t * d[i], r = o[j] + t * d[j];
            if (!(std::fabs(s) <= half && std::fabs(r) <= half)) continue;
            surface_detail::keep_nearest(
                nearest, {t, sign * cube.world_from_cube[axis],
                          checker_color((s + half) / CheckerCube::side, (r + half) / CheckerCube::side)});
        }
    return nearest;
}

}  // namespace relevo::relief
