// Scene files: every key, every default, every error with its place.
#include "samples/scene/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "samples/scene/choices.hpp"
#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::scene {
namespace {

using io::TemporaryFolder;
using pipeline::LinearRgb;
using pipeline::Scalar;

LoadedScene parsed(const std::string& text, const SceneOptions& options = {}) {
    auto scene = parse_scene(text, "scene.toml", options);
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? std::move(*scene) : LoadedScene{};
}

std::string error_of(const std::string& text, const SceneOptions& options = {}) {
    const auto scene = parse_scene(text, "scene.toml", options);
    return scene ? "no error" : scene.error().text();
}

const std::string cube = "[[object]]\nmesh = \"cube\"\n";

// ---------------------------------------------------------------------------------------------- what is read

TEST(Scene, OneObjectIsEnough) {
    const LoadedScene s = parsed(cube);
    EXPECT_EQ(s.name, "scene");
    EXPECT_EQ(s.width, 640);
    EXPECT_EQ(s.height, 480);
    EXPECT_EQ(s.scene.background, (LinearRgb{Scalar(0.1), Scalar(0.1), Scalar(0.12)}));
    EXPECT_EQ(s.settings.output, raster::Output::Srgb);
    EXPECT_EQ(s.settings.shading, raster::Shading::Phong);
    EXPECT_EQ(s.settings.texture_filter, raster::Filter::Bilinear);
    EXPECT_EQ(s.settings.depth, raster::DepthFormat::Float32Reversed);
    EXPECT_EQ(s.settings.cull, pipeline::Cull::Back);
    EXPECT_EQ(s.settings.path, raster::Path::Auto);
    EXPECT_EQ(s.settings.instruction_set, std::nullopt);
    ASSERT_EQ(s.scene.models.size(), 1u);
    EXPECT_EQ(s.scene.models[0].mesh->triangles(), 12u);
    EXPECT_EQ(s.scene.models[0].texture, nullptr);
    EXPECT_EQ(s.descriptions[0].name, "cube");
    EXPECT_EQ(s.scene.lights.size(), 1u);
    EXPECT_TRUE(s.camera.framed);
}

TEST(Scene, ReadsEveryKeyOfImageAndPipeline) {
    const LoadedScene s = parsed(R"([image]
width = 8192
height = 1
background = [0, 0.5, 1]
output = "raw"
[pipeline]
shading = "gouraud"
texture_filter = "nearest"
depth = "float32-forward"
cull = "none"
path = "textbook"
instruction_set = "auto"
)" + cube);
    EXPECT_EQ(s.width, 8192);
    EXPECT_EQ(s.height, 1);
    EXPECT_EQ(s.scene.background, (LinearRgb{0, Scalar(0.5), 1}));
    EXPECT_EQ(s.settings.output, raster::Output::Raw);
    EXPECT_EQ(s.settings.shading, raster::Shading::Gouraud);
    EXPECT_EQ(s.settings.texture_filter, raster::Filter::Nearest);
    EXPECT_EQ(s.settings.depth, raster::DepthFormat::Float32Forward);
    EXPECT_EQ(s.settings.cull, pipeline::Cull::None);
    EXPECT_EQ(s.settings.path, raster::Path::Textbook);
    EXPECT_EQ(s.settings.instruction_set, std::nullopt);
}

TEST(Scene, ReadsEveryPath) {
    const auto with = [](const std::string& path) {
        return parsed(cube, {{"path=" + path}, {}}).settings.path;
    };
    EXPECT_EQ(with("auto"), raster::Path::Auto);
    EXPECT_EQ(with("fast"), raster::Path::Fast);
    EXPECT_EQ(with("textbook"), raster::Path::Textbook);
    EXPECT_EQ(error_of(cube, {{"path=quick"}, {}}),
              "--set path=quick: pipeline.path is \"quick\", accepted: auto, fast, textbook");
}

// An instruction set that this processor (or this build) lacks is refused; the message names those it has.
TEST(Scene, TakesTheInstructionSetsThatAreThere) {
    const auto there = raster::fast::instruction_sets();
    std::string names = "auto";
    for (const raster::fast::InstructionSet set : there)
        names += ", " + std::string(name_of(std::optional(set), instruction_sets));
    for (const auto& choice : instruction_sets) {
        const std::string option = "instruction_set=" + std::string(choice.name);
        if (!choice.meaning || std::find(there.begin(), there.end(), *choice.meaning) != there.end())
            EXPECT_EQ(parsed(cube, {{option}, {}}).settings.instruction_set, choice.meaning);
        else
            EXPECT_EQ(error_of(cube, {{option}, {}}),
                      "--set " + option + ": pipeline.instruction_set is \"" + std::string(choice.name) +
                          "\", accepted: " + names + " (what this processor and this build have)");
    }
}

TEST(Scene, ReadsEveryShadingAndCull) {
    const std::pair<const char*, raster::Shading> shadings[] = {{"unlit", raster::Shading::Unlit},
                                                                {"flat", raster::Shading::Flat},
                                                                {"gouraud", raster::Shading::Gouraud},
                                                                {"phong", raster::Shading::Phong}};
    for (const auto& [word, meaning] : shadings)
        EXPECT_EQ(parsed(cube + "[pipeline]\nshading = \"" + word + "\"\n").settings.shading, meaning);
    EXPECT_EQ(parsed(cube + "[pipeline]\ncull = \"front\"\n").settings.cull, pipeline::Cull::Front);
}

TEST(Scene, ReadsLights) {
    const LoadedScene s = parsed(cube + R"([[light]]
position = [1, 2, 3]
color = [4, 5, 6]
[[light]]
type = "directional"
direction = [0, -2, 0]
)");
    ASSERT_EQ(s.scene.lights.size(), 2u);
    EXPECT_EQ(s.scene.lights[0].kind, pipeline::Light::Kind::Point);
    EXPECT_EQ(s.scene.lights[0].position.v, pipeline::Vec3(1, 2, 3));
    EXPECT_EQ(s.scene.lights[0].color, (LinearRgb{4, 5, 6}));
    EXPECT_EQ(s.scene.lights[1].kind, pipeline::Light::Kind::Directional);
    EXPECT_EQ(s.scene.lights[1].direction.v, pipeline::Vec3(0, -2, 0));
    EXPECT_EQ(s.scene.lights[1].color, (LinearRgb{1, 1, 1}));
}

TEST(Scene, TheDefaultLightShinesOnWhatTheCameraSees) {
    const LoadedScene s = parsed(cube + "[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\n");
    const auto p = s.scene.lights.at(0).position.v;  // right of, above and behind the eye
    EXPECT_GT(p.x, 0);
    EXPECT_GT(p.y, 0);
    EXPECT_GT(p.z, 10);
}

TEST(Scene, OptionsReplaceKeysOfThePipelineAndTheSize) {
    const LoadedScene s = parsed(cube + "[pipeline]\nshading = \"flat\"\n",
                                 {{"shading=gouraud", "cull=none", "shading=unlit"}, std::pair(7, 9)});
    EXPECT_EQ(s.settings.shading, raster::Shading::Unlit);
    EXPECT_EQ(s.settings.cull, pipeline::Cull::None);
    EXPECT_EQ(s.width, 7);
    EXPECT_EQ(s.height, 9);
}

TEST(Scene, AMovedSceneKeepsItsMeshes) {
    LoadedScene first = parsed(cube);
    const LoadedScene second = std::move(first);
    EXPECT_EQ(second.scene.models[0].mesh, second.meshes[0].get());
}

TEST(Scene, SizesAreReadFromTwoWholeNumbers) {
    EXPECT_EQ(*parse_size("1x8192"), (std::pair{1, 8192}));
    for (const char* bad : {"", "x", "3", "3x", "x3", "3x4x5", "3x4 ", " 3x4", "0x4", "4x0", "-1x4", "3X4",
                            "8193x1", "1x8193", "1e9x1e9", "1000000000x1000000000", "99999999999x1", "1.5x2"})
        EXPECT_EQ(
            parse_size(bad).error().text(),
            "--size " + std::string(bad) + ": accepted: WIDTHxHEIGHT, two whole numbers from 1 to 8192");
}

TEST(Scene, FramesHaveItsSize) {
    const raster::Frame frame = make_frame(parsed("[image]\nwidth = 3\nheight = 5\n" + cube));
    EXPECT_EQ(frame.color.width(), 3);
    EXPECT_EQ(frame.depth.height(), 5);
    EXPECT_TRUE(frame.linear.empty());
}

// ---------------------------------------------------------------------------------------------- what is
// refused

struct Bad {
    const char *text, *error;
};

class BadScene : public testing::TestWithParam<Bad> {};

TEST_P(BadScene, IsRefusedAtItsPlace) { EXPECT_EQ(error_of(GetParam().text), GetParam().error); }

INSTANTIATE_TEST_SUITE_P(
    Document, BadScene,
    testing::Values(
        Bad{"[image]\nwidth = 5\n",
            "scene.toml: there is no [[object]] with a mesh and no [[shape2d]]: a scene needs at least one"},
        Bad{"width = 3\n[[object]]\nmesh = \"cube\"",
            "scene.toml:1:1: unknown table or key width, accepted: [image], [camera], [[light]], "
            "[[object]], [animation], [axes], [clip], [[shape2d]], [pipeline]"},
        Bad{"[[objekt]]\nmesh = \"cube\"",
            "scene.toml:1:3: unknown table or key objekt, accepted: [image], [camera], "
            "[[light]], [[object]], [animation], [axes], [clip], [[shape2d]], [pipeline], did you mean "
            "'object'?"},
        Bad{"[object]\nmesh = \"cube\"",
            "scene.toml:1:2: [object] is one table, accepted: [[object]], which may be repeated"},
        Bad{"[[image]]\nwidth = 3\n[[object]]\nmesh = \"cube\"",
            "scene.toml:1:1: image is a list, accepted: a table"},
        Bad{"camera = 3\n[[object]]\nmesh = \"cube\"", "scene.toml:1:10: camera is 3, accepted: a table"},
        Bad{"object = [1]", "scene.toml:1:11: object is 1, accepted: a table"},
        Bad{"[[object]]\nmesh = \"cube\"\n[animations]\nframes = 3",
            "scene.toml:3:2: unknown table or key animations, accepted: [image], [camera], [[light]], "
            "[[object]], [animation], [axes], [clip], [[shape2d]], [pipeline], did you mean 'animation'?"}));

INSTANTIATE_TEST_SUITE_P(
    Image, BadScene,
    testing::Values(
        Bad{"[image]\nwidht = 5\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:1: unknown key image.widht, accepted: width, height, background, output, did you "
            "mean "
            "'width'?"},
        Bad{"[image]\nwidth = 0\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:9: image.width is 0, accepted: a whole number from 1 to 8192"},
        Bad{"[image]\nheight = 8193\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:10: image.height is 8193, accepted: a whole number from 1 to 8192"},
        Bad{"[image]\nheight = 1e9\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:10: image.height is 1000000000, accepted: a whole number from 1 to 8192"},
        Bad{"[image]\nwidth = 4.5\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:9: image.width is 4.5, accepted: a whole number from 1 to 8192"},
        Bad{"[image]\nwidth = 9223372036854775807\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:9: image.width is 9223372036854775807, accepted: a whole number from 1 to 8192"},
        Bad{"[image]\nbackground = 3\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:14: image.background is 3, accepted: three numbers in brackets, each 0 to 1"},
        Bad{"[image]\nbackground = [0, 1]\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:14: image.background is a list of 2, accepted: three numbers in brackets, each 0 "
            "to 1"},
        Bad{"[image]\nbackground = [0, 1, nan]\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:21: image.background[2] is nan, accepted: 0 to 1"},
        Bad{"[image]\nbackground = [0, -1, 0]\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:18: image.background[1] is -1, accepted: 0 to 1"},
        Bad{"[image]\noutput = \"rgb\"\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:10: image.output is \"rgb\", accepted: srgb, raw, did you mean 'srgb'?"},
        Bad{"[image]\noutput = 2020-01-01\n[[object]]\nmesh = \"cube\"",
            "scene.toml:2:10: image.output is a date or time, accepted: srgb, raw"}));

INSTANTIATE_TEST_SUITE_P(
    Pipeline, BadScene,
    testing::Values(
        Bad{"[[object]]\nmesh = \"cube\"\n[pipeline]\nshading = \"fong\"",
            "scene.toml:4:11: pipeline.shading is \"fong\", accepted: unlit, flat, gouraud, phong"},
        Bad{"[[object]]\nmesh = \"cube\"\n[pipeline]\nshading = \"phon\"",
            "scene.toml:4:11: pipeline.shading is \"phon\", accepted: unlit, flat, gouraud, phong, did you "
            "mean "
            "'phong'?"},
        Bad{"[[object]]\nmesh = \"cube\"\n[pipeline]\ncull = true",
            "scene.toml:4:8: pipeline.cull is true, accepted: back, front, none"},
        Bad{"[[object]]\nmesh = \"cube\"\n[pipeline]\ndepth = \"unorm24\"",
            "scene.toml:4:9: pipeline.depth is \"unorm24\", accepted: float32-reversed, float32-forward"},
        Bad{"[[object]]\nmesh = \"cube\"\n[pipeline]\ntexture = \"nearest\"",
            "scene.toml:4:1: unknown key pipeline.texture, accepted: shading, texture_filter, depth, cull, "
            "path, instruction_set"}));

INSTANTIATE_TEST_SUITE_P(
    Lights, BadScene,
    testing::Values(
        Bad{"[[object]]\nmesh = \"cube\"\n[light]\ntype = \"point\"",
            "scene.toml:3:2: [light] is one table, accepted: [[light]], which may be repeated"},
        Bad{"[[object]]\nmesh = \"cube\"\n[[light]]\ntype = \"spot\"",
            "scene.toml:4:8: light.type is \"spot\", accepted: point, directional"},
        Bad{"[[object]]\nmesh = \"cube\"\n[[light]]\ncolour = [1, 1, 1]",
            "scene.toml:4:1: unknown key light.colour, accepted: type, position, direction, color, did you "
            "mean "
            "'color'?"},
        Bad{"[[object]]\nmesh = \"cube\"\n[[light]]\ncolor = [1, 1, -0.5]",
            "scene.toml:4:16: light.color[2] is -0.5, accepted: 0 or more (finite)"},
        Bad{"[[object]]\nmesh = \"cube\"\n[[light]]\nposition = [1, inf, 0]",
            "scene.toml:4:16: light.position[1] is inf, accepted: a finite number (float32)"},
        Bad{"[[object]]\nmesh = \"cube\"\n[[light]]\nposition = [1, 1e39, 0]",
            "scene.toml:4:16: light.position[1] is 1e+39, accepted: a finite number (float32)"},
        Bad{"[[object]]\nmesh = \"cube\"\n[[light]]\nposition = [\"a\", 1, 0]",
            "scene.toml:4:13: light.position[0] is \"a\", accepted: a number, a finite number (float32)"},
        Bad{"[[object]]\nmesh = \"cube\"\n[[light]]\ndirection = [0, 1, 0]",
            "scene.toml:4:13: light.direction is for type = \"directional\" only"},
        Bad{"[[object]]\nmesh = \"cube\"\n[[light]]\ntype = \"directional\"\nposition = [0, 1, 0]",
            "scene.toml:5:12: light.position is for type = \"point\" only"},
        Bad{"[[object]]\nmesh = \"cube\"\n[[light]]\ntype = \"directional\"\ndirection = [0, 0, 0]",
            "scene.toml:5:13: light.direction is a list, accepted: the way the light travels, three numbers "
            "that are "
            "not all 0"}));

TEST(BadScenes, WrongTomlIsSaidWithItsPlace) {
    const std::string error = error_of("[[object]]\nmesh = \"cube\n");
    EXPECT_EQ(error.substr(0, 38), "scene.toml:2:13: this is not TOML: Err") << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
}

// A path of 16 letters and more lives on the heap: an error on the way destroys it once.
TEST(BadScenes, WrongTomlInAFileWithALongNameIsSaidToo) {
    const std::string path = "a folder with a long name/and a scene with a long name.toml";
    for (const char* text : {"x = @", "[= a]", "[[object]]\nmesh = \"cube\n"}) {
        const auto scene = parse_scene(text, path);
        ASSERT_FALSE(scene);
        EXPECT_EQ(scene.error().place.file, path);
        EXPECT_EQ(scene.error().message.substr(0, 16), "this is not TOML");
    }
}

TEST(BadScenes, WhatTheParserOfTomlAssertsIsAnErrorToo) {
    EXPECT_EQ(error_of("# \xc3\xa4\n[image]\n[= a]\n[= b]"),
              "scene.toml:3:2: this is not TOML: unexpected here");
}

TEST(BadScenes, AnyDamageIsAnErrorInOneLineOrAScene) {
    const std::string whole =
        "[image]\nwidth = 9\n[camera]\neye = [1, 2, 3]\n[[object]]\nmesh = \"cube\"\n"
        "transform = [{ rotate = { axis = [0, 1, 0], degrees = 3 } }]\n";
    for (std::size_t cut = 0; cut < whole.size(); ++cut)
        for (const char* with : {"", "\"", "[", "\xff", "= ", "nan", "\n\n", "{"}) {
            std::string text = whole;
            text.replace(cut, 1, with);
            const std::string error = error_of(text);
            EXPECT_EQ(error.find('\n'), std::string::npos) << text;
            EXPECT_EQ(error == "no error" || error.starts_with("scene.toml"), true) << error;
        }
}

TEST(BadOptions, AreSaidAsTheyWereWritten) {
    const auto with = [](const std::string& option) { return error_of(cube, {{option}, std::nullopt}); };
    EXPECT_EQ(with("shading=phog"),
              "--set shading=phog: pipeline.shading is \"phog\", accepted: unlit, flat, gouraud, phong, did "
              "you mean "
              "'phong'?");
    EXPECT_EQ(with("shadng=flat"),
              "--set shadng=flat: unknown key pipeline.shadng, accepted: shading, texture_filter, depth, "
              "cull, path, instruction_set, did "
              "you mean 'shading'?");
    for (const std::string none : {"shading", "=flat", ""})
        EXPECT_EQ(with(none),
                  "--set " + none +
                      ": accepted: key=value, with a key of [pipeline]: shading, texture_filter, depth, "
                      "cull, path, instruction_set");
    EXPECT_EQ(error_of(cube, {{}, std::pair(0, 0)}),
              "--size 0x0: accepted: WIDTHxHEIGHT, two whole numbers from 1 to 8192");
}

TEST(BadFiles, AreSaidByName) {
    const TemporaryFolder folder;
    const auto error = [&](const std::string& name) {
        const auto scene = load_scene(folder.path(name));
        return scene ? "no error" : folder.without_path(scene.error().text());
    };
    EXPECT_EQ(error("none.toml"), "none.toml: there is no such file");
    folder.write("empty.toml", "");
    EXPECT_EQ(error("empty.toml").substr(0, 12), "empty.toml: ");
    folder.write("binary.toml", std::string("a\0b", 3));
    EXPECT_EQ(error("binary.toml").substr(0, 11), "binary.toml");
    EXPECT_EQ(error("").find("no error"), std::string::npos);
}

}  // namespace
}  // namespace relevo::scene
