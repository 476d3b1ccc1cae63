// Pictures of analytic surfaces by casting a ray through every texel: a source of relief textures, and the
// truth with which the warped ones are compared.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "relief/relief_texture.hpp"
#include "relief/surface.hpp"
#include "relief/view_image.hpp"

namespace relevo::relief {

// The ray through (u, v) from the camera's plane on: what lies before the plane is not seen. A surface that
// touches the plane is, whatever rounding does to it: the ray starts 1e-9 of the picture's width before.
inline Ray capture_ray(const ReliefCamera& camera, double u, double v) {
    const SourceRay ray = source_ray(camera, u, v);
    if (camera.projection == Projection::Perspective) return {ray.origin, ray.direction, 1 - 1e-9};
    return {ray.origin, ray.direction, -1e-9 * camera.width * std::sqrt(glm::dot(camera.a, camera.a))};
}

// What a relief texture stores for the point at t on the ray: a displacement t >= 0 or a disparity 1 / t
// <= 1.
inline Scalar stored_depth(Projection projection, double t) {
    return static_cast<Scalar>(projection == Projection::Orthographic ? std::max(t, 0.0)
                                                                      : std::min(1 / t, 1.0));
}

// One ray through the centre of each texel.
template <RayCastable Surface>
ReliefTexture ray_cast(const Surface& surface, const ReliefCamera& camera) {
    ReliefTexture texture = make_relief_texture(camera);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const auto hit = first_hit(surface, capture_ray(camera, x + 0.5, y + 0.5));
            if (!hit) continue;
            texture.color.at(x, y) = hit->color;
            texture.normal.at(x, y) = Vec3(hit->normal);
            texture.depth.at(x, y) = stored_depth(camera.projection, hit->t);
            texture.coverage.at(x, y) = 1;
        }
    return texture;
}

// What a viewer sees of it: the truth at the pixel centres (samples = 1), or of samples x samples rays a
// pixel, each from the screen's plane on.
template <RayCastable Surface>
ViewImage ray_cast_view(const Surface& surface, const ReliefCamera& viewer, int samples = 1) {
    const ViewImage fine = as_seen(ray_cast(surface, refined(viewer, samples)));
    return samples == 1 ? fine : reduced(fine, samples);
}

}  // namespace relevo::relief
