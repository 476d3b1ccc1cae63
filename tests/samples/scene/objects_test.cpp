// The [[object]] tables: meshes, parameters, transforms, materials, textures.
#include "samples/scene/objects.hpp"

#include <gtest/gtest.h>

#include "samples/io/png.hpp"
#include "samples/scene/scene.hpp"
#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::scene {
namespace {

using io::TemporaryFolder;
using pipeline::LinearRgb;
using pipeline::Scalar;

LoadedScene parsed(const std::string& text, const std::string& path = "scene.toml") {
    auto scene = parse_scene(text, path);
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? std::move(*scene) : LoadedScene{};
}
std::string error_of(const std::string& object, const std::string& path = "scene.toml") {
    const auto scene = parse_scene("[[object]]\n" + object, path);
    return scene ? "no error" : scene.error().text();
}

const char* const triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

void write_texture(const TemporaryFolder& folder, const std::string& name) {
    raster::Image<raster::Rgba8> picture(2, 1, {255, 0, 128, 255});
    EXPECT_FALSE(io::write_png(folder.path(name), picture));
}

TEST(Objects, EveryShapeHasItsParameters) {
    const auto triangles = [](const std::string& object) {
        return parsed("[[object]]\n" + object).scene.models.at(0).mesh->triangles();
    };
    EXPECT_EQ(triangles("mesh = \"cube\""), 12u);
    EXPECT_EQ(triangles("mesh = \"dice\""), 12u);
    EXPECT_EQ(triangles("mesh = \"sphere\""), 2u * 64 * 31);
    EXPECT_EQ(triangles("mesh = \"sphere\"\nsegments = [5, 4]"), 2u * 5 * 3);
    EXPECT_EQ(triangles("mesh = \"torus\""), 2u * 64 * 32);
    EXPECT_EQ(triangles("mesh = \"torus\"\nsegments = [316, 158]\ntube = 0.2"), 2u * 316 * 158);
    EXPECT_EQ(triangles("mesh = \"plane\""), 2u);
    EXPECT_EQ(triangles("mesh = \"plane\"\nsegments = [3, 5]\nrepeat = 2.5"), 30u);
    EXPECT_EQ(triangles("mesh = \"teapot\"\nsegments = 2"), 240u);
    EXPECT_EQ(triangles("mesh = \"terrain\"\nsegments = [4, 8]\nseed = 7\nheight = 0.5"), 64u);
}

TEST(Objects, TransformsActFromTheFirstToTheLast) {
    const LoadedScene s = parsed(R"([[object]]
mesh = "cube"
transform = [ { scale = 2 }, { rotate = { axis = [0, 1, 0], degrees = 90 } }, { translate = [0, 0.5, 0] }, { scale = [1, 1, -3] } ]
)");
    // x = 1: scaled 2, turned to z = -2, moved, mirrored to z = 6.
    const glm::dvec4 p = s.scene.models[0].world_from_object.m * glm::dvec4(1, 0, 0, 1);
    EXPECT_EQ(p, glm::dvec4(0, 0.5, 6, 1));
}

TEST(Objects, MaterialKeysAndDefaults) {
    const LoadedScene s = parsed(R"([[object]]
mesh = "cube"
name = "box"
material = { ambient = 0.25, diffuse = 0.5, specular = 1, shininess = 0, color = [0, 0.5, 1], two_sided = true }
[[object]]
mesh = "cube"
)");
    const raster::Model &a = s.scene.models[0], &b = s.scene.models[1];
    EXPECT_EQ(a.material.ambient, Scalar(0.25));
    EXPECT_EQ(a.material.diffuse, Scalar(0.5));
    EXPECT_EQ(a.material.specular, 1);
    EXPECT_EQ(a.material.shininess, 0);
    EXPECT_EQ(a.material.color, (LinearRgb{0, Scalar(0.5), 1}));
    EXPECT_TRUE(a.two_sided);
    EXPECT_EQ(s.descriptions[0].name, "box");
    EXPECT_EQ(b.material.ambient, pipeline::Material{}.ambient);
    EXPECT_EQ(b.material.color, pipeline::Material{}.color);
    EXPECT_FALSE(b.two_sided);
}

TEST(Objects, TheSceneReplacesTheMaterialOfTheFileKeyByKey) {
    const TemporaryFolder folder;
    folder.write("m.mtl", "newmtl red\nKd 1 0 0\nNs 7\nmap_Kd own.png\n");
    folder.write("m.obj", "mtllib m.mtl\nusemtl red\n" + std::string(triangle_obj));
    write_texture(folder, "own.png");
    write_texture(folder, "other.png");
    const LoadedScene s = parsed(R"([[object]]
mesh = "m.obj"
material = { shininess = 9, texture = "other.png" }
[[object]]
mesh = "m.obj"
[[object]]
mesh = "m.obj"
material = { texture = "" }
)",
                                 folder.path("scene.toml"));
    ASSERT_EQ(s.scene.models.size(), 3u);
    EXPECT_EQ(s.scene.models[0].material.shininess, 9);
    EXPECT_EQ(s.scene.models[1].material.shininess, 7);
    EXPECT_EQ(s.scene.models[0].material.diffuse, s.scene.models[1].material.diffuse);
    EXPECT_EQ(s.descriptions[0].texture, "other.png");
    EXPECT_EQ(s.descriptions[1].texture, "own.png");
    EXPECT_EQ(s.scene.models[2].texture, nullptr);
    EXPECT_EQ(s.meshes.size(), 1u) << "a file named three times is read once";
}

