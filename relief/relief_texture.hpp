// A relief texture: a picture whose texels know how far the surface lies behind the picture's plane
// (Oliveira, Bishop and McAllister, "Relief texture mapping", SIGGRAPH 2000; Clua 2004, 3.4).
//
//     corner C, one texel step a to the right and b down, f = (a x b) / |a x b| into the relief, away
//     from the viewer; texel (i, j) is [i, i+1) x [j, j+1), its centre (u, v) = (i + .5, j + .5), row 0
//     on top
//
//     orthographic   X = C + u a + v b + d f           d >= 0: displacement, in world units along f
//     perspective    X = S + (C + u a + v b - S) / q   0 < q <= 1: generalised disparity, 1 on the plane
//
// The thesis writes both numbers with one letter, though the one grows with the distance and the other
// falls: here they are two types. Whether a texel holds a surface at all is told by its coverage, never
// by a magic depth.
//
// The channels are pictures of their own, for a warp reads some and skips others. Colour is linear
// float, not 8 bits: a warp mixes colours, which is right in linear light only, and twice (rows, then
// columns), so that a rounded intermediate would show. Cameras are in double: a warp rounds its
// constants, not their sources.
#pragma once
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>

#include "pipeline/color.hpp"
#include "pipeline/elementary.hpp"
#include "pipeline/result.hpp"
#include "raster/image.hpp"

namespace relevo::relief {

using pipeline::LinearRgb;
using pipeline::Result;
using pipeline::Scalar;
using pipeline::Vec3;
using raster::Image;

enum class Projection { Orthographic, Perspective };

struct Displacement {
    Scalar value;
};
struct Disparity {
    Scalar value;
};

// The camera of a source picture. World coordinates; a and b are neither zero nor parallel.
struct ReliefCamera {
    Projection projection = Projection::Orthographic;
    glm::dvec3 corner{0};  // C, where u = v = 0
    glm::dvec3 a{1, 0, 0}, b{0, -1, 0};
    glm::dvec3 eye{0};  // S, in front of the plane; of a perspective camera only
    int width = 0, height = 0;
};

inline glm::dvec3 forward(const ReliefCamera& camera) {
    const glm::dvec3 n = glm::cross(camera.a, camera.b);
    return n / std::sqrt(glm::dot(n, n));
}
inline glm::dvec3 plane_point(const ReliefCamera& camera, double u, double v) {
    return camera.corner + (u * camera.a + v * camera.b);
}

// The line of sight through (u, v): X = origin + t direction, where t is the displacement of an
// orthographic source (t = 0 on the plane) and 1 / disparity of a perspective one (t = 1 on the plane).
struct SourceRay {
    glm::dvec3 origin, direction;
};
inline SourceRay source_ray(const ReliefCamera& camera, double u, double v) {
    const glm::dvec3 p = plane_point(camera, u, v);
    if (camera.projection == Projection::Orthographic) return {p, forward(camera)};
    return {camera.eye, p - camera.eye};
}

inline glm::dvec3 world_point(const ReliefCamera& camera, double u, double v, Displacement d) {
    assert(camera.projection == Projection::Orthographic);
    return plane_point(camera, u, v) + double{d.value} * forward(camera);
}
inline glm::dvec3 world_point(const ReliefCamera& camera, double u, double v, Disparity q) {
    assert(camera.projection == Projection::Perspective);
    return camera.eye + (plane_point(camera, u, v) - camera.eye) / double{q.value};
}

// All channels have the camera's size. Where coverage is 0 the others mean nothing (they are zero as
// made).
struct ReliefTexture {
    ReliefCamera camera;
    Image<LinearRgb> color;
    Image<Vec3> normal;            // of length 1, in world space
    Image<Scalar> depth;           // Displacement or Disparity, as the camera's projection says
    Image<std::uint8_t> coverage;  // 1: a surface, 0: empty
};

inline Displacement displacement(const ReliefTexture& texture, int x, int y) {
    assert(texture.camera.projection == Projection::Orthographic);
    return {texture.depth.at(x, y)};
}
inline Disparity disparity(const ReliefTexture& texture, int x, int y) {
    assert(texture.camera.projection == Projection::Perspective);
    return {texture.depth.at(x, y)};
}
// The surface's point at the centre of a covered texel.
inline glm::dvec3 world_point(const ReliefTexture& texture, int x, int y) {
    const double u = x + 0.5, v = y + 0.5;
    return texture.camera.projection == Projection::Orthographic
               ? world_point(texture.camera, u, v, displacement(texture, x, y))
               : world_point(texture.camera, u, v, disparity(texture, x, y));
}

// An empty relief texture of the camera's size.
inline ReliefTexture make_relief_texture(const ReliefCamera& camera) {
    return {camera,
            {camera.width, camera.height},
            {camera.width, camera.height},
            {camera.width, camera.height},
            {camera.width, camera.height}};
}

// Why a camera, or a relief texture, cannot be used; nothing when it can. Refused: sizes outside
// 1..max_picture_size or not the camera's; what is not finite; a and b parallel or zero; an eye on or
// behind the plane; in a covered texel a displacement below 0 or a disparity outside (0, 1]. The message
// names the first texel that is wrong.
std::optional<pipeline::Error> refusal(const ReliefCamera& camera);
std::optional<pipeline::Error> refusal(const ReliefTexture& texture);

// What both kinds of camera look at: width x height square texels; `toward` is the direction of sight,
// any length, `up` any direction not parallel to it.
struct SourceView {
    glm::dvec3 toward{0, 0, -1}, up{0, 1, 0};
    int width = 256, height = 256;
};
// The plane passes through `center`; `extent` is its height in world units.
Result<ReliefCamera> orthographic_camera(const SourceView& view, glm::dvec3 center, double extent);
// The plane lies `distance` > 0 in front of the eye and is seen under the vertical angle fov_y, 0 to 180
// degrees.
Result<ReliefCamera> perspective_camera(const SourceView& view, glm::dvec3 eye, double distance,
                                        pipeline::Degrees fov_y);

}  // namespace relevo::relief
