// Small scenes of the step pictures' tests.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "samples/scene/scene.hpp"

namespace relevo::show {

inline scene::LoadedScene loaded_scene(const std::string& text) {
    auto loaded = scene::parse_scene(text, "scene.toml");
    if (!loaded) {
        ADD_FAILURE() << loaded.error().text();
        std::abort();
    }
    return std::move(*loaded);
}

// A cube before the eye, 40 x 30 pixels.
inline const std::string cube_scene = R"([image]
width = 40
height = 30
[camera]
eye = [0, 1, 3]
target = [0, 0, 0]
[[object]]
mesh = "cube"
)";

// The same, looked at from the wrong side: everything is behind the eye.
inline const std::string outside_scene = R"([image]
width = 40
height = 30
[camera]
eye = [0, 0, 3]
target = [0, 0, 9]
[[object]]
mesh = "cube"
)";

// A square whose front looks down, seen from above: nothing is left after culling.
inline const std::string culled_scene = R"([image]
width = 40
height = 30
[camera]
eye = [0, 4, 0.5]
target = [0, 0, 0]
[[object]]
mesh = "plane"
transform = [{ rotate = { axis = [1, 0, 0], degrees = 180 } }]
)";

}  // namespace relevo::show
