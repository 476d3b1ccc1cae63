#include "relief/unseen.hpp"

#include "raster/draw.hpp"
#include "relief/capture_raster.hpp"

namespace relevo::relief {
namespace {

struct NearestTriangle {
    Image<std::uint32_t>& number;  // 1 + the primitive, 0: none
    void on(const raster::FragmentShaded& fragment) {
        number.at(fragment.x, fragment.y) = 1 + fragment.primitive;
    }
};

}  // namespace

std::vector<std::uint8_t> seen_triangles(const raster::Scene& scene, std::span<const ReliefCamera> cameras,
                                         pipeline::Cull cull) {
    std::size_t triangles = 0;
    for (const raster::Model& model : scene.models) triangles += model.mesh->triangles();
    std::vector<std::uint8_t> seen(triangles, 0);
    raster::Scene view = scene;
    for (const ReliefCamera& camera : cameras) {
        view.camera = raster_camera(camera, depth_of_scene(scene, camera));
        raster::Frame frame{{camera.width, camera.height}, {camera.width, camera.height}, {}};
        Image<std::uint32_t> number(camera.width, camera.height);
        raster::draw(view, {.shading = raster::Shading::Unlit, .cull = cull}, frame, NearestTriangle{number});
        for (const std::uint32_t n : number.pixels())
            if (n > 0) seen[n - 1] = 1;
    }
    return seen;
}

}  // namespace relevo::relief
