// Lessons of clipping: their moments, numbers and words in the cases of the textbook's figures.
#include <gtest/gtest.h>

#include "samples/show/lessons.hpp"
#include "tests/samples/show/scenes.hpp"

namespace relevo::show {
namespace {

const std::string axes = "[axes]\nextent = [0, 0, 20, 14]\ny = \"up\"\n";

std::string line(const std::string& points) {
    return "[[shape2d]]\ntype = \"line\"\npoints = " + points + "\n";
}
std::string polygon(const std::string& points) {
    return "[[shape2d]]\ntype = \"polygon\"\npoints = " + points + "\n";
}

// The lesson of the first shape, with what must hold for all of them.
Lesson lesson_of(const std::string& clip, const std::string& shape) {
    const scene::LoadedScene loaded = loaded_scene(axes + "[clip]\n" + clip + shape);
    std::vector<Lesson> lessons = clipping_lessons(loaded, 0);
    EXPECT_EQ(lessons.size(), 1u);
    if (lessons.empty()) return {};
    Lesson lesson = std::move(lessons[0]);
    EXPECT_FALSE(lesson.frames.empty());
    EXPECT_FALSE(lesson.view.empty());
    EXPECT_FALSE(lesson.sentence.empty() || lesson.source.empty());
    for (const LessonFrame& frame : lesson.frames) {
        EXPECT_FALSE(frame.title.empty() || frame.equation.empty() || frame.caption.empty());
        EXPECT_TRUE(frame.row.empty() || frame.row.size() == lesson.columns.size()) << frame.title;
        EXPECT_FALSE(frame.caption.ends_with(' ')) << frame.caption;
    }
    return lesson;
}

bool says(const LessonFrame& frame, const std::string& words) {
    return frame.caption.find(words) != std::string::npos;
}
int count(const std::vector<Mark>& marks, Mark::Kind kind) {
    return static_cast<int>(std::ranges::count(marks, kind, &Mark::kind));
}

// Fig. 4.3: asked for the right side first, the first crossing is wasted.
TEST(LessonsClipping, TheWastedCrossingOfCohenSutherland) {
    const std::string segment = line("[[6, 5], [18, 13]]");
    const Lesson lesson =
        lesson_of("window = [4, 3, 14, 9]\norder = [\"right\", \"top\", \"bottom\", \"left\"]\n", segment);
    EXPECT_EQ(lesson.name, "clip-cohen-sutherland");
    ASSERT_EQ(lesson.frames.size(), 6u);
    EXPECT_EQ(lesson.frames[1].equation, "0000 & 1010 = 0000, 0000 | 1010 = 1010 -> cut");
    EXPECT_EQ(lesson.frames[2].title, "cut at the right");
    EXPECT_EQ(lesson.frames[2].equation, "y = 5 + (14 - 6) (13 - 5) / (18 - 6) = 10.33");
    EXPECT_TRUE(says(lesson.frames[2], "right, top, bottom, left"));
    EXPECT_TRUE(says(lesson.frames[2], "code is 1000 now: still outside, so this crossing was wasted"));
    EXPECT_TRUE(says(lesson.frames[2], "(bottom, left) lies off the segment"));
    EXPECT_EQ(count(lesson.frames[2].stays, Mark::Kind::Cross), 1);
    EXPECT_EQ(lesson.frames[3].equation, "0000 & 1000 = 0000, 0000 | 1000 = 1000 -> cut");
    EXPECT_EQ(lesson.frames[4].equation, "x = 6 + (9 - 5) (18 - 6) / (13 - 5) = 12");
    EXPECT_EQ(count(lesson.frames[4].stays, Mark::Kind::Dot), 1);
    EXPECT_EQ(lesson.frames[5].equation, "0000 | 0000 = 0000 -> accept");
    EXPECT_TRUE(says(lesson.frames[5], "2 crossings computed, 1 of them wasted"));
    EXPECT_EQ(lesson.frames[5].row,
              (std::vector<std::string>{"3", "(6, 5)", "0000", "(12, 9)", "0000", "accept"}));
    const Lesson better =
        lesson_of("window = [4, 3, 14, 9]\norder = [\"top\", \"right\", \"bottom\", \"left\"]\n", segment);
    ASSERT_EQ(better.frames.size(), 4u);
    EXPECT_TRUE(says(better.frames[3], "1 crossing computed, 0 of them wasted"));
}

TEST(LessonsClipping, TrivialDecisions) {
    const std::string window = "window = [4, 3, 14, 9]\n";
    const Lesson rejected = lesson_of(window, line("[[1, 1], [2, 8]]"));
    ASSERT_EQ(rejected.frames.size(), 2u);
    EXPECT_EQ(rejected.frames[1].equation, "0101 & 0001 = 0001 -> reject");
    int codes = 0;
    for (const Mark& mark : rejected.ground) codes += mark.kind == Mark::Kind::Text;
    EXPECT_EQ(codes, 9) << "the nine regions";
    const Lesson accepted = lesson_of(window, line("[[5, 5], [8, 4]]"));
    ASSERT_EQ(accepted.frames.size(), 2u);
    EXPECT_EQ(accepted.frames[1].equation, "0000 | 0000 = 0000 -> accept");
}

// Table 4.1 in the words of y upwards.
TEST(LessonsClipping, LiangBarskyFillsInTheTable) {
    const Lesson lesson =
        lesson_of("window = [4, 4, 12, 8]\nlines = \"liang-barsky\"\n", line("[[2, 5], [18, 13]]"));
    ASSERT_EQ(lesson.frames.size(), 6u);
    EXPECT_EQ(lesson.frames[1].equation, "t = (xmin - x0) / (x1 - x0) = (4 - 2) / (18 - 2) = 0.125");
    EXPECT_TRUE(says(lesson.frames[1], "enters here, visible from t = 0.125 on"));
    EXPECT_EQ(lesson.frames[2].equation, "t = (x0 - xmax) / (x0 - x1) = (2 - 12) / (2 - 18) = 0.625");
    EXPECT_EQ(lesson.frames[3].title, "top: leaving");
    EXPECT_EQ(lesson.frames[3].equation, "t = (y0 - ymax) / (y0 - y1) = (5 - 8) / (5 - 13) = 0.375");
    EXPECT_EQ(lesson.frames[3].row,
              (std::vector<std::string>{"top", "-3", "-8", "0.375", "leaving", "0.125", "0.375"}));
    EXPECT_EQ(lesson.frames[4].equation, "t = (ymin - y0) / (y1 - y0) = (4 - 5) / (13 - 5) = -0.125");
    EXPECT_TRUE(says(lesson.frames[4], "Nothing changes"));
    EXPECT_EQ(lesson.frames[5].equation, "P(0.125) = (4, 6),  P(0.375) = (8, 8)");
}

TEST(LessonsClipping, CyrusBeckShowsNormals) {
    const Lesson lesson = lesson_of("polygon = [[4, 2], [12, 2], [4, 10]]\nlines = \"cyrus-beck\"\n",
                                    line("[[2, 4], [18, 4]]"));
    EXPECT_EQ(lesson.name, "clip-cyrus-beck");
    ASSERT_EQ(lesson.frames.size(), 5u);
    int arrows = 0, slanted = 0;
    for (const LessonFrame& frame : lesson.frames) {
        arrows += count(frame.now, Mark::Kind::Arrow);
        slanted +=
            frame.equation == "N.(P0 - PL) / (-N.D) = -64 / (-128) -> t = 0.5" && says(frame, "N = (8, 8)");
    }
    EXPECT_EQ(arrows, 3);
    EXPECT_EQ(slanted, 1) << "N points up and to the right, in the words of the scene";
    EXPECT_EQ(lesson.frames.back().equation, "P(0.125) = (4, 4),  P(0.5) = (10, 4)");
}

// Fig. 4.4: PL is a corner of the window, is marked, and gives the printed numerator.
TEST(LessonsClipping, CyrusBeckNamesThePointOfTheSide) {
    const Lesson lesson =
        lesson_of("window = [4, 3, 14, 10]\nlines = \"cyrus-beck\"\n", line("[[8, 5], [19, 9]]"));
    ASSERT_EQ(lesson.frames.size(), 6u);
    int named = 0;
    for (const LessonFrame& frame : lesson.frames) {
        if (frame.title.starts_with("left")) {
            EXPECT_EQ(frame.equation, "N.(P0 - PL) / (-N.D) = -4 / 11 -> t = -0.3636");
            EXPECT_TRUE(says(frame, "N = (-1, 0), PL = (4, 3), P0 - PL = (4, 2)")) << frame.caption;
        }
        for (const Mark& mark : frame.now) named += mark.text == "PL";
    }
    EXPECT_EQ(named, 4);
}

TEST(LessonsClipping, MidpointHalves) {
    const Lesson lesson =
        lesson_of("window = [4, 3, 14, 9]\nlines = \"midpoint\"\n", line("[[6, 5], [18, 13]]"));
    EXPECT_EQ(lesson.frames[0].equation, "codes 0000 and 1010");
    EXPECT_EQ(lesson.frames[1].equation, "x = (6 + 18) / 2 = 12,  y = (5 + 13) / 2 = 9");
    EXPECT_TRUE(says(lesson.frames[1], "visible"));
    EXPECT_EQ(lesson.frames.back().equation, "from (6, 5) to (12, 9)");
    EXPECT_LT(lesson.frames.size(), 15u) << "what is too small to see is summed up";
}

// Fig. 4.9: three bars that hang together outside of the window.
const std::string bars = polygon(
    "[[4, 1], [19, 1], [19, 13], [4, 13], [4, 10], [17, 10], [17, 8], [6, 8], [6, 6], [17, 6], [17, 4], [4, "
    "4]]");

TEST(LessonsClipping, BridgesOfTheConcaveCase) {
    const Lesson lesson = lesson_of("window = [2, 0, 14, 14]\nsplit = true\n", bars);
    EXPECT_EQ(lesson.name, "clip-sutherland-hodgman");
    ASSERT_EQ(lesson.frames.size(), 1 + 4 * 2 + 2u) << "the polygon, two a side, bridges, pieces";
    const LessonFrame& bridges = lesson.frames[lesson.frames.size() - 2];
    EXPECT_EQ(bridges.equation, "there 4 + back 4: enclosed area 0");
    EXPECT_EQ(count(bridges.now, Mark::Kind::Segment), 2);
    EXPECT_EQ(lesson.frames.back().equation.substr(0, 5), "area ");
    EXPECT_NE(lesson.frames.back().equation.find(" = 76"), std::string::npos) << "30 + 16 + 30";
    EXPECT_EQ(count(lesson.frames.back().now, Mark::Kind::Area), 3);
    const Lesson whole = lesson_of("window = [2, 0, 14, 14]\n", bars);
    EXPECT_EQ(whole.frames.size(), 10u);
    EXPECT_TRUE(says(whole.frames.back(), "split = true"));
}

TEST(LessonsClipping, SutherlandHodgmanClassifiesEdges) {
    const Lesson lesson =
        lesson_of("window = [2, 0, 14, 14]\norder = [\"right\", \"top\", \"bottom\", \"left\"]\n",
                  polygon("[[4, 4], [18, 4], [18, 10], [4, 10]]"));
    EXPECT_EQ(lesson.frames[1].title, "against the right");
    EXPECT_EQ(lesson.frames[1].equation,
              "1 inside x 1 + 1 leaving x 1 + 1 outside x 0 + 1 entering x 2 = 4 points");
    EXPECT_EQ(count(lesson.frames[1].now, Mark::Kind::Arrow), 4);
    EXPECT_TRUE(says(lesson.frames[2], "(14, 4)"));
    EXPECT_TRUE(says(lesson.frames[2], "(14, 10)"));
    EXPECT_EQ(lesson.frames[1].row, (std::vector<std::string>{"right", "1", "1", "1", "1", "4"}));
}

TEST(LessonsClipping, ThePipelineShowsWhatStagesHold) {
    const Lesson lesson = lesson_of("window = [2, 0, 14, 14]\npolygons = \"pipeline\"\n",
                                    polygon("[[4, 4], [18, 4], [18, 10], [4, 10]]"));
    EXPECT_EQ(lesson.name, "clip-pipeline");
    ASSERT_EQ(lesson.frames.size(), 6u) << "four corners, close, result";
    EXPECT_EQ(lesson.frames[0].equation, "no edge yet");
    EXPECT_EQ(lesson.frames[0].row[1], "(4, 4) (4, 4)");
    EXPECT_EQ(lesson.frames[4].title, "close");
    EXPECT_EQ(lesson.frames[4].row.back(), "4");
    EXPECT_EQ(lesson.frames[5].equation, "area 60");
}

// Fig. 4.8: a stage may handle several edges of one corner.
TEST(LessonsClipping, ThePipelineTellsAllEdgesOfAStage) {
    const Lesson lesson = lesson_of(
        "window = [4, 3, 15, 11]\npolygons = \"pipeline\"\norder = [\"left\", \"right\", \"bottom\", "
        "\"top\"]\n",
        polygon("[[1, 6], [18, 1], [12, 13.5]]"));
    ASSERT_EQ(lesson.frames.size(), 5u) << "three corners, close, result";
    EXPECT_EQ(lesson.frames[1].equation, "left: entering; right: leaving");
    EXPECT_EQ(lesson.frames[2].equation,
              "left: inside; right: entering; bottom: entering, inside; top: inside, leaving");
    EXPECT_EQ(lesson.frames[3].equation,
              "left: leaving; right: inside, inside; bottom: inside, inside, leaving; "
              "top: entering, inside, inside, inside");
}

TEST(LessonsClipping, GreinerHormannWalks) {
    const Lesson lesson =
        lesson_of("polygon = [[2, 2], [18, 2], [18, 13], [10, 5], [2, 13]]\npolygons = \"greiner-hormann\"\n",
                  polygon("[[1, 7], [19, 7], [19, 11], [1, 11]]"));
    EXPECT_EQ(lesson.name, "clip-greiner-hormann");
    EXPECT_EQ(lesson.frames[1].equation, "4 entering, 4 leaving, 0 touching");
    EXPECT_EQ(count(lesson.frames[1].stays, Mark::Kind::Dot), 8);
    EXPECT_EQ(lesson.frames.size(), 2 + 8 + 1u) << "two rings, each twice along both outlines";
    EXPECT_EQ(lesson.frames.back().equation, "area 16 + 16 = 32");
}

TEST(LessonsClipping, NothingToTell) {
    const std::string circle = "[[shape2d]]\ntype = \"circle\"\ncenter = [5, 5]\nradius = 3\n";
    EXPECT_TRUE(clipping_lessons(loaded_scene(axes + line("[[1, 1], [9, 9]]")), 0).empty()) << "no window";
    EXPECT_TRUE(clipping_lessons(loaded_scene(axes + "[clip]\nwindow = [2, 2, 9, 9]\n" + circle), 0).empty())
        << "curves have their own";
}

TEST(LessonsClipping, BadWindowsAreExplained) {
    scene::LoadedScene loaded = loaded_scene(axes + "[clip]\nwindow = [4, 4, 9, 9]\n" +
                                             line("[[1, 1], [9, 9]]") + polygon("[[1, 1], [9, 1], [5, 8]]"));
    for (const auto clipper : {raster::LineClipper::CohenSutherland, raster::LineClipper::CyrusBeck,
                               raster::LineClipper::LiangBarsky, raster::LineClipper::MidpointSubdivision}) {
        loaded.shapes.clip.lines = clipper;
        loaded.shapes.clip.low = {9, 9}, loaded.shapes.clip.high = {4, 4};
        EXPECT_TRUE(says(clipping_lessons(loaded, 0)[0].frames.back(), "lower limit is above"))
            << int(clipper);
        EXPECT_TRUE(says(clipping_lessons(loaded, 1)[0].frames.back(), "lower limit is above"));
    }
    loaded.shapes.clip.polygon = {{0, 0}, {9, 0}, {2, 2}, {0, 9}};
    EXPECT_TRUE(says(clipping_lessons(loaded, 0)[0].frames.back(), "not convex"));
    EXPECT_TRUE(says(clipping_lessons(loaded, 1)[0].frames.back(), "not convex"));
    loaded.shapes.clip.polygons = raster::PolygonClipper::GreinerHormann;
    EXPECT_EQ(clipping_lessons(loaded, 1)[0].frames.back().title, "result") << "it takes any window";
    loaded.shapes.clip.polygon = {{0, 0}, {9, 9}, {3, 3}};
    EXPECT_TRUE(says(clipping_lessons(loaded, 1)[0].frames.back(), "no area"));
}

}  // namespace
}  // namespace relevo::show
