// The test object `checker_cube`: a cube of side 1.1 round the origin, turned by 30 degrees about (1, 1, 0),
// checkered in squares of 1/8 of a side.
#pragma once
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "relief/surface.hpp"

namespace relevo::relief {

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
            keep_nearest(nearest,
                         {t, sign * cube.world_from_cube[axis],
                          checker_color((s + half) / CheckerCube::side, (r + half) / CheckerCube::side)},
                         ray);
        }
    return nearest;
}

}  // namespace relevo::relief
