// The inverse mapping by visiting every texel under the ray, one after the other (Amanatides and Woo, "A fast
// voxel traversal algorithm", 1987): exact for the solid of pillars, whatever is thin, and the judge of all
// other searches. A ray of L texels costs L look-ups: the "natural" number of slices.
#pragma once
#include <cmath>
#include <optional>

#include "pipeline/probe.hpp"
#include "relief/relief_solid.hpp"

namespace relevo::relief {

// A ray on its way from texel to texel.
class TexelWalk {
  public:
    TexelWalk(const ReliefRay& ray, const ReliefSolid& solid, double z) : ray_(ray), z_(z) {
        const glm::dvec2 p = ray.at(z);
        const int size[2] = {solid.front.width(), solid.front.height()};
        for (int k = 0; k < 2; ++k) {
            const double last = size[k] - 1;
            cell_[k] = static_cast<int>(std::fmin(std::fmax(std::floor(p[k]), 0.0), last));
        }
        find_exits();
    }
    int x() const { return cell_[0]; }
    int y() const { return cell_[1]; }
    double z() const { return z_; }                                            // where the ray is now
    double exit() const { return exit_[0] < exit_[1] ? exit_[0] : exit_[1]; }  // where it leaves the texel

    // Goes to the next texel.
    void next() {
        const int k = exit_[0] < exit_[1] ? 0 : 1;
        z_ = std::fmax(z_, exit_[k]);
        cell_[k] += ray_.slope[k] > 0 ? 1 : -1;
        find_exit(k);
    }

  private:
    void find_exit(int k) {
        const double border = cell_[k] + (ray_.slope[k] > 0 ? 1 : 0);
        exit_[k] = ray_.slope[k] == 0 ? std::numeric_limits<double>::infinity()
                                      : (border - ray_.entry[k]) / ray_.slope[k];
    }
    void find_exits() { find_exit(0), find_exit(1); }

    ReliefRay ray_;
    double z_;
    int cell_[2];
    double exit_[2];
};

// The hit in the texel that the ray crosses from z to `exit`, if there is one: on the pillar's top, or on its
// side when the ray comes in below the top.
inline std::optional<ReliefHit> hit_in_texel(const ReliefSolid& solid, const ReliefRay& ray, int x, int y,
                                             double z, double exit) {
    const double front = solid.front.at(x, y), back = solid.back.at(x, y);
    const double hit = std::fmax(front, z);
    if (!(hit <= exit && hit <= back && hit <= solid.high)) return {};
    const glm::dvec2 p = ray.at(hit);
    return ReliefHit{x, y, p.x, p.y, hit};
}

template <class Probe = const pipeline::NoProbe>
std::optional<ReliefHit> find_by_texels(const ReliefSolid& solid, const ReliefRay& ray, Probe&& probe = {}) {
    const SearchRange range = search_range(solid, ray);
    if (!(range.first <= range.last)) return {};
    for (TexelWalk walk(ray, solid, range.first); solid.front.holds(walk.x(), walk.y()); walk.next()) {
        const auto hit = hit_in_texel(solid, ray, walk.x(), walk.y(), walk.z(), walk.exit());
        pipeline::note<SolidLookedUp>(probe, ray.at(walk.z()), walk.z(), hit.has_value());
        if (hit) return hit;
        if (!(walk.exit() < range.last)) break;
    }
    return {};
}

}  // namespace relevo::relief
