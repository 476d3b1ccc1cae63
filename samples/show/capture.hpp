// Everything the step pictures need to know about one scene: the machine drew it once, with the probes
// watching.
#pragma once
#include <string>
#include <vector>

#include "raster/draw.hpp"
#include "samples/scene/scene.hpp"
#include "samples/show/probes.hpp"
#include "samples/show/view.hpp"

namespace relevo::show {

struct Capture {
    const scene::LoadedScene* loaded = nullptr;  // borrowed
    RecordingProbe seen;
    raster::Image<raster::Scalar> depth;
    raster::Image<std::uint32_t> visible;  // the primitive that each pixel shows, or SeenPixel::nothing

    const raster::Scene& scene() const { return loaded->scene; }
    const raster::Model& model(std::size_t m) const { return loaded->scene.models[m]; }
    const std::vector<SeenVertex>& vertices(std::size_t m) const { return seen.geometry.models[m]; }
    std::int64_t triangles() const;
    std::int64_t vertices() const;  // vertices of all models
    bool reversed_depth() const { return loaded->settings.depth == raster::DepthFormat::Float32Reversed; }
};

// Draws the scene with Phong shading (so that normals reach the pixels) and notes what happens. `visible`
// comes from the fast path where plan_path() chooses it, else from the probe: the same numbers.
Capture capture(const scene::LoadedScene& loaded);

// The scene's picture with this shading and the scene's other settings.
Picture drawn_picture(const scene::LoadedScene& loaded, raster::Shading shading);

// "teapot", shortened; "model 3" when it has no name.
std::string model_name(const scene::LoadedScene& loaded, std::size_t model, int letters);

// The models' corners in world space; a list a model.
std::vector<glm::dvec3> world_positions(const raster::Model& model);
std::vector<glm::dvec3> object_positions(const raster::Model& model);

}  // namespace relevo::show
