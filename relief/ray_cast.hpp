// Pictures of analytic surfaces by casting a ray through every texel: a source of relief textures, and the
// truth with which the warped ones are compared.
#pragma once
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "pipeline/result.hpp"
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

// What a viewer at the eye of a perspective camera sees: truth at the pixel centres (samples = 1), or of
// samples x samples rays a pixel. Then a pixel is covered when at least half of its rays hit something; its
// colour and depth are the mean over those that do.
template <RayCastable Surface>
ViewImage ray_cast_view(const Surface& surface, const ReliefCamera& viewer, int samples = 1) {
    assert(viewer.projection == Projection::Perspective && samples >= 1);
    const double distance = glm::dot(viewer.corner - viewer.eye, forward(viewer));
    ViewImage image(viewer.width, viewer.height);
    for (int y = 0; y < viewer.height; ++y)
        for (int x = 0; x < viewer.width; ++x) {
            glm::dvec3 color{0};
            double depth = 0;
            int hits = 0;
            for (int j = 0; j < samples; ++j)
                for (int i = 0; i < samples; ++i) {
                    const SourceRay ray =
                        source_ray(viewer, x + (i + 0.5) / samples, y + (j + 0.5) / samples);
                    const auto hit = first_hit(surface, Ray{ray.origin, ray.direction});
                    if (!hit) continue;
                    ++hits, depth += hit->t * distance;
                    color += glm::dvec3(hit->color.r, hit->color.g, hit->color.b);
                }
            if (2 * hits < samples * samples || hits == 0) continue;
            color /= hits;
            image.color.at(x, y) = {Scalar(color.x), Scalar(color.y), Scalar(color.z)};
            image.depth.at(x, y) = static_cast<Scalar>(depth / hits);
            image.coverage.at(x, y) = 1;
        }
    return image;
}

}  // namespace relevo::relief
