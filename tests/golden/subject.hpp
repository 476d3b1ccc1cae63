// The small scenes that the goldens draw, made in code so that no file reader stands between them and a
// pixel.
#pragma once
#include <deque>
#include <span>
#include <string_view>

#include "raster/scene.hpp"

namespace relevo::golden {

// A scene that owns its meshes and textures; to be moved, not copied.
struct Subject {
    int width = 0, height = 0;
    raster::Scene scene;
    raster::Settings settings;
    std::deque<pipeline::Mesh> meshes;  // a deque keeps its elements in place: scene.models points at them
    std::deque<raster::Texture> textures;

    Subject() = default;
    Subject(Subject&&) = default;
    Subject& operator=(Subject&&) = default;
    Subject(const Subject&) = delete;
    Subject& operator=(const Subject&) = delete;
};

enum class Stage { Clipped, Window, Coverage, Depth, Attributes, Color, Final };

struct Case {
    std::string_view name;  // folder/file below tests/golden
    Stage stage;            // which of the machine's data the golden keeps
    Subject (*make)();
};
std::span<const Case> all_cases();

}  // namespace relevo::golden
