// An analytic surface somewhere else: turned, scaled and moved as a model is (Clua 2004, 8.8: relief
// textures of whatever can be drawn).
//
// The ray is brought to the surface's own space; a map of points takes lines to lines and keeps the t of
// each point, so the hit needs no correction but its normal.
#pragma once
#include <variant>

#include "relief/surface_checker_cube.hpp"
#include "relief/surface_plane_step.hpp"
#include "relief/surface_spheres.hpp"

namespace relevo::relief {

using AnalyticSurface = std::variant<Spheres, PlaneStep, CheckerCube>;

// A ball that holds all of a surface or mesh. World units.
struct BoundingBall {
    glm::dvec3 centre{0};
    double radius = 0;
};

// Round the middle of the surface's box, in its own space.
inline BoundingBall bounding_ball(const AnalyticSurface& surface) {
    struct Bound {
        BoundingBall operator()(const Spheres& spheres) const {
            double radius = 0;
            for (const Sphere& s : spheres.sphere)
                radius = std::max(radius, std::sqrt(glm::dot(s.centre, s.centre)) + s.radius);
            return {glm::dvec3(0), radius};
        }
        BoundingBall operator()(const PlaneStep& plane) const {
            return {{0, 0, plane.step / 2}, std::sqrt(2 + plane.step * plane.step / 4)};
        }
        BoundingBall operator()(const CheckerCube&) const {
            return {glm::dvec3(0), CheckerCube::side * std::sqrt(0.75)};
        }
    };
    return std::visit(Bound{}, surface);
}

struct PlacedSurface {
    AnalyticSurface surface;
    glm::dmat4 world_from_surface, surface_from_world;
};
// The map has an inverse and no projection.
inline PlacedSurface placed(AnalyticSurface surface, const glm::dmat4& world_from_surface) {
    return {std::move(surface), world_from_surface, glm::inverse(world_from_surface)};
}

inline std::optional<SurfaceHit> first_hit(const PlacedSurface& placed, const Ray& ray) {
    const glm::dmat4& surface_from_world = placed.surface_from_world;
    const Ray local{glm::dvec3(surface_from_world * glm::dvec4(ray.origin, 1)),
                    glm::dvec3(surface_from_world * glm::dvec4(ray.direction, 0)), ray.from};
    auto hit = std::visit([&](const auto& surface) { return first_hit(surface, local); }, placed.surface);
    if (!hit) return hit;
    // normals go by the inverse transposed
    const glm::dvec3 n = glm::transpose(glm::dmat3(surface_from_world)) * hit->normal;
    hit->normal = n / std::sqrt(glm::dot(n, n));
    return hit;
}

inline BoundingBall bounding_ball(const PlacedSurface& placed) {
    const BoundingBall own = bounding_ball(placed.surface);
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 column(placed.world_from_surface[k]);
        longest = std::max(longest, glm::dot(column, column));
    }
    return {glm::dvec3(placed.world_from_surface * glm::dvec4(own.centre, 1)),
            own.radius * std::sqrt(longest)};
}

}  // namespace relevo::relief
