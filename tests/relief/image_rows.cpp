#include "tests/relief/image_rows.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "relief/capture_raster.hpp"
#include "relief/inverse_slices.hpp"
#include "relief/inverse_view.hpp"
#include "relief/map_plane.hpp"
#include "relief/sprite.hpp"
#include "relief/sprite_with_depth.hpp"
#include "relief/surface_checker_cube.hpp"
#include "relief/surface_plane_step.hpp"
#include "samples/io/obj.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/relief/image_asked.hpp"
#include "tests/relief/image_experiment.hpp"

namespace relevo::tests {
namespace {

using namespace relief;

// ---------------------------------------------------------------------------------------------------- the
// scenes
struct Experiment {
    ReliefTexture texture;
    ReliefCamera viewer;
    ViewImage truth;
};
template <class Surface>
Experiment analytic(const Surface& surface, const ReliefCamera& source, const ReliefCamera& viewer) {
    return {ray_cast(surface, source), viewer, ray_cast_view(surface, viewer)};
}

// Half a turn about y.
ReliefCamera turned(ReliefCamera camera) {
    for (glm::dvec3* const v : {&camera.corner, &camera.a, &camera.b, &camera.eye})
        v->x = -v->x, v->z = -v->z;
    return camera;
}

// A mesh that fills the ball of radius 1 round the origin; its points have the colours of the balls.
struct Painted {
    std::vector<io::ObjPart> parts;
    raster::Scene scene;
};
std::optional<Painted> bunny() {
    auto parts = io::read_obj("/usr/share/glmark2/models/bunny.obj");
    if (!parts) return {};
    std::optional<Painted> painted(Painted{*std::move(parts), {}});
    constexpr double infinity = std::numeric_limits<double>::infinity();
    glm::dvec3 low(infinity), high(-infinity);
    for (const io::ObjPart& part : painted->parts)
        for (const pipeline::Vertex& v : part.mesh.vertices)
            low = glm::min(low, glm::dvec3(v.position.v)), high = glm::max(high, glm::dvec3(v.position.v));
    const glm::dvec3 middle = 0.5 * (low + high);
    double farthest = 0;
    for (const io::ObjPart& part : painted->parts)
        for (const pipeline::Vertex& v : part.mesh.vertices) {
            const glm::dvec3 from = glm::dvec3(v.position.v) - middle;
            farthest = std::max(farthest, glm::dot(from, from));
        }
    const double scale = 1 / std::sqrt(farthest);
    for (const io::ObjPart& part : painted->parts) {
        raster::Model& model = painted->scene.models.emplace_back();
        model.mesh = &part.mesh;
        for (int k = 0; k < 3; ++k) {
            model.world_from_object.m[k][k] = scale;
            model.world_from_object.m[3][k] = -scale * middle[k];
        }
    }
    return painted;
}
ReliefTexture captured(const Painted& painted, const ReliefCamera& camera) {
    ReliefTexture texture = *capture_raster(painted.scene, camera);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            if (texture.coverage.at(x, y)) texture.color.at(x, y) = wave_color(world_point(texture, x, y));
    return texture;
}

std::optional<Experiment> experiment(std::string_view scene, double azimuth) {
    const ReliefCamera source = experiment_source(), viewer = experiment_viewer(azimuth);
    if (scene == "sphere") return analytic(scene::sphere_object, source, viewer);
    if (scene == "bumpy") return analytic(scene::bumpy_object, source, viewer);
    if (scene == "complex") return analytic(scene::complex_object, source, viewer);
    if (scene == "checker_cube") return analytic(CheckerCube{}, source, viewer);
    if (scene == "plane_step") return analytic(PlaneStep{}, turned(source), turned(viewer));
    static const std::optional<Painted> painted = bunny();
    if (!painted) return {};
    constexpr int times = 4;  // 16 samples
    return Experiment{captured(*painted, turned(source)), turned(viewer),
                      reduced(as_seen(captured(*painted, refined(turned(viewer), times))), times)};
}

}  // namespace

bool met(const ImageRow& row) {
    const auto at_most = [](double got, double asked, double slack) { return got <= 1.05 * asked + slack; };
    const ErrorSet &e = row.error, &a = row.asked;
    return e.psnr >= a.psnr - 0.1 && at_most(e.missing_percent, a.missing_percent, 0.1) &&
           at_most(e.extra_percent, a.extra_percent, 0.1) && at_most(e.bad_percent, a.bad_percent, 0.1) &&
           at_most(e.mean_depth_error, a.mean_depth_error, 2e-4);
}

std::vector<ImageRow> image_rows(std::string_view scene, double azimuth) {
    const auto e = experiment(scene, azimuth);
    if (!e) return {};
    const auto asked = std::find_if(std::begin(all_asked), std::end(all_asked),
                                    [&](const Asked& a) { return a.scene == scene && a.azimuth == azimuth; });
    std::vector<ImageRow> rows;
    const auto add = [&](const ErrorSet& error) {
        const std::size_t i = rows.size();
        rows.push_back({image_ways[i],
                        error,
                        {asked->missing[i], asked->extra[i], asked->least[i], asked->depth[i], asked->bad[i]},
                        i < asked->by_design});
    };
    const Warp warp = *make_warp(e->texture.camera, viewer_at(e->viewer.eye));
    const Window window = *target_window(e->texture.camera, warp, depth_range(e->texture));
    // The warped picture is read bilinearly across jumps of up to 0.3.
    const auto warped = [&](const Prewarped& picture) {
        add(error_set(map_plane(picture, e->texture.camera, warp, e->viewer, Reading::Bilinear, Scalar(0.3)),
                      e->truth));
    };
    add(error_set(*draw_sprite(e->texture, e->viewer, Reading::Nearest), e->truth));
    for (const auto& [resampler, jump] : {std::pair(Resampler::OneDimensional, Jump::Skin),
                                          {Resampler::Asymmetric, Jump::Skin},
                                          {Resampler::Compensated, Jump::Skin},
                                          {Resampler::Interleaved, Jump::Skin},
                                          {Resampler::Interleaved, Jump::Cut},
                                          {Resampler::Mesh, Jump::Skin}})
        warped(prewarp(e->texture, warp, window, {.resampler = resampler, .jump = jump}));
    warped(warp_sprite_with_depth(e->texture, warp, window));
    ReliefSolid solid = solid_of_thickness(e->texture, 0.2);
    solid.reading = Reading::Bilinear;
    add(error_set(*inverse_view(e->texture, solid, e->viewer,
                                [&](const ReliefRay& ray) {
                                    return find_by_slices(solid, ray, {64, 6});
                                }),
                  e->truth));
    return rows;
}

}  // namespace relevo::tests
