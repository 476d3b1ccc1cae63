// Image warping in three dimensions, without any factoring: the reference of the pre-warp (McMillan, "An
// image-based approach to three-dimensional computer graphics", 1997, 3.3; Clua 2004, 2-10).
//
//     x_t ~ P_t^-1 ( (S - T) q + P_s x_s )       P = [a b C - eye], x = (u, v, 1), q: generalised disparity
//     x_t ~ P_t^-1 ( C_s - T + u a_s + v b_s + d f )                            for an orthographic source
//
// A relief texture factors this map: the pre-warp, which needs the depth, and then the homography
// between the planes, which is texture mapping. The two together are this map again.
#pragma once
#include <glm/matrix.hpp>

#include "relief/relief_texture.hpp"

namespace relevo::relief {

// [a b C - eye]: takes (u, v, 1) to the point's line of sight. Its inverse takes any vector from the eye
// to (u, v, 1) times how many times farther than the plane it reaches.
inline glm::dmat3 sight_matrix(const ReliefCamera& camera) {
    assert(camera.projection == Projection::Perspective);
    return {camera.a, camera.b, camera.corner - camera.eye};
}

// The same texel in the picture of the target camera. `z` is how many times farther than the target's
// plane the point lies; z <= 0: at or behind the target's eye, u and v then mean nothing.
struct Warped3d {
    double u, v, z;
};
inline Warped3d warp_3d(const glm::dvec3& from_target_eye, const ReliefCamera& target) {
    const glm::dvec3 x = glm::inverse(sight_matrix(target)) * from_target_eye;
    return {x.x / x.z, x.y / x.z, x.z};
}
inline Warped3d warp_3d(const ReliefCamera& source, double u, double v, Disparity q,
                        const ReliefCamera& target) {
    const glm::dvec3 sight = sight_matrix(source) * glm::dvec3(u, v, 1);
    Warped3d x = warp_3d((source.eye - target.eye) * double{q.value} + sight, target);
    x.z /= double{q.value};
    return x;
}
inline Warped3d warp_3d(const ReliefCamera& source, double u, double v, Displacement d,
                        const ReliefCamera& target) {
    return warp_3d(world_point(source, u, v, d) - target.eye, target);
}

// Where the target camera sees the points (u, v) of the source's plane: multiply it by (u, v, 1).
inline glm::dmat3 plane_homography(const ReliefCamera& source, const ReliefCamera& target) {
    return glm::inverse(sight_matrix(target)) * glm::dmat3(source.a, source.b, source.corner - target.eye);
}

}  // namespace relevo::relief
