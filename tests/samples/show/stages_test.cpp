// The pictures of the stages: the right pixels in the frame, a page for every scene and size, the right
// counts.
#include "samples/show/stages.hpp"

#include <gtest/gtest.h>

#include "tests/samples/show/scenes.hpp"

namespace relevo::show {
namespace {

std::size_t stage_number(std::string_view name) {
    for (std::size_t i = 0; i < stages().size(); ++i)
        if (stages()[i].name == name) return i;
    ADD_FAILURE() << name;
    return 0;
}

std::int64_t count(const StagePage& page, std::string_view name) {
    for (const Count& c : page.counts)
        if (c.name == name) return std::get<std::int64_t>(c.value);
    ADD_FAILURE() << name;
    return -1;
}

TEST(Stages, HaveTheirFixedNamesAndOrder) {
    std::string names;
    for (const StageInfo& stage : stages()) names += std::string(stage.name) + " ";
    EXPECT_EQ(names,
              "object world eye clip clipped ndc window culled coverage depth visibility attributes flat "
              "gouraud phong "
              "texture final ");
    EXPECT_EQ(stage_file(0), "01-object.png");
    EXPECT_EQ(stage_file(16), "17-final.png");
}

TEST(Stages, FinalHoldsTheRenderedPicture) {
    for (const std::string& size :
         {std::string("width = 40\nheight = 30"), std::string("width = 301\nheight = 7")}) {
        std::string text = cube_scene;
        text.replace(text.find("width = 40\nheight = 30"), 22, size);
        for (const char* set : {"phong", "flat"}) {
            const scene::LoadedScene loaded = loaded_scene(text + "[pipeline]\nshading = \"" + set + "\"\n");
            raster::Frame frame = scene::make_frame(loaded);
            raster::draw(loaded.scene, loaded.settings, frame);
            const StagePage page = draw_stage(capture(loaded), stage_number("final"));
            // With a factor of 8 and more there is a grid on the first row and column of every pixel.
            for (int y = 0; y < loaded.height; ++y)
                for (int x = 0; x < loaded.width; ++x)
                    for (int sub = page.factor >= 8 ? 1 : 0; sub < page.factor; ++sub)
                        ASSERT_EQ(page.picture.at(page.pixels.x + x * page.factor + sub,
                                                  page.pixels.y + y * page.factor + sub),
                                  frame.color.at(x, y))
                            << x << ", " << y;
        }
    }
}

TEST(Stages, EveryStageHasAPageForEveryScene) {
    std::vector<std::string> texts{cube_scene, outside_scene, culled_scene};
    for (const char* size : {"width = 1\nheight = 1", "width = 3\nheight = 5", "width = 2048\nheight = 64"}) {
        texts.push_back(cube_scene);
        texts.back().replace(texts.back().find("width = 40\nheight = 30"), 22, size);
    }
    for (const std::string& text : texts) {
        const scene::LoadedScene loaded = loaded_scene(text);
        const Capture seen = capture(loaded);
        for (std::size_t i = 0; i < stages().size(); ++i) {
            const StagePage page = draw_stage(seen, i);
            EXPECT_GE(page.picture.width(), 1000) << stages()[i].name;
            EXPECT_LE(page.picture.width(), 2600) << stages()[i].name;
            EXPECT_LE(page.picture.height(), 1300) << stages()[i].name;
            EXPECT_FALSE(page.counts.empty()) << stages()[i].name;
        }
    }
}

TEST(Stages, CountsOfTheCube) {
    const scene::LoadedScene loaded = loaded_scene(cube_scene);
    const Capture seen = capture(loaded);
    EXPECT_EQ(count(draw_stage(seen, stage_number("object")), "triangles"), 12);
    EXPECT_EQ(count(draw_stage(seen, stage_number("clip")), "inside"), 12);
    EXPECT_EQ(count(draw_stage(seen, stage_number("clipped")), "polygons"), 12);
    const StagePage culled = draw_stage(seen, stage_number("culled"));
    EXPECT_EQ(count(culled, "front"), 4) << "the front and the top are seen";
    EXPECT_EQ(count(culled, "back"), 8);
    EXPECT_EQ(count(culled, "culled"), 8);
    const StagePage coverage = draw_stage(seen, stage_number("coverage"));
    EXPECT_EQ(count(coverage, "covered_pixels"), count(coverage, "fragments"))
        << "a convex body covers each pixel once";
    EXPECT_EQ(count(draw_stage(seen, stage_number("texture")), "textured_models"), 0);
}

// Two squares behind each other, the far one first: every pixel of the near one is shaded twice.
const std::string two_squares = R"([image]
width = 40
height = 30
[camera]
projection = "orthographic"
height = 30
eye = [0, 0, 5]
target = [0, 0, 0]
[[object]]
mesh = "plane"
transform = [{ rotate = { axis = [1, 0, 0], degrees = 90 } }, { scale = 10 }]
[[object]]
mesh = "plane"
transform = [{ rotate = { axis = [1, 0, 0], degrees = 90 } }, { scale = 4 }, { translate = [0, 0, 1] }]
)";

TEST(Stages, VisibilityCountsWhatTheTextbookPathShadesInVain) {
    const StagePage page = draw_stage(capture(loaded_scene(two_squares)), stage_number("visibility"));
    EXPECT_EQ(count(page, "triangles_seen"), 4);
    EXPECT_EQ(count(page, "visible_pixels"), 100);
    EXPECT_EQ(count(page, "textbook_shaded"), 100 + 16);
    EXPECT_EQ(count(page, "most_pixels"), 55 - 10);  // with and without the diagonal
    EXPECT_EQ(count(page, "fewest_pixels"), 6);
    EXPECT_EQ(std::get<double>(page.counts.back().value), 1.16);
}

// The fast path knows it without a probe.
TEST(Stages, BothPathsSeeTheSameTriangles) {
    for (const std::string& text : {cube_scene, two_squares, outside_scene}) {
        const Capture fast = capture(loaded_scene(text + "[pipeline]\npath = \"fast\"\n")),
                      textbook = capture(loaded_scene(text + "[pipeline]\npath = \"textbook\"\n"));
        EXPECT_EQ(fast.visible.pixels(), textbook.visible.pixels());
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x)
                ASSERT_EQ(fast.visible.at(x, y), fast.seen.pixels.pixels.at(x, y).primitive);
    }
}

