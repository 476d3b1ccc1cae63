#include "relief/window.hpp"

#include <gtest/gtest.h>

#include "tests/relief/random_source.hpp"

namespace relevo::relief {
namespace {

namespace hard = tests::hard;

ReliefTexture random_texture(hard::Random& r, Projection projection) {
    ReliefTexture texture = make_relief_texture(random::source(r, projection));
    for (std::size_t i = 0; i < texture.depth.pixels().size(); ++i) {
        texture.coverage.pixels()[i] = r.coin();
        texture.depth.pixels()[i] = projection == Projection::Orthographic ? random::displacement(r).value
                                                                           : random::disparity(r).value;
    }
    return texture;
}

// By hand: 256 texels, epipole at 456 = 200 beyond the right border, h = d_max = 1: half of the way.
TEST(Window, ReachesTowardsTheViewerAsTheFormulaSays) {
    const ReliefCamera camera = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 256, 256}, {0, 0, 0}, 2);
    const Warp warp = *make_warp(camera, viewer_at(plane_point(camera, 456, 100) + glm::dvec3(0, 0, 1)));
    EXPECT_EQ(*target_window(camera, warp, {0, 1, false}), (Window{0, 0, 356, 256}));
    EXPECT_EQ(*target_window(camera, warp, {0, 0, true}), source_window(camera));
}

TEST(Window, HoldsEveryWarpedTexelAndTouchesNoneInVain) {
    hard::Random r(1);
    for (int i = 0; i < 200; ++i) {
        const ReliefTexture texture =
            random_texture(r, i % 2 ? Projection::Orthographic : Projection::Perspective);
        const ReliefCamera& camera = texture.camera;
        const Warp warp =
            *make_warp(camera, viewer_at(random::viewer_place(r, camera, r.between(0.5, 5), 5)));
        const auto window = target_window(camera, warp, depth_range(texture));
        if (!window) continue;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) {
                if (!texture.coverage.at(x, y)) continue;
                const WarpedPoint p = warp_texel(warp, texture, x, y);
                ASSERT_GE(p.u, window->x0);
                ASSERT_LE(p.u, window->x0 + window->width);
                ASSERT_GE(p.v, window->y0);
                ASSERT_LE(p.v, window->y0 + window->height);
            }
        EXPECT_LE(window->x0, 0);
        EXPECT_GE(window->x0 + window->width, camera.width);
    }
}

TEST(Window, AViewThatIsTooNearlyEdgeOnIsRefused) {
    const ReliefCamera camera = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 256, 256}, {0, 0, 0}, 2);
    const Warp warp = *make_warp(camera, viewer_at(plane_point(camera, 1e9, 100) + glm::dvec3(0, 0, 1)));
    const auto window = target_window(camera, warp, {0, 1, false});
    ASSERT_FALSE(window);
    EXPECT_NE(window.error().message.find("too close"), std::string::npos);
}

}  // namespace
}  // namespace relevo::relief
