// The [animation] table: where the eye stands in every frame.
#include "samples/scene/animation.hpp"

#include <gtest/gtest.h>

#include "samples/scene/scene.hpp"

namespace relevo::scene {
namespace {

LoadedScene parsed(const std::string& text) {
    auto scene = parse_scene(text + "[[object]]\nmesh = \"cube\"\n", "scene.toml");
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? std::move(*scene) : LoadedScene{};
}
std::string error_of(const std::string& text) {
    const auto scene = parse_scene(text + "[[object]]\nmesh = \"cube\"\n", "scene.toml");
    return scene ? "no error" : scene.error().text();
}
void expect_at(const glm::dvec3& p, const glm::dvec3& q) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(p[k], q[k], 1e-12) << k;
}

TEST(Animation, AWholeTurnEndsOneStepBeforeItsBeginning) {
    const LoadedScene s = parsed("[animation]\nradius = 2\nframes = 4\ntarget = [0, 1, 0]\n");
    ASSERT_TRUE(s.animation);
    expect_at(eye_at(*s.animation, 0), {0, 1, 2});
    expect_at(eye_at(*s.animation, 1), {2, 1, 0});
    expect_at(eye_at(*s.animation, 2), {0, 1, -2});
    expect_at(eye_at(*s.animation, 3), {-2, 1, 0});
    expect_at(s.camera.eye, {0, 1, 2});
    EXPECT_EQ(camera_at(s, 0).eye_from_world.m, s.scene.camera.eye_from_world.m);
    EXPECT_NE(camera_at(s, 1).eye_from_world.m, s.scene.camera.eye_from_world.m);
}

TEST(Animation, APartOfATurnEndsWhereItSays) {
    const LoadedScene s = parsed(
        "[animation]\nfrom = 0\nto = 40\nframes = 5\nradius = 1\nelevation = 30\ntarget = [0, 0, 0]\n");
    for (int k = 0; k < 5; ++k) {
        const pipeline::Degrees azimuth{10.0 * k}, up{30};
        expect_at(eye_at(*s.animation, k), {sin(azimuth) * cos(up), sin(up), cos(azimuth) * cos(up)});
    }
    const LoadedScene one =
        parsed("[animation]\nfrom = 90\nto = 120\nframes = 1\nradius = 1\ntarget = [0, 0, 0]\n");
    expect_at(eye_at(*one.animation, 0), {1, 0, 0});
}

TEST(Animation, TargetAndRadiusAreTheCamerasOwn) {
    const LoadedScene s = parsed("[camera]\neye = [3, 0, 4]\ntarget = [0, 0, 1]\n[animation]\n");
    EXPECT_EQ(s.animation->frames, 36);
    EXPECT_NEAR(s.animation->radius, std::sqrt(18), 1e-12);
    expect_at(s.animation->target, {0, 0, 1});
}

TEST(Animation, APathGoesFromEyeToEye) {
    const LoadedScene s = parsed(
        "[animation]\ntype = \"path\"\neyes = [[0, 0, 4], [2, 0, 4], [2, 2, 4]]\nframes = 5\ntarget = [0, 0, "
        "0]\n");
    const glm::dvec3 eyes[] = {{0, 0, 4}, {1, 0, 4}, {2, 0, 4}, {2, 1, 4}, {2, 2, 4}};
    for (int k = 0; k < 5; ++k) expect_at(eye_at(*s.animation, k), eyes[k]);
}

TEST(Animation, EveryMistakeHasItsPlace) {
    EXPECT_EQ(
        error_of("[animation]\nframs = 3\n"),
        "scene.toml:2:1: unknown key animation.frams, accepted: type, target, radius, elevation, from, to, "
        "frames, eyes, did you mean 'frames'?");
    EXPECT_EQ(error_of("[animation]\nframes = 0\n"),
              "scene.toml:2:10: animation.frames is 0, accepted: a whole number from 1 to 10000");
    EXPECT_EQ(error_of("[animation]\neyes = [[0, 0, 1], [0, 1, 1]]\n"),
              "scene.toml:2:8: animation.eyes is for type = \"path\" only");
    EXPECT_EQ(error_of("[animation]\ntype = \"path\"\nradius = 2\n"),
              "scene.toml:3:10: animation.radius is for type = \"orbit\" only");
    EXPECT_EQ(error_of("[animation]\ntype = \"path\"\neyes = [[0, 0, 1]]\n"),
              "scene.toml:3:8: animation.eyes is a list, accepted: a list of two or more places [x, y, z]");
    EXPECT_EQ(error_of("[animation]\nelevation = 90\n"),
              "scene.toml:2:13: animation.elevation is 90, accepted: more than -90 and less than 90 degrees");
    EXPECT_EQ(error_of("[animation]\ntype = \"path\"\neyes = [[0, 3, 0.1], [0, 3, -0.1]]\nframes = 3\ntarget "
                       "= [0, 0, 0]\n")
                  .substr(0, 45),
              "scene.toml:1:1: animation: frame 1: up is par");
}

TEST(Animation, ALessonHasNone) {
    const auto scene =
        parse_scene("[animation]\n[[shape2d]]\ntype = \"line\"\npoints = [[0, 0], [1, 1]]\n", "scene.toml");
    EXPECT_EQ(scene.error().text(),
              "scene.toml:1:2: animation is for [[object]]s, and this scene is made of [[shape2d]]s");
}

}  // namespace
}  // namespace relevo::scene