TEST(Stages, NothingToSeeIsCountedAsNothing) {
    for (const std::string& text : {outside_scene, culled_scene}) {
        const scene::LoadedScene loaded = loaded_scene(text);
        const Capture seen = capture(loaded);
        EXPECT_EQ(count(draw_stage(seen, stage_number("coverage")), "covered_pixels"), 0);
        EXPECT_EQ(count(draw_stage(seen, stage_number("visibility")), "visible_pixels"), 0);
        EXPECT_EQ(count(draw_stage(seen, stage_number("culled")), "kept"), 0);
        EXPECT_EQ(count(draw_stage(seen, stage_number("final")), "drawn_fragments"), 0);
    }
    const scene::LoadedScene outside = loaded_scene(outside_scene);
    EXPECT_EQ(count(draw_stage(capture(outside), stage_number("clip")), "outside"), 12);
    EXPECT_EQ(count(draw_stage(capture(outside), stage_number("clipped")), "polygons"), 0);
}

TEST(Stages, TheProbesMoveNoPixel) {
    const scene::LoadedScene loaded = loaded_scene(cube_scene);
    raster::Frame frame = scene::make_frame(loaded);
    raster::Settings settings = loaded.settings;
    settings.shading = raster::Shading::Phong;
    raster::draw(loaded.scene, settings, frame);
    EXPECT_EQ(capture(loaded).depth.pixels(), frame.depth.pixels());
}

TEST(Stages, APictureIsTheSameEveryTime) {
    const scene::LoadedScene loaded = loaded_scene(cube_scene);
    const Capture first = capture(loaded), second = capture(loaded);
    for (std::size_t i = 0; i < stages().size(); ++i)
        EXPECT_EQ(draw_stage(first, i).picture.pixels(), draw_stage(second, i).picture.pixels())
            << stages()[i].name;
}

}  // namespace
}  // namespace relevo::show
