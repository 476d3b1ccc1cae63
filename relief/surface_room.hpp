// The test object `room`, seen from inside: a box round the origin, 2 wide, 1.2 high and 2.4 deep, every wall
// checkered in squares of 1/8 in colours of its own, with a few balls in it. No ball comes nearer to the
// vertical axis than 0.5.
#pragma once
#include <array>

#include "relief/surface_spheres.hpp"

namespace relevo::relief {

struct Room {
    glm::dvec3 half{1, 0.6, 1.2};
    Spheres balls{{{{0.62, -0.42, -0.35}, 0.18},
                   {{-0.55, 0.1, -0.6}, 0.15},
                   {{-0.7, -0.35, 0.5}, 0.22},
                   {{0.15, 0.25, 0.75}, 0.2},
                   {{0.75, 0.2, 0.4}, 0.12}}};
};

namespace room_detail {

// -x +x -y +y -z +z: what the light squares are tinted with
inline constexpr std::array<std::array<double, 3>, 6> tint = {
    {{1, 0.6, 0.5}, {0.55, 0.8, 1}, {0.75, 0.7, 0.6}, {1, 1, 1}, {0.7, 1, 0.6}, {1, 0.9, 0.5}}};

inline LinearRgb wall_color(std::size_t wall, double s, double t) {
    const LinearRgb c = checker_color(s, t);
    return {Scalar(double{c.r} * tint[wall][0]), Scalar(double{c.g} * tint[wall][1]),
            Scalar(double{c.b} * tint[wall][2])};
}

}  // namespace room_detail

inline std::optional<SurfaceHit> first_hit(const Room& room, const Ray& ray) {
    if (!is_finite(ray.origin) || !is_finite(ray.direction)) return {};
    std::optional<SurfaceHit> nearest = first_hit(room.balls, ray);
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            const int i = (axis + 1) % 3, j = (axis + 2) % 3;
            const double t = (sign * room.half[axis] - ray.origin[axis]) / ray.direction[axis];
            const glm::dvec3 p = ray.origin + t * ray.direction;
            if (!(std::fabs(p[i]) <= room.half[i] && std::fabs(p[j]) <= room.half[j])) continue;
            glm::dvec3 inwards(0);
            inwards[axis] = -sign;
            const std::size_t wall = std::size_t(2 * axis + (sign > 0));
            keep_nearest(nearest, {t, inwards, room_detail::wall_color(wall, p[i], p[j])}, ray);
        }
    return nearest;
}

}  // namespace relevo::relief
