#include "relief/offset_map.hpp"

#include <gtest/gtest.h>

#include "relief/error_set.hpp"
#include "relief/ray_cast.hpp"
#include "relief/surface_spheres.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/relief/image_experiment.hpp"

namespace relevo::relief {
namespace {

Prewarped warped(const ReliefTexture& texture, Resampler resampler) {
    const Warp warp = *make_warp(texture.camera, viewer_at(tests::experiment_viewer(25).eye));
    PrewarpSettings settings;
    settings.resampler = resampler, settings.maps = true;
    return prewarp(texture, warp, *target_window(texture.camera, warp, depth_range(texture)), settings);
}

// What a mirror-like surface would show: another channel, made after the warp's settings are forgotten.
Image<LinearRgb> reflections(const ReliefTexture& texture) {
    Image<LinearRgb> image(texture.camera.width, texture.camera.height);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Vec3& n = texture.normal.at(x, y);
            image.at(x, y) = {n.x * n.z, n.y * n.y, 1 - n.z};
        }
    return image;
}

TEST(OffsetMap, OfSplatsIsTheDirectWarpToTheBitForEveryChannel) {
    ReliefTexture texture = ray_cast(scene::bumpy_object, tests::experiment_source(128));
    const Prewarped picture = warped(texture, Resampler::Splat);
    const Image<LinearRgb> mirror = reflections(texture);
    ReliefTexture mirrored = texture;
    mirrored.color = mirror;
    const Prewarped direct = warped(mirrored, Resampler::Splat);
    for (const Reading reading : {Reading::Nearest, Reading::Bilinear}) {
        const auto color = fetch_by_map(picture, texture, texture.color, reading),
                   reflection = fetch_by_map(picture, texture, mirror, reading);
        const auto normal = fetch_by_map(picture, texture, texture.normal, reading);
        int seen = 0;
        for (int y = 0; y < color.height(); ++y)
            for (int x = 0; x < color.width(); ++x) {
                if (!picture.coverage.at(x, y)) continue;
                ++seen;
                ASSERT_EQ(color.at(x, y), picture.color.at(x, y));
                ASSERT_EQ(normal.at(x, y), picture.normal.at(x, y));
                ASSERT_EQ(reflection.at(x, y), direct.color.at(x, y));
            }
        EXPECT_GT(seen, 2000);
    }
}

TEST(OffsetMap, OfAnInterpolatedPictureIsNearlyTheDirectWarp) {
    const ReliefTexture texture = ray_cast(scene::sphere_object, tests::experiment_source(256));
    for (const Resampler resampler : {Resampler::Interleaved, Resampler::Asymmetric, Resampler::Mesh}) {
        const Prewarped picture = warped(texture, resampler);
        const auto color = fetch_by_map(picture, texture, texture.color);
        int seen = 0, off = 0;
        for (int y = 0; y < color.height(); ++y)
            for (int x = 0; x < color.width(); ++x) {
                if (!picture.coverage.at(x, y)) continue;
                ++seen;
                off += mean_square_difference(color.at(x, y), picture.color.at(x, y)) > 0.01 * 0.01;
            }
        std::printf("%d of %d pixels more than 0.01 off\n", off, seen);
        EXPECT_LE(off, seen / 50);
    }
}

}  // namespace
}  // namespace relevo::relief
