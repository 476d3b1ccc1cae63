// Lessons: what [[shape2d]], [axes] and [clip] say, and every error with its place.
#include "samples/scene/shapes2d.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "samples/scene/scene.hpp"

namespace relevo::scene {
namespace {

using raster::Antialiasing;
using raster::ScanAlgorithm;
using raster::ShapeKind;
using Point = glm::vec2;
using Points = std::vector<Point>;

LoadedScene parsed(const std::string& text, const SceneOptions& options = {}) {
    auto scene = parse_scene(text, "lesson.toml", options);
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? std::move(*scene) : LoadedScene{};
}

std::string error_of(const std::string& text, const SceneOptions& options = {}) {
    const auto scene = parse_scene(text, "lesson.toml", options);
    return scene ? "no error" : scene.error().text();
}

raster::Shape shape(const std::string& keys) { return parsed("[[shape2d]]\n" + keys).shapes.shapes.at(0); }

const std::string line = "[[shape2d]]\ntype = \"line\"\npoints = [[0, 0], [7, 3]]\n";

// ---------------------------------------------------------------------------------------------- what is read

TEST(Lesson, OneLineIsEnough) {
    const LoadedScene s = parsed(line);
    EXPECT_TRUE(is_lesson(s));
    EXPECT_TRUE(s.scene.models.empty());
    EXPECT_EQ(s.width, 640);
    EXPECT_EQ(s.height, 480);
    EXPECT_EQ(s.zoom, 1);
    EXPECT_EQ(s.axes.left, 0);
    EXPECT_EQ(s.axes.top, 0);
    EXPECT_FALSE(s.shapes.clip.on);
    EXPECT_EQ(s.shapes.fill_rule, raster::FillRule::TopLeft);
    EXPECT_EQ(s.shapes.background, (pipeline::LinearRgb{0.1f, 0.1f, 0.12f}));
    ASSERT_EQ(s.shapes.shapes.size(), 1u);
    const raster::Shape& one = s.shapes.shapes[0];
    EXPECT_EQ(one.kind, ShapeKind::Line);
    EXPECT_EQ(one.points, (Points{{0, 0}, {7, 3}}));
    EXPECT_EQ(one.algorithm, ScanAlgorithm::Midpoint);
    EXPECT_EQ(one.antialiasing, Antialiasing::None);
    EXPECT_EQ(one.width, 1);
    EXPECT_EQ(one.opacity, 1);
    EXPECT_EQ(one.color, (pipeline::LinearRgb{1, 1, 1}));
}

TEST(Lesson, ReadsEveryKeyOfAShape) {
    const raster::Shape line_shape = shape(
        "type = \"line\"\npoints = [[0.5, 0], [7, 3]]\nantialiasing = \"supersample\"\nsamples = 16\n"
        "width = 2.5\ncolor = [1, 0.5, 0]\nopacity = 0.25\n");
    EXPECT_EQ(line_shape.antialiasing, Antialiasing::Supersample);
    EXPECT_EQ(line_shape.samples, 16);
    EXPECT_EQ(line_shape.width, 2.5f);
    EXPECT_EQ(line_shape.color, (pipeline::LinearRgb{1, 0.5f, 0}));
    EXPECT_EQ(line_shape.opacity, 0.25f);
    EXPECT_TRUE(shape("type = \"line\"\npoints = [[0, 0], [7, 3]]\neven_weight = true\n").even_weight);
    const raster::Shape star =
        shape("type = \"polygon\"\npoints = [[0, 0], [4, 0.5], [0, 1]]\ninside = \"even-odd\"\n");
    EXPECT_EQ(star.inside, raster::InsideRule::EvenOdd);
    EXPECT_EQ(star.algorithm, ScanAlgorithm::ActiveEdges);
    const raster::Shape ellipse =
        shape("type = \"ellipse\"\ncenter = [5, 6]\nradius = [4, 3]\nalgorithm = \"textbook\"\n");
    EXPECT_EQ(ellipse.points, (Points{{5, 6}}));
    EXPECT_EQ(ellipse.radius_x, 4);
    EXPECT_EQ(ellipse.radius_y, 3);
    EXPECT_EQ(ellipse.algorithm, ScanAlgorithm::Textbook);
    const raster::Shape disc = shape(
        "type = \"circle\"\ncenter = [5.5, 6]\nradius = 3.25\nfilled = true\nantialiasing = \"area\"\n");
    EXPECT_TRUE(disc.filled);
    EXPECT_EQ(disc.radius_x, 3.25f);
    EXPECT_EQ(disc.radius_y, 3.25f);
}

TEST(Lesson, ReadsEveryWord) {
    const std::pair<const char*, ShapeKind> areas[] = {
        {"rectangle", ShapeKind::Rectangle}, {"polyline", ShapeKind::Polyline}, {"line", ShapeKind::Line}};
    for (const auto& [word, kind] : areas)
        EXPECT_EQ(shape(std::string("points = [[0, 0], [7, 3]]\ntype = \"") + word + "\"\n").kind, kind);
    for (const auto& algorithm : scan_algorithms) {
        bool taken = false;
        for (const char* type : {"type = \"line\"\npoints = [[0, 0], [7, 3]]\n",
                                 "type = \"ellipse\"\ncenter = [0, 0]\nradius = [1, 2]\n",
                                 "type = \"triangle\"\npoints = [[0, 0], [7, 3], [1, 9]]\n"}) {
            const auto scene = parse_scene(
                std::string("[[shape2d]]\n") + type + "algorithm = \"" + std::string(algorithm.name) + "\"\n",
                "lesson.toml");
            if (!scene) continue;
            taken = true;
            EXPECT_EQ(scene->shapes.shapes[0].algorithm, algorithm.meaning);
        }
        EXPECT_TRUE(taken) << algorithm.name;
    }
    for (const auto& way : antialiasings)
        EXPECT_EQ(shape("type = \"line\"\npoints = [[0, 0], [7, 3]]\nantialiasing = \"" +
                        std::string(way.name) + "\"\n")
                      .antialiasing,
                  way.meaning);
}

TEST(Lesson, CoordinatesAreThoseOfTheAxes) {
    const LoadedScene down = parsed("[axes]\nextent = [-3, 2, 12, 13]\n" + line);
    EXPECT_EQ(down.width, 16);
    EXPECT_EQ(down.height, 12);
    EXPECT_EQ(down.shapes.shapes[0].points, (Points{{3, -2}, {10, 1}}));
    EXPECT_EQ(down.axes.x_of(3), 0);
    EXPECT_EQ(down.axes.y_of(-2), 0);
    const LoadedScene up = parsed("[axes]\nextent = [-3, -2, 12, 9]\ny = \"up\"\n" + line);
    EXPECT_EQ(up.height, 12);
    EXPECT_EQ(up.shapes.shapes[0].points, (Points{{3, 9}, {10, 6}}));
    const LoadedScene whole = parsed("[image]\nwidth = 8\nheight = 4\n[axes]\ny = \"up\"\n" + line);
    EXPECT_EQ(whole.shapes.shapes[0].points, (Points{{0, 3}, {7, 0}}));
}

TEST(Lesson, ThePictureHasTheSizeOfTheExtent) {
    const std::string axes = "[axes]\nextent = [0, 0, 15, 11]\n";
    const LoadedScene s = parsed("[image]\nwidth = 16\nheight = 12\nzoom = 20\n" + axes + line);
    EXPECT_EQ(s.width, 16);
    EXPECT_EQ(s.zoom, 20);
    EXPECT_EQ(
        error_of("[image]\nwidth = 15\n" + axes + line),
        "lesson.toml:2:9: image.width is 15, accepted: 16, the pixels of axes.extent, or no width at all");
    EXPECT_EQ(
        error_of("[image]\nheight = 15\n" + axes + line),
        "lesson.toml:2:10: image.height is 15, accepted: 12, the pixels of axes.extent, or no height at "
        "all");
    EXPECT_EQ(parsed(axes + line, {{}, std::pair(16, 12)}).width, 16);
    EXPECT_EQ(error_of(axes + line, {{}, std::pair(20, 12)}),
              "--size 20x12: the picture of a lesson with axes.extent is 16x12; image.zoom enlarges it");
    EXPECT_EQ(parsed(line, {{}, std::pair(20, 12)}).width, 20);
}

TEST(Lesson, ReadsTheWindow) {
    const std::string axes = "[axes]\nextent = [0, 0, 15, 11]\ny = \"up\"\n";
    const raster::ShapeClip box =
        parsed(axes +
               "[clip]\nwindow = [1, 2.5, 7, 9]\nlines = \"midpoint\"\npolygons = \"pipeline\"\n"
               "order = [\"left\", \"top\", \"right\", \"bottom\"]\nsplit = true\n" +
               line)
            .shapes.clip;
    EXPECT_TRUE(box.on);
    EXPECT_EQ(box.low, Point(1, 2));
    EXPECT_EQ(box.high, Point(7, 8.5f));
    EXPECT_EQ(box.lines, raster::LineClipper::MidpointSubdivision);
    EXPECT_EQ(box.polygons, raster::PolygonClipper::SutherlandHodgmanPipeline);
    EXPECT_TRUE(box.split);
    EXPECT_EQ(box.order[0], raster::Side::Left);
    EXPECT_EQ(box.order[3], raster::Side::Bottom);
    const raster::ShapeClip triangle =
        parsed(axes + "[clip]\npolygon = [[0, 0], [4, 0], [0, 11]]\n" + line).shapes.clip;
    EXPECT_EQ(triangle.polygon, (Points{{0, 11}, {4, 11}, {0, 0}}));
    EXPECT_EQ(triangle.lines, raster::LineClipper::CyrusBeck);
    const std::string arrow = "[clip]\npolygon = [[0, 0], [8, 4], [0, 8], [2, 4]]\n";
    EXPECT_EQ(parsed(arrow + "polygons = \"greiner-hormann\"\n" + line).shapes.clip.polygon.size(), 4u);
}

TEST(Lesson, AWindowMayBeOnePointOrALine) {
    EXPECT_EQ(parsed("[clip]\nwindow = [3, 4, 3, 4]\n" + line).shapes.clip.high, Point(3, 4));
}

TEST(Lesson, ThePipelineSpeaksForShapesThatSayNothing) {
    const std::string two =
        line + "[[shape2d]]\ntype = \"circle\"\ncenter = [3, 3]\nradius = 2\n" +
        "[[shape2d]]\ntype = \"line\"\npoints = [[0, 0], [7, 3]]\nantialiasing = \"area\"\n";
    const LoadedScene s = parsed(two, {{"antialiasing=supersample", "samples=8", "fill_rule=book"}, {}});
    EXPECT_EQ(s.shapes.shapes[0].antialiasing, Antialiasing::Supersample);
    EXPECT_EQ(s.shapes.shapes[0].samples, 8);
    EXPECT_EQ(s.shapes.shapes[1].antialiasing, Antialiasing::None);  // circles do not take it
    EXPECT_EQ(s.shapes.shapes[2].antialiasing, Antialiasing::Area);  // its own key comes first
    EXPECT_EQ(s.shapes.fill_rule, raster::FillRule::Book);
    const LoadedScene dda = parsed("[pipeline]\nalgorithm = \"dda\"\n" + two);
    EXPECT_EQ(dda.shapes.shapes[0].algorithm, ScanAlgorithm::Dda);
    EXPECT_EQ(dda.shapes.shapes[1].algorithm, ScanAlgorithm::Midpoint);
    const LoadedScene chosen = parsed(line + "algorithm = \"dda\"\n", {{"antialiasing=area"}, {}});
    EXPECT_EQ(chosen.shapes.shapes[0].antialiasing, Antialiasing::Area);
}

TEST(Lesson, APolygonMayCrossItselfAndRepeatPoints) {
    const raster::Shape s =
        shape("type = \"polygon\"\npoints = [[0, 0], [0, 0], [9, 9], [9, 0], [0, 9], [0, 9]]\n");
    EXPECT_EQ(s.points.size(), 6u);
}

TEST(Lesson, PointsFarAwayAreExact) {
    const raster::Shape s =
        shape("type = \"polygon\"\npoints = [[-32767, 0], [32767, 0.00390625], [0, 32767]]\n");
    EXPECT_EQ(s.points, (Points{{-32767, 0}, {32767, 0.00390625f}, {0, 32767}}));
}

TEST(Lesson, AHundredThousandCornersAreRead) {
    std::string text = "type = \"polygon\"\npoints = [";
    for (int i = 0; i < 100'000; ++i) text += i % 2 == 0 ? "[1,2]," : "[30,4],";
    EXPECT_EQ(shape(text + "]\n").points.size(), 100'000u);
}

// ---------------------------------------------------------------------------------------------- what is
// refused

struct Bad {
    const char *text, *error;
};
class BadLesson : public testing::TestWithParam<Bad> {};
TEST_P(BadLesson, IsRefusedAtItsPlace) {
    EXPECT_EQ(error_of(GetParam().text), std::string("lesson.toml:") + GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    Tables, BadLesson,
    testing::Values(Bad{"[[shape2d]]\n[[object]]\nmesh = \"cube\"",
                        "2:3: a scene is made of [[object]]s or of [[shape2d]]s, not of both"},
                    Bad{"[camera]\n[[shape2d]]\n",
                        "1:2: camera is for [[object]]s, and this scene is made of [[shape2d]]s"},
                    Bad{"[[shape2d]]\n[[light]]\n",
                        "2:3: light is for [[object]]s, and this scene is made of [[shape2d]]s"},
                    Bad{"[axes]\n[[object]]\nmesh = \"cube\"",
                        "1:2: axes is for [[shape2d]]s, and this scene is made of [[object]]s"},
                    Bad{"[clip]\n[[object]]\nmesh = \"cube\"",
                        "1:2: clip is for [[shape2d]]s, and this scene is made of [[object]]s"},
                    Bad{"[shape2d]\ntype = \"line\"",
                        "1:2: [shape2d] is one table, accepted: [[shape2d]], which may be repeated"},
                    Bad{"[[shape2b]]\ntype = \"line\"",
                        "1:3: unknown table or key shape2b, accepted: [image], [camera], [[light]], "
                        "[[object]], [animation], [axes], "
                        "[clip], [[shape2d]], [pipeline], did you mean 'shape2d'?"}));

INSTANTIATE_TEST_SUITE_P(
    Axes, BadLesson,
    testing::Values(
        Bad{"[axes]\nextent = [0, 0, 3]\n[[shape2d]]",
            "2:10: axes.extent is a list of 3, accepted: four numbers in brackets, each a whole number from "
            "-1000000 to 1000000"},
        Bad{"[axes]\nextent = [5, 0, 3, 3]\n[[shape2d]]",
            "2:10: axes.extent goes from (5, 0) to (3, 3), accepted: [x0, y0, x1, y1] with x0 <= x1 and y0 "
            "<= "
            "y1"},
        Bad{"[axes]\nextent = [0, 0, 3.5, 3]\n[[shape2d]]",
            "2:17: axes.extent[2] is 3.5, accepted: a whole number from -1000000 to 1000000"},
        Bad{"[axes]\nextent = [0, 0, inf, 3]\n[[shape2d]]",
            "2:17: axes.extent[2] is inf, accepted: a whole number from -1000000 to 1000000"},
        Bad{"[axes]\nextent = [0, 0, 8192, 3]\n[[shape2d]]",
            "2:10: axes.extent has 8193x4 pixels, accepted: at most 8192 a side"},
        Bad{"[axes]\ny = \"upp\"\n[[shape2d]]", "2:5: axes.y is \"upp\", accepted: up, down"},
        Bad{"[image]\nzoom = 0\n[[shape2d]]", "2:8: image.zoom is 0, accepted: a whole number from 1 to 64"},
        Bad{"[image]\nzoom = 13\n[[shape2d]]",
            "2:8: image.zoom makes a picture of 8320x6240 pixels, accepted: at most 8192 a side"},
        Bad{"[pipeline]\nshading = \"flat\"\n[[shape2d]]",
            "2:1: unknown key pipeline.shading, accepted: fill_rule, algorithm, antialiasing, samples"},
        Bad{"[pipeline]\nfill_rule = \"topleft\"\n[[shape2d]]",
            "2:13: pipeline.fill_rule is \"topleft\", accepted: top-left, book, did you mean 'top-left'?"}));

INSTANTIATE_TEST_SUITE_P(
    Shapes, BadLesson,
    testing::Values(
        Bad{"[[shape2d]]\n",
            "1:1: shape2d.type is missing, accepted: line, polyline, circle, ellipse, rectangle, triangle, "
            "polygon"},
        Bad{"[[shape2d]]\ntype = \"cirkle\"",
            "2:8: shape2d.type is \"cirkle\", accepted: line, polyline, circle, ellipse, rectangle, "
            "triangle, "
            "polygon, did you mean 'circle'?"},
        Bad{"[[shape2d]]\ntype = \"line\"",
            "1:1: shape2d.points is missing, accepted: [[x0, y0], [x1, y1]], the two ends of the line"},
        Bad{"[[shape2d]]\ntype = \"line\"\npoints = [[0, 0]]",
            "3:10: shape2d.points is a list of 1, accepted: [[x0, y0], [x1, y1]], the two ends of the line"},
        Bad{"[[shape2d]]\ntype = \"line\"\npoints = 3",
            "3:10: shape2d.points is 3, accepted: [[x0, y0], [x1, y1]], the two ends of the line"},
        Bad{"[[shape2d]]\ntype = \"line\"\npoints = [[0, 0], [1, 2, 3]]",
            "3:19: shape2d.points[1] is a list of 3, accepted: two numbers in brackets, each from "
            "-32767 to 32767 for x and from -32767 to 32767 for y"},
        Bad{"[[shape2d]]\ntype = \"line\"\npoints = [[0, 0], [1.5, 2]]",
            "3:19: shape2d.points[1] is [1.5, 2], accepted: whole numbers, since algorithm = \"midpoint\" "
            "works "
            "in whole pixels (antialiasing = \"area\" takes any number)"},
        Bad{"[[shape2d]]\ntype = \"line\"\npoints = [[nan, 0], [1, 2]]",
            "3:12: shape2d.points[0][0] is nan, accepted: from -32767 to 32767 for x and from "
            "-32767 "
            "to 32767 for y"},
        Bad{"[axes]\nextent = [100, 100, 200, 200]\ny = \"up\"\n[[shape2d]]\ntype = \"line\"\npoints = [[0, "
            "inf], "
            "[1, 2]]",
            "6:15: shape2d.points[0][1] is inf, accepted: from -32667 to 32867 for x and from "
            "-32567 "
            "to 32967 for y"},
        Bad{"[[shape2d]]\ntype = \"line\"\npoints = [[0, 0], [4294967296, 2]]",
            "3:20: shape2d.points[1][0] is 4294967296, accepted: from -32767 to 32767 for x and "
            "from "
            "-32767 to 32767 for y"},
        Bad{"[[shape2d]]\ntype = \"line\"\npoints = [[\"a\", 0], [1, 1]]",
            "3:12: shape2d.points[0][0] is \"a\", accepted: a number, from -32767 to 32767 for x and from "
            "-32767 to 32767 for y"},
        Bad{"[[shape2d]]\ntype = \"polygon\"\npoints = [[0, 0], [1, 2]]",
            "3:10: shape2d.points is a list of 2, accepted: 3 to 1000000 corners [x, y]"},
        Bad{"[[shape2d]]\ntype = \"triangle\"\npoints = [[0, 0], [1, 2], [2, 3], [4, 5]]",
            "3:10: shape2d.points is a list of 4, accepted: three corners, as in [[0, 0], [8, 0], [0, 6]]"},
        Bad{"[[shape2d]]\ntype = \"circle\"\nradius = 3", "1:1: shape2d.center is missing, accepted: [x, y]"},
        Bad{"[[shape2d]]\ntype = \"circle\"\ncenter = [3, 3]\nradius = -1",
            "4:10: shape2d.radius is -1, accepted: 0 to 32767"},
        Bad{"[[shape2d]]\ntype = \"circle\"\ncenter = [3, 3]\nradius = 2.5",
            "4:10: shape2d.radius is 2.5, accepted: whole numbers, since algorithm = \"midpoint\" "
            "works "
            "in whole pixels (antialiasing = \"area\" takes any number)"},
        Bad{"[[shape2d]]\ntype = \"circle\"\ncenter = [3, 3]\nradius = [2, 3]",
            "4:10: shape2d.radius is a list, accepted: a number from 0 to 32767"},
        Bad{"[[shape2d]]\ntype = \"ellipse\"\ncenter = [3, 3]\nradius = 2",
            "4:10: shape2d.radius is 2, accepted: [a, b], the radii across and down, each from 0 to 32767"},
        Bad{"[[shape2d]]\ntype = \"ellipse\"\ncenter = [3, 3]\nradius = [2, -2]",
            "4:14: shape2d.radius[1] is -2, accepted: 0 to 32767"},
        Bad{"[[shape2d]]\ntype = \"circle\"\ncenter = [3, 3]\nradius = 2\npoints = [[1, 1]]",
            "5:10: shape2d.points has no place here: circles and ellipses have center and radius"},
        Bad{"[[shape2d]]\ntype = \"line\"\npoints = [[0, 0], [1, 2]]\nradius = 2",
            "4:10: shape2d.radius is for circles and ellipses"},
        Bad{"[[shape2d]]\ntype = \"line\"\nopacity = 1.5\npoints = [[0, 0], [1, 2]]",
            "3:11: shape2d.opacity is 1.5, accepted: 0 to 1"},
        Bad{"[[shape2d]]\ntype = \"line\"\ncolour = 1",
            "3:1: unknown key shape2d.colour, accepted: type, points, center, radius, algorithm, samples, "
            "width, "
            "antialiasing, filled, inside, color, opacity, even_weight, did you mean 'color'?"}));

INSTANTIATE_TEST_SUITE_P(
    Methods, BadLesson,
    testing::Values(
        Bad{"[[shape2d]]\ntype = \"line\"\nalgorithm = \"bresenham\"",
            "3:13: shape2d.algorithm is \"bresenham\", accepted: midpoint, second-order, textbook, dda, "
            "explicit, "
            "wu, gupta-sproull, scanline, edge-function, active-edges"},
        Bad{"[[shape2d]]\ntype = \"line\"\nalgorithm = \"scanline\"",
            "3:13: shape2d.algorithm is \"scanline\", accepted: midpoint, dda, explicit, wu, gupta-sproull "
            "for "
            "type = \"line\""},
        Bad{"[[shape2d]]\ntype = \"circle\"\nfilled = true\nalgorithm = \"midpoint\"",
            "4:13: shape2d.algorithm is for outlines; filled = true has only one"},
        Bad{"[[shape2d]]\ntype = \"circle\"\nantialiasing = \"weighted\"",
            "3:16: shape2d.antialiasing is \"weighted\", accepted: none, area for type = \"circle\""},
        Bad{"[[shape2d]]\ntype = \"line\"\nalgorithm = \"wu\"\nantialiasing = \"area\"",
            "4:16: shape2d.antialiasing has no place here: this algorithm smooths the line itself"},
        Bad{"[[shape2d]]\ntype = \"line\"\nalgorithm = \"dda\"\nantialiasing = \"area\"",
            "3:13: shape2d.algorithm is for antialiasing = \"none\": a smooth shape has no pixels to choose"},
        Bad{"[[shape2d]]\ntype = \"line\"\nsamples = 4",
            "3:11: shape2d.samples is for antialiasing = \"supersample\" or \"multisample\""},
        Bad{"[[shape2d]]\ntype = \"line\"\nantialiasing = \"multisample\"\nsamples = 17",
            "4:11: shape2d.samples is 17, accepted: a whole number from 1 to 16"},
        Bad{"[[shape2d]]\ntype = \"polygon\"\nwidth = 2", "3:9: shape2d.width is for lines and outlines"},
        Bad{"[[shape2d]]\ntype = \"circle\"\nwidth = 2",
            "3:9: shape2d.width is for antialiasing = \"area\": the outline of whole pixels is one pixel "
            "thin"},
        Bad{"[[shape2d]]\ntype = \"line\"\nalgorithm = \"wu\"\nwidth = 2",
            "4:9: shape2d.width has no place here: the lines of Wu are one pixel wide"},
        Bad{"[[shape2d]]\ntype = \"line\"\nwidth = 0",
            "3:9: shape2d.width is 0, accepted: more than 0, at most 1024 pixels"},
        Bad{"[[shape2d]]\ntype = \"line\"\nwidth = 1e-300",
            "3:9: shape2d.width is 1e-300, accepted: more than 0, at most 1024 pixels"},
        Bad{"[[shape2d]]\ntype = \"line\"\nantialiasing = \"area\"\neven_weight = true",
            "4:15: shape2d.even_weight is for lines that are not smoothed"},
        Bad{"[[shape2d]]\ntype = \"line\"\nwidth = 2\neven_weight = true",
            "4:15: shape2d.even_weight is for lines of width 1: wider ones are areas and need no help"},
        Bad{"[[shape2d]]\ntype = \"line\"\nfilled = true",
            "3:10: shape2d.filled is for circles and ellipses; a polyline draws the outline of an area"},
        Bad{"[[shape2d]]\ntype = \"line\"\ninside = \"even-odd\"\npoints = [[0, 0], [1, 2]]",
            "3:10: shape2d.inside is for polygons"},
        Bad{"[pipeline]\nalgorithm = \"textbook\"\n[[shape2d]]\ntype = \"line\"\npoints = [[0, 0], [7, 3]]",
            "2:13: pipeline.algorithm is \"textbook\", which no shape of this scene takes (a shape's own "
            "keys "
            "come first)"},
        Bad{"[pipeline]\nsamples = 4\n[[shape2d]]\ntype = \"line\"\npoints = [[0, 0], [7, 3]]",
            "2:11: pipeline.samples is 4, which no shape of this scene takes (a shape's own keys come "
            "first)"}));

INSTANTIATE_TEST_SUITE_P(
    Clip, BadLesson,
    testing::Values(
        Bad{"[clip]\n[[shape2d]]",
            "1:1: clip has neither window nor polygon, accepted: either window or polygon"},
        Bad{"[clip]\nwindow = [0, 0, 1, 1]\npolygon = [[0, 0], [1, 0], [0, 1]]\n[[shape2d]]",
            "1:1: clip has both window and polygon, accepted: either window or polygon"},
        Bad{"[clip]\nwindow = [5, 0, 2, 3]\n[[shape2d]]",
            "2:10: clip.window is [5, 0, 2, 3], accepted: [x0, y0, x1, y1] with x0 <= x1 and y0 <= y1"},
        Bad{"[clip]\nwindow = [0, nan, 2, 3]\n[[shape2d]]",
            "2:14: clip.window[1] is nan, accepted: from -32767 to 32767 for x and from -32767 to "
            "32767 "
            "for y"},
        Bad{"[clip]\nwindow = [0, 0, 2, 3]\nlines = \"cohen\"\n[[shape2d]]",
            "3:9: clip.lines is \"cohen\", accepted: cohen-sutherland, cyrus-beck, liang-barsky, midpoint"},
        Bad{"[clip]\nwindow = [0, 0, 2, 3]\norder = [\"top\", \"left\", \"top\", \"right\"]\n[[shape2d]]",
            "3:25: clip.order[2] is \"top\", accepted: top, bottom, right and left, each once, as in "
            "[\"top\", "
            "\"bottom\", \"right\", \"left\"]"},
        Bad{"[clip]\nwindow = [0, 0, 2, 3]\norder = [\"top\"]\n[[shape2d]]",
            "3:9: clip.order is a list of 1, accepted: top, bottom, right and left, each once, as in "
            "[\"top\", "
            "\"bottom\", \"right\", \"left\"]"},
        Bad{"[clip]\npolygon = [[0, 0], [1, 0], [0, 1]]\norder = [\"top\"]\n[[shape2d]]",
            "3:9: clip.order is a list of 1, accepted: top, bottom, right and left, each once, as in "
            "[\"top\", "
            "\"bottom\", \"right\", \"left\"]"},
        Bad{"[clip]\npolygon = [[0, 0], [1, 0]]\n[[shape2d]]",
            "2:11: clip.polygon is a list of 2, accepted: at least three corners [x, y] that do not lie on "
            "one "
            "line"},
        Bad{"[clip]\npolygon = [[0, 0], [8, 4], [0, 8], [2, 4]]\n[[shape2d]]",
            "2:11: clip.polygon is not convex, which polygons = \"sutherland-hodgman\" cannot do; accepted: "
            "a "
            "convex one, or polygons = \"greiner-hormann\""},
        Bad{"[clip]\npolygon = [[0, 0], [9, 9], [9, 0], [0, 9]]\n[[shape2d]]",
            "2:11: clip.polygon is not convex, which polygons = \"sutherland-hodgman\" cannot do; accepted: "
            "a "
            "convex one, or polygons = \"greiner-hormann\""},
        Bad{"[clip]\npolygon = [[0, 0], [4, 4], [9, 9]]\n[[shape2d]]",
            "2:11: clip.polygon has all corners on one line, accepted: at least three corners [x, y] that do "
            "not lie on one "
            "line"},
        Bad{"[clip]\npolygon = [[0, 0], [8, 0], [0, 8]]\nlines = \"liang-barsky\"\n[[shape2d]]",
            "3:9: clip.lines is \"liang-barsky\", accepted: \"cyrus-beck\": the others know upright windows "
            "only"},
        Bad{"[clip]\nwindow = [0, 0, 2, 3]\npolygons = \"greiner-hormann\"\nsplit = true\n[[shape2d]]",
            "4:9: clip.split has no place here: greiner-hormann makes no bridges to be cut"}));

TEST(BadLessons, APentagramIsNoConvexWindow) {  // all its turns go the same way, twice around
    EXPECT_NE(error_of("[clip]\npolygon = [[0, -9], [5, 7], [-9, -3], [9, -3], [-5, 7]]\n" + line)
                  .find("is not convex"),
              std::string::npos);
    EXPECT_EQ(error_of("[clip]\npolygon = [[0, 0], [4, 0], [8, 0], [8, 8], [8, 8], [0, 8]]\n" + line),
              "no error");
}

TEST(BadLessons, GreinerHormannTakesNoOutlineThatMeetsItself) {
    const std::string axes = "[axes]\nextent = [-1, -1, 13, 6]\n[clip]\nwindow = [1, 1, 6, 3]\n";
    const std::string walk = "polygons = \"greiner-hormann\"\n",
                      polygon = "[[shape2d]]\ntype = \"polygon\"\n";
    const std::string bow = "points = [[0, 0], [10, 5], [10, 0], [0, 5]]\n",
                      star = "points = [[0, -9], [5, 7], [-9, -3], [9, -3], [-5, 7]]\n",
                      arrow = "points = [[0, 0], [8, 4], [0, 8], [2, 4]]\n";
    const std::string end =
        "accepted with polygons = \"greiner-hormann\": an outline that does not; \"sutherland-hodgman\" and "
        "\"pipeline\" take any outline in a convex window";
    const std::string meets =
        "lesson.toml:8:10: shape2d.points crosses or touches itself: the edge from points[0] meets the edge "
        "from points[2], ";
    EXPECT_EQ(error_of(axes + walk + polygon + bow), meets + end);
    EXPECT_EQ(error_of(axes + walk + polygon + star), meets + end);
    EXPECT_EQ(error_of(axes + walk + polygon + arrow), "no error");
    EXPECT_EQ(error_of(axes + polygon + bow), "no error");
    EXPECT_EQ(error_of(axes + "polygons = \"pipeline\"\n" + polygon + bow), "no error");
    EXPECT_EQ(error_of(axes + walk + "[[shape2d]]\ntype = \"polyline\"\n" + bow), "no error")
        << "lines are clipped one by one";
    EXPECT_EQ(error_of("[clip]\npolygon = [[0, 0], [10, 5], [10, 0], [0, 6]]\n" + walk + line),
              "lesson.toml:2:11: clip.polygon crosses or touches itself: the edge from polygon[0] meets the "
              "edge from polygon[2], accepted with polygons = \"greiner-hormann\": an outline that does not; "
              "the other clippers take convex windows only");
}

TEST(BadLessons, GreinerHormannTakesSoManyCorners) {
    const auto comb = [](int corners) {
        std::string text =
            "[clip]\nwindow = [1, 1, 6, 3]\npolygons = \"greiner-hormann\"\n[[shape2d]]\n"
            "type = \"polygon\"\npoints = [[0, 9]";
        for (int i = 1; i + 1 < corners; ++i) text += fmt::format(", [{}, {}]", i, i % 2);
        return text + fmt::format(", [{}, 9]]\n", corners);
    };
    EXPECT_EQ(error_of(comb(4096)), "no error");
    EXPECT_EQ(error_of(comb(4097)),
              "lesson.toml:6:10: shape2d.points is a list of 4097, accepted: at most 4096 corners with "
              "polygons = \"greiner-hormann\"; \"sutherland-hodgman\" and \"pipeline\" take any outline in a "
              "convex window");
}

TEST(BadLessons, AWideLineMustLeaveRoomForItsWidth) {
    const std::string far = "[[shape2d]]\ntype = \"line\"\npoints = [[-32767, 0], [0, 0]]\n";
    EXPECT_EQ(error_of(far), "no error");
    EXPECT_EQ(error_of(far + "width = 3\n"),
              "lesson.toml:3:11: shape2d.points[0]: this line is 3 wide, so its corners lie more than 32767 "
              "pixels from the picture's first one");
}

TEST(BadLessons, OptionsAreSaidAsTheyWereWritten) {
    EXPECT_EQ(error_of(line, {{"antialiasing=aera"}, {}}),
              "--set antialiasing=aera: pipeline.antialiasing is \"aera\", accepted: none, area, weighted, "
              "supersample, multisample, did you mean 'area'?");
    EXPECT_EQ(error_of(line, {{"fill_rule"}, {}}),
              "--set fill_rule: accepted: key=value, with a key of [pipeline]: fill_rule, algorithm, "
              "antialiasing, samples");
    EXPECT_EQ(error_of(line, {{"antialiasing=supersample", "samples=x"}, {}}),
              "--set samples=x: pipeline.samples is \"x\", accepted: a whole number from 1 to 16");
}

TEST(BadLessons, AnyDamageIsAnErrorInOneLineOrAScene) {
    const std::string whole =
        "[axes]\nextent = [0, 0, 9, 9]\n[clip]\nwindow = [1, 2, 3, 4]\n[[shape2d]]\ntype = \"circle\"\n"
        "center = [4, 4]\nradius = 3\nopacity = 0.5\n[[shape2d]]\ntype = \"polygon\"\n"
        "points = [[0, 0], [1, 2], [3, 4]]\n";
    for (std::size_t cut = 0; cut < whole.size(); ++cut)
        for (const char* with : {"", "\"", "[", "\xff", "= ", "nan", "\n\n", "{", "-", "9e9"}) {
            std::string text = whole;
            text.replace(cut, 1, with);
            const std::string error = error_of(text);
            EXPECT_EQ(error.find('\n'), std::string::npos) << text;
            EXPECT_EQ(error == "no error" || error.starts_with("lesson.toml"), true) << error;
        }
}

}  // namespace
}  // namespace relevo::scene
