// The counting probe: counts of a small scene that can be told by hand, and that no pixel moves for it.
#include "samples/scene/statistics.hpp"

#include <gtest/gtest.h>

#include "raster/draw.hpp"
#include "samples/scene/scene.hpp"

namespace relevo::scene {
namespace {

struct Counted {
    Statistics statistics;
    raster::Frame frame;
};
Counted counted(const std::string& text) {
    auto scene = parse_scene(text, "scene.toml");
    EXPECT_TRUE(scene) << scene.error().text();
    Counted out{statistics_of(scene->scene), make_frame(*scene)};
    raster::draw(scene->scene, scene->settings, out.frame, out.statistics);
    raster::Frame unwatched = make_frame(*scene);
    raster::draw(scene->scene, scene->settings, unwatched);
    EXPECT_EQ(unwatched.color.pixels(), out.frame.color.pixels());
    EXPECT_EQ(unwatched.depth.pixels(), out.frame.depth.pixels());
    return out;
}

// Two squares, seen from above by parallel rays: 100 x 100 pixels, and under it 50 x 50.
const std::string squares = R"([image]
width = 200
height = 200
[camera]
projection = "orthographic"
eye = [0, 5, 0]
target = [0, 0, 0]
up = [0, 0, -1]
height = 2
near = 1
far = 10
[[object]]
mesh = "plane"
[[object]]
mesh = "plane"
transform = [{ scale = 0.5 }, { translate = [0, -1, 0] }]
)";

TEST(Statistics, CountTwoSquaresOneUnderTheOther) {
    const Statistics s = counted(squares).statistics;
    EXPECT_EQ(s.triangles, 4u);
    EXPECT_EQ(s.vertices, 8u);
    EXPECT_EQ(s.pieces, 4u);
    EXPECT_EQ(s.drawn, 4u);
    EXPECT_EQ(s.covered, 12500u);
    EXPECT_EQ(s.depth_passed, 10000u);
    EXPECT_EQ(s.depth_failed, 2500u);
    EXPECT_EQ(s.shaded, 10000u);
    EXPECT_EQ(s.clipped, 0u);
    EXPECT_EQ(s.rejected, (std::array<Statistics::Count, 5>{}));
}

TEST(Statistics, CountWhatIsDropped) {
    const Statistics s = counted(squares + R"([[object]]
mesh = "plane"
transform = [{ translate = [0, -30, 0] }]
[[object]]
mesh = "plane"
transform = [{ rotate = { axis = [1, 0, 0], degrees = 180 } }]
[[object]]
mesh = "plane"
transform = [{ scale = [1, 1, 0] }]
[[object]]
mesh = "plane"
transform = [{ scale = 1e38 }, { scale = 1e38 }]
[[object]]
mesh = "plane"
transform = [{ scale = 1e-6 }]
)")
                             .statistics;
    using raster::Rejection;
    EXPECT_EQ(s.rejected_for(Rejection::Outside), 2u);
    EXPECT_EQ(s.rejected_for(Rejection::Culled), 2u);
    EXPECT_EQ(s.rejected_for(Rejection::ZeroArea), 4u);
    EXPECT_EQ(s.rejected_for(Rejection::NonFinite), 2u);
    EXPECT_EQ(s.covered, 12500u);
}

TEST(Statistics, CountAClippedTriangle) {
    const Statistics s = counted(R"([camera]
eye = [0, 1, 0]
target = [0, 1, -1]
near = 0.1
[[object]]
mesh = "plane"
transform = [{ scale = 100 }]
)")
                             .statistics;
    EXPECT_EQ(s.clipped, 2u);
    EXPECT_GT(s.pieces, 2u);
    EXPECT_EQ(s.drawn, 1u) << "the other one is beside the picture";
}

TEST(Statistics, AsJson) {
    Statistics s;
    s.triangles = 3;
    s.shaded = 18446744073709551615u;
    EXPECT_EQ(
        to_json(named_counts(s)),
        R"({"triangles": 3, "vertices": 0, "clipped": 0, "rejected_non_finite": 0, "rejected_outside": 0, )"
        R"("rejected_zero_area": 0, "rejected_culled": 0, "rejected_no_pixel": 0, "pieces": 0, "drawn": 0, )"
        R"("covered": 0, "depth_passed": 0, "depth_failed": 0, "shaded": 18446744073709551615})");
}

}  // namespace
}  // namespace relevo::scene
