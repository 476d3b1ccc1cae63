// relevo render of scenes with reliefs and animations, as a user runs it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>

#include "samples/io/relief_file.hpp"
#include "tests/samples/relevo/program.hpp"

namespace relevo::command {
namespace {

using io::TemporaryFolder;

const std::string turn = R"([image]
width = 40
height = 30
[animation]
radius = 3
target = [0, 0, 0]
frames = 3
[[object]]
surface = "sphere"
representation = "REP"
[object.relief]
texels = 16
)";
std::string turn_of(const std::string& representation) {
    std::string text = turn;
    return text.replace(text.find("REP"), 3, representation);
}
bool exists(const TemporaryFolder& folder, const std::string& file) {
    return std::filesystem::exists(folder.path(file));
}

TEST(RenderRelief, AnAnimationIsARowOfNumberedPictures) {
    const TemporaryFolder folder;
    folder.write("turn.toml", turn_of("relief-box"));
    const Outcome all = run(folder, "render turn.toml");
    EXPECT_EQ(all.status, 0) << all.err;
    EXPECT_EQ(all.out + all.err, "");
    EXPECT_TRUE(exists(folder, "turn-0000.png") && exists(folder, "turn-0001.png") &&
                exists(folder, "turn-0002.png"));
    EXPECT_FALSE(exists(folder, "turn-0003.png") || exists(folder, "turn.png"));
    ASSERT_EQ(run(folder, "render turn.toml -o some.png --raw-depth z.exr --frames 1-2").status, 0);
    EXPECT_FALSE(exists(folder, "some-0000.png"));
    EXPECT_TRUE(exists(folder, "some-0002.png") && exists(folder, "z-0001.exr"));
    EXPECT_EQ(io::bytes_of(folder.path("some-0001.png")), io::bytes_of(folder.path("turn-0001.png")));
    ASSERT_EQ(run(folder, "render turn.toml -o one.png --frames 1 --threads 1").status, 0);
    EXPECT_EQ(io::bytes_of(folder.path("one-0001.png")), io::bytes_of(folder.path("turn-0001.png")));
    EXPECT_NE(io::bytes_of(folder.path("turn-0000.png")), io::bytes_of(folder.path("turn-0001.png")));
}

TEST(RenderRelief, WrongFramesAreRefused) {
    const TemporaryFolder folder;
    folder.write("turn.toml", turn_of("relief-box"));
    folder.write("still.toml", "[[object]]\nmesh = \"cube\"\n");
    folder.write("lesson.toml", "[[shape2d]]\ntype = \"line\"\npoints = [[0, 0], [9, 9]]\n");
    for (const std::string frames : {"1-3", "2-1", "-1", "x", "1-", "1-2-3"}) {
        const Outcome wrong = run(folder, "render turn.toml --frames=" + frames);
        EXPECT_EQ(wrong.status, 2) << frames;
        EXPECT_EQ(wrong.err, "--frames " + frames + ": accepted: A-B or A, whole numbers from 0 to 2\n");
    }
    EXPECT_EQ(run(folder, "render still.toml --frames 0").err,
              "--frames 0: this scene has no [animation], and so a single picture\n");
    EXPECT_EQ(run(folder, "render lesson.toml --frames 0").err,
              "--frames 0: a lesson has one picture; only scenes with [animation] have frames\n");
}

TEST(RenderRelief, AReliefSeenFromBehindIsDrawnAsGeometryWithAWarning) {
    const TemporaryFolder folder;
    folder.write("turn.toml", turn_of("relief"));
    const Outcome outcome = run(folder, "render turn.toml");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(
        outcome.err,
        "warning: frame 1: turn.toml:10:18: sphere: drawn as geometry: the viewer must lie in front of the "
        "relief's plane, not on it or behind: choose another face, or draw the geometry\n"
        "warning: frame 2: turn.toml:10:18: sphere: drawn as geometry: the viewer must lie in front of the "
        "relief's plane, not on it or behind: choose another face, or draw the geometry\n");
}

TEST(RenderRelief, TheReliefItselfIsWritten) {
    const TemporaryFolder folder;
    folder.write("turn.toml", turn_of("relief"));
    folder.write("still.toml", "[[object]]\nmesh = \"cube\"\n");
    const Outcome outcome = run(folder, "render turn.toml --frames 0 --relief ball.json");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const auto texture = io::read_relief(folder.path("ball.json"));
    ASSERT_TRUE(texture) << texture.error().text();
    EXPECT_EQ(texture->camera.width, 16);
    EXPECT_EQ(texture->coverage.at(8, 8), 1);
    EXPECT_NEAR(texture->depth.at(8, 8), 0, 0.01);  // the ball touches the plane
    EXPECT_EQ(run(folder, "render still.toml --relief none.json").err,
              "--relief none.json: this scene has no object that is shown by pictures (representation)\n");
    // before a scene is read, let alone its pictures taken
    EXPECT_EQ(run(folder, "render missing.toml --relief ball.exr").err,
              "ball.exr: cannot be written: the name of a relief texture ends in .json\n");
}

TEST(RenderRelief, EverySampleSceneIsDrawnAndTakenApart) {
    const TemporaryFolder folder;
    for (const auto& entry :
         std::filesystem::directory_iterator(RELEVO_SOURCE_DIR "/samples/scenes/relief")) {
        const std::string scene = "'" + entry.path().string() + "'";
        const Outcome drawn = run(folder, "render " + scene + " --size 64x48 -o picture.png");
        EXPECT_EQ(drawn.status, 0) << scene;
        EXPECT_EQ(drawn.err, "") << scene;
        const Outcome steps =
            run(folder, "steps " + scene + " --size 64x48 -o steps --stage final --stage relief-map");
        EXPECT_EQ(steps.status, 0) << scene << steps.err;
    }
}

TEST(RenderRelief, StatisticsTellWhatPicturesWereTaken) {
    const TemporaryFolder folder;
    const auto scene = [](const std::string& representation) {
        return "[image]\nwidth = 40\nheight = 30\n[camera]\neye = [0, 0, 4]\ntarget = [0, 0, 0]\n"
               "[[object]]\nsurface = \"sphere\"\nname = \"a \\\"ball\\\"\"\nrepresentation = \"" +
               representation + "\"\n[object.relief]\ntexels = 16\n";
    };
    folder.write("s.toml", scene("relief"));
    const std::string text = run(folder, "render --stats s.toml").out;
    EXPECT_NE(
        text.find("         256  texels of a \"ball\", drawn as relief: one picture of 16 x 16, 208 texels "
                  "covered\n"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("milliseconds to take the pictures\n"), std::string::npos);
    folder.write("s.toml", scene("relief-box"));
    const std::string box = run(folder, "render --stats s.toml").out;
    EXPECT_NE(box.find("        1536  texels of a \"ball\", drawn as relief-box: 6 pictures of 16 x 16, "),
              std::string::npos)
        << box;
    const auto json = nlohmann::json::parse(run(folder, "render --stats=json s.toml").out);
    ASSERT_EQ(json["pictures"].size(), 1u);
    EXPECT_EQ(json["pictures"][0]["object"], "a \"ball\"");
    EXPECT_EQ(json["pictures"][0]["representation"], "relief-box");
    EXPECT_EQ(json["pictures"][0]["texels"], 6 * 256);
    EXPECT_TRUE(json["milliseconds"].contains("pictures"));
    // without such objects there is no such line
    folder.write("s.toml", "[[object]]\nmesh = \"cube\"\n");
    EXPECT_EQ(run(folder, "render --stats s.toml").out.find("pictures"), std::string::npos);
    EXPECT_EQ(run(folder, "render --stats=json s.toml").out.find("pictures"), std::string::npos);
}

}  // namespace
}  // namespace relevo::command
