// Cones over the texels of a relief, which say how far a search may jump (Dummer, "Cone step mapping", 2006).
//
// Over each texel stands a cone, its point on the texel's surface, that opens towards the viewer and holds
// nothing of the relief. A ray inside may jump to the cone's wall. `width` is how many texels wide (radius)
// the cone is a unit of z above its point; here distances are measured between the texels' squares, so that
// the jump is safe from anywhere in the texel, and search by cones finds exactly what inverse_texels.hpp
// finds.
//
// Making the map costs up to the square of the number of texels; it does not depend on the viewer.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "relief/inverse_texels.hpp"

namespace relevo::relief {

// What stands for "as wide as you like".
inline constexpr Scalar widest_cone = Scalar(1e9);

// The width of each texel's cone: texels a unit of z, >= 0.
using ConeStepMap = Image<Scalar>;

namespace cone_detail {

// Empty texels have their surface at the deepest z: nothing lies deeper.
inline double floor_of(const ReliefSolid& solid, int x, int y) {
    return std::fmin(double{solid.front.row(y)[x]}, solid.high);
}
// Between the squares of two texels that are dx and dy apart.
inline double gap_between(int dx, int dy) {
    const double gx = std::max(std::abs(dx) - 1, 0), gy = std::max(std::abs(dy) - 1, 0);
    return std::sqrt(gx * gx + gy * gy);
}

// Calls visit(i, j) for the texels of the ring of squares `radius` around (x, y) that lie in the picture.
template <class Visit>
void for_ring(int x, int y, int radius, int width, int height, Visit&& visit) {
    for (int j = std::max(y - radius, 0); j <= std::min(y + radius, height - 1); ++j) {
        const bool border = j == y - radius || j == y + radius;
        for (int i = std::max(x - radius, 0); i <= std::min(x + radius, width - 1);) {
            if (border || i == x - radius || i == x + radius) visit(i, j);
            i = border || i == x + radius ? i + 1 : std::max(i + 1, std::min(x + radius, width));
        }
    }
}

// Where a ray at z over (x, y) meets the wall of the texel's cone: slope dz = width (surface - z - dz).
// Behind the surface there is no cone, and the ray stays where it is.
inline double wall(const ReliefSolid& solid, const ConeStepMap& map, int x, int y, double z, double slope) {
    const double above = floor_of(solid, x, y) - z, cone = map.row(y)[x];
    return above > 0 ? z + cone * above / (slope + cone) : z;
}

}  // namespace cone_detail

inline ConeStepMap make_cone_step_map(const ReliefSolid& solid) {
    using namespace cone_detail;
    const int width = solid.front.width(), height = solid.front.height();
    ConeStepMap map(width, height);
    const double range = solid.high - solid.low;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double here = floor_of(solid, x, y);
            double cone = widest_cone;
            // A ring farther than the cone's own wall is at the height of the nearest texel cannot narrow it.
            for (int r = 1; r < std::max(width, height) && r - 1 < cone * (here - solid.low); ++r)
                for_ring(x, y, r, width, height, [&](int i, int j) {
                    const double above = here - floor_of(solid, i, j);
                    if (above > 0) cone = std::min(cone, gap_between(i - x, j - y) / above);
                });
            map.at(x, y) = static_cast<Scalar>(cone * (range > 0 ? 1 - 1e-6 : 1));
        }
    return map;
}

// The same hit as find_by_texels, for a solid without end or with one.
template <class Probe = const pipeline::NoProbe>
std::optional<ReliefHit> find_by_cones(const ReliefSolid& solid, const ConeStepMap& map, const ReliefRay& ray,
                                       Probe&& probe = {}) {
    const SearchRange range = search_range(solid, ray);
    if (!(range.first <= range.last)) return {};
    const double slope = std::sqrt(glm::dot(ray.slope, ray.slope));  // texels a unit of z
    TexelWalk walk(ray, solid, range.first);
    while (solid.front.holds(walk.x(), walk.y())) {
        const int x = walk.x(), y = walk.y();
        const auto hit = hit_in_texel(solid, ray, x, y, walk.z(), walk.exit());
        pipeline::note<SolidLookedUp>(probe, ray.at(walk.z()), walk.z(), hit.has_value());
        if (hit) return hit;
        if (!(walk.exit() < range.last)) return {};
        const double wall = cone_detail::wall(solid, map, x, y, walk.z(), slope);
        if (wall > walk.exit() && wall < range.last)
            walk = TexelWalk(ray, solid, wall);
        else
            walk.next();
    }
    return {};
}

}  // namespace relevo::relief
