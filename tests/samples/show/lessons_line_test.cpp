// Lessons of lines: what they light, say and leave out.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "raster/line_midpoint.hpp"
#include "samples/show/lesson_sheet.hpp"
#include "samples/show/lessons.hpp"

namespace relevo::show {
namespace {

using raster::ScanAlgorithm;
using raster::ShapeKind;
using Pixels = std::set<std::pair<int, int>>;
using Words = std::vector<std::string>;

raster::Shape line(std::vector<glm::vec2> points, ScanAlgorithm algorithm = ScanAlgorithm::Midpoint) {
    raster::Shape s;
    s.kind = points.size() == 2 ? ShapeKind::Line : ShapeKind::Polyline;
    s.points = std::move(points);
    s.algorithm = algorithm;
    return s;
}

scene::LoadedScene scene_of(std::vector<raster::Shape> shapes, int width = 32, int height = 24) {
    scene::LoadedScene loaded;
    loaded.width = width;
    loaded.height = height;
    loaded.shapes.shapes = std::move(shapes);
    return loaded;
}

// y grows upwards from the lowest row, as in the textbook.
scene::LoadedScene textbook_scene(std::vector<raster::Shape> shapes, int width = 32, int height = 24) {
    scene::LoadedScene loaded = scene_of(std::move(shapes), width, height);
    loaded.axes = {0, height - 1, true};
    for (raster::Shape& shape : loaded.shapes.shapes)
        for (glm::vec2& p : shape.points) p.y = static_cast<float>(loaded.axes.pixel_y(p.y));
    return loaded;
}

Lesson only_lesson(const scene::LoadedScene& loaded) {
    std::vector<Lesson> all = line_lessons(loaded, 0);
    EXPECT_EQ(all.size(), 1u);
    return all.empty() ? Lesson{} : std::move(all[0]);
}

// The pixels that are lit at the end; each of them once.
Pixels lit(const Lesson& lesson) {
    Pixels pixels;
    for (const LessonFrame& frame : lesson.frames)
        for (const Mark& mark : frame.stays)
            if (mark.kind == Mark::Kind::Cell) {
                const auto [x, y] = mark.points[0];
                EXPECT_TRUE(pixels.insert({static_cast<int>(x), static_cast<int>(y)}).second);
            }
    return pixels;
}

Pixels midpoint_pixels(const std::vector<glm::vec2>& points, const raster::PixelBox& box) {
    Pixels pixels;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        raster::line_midpoint({int(points[i].x), int(points[i].y)},
                              {int(points[i + 1].x), int(points[i + 1].y)}, box, [&](int x, int y) {
                                  pixels.insert({x, y});
                              });
    return pixels;
}

Words equations(const Lesson& lesson) {
    Words all;
    for (const LessonFrame& frame : lesson.frames) all.push_back(frame.equation);
    return all;
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void expect_well_told(const Lesson& lesson) {
    EXPECT_FALSE(lesson.name.empty() || lesson.title.empty() || lesson.sentence.empty() ||
                 lesson.source.empty());
    EXPECT_FALSE(lesson.frames.empty());
    EXPECT_LE(lesson.frames.size(), 48u);
    for (const LessonFrame& frame : lesson.frames) {
        EXPECT_FALSE(frame.title.empty());
        EXPECT_FALSE(frame.caption.empty()) << frame.title;
        EXPECT_TRUE(frame.row.empty() || frame.row.size() == lesson.columns.size()) << frame.title;
        for (const std::string& words : {frame.title, frame.equation, frame.caption})
            EXPECT_FALSE(says(words, "nan") || says(words, "inf") || says(words, "e-") || says(words, "-0 "))
                << words;
    }
}

TEST(LineLessons, TheTextbooksFirstOctant) {
    const scene::LoadedScene loaded = textbook_scene({line({{0, 0}, {7, 3}})});
    const Lesson lesson = only_lesson(loaded);
    expect_well_told(lesson);
    EXPECT_EQ(lesson.name, "line-midpoint");
    EXPECT_EQ(equations(lesson), (Words{"d = 2dy - dx = 2*3 - 7 = -1",                //
                                        "d = 2dy - dx = -1 < 0 -> E, d += 2dy",       //
                                        "d = -1 + 6 = 5 > 0 -> NE, d += 2(dy - dx)",  //
                                        "d = 5 - 8 = -3 < 0 -> E, d += 2dy",          //
                                        "d = -3 + 6 = 3 > 0 -> NE, d += 2(dy - dx)",  //
                                        "d = 3 - 8 = -5 < 0 -> E, d += 2dy",          //
                                        "d = -5 + 6 = 1 > 0 -> NE, d += 2(dy - dx)",  //
                                        "d = 1 - 8 = -7 < 0 -> E, d += 2dy",          //
                                        "x = 7"}));
    EXPECT_EQ(lesson.columns, (Words{"step", "x", "y", "d", "choice"}));
    EXPECT_EQ(lesson.frames[2].row, (Words{"2", "1", "0", "5", "NE"}));
    EXPECT_EQ(lesson.frames.back().row, (Words{"8", "7", "3", "", "end"}));
    EXPECT_TRUE(says(lesson.frames[2].caption, "(2, 0.5)")) << lesson.frames[2].caption;
    EXPECT_TRUE(says(lesson.frames.back().caption, "8 pixels for a way of 7.616"));
    EXPECT_EQ(lit(lesson), midpoint_pixels(loaded.shapes.shapes[0].points, {0, 0, 31, 23}));
}

TEST(LineLessons, EveryOctantHasItsCompass) {
    const auto ways = [](glm::vec2 to) {
        const scene::LoadedScene loaded = scene_of({line({{12, 12}, {12 + to.x, 12 + to.y}})});
        const Lesson lesson = only_lesson(loaded);
        expect_well_told(lesson);
        EXPECT_EQ(lit(lesson), midpoint_pixels(loaded.shapes.shapes[0].points, {0, 0, 31, 23}));
        return std::pair{lesson.legend[3].words, lesson.legend[4].words};
    };
    using Ways = std::pair<std::string, std::string>;
    EXPECT_EQ(ways({7, 3}), (Ways{"candidate E", "candidate SE"}));
    EXPECT_EQ(ways({-7, -3}), (Ways{"candidate E", "candidate SE"}));
    EXPECT_EQ(ways({7, -3}), (Ways{"candidate E", "candidate NE"}));
    EXPECT_EQ(ways({3, 7}), (Ways{"candidate S", "candidate SE"}));
    EXPECT_EQ(ways({-3, 7}), (Ways{"candidate S", "candidate SW"}));
    EXPECT_EQ(ways({3, -7}), (Ways{"candidate S", "candidate SW"}));
}

TEST(LineLessons, ATieIsNamed) {
    const Lesson lesson = only_lesson(scene_of({line({{0, 0}, {4, 2}})}));
    EXPECT_EQ(lesson.frames[1].equation, "d = 2dy - dx = 0: a tie -> E, d += 2dy");
    EXPECT_TRUE(says(lesson.frames[1].caption, "straight on"));
}

TEST(LineLessons, LongLinesAreLitToTheEnd) {
    const scene::LoadedScene loaded = scene_of({line({{-500, -80}, {3000, 600}})}, 640, 480);
    const Lesson lesson = only_lesson(loaded);
    expect_well_told(lesson);
    EXPECT_EQ(lit(lesson), midpoint_pixels(loaded.shapes.shapes[0].points, lesson.view));
    EXPECT_FALSE(lit(lesson).empty());
    EXPECT_TRUE(says(lesson.sentence, "are shown here")) << lesson.sentence;
    EXPECT_TRUE(says(lesson.frames[0].caption, "comes in at step")) << lesson.frames[0].caption;
    EXPECT_TRUE(says(lesson.frames.back().title, "the view ends"));
}

TEST(LineLessons, ManyMomentsEndInOneFrame) {
    std::vector<glm::vec2> points;
    for (int i = 0; i < 3000; ++i) points.push_back({float(i % 30), float(i * 7 % 23)});
    const scene::LoadedScene loaded = scene_of({line(points)});
    const Lesson lesson = only_lesson(loaded);
    expect_well_told(lesson);
    EXPECT_EQ(lesson.frames.size(), 48u);
    EXPECT_EQ(lit(lesson), midpoint_pixels(points, lesson.view));
    EXPECT_TRUE(says(lesson.frames[46].title, "more")) << lesson.frames[46].title;
    EXPECT_TRUE(says(lesson.frames[0].title, "line 1: "));
}

TEST(LineLessons, DdaShowsTheSum) {
    const scene::LoadedScene loaded = textbook_scene({line({{0, 0}, {7, 3}}, ScanAlgorithm::Dda)});
    const Lesson lesson = only_lesson(loaded);
    expect_well_told(lesson);
    ASSERT_EQ(lesson.frames.size(), 8u);
    EXPECT_EQ(lesson.frames[0].equation, "slope = 3 / 7 = 0.4285714");
    EXPECT_EQ(lesson.frames[2].equation, "y = y + slope = 0.857143 -> 1");
    EXPECT_EQ(lesson.frames[2].row[2], "0.857143");
    EXPECT_EQ(lit(lesson), midpoint_pixels(loaded.shapes.shapes[0].points, lesson.view));
    EXPECT_EQ(only_lesson(scene_of({line({{0, 5}, {4, 1}}, ScanAlgorithm::Dda)})).frames[0].equation,
              "slope = -4 / 4 = -1");
}

TEST(LineLessons, ExplicitShowsGapsAndTheVertical) {
    const Lesson steep = only_lesson(textbook_scene({line({{10, 1}, {13, 10}}, ScanAlgorithm::Explicit)}));
    expect_well_told(steep);
    ASSERT_EQ(steep.frames.size(), 4u);
    EXPECT_EQ(steep.frames[1].equation, "y = a x + B = 3 * 11 - 29 = 4 -> 4");
    EXPECT_TRUE(says(steep.frames[1].caption, "leaves out 2 rows"));
    EXPECT_EQ(std::ranges::count(steep.frames[1].now, Mark::Kind::Cross, &Mark::kind), 2);
    EXPECT_EQ(steep.frames[1].row, (Words{"11", "4", "4", "2"}));
    const Lesson upright = only_lesson(scene_of({line({{5, 1}, {5, 9}}, ScanAlgorithm::Explicit)}));
    expect_well_told(upright);
    ASSERT_EQ(upright.frames.size(), 1u);
    EXPECT_EQ(upright.frames[0].equation, "a = dy / dx = 8 / 0: undefined");
    EXPECT_TRUE(lit(upright).empty());
    EXPECT_EQ(std::ranges::count(upright.frames[0].now, Mark::Kind::Cross, &Mark::kind), 9);
}

TEST(LineLessons, WuSharesTheLight) {
    const Lesson lesson = only_lesson(scene_of({line({{1, 1}, {5, 2}}, ScanAlgorithm::Wu)}));
    expect_well_told(lesson);
    ASSERT_EQ(lesson.frames.size(), 5u);
    EXPECT_EQ(lesson.frames[0].equation, "f = 0, 0.5 of the width -> upper 0.5, lower 0");
    EXPECT_EQ(lesson.frames[1].equation, "f = 0.25 -> upper 1 - f = 0.75, lower f = 0.25");
    EXPECT_EQ(lesson.frames[1].row, (Words{"2", "1.25", "0.75", "0.25", "1"}));
    ASSERT_EQ(lesson.frames[1].stays.size(), 2u);
    EXPECT_EQ(lesson.frames[1].stays[0].level, 191);
    EXPECT_EQ(lesson.frames[1].stays[1].level, 64);
    EXPECT_EQ(lit(lesson).size(), 8u);
}

TEST(LineLessons, GuptaSproullShowsDistanceAndWeight) {
    const Lesson lesson = only_lesson(scene_of({line({{2, 4}, {16, 4}}, ScanAlgorithm::GuptaSproull)}));
    expect_well_told(lesson);
    const auto middle = std::ranges::find(lesson.frames, "x = 9", &LessonFrame::title);
    ASSERT_NE(middle, lesson.frames.end());
    EXPECT_EQ(middle->equation, "t = 0: H(0.5) - H(-0.5) = 0.78");
    EXPECT_EQ(middle->row, (Words{"9", "4", "0", "0.78", "0.11 0.78 0.11"}));
    EXPECT_EQ(lesson.frames.front().title, "x = 2");
}

TEST(LineLessons, EvenWeightIsExplained) {
    raster::Shape shape = line({{1, 1}, {15, 7}});
    shape.even_weight = true;
    const scene::LoadedScene loaded = scene_of({shape});
    const std::vector<Lesson> all = line_lessons(loaded, 0);
    ASSERT_EQ(all.size(), 2u);
    const Lesson& lesson = all[1];
    expect_well_told(lesson);
    ASSERT_EQ(lesson.frames.size(), 2u);
    EXPECT_EQ(lesson.frames[1].equation, "w = length / (1.414 dx) = 15.232 / 19.799 = 0.769");
    EXPECT_EQ(lit(lesson), midpoint_pixels(shape.points, lesson.view));
    EXPECT_EQ(lesson.frames[1].stays[0].level, 196);  // 0.769 * 255
}

TEST(LineLessons, OtherShapesHaveNone) {
    raster::Shape circle = line({{3, 3}, {4, 4}});
    circle.kind = ShapeKind::Circle;
    raster::Shape smooth = line({{1, 1}, {9, 4}});
    smooth.antialiasing = raster::Antialiasing::Area;
    raster::Shape wide = line({{1, 1}, {9, 4}});
    wide.width = 3;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    for (const raster::Shape& shape : {circle, smooth, wide, line({{1, nan}, {9, 4}}),
                                       line({{1, 1}, {1e30f, 4}}), line({{-90, -90}, {-50, -60}})})
        EXPECT_TRUE(line_lessons(scene_of({shape}), 0).empty());
}

// A point, a line that misses the picture's corner, a line of one column, wide and tiny ones: all can be
// drawn.
TEST(LineLessons, EveryLessonCanBeDrawn) {
    for (const ScanAlgorithm algorithm :
         {ScanAlgorithm::Midpoint, ScanAlgorithm::Dda, ScanAlgorithm::Explicit, ScanAlgorithm::Wu,
          ScanAlgorithm::GuptaSproull})
        for (const auto& points :
             std::vector<std::vector<glm::vec2>>{{{4, 4}, {4, 4}},
                                                 {{-9, 5}, {5, -9}},
                                                 {{-1, 3}, {2, -3}},
                                                 {{3, -50}, {3, 50}},
                                                 {{2.3f, 4.7f}, {9.1f, 5.2f}, {9.1f, 20}}}) {
            raster::Shape shape = line(points, algorithm);
            if (algorithm == ScanAlgorithm::GuptaSproull) shape.width = 4.5f;
            const scene::LoadedScene loaded = scene_of({shape});
            const Lesson lesson = only_lesson(loaded);
            expect_well_told(lesson);
            const LessonPage page = draw_lesson_frame(lesson, loaded.axes, lesson.frames.size() - 1);
            EXPECT_GE(page.picture.width(), lesson_width);
        }
}

}  // namespace
}  // namespace relevo::show
