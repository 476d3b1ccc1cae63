#include "tests/golden/relief/subject.hpp"

#include <algorithm>

#include "relief/ray_cast.hpp"
#include "relief/surface_checker_cube.hpp"
#include "relief/surface_plane_step.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/golden/relief/plain.hpp"
#include "tests/relief/image_experiment.hpp"

namespace relevo::golden {
namespace {

using namespace relief;

template <class Surface>
void show(ReliefSubject& s, const Surface& surface) {
    s.capture = [surface](const ReliefCamera& camera) { return ray_cast(surface, camera); };
    s.truth = [surface](const ReliefCamera& screen, int samples) {
        return ray_cast_view(surface, screen, samples);
    };
}

}  // namespace

ReliefSubject relief_subject(std::string_view scene, double azimuth, bool perspective, int texels,
                             const ReliefMistake& mistake) {
    ReliefSubject s;
    s.scene = scene, s.perspective = perspective, s.mistake = &mistake;
    if (scene == "sphere") show(s, scene::sphere_object);
    if (scene == "bumpy") show(s, scene::bumpy_object);
    if (scene == "complex") show(s, scene::complex_object);
    if (scene == "checker_cube") show(s, CheckerCube{});
    if (scene == "plane_step") show(s, PlaneStep{});
    assert(s.capture);
    s.screen = tests::experiment_viewer(azimuth, 2 * texels);
    ReliefCamera source = tests::experiment_source(texels);
    if (perspective)
        source = *perspective_camera({{0, 0, 1}, {0, 1, 0}, texels, texels}, {0, 0, -3}, 2, {40});
    if (scene == "plane_step") {  // it shows its face to +z, its riser to -x
        source = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, texels, texels}, {0, 0, 1}, 2);
        const glm::dvec3 eye(-s.screen.eye.x, s.screen.eye.y, -s.screen.eye.z);
        s.screen = *perspective_camera({-eye, {0, 1, 0}, 2 * texels, 2 * texels}, eye, 1, {45});
    }
    if (mistake.to_source) mistake.to_source(source);
    s.texture = s.capture(source);
    if (mistake.to_texture) mistake.to_texture(s.texture);
    s.warp = *make_warp(s.texture.camera, viewer_at(s.screen.eye));
    s.window = *target_window(s.texture.camera, s.warp, depth_range(s.texture));
    if (mistake.to_warp) mistake.to_warp(s.warp);
    s.settings.maps = true;
    if (mistake.to_settings) mistake.to_settings(s.settings);
    return s;
}

namespace {

template <class Pixel>
void cut_to(const Window& square, const Window& window, Image<Pixel>& image) {
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const int u = x + window.x0 - square.x0, v = y + window.y0 - square.y0;
            if (u < 0 || v < 0 || u >= square.width || v >= square.height) image.at(x, y) = Pixel{};
        }
}

}  // namespace

Prewarped warped_picture(const ReliefSubject& s, Resampler resampler) {
    PrewarpSettings settings = s.settings;
    settings.resampler = resampler;
    const ReliefRules& rules = s.mistake->rules;
    Prewarped picture = rules.plain ? plain_prewarp(s.texture, s.warp, s.window, settings, rules)
                                    : prewarp(s.texture, s.warp, s.window, settings);
    if (s.mistake->clipped) {
        const Window square = source_window(s.texture.camera);
        cut_to(square, s.window, picture.coverage), cut_to(square, s.window, picture.kind);
        cut_to(square, s.window, picture.writes);
    }
    if (s.mistake->to_picture) s.mistake->to_picture(picture, s.warp);
    return picture;
}

}  // namespace relevo::golden
