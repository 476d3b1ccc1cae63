// relevo render and relevo list with lessons, from outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "samples/io/picture.hpp"
#include "tests/samples/relevo/program.hpp"

namespace relevo::command {
namespace {

using io::TemporaryFolder;
using Names = std::vector<std::string>;

const std::string lesson =
    "[image]\noutput = \"raw\"\nbackground = [0, 0, 0]\n[axes]\nextent = [0, 0, 3, 2]\n"
    "[[shape2d]]\ntype = \"rectangle\"\npoints = [[1, 0], [3, 1]]\n";

void expect_refused(const TemporaryFolder& folder, const std::string& arguments, const std::string& error) {
    const Names before = folder.names();
    const Outcome outcome = run(folder, arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.err, error + "\n") << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(folder.names(), before) << arguments;
}

// '#' for white, '.' for black, one row after the other.
std::string pixels(const TemporaryFolder& folder, const std::string& name) {
    const auto picture = io::read_image(folder.path(name));
    if (!picture) return picture.error().text();
    std::string out;
    for (int y = 0; y < picture->height(); ++y) {
        for (int x = 0; x < picture->width(); ++x)
            out += picture->at(x, y).r == 255 ? '#' : picture->at(x, y).r == 0 ? '.' : '+';
        out += '\n';
    }
    return out;
}

TEST(RenderLesson, WritesOnePixelAPixelOrMore) {
    const TemporaryFolder folder;
    folder.write("s.toml", lesson);
    const Outcome outcome = run(folder, "render s.toml");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_EQ(pixels(folder, "s.png"), ".##.\n....\n....\n");
    folder.write("t.toml", "[image]\nzoom = 2\n" + lesson.substr(8));
    ASSERT_EQ(run(folder, "render t.toml").status, 0);
    EXPECT_EQ(pixels(folder, "t.png"), "..####..\n..####..\n........\n........\n........\n........\n");
}

TEST(RenderLesson, SetChangesItsPipeline) {
    const TemporaryFolder folder;
    folder.write("s.toml", lesson);
    ASSERT_EQ(run(folder, "render s.toml --set fill_rule=book").status, 0);
    EXPECT_EQ(pixels(folder, "s.png"), "....\n.##.\n....\n");
    ASSERT_EQ(run(folder, "render s.toml --set antialiasing=supersample --set samples=2").status, 0);
    EXPECT_EQ(pixels(folder, "s.png"), ".+++\n.+++\n....\n");
    expect_refused(
        folder, "render s.toml --set algorithm=midpoint",
        "--set algorithm=midpoint: pipeline.algorithm is \"midpoint\", which no shape of this scene "
        "takes (a shape's own keys come first)");
    expect_refused(folder, "render s.toml --set shading=flat",
                   "--set shading=flat: unknown key pipeline.shading, accepted: fill_rule, algorithm, "
                   "antialiasing, samples");
    expect_refused(
        folder, "render s.toml --set fill_rule=bok",
        "--set fill_rule=bok: pipeline.fill_rule is \"bok\", accepted: top-left, book, did you mean "
        "'book'?");
}

TEST(RenderLesson, HasNoDepthAndNoOtherSize) {
    const TemporaryFolder folder;
    folder.write("s.toml", lesson);
    expect_refused(folder, "render s.toml --raw-depth d.exr",
                   "--raw-depth d.exr: a lesson has no depth buffer; only scenes of [[object]]s have one");
    expect_refused(folder, "render s.toml --size 9x9",
                   "--size 9x9: the picture of a lesson with axes.extent is 4x3; image.zoom enlarges it");
}

TEST(RenderLesson, StatisticsCountPixels) {
    const TemporaryFolder folder;
    folder.write("s.toml", lesson + "[[shape2d]]\ntype = \"line\"\npoints = [[2, 0], [2, 1]]\n");
    const Outcome json = run(folder, "render s.toml --stats=json");
    EXPECT_EQ(json.status, 0) << json.err;
    const std::string right =
        "{\"counts\": {\"shapes\": 2, \"refused\": 0, \"cut\": 0, \"gone\": 0, \"spans\": 3, \"painted\": 4, "
        "\"partly\": 0, \"lit\": 3, \"area\": 4}, \"milliseconds\": {\"load\": ";
    EXPECT_EQ(json.out.substr(0, right.size()), right);
    const Outcome text = run(folder, "render s.toml --stats");
    EXPECT_NE(text.out.find("           3  different pixels lit\n"), std::string::npos) << text.out;
}

TEST(RenderLesson, RefusesBadLessons) {
    const TemporaryFolder folder;
    const auto with = [&](const std::string& more, const std::string& error) {
        folder.write("s.toml", lesson + more);
        expect_refused(folder, "render s.toml", error);
    };
    with("[[object]]\nmesh = \"cube\"\n",
         "s.toml:9:3: a scene is made of [[object]]s or of [[shape2d]]s, not of both");
    with("[camera]\n", "s.toml:9:2: camera is for [[object]]s, and this scene is made of [[shape2d]]s");
    with("algorithm = \"bresenham\"\n",
         "s.toml:9:13: shape2d.algorithm is \"bresenham\", accepted: midpoint, second-order, textbook, dda, "
         "explicit, wu, gupta-sproull, scanline, edge-function, active-edges");
    with("[clip]\nwindow = [3, 0, 1, 2]\n",
         "s.toml:10:10: clip.window is [3, 0, 1, 2], accepted: [x0, y0, x1, y1] with x0 <= x1 and y0 <= y1");
}

// The largest polygon, a walk all over the picture: it is drawn.
TEST(RenderLesson, APolygonOfAMillionCorners) {
    const TemporaryFolder folder;
    std::string text = "[image]\nwidth = 64\nheight = 64\n[[shape2d]]\ntype = \"polygon\"\npoints = [";
    unsigned state = 1, x = 32, y = 32;
    for (int i = 0; i < 1'000'000; ++i) {
        state = state * 1664525u + 1013904223u;
        x = (x + (state >> 20) % 3 + 63) % 64, y = (y + (state >> 24) % 3 + 63) % 64;
        text += "[" + std::to_string(x) + "," + std::to_string(y) + "],";
    }
    folder.write("million.toml", text + "]\n");
    const Outcome outcome = run(folder, "render million.toml --stats=json");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("\"shapes\": 1"), std::string::npos) << outcome.out;
    text.insert(text.find('[', text.find("points")) + 1, "[1,1],");
    folder.write("more.toml", text + "]\n");
    EXPECT_EQ(run(folder, "render more.toml").err,
              "more.toml:6:10: shape2d.points is a list of 1000001, accepted: 3 to 1000000 corners [x, y]\n");
}

TEST(RenderLesson, EverySampleLessonIsDrawn) {
    const TemporaryFolder folder;
    int lessons = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(RELEVO_SOURCE_DIR "/samples/scenes/lessons")) {
        ++lessons;
        const std::string name = entry.path().stem().string();
        const Outcome outcome = run(folder, "render '" + entry.path().string() + "' -o " + name + ".png");
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "") << name << ": no warning";
        EXPECT_TRUE(io::read_image(folder.path(name + ".png"))) << name;
    }
    EXPECT_GE(lessons, 40);
}

