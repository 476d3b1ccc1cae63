// Surfaces that a ray can be cast at exactly, with a colour for each of their points: objects whose picture
// is known from every side.
//
// Each is a struct of numbers in a header of its own, with an overload
//   std::optional<SurfaceHit> first_hit(const TheSurface&, const Ray&)
// that gives the nearest point of the surface on the ray, entering or leaving. All of it is computed in
// double. A ray that is not finite or has no direction hits nothing.
#pragma once
#include <cmath>
#include <concepts>
#include <glm/vec3.hpp>
#include <optional>

#include "pipeline/color.hpp"
#include "pipeline/elementary.hpp"

namespace relevo::relief {

using pipeline::LinearRgb;
using pipeline::Scalar;

struct Ray {
    glm::dvec3 origin, direction;  // world; the direction may have any length but zero
    double from = 0;               // the ray is origin + t direction with t >= from
};

struct SurfaceHit {
    double t;           // >= from
    glm::dvec3 normal;  // of length 1, outwards
    LinearRgb color;    // unlit
};

inline bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <class Surface>
concept RayCastable = requires(const Surface& surface, const Ray& ray) {
    { first_hit(surface, ray) } -> std::same_as<std::optional<SurfaceHit>>;
};

inline void keep_nearest(std::optional<SurfaceHit>& nearest, const SurfaceHit& hit, const Ray& ray) {
    if (hit.t >= ray.from && (!nearest || hit.t < nearest->t)) nearest = hit;
}

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

}  // namespace relevo::relief
