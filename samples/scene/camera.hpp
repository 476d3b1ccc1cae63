// The [camera] table: from words to the two maps of the machine.
#pragma once
#include <vector>

#include "samples/scene/fields.hpp"

namespace relevo::scene {

struct SceneCamera {
    CameraDescription description;
    raster::Camera camera;
};

// `aspect` is width / height. What the table leaves out is chosen so that all models are seen:
//   projection "perspective", fov_y 40, up +y, target the middle of the models, eye in front of it to the
//   right and above, near a hundredth of the way to the target, far infinite; orthographic: near 0, far
//   behind the last model.
// A frustum's window has no default.
SceneCamera read_camera(const Value& table, double aspect, raster::DepthFormat depth,
                        const std::vector<raster::Model>& models, Diagnosis& diagnosis);

// Above, to the right of and behind the camera.
glm::dvec3 lamp_position(const SceneCamera& camera);

}  // namespace relevo::scene
