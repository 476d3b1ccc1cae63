// The image experiment, every resampler beside the sprite and the inverse: PSNR over the union of both
// silhouettes, dB. A row fails where a figure that the design asks for is missed by more than 0.1 dB.
#include "tests/relief/image_experiment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "relief/inverse_slices.hpp"
#include "relief/inverse_view.hpp"
#include "relief/map_plane.hpp"
#include "relief/sprite.hpp"
#include "relief/sprite_with_depth.hpp"
#include "relief/surface_checker_cube.hpp"
#include "relief/surface_plane_step.hpp"
#include "samples/scene/shapes/spheres.hpp"

namespace relevo::relief {
namespace {

constexpr double first = 0;  // nothing is asked for: the first figure

// sprite (nearest texels), 1-D, asymmetric, compensated, interleaved, interleaved cut, mesh
struct Required {
    double sprite, one_dimensional, asymmetric, compensated, interleaved, cut, mesh;
};

struct Experiment {
    ReliefTexture texture;
    ReliefCamera viewer;
    ViewImage truth;
    Warp warp;
    Window window;
};
template <class Surface>
Experiment experiment(const Surface& surface, double azimuth) {
    Experiment e;
    e.texture = ray_cast(surface, tests::experiment_source());
    e.viewer = tests::experiment_viewer(azimuth);
    e.truth = ray_cast_view(surface, e.viewer);
    e.warp = *make_warp(e.texture.camera, viewer_at(e.viewer.eye));
    e.window = *target_window(e.texture.camera, e.warp, depth_range(e.texture));
    return e;
}
// The warped picture is read bilinearly across jumps of up to 0.3.
ErrorSet error_of(const Experiment& e, const Prewarped& picture) {
    return error_set(map_plane(picture, e.texture.camera, e.warp, e.viewer, Reading::Bilinear, Scalar(0.3)),
                     e.truth);
}

template <class Surface>
void check(const char* name, const Surface& surface, double azimuth, const Required& required) {
    const Experiment e = experiment(surface, azimuth);
    const auto say = [&](const char* how, const ErrorSet& error, double least) {
        std::printf(
            "%-12s %2.0f  %-18s %6.2f dB (%5.2f)  missing %5.2f %%  extra %5.2f  depth %.4f  bad %5.2f %%\n",
            name, azimuth, how, error.psnr, least, error.missing_percent, error.extra_percent,
            error.mean_depth_error, error.bad_percent);
        EXPECT_GE(error.psnr, least - 0.1) << name << ' ' << azimuth << ' ' << how;
    };
    say("sprite", error_set(*draw_sprite(e.texture, e.viewer, Reading::Nearest), e.truth), required.sprite);
    const auto warped = [&](const char* how, const PrewarpSettings& settings, double least) {
        say(how, error_of(e, prewarp(e.texture, e.warp, e.window, settings)), least);
    };
    warped("1-D", {.resampler = Resampler::OneDimensional}, required.one_dimensional);
    warped("asymmetric", {.resampler = Resampler::Asymmetric}, required.asymmetric);
    warped("compensated", {.resampler = Resampler::Compensated}, required.compensated);
    warped("interleaved", {.resampler = Resampler::Interleaved}, required.interleaved);
    warped("interleaved, cut", {.resampler = Resampler::Interleaved, .jump = Jump::Cut}, required.cut);
    warped("mesh", {.resampler = Resampler::Mesh}, required.mesh);
    say("sprite with depth", error_of(e, warp_sprite_with_depth(e.texture, e.warp, e.window)), first);
    ReliefSolid solid = solid_of_thickness(e.texture, 0.2);
    solid.reading = Reading::Bilinear;
    say("inverse 64+6",
        error_set(*inverse_view(e.texture, solid, e.viewer,
                                [&](const ReliefRay& ray) {
                                    return find_by_slices(solid, ray, {64, 6});
                                }),
                  e.truth),
        first);
}

TEST(ImageExperiment, Sphere) {
    check("sphere", scene::sphere_object, 0, {7.57, 27.73, 27.73, 27.73, 27.73, 27.73, 27.82});
    check("sphere", scene::sphere_object, 10, {});
    check("sphere", scene::sphere_object, 25, {6.95, 22.61, 22.61, 22.61, 22.61, 22.51, 21.66});
    check("sphere", scene::sphere_object, 40, {4.92, 15.08, 15.09, 15.09, 15.11, 15.06, 14.76});
}
TEST(ImageExperiment, Bumpy) {
    check("bumpy", scene::bumpy_object, 0, {});
    check("bumpy", scene::bumpy_object, 10, {6.75, 25.21, 25.21, 25.21, 25.20, 24.93, 25.79});
    check("bumpy", scene::bumpy_object, 25, {5.49, 19.31, 19.32, 19.32, 19.37, 16.56, 18.85});
    check("bumpy", scene::bumpy_object, 40, {});
}
TEST(ImageExperiment, Complex) {
    check("complex", scene::complex_object, 0, {5.52, 16.48, 16.44, 16.44, 16.50, 14.19, 16.10});
    check("complex", scene::complex_object, 10, {});
    check("complex", scene::complex_object, 25, {4.56, 11.48, 11.42, 11.42, 11.54, 10.94, 11.48});
    check("complex", scene::complex_object, 40, {});
}
TEST(ImageExperiment, CheckerCube) {
    for (const double azimuth : {0.0, 10.0, 25.0, 40.0}) check("checker_cube", CheckerCube{}, azimuth, {});
}

}  // namespace
}  // namespace relevo::relief
