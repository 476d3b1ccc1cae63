#include "relief/offset_map.hpp"

#include <gtest/gtest.h>

#include <limits>

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

// A map by hand: red to the left, blue to the right, a jump of depth between them, an empty column of
// nonsense.
struct ByHand {
    ReliefTexture texture;
    Prewarped picture;
};
ByHand by_hand(const std::vector<Vec2>& places) {
    ByHand made{make_relief_texture(*orthographic_camera({{0, 0, -1}, {0, 1, 0}, 5, 1}, {0, 0, 0}, 1)), {}};
    constexpr Scalar nonsense = std::numeric_limits<Scalar>::quiet_NaN();
    for (int x = 0; x < 5; ++x) {
        made.texture.coverage.at(x, 0) = x != 4;
        made.texture.depth.at(x, 0) = x < 2 ? 0 : x < 4 ? Scalar(0.5) : nonsense;
        made.texture.color.at(x, 0) = x < 2   ? LinearRgb{Scalar(x + 1), 0, 0}
                                      : x < 4 ? LinearRgb{0, 0, 1}
                                              : LinearRgb{nonsense, nonsense, nonsense};
    }
    const int count = static_cast<int>(places.size());
    made.picture.window = {0, 0, count, 1};
    made.picture.coverage = Image<std::uint8_t>(count, 1, 1);
    made.picture.source = Image<Vec2>(count, 1);
    for (int x = 0; x < count; ++x) made.picture.source.at(x, 0) = places[std::size_t(x)];
    return made;
}

TEST(OffsetMap, MixesWhatBelongsTogetherAndNothingElse) {
    const Scalar half = Scalar(0.5);
    ByHand made = by_hand(
        {{1, half}, {Scalar(1.75), half}, {Scalar(2.25), half}, {Scalar(3.75), half}, {Scalar(4.5), half}});
    const auto fetched = [&](Reading reading, Scalar jump) {
        return fetch_by_map(made.picture, made.texture, made.texture.color, reading, jump);
    };
    const auto color = fetched(Reading::Bilinear, Scalar(0.1));
    EXPECT_EQ(color.at(0, 0), (LinearRgb{Scalar(1.5), 0, 0}));
    EXPECT_EQ(color.at(1, 0), (LinearRgb{2, 0, 0}));  // not across the jump
    EXPECT_EQ(color.at(2, 0), (LinearRgb{0, 0, 1}));
    EXPECT_EQ(color.at(3, 0), (LinearRgb{0, 0, 1}));  // nothing of the empty column
    EXPECT_EQ(color.at(4, 0), LinearRgb{});
    const auto across = fetched(Reading::Bilinear, 1), nearest = fetched(Reading::Nearest, Scalar(0.1));
    EXPECT_EQ(across.at(1, 0), (LinearRgb{Scalar(1.5), 0, Scalar(0.25)}));
    EXPECT_EQ(nearest.at(0, 0), (LinearRgb{2, 0, 0}));
}

TEST(OffsetMap, WhereNothingIsSeenNothingIsFetched) {
    ByHand made = by_hand({{Scalar(0.5), Scalar(0.5)}, {Scalar(1.5), Scalar(0.5)}});
    made.picture.coverage.at(1, 0) = 0;  // what a former warp left there means nothing
    const auto color = fetch_by_map(made.picture, made.texture, made.texture.color);
    EXPECT_EQ(color.at(0, 0), (LinearRgb{1, 0, 0}));
    EXPECT_EQ(color.at(1, 0), LinearRgb{});
}

}  // namespace
}  // namespace relevo::relief
