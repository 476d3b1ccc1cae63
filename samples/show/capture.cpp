#include "samples/show/capture.hpp"

#include <algorithm>

#include "raster/path.hpp"

namespace relevo::show {
namespace {

static_assert(SeenPixel::nothing == raster::fast::nothing);

raster::Image<std::uint32_t> visible_triangles(const scene::LoadedScene& loaded, const PixelProbe& seen) {
    raster::Image<std::uint32_t> visible(loaded.width, loaded.height);
    const raster::PathPlan plan = plan_path(loaded.scene, loaded.settings);
    if (plan.fast) {
        raster::fast::Workspace workspace;
        raster::Frame frame = scene::make_frame(loaded);
        draw(loaded.scene, loaded.settings, frame, workspace,
             {plan.instruction_set, plan.tile, nullptr, &visible});
    } else {
        std::transform(seen.pixels.pixels().begin(), seen.pixels.pixels().end(), visible.pixels().begin(),
                       [](const SeenPixel& pixel) { return pixel.primitive; });
    }
    return visible;
}

}  // namespace

std::int64_t Capture::triangles() const {
    std::int64_t count = 0;
    for (const raster::Model& m : scene().models) count += static_cast<std::int64_t>(m.mesh->triangles());
    return count;
}

std::int64_t Capture::vertices() const {
    std::int64_t count = 0;
    for (const raster::Model& m : scene().models) count += static_cast<std::int64_t>(m.mesh->vertices.size());
    return count;
}

Capture capture(const scene::LoadedScene& loaded) {
    Capture out{&loaded, {}, {}, {}};
    out.seen.geometry.models.resize(loaded.scene.models.size());
    for (std::size_t m = 0; m < loaded.scene.models.size(); ++m)
        out.seen.geometry.models[m].reserve(loaded.scene.models[m].mesh->vertices.size());
    out.seen.pixels.pixels = raster::Image<SeenPixel>(loaded.width, loaded.height);
    raster::Settings settings = loaded.settings;
    settings.shading = raster::Shading::Phong;
    raster::Frame frame = scene::make_frame(loaded);
    raster::draw(loaded.scene, settings, frame, out.seen);
    out.depth = std::move(frame.depth);
    out.visible = visible_triangles(loaded, out.seen.pixels);
    return out;
}

Picture drawn_picture(const scene::LoadedScene& loaded, raster::Shading shading) {
    raster::Settings settings = loaded.settings;
    settings.shading = shading;
    raster::Frame frame = scene::make_frame(loaded);
    raster::draw(loaded.scene, settings, frame);
    return std::move(frame.color);
}

std::string model_name(const scene::LoadedScene& loaded, std::size_t model, int most) {
    const bool named = model < loaded.descriptions.size() && !loaded.descriptions[model].name.empty();
    return shortened(named ? loaded.descriptions[model].name : "model " + std::to_string(model + 1), most);
}

std::vector<glm::dvec3> object_positions(const raster::Model& model) {
    std::vector<glm::dvec3> out;
    out.reserve(model.mesh->vertices.size());
    for (const pipeline::Vertex& v : model.mesh->vertices) out.push_back(glm::dvec3(v.position.v));
    return out;
}

std::vector<glm::dvec3> world_positions(const raster::Model& model) {
    std::vector<glm::dvec3> out = object_positions(model);
    for (glm::dvec3& p : out) p = glm::dvec3(model.world_from_object.m * glm::dvec4(p, 1));
    return out;
}

}  // namespace relevo::show