TEST(Objects, ATextureIsReadOnceAndItsNumbersMeanWhatTheOutputSays) {
    const TemporaryFolder folder;
    write_texture(folder, "t.png");
    const std::string objects =
        "[[object]]\nmesh = \"cube\"\nmaterial = { texture = \"t.png\" }\n"
        "[[object]]\nmesh = \"sphere\"\nmaterial = { texture = \"./t.png\" }\n";
    const LoadedScene srgb = parsed(objects, folder.path("scene.toml"));
    EXPECT_EQ(srgb.textures.size(), 1u);
    EXPECT_EQ(srgb.scene.models[0].texture, srgb.scene.models[1].texture);
    EXPECT_EQ(srgb.scene.models[0].texture->texels[0][2], raster::srgb_decoded[128]);
    const LoadedScene raw = parsed("[image]\noutput = \"raw\"\n" + objects, folder.path("scene.toml"));
    EXPECT_EQ(raw.scene.models[0].texture->texels[0][2], 128);
}

TEST(Objects, EveryPartOfAnObjFileIsAModel) {
    const TemporaryFolder folder;
    folder.write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no one\nf 1 2 3\no two\nf 3 2 1\n");
    const LoadedScene s = parsed("[[object]]\nmesh = \"two.obj\"\n", folder.path("scene.toml"));
    ASSERT_EQ(s.scene.models.size(), 2u);
    EXPECT_EQ(s.descriptions[0].name, "one");
    EXPECT_EQ(s.descriptions[1].name, "two");
    EXPECT_FALSE(s.descriptions[0].has_uv);
    EXPECT_FALSE(s.descriptions[0].had_normals);
}

TEST(Objects, ATextureOnAMeshWithoutCoordinatesIsWarnedOf) {
    const TemporaryFolder folder;
    folder.write("m.obj", triangle_obj);
    write_texture(folder, "t.png");
    const LoadedScene s = parsed("[[object]]\nmesh = \"m.obj\"\nmaterial = { texture = \"t.png\" }\n",
                                 folder.path("scene.toml"));
    ASSERT_EQ(s.warnings.size(), 1u);
    EXPECT_EQ(folder.without_path(s.warnings[0]),
              "scene.toml:3:24: object.material.texture: the mesh has no texture coordinates everywhere, so "
              "(0, 0) is "
              "used where they are missing");
}

