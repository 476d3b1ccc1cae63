#include "samples/scene/draw_scene.hpp"

#include <algorithm>

#include "samples/scene/animation.hpp"
#include "samples/scene/choices.hpp"

namespace relevo::scene {
namespace {

io::FileError wrong(const ReliefObject& object, const std::string& what) {
    return {object.place, object.name + ": " + what};
}

}  // namespace

io::FileResult<ReliefPictures> take_pictures(const LoadedScene& scene, int threads) {
    ReliefPictures pictures;
    for (const ReliefObject& object : scene.reliefs) {
        auto made = relief::represent(object.representation, object.settings, shape_capture(scene, object));
        if (!made) return wrong(object, made.error().message);
        made->settings.prewarp.threads = threads;
        const auto shows = [](const relief::ReliefTexture& texture) {
            const auto& covered = texture.coverage.pixels();
            return std::find(covered.begin(), covered.end(), 1) != covered.end();
        };
        if (!made->textures.empty() && std::none_of(made->textures.begin(), made->textures.end(), shows))
            pictures.notes.push_back(
                wrong(object, "its pictures are empty: from this azimuth and elevation no texel meets it")
                    .text());
        pictures.objects.push_back(*std::move(made));
    }
    return pictures;
}

std::vector<PictureCounts> picture_counts(const LoadedScene& scene, const ReliefPictures& pictures) {
    std::vector<PictureCounts> all;
    for (std::size_t i = 0; i < scene.reliefs.size(); ++i) {
        const relief::Represented& object = pictures.objects[i];
        PictureCounts counts{scene.reliefs[i].name,
                             name_of(object.representation, representations),
                             object.textures.size(),
                             0,
                             0,
                             0,
                             0};
        for (const relief::ReliefTexture& texture : object.textures) {
            counts.width = texture.camera.width, counts.height = texture.camera.height;
            const auto& covered = texture.coverage.pixels();
            counts.texels += covered.size();
            counts.covered += static_cast<std::uint64_t>(std::count(covered.begin(), covered.end(), 1));
        }
        all.push_back(std::move(counts));
    }
    return all;
}

io::FileResult<Drawn> draw_scene(const LoadedScene& loaded, const ReliefPictures& pictures, int frame_number,
                                 raster::Frame& frame, raster::fast::Workspace& workspace,
                                 raster::fast::Workers* workers) {
    raster::Scene scene = loaded.scene;
    scene.camera = camera_at(loaded, frame_number);
    Drawn drawn;
    std::vector<relief::Represented> surfaces;  // those of `objects` that are drawn as geometry
    surfaces.reserve(loaded.reliefs.size());
    std::vector<const relief::Represented*> objects;
    for (std::size_t i = 0; i < loaded.reliefs.size(); ++i) {
        const relief::Represented& object = pictures.objects[i];
        const auto refusal = relief::refusal(object, scene.camera);
        if (refusal) {
            drawn.notes.push_back(wrong(loaded.reliefs[i], "drawn as geometry: " + refusal->message).text());
            const std::vector<raster::Model>& models = loaded.reliefs[i].models->models;
            scene.models.insert(scene.models.end(), models.begin(), models.end());
            if (!models.empty()) continue;
            if (scene.camera.parallel)
                return wrong(
                    loaded.reliefs[i],
                    refusal->message + "; and rays are cast from an eye, which a parallel view has not");
            relief::Represented& surface = surfaces.emplace_back();
            surface.settings = object.settings, surface.capture = object.capture, surface.ball = object.ball;
        }
        objects.push_back(refusal ? &surfaces.back() : &object);
    }
    drawn.rendering = raster::render(scene, loaded.settings, frame, workspace, workers);
    for (const relief::Represented* object : objects)
        if (const auto error = relief::draw_represented(*object, scene, loaded.settings, frame))
            return io::FileError{{loaded.path, 0, 0}, error->message};
    return drawn;
}

}  // namespace relevo::scene
