// The inverse mapping by slices (Clua 2004, 6.5, after Policarpo 2003), and its refinement by bisection
// (linear and binary search: Policarpo, Oliveira and Comba, "Real-time relief mapping on arbitrary polygonal
// surfaces", 2005).
//
// The depths between the nearest and the deepest texel are cut into N slices; the first slice at which the
// ray is inside the solid is the hit. The depth found is too large by half a slice on average, so the error
// falls as 1/N while the cost grows as N. Bisection between that slice and the one before, where the ray was
// outside, halves the error at every step: 32 slices and 8 bisections are as fine as 8192 slices. But what is
// thinner than a slice can be missed by either.
#pragma once
#include <optional>

#include "pipeline/probe.hpp"
#include "relief/relief_solid.hpp"

namespace relevo::relief {

struct SliceSettings {
    int slices = 128;    // >= 1
    int bisections = 0;  // >= 0
};

template <class Probe = const pipeline::NoProbe>
std::optional<ReliefHit> find_by_slices(const ReliefSolid& solid, const ReliefRay& ray,
                                        const SliceSettings& settings, Probe&& probe = {}) {
    const auto inside = [&](double z) {
        const glm::dvec2 p = ray.at(z);
        const bool found = solid.contains(p.x, p.y, z);
        pipeline::note<SolidLookedUp>(probe, p, z, found);
        return found;
    };
    const SearchRange range = search_range(solid, ray);
    if (!(range.first <= range.last)) return {};
    // Slice k lies at low + k (high - low) / N; those before and behind the square need no look.
    const double step = (solid.high - solid.low) / settings.slices;
    const auto slice = [&](double k) { return k == settings.slices ? solid.high : solid.low + k * step; };
    const double begin = step > 0 ? std::max(std::floor((range.first - solid.low) / step), 0.0) : 0;
    for (double k = begin; k <= settings.slices; ++k) {
        double z = slice(k);
        if (!inside(z)) {
            if (z > range.last) break;
            continue;
        }
        double before = k > 0 ? slice(k - 1) : z;
        for (int i = 0; i < settings.bisections; ++i) {
            const double middle = 0.5 * (before + z);
            (inside(middle) ? z : before) = middle;
        }
        const glm::dvec2 p = ray.at(z);
        return ReliefHit{static_cast<int>(p.x), static_cast<int>(p.y), p.x, p.y, z};
    }
    return {};
}

}  // namespace relevo::relief
