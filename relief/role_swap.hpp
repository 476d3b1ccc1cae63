// A side face of a box on the plane of its front face (Oliveira and Bishop 1999; Clua 2004, 3.4.3).
//
// The face to the left of the front one looks along the front's a; its columns run along the front's f. So a
// point of it is a point of the front's plane with the roles exchanged: what the side face stores as a
// displacement is a place along u, and its column is a depth behind the front's plane:
//
//     X = O + v b + (u' s) f + disp a/|a|     U = disp / |a|,  d = u' s,  V = v       (left)
//                                             U = N - disp / |a|                       (right)
//
// d is the same all over a column, so the warp's factor 1 / (1 + k3 d) is one number a column. In general the
// coordinates of two parallel projections on planes at any angle differ by an affine map, which is what
// stands here: it also serves the faces above and below, and depth images that are placed anywhere.
#pragma once
#include <glm/matrix.hpp>

#include "relief/relief_texture.hpp"

namespace relevo::relief {

// (U, V, d) of the carrier from (u, v, displacement) of another texture; texels and world units. Both are
// orthographic.
struct RoleSwap {
    glm::dmat3 linear;
    glm::dvec3 origin;
    glm::dvec3 operator()(double u, double v, Displacement d) const {
        return linear * glm::dvec3(u, v, d.value) + origin;
    }
};
inline RoleSwap role_swap(const ReliefCamera& carrier, const ReliefCamera& face) {
    assert(carrier.projection == Projection::Orthographic && face.projection == Projection::Orthographic);
    const glm::dmat3 carrier_from_world = glm::inverse(glm::dmat3(carrier.a, carrier.b, forward(carrier)));
    return {carrier_from_world * glm::dmat3(face.a, face.b, forward(face)),
            carrier_from_world * (face.corner - carrier.corner)};
}

}  // namespace relevo::relief
