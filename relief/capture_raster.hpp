// Relief textures from the project's own rasterizer (Clua 2004, 8.8): the machine of raster/draw.hpp draws
// the scene for the source's camera, with a probe that keeps what a relief texture needs of every texel.
//
// The z-buffer decides which triangle a texel sees; its depth is not read. A fragment's point lies on the
// triangle, but up to 1/512 texel beside the texel's ray (the corners are snapped), which on a steep face is
// a visible error of depth. So the displacement is where the ray meets the triangle's own plane, in double:
// the same number that a ray caster finds. Normals are interpolated by the machine; a vertex without one gets
// the face's.
#pragma once
#include <vector>

#include "raster/scene.hpp"
#include "relief/capture.hpp"

namespace relevo::relief {

// The machine's camera that draws the source's picture, texel for pixel. Depth is reversed; what lies before
// the source's plane is clipped; `far` is how far behind the plane an orthographic camera sees, in world
// units. Skewed axes are no obstacle.
raster::Camera raster_camera(const ReliefCamera& camera, double far);

// How far the scene reaches behind the source's plane, in world units: the `far` that cuts nothing off.
double depth_of_scene(const raster::Scene& scene, const ReliefCamera& camera);

// The scene's own camera is not used. `settings` says how colours are made; the default is unlit, so that the
// relief can be lit where it is shown. Refused: a camera that `refusal` refuses.
Result<ReliefTexture> capture_raster(const raster::Scene& scene, const ReliefCamera& camera,
                                     raster::Settings settings = {.shading = raster::Shading::Unlit});

// What lies behind one another in every texel, the nearest first, both sides of every triangle; unlit. Layers
// may be empty (depth peeling; layered_depth_image.hpp draws them). layers > 0. Refused: as above.
Result<std::vector<ReliefTexture>> capture_raster_layers(const raster::Scene& scene,
                                                         const ReliefCamera& camera, int layers,
                                                         raster::Settings settings = {});

struct RasterCapture {
    const raster::Scene& scene;  // borrowed
    raster::Settings settings{.shading = raster::Shading::Unlit};
    Result<ReliefTexture> operator()(const ReliefCamera& camera) const {
        return capture_raster(scene, camera, settings);
    }
};

}  // namespace relevo::relief
