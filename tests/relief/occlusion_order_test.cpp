#include "relief/occlusion_order.hpp"

#include <gtest/gtest.h>

#include <set>

#include "relief/prewarp.hpp"
#include "relief/ray_cast.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/relief/random_source.hpp"

namespace relevo::relief {
namespace {

namespace hard = tests::hard;

TEST(OcclusionOrder, EveryTexelOnceAndMonotoneInTheDistanceFromTheEpipole) {
    hard::Random r(1);
    for (int i = 0; i < 200; ++i) {
        const int width = int(r.integer(1, 12)), height = int(r.integer(1, 12));
        const OcclusionOrder order{r.between(-3, 15),
                                   r.coin() ? double(r.integer(0, 12)) + 0.5 : r.between(-3, 15), r.coin()};
        std::set<std::pair<int, int>> seen;
        // of two texels of a row on one side of the epipole, the nearer to it comes later
        std::vector<std::pair<int, int>> visited;
        for_each_in_order(order, width, height, [&](int x, int y) {
            EXPECT_TRUE(seen.insert({x, y}).second);
            visited.push_back({x, y});
        });
        EXPECT_EQ(seen.size(), std::size_t(width * height));
        for (std::size_t a = 0; a < visited.size(); ++a)
            for (std::size_t b = a + 1; b < visited.size(); ++b) {
                const double ua = visited[a].first + 0.5 - order.u, ub = visited[b].first + 0.5 - order.u,
                             va = visited[a].second + 0.5 - order.v, vb = visited[b].second + 0.5 - order.v;
                if ((ua < 0) != (ub < 0) || (va < 0) != (vb < 0)) continue;  // another sheet
                const bool a_nearer = std::abs(ua) < std::abs(ub) && std::abs(va) < std::abs(vb),
                           b_nearer = std::abs(ub) < std::abs(ua) && std::abs(vb) < std::abs(va);
                EXPECT_FALSE(order.toward ? a_nearer : b_nearer);
            }
    }
}

TEST(OcclusionOrder, EveryGapOnceAndTheEpipolesLastOrFirst) {
    for (const bool toward : {true, false})
        for (const double e : {-2.0, 0.0, 0.5, 3.2, 3.5, 6.0, 9.0}) {
            std::vector<int> gaps;
            for_each_gap(e, 6, toward, [&](int k) { gaps.push_back(k); });
            EXPECT_EQ(std::set<int>(gaps.begin(), gaps.end()), (std::set<int>{-1, 0, 1, 2, 3, 4, 5}));
            EXPECT_EQ(gaps.size(), 7u);
            EXPECT_EQ(toward ? gaps.back() : gaps.front(), texels_before(e, 6) - 1);
        }
}

// One texel in the place of another, both on a line through the epipole: the formula of the order
// against depths.
TEST(OcclusionOrder, TheNearestOfTwoThatMeetComesLast) {
    hard::Random r(2);
    int cases = 0;
    for (int i = 0; i < 20'000; ++i) {
        const bool perspective = r.coin();
        const ReliefCamera camera =
            perspective ? *perspective_camera({{0, 0, -1}, {0, 1, 0}, 64, 64}, {0, 0, 2}, 1, {60})
                        : *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 64, 64}, {0, 0, 1}, 2);
        glm::dvec3 eye = random::viewer_place(r, camera, r.between(0.2, 4), 4);
        if (perspective && i % 4 == 0) eye.z = camera.eye.z;  // a lateral move: the epipole at infinity
        const Warp warp = *make_warp(camera, viewer_at(eye));
        const OcclusionOrder order = occlusion_order(warp);
        // where a texel must stand to be seen in the same place at another depth
        const Displacement da{Scalar(r.between(0, 2))}, db{Scalar(r.between(0, 2))};
        const Disparity qa{Scalar(r.between(0.1, 1))}, qb{Scalar(r.between(0.1, 1))};
        const double u = r.between(0, 64), v = r.between(0, 64);
        const WarpedPoint p = perspective ? warp_point(warp, u, v, qa) : warp_point(warp, u, v, da);
        const glm::dvec2 other =
            perspective ? unwarp_point(warp, p.u, p.v, qb) : unwarp_point(warp, p.u, p.v, db);
        const WarpedPoint q =
            perspective ? warp_point(warp, other.x, other.y, qb) : warp_point(warp, other.x, other.y, db);
        if (std::abs(other.x - u) < 1e-3 || std::abs(other.y - v) < 1e-3) continue;
        ++cases;
        const bool first_nearer = p.weight > q.weight;  // h / (h + d)
        const bool first_closer = std::abs(u - order.u) < std::abs(other.x - order.u);
        ASSERT_EQ(first_nearer, first_closer == order.toward) << i;
        const bool first_closer_v = std::abs(v - order.v) < std::abs(other.y - order.v);
        ASSERT_EQ(first_nearer, first_closer_v == order.toward) << i;
    }
    EXPECT_GT(cases, 10'000);
}

// Splats of the test objects, painted in the right and in the wrong order, against splats with a
// z-buffer. Where texels are drawn together, neighbours fall into one pixel, and which of them comes
// last is a matter of rounding; a splat is wrong when it is seen more than two texels behind the
// nearest.
struct Wrong {
    double right, reversed;
};
Wrong wrong_splats(const Spheres& object, const glm::dvec3& eye) {
    const ReliefCamera camera = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 256, 256}, {0, 0, 1}, 2);
    const ReliefTexture texture = ray_cast(object, camera);
    const Warp warp = *make_warp(camera, viewer_at(eye));
    const Window window = *target_window(camera, warp, depth_range(texture));
    PrewarpSettings settings;
    settings.resampler = Resampler::Splat;
    const Prewarped right = prewarp(texture, warp, window, settings);
    settings.painting = Painting::Reversed;
    const Prewarped reversed = prewarp(texture, warp, window, settings);
    settings.depth_test = true;
    const Prewarped tested_reversed = prewarp(texture, warp, window, settings);
    settings.painting = Painting::Right;
    const Prewarped truth = prewarp(texture, warp, window, settings);
    int covered = 0, wrong_right = 0, wrong_reversed = 0;
    for (std::size_t i = 0; i < truth.depth.pixels().size(); ++i) {
        if (!truth.coverage.pixels()[i]) continue;
        ++covered;
        wrong_right += right.depth.pixels()[i] > truth.depth.pixels()[i] + Scalar(2 * 2.0 / 256);
        wrong_reversed += reversed.depth.pixels()[i] > truth.depth.pixels()[i] + Scalar(2 * 2.0 / 256);
        EXPECT_EQ(tested_reversed.depth.pixels()[i], truth.depth.pixels()[i]);  // with z no order matters
    }
    return {100.0 * wrong_right / covered, 100.0 * wrong_reversed / covered};
}

TEST(OcclusionOrder, RightIsRightAndReversedIsWrong) {
    using pipeline::Degrees;
    double worst = 0, least = 100, most = 0;
    for (const Spheres* object : {&scene::bumpy_object, &scene::complex_object})
        for (const double azimuth : {25.0, 40.0, 55.0}) {
            const glm::dvec3 eye =
                3.0 * glm::dvec3(pipeline::sin(Degrees{azimuth}), 0.2, pipeline::cos(Degrees{azimuth}));
            const Wrong wrong = wrong_splats(*object, eye);
            std::printf("%s %2.0f degrees: %.2f %% wrong in the right order, %.1f %% in the other\n",
                        object == &scene::bumpy_object ? "bumpy  " : "complex", azimuth, wrong.right,
                        wrong.reversed);
            worst = std::max(worst, wrong.right);
            least = std::min(least, wrong.reversed), most = std::max(most, wrong.reversed);
        }
    EXPECT_LE(worst, 1.3);
    EXPECT_GE(most, 14);
    EXPECT_GE(least, 14);
}

}  // namespace
}  // namespace relevo::relief