TEST(BadFiles, AreSaidWhereTheyAreNamedOrAtTheirOwnLine) {
    const TemporaryFolder folder;
    folder.write("bad.obj", "v 0 0 0\nv 1 nan 0\n");
    folder.write("bad.png", "no picture");
    const auto error = [&](const std::string& object) {
        return folder.without_path(error_of(object, folder.path("scene.toml")));
    };
    EXPECT_EQ(error("mesh = \"none.obj\""), "scene.toml:2:8: object.mesh: none.obj: there is no such file");
    EXPECT_EQ(error("mesh = \"bad.obj\"").substr(0, 12), "bad.obj:2:5:");
    EXPECT_EQ(error("mesh = \"bunny.ply\""),
              "scene.toml:2:8: object.mesh is \"bunny.ply\", accepted: a file ending in .obj or .solid");
    EXPECT_EQ(error("mesh = \"cube\"\nmaterial = { texture = \"none.png\" }"),
              "scene.toml:3:24: object.material.texture: none.png: there is no such file");
    EXPECT_EQ(error("mesh = \"cube\"\nmaterial = { texture = \"bad.png\" }").substr(0, 51),
              "scene.toml:3:24: object.material.texture: bad.png: ");
}

struct Bad {
    const char *object, *error;
};
class BadObject : public testing::TestWithParam<Bad> {};
TEST_P(BadObject, IsRefusedAtItsPlace) { EXPECT_EQ(error_of(GetParam().object), GetParam().error); }

INSTANTIATE_TEST_SUITE_P(
    Mesh, BadObject,
    testing::Values(
        Bad{"name = \"x\"",
            "scene.toml:1:1: object.mesh is missing, accepted: a file ending in .obj or .solid, or a shape"},
        Bad{"mesh = 3", "scene.toml:2:8: object.mesh is 3, accepted: a text in quotes"},
        Bad{"mesh = \"\"",
            "scene.toml:2:8: object.mesh is \"\", accepted: a file ending in .obj or .solid, or a shape"},
        Bad{"mesh = \"teapott\"",
            "scene.toml:2:8: object.mesh is \"teapott\", accepted: a file ending in .obj or .solid, or a "
            "shape: cube, "
            "dice, sphere, torus, plane, teapot, terrain, did you mean 'teapot'?"},
        Bad{"mesh = \"cube\"\nrepresentations = \"relief\"",
            "scene.toml:3:1: unknown key object.representations, accepted: mesh, surface, name, transform, "
            "representation, relief, step, material, segments, tube, repeat, seed, height, did you mean "
            "'representation'?"},
        Bad{"mesh = \"cube\"\nsegments = [3, 3]",
            "scene.toml:3:12: object.segments is no parameter of mesh = \"cube\", accepted: none"},
        Bad{"mesh = \"sphere\"\nseed = 1",
            "scene.toml:3:8: object.seed is no parameter of mesh = \"sphere\", accepted: segments"},
        Bad{"mesh = \"a.obj\"\nsegments = 3",
            "scene.toml:3:12: object.segments is no parameter of mesh = \"a.obj\", accepted: none"},
        Bad{"mesh = \"sphere\"\nsegments = 3",
            "scene.toml:3:12: object.segments is not right, accepted: two whole numbers from 3 to 2048, as "
            "in [64, 32]"},
        Bad{"mesh = \"sphere\"\nsegments = [3, 1000000000]",
            "scene.toml:3:12: object.segments is not right, accepted: two whole numbers from 3 to 2048, as "
            "in [64, 32]"},
        Bad{"mesh = \"torus\"\nsegments = [3, 3, 3]",
            "scene.toml:3:12: object.segments is not right, accepted: two whole numbers from 3 to 2048, as "
            "in [64, 32]"},
        Bad{"mesh = \"torus\"\ntube = 1",
            "scene.toml:3:8: object.tube is 1, accepted: more than 0 and less than 1"},
        Bad{"mesh = \"plane\"\nrepeat = 0",
            "scene.toml:3:10: object.repeat is 0, accepted: more than 0 (finite)"},
        Bad{"mesh = \"teapot\"\nsegments = 1",
            "scene.toml:3:12: object.segments is 1, accepted: a whole number from 2 to 64"},
        Bad{"mesh = \"terrain\"\nseed = -1",
            "scene.toml:3:8: object.seed is -1, accepted: a whole number from 0 to 1000000"},
        Bad{"mesh = \"terrain\"\nheight = nan",
            "scene.toml:3:10: object.height is nan, accepted: 0 or more (finite)"}));

