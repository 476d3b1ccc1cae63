// The [animation] table: where the eye stands in each picture of a row.
#pragma once
#include "samples/scene/camera.hpp"

namespace relevo::scene {

inline constexpr int max_frames = 10'000;

// Target and radius, where they are left out, are those of the camera, which becomes that of the first
// frame. Every frame's eye must have a view.
Animation read_animation(const Value& table, SceneCamera& camera, Diagnosis& diagnosis);

// The eye of frame 0 .. frames - 1. An orbit ends at `to`, or, when it goes round whole turns, one step
// before, so that the row can be repeated.
glm::dvec3 eye_at(const Animation& animation, int frame);

// The scene's camera in that frame; its own when there is no animation.
raster::Camera camera_at(const LoadedScene& scene, int frame);

}  // namespace relevo::scene
