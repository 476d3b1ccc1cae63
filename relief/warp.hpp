// The pre-warp: where a texel of a relief texture must be painted on its own plane, so that the flat
// picture looks right from another place (Oliveira, Bishop and McAllister 2000; Clua 2004, 3-1 and 3-2,
// with the sign corrected).
//
//     u_i = (u + k1 q) / (1 + k3 q)      v_i = (v + k2 q) / (1 + k3 q)
//
//     c = C - T, from the viewer T to the corner; h = c.f > 0, how far the viewer is before the plane
//     orthographic source    q = d,            f = k1 a + k2 b + k3 c
//     perspective source     q = disparity - 1, D = k1 a + k2 b + k3 c with D = S - T, the viewer to S
//
// Why: X - T = c + u a + v b + d f = (1 + k3 d)(u_i a + v_i b + c), and the same with D for the other
// source. The weight h / (h + d) is linear in the warped picture: everything else is interpolated with
// it.
//
// A viewer may be infinitely far away: k3 of an orthographic source is then 0, the warp a pure shear.
// Refused: a viewer on or behind the plane (h <= 0), for there 1 + k3 q changes its sign, and one that
// is not finite.
#pragma once
#include "relief/relief_texture.hpp"

namespace relevo::relief {

// Where the picture is seen from: a homogeneous place in the world; w = 0 is a direction, towards the
// viewer.
struct Viewer {
    glm::dvec4 place;
};
inline Viewer viewer_at(const glm::dvec3& p) { return {{p, 1}}; }
inline Viewer viewer_toward(const glm::dvec3& direction) { return {{direction, 0}}; }

struct Warp {
    Projection projection;
    double k1, k2, k3;
    double h;         // from the viewer to the plane along f, world units; infinite at infinity
    double source_h;  // from the eye S to the plane; infinite for an orthographic source
};
// From the eye of a perspective camera to its plane, along f; infinite for an orthographic one.
double height_of_source(const ReliefCamera& camera);

// The constants from triple products: any axes, also skewed ones.
Result<Warp> make_warp(const ReliefCamera& camera, const Viewer& viewer);
// The constants from lengths along the axes (the foot of the viewer on the plane, in texels, is the
// epipole of an orthographic source). Needs a.b = 0; skewed axes are refused.
Result<Warp> make_warp_along_axes(const ReliefCamera& camera, const Viewer& viewer);

// What the formulas call q.
inline double warp_parameter(Displacement d) { return double{d.value}; }
inline double warp_parameter(Disparity q) { return double{q.value} - 1; }

// A texel on its way: its place in the warped picture, and h / (h + d), the weight of all that it
// carries.
struct WarpedPoint {
    double u, v, weight;
};

inline WarpedPoint warp_point(const Warp& warp, double u, double v, Displacement d) {
    assert(warp.projection == Projection::Orthographic);
    const double q = warp_parameter(d), w = 1 / (1 + warp.k3 * q);
    return {(u + warp.k1 * q) * w, (v + warp.k2 * q) * w, w};
}
inline WarpedPoint warp_point(const Warp& warp, double u, double v, Disparity disparity) {
    assert(warp.projection == Projection::Perspective);
    const double q = warp_parameter(disparity), w = 1 / (1 + warp.k3 * q);
    return {(u + warp.k1 * q) * w, (v + warp.k2 * q) * w, w * double{disparity.value}};
}
inline WarpedPoint warp_texel(const Warp& warp, const ReliefTexture& texture, int x, int y) {
    const double u = x + 0.5, v = y + 0.5;
    return warp.projection == Projection::Orthographic ? warp_point(warp, u, v, displacement(texture, x, y))
                                                       : warp_point(warp, u, v, disparity(texture, x, y));
}

// Where a point of the warped picture comes from, if it lies that deep (Clua 6-1, its k2 corrected): a
// straight line in the source picture, which is the ray that the inverse searches.
template <class Depth>
glm::dvec2 unwarp_point(const Warp& warp, double u, double v, Depth depth) {
    const double q = warp_parameter(depth), s = 1 + warp.k3 * q;
    return {u * s - warp.k1 * q, v * s - warp.k2 * q};
}

// How deep behind the plane, in world units along f, for either source.
inline double depth_behind_plane(const Warp&, Displacement d) { return double{d.value}; }
inline double depth_behind_plane(const Warp& warp, Disparity q) {
    return warp.source_h * ((1 - double{q.value}) / double{q.value});
}

}  // namespace relevo::relief
