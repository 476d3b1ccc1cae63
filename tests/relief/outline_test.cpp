// Where a surface ends: the half texels that stick out of it (relief/resample_line.hpp, relief/prepare.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "relief/prewarp.hpp"
#include "relief/ray_cast.hpp"
#include "relief/resample_line.hpp"
#include "relief/surface_plane_step.hpp"

namespace relevo::relief {
namespace {

TEST(Outline, ARoundEndIsFoundFromThreeTexels) {
    for (const double c : {0.01, 0.3, 2.0})
        for (const double s : {0.02, 0.1, 0.3, 0.5, 0.7, 0.99}) {
            const auto depth = [&](double texels) {
                return static_cast<Scalar>(c * (2 - std::sqrt(texels)));
            };
            // up to the end, or half a texel on where that is less
            const double right = c * (std::sqrt(s) - std::sqrt(std::max(s - 0.5, 0.0)));
            EXPECT_NEAR(growth_beyond(depth(s), depth(s + 1), depth(s + 2)), right, 2e-3 * c)
                << c << ' ' << s;
        }
}

TEST(Outline, APlaneGoesOnAndNothingRises) {
    EXPECT_EQ(growth_beyond(Scalar(1.5), Scalar(1), Scalar(0.5)), Scalar(0.25));
    EXPECT_EQ(growth_beyond(Scalar(1.5), Scalar(1), std::nullopt), Scalar(0.25));
    EXPECT_EQ(growth_beyond(Scalar(1.25), Scalar(1), Scalar(0.5)), Scalar(0.125));  // flattening
    EXPECT_EQ(growth_beyond(Scalar(0.5), Scalar(1), Scalar(1.5)), 0);
    EXPECT_EQ(growth_beyond(Scalar(1.5), Scalar(1), Scalar(1.1)), 0);
}

// A cylinder whose axis is a little askew to the columns: of one row the last texel lies just before the
// outline, of the next nearly a texel. Seen from aside its outline is straight all the same.
TEST(Outline, ASteepOutlineDoesNotFray) {
    constexpr int size = 160;
    constexpr double radius = 40, texel = 2.0 / size;
    const ReliefCamera camera = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, size, size}, {0, 0, 1}, 2);
    const auto axis = [](int y) { return 80 + 0.13 * (y + 0.5 - size / 2); };
    ReliefTexture texture = make_relief_texture(camera);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double away = x + 0.5 - axis(y), inside = radius * radius - away * away;
            if (inside < 0) continue;
            texture.coverage.at(x, y) = 1;
            texture.depth.at(x, y) = static_cast<Scalar>(texel * (radius - std::sqrt(inside)));
            texture.color.at(x, y) = {1, 1, 1};
        }
    // a viewer at infinity: the picture is sheared, u_i = u + k1 d
    const Warp warp = *make_warp(camera, viewer_toward({0.8, 0, 0.6}));
    const Window window = *target_window(camera, warp, depth_range(texture));
    for (const Jump jump : {Jump::Skin, Jump::Cut})
        for (const Resampler resampler : {Resampler::Asymmetric, Resampler::Interleaved, Resampler::Mesh}) {
            const PrewarpSettings settings{.resampler = resampler, .jump = jump, .jump_depth = Scalar(0.1)};
            const Prewarped picture = prewarp(texture, warp, window, settings);
            double worst = 0;
            for (int y = 10; y < size - 10; ++y) {
                int end = 0;
                for (int x = 0; x < window.width; ++x)
                    if (picture.coverage.at(x, y - window.y0)) end = x + 1;
                const double right = axis(y) + radius + warp.k1 * texel * radius;
                worst = std::max(worst, std::abs(end + window.x0 - right));
            }
            EXPECT_LE(worst, 3) << int(resampler) << ' ' << int(jump);
        }
}

// A skin over a step is seen from the side that the step faces, and from there only: from behind it folds
// back, hidden by the higher plate, and is not drawn at all.
TEST(FoldedSkin, IsNotDrawn) {
    const PlaneStep plane{0.5};
    const ReliefCamera camera = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 96, 96}, {0, 0, 1}, 2);
    const ReliefTexture texture = ray_cast(plane, camera);
    for (const Resampler resampler :
         {Resampler::OneDimensional, Resampler::Asymmetric, Resampler::Compensated, Resampler::Interleaved}) {
        const auto across = [&](double x) {
            const Warp warp = *make_warp(camera, viewer_at({x, 0.3, 4}));
            const Window window = *target_window(camera, warp, depth_range(texture));
            PrewarpSettings settings;
            settings.resampler = resampler, settings.maps = true;
            const Prewarped picture = prewarp(texture, warp, window, settings);
            const auto& kinds = picture.kind.pixels();
            return std::count(kinds.begin(), kinds.end(), Kind::FilledAcross);
        };
        EXPECT_GT(across(-2), 500) << int(resampler);  // some ten pixels wide in 90 rows
        EXPECT_EQ(across(2), 0) << int(resampler);
    }
}

}  // namespace
}  // namespace relevo::relief
