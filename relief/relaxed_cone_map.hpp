// Relaxed cones (Policarpo and Oliveira, "Relaxed cone stepping for relief mapping", GPU Gems 3, 2007,
// chapter 18): wider than the safe cones of cone_step_map.hpp, so that a search needs fewer jumps.
//
// A relaxed cone may hold a bit of the relief, but no more of it than a ray down to the texel goes into once:
// for every other texel, the ray from above this texel to the other one's surface goes in there; where it
// comes out again, the cone must end. So a ray that has jumped is either still outside, or has gone in
// exactly once, and bisection finds where. The rays considered start over the texel's middle, so this is an
// approximation. Measured on `bumpy`, 64 x 64: 3.4 look-ups a ray in the place of 6.2 (10 degrees aside) and
// 3.3 of 9.4 (40 degrees); 0.6 and 2.5 % of the hits are another place than the first.
//
// The map is for a solid without end, read by nearest texels. It costs up to the square of the number of
// texels times the length of the rays: for small textures, once.
#pragma once
#include "relief/cone_step_map.hpp"

namespace relevo::relief {

namespace cone_detail {

// Horizontal way from the texel, in texels, over the height above its surface, at the point where the ray
// from over (x, y) that goes in at (i, j) comes out again: the widest cone that this ray allows.
inline double relaxed_limit(const ReliefSolid& solid, int x, int y, int i, int j) {
    const double dx = i - x, dy = j - y, way = std::sqrt(dx * dx + dy * dy);
    const double here = floor_of(solid, x, y), in = floor_of(solid, i, j);
    const double deeper = (in - solid.low) / way;  // z a texel of way
    for (double s = way + 0.5;; s += 0.5) {
        const int u = static_cast<int>(std::floor(x + 0.5 + dx / way * s));
        const int v = static_cast<int>(std::floor(y + 0.5 + dy / way * s));
        const double z = solid.low + deeper * s;
        if (z >= here || !solid.front.holds(u, v)) return widest_cone;
        if (floor_of(solid, u, v) > z) return s / (here - z);
    }
}

}  // namespace cone_detail

inline ConeStepMap make_relaxed_cone_map(const ReliefSolid& solid) {
    using namespace cone_detail;
    const int width = solid.front.width(), height = solid.front.height();
    ConeStepMap map(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double here = floor_of(solid, x, y);
            double cone = widest_cone;
            for (int r = 1; r < std::max(width, height) && r < cone * (here - solid.low); ++r)
                for_ring(x, y, r, width, height, [&](int i, int j) {
                    if (floor_of(solid, i, j) < here) cone = std::min(cone, relaxed_limit(solid, x, y, i, j));
                });
            map.at(x, y) = static_cast<Scalar>(cone);
        }
    return map;
}

// Jumps from cone to cone until the ray is inside, then `bisections` halvings.
template <class Probe = const pipeline::NoProbe>
std::optional<ReliefHit> find_by_relaxed_cones(const ReliefSolid& solid, const ConeStepMap& map,
                                               const ReliefRay& ray, int bisections, Probe&& probe = {}) {
    const SearchRange range = search_range(solid, ray);
    if (!(range.first <= range.last)) return {};
    const auto inside = [&](double z) {
        const glm::dvec2 p = ray.at(z);
        const bool found = solid.contains(p.x, p.y, z);
        pipeline::note<SolidLookedUp>(probe, p, z, found);
        return found;
    };
    const double slope = std::sqrt(glm::dot(ray.slope, ray.slope));
    double outside = range.first, z = range.first;
    while (!inside(z)) {
        if (z >= range.last) return {};
        const TexelWalk walk(ray, solid, z);
        outside = z;
        // at least out of this texel, or down to its surface
        const double front = solid.front.at(walk.x(), walk.y());
        const double least =
            front > z && front < walk.exit() ? front : walk.exit() + 1e-9 * (solid.high - solid.low);
        z = std::min(std::max(cone_detail::wall(solid, map, walk.x(), walk.y(), z, slope), least),
                     range.last);
    }
    for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (outside + z);
        (inside(middle) ? z : outside) = middle;
    }
    const glm::dvec2 p = ray.at(z);
    return ReliefHit{static_cast<int>(p.x), static_cast<int>(p.y), p.x, p.y, z};
}

}  // namespace relevo::relief
