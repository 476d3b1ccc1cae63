// Layered depth images: behind the first surface of every texel also the second, the third... (Shade,
// Gortler, He and Szeliski, SIGGRAPH 1998; Clua 2004, 3.2). What one relief texture loses when the viewer
// moves, since something else stood before it, is there.
//
// A layer is a relief texture of the same camera. Surfaces that turn their back to the source are layers,
// too: whoever looks from aside sees round the edge at some of them.
#pragma once
#include <vector>

#include "relief/ray_cast.hpp"
#include "relief/view_mesh.hpp"

namespace relevo::relief {

// Depth peeling by rays: each goes on from where the last layer stopped it. Layers may be empty.
template <RayCastable Surface>
std::vector<ReliefTexture> ray_cast_layers(const Surface& surface, const ReliefCamera& camera, int layers) {
    std::vector<ReliefTexture> peeled(std::size_t(layers), make_relief_texture(camera));
    const double hair =
        camera.projection == Projection::Perspective
            ? 1e-7
            : 1e-7 * camera.width * std::sqrt(glm::dot(camera.a, camera.a));  // beyond the surface just met
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            Ray ray = capture_ray(camera, x + 0.5, y + 0.5);
            for (ReliefTexture& texture : peeled) {
                const auto hit = first_hit(surface, ray);
                if (!hit) break;
                ray.from = hit->t + hair;
                texture.color.at(x, y) = hit->color;
                texture.normal.at(x, y) = Vec3(hit->normal);
                texture.depth.at(x, y) = stored_depth(camera.projection, hit->t);
                texture.coverage.at(x, y) = 1;
            }
        }
    return peeled;
}

// All layers by depth; the coverage of a pixel is 1 + its layer. `jump` is that of view_mesh.hpp.
inline ViewImage draw_layers(const std::vector<ReliefTexture>& layers, const ReliefCamera& viewer,
                             double jump) {
    ViewImage image(viewer.width, viewer.height);
    for (std::size_t k = 0; k < layers.size(); ++k)
        draw_view_mesh(layers[k], viewer, jump, image, static_cast<std::uint8_t>(1 + k), Sides::Both);
    return image;
}

}  // namespace relevo::relief
