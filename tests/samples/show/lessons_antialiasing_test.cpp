// Lessons of smooth edges: their pixels are those of the algorithms, and their numbers are true.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "raster/area_coverage.hpp"
#include "raster/supersample.hpp"
#include "raster/weighted_coverage.hpp"
#include "samples/show/lessons.hpp"

namespace relevo::show {
namespace {

using raster::Antialiasing;
using raster::ShapeKind;
using Levels = std::map<std::pair<int, int>, int>;

raster::Shape shape(ShapeKind kind, std::vector<glm::vec2> points, Antialiasing antialiasing,
                    int samples = 4) {
    raster::Shape s;
    s.kind = kind;
    s.points = std::move(points);
    s.antialiasing = antialiasing;
    s.samples = samples;
    return s;
}
scene::LoadedScene scene_of(std::vector<raster::Shape> shapes, int width = 20, int height = 14) {
    scene::LoadedScene loaded;
    loaded.width = width, loaded.height = height;
    loaded.shapes.shapes = std::move(shapes);
    return loaded;
}
Lesson only_lesson(const scene::LoadedScene& loaded, std::size_t number = 0) {
    std::vector<Lesson> all = antialiasing_lessons(loaded, number);
    EXPECT_EQ(all.size(), 1u);
    return all.empty() ? Lesson{} : std::move(all[0]);
}
const std::vector<glm::vec2> corners{{2, 1.5f}, {16.25f, 5}, {6, 11}};
constexpr Antialiasing all_kinds[] = {Antialiasing::Area, Antialiasing::Weighted, Antialiasing::Supersample,
                                      Antialiasing::Multisample};

// How much of its colour each pixel has at the end; each is told once.
Levels levels(const Lesson& lesson) {
    Levels found;
    for (const LessonFrame& frame : lesson.frames)
        for (const Mark& m : frame.stays)
            if (m.kind == Mark::Kind::Cell) {
                EXPECT_TRUE(found.insert({{int(m.points[0].y), int(m.points[0].x)}, m.level}).second);
            }
    return found;
}
Levels right_levels(const raster::Shape& s, const raster::PixelBox& box) {
    const std::vector<std::vector<glm::dvec2>> rings{{s.points.begin(), s.points.end()}};
    Levels right;
    const auto cover = [&](int y, int x0, int x1, int coverage) {
        for (int x = x0; x < x1; ++x) right[{y, x}] = int(std::lround(coverage * 255.0 / 65536));
    };
    if (s.antialiasing == Antialiasing::Area)
        raster::area_coverage(rings, s.inside, box, cover);
    else if (s.antialiasing == Antialiasing::Weighted)
        raster::weighted_coverage(rings, s.inside, box, cover);
    else
        raster::supersample(s.samples, rings, s.inside, box, cover);
    return right;
}
const LessonFrame* frame_called(const Lesson& lesson, const std::string& title) {
    for (const LessonFrame& frame : lesson.frames)
        if (frame.title == title) return &frame;
    return nullptr;
}
bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(LessonsAntialiasing, FillThePixelsOfTheAlgorithmInAtMost48Frames) {
    for (const Antialiasing how : all_kinds)
        for (const int samples : {1, 2, 4, 7, 16})
            for (const float size : {1.f, 3.f, 20.f}) {
                std::vector<glm::vec2> points = corners;
                for (glm::vec2& p : points) p *= size;
                const auto loaded = scene_of({shape(ShapeKind::Triangle, points, how, samples)}, 340, 250);
                const Lesson lesson = only_lesson(loaded);
                EXPECT_LE(lesson.frames.size(), 48u);
                EXPECT_EQ(levels(lesson), right_levels(loaded.shapes.shapes[0], lesson.view));
                for (const LessonFrame& frame : lesson.frames) {
                    EXPECT_FALSE(frame.title.empty() || frame.caption.empty() || frame.equation.empty());
                    EXPECT_TRUE(frame.row.empty() || frame.row.size() == lesson.columns.size());
                }
                const bool cut = lesson.view.x1 - lesson.view.x0 < int(14 * size) - 2;
                EXPECT_EQ(says(lesson.frames[0].caption, "are shown, so that"), cut);
            }
}

TEST(LessonsAntialiasing, TheAreaOfAPixelIsASumOverItsEdges) {
    // Pixel (3, 4) of an upright square: a quarter; and pixel (6, 4), where the right side closes.
    const auto loaded = scene_of({shape(ShapeKind::Rectangle, {{3, 4}, {6.25f, 8}}, Antialiasing::Area)});
    const Lesson lesson = only_lesson(loaded);
    ASSERT_NE(frame_called(lesson, "pixel (3, 4)"), nullptr);
    EXPECT_EQ(frame_called(lesson, "pixel (3, 4)")->equation, "area = 0.25 -> 25 %");
    EXPECT_EQ(frame_called(lesson, "pixel (6, 4)")->equation, "area = 0.5 - 0.125 = 0.375 -> 38 %");
    EXPECT_EQ(frame_called(lesson, "pixel (6, 4)")->row,
              (std::vector<std::string>{"6", "4", "4", "0.375", "24,576", "38 %"}));
    EXPECT_EQ(lesson.frames[1].equation, "area = 1 -> 100 %");
    EXPECT_EQ(lesson.frames[1].stays.size(), 6u);
    EXPECT_EQ(lesson.frames.back().equation, "sum of all areas = 13");
}

TEST(LessonsAntialiasing, ThePieceInThePixelHasTheAreaThatIsTold) {
    const Lesson lesson = only_lesson(scene_of({shape(ShapeKind::Triangle, corners, Antialiasing::Area)}));
    int pieces = 0;
    for (const LessonFrame& frame : lesson.frames) {
        if (frame.row.empty()) continue;
        for (const Mark& m : frame.now) {
            if (m.kind != Mark::Kind::Area) continue;
            double twice = 0;
            for (std::size_t i = 0; i < m.points.size(); ++i) {
                const Spot a = m.points[i], b = m.points[(i + 1) % m.points.size()];
                twice += a.x * b.y - a.y * b.x;
            }
            EXPECT_NEAR(std::abs(twice) / 2, std::stod(frame.row[3]), 1e-4) << frame.title;
            ++pieces;
        }
    }
    EXPECT_GT(pieces, 20);
}

TEST(LessonsAntialiasing, TheSameAreaAtAnotherPlace) {
    const Lesson area = only_lesson(scene_of({shape(ShapeKind::Triangle, corners, Antialiasing::Area)}));
    EXPECT_NE(frame_called(area, "same area, other place"), nullptr);
    // One row has its centres in the middle of the band, another at its border: half of the area each.
    auto band =
        shape(ShapeKind::Polyline, {{2, 2}, {12, 2}, {12, 7.25f}, {2, 7.25f}}, Antialiasing::Weighted);
    band.width = 0.5f;
    const Lesson weighted = only_lesson(scene_of({band}));
    const LessonFrame* pair = frame_called(weighted, "same area, other weight");
    ASSERT_NE(pair, nullptr);
    EXPECT_TRUE(says(pair->equation, "area 0.5 and 0.5, weight ")) << pair->equation;
    const Lesson none =
        only_lesson(scene_of({shape(ShapeKind::Line, {{1, 5}, {7, 5}}, Antialiasing::Weighted)}));
    EXPECT_EQ(frame_called(none, "same area, other weight"), nullptr) << "only untouched pixels are alike";
}

TEST(LessonsAntialiasing, TheConeReachesBeyondTheShape) {
    const auto loaded =
        scene_of({shape(ShapeKind::Rectangle, {{4.6f, -3}, {9, 20}}, Antialiasing::Weighted)});
    const Lesson lesson = only_lesson(loaded);
    const LessonFrame* beside = frame_called(lesson, "pixel (4, 5)");
    ASSERT_NE(beside, nullptr);
    EXPECT_TRUE(says(beside->caption, "does not touch"));
    EXPECT_TRUE(says(beside->equation, "(area alone: 0)"));
    // The cone is lower than 1, so a pixel has more than its area only by what lies beyond its square.
    const Lesson grown =
        only_lesson(scene_of({shape(ShapeKind::Rectangle, {{5.25f, -3}, {9, 20}}, Antialiasing::Weighted)}));
    const LessonFrame* more = frame_called(grown, "pixel (5, 5)");
    ASSERT_NE(more, nullptr);
    EXPECT_TRUE(says(more->equation, "(area alone: 0.25)"));
    EXPECT_TRUE(says(more->caption, "More than the area alone: the cone meets the shape beyond"));
    const Lesson halved =
        only_lesson(scene_of({shape(ShapeKind::Rectangle, {{5, -3}, {9, 20}}, Antialiasing::Weighted)}));
    ASSERT_NE(frame_called(halved, "pixel (5, 5)"), nullptr);
    EXPECT_TRUE(says(frame_called(halved, "pixel (5, 5)")->caption, "As much as the area alone"));
    EXPECT_TRUE(says(lesson.frames[0].equation, "0.9549"));
}

TEST(LessonsAntialiasing, SamplesAreCounted) {
    const auto loaded =
        scene_of({shape(ShapeKind::Rectangle, {{2, 2}, {5.25f, 6}}, Antialiasing::Supersample, 4)});
    const Lesson lesson = only_lesson(loaded);
    const LessonFrame* corner = frame_called(lesson, "pixel (2, 2)");
    ASSERT_NE(corner, nullptr);
    EXPECT_EQ(corner->equation, "4 of 16 = 0.25 -> 25 %  (area: 0.25)");
    const auto of_kind = [&](Mark::Kind kind) {
        return std::count_if(corner->now.begin(), corner->now.end(),
                             [&](const Mark& m) { return m.kind == kind; });
    };
    EXPECT_EQ(of_kind(Mark::Kind::Dot), 4);
    EXPECT_EQ(of_kind(Mark::Kind::Cross), 12);
    // A sliver that slips between the points.
    const Lesson missed = only_lesson(
        scene_of({shape(ShapeKind::Rectangle, {{2, 2.1f}, {5, 2.2f}}, Antialiasing::Supersample, 2)}));
    EXPECT_NE(frame_called(missed, "missed"), nullptr);
}

TEST(LessonsAntialiasing, TheSeamAndItsCure) {
    const std::vector<glm::vec2> one{{1, 1}, {9, 1}, {1, 9}}, two{{9, 1}, {9, 9}, {1, 9}};
    const Lesson area = only_lesson(scene_of({shape(ShapeKind::Triangle, one, Antialiasing::Area),
                                              shape(ShapeKind::Triangle, two, Antialiasing::Area)}));
    ASSERT_NE(frame_called(area, "a seam"), nullptr);
    EXPECT_EQ(frame_called(area, "a seam")->equation, "1 - (1 - 0.5)(1 - 0.5) = 0.75, not 1");
    const auto loaded = scene_of({shape(ShapeKind::Triangle, one, Antialiasing::Multisample),
                                  shape(ShapeKind::Triangle, two, Antialiasing::Multisample)});
    for (const std::size_t number : {0u, 1u}) {
        const Lesson shared = only_lesson(loaded, number);
        ASSERT_NE(frame_called(shared, "no seam"), nullptr);
        EXPECT_TRUE(
            says(frame_called(shared, "no seam")->equation, " = 16;  area: 1 - (1 - 0.5)(1 - 0.5) = 0.75"));
        EXPECT_TRUE(says(frame_called(shared, "no seam")->caption, "outlined in orange"));
        int filled = 0;
        for (const LessonFrame& frame : shared.frames) {
            if (frame.row.empty() || frame.row[3] == "0") continue;
            const int x = std::stoi(frame.row[0]), y = std::stoi(frame.row[1]);
            if (x == 1 || x == 9 || y == 1 || y == 9)
                continue;  // the ends of the edge, on the square's border
            EXPECT_EQ(frame.row[4], "0") << "no point on the shared edge is free";
            EXPECT_EQ(std::stoi(frame.row[2]) + std::stoi(frame.row[3]), 16);
            ++filled;
        }
        EXPECT_GT(filled, 3);
    }
}

TEST(LessonsAntialiasing, LinesAreTheirRectangles) {
    auto line = shape(ShapeKind::Line, {{2, 2}, {12, 6}}, Antialiasing::Area);
    line.width = 2;
    const Lesson lesson = only_lesson(scene_of({line}));
    ASSERT_EQ(lesson.ground.size(), 1u);
    EXPECT_EQ(lesson.ground[0].points.size(), 4u);
    EXPECT_EQ(lesson.frames.back().equation, "sum of all areas = 21.54") << "2 times the length, 10.77";
    line.kind = ShapeKind::Polyline;
    line.points.push_back({3, 11});
    EXPECT_EQ(only_lesson(scene_of({line})).ground.size(), 2u);
}

TEST(LessonsAntialiasing, NamesPlacesByTheAxes) {
    auto loaded = scene_of({shape(ShapeKind::Rectangle, {{3, 4}, {6.25f, 8}}, Antialiasing::Area)});
    loaded.axes = {-10, 5, true};
    EXPECT_NE(frame_called(only_lesson(loaded), "pixel (-7, 1)"), nullptr);
}

TEST(LessonsAntialiasing, OthersHaveNone) {
    const float bad = std::numeric_limits<float>::quiet_NaN();
    for (const Antialiasing how : all_kinds) {
        auto circle = shape(ShapeKind::Circle, {{5, 5}}, how);
        circle.radius_x = circle.radius_y = 3;
        EXPECT_TRUE(antialiasing_lessons(scene_of({circle}), 0).empty());
        EXPECT_TRUE(
            antialiasing_lessons(scene_of({shape(ShapeKind::Triangle, {{1, bad}, {2, 2}, {3, 1}}, how)}), 0)
                .empty());
        EXPECT_TRUE(
            antialiasing_lessons(scene_of({shape(ShapeKind::Polygon, {{1, 1}, {2, 2}}, how)}), 0).empty());
        EXPECT_TRUE(antialiasing_lessons(
                        scene_of({shape(ShapeKind::Triangle, {{90, 90}, {99, 90}, {95, 99}}, how)}), 0)
                        .empty())
            << "outside of the picture";
        auto wu = shape(ShapeKind::Line, {{1, 1}, {9, 4}}, how);
        wu.algorithm = raster::ScanAlgorithm::Wu;
        EXPECT_TRUE(antialiasing_lessons(scene_of({wu}), 0).empty()) << "it has its own lesson";
    }
    EXPECT_TRUE(
        antialiasing_lessons(scene_of({shape(ShapeKind::Triangle, corners, Antialiasing::None)}), 0).empty());
    EXPECT_TRUE(antialiasing_lessons(
                    scene_of({shape(ShapeKind::Triangle, corners, Antialiasing::Supersample, 17)}), 0)
                    .empty());
}

}  // namespace
}  // namespace relevo::show
