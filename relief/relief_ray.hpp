// The line of sight of a viewer's pixel as a line in the relief texture: where the inverse mapping searches
// (Oliveira 2000; Clua 2004, 6-1, with k2 in its second line; Policarpo, Oliveira and Comba 2005).
//
//     (u, v)(z) = (u_i, v_i) + z s (k3 u_i - k1, k3 v_i - k2)
//
// (u_i, v_i) is where the line meets the source's plane. z is the depth of the texture counted from the
// plane: the displacement (s = 1) of an orthographic source, 1 - disparity (s = -1) of a perspective one.
// Both take straight lines of the world to straight lines, so one search serves both.
#pragma once
#include <optional>

#include "relief/view_image.hpp"
#include "relief/warp.hpp"
#include "relief/warp_3d.hpp"

namespace relevo::relief {

struct ReliefRay {
    glm::dvec2 entry, slope;  // texels, texels per unit of z
    glm::dvec2 at(double z) const { return entry + z * slope; }
};

// What the texture stores, counted from the plane inwards; and back.
inline double inward_depth(Projection projection, Scalar stored) {
    return projection == Projection::Orthographic ? double{stored} : 1 - double{stored};
}
inline glm::dvec3 inward_point(const ReliefCamera& camera, double u, double v, double z) {
    const SourceRay ray = source_ray(camera, u, v);
    return ray.origin + (camera.projection == Projection::Orthographic ? z : 1 / (1 - z)) * ray.direction;
}

// All lines of sight of a viewer.
struct ReliefRays {
    glm::dmat3 plane_from_screen;
    double k1, k2, k3;  // times s

    // Through (x, y) on the screen, in pixels; none where it does not go through the plane.
    std::optional<ReliefRay> through(double x, double y) const {
        const glm::dvec3 p = plane_from_screen * glm::dvec3(x, y, 1);
        if (!(p.z > 0)) return {};
        const glm::dvec2 entry(p.x / p.z, p.y / p.z);
        return ReliefRay{entry, {k3 * entry.x - k1, k3 * entry.y - k2}};
    }
};
// Errors are those of make_warp. The viewer is a perspective camera.
inline Result<ReliefRays> relief_rays(const ReliefCamera& source, const ReliefCamera& viewer) {
    assert(viewer.projection == Projection::Perspective);
    const auto warp = make_warp(source, viewer_at(viewer.eye));
    if (!warp) return warp.error();
    const double s = source.projection == Projection::Orthographic ? 1 : -1;
    return ReliefRays{glm::inverse(plane_homography(source, viewer)), s * warp->k1, s * warp->k2,
                      s * warp->k3};
}

}  // namespace relevo::relief
