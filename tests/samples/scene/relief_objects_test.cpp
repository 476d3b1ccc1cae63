// Objects by pictures of themselves: every key of [object.relief], and every mistake with its place.
#include "samples/scene/relief_objects.hpp"

#include <gtest/gtest.h>

#include "samples/scene/scene.hpp"
#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::scene {
namespace {

using relief::Representation;

LoadedScene parsed(const std::string& text) {
    auto scene = parse_scene(text, "scene.toml");
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? std::move(*scene) : LoadedScene{};
}
std::string error_of(const std::string& text) {
    const auto scene = parse_scene(text, "scene.toml");
    return scene ? "no error" : scene.error().text();
}

TEST(ReliefObjects, AMeshBecomesAReliefInPlaceOfAModel) {
    const LoadedScene s = parsed(R"([[object]]
mesh = "teapot"
name = "pot"
representation = "relief"
material = { shininess = 7 }
[object.relief]
texels = 64
azimuth = 30
elevation = -20
source = "perspective"
distance = 4
radius = 5
bits = "8"
light = "captured"
reading = "nearest"
resampler = "compensated"
jump = "cut"
jump_depth = 0.25
depth_test = true
[[object]]
mesh = "cube"
)");
    ASSERT_EQ(s.scene.models.size(), 1u);
    EXPECT_EQ(s.descriptions.size(), 1u);
    ASSERT_EQ(s.reliefs.size(), 1u);
    const ReliefObject& object = s.reliefs[0];
    EXPECT_EQ(object.name, "pot");
    EXPECT_EQ(object.representation, Representation::Relief);
    ASSERT_EQ(object.models->models.size(), 1u);
    EXPECT_EQ(object.models->lights.size(), 1u);
    EXPECT_EQ(object.surface, nullptr);
    EXPECT_EQ(object.material.shininess, 7);
    const relief::RepresentationSettings& r = object.settings;
    EXPECT_EQ(r.texels, 64);
    EXPECT_EQ(r.azimuth.value, 30);
    EXPECT_EQ(r.elevation.value, -20);
    EXPECT_EQ(r.projection, relief::Projection::Perspective);
    EXPECT_EQ(r.distance, 4);
    EXPECT_EQ(r.radius, 5);
    EXPECT_EQ(r.bits, relief::DepthBits::Eight);
    EXPECT_EQ(r.lit, relief::Lit::Captured);
    EXPECT_EQ(r.reading, relief::Reading::Nearest);
    EXPECT_EQ(r.prewarp.resampler, relief::Resampler::Compensated);
    EXPECT_EQ(r.prewarp.jump, relief::Jump::Cut);
    EXPECT_EQ(r.prewarp.jump_depth, 0.25f);
    EXPECT_TRUE(r.prewarp.depth_test);
}

TEST(ReliefObjects, ASurfaceIsGeometryUnlessItSaysOtherwise) {
    for (const SurfaceInfo& surface : surfaces()) {
        const LoadedScene s = parsed("[[object]]\nsurface = \"" + std::string(surface.name) + "\"\n");
        EXPECT_TRUE(s.scene.models.empty());
        ASSERT_EQ(s.reliefs.size(), 1u);
        EXPECT_EQ(s.reliefs[0].representation, Representation::Geometry);
        EXPECT_NE(s.reliefs[0].surface, nullptr);
        EXPECT_EQ(s.reliefs[0].name, surface.name);
        EXPECT_TRUE(s.camera.framed);
        // the framed camera sees the whole ball
        const relief::BoundingBall ball = bounding_ball(*s.reliefs[0].surface);
        EXPECT_GT(glm::length(s.camera.eye - s.camera.target), ball.radius);
        EXPECT_NEAR(glm::length(s.camera.target - ball.centre), 0, 1e-6);
    }
}

TEST(ReliefObjects, ReadsTheKeysOfSearchesBoxesAndLayers) {
    const LoadedScene s = parsed(R"([[object]]
surface = "plane-step"
step = 1
representation = "relief-inverse"
[object.relief]
search = "relaxed-cones"
slices = 12
bisections = 3
end = "thickness"
thickness = 0.5
[[object]]
surface = "complex"
transform = [ { scale = 2 } ]
representation = "ldi"
[object.relief]
layers = 6
[[object]]
surface = "sphere"
representation = "relief-box"
[object.relief]
composite = "order"
[[object]]
surface = "sphere"
representation = "morph"
[object.relief]
morphing = "plain"
aside = 20
distance = 4
)");
    ASSERT_EQ(s.reliefs.size(), 4u);
    EXPECT_EQ(s.reliefs[3].settings.morphing, relief::Morphing::Plain);
    EXPECT_EQ(s.reliefs[3].settings.aside.value, 20);
    EXPECT_EQ(s.reliefs[3].settings.distance, 4);
    const relief::RepresentationSettings& r = s.reliefs[0].settings;
    EXPECT_EQ(r.search, relief::Search::RelaxedCones);
    EXPECT_EQ(r.slices.slices, 12);
    EXPECT_EQ(r.slices.bisections, 3);
    EXPECT_EQ(r.end, relief::SolidEnd::Thickness);
    EXPECT_EQ(r.thickness, 0.5);
    EXPECT_EQ(std::get<relief::PlaneStep>(s.reliefs[0].surface->surface).step, 1);
    EXPECT_EQ(s.reliefs[1].settings.layers, 6);
    EXPECT_EQ(s.reliefs[1].surface->world_from_surface[0][0], 2);
    EXPECT_EQ(s.reliefs[2].settings.composite, relief::Composite::FaceOrder);
}

TEST(ReliefObjects, EveryMistakeHasItsPlace) {
    const auto object = [](const std::string& rest) { return "[[object]]\n" + rest; };
    EXPECT_EQ(error_of(object("mesh = \"cube\"\nrepresentation = \"releif\"\n")),
              "scene.toml:3:18: object.representation is \"releif\", accepted: geometry, relief, relief-box, "
              "relief-inverse, sprite, sprite-depth, ldi, morph, did you mean 'relief'?");
    EXPECT_EQ(error_of(object("surface = \"bumpi\"\n")),
              "scene.toml:2:11: object.surface is \"bumpi\", accepted: sphere, bumpy, complex, plane-step, "
              "checker-cube, did you mean 'bumpy'?");
    EXPECT_EQ(error_of(object("surface = \"bumpy\"\nmesh = \"cube\"\n")),
              "scene.toml:2:11: an object has a mesh or a surface, not both");
    EXPECT_EQ(error_of(object("surface = \"bumpy\"\nstep = 1\n")),
              "scene.toml:3:8: object.step is for surface = \"plane-step\" only");
    EXPECT_EQ(error_of(object("mesh = \"cube\"\nstep = 1\n")),
              "scene.toml:3:8: object.step is for surface = \"plane-step\" only");
    EXPECT_EQ(error_of(object("surface = \"bumpy\"\nsegments = [3, 4]\n")),
              "scene.toml:3:12: object.segments is no parameter of surface = \"bumpy\", accepted: none");
    EXPECT_EQ(error_of(object("surface = \"bumpy\"\nmaterial = { color = [1, 1, 1] }\n")),
              "scene.toml:3:14: unknown key object.material.color, accepted: ambient, diffuse, specular, "
              "shininess");
    EXPECT_EQ(error_of(object("surface = \"bumpy\"\ntransform = [ { scale = [1, 0, 1] } ]\n")),
              "scene.toml:3:13: object.transform flattens the surface or shrinks it to nothing: it must have "
              "an inverse");
    EXPECT_EQ(error_of(object("mesh = \"cube\"\n[object.relief]\ntexels = 4\n")),
              "scene.toml:3:1: object.relief has no meaning for representation = \"geometry\", which is the "
              "default");
    EXPECT_EQ(
        error_of(object("surface = \"bumpy\"\nrepresentation = \"relief\"\n[object.relief]\nlayers = 4\n")),
        "scene.toml:5:1: unknown key object.relief.layers, accepted: texels, radius, light, bits, azimuth, "
        "elevation, source, distance, jump_depth, resampler, jump, depth_test, reading");
    EXPECT_EQ(
        error_of(object("surface = \"bumpy\"\nrepresentation = \"sprite-depth\"\n[object.relief]\nsource = "
                        "\"perspective\"\n")),
        "scene.toml:5:1: unknown key object.relief.source, accepted: texels, radius, light, bits, azimuth, "
        "elevation, jump_depth, reading");
    EXPECT_EQ(
        error_of(object("surface = \"bumpy\"\nrepresentation = \"relief\"\n[object.relief]\ndistance = 4\n")),
        "scene.toml:5:12: object.relief.distance is for source = \"perspective\" only");
    EXPECT_EQ(
        error_of(object("surface = \"bumpy\"\nrepresentation = \"relief\"\n[object.relief]\ntexels = 0\n")),
        "scene.toml:5:10: object.relief.texels is 0, accepted: a whole number from 1 to 2048");
    for (const std::string radius : {"1e-300", "1e300", "0"})
        EXPECT_EQ(
            error_of(object("surface = \"bumpy\"\nrepresentation = \"relief\"\n[object.relief]\nradius = " +
                            radius + "\n"))
                .substr(0, 33),
            "scene.toml:5:10: object.relief.ra");
    EXPECT_EQ(
        error_of(object("surface = \"bumpy\"\nrepresentation = \"relief\"\n[object.relief]\nradius = 0\n")),
        "scene.toml:5:10: object.relief.radius is 0, accepted: 1e-15 to 1e15");
    EXPECT_EQ(
        error_of(object("surface = \"bumpy\"\nrepresentation = \"relief-inverse\"\n[object.relief]\nsource = "
                        "\"perspective\"\nend = \"back\"\n")),
        "scene.toml:6:7: object.relief.end is \"back\", accepted: with source = \"perspective\": "
        "thickness, none");
    EXPECT_EQ(error_of(object("surface = \"bumpy\"\nrepresentation = \"relief-inverse\"\n[object.relief]\n"
                              "search = \"texels\"\nreading = \"bilinear\"\n")),
              "scene.toml:6:11: object.relief.reading is \"bilinear\", accepted: with search = \"texels\" or "
              "\"cones\": nearest");
}

TEST(ReliefObjects, AParallelViewTakesReliefsOnly) {
    const std::string camera = "[camera]\nprojection = \"orthographic\"\n[[object]]\nsurface = \"bumpy\"\n";
    EXPECT_EQ(error_of(camera + "representation = \"sprite\"\n"),
              "scene.toml:5:18: bumpy by \"sprite\" needs a viewer with an eye, accepted with projection = "
              "\"orthographic\": representation = \"relief\", and \"geometry\" of a mesh");
    EXPECT_EQ(error_of(camera + "representation = \"relief\"\n"), "no error");
}

TEST(ReliefObjects, ATransparentMaterialIsRefused) {
    const io::TemporaryFolder folder;
    folder.write("glass.mtl", "newmtl glass\nKd 1 1 1\nd 0.5\n");
    folder.write("glass.obj", "mtllib glass.mtl\no pane\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl glass\nf 1 2 3\n");
    const auto of = [&](const std::string& way) {
        folder.write("scene.toml", "[[object]]\nmesh = \"glass.obj\"\nrepresentation = \"" + way + "\"\n");
        const auto scene = load_scene(folder.path("scene.toml"));
        return scene ? "no error" : folder.without_path(scene.error().text());
    };
    EXPECT_EQ(
        of("relief"),
        "scene.toml:3:18: pane is of a transparent material, and pictures with depth know one surface a "
        "texel, accepted: representation = \"geometry\" (drawn opaque)");
    EXPECT_EQ(of("geometry"), "no error");
}

}  // namespace
}  // namespace relevo::scene
