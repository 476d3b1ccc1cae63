// What relief textures are compared with: sprites, sprites with depth, layered depth images.
#include <gtest/gtest.h>

#include <cmath>

#include "relief/layered_depth_image.hpp"
#include "relief/sprite.hpp"
#include "relief/sprite_with_depth.hpp"
#include "relief/surface_plane_step.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/relief/image_experiment.hpp"

namespace relevo::relief {
namespace {

using tests::experiment_source;
using tests::experiment_viewer;

// Everything lies on the source's plane.
ReliefTexture flat() {
    return ray_cast(PlaneStep{1e-9}, *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 64, 64}, {0, 0, 0}, 2));
}
ReliefCamera viewer_before_flat() {
    return *perspective_camera({{-1, -0.5, -2}, {0, 1, 0}, 128, 128}, {1.6, 0.8, 3.2}, 1, {45});
}

TEST(Sprite, IsRightWhereEverythingLiesOnThePlane) {
    const ReliefCamera viewer = viewer_before_flat();
    const ErrorSet error = error_set(*draw_sprite(flat(), viewer), ray_cast_view(PlaneStep{1e-9}, viewer));
    EXPECT_LT(error.missing_percent, 0.2);
    EXPECT_LT(error.extra_percent, 0.2);
    EXPECT_LT(error.mean_depth_error, 1e-6);
}

TEST(Sprite, IsRefusedFromBehind) {
    EXPECT_FALSE(draw_sprite(flat(), *perspective_camera({{0, 0, 1}, {0, 1, 0}, 8, 8}, {0, 0, -3}, 1, {45})));
}

TEST(SpriteWithDepth, CopiesWhatLiesOnThePlane) {
    const ReliefTexture texture = flat();
    const Warp warp = *make_warp(texture.camera, viewer_at(viewer_before_flat().eye));
    const Prewarped picture = warp_sprite_with_depth(texture, warp, source_window(texture.camera));
    EXPECT_EQ(picture.coverage.pixels(), texture.coverage.pixels());
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            EXPECT_NEAR(picture.color.at(x, y).r, texture.color.at(x, y).r, 1e-6);
            EXPECT_LT(glm::length(picture.normal.at(x, y) - texture.normal.at(x, y)), 1e-6);
        }
}

TEST(SpriteWithDepth, IsNearTheWarpAndFarFromTheSprite) {
    const ReliefTexture texture = ray_cast(scene::bumpy_object, experiment_source(128));
    const ReliefCamera viewer = experiment_viewer(10, 256);
    const Warp warp = *make_warp(texture.camera, viewer_at(viewer.eye));
    const Window window = *target_window(texture.camera, warp, depth_range(texture));
    const ViewImage truth = ray_cast_view(scene::bumpy_object, viewer);
    const auto psnr = [&](const Prewarped& picture) {
        return error_set(map_plane(picture, texture.camera, warp, viewer), truth).psnr;
    };
    const double sprite = psnr(unwarped(texture)),
                 with_depth = psnr(warp_sprite_with_depth(texture, warp, window)),
                 relief = psnr(prewarp(texture, warp, window));
    std::printf("bumpy 10 degrees: sprite %.2f dB, with depth %.2f, relief %.2f\n", sprite, with_depth,
                relief);
    EXPECT_GT(with_depth, sprite + 10);
    EXPECT_GT(with_depth, relief - 5);
}

TEST(SpriteWithDepth, FillsTheHolesOfItsFirstPass) {
    // From near by, a slanted surface is stretched: splats leave holes.
    const ReliefTexture texture = ray_cast(scene::sphere_object, experiment_source(128));
    const Warp warp = *make_warp(texture.camera, viewer_at({1.5, 0.5, -2.2}));
    const Window window = *target_window(texture.camera, warp, depth_range(texture));
    const auto holes = [&](const Prewarped& picture) {  // empty between two covered ones
        int count = 0;
        for (int y = 0; y < window.height; ++y)
            for (int x = 1; x + 1 < window.width; ++x)
                count += !picture.coverage.at(x, y) && picture.coverage.at(x - 1, y) &&
                         picture.coverage.at(x + 1, y);
        return count;
    };
    const int before = holes(prewarp(texture, warp, window, {.resampler = Resampler::Splat}));
    EXPECT_GT(before, 100);
    EXPECT_LT(holes(warp_sprite_with_depth(texture, warp, window)), before / 20);
}

