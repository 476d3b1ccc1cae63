// The [camera] table: projections, framing, and what no camera can be.
#include "samples/scene/camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"
#include "samples/scene/framing.hpp"
#include "samples/scene/scene.hpp"

namespace relevo::scene {
namespace {

const std::string cube = "[[object]]\nmesh = \"cube\"\n";

LoadedScene parsed(const std::string& text) {
    auto scene = parse_scene(text, "scene.toml");
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? std::move(*scene) : LoadedScene{};
}
std::string error_of(const std::string& camera) {
    const auto scene = parse_scene(cube + "[camera]\n" + camera, "scene.toml");
    return scene ? "no error" : scene.error().text();
}

// The largest |x|/w and |y|/w of all vertices, and whether all are between near and far.
struct Sight {
    double x = 0, y = 0;
    bool between = true;
};
Sight sight(const LoadedScene& s) {
    Sight out;
    for (const raster::Model& model : s.scene.models)
        for (const pipeline::Vertex& v : model.mesh->vertices) {
            const glm::dmat4 m =
                s.scene.camera.clip_from_eye.m * s.scene.camera.eye_from_world.m * model.world_from_object.m;
            const glm::dvec4 p = m * glm::dvec4(glm::dvec3(v.position.v), 1);
            out.x = std::max(out.x, std::abs(p.x / p.w));
            out.y = std::max(out.y, std::abs(p.y / p.w));
            out.between = out.between && p.w > 0 && p.z >= 0 && p.z <= p.w;
        }
    return out;
}

TEST(Camera, WithoutOneEverythingIsSeenAndNothingIsTiny) {
    const std::string heads[] = {
        "[[object]]\nmesh = \"cube\"\n", "[[object]]\nmesh = \"torus\"\n",
        "[[object]]\nmesh = \"teapot\"\ntransform = [{scale = [1, 20, 1]}]\n",
        "[[object]]\nmesh = \"plane\"\ntransform = [{translate = [1e6, 0, 0]}, {scale = 1e-3}]\n",
        "[[object]]\nmesh = \"sphere\"\ntransform = [{scale = 1e-12}]\n"};
    for (const std::string& head : heads)
        for (const std::string image :
             {"width = 640\nheight = 480", "width = 100\nheight = 1000", "width = 1000\nheight = 90"})
            for (const std::string camera :
                 {"", "[camera]\nfov_y = 100\n", "[camera]\nprojection = \"orthographic\"\n",
                  "[camera]\nup = [1, 0, 0]\n"}) {
                const LoadedScene s = parsed(head + "[image]\n" + image + "\n" + camera);
                const Sight seen = sight(s);
                EXPECT_TRUE(seen.between);
                EXPECT_LE(std::max(seen.x, seen.y), 1) << head << image << camera;
                EXPECT_GE(std::max(seen.x, seen.y), 0.4) << head << image << camera;
            }
}

TEST(Camera, FramesAFrustumToo) {
    const LoadedScene s = parsed(cube +
                                 "[camera]\nprojection = \"frustum\"\nleft = -0.1\nright = 0.1\nbottom = "
                                 "-0.2\ntop = 0.2\nnear = 0.3\n");
    EXPECT_TRUE(sight(s).between);
    EXPECT_LE(std::max(sight(s).x, sight(s).y), 1);
}

TEST(Camera, ReadsAPerspective) {
    const LoadedScene s = parsed(cube + R"([image]
width = 200
height = 100
[camera]
projection = "perspective"
eye = [1, 2, 3]
target = [4, 5, 6]
up = [0, 0, 1]
fov_y = 60
near = 0.5
far = 100
)");
    using pipeline::DepthRange;
    EXPECT_EQ(s.scene.camera.eye_from_world.m, pipeline::look_at({1, 2, 3}, {4, 5, 6}, {0, 0, 1})->m);
    EXPECT_EQ(s.scene.camera.clip_from_eye.m,
              pipeline::perspective(pipeline::Degrees{60}, 2, 0.5, 100, DepthRange::Reversed)->m);
    EXPECT_FALSE(s.scene.camera.parallel);
    EXPECT_FALSE(s.camera.framed);
    EXPECT_EQ(s.camera.kind, CameraDescription::Kind::Perspective);
    EXPECT_EQ(s.camera.eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(s.camera.fov_y, 60);
    EXPECT_EQ(s.camera.far, 100);
}

TEST(Camera, ForwardDepthAndAnInfiniteFarPlane) {
    const LoadedScene s = parsed(cube +
                                 "[camera]\neye = [0, 0, 3]\nfov_y = 60\nnear = 0.5\nfar = "
                                 "inf\n[pipeline]\ndepth = \"float32-forward\"\n");
    EXPECT_EQ(s.scene.camera.clip_from_eye.m, pipeline::perspective(pipeline::Degrees{60}, 640.0 / 480, 0.5,
                                                                    HUGE_VAL, pipeline::DepthRange::Forward)
                                                  ->m);
}

TEST(Camera, ReadsAnOrthographicView) {
    const LoadedScene s = parsed(
        cube + "[camera]\nprojection = \"orthographic\"\neye = [0, 0, 3]\nheight = 3\nnear = -1\nfar = 10\n");
    EXPECT_EQ(s.scene.camera.clip_from_eye.m,
              pipeline::orthographic(-2, 2, -1.5, 1.5, -1, 10, pipeline::DepthRange::Reversed)->m);
    EXPECT_TRUE(s.scene.camera.parallel);
}

TEST(Camera, ReadsAFrustum) {
    const LoadedScene s = parsed(cube + R"([camera]
projection = "frustum"
eye = [0, 0, 3]
left = -1
right = 2
bottom = -3
top = 4
near = 1
)");
    EXPECT_EQ(s.scene.camera.clip_from_eye.m,
              pipeline::frustum(-1, 2, -3, 4, 1, HUGE_VAL, pipeline::DepthRange::Reversed)->m);
}

TEST(Camera, LooksAtTheMiddleOfTheObjects) {
    const LoadedScene s = parsed(
        "[[object]]\nmesh = \"cube\"\ntransform = [{ translate = [3, 4, 5] }]\n[camera]\neye = [0, 0, 9]\n");
    EXPECT_EQ(s.camera.target, glm::dvec3(3, 4, 5));
}

TEST(Framing, HasAnAnswerForNoVertexAndForOnePoint) {
    EXPECT_EQ(bounds_of({}).center(), glm::dvec3(0, 0, 0));
    EXPECT_EQ(perspective_distance({}, {0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1, 1), 1);
    pipeline::Mesh mesh;
    mesh.vertices = {{{{2, 3, 4}}, {{0, 0, 0}}, {0, 0}},
                     {{{std::numeric_limits<pipeline::Scalar>::infinity(), 0, 0}}, {{0, 0, 0}}, {0, 0}}};
    raster::Model model;
    model.mesh = &mesh;
    EXPECT_EQ(bounds_of({model}).low, glm::dvec3(2, 3, 4));
    EXPECT_EQ(bounds_of({model}).high, glm::dvec3(2, 3, 4));
}

struct Bad {
    const char *camera, *error;
};
class BadCamera : public testing::TestWithParam<Bad> {};
TEST_P(BadCamera, IsRefusedAtItsPlace) { EXPECT_EQ(error_of(GetParam().camera), GetParam().error); }

INSTANTIATE_TEST_SUITE_P(
    Camera, BadCamera,
    testing::Values(
        Bad{"fov_y = 190",
            "scene.toml:4:9: camera.fov_y is 190, accepted: more than 0 and less than 180 degrees"},
        Bad{"fov_y = 180",
            "scene.toml:4:9: camera.fov_y is 180, accepted: more than 0 and less than 180 degrees"},
        Bad{"fov_y = 0",
            "scene.toml:4:9: camera.fov_y is 0, accepted: more than 0 and less than 180 degrees"},
        Bad{"fov_y = nan",
            "scene.toml:4:9: camera.fov_y is nan, accepted: more than 0 and less than 180 degrees"},
        Bad{"fov_y = \"wide\"",
            "scene.toml:4:9: camera.fov_y is \"wide\", accepted: a number, more than 0 and less than 180 "
            "degrees"},
        Bad{"near = 0", "scene.toml:4:8: camera.near is 0, accepted: more than 0 (finite)"},
        Bad{"near = -1", "scene.toml:4:8: camera.near is -1, accepted: more than 0 (finite)"},
        Bad{"near = inf", "scene.toml:4:8: camera.near is inf, accepted: a finite number (float32)"},
        Bad{"near = 10\nfar = 1",
            "scene.toml:4:8: camera.near is 10, accepted: less than camera.far, which is 1"},
        Bad{"near = 1\nfar = 1",
            "scene.toml:4:8: camera.near is 1, accepted: less than camera.far, which is 1"},
        Bad{"eye = [0, 0, 100]\nfar = 0.5",
            "scene.toml:5:7: camera.far is 0.5, accepted: more than camera.near, which is 1"},
        Bad{"far = 0", "scene.toml:4:7: camera.far is 0, accepted: more than near, or inf"},
        Bad{"far = -inf", "scene.toml:4:7: camera.far is -inf, accepted: more than near, or inf"},
        Bad{"far = nan", "scene.toml:4:7: camera.far is nan, accepted: more than near, or inf"},
        Bad{"eye = [1, 1, 1]\ntarget = [1, 1, 1]",
            "scene.toml:4:7: camera: eye and target are the same point; the camera needs a direction to look "
            "in"},
        Bad{"eye = [0, 5, 0]\ntarget = [0, 0, 0]",
            "scene.toml:4:7: camera: up is parallel to the line of sight from eye to target; choose another "
            "up"},
        Bad{"eye = [0, 0, 5]\ntarget = [0, 0, 0]\nup = [0, 0, -2]",
            "scene.toml:6:6: camera: up is parallel to the line of sight from eye to target; choose another "
            "up"},
        Bad{"up = [0, 0, 0]",
            "scene.toml:4:6: camera: up is zero; it must be a direction that is not along the line of sight"},
        Bad{"eye = [0, 0]",
            "scene.toml:4:7: camera.eye is a list of 2, accepted: three numbers in brackets, each a finite "
            "number "
            "(float32)"},
        Bad{"eye = [0, 0, nan]",
            "scene.toml:4:14: camera.eye[2] is nan, accepted: a finite number (float32)"},
        Bad{"fov = 30",
            "scene.toml:4:1: unknown key camera.fov, accepted: projection, eye, target, up, fov_y, height, "
            "left, "
            "right, bottom, top, near, far"},
        Bad{"projection = \"ortographic\"",
            "scene.toml:4:14: camera.projection is \"ortographic\", accepted: perspective, orthographic, "
            "frustum, did "
            "you mean 'orthographic'?"},
        Bad{"height = 3", "scene.toml:4:10: camera.height is for projection = \"orthographic\" only"},
        Bad{"left = 3", "scene.toml:4:8: camera.left is for projection = \"frustum\" only"},
        Bad{"projection = \"orthographic\"\nfov_y = 3",
            "scene.toml:5:9: camera.fov_y is for projection = \"perspective\" only"},
        Bad{"projection = \"orthographic\"\nheight = 0",
            "scene.toml:5:10: camera.height is 0, accepted: more than 0 (finite)"},
        Bad{"projection = \"orthographic\"\nfar = inf",
            "scene.toml:5:7: camera.far is inf, accepted: a finite number (float32)"},
        Bad{"projection = \"frustum\"",
            "scene.toml:3:1: camera.left is missing, accepted: a frustum needs left, right, bottom, top and "
            "near"},
        Bad{"projection = \"frustum\"\nleft = 1\nright = 1\nbottom = 0\ntop = 1\nnear = 1",
            "scene.toml:5:8: camera.left is 1, accepted: less than camera.right, which is 1"},
        Bad{"projection = \"frustum\"\nleft = 0\nright = 1\nbottom = 2\ntop = 1\nnear = 1",
            "scene.toml:7:10: camera.bottom is 2, accepted: less than camera.top, which is 1"},
        Bad{"projection = \"frustum\"\nleft = 0\nright = 1\nbottom = 0\ntop = 1\nnear = 0",
            "scene.toml:9:8: camera.near is 0, accepted: more than 0 (finite)"}));

}  // namespace
}  // namespace relevo::scene
