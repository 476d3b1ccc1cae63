// Polygons of a mesh file: their normal, and their triangles.
#pragma once
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "pipeline/scalar.hpp"

namespace relevo::io {

// The normal of a polygon, as long as twice its area: the sum of (p_i - p_0) x (p_i+1 - p_0), right also for
// a polygon that is not convex or not quite flat (M. Newell's sum with the origin at p_0). Differences and
// products of float32 coordinates cannot overflow in double.
template <class PositionOf>  // std::size_t -> glm::dvec3
glm::dvec3 area_vector(std::size_t corners, const PositionOf& position) {
    glm::dvec3 sum(0);
    const glm::dvec3 origin = position(0);
    for (std::size_t i = 1; i + 1 < corners; ++i)
        sum += glm::cross(position(i) - origin, position(i + 1) - origin);
    return sum;
}

// Of length 1; zero for the zero vector.
inline pipeline::Vec3 unit(const glm::dvec3& v) {
    const double length = std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
    return length > 0 ? pipeline::Vec3(v / length) : pipeline::Vec3(0);
}

// The triangles (0, i, i+1) of a convex polygon.
inline void append_fan(std::span<const std::uint32_t> polygon, std::vector<std::uint32_t>& indices) {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        indices.insert(indices.end(), {polygon[0], polygon[i], polygon[i + 1]});
}

}  // namespace relevo::io