INSTANTIATE_TEST_SUITE_P(
    Transform, BadObject,
    testing::Values(
        Bad{"mesh = \"cube\"\ntransform = { scale = 2 }",
            "scene.toml:3:13: object.transform is a table, accepted: a list of steps, as in [ { scale = 2 }, "
            "{ "
            "translate = [0, 1, 0] } ]"},
        Bad{"mesh = \"cube\"\ntransform = [ 3 ]",
            "scene.toml:3:15: object.transform[0] is 3, accepted: a table"},
        Bad{"mesh = \"cube\"\ntransform = [ {} ]",
            "scene.toml:3:15: object.transform[0] holds nothing, accepted: one of scale, rotate, translate"},
        Bad{"mesh = \"cube\"\ntransform = [ { scale = 1 }, { scale = 2, translate = [0, 0, 0] } ]",
            "scene.toml:3:30: object.transform[1] holds several steps, accepted: one of scale, rotate, "
            "translate"},
        Bad{"mesh = \"cube\"\ntransform = [ { scal = 1 } ]",
            "scene.toml:3:17: unknown key object.transform[0].scal, accepted: scale, rotate, translate, did "
            "you mean "
            "'scale'?"},
        Bad{"mesh = \"cube\"\ntransform = [ { scale = 0 } ]",
            "scene.toml:3:25: object.transform[0].scale is 0, accepted: a number other than 0, or three"},
        Bad{"mesh = \"cube\"\ntransform = [ { scale = [1, 2, 1e39] } ]",
            "scene.toml:3:32: object.transform[0].scale[2] is 1e+39, accepted: a finite number (float32)"},
        Bad{"mesh = \"cube\"\ntransform = [ { rotate = { axis = [0, 0, 0], degrees = 3 } } ]",
            "scene.toml:3:35: object.transform[0].rotate.axis is a list, accepted: a direction, three "
            "numbers that are "
            "not all 0"},
        Bad{"mesh = \"cube\"\ntransform = [ { rotate = { degrees = 3 } } ]",
            "scene.toml:3:26: object.transform[0].rotate.axis is missing, accepted: axis = [x, y, z] and "
            "degrees"},
        Bad{"mesh = \"cube\"\ntransform = [ { rotate = { axis = [1, 0, 0], angle = 3 } } ]",
            "scene.toml:3:46: unknown key object.transform[0].rotate.angle, accepted: axis, degrees"},
        Bad{"mesh = \"cube\"\ntransform = [ { translate = 5 } ]",
            "scene.toml:3:29: object.transform[0].translate is 5, accepted: three numbers in brackets, each "
            "a finite "
            "number (float32)"}));

INSTANTIATE_TEST_SUITE_P(
    Material, BadObject,
    testing::Values(Bad{"mesh = \"cube\"\nmaterial = \"wood\"",
                        "scene.toml:3:12: object.material is \"wood\", accepted: a table"},
                    Bad{"mesh = \"cube\"\nmaterial = { ambient = 1.5 }",
                        "scene.toml:3:24: object.material.ambient is 1.5, accepted: 0 to 1"},
                    Bad{"mesh = \"cube\"\nmaterial = { diffuse = -0.1 }",
                        "scene.toml:3:24: object.material.diffuse is -0.1, accepted: 0 to 1"},
                    Bad{"mesh = \"cube\"\nmaterial = { shininess = -1 }",
                        "scene.toml:3:26: object.material.shininess is -1, accepted: 0 or more (finite)"},
                    Bad{"mesh = \"cube\"\nmaterial = { color = [2, 0, 0] }",
                        "scene.toml:3:23: object.material.color[0] is 2, accepted: 0 to 1"},
                    Bad{"mesh = \"cube\"\nmaterial = { two_sided = 1 }",
                        "scene.toml:3:26: object.material.two_sided is 1, accepted: true or false"},
                    Bad{"mesh = \"cube\"\nmaterial = { texture = 4 }",
                        "scene.toml:3:24: object.material.texture is 4, accepted: a text in quotes"},
                    Bad{"mesh = \"cube\"\nmaterial = { shinyness = 4 }",
                        "scene.toml:3:14: unknown key object.material.shinyness, accepted: ambient, diffuse, "
                        "specular, shininess, "
                        "color, texture, two_sided, did you mean 'shininess'?"}));

}  // namespace
}  // namespace relevo::scene