TEST(LayeredDepthImage, EachLayerLiesBehindTheLast) {
    const ReliefCamera source = experiment_source(96);
    const auto layers = ray_cast_layers(scene::complex_object, source, 4);
    const ReliefTexture first = ray_cast(scene::complex_object, source);
    EXPECT_EQ(layers[0].depth.pixels(), first.depth.pixels());
    EXPECT_EQ(layers[0].coverage.pixels(), first.coverage.pixels());
    int covered[4] = {0, 0, 0, 0}, backs = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x)
            for (std::size_t k = 0; k < 4; ++k) {
                if (!layers[k].coverage.at(x, y)) continue;
                ++covered[k];
                const double away = glm::dot(glm::dvec3(layers[k].normal.at(x, y)), forward(source));
                backs += away > 0;
                if (k == 0) {
                    EXPECT_LT(away, 0);
                    continue;
                }
                EXPECT_TRUE(layers[k - 1].coverage.at(x, y));
                EXPECT_GT(layers[k].depth.at(x, y), layers[k - 1].depth.at(x, y));
            }
    EXPECT_EQ(covered[0], covered[1]);  // whoever goes into a ball comes out
    EXPECT_TRUE(covered[1] > covered[2] && covered[2] == covered[3] && covered[3] > 500);
    EXPECT_NEAR(backs, covered[1] + covered[3], 0.05 * backs);  // in, out, in, out, but where balls overlap
}

TEST(LayeredDepthImage, MoreLayersLeaveLessMissing) {
    const auto all = ray_cast_layers(scene::complex_object, experiment_source(256), 8);
    for (const double azimuth : {0.0, 25.0}) {
        const ReliefCamera viewer = experiment_viewer(azimuth, 256);
        const ViewImage truth = ray_cast_view(scene::complex_object, viewer);
        double missing[9];
        for (std::size_t layers = 1; layers <= 8; layers = layers < 4 ? layers + 1 : layers + 2) {
            const std::vector<ReliefTexture> some(all.begin(), all.begin() + std::ptrdiff_t(layers));
            const ErrorSet error = error_set(draw_layers(some, viewer, 0.1), truth);
            missing[layers] = error.missing_percent;
            std::printf("complex %2.0f degrees, %zu layers: missing %.2f %%, extra %.2f %%, PSNR %.2f dB\n",
                        azimuth, layers, error.missing_percent, error.extra_percent, error.psnr);
        }
        EXPECT_GT(missing[1], 5);
        EXPECT_LT(missing[4], 2);
        EXPECT_LT(missing[6], 0.5);
    }
}

// Front and back of a body meet at its outline: from no side does one see into a ball, or past its rim, and
// its outline is finer than the texels.
TEST(LayeredDepthImage, ABallIsClosedFromAllSides) {
    constexpr int texels = 64;
    const ReliefCamera parallel = experiment_source(texels),
                       from_an_eye = *perspective_camera({{0, 0, 1}, {0, 1, 0}, texels, texels}, {0, 0, -4},
                                                         3, {2 * 15});
    for (const ReliefCamera& source : {parallel, from_an_eye}) {
        const auto layers = ray_cast_layers(scene::sphere_object, source, 2);
        for (const double azimuth : {0.0, 25.0, 60.0, 90.0, 150.0, 180.0}) {
            const ReliefCamera viewer = experiment_viewer(azimuth, 256);
            const ErrorSet error =
                error_set(draw_layers(layers, viewer, 0.5), ray_cast_view(scene::sphere_object, viewer));
            EXPECT_LT(error.missing_percent, 0.5) << azimuth;
            EXPECT_LT(error.extra_percent, 0.1) << azimuth;
            EXPECT_LT(error.mean_depth_error, 0.005) << azimuth;
        }
    }
}

// Where a ball hides a part of another, the other's surface goes on in a deeper layer: without a seam.
TEST(LayeredDepthImage, SurfacesGoOnFromLayerToLayer) {
    const auto layers = ray_cast_layers(scene::complex_object, experiment_source(256), 6);
    for (const double azimuth : {0.0, 25.0, 40.0}) {
        const ReliefCamera viewer = experiment_viewer(azimuth, 256);
        const ErrorSet error =
            error_set(draw_layers(layers, viewer, 0.1), ray_cast_view(scene::complex_object, viewer));
        EXPECT_GT(error.psnr, 26) << azimuth;  // with the seams and open rims: 20, 19 and 17
        EXPECT_LT(error.bad_percent, 0.8) << azimuth;
        EXPECT_LT(error.extra_percent, 0.1) << azimuth;
    }
}

}  // namespace
}  // namespace relevo::relief
