#include <map>
#include <set>

#include "raster/curve_coverage.hpp"
#include "raster/disc.hpp"
#include "raster/ellipse_textbook.hpp"
#include "samples/show/lessons.hpp"
#include "tests/samples/show/scenes.hpp"

namespace relevo::show {
namespace {

using Places = std::set<std::pair<int, int>>;

std::vector<Lesson> lessons_of(const std::string& shape, const std::string& axes = "extent = [0, 0, 40, 30]",
                               const std::string& more = "") {
    const scene::LoadedScene loaded =
        loaded_scene("[axes]\n" + axes + "\n" + more + "\n[[shape2d]]\n" + shape);
    std::vector<Lesson> lessons = curve_lessons(loaded, 0);
    for (const Lesson& lesson : lessons) {
        EXPECT_FALSE(lesson.frames.empty()) << lesson.name;
        EXPECT_LE(lesson.frames.size(), 48u) << lesson.name;
        EXPECT_FALSE(lesson.view.empty() || lesson.title.empty() || lesson.sentence.empty());
        for (const LessonFrame& frame : lesson.frames) {
            EXPECT_FALSE(frame.title.empty() || frame.caption.empty()) << lesson.name;
            EXPECT_TRUE(frame.row.size() <= lesson.columns.size()) << lesson.name;
        }
    }
    return lessons;
}

// The pixels lit for good; none of them twice.
Places lit(const Lesson& lesson) {
    Places places;
    for (const LessonFrame& frame : lesson.frames)
        for (const Mark& mark : frame.stays)
            EXPECT_TRUE(places.insert({int(mark.points[0].x), int(mark.points[0].y)}).second) << lesson.name;
    return places;
}

template <class Draw>
Places pixels_of(Draw&& draw) {
    Places places;
    draw([&](int x, int y) { places.insert({x, y}); });
    return places;
}

const raster::PixelBox picture{0, 0, 40, 30};

TEST(LessonsCurve, TheCircleOfRadiusEight) {
    const std::vector<Lesson> lessons = lessons_of("type = \"circle\"\ncenter = [3, 2]\nradius = 8\n",
                                                   "extent = [-10, -10, 20, 15]\ny = \"up\"");
    ASSERT_EQ(lessons.size(), 1u);
    EXPECT_EQ(lessons[0].name, "circle-midpoint");
    ASSERT_EQ(lessons[0].frames.size(), 7u);
    EXPECT_EQ(lessons[0].frames[0].equation, "d = 1 - R = 1 - 8 = -7");
    EXPECT_EQ(lessons[0].frames[2].equation, "d = -4 < 0 -> E, d += 2x + 3 = 5");
    EXPECT_EQ(lessons[0].frames[3].equation, "d = 1 >= 0 -> SE, d += 2x - 2y + 5 = -7");
    // M is named in the words of the scene: 3 to the right of the centre, 7.5 above it
    EXPECT_EQ(lessons[0].frames[3].caption.substr(0, 9), "M (6, 9.5");
    EXPECT_EQ(lit(lessons[0]), pixels_of([&](auto plot) {
                  raster::circle_midpoint({13, 13}, 8, {0, 0, 30, 25}, plot);
              }));
}

TEST(LessonsCurve, TheIncrementsOfSecondOrder) {
    const std::vector<Lesson> lessons =
        lessons_of("type = \"circle\"\ncenter = [15, 15]\nradius = 8\nalgorithm = \"second-order\"\n");
    ASSERT_EQ(lessons.size(), 1u);
    EXPECT_EQ(lessons[0].name, "circle-second-order");
    EXPECT_EQ(lessons[0].frames[3].row, (std::vector<std::string>{"3", "2", "8", "1", "7", "-7", "SE"}));
    EXPECT_EQ(lessons[0].frames[3].equation, "d = 1 >= 0 -> SE, d += -7, delta E += 2, delta SE += 4");
}

TEST(LessonsCurve, LitCellsAreThePixelsOfTheAlgorithm) {
    struct Case {
        int a, b;
        const char* algorithm;
        const char* name;
    };
    for (const Case& c :
         {Case{12, 8, "midpoint", "ellipse-midpoint"}, Case{18, 1, "midpoint", "ellipse-midpoint"},
          Case{3, 14, "second-order", "ellipse-second-order"}, Case{10, 10, "midpoint", "circle-midpoint"},
          Case{18, 1, "textbook", "ellipse-textbook"}, Case{6, 2, "textbook", "ellipse-textbook"},
          Case{9, 0, "midpoint", "ellipse-midpoint"}, Case{0, 0, "midpoint", "circle-midpoint"},
          Case{35, 40, "midpoint", "ellipse-midpoint"}}) {
        const std::vector<Lesson> lessons =
            lessons_of("type = \"ellipse\"\ncenter = [20, 15]\nradius = [" + std::to_string(c.a) + ", " +
                       std::to_string(c.b) + "]\nalgorithm = \"" + c.algorithm + "\"\n");
        ASSERT_EQ(lessons.size(), 1u);
        EXPECT_EQ(lessons[0].name, c.name);
        EXPECT_EQ(lit(lessons[0]), pixels_of([&](auto plot) {
                      if (std::string(c.algorithm) == "textbook")
                          raster::ellipse_textbook({20, 15}, c.a, c.b, picture, plot);
                      else
                          raster::ellipse_midpoint({20, 15}, c.a, c.b, picture, plot);
                  }))
            << c.a << ", " << c.b;
    }
}

TEST(LessonsCurve, ALongOneIsShortened) {
    const std::vector<Lesson> lessons =
        lessons_of("type = \"circle\"\ncenter = [0, 150]\nradius = 140\n", "extent = [-160, 0, 160, 300]");
    ASSERT_EQ(lessons.size(), 1u);
    EXPECT_EQ(lessons[0].frames.size(), 48u);
    EXPECT_NE(lessons[0].sentence.find("left out"), std::string::npos);
    const raster::PixelBox& view = lessons[0].view;
    EXPECT_EQ(lit(lessons[0]), pixels_of([&](auto plot) {
                  raster::circle_midpoint({160, 150}, 140, view, plot);
              }));
}

TEST(LessonsCurve, TheLostTipIsShown) {
    const std::vector<Lesson> lessons =
        lessons_of("type = \"ellipse\"\ncenter = [20, 15]\nradius = [18, 1]\nalgorithm = \"textbook\"\n");
    const LessonFrame& last = lessons.at(0).frames.back();
    int crosses = 0;
    for (const Mark& mark : last.now) crosses += mark.kind == Mark::Kind::Cross;
    EXPECT_EQ(crosses, 8);  // two pixels at each end, once a quarter
    EXPECT_EQ(last.equation, "y = 0 at x = 16, but a = 18");
}

TEST(LessonsCurve, ClippingByParts) {
    for (const char* radius : {"[9, 9]", "[12, 7]"}) {
        const std::vector<Lesson> lessons =
            lessons_of(std::string("type = \"ellipse\"\ncenter = [14, 12]\nradius = ") + radius + "\n",
                       "extent = [0, 0, 40, 30]", "[clip]\nwindow = [10, 8, 30, 25]\n");
        ASSERT_EQ(lessons.size(), 2u);
        const bool round = std::string(radius) == "[9, 9]";
        EXPECT_EQ(lessons[0].name, round ? "circle-clip" : "ellipse-clip");
        EXPECT_EQ(
            lit(lessons[0]), pixels_of([&](auto plot) {
                raster::ellipse_midpoint({14, 12}, round ? 9 : 12, round ? 9 : 7, {10, 8, 30, 25}, plot);
            }));
        EXPECT_EQ(lessons[0].frames[0].row[1], "cut");
    }
}

TEST(LessonsCurve, ADiscInRows) {
    const std::vector<Lesson> lessons =
        lessons_of("type = \"circle\"\ncenter = [20, 15]\nradius = 9\nfilled = true\n");
    ASSERT_EQ(lessons.size(), 1u);
    EXPECT_EQ(lessons[0].name, "disc-spans");
    EXPECT_EQ(lessons[0].frames.size(), 19u);
    EXPECT_EQ(lit(lessons[0]), pixels_of([&](auto plot) {
                  raster::disc({20, 15}, 9, 9, picture, [&](int y, int x0, int x1) {
                      for (int x = x0; x < x1; ++x) plot(x, y);
                  });
              }));
}

TEST(LessonsCurve, ASmoothOneIsAsDarkAsItsCoverage) {
    for (const bool filled : {false, true}) {
        const std::vector<Lesson> lessons =
            lessons_of(std::string("type = \"circle\"\ncenter = [20.25, 15.5]\nradius = 7.5\n") +
                       "antialiasing = \"area\"\nfilled = " + (filled ? "true\n" : "false\n"));
        ASSERT_EQ(lessons.size(), 1u);
        EXPECT_EQ(lessons[0].name, filled ? "disc-coverage" : "ring-coverage");
        std::map<std::pair<int, int>, int> right, levels;
        const auto cover = [&](int y, int x0, int x1, int coverage) {
            for (int x = x0; x < x1; ++x) right[{x, y}] = (coverage * 255 + 32768) / raster::full_coverage;
        };
        if (filled)
            raster::disc_coverage({20.25, 15.5}, 7.5, 7.5, picture, cover);
        else
            raster::ring_coverage({20.25, 15.5}, 7.5, 7.5, 1, picture, cover);
        for (const LessonFrame& frame : lessons[0].frames)
            for (const Mark& mark : frame.stays)
                levels[{int(mark.points[0].x), int(mark.points[0].y)}] = mark.level;
        EXPECT_EQ(levels, right);
        EXPECT_EQ(lessons[0].frames.back().equation,
                  filled ? "sum of all pixels = 176.715" : "sum of all pixels = 47.124");
    }
}

TEST(LessonsCurve, OtherShapesHaveNone) {
    EXPECT_TRUE(lessons_of("type = \"line\"\npoints = [[1, 1], [5, 3]]\n").empty());
}

}  // namespace
}  // namespace relevo::show