// The names of all events that the core notes.
std::set<std::string> noted_events() {
    std::set<std::string> names;
    const std::regex noted("note<([A-Za-z]+)>");
    for (const char* folder : {"pipeline", "raster"})
        for (const auto& entry :
             std::filesystem::directory_iterator(RELEVO_SOURCE_DIR "/" + std::string(folder))) {
            if (entry.path().extension() != ".hpp") continue;
            const std::string text = io::bytes_of(entry.path().string());
            for (std::sregex_iterator i(text.begin(), text.end(), noted), end; i != end; ++i)
                names.insert((*i)[1]);
        }
    names.erase("Event");  // of the example in probe.hpp
    return names;
}

TEST(List, NamesEveryEventAndEveryWordOfLessons) {
    const TemporaryFolder folder;
    const std::string events = run(folder, "list events").out;
    EXPECT_GE(noted_events().size(), 50u);
    for (const std::string& event : noted_events())
        EXPECT_NE(("\n" + events).find(event + " "), std::string::npos) << event;
    const std::string algorithms = run(folder, "list algorithms").out, knobs = run(folder, "list knobs").out;
    for (const char* word : {"gupta-sproull", "active-edges", "second-order", "multisample", "liang-barsky",
                             "greiner-hormann", "pipeline", "split bridges"})
        EXPECT_NE(algorithms.find("  " + std::string(word) + " "), std::string::npos) << word;
    for (const char* word : {"fill_rule", "book", "top-left", "antialiasing", "samples", "midpoint, dda"})
        EXPECT_NE(knobs.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace relevo::command
