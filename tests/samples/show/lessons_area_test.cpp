// Lessons of triangles, rectangles and polygons: what they light, say and leave out.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "raster/polygon_active_edges.hpp"
#include "samples/show/lessons.hpp"
#include "tests/support/hard.hpp"

namespace relevo::show {
namespace {

using raster::ScanAlgorithm;
using raster::ShapeKind;
using Pixels = std::set<std::pair<int, int>>;

raster::Shape shape(ShapeKind kind, std::vector<glm::vec2> points, ScanAlgorithm algorithm) {
    raster::Shape s;
    s.kind = kind;
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

Lesson only_lesson(const scene::LoadedScene& loaded, std::size_t shape = 0) {
    std::vector<Lesson> all = area_lessons(loaded, shape);
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

Pixels covered(const scene::LoadedScene& loaded, const raster::PixelBox& box) {
    const raster::Shape& s = loaded.shapes.shapes[0];
    std::vector<raster::SnappedPoint> ring;
    for (const glm::vec2& p : s.points) ring.push_back(raster::snapped(p.x, p.y));
    if (s.kind == ShapeKind::Rectangle)
        ring = {ring[0], {ring[1].x, ring[0].y}, ring[1], {ring[0].x, ring[1].y}};
    Pixels pixels;
    raster::polygon_active_edges(std::span(&ring, 1), s.inside, loaded.shapes.fill_rule, box,
                                 [&](int y, int x0, int x1) {
                                     for (int x = x0; x < x1; ++x) pixels.insert({x, y});
                                 });
    return pixels;
}

const LessonFrame& frame_called(const Lesson& lesson, const std::string& title) {
    for (const LessonFrame& frame : lesson.frames)
        if (frame.title == title) return frame;
    ADD_FAILURE() << "no frame is called " << title;
    return lesson.frames.at(0);
}

const std::vector<glm::vec2> corners{{2, 1}, {17, 5}, {6, 12}};

TEST(LessonsArea, LightThePixelsOfTheAlgorithmInAtMost48Frames) {
    tests::hard::Random random(3);
    for (int i = 0; i < 120; ++i) {
        const int size = i % 3 == 0 ? 200 : 30;
        const auto place = [&] {
            const double v = random.between(-3, size);
            return static_cast<float>(i % 2 ? v : std::floor(v));
        };
        const auto point = [&] {
            const float x = place();
            return glm::vec2{x, place()};
        };
        const glm::vec2 a = point(), b = point(), c = point(), d = point(), e = point();
        for (raster::Shape s : {shape(ShapeKind::Triangle, {a, b, c}, ScanAlgorithm::Scanline),
                                shape(ShapeKind::Triangle, {a, b, c}, ScanAlgorithm::EdgeFunction),
                                shape(ShapeKind::Triangle, {a, b, c}, ScanAlgorithm::ActiveEdges),
                                shape(ShapeKind::Rectangle, {a, b}, ScanAlgorithm::Scanline),
                                shape(ShapeKind::Polygon, {a, b, c, d, e}, ScanAlgorithm::ActiveEdges)}) {
            s.inside = i % 4 < 2 ? raster::InsideRule::NonZero : raster::InsideRule::EvenOdd;
            scene::LoadedScene loaded = scene_of({s, s}, size, size);
            loaded.shapes.fill_rule = i % 8 < 4 ? raster::FillRule::TopLeft : raster::FillRule::Book;
            loaded.axes.y_up = i % 5 == 0;
            const std::vector<Lesson> lessons = area_lessons(loaded, 0);
            if (lessons.empty()) continue;  // outside of the picture
            const Lesson& lesson = lessons[0];
            ASSERT_EQ(lit(lesson), covered(loaded, lesson.view)) << lesson.name << ", case " << i;
            EXPECT_LE(lesson.frames.size(), 48u);
            EXPECT_GE(lesson.frames.size(), 1u);
            for (const LessonFrame& frame : lesson.frames) {
                EXPECT_FALSE(frame.title.empty());
                EXPECT_FALSE(frame.equation.empty());
                EXPECT_FALSE(frame.caption.empty());
                EXPECT_TRUE(frame.row.empty() || frame.row.size() == lesson.columns.size());
            }
        }
    }
}

TEST(LessonsArea, TheTrianglesRowsHaveTheirFractions) {
    const Lesson lesson =
        only_lesson(scene_of({shape(ShapeKind::Triangle, corners, ScanAlgorithm::Scanline)}));
    EXPECT_EQ(lesson.name, "triangle-scanline");
    EXPECT_EQ(frame_called(lesson, "which edge is which").equation,
              "long edge: 11 rows, edge 2: 4 rows, edge 3: 7 rows");
    EXPECT_EQ(frame_called(lesson, "edge 3 begins").equation,
              "x = 17; a row: x -= 2, rest -= 3; rest < 0: x += 1, rest += 7");
    const LessonFrame& row = frame_called(lesson, "row y = 3");
    EXPECT_EQ(row.equation, "left 3 - 3/11 = 2.727, right 10 - 2/4 = 9.5: pixels 3 to 9");
    EXPECT_EQ(row.row, (std::vector<std::string>{"3", "3 - 3/11", "10 - 2/4", "7"}));
    EXPECT_EQ(frame_called(lesson, "done").equation, "74 pixels lit");
}

TEST(LessonsArea, TheEdgeFunctionsAreThoseOfTheSceneFile) {
    scene::LoadedScene loaded = scene_of({shape(ShapeKind::Triangle, corners, ScanAlgorithm::EdgeFunction)});
    loaded.axes = {0, 13, true};  // y upwards: the corners are (2, 12), (17, 8), (6, 1)
    const Lesson lesson = only_lesson(loaded);
    EXPECT_EQ(lesson.name, "triangle-edge-function");
    EXPECT_EQ(frame_called(lesson, "edge 0: E0").equation, "E0 = -7x + 11y + 31 > 0");
    EXPECT_EQ(frame_called(lesson, "edge 1: E1").equation, "E1 = 11x + 4y - 70 ≥ 0");
    EXPECT_EQ(frame_called(lesson, "row y = 8").equation, "at (4, 8): E0 = 91, E1 = 6, E2 = 52 -> lit");
    EXPECT_NE(
        frame_called(lesson, "row y = 8").caption.find("at (17, 8): E0 = 0 on an edge of the neighbour"),
        std::string::npos);
}

TEST(LessonsArea, TheRectangleSaysWhichSidesAreClosed) {
    scene::LoadedScene loaded =
        scene_of({shape(ShapeKind::Rectangle, {{3, 9}, {11, 2}}, ScanAlgorithm::Scanline)});
    EXPECT_EQ(only_lesson(loaded).frames[0].equation, "3 ≤ x < 11,  2 ≤ y < 9");
    loaded.shapes.fill_rule = raster::FillRule::Book;
    EXPECT_EQ(only_lesson(loaded).frames[0].equation, "3 ≤ x < 11,  2 < y ≤ 9");
    loaded.axes = {10, 20, true};
    EXPECT_EQ(only_lesson(loaded).frames[0].equation, "13 ≤ x < 21,  11 ≤ y < 18");
}

TEST(LessonsArea, ThePolygonTellsItsTwoLists) {
    const Lesson lesson = only_lesson(scene_of(
        {shape(ShapeKind::Polygon, {{0, 8}, {2, 0}, {5, 5}, {8, 0}, {10, 8}}, ScanAlgorithm::ActiveEdges)}));
    EXPECT_EQ(lesson.name, "polygon-active-edges");
    EXPECT_EQ(frame_called(lesson, "edge table").equation, "y = 0: 0 1 2 3");
    EXPECT_NE(lesson.frames[0].caption.find("The other 1 crosses none here."), std::string::npos);
    const LessonFrame& row = frame_called(lesson, "row y = 4: 4 active edges");
    EXPECT_EQ(row.equation, "x = 1 (-1), 4.4 (+1), 5.6 (-1), 9 (+1)");
    EXPECT_NE(row.caption.find("0, -1, 0, -1, 0: inside where it is not 0"), std::string::npos);
    EXPECT_EQ(row.row, (std::vector<std::string>{"4", "0, 1, 2, 3", "7"}));
    EXPECT_NE(frame_called(lesson, "row y = 5: 2 active edges").caption.find("Leave: edges 1, 2"),
              std::string::npos);
}

// Fig. 5.9: four triangles round (8, 8).
TEST(LessonsArea, ASharedCornerHasOneOwner) {
    const auto triangle = [](glm::vec2 b, glm::vec2 c) {
        return shape(ShapeKind::Triangle, {{8, 8}, b, c}, ScanAlgorithm::Scanline);
    };
    const scene::LoadedScene loaded = scene_of({triangle({2, 2}, {14, 2}), triangle({14, 2}, {14, 14}),
                                                triangle({14, 14}, {2, 14}), triangle({2, 14}, {2, 2})});
    for (std::size_t i = 0; i < 4; ++i) {
        const Lesson lesson = only_lesson(loaded, i);
        EXPECT_EQ(frame_called(lesson, "shared corner (8, 8)").equation,
                  "4 shapes, pixel (8, 8): lit by shape 2");  // the one right of it
    }
}

TEST(LessonsArea, SayWhatTheyLeaveOut) {
    const Lesson lesson = only_lesson(scene_of(
        {shape(ShapeKind::Triangle, {{5, 5}, {190, 40}, {60, 180}}, ScanAlgorithm::Scanline)}, 200, 200));
    EXPECT_LE(lesson.view.x1 - lesson.view.x0, 64);
    EXPECT_NE(lesson.frames[0].caption.find("Only its first 64 columns and 48 rows"), std::string::npos);
    EXPECT_TRUE(std::ranges::any_of(lesson.frames, [](const LessonFrame& f) {
        return f.caption.find("treated alike, is left out here") != std::string::npos;
    }));
}

TEST(LessonsArea, OthersHaveNoLessonHere) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    raster::Shape smooth = shape(ShapeKind::Triangle, corners, ScanAlgorithm::Scanline);
    smooth.antialiasing = raster::Antialiasing::Area;
    for (const raster::Shape& s :
         {smooth, shape(ShapeKind::Circle, {{5, 5}}, ScanAlgorithm::Midpoint),
          shape(ShapeKind::Line, {{5, 5}, {9, 9}}, ScanAlgorithm::Midpoint),
          shape(ShapeKind::Polygon, {{5, 5}, {9, 9}}, ScanAlgorithm::ActiveEdges),
          shape(ShapeKind::Triangle, {{1, 1}, {nan, 2}, {3, 5}}, ScanAlgorithm::Scanline),
          shape(ShapeKind::Triangle, {{1, 1}, {40000, 2}, {3, 5}}, ScanAlgorithm::Scanline),
          shape(ShapeKind::Triangle, {{-9, 1}, {-5, 2}, {-7, 5}}, ScanAlgorithm::Scanline)})
        EXPECT_TRUE(area_lessons(scene_of({s}), 0).empty());
    const Lesson flat = only_lesson(
        scene_of({shape(ShapeKind::Triangle, {{1, 1}, {2, 2}, {5, 5}}, ScanAlgorithm::EdgeFunction)}));
    EXPECT_EQ(flat.frames[0].title, "no area");
}

}  // namespace
}  // namespace relevo::show
