// A mesh of triangles in world space as a surface for rays (Moller and Trumbore, "Fast, minimum storage
// ray/triangle intersection", Journal of Graphics Tools 1997).
//
// Front and back faces are hit alike. The normal is the mesh's, interpolated; where that is zero, the face's.
// Every triangle is tried for every ray: this is the rasterizer's judge, not its rival.
#pragma once
#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/mesh.hpp"
#include "relief/surface.hpp"

namespace relevo::relief {

struct MeshSurface {
    const pipeline::Mesh& mesh;  // borrowed; its object space is the world
    LinearRgb color{1, 1, 1};
};

inline std::optional<SurfaceHit> first_hit(const MeshSurface& surface, const Ray& ray) {
    const auto& [vertices, indices] = surface.mesh;
    std::optional<SurfaceHit> nearest;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const pipeline::Vertex* const v[3] = {&vertices[indices[i]], &vertices[indices[i + 1]],
                                              &vertices[indices[i + 2]]};
        const glm::dvec3 p0(v[0]->position.v), e1 = glm::dvec3(v[1]->position.v) - p0,
                                               e2 = glm::dvec3(v[2]->position.v) - p0;
        const glm::dvec3 across = glm::cross(ray.direction, e2), from = ray.origin - p0;
        const double volume = glm::dot(e1, across), b1 = glm::dot(from, across) / volume;
        const glm::dvec3 q = glm::cross(from, e1);
        const double b2 = glm::dot(ray.direction, q) / volume, t = glm::dot(e2, q) / volume;
        if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= 1)) continue;
        glm::dvec3 n = (1 - b1 - b2) * glm::dvec3(v[0]->normal.v) + b1 * glm::dvec3(v[1]->normal.v) +
                       b2 * glm::dvec3(v[2]->normal.v);
        if (glm::dot(n, n) == 0) n = glm::cross(e1, e2);
        keep_nearest(nearest, {t, n / std::sqrt(glm::dot(n, n)), surface.color}, ray);
    }
    return nearest;
}

}  // namespace relevo::relief
