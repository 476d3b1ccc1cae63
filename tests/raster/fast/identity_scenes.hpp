// What the promise "same bytes" is tried on: subjects, and everything that a picture of them can ask for.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "raster/scene.hpp"
#include "tests/raster/fast/identity.hpp"

namespace relevo::tests::identity {

// ---------------------------------------------------------------------------------------- what can be asked
enum class Texturing { None, Nearest, Bilinear };

struct Features {
    raster::Shading shading = raster::Shading::Phong;
    Texturing texturing = Texturing::None;
    raster::Output output = raster::Output::Raw;
    pipeline::Cull cull = pipeline::Cull::None;
    bool two_sided = false, mirrored = false;
    raster::DepthFormat depth = raster::DepthFormat::Float32Reversed;
    int lights = 1;  // 0, 1 or 3
    bool orthographic = false;
};
inline const std::vector<int> feature_choices{4, 3, 2, 3, 2, 2, 2, 3, 2};  // of each member in its turn
// One choice for each member; further choices may follow, for the caller.
Features features(const std::vector<int>& choice);
std::string text(const Features& features);
raster::Settings settings(const Features& features);

// All combinations of choices, the last one turning fastest.
std::vector<std::vector<int>> product(const std::vector<int>& choices);
// Few combinations, in which every two choices of every two members meet.
std::vector<std::vector<int>> pairs(const std::vector<int>& choices);

// ---------------------------------------------------------------------------------------------- of what
// A scene that any features can be put on. Owns its meshes.
struct Subject {
    std::string name;
    std::vector<std::shared_ptr<const pipeline::Mesh>> meshes;
    raster::Scene scene;
    double near = 0.1, half_height = 1.5;  // of the view; half_height: of the orthographic one

    void add(pipeline::Mesh mesh, const pipeline::Affine<pipeline::World, pipeline::Object>& place = {});
};
raster::Scene dressed(const Subject& subject, const Features& features, Size size);

// A floor from behind the eye to the horizon, fans seen from both sides, a torus round the eye: 300
// triangles.
Subject everything();
Subject torus(const std::string& name, int ring, int round);  // tests/bench/workload.hpp
Subject inside_torus(int ring, int round);                    // the eye in its tube: near plane, guard band
Subject fill();
Subject bunny();
Subject inside_bunny();

// ------------------------------------------------------------------------------------------ sample scenes
std::vector<std::string> sample_scenes();  // names of samples/scenes/*.toml

}  // namespace relevo::tests::identity
