// The machine of the lessons: every kind of shape by every algorithm, the window, the order of painting.
#include "raster/draw_shapes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/drawing.hpp"

namespace relevo::raster {
namespace {

using tests::Drawing;
using tests::same_drawing;

Shape shape_of(ShapeKind kind, std::vector<glm::vec2> points,
               ScanAlgorithm algorithm = ScanAlgorithm::Midpoint) {
    Shape shape;
    shape.kind = kind;
    shape.points = std::move(points);
    shape.algorithm = algorithm;
    return shape;
}
Shape smooth(Shape shape, Antialiasing antialiasing = Antialiasing::Area) {
    shape.antialiasing = antialiasing;
    return shape;
}

struct Everything {
    std::size_t events = 0;
    void on(const auto&) { ++events; }
};

// White shapes on black; watched and unwatched are the same.
Image<LinearRgb> drawn(const ShapeScene& scene, int width, int height) {
    Image<LinearRgb> picture(width, height), watched(width, height);
    draw_shapes(scene, picture);
    Everything everything;
    draw_shapes(scene, watched, everything);
    EXPECT_EQ(picture.pixels(), watched.pixels());
    EXPECT_GE(everything.events, scene.shapes.size());
    return picture;
}
// '.' nothing, '#' the whole colour, digits tenths of it.
Drawing drawing(const ShapeScene& scene, int width, int height) {
    return tests::drawing_of(drawn(scene, width, height), [](const LinearRgb& c) {
        return c.r == 0 ? '.' : c.r == 1 ? '#' : static_cast<char>('0' + static_cast<int>(c.r * 10));
    });
}
Drawing drawing(const Shape& shape, int width, int height, const ShapeClip& clip = {},
                FillRule rule = FillRule::TopLeft) {
    return drawing(ShapeScene{{shape}, clip, rule, {0, 0, 0}}, width, height);
}
ShapeClip window(glm::vec2 low, glm::vec2 high) {
    ShapeClip clip;
    clip.on = true, clip.low = low, clip.high = high;
    return clip;
}
ShapeClip window(std::vector<glm::vec2> polygon,
                 PolygonClipper polygons = PolygonClipper::SutherlandHodgman) {
    ShapeClip clip;
    clip.on = true, clip.polygon = std::move(polygon), clip.polygons = polygons;
    return clip;
}

// ------------------------------------------------------------------------------------------------- lines

TEST(Lines, OfWholePixelsByThreeAlgorithms) {
    const Drawing right{"##......", "..##....", "....##..", "......##"};
    for (const ScanAlgorithm algorithm :
         {ScanAlgorithm::Midpoint, ScanAlgorithm::Dda, ScanAlgorithm::Explicit}) {
        const Shape line = shape_of(ShapeKind::Line, {{0, 0}, {7, 3}}, algorithm);
        EXPECT_TRUE(same_drawing(drawing(line, 8, 4), right)) << int(algorithm);
    }
}

TEST(Lines, TheExplicitFormHasGapsWhereItIsSteep) {
    const auto steep = [](ScanAlgorithm algorithm) {
        return drawing(shape_of(ShapeKind::Line, {{0, 0}, {2, 4}}, algorithm), 3, 5);
    };
    EXPECT_TRUE(same_drawing(steep(ScanAlgorithm::Explicit), {"#..", "...", ".#.", "...", "..#"}));
    EXPECT_TRUE(same_drawing(steep(ScanAlgorithm::Midpoint), {"#..", "#..", ".#.", ".#.", "..#"}));
}

TEST(Lines, AreCutToThePixelsOfTheUncutLine) {
    const Shape line = shape_of(ShapeKind::Line, {{-3, -2}, {11, 5}});
    const Drawing uncut = drawing(line, 9, 4);
    const Drawing cut = drawing(line, 9, 4, window(glm::vec2(2, 1), glm::vec2(6.5, 3)));
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 9; ++x)
            EXPECT_EQ(cut[y][x], 2 <= x && x <= 6 && 1 <= y ? uncut[y][x] : '.') << x << ' ' << y;
}

TEST(Lines, ThePolygonOfAWindowOwnsItsBorder) {
    const Shape row = shape_of(ShapeKind::Line, {{0, 2}, {8, 2}});
    EXPECT_TRUE(same_drawing(drawing(row, 9, 5, window({{4, 0}, {6, 2}, {4, 4}, {2, 2}})),
                             {".........", ".........", "..#####..", ".........", "........."}));
    const Shape edge = shape_of(ShapeKind::Line, {{0, 4}, {8, 4}});
    EXPECT_TRUE(same_drawing(drawing(edge, 9, 5, window({{1, 0}, {5, 4}, {1, 4}})),
                             {".........", ".........", ".........", ".........", ".#####..."}));
}

TEST(Lines, EvenWeightDimsThoseAlongTheAxes) {
    Shape line = shape_of(ShapeKind::Line, {{0, 0}, {3, 0}});
    line.even_weight = true;
    EXPECT_TRUE(same_drawing(drawing(line, 4, 1), {"7777"}));
    line.points = {{0, 0}, {3, 3}};
    EXPECT_TRUE(same_drawing(drawing(line, 4, 4), {"#...", ".#..", "..#.", "...#"}));
}

TEST(Lines, AreAreasWhenTheyAreSmoothOrWide) {
    const Shape line = shape_of(ShapeKind::Line, {{1, 1}, {4, 1}});
    EXPECT_TRUE(same_drawing(drawing(smooth(line), 6, 3), {"......", ".5##5.", "......"}));
    Shape wide = line;
    wide.width = 3;
    EXPECT_TRUE(same_drawing(drawing(wide, 6, 3), {".###..", ".###..", ".###.."}));
}

TEST(Polylines, OfManyLinesNeedNoMoreThanThePicture) {
    std::vector<glm::vec2> points;
    for (int i = 0; i < 6000; ++i) points.push_back({i % 2 == 0 ? 0 : 499, i % 40});
    Shape zigzag = shape_of(ShapeKind::Polyline, points);
    zigzag.opacity = 0.5f;
    const Image<LinearRgb> picture = drawn(ShapeScene{{zigzag}, {}, {}, {0, 0, 0}}, 500, 40);
    for (const LinearRgb& c : picture.pixels()) EXPECT_TRUE(c.r == 0 || c.r == 0.5f);
    EXPECT_EQ(picture.at(0, 0).r, 0.5f);
}

TEST(Polylines, PaintEachPixelOnce) {
    Shape corner = shape_of(ShapeKind::Polyline, {{0, 2}, {2, 2}, {2, 0}, {2, 2}});
    corner.opacity = 0.5f;
    EXPECT_TRUE(same_drawing(drawing(corner, 3, 3), {"..5", "..5", "555"}));
    EXPECT_TRUE(same_drawing(drawing(smooth(corner), 3, 3), {"..5", "..5", "255"}));
    corner.algorithm = ScanAlgorithm::Wu;
    EXPECT_TRUE(same_drawing(drawing(corner, 3, 3), {"..5", "..5", "255"}));
}

// -------------------------------------------------------------------------------------------------- curves

TEST(Curves, ByEachAlgorithm) {
    const Drawing circle{".###.", "#...#", "#...#", "#...#", ".###."};
    for (const ScanAlgorithm algorithm : {ScanAlgorithm::Midpoint, ScanAlgorithm::SecondOrder}) {
        Shape shape = shape_of(ShapeKind::Circle, {{2, 2}}, algorithm);
        shape.radius_x = shape.radius_y = 2;
        EXPECT_TRUE(same_drawing(drawing(shape, 5, 5), circle));
        shape.kind = ShapeKind::Ellipse;
        EXPECT_TRUE(same_drawing(drawing(shape, 5, 5), circle));
    }
    Shape flat = shape_of(ShapeKind::Ellipse, {{20, 1}}, ScanAlgorithm::Midpoint);
    flat.radius_x = 20, flat.radius_y = 1;
    const Drawing cured = drawing(flat, 41, 3);
    flat.algorithm = ScanAlgorithm::Textbook;
    EXPECT_NE(drawing(flat, 41, 3), cured);
    EXPECT_EQ(cured[1].front(), '#');
}

TEST(Curves, AreCutPixelByPixel) {
    Shape disc_shape = shape_of(ShapeKind::Circle, {{2, 2}});
    disc_shape.radius_x = disc_shape.radius_y = 2;
    disc_shape.filled = true;
    EXPECT_TRUE(same_drawing(drawing(disc_shape, 5, 5), {".###.", "#####", "#####", "#####", ".###."}));
    EXPECT_TRUE(same_drawing(drawing(disc_shape, 5, 5, window(glm::vec2(1, 0), glm::vec2(2, 9))),
                             {".##..", ".##..", ".##..", ".##..", ".##.."}));
    EXPECT_TRUE(same_drawing(drawing(disc_shape, 5, 5, window({{0, 0}, {4, 4}, {0, 4}})),
                             {".....", "##...", "###..", "####.", ".###."}));
}

// --------------------------------------------------------------------------------------------------- areas

TEST(Areas, HaveTheSamePixelsByEveryAlgorithm) {
    const std::vector<glm::vec2> corners[] = {
        {{0, 0}, {7, 2}, {2, 5}}, {{1.25f, 0.5f}, {1, 5}, {6.5f, 3}}, {{-4, -3}, {9, 2}, {2, 40}}};
    for (const auto& points : corners)
        for (const FillRule rule : {FillRule::TopLeft, FillRule::Book}) {
            const auto by = [&](ScanAlgorithm algorithm) {
                return drawing(shape_of(ShapeKind::Triangle, points, algorithm), 8, 6, {}, rule);
            };
            EXPECT_TRUE(same_drawing(by(ScanAlgorithm::EdgeFunction), by(ScanAlgorithm::Scanline)));
            EXPECT_TRUE(same_drawing(by(ScanAlgorithm::ActiveEdges), by(ScanAlgorithm::Scanline)));
        }
}

TEST(Areas, TheBookOwnsTheBottomRow) {
    for (const ScanAlgorithm algorithm : {ScanAlgorithm::Scanline, ScanAlgorithm::ActiveEdges}) {
        const Shape box = shape_of(ShapeKind::Rectangle, {{4, 3}, {1, 1}}, algorithm);
        EXPECT_TRUE(same_drawing(drawing(box, 6, 5), {"......", ".###..", ".###..", "......", "......"}));
        EXPECT_TRUE(same_drawing(drawing(box, 6, 5, {}, FillRule::Book),
                                 {"......", "......", ".###..", ".###..", "......"}));
    }
}

TEST(Areas, ThePentagramByBothRules) {
    Shape star =
        shape_of(ShapeKind::Polygon, {{5, -1}, {8, 9}, {-1, 3}, {11, 3}, {2, 9}}, ScanAlgorithm::ActiveEdges);
    const Drawing whole = drawing(star, 11, 10);
    star.inside = InsideRule::EvenOdd;
    const Drawing hollow = drawing(star, 11, 10);
    EXPECT_EQ(whole[5][5], '#');
    EXPECT_EQ(hollow[5][5], '.');
    EXPECT_EQ(hollow[0], whole[0]);
    EXPECT_EQ(hollow[9], whole[9]);
}

TEST(Areas, SmoothOnesAreTheCoveredPart) {
    const Shape half = shape_of(ShapeKind::Rectangle, {{0, 0}, {2, 2}});
    EXPECT_TRUE(same_drawing(drawing(smooth(half), 4, 4), {"252.", "5#5.", "252.", "...."}));
}

// ------------------------------------------------------------------------------------------------- windows

const std::vector<glm::vec2> fork{{1, 0}, {9, 0}, {9, 6}, {1, 6},
                                  {1, 5}, {7, 5}, {7, 1}, {1, 1}};  // a bracket: ]

TEST(Windows, CutAreasByEveryClipper) {
    const Shape bracket = shape_of(ShapeKind::Polygon, fork, ScanAlgorithm::ActiveEdges);
    const Drawing uncut = drawing(bracket, 11, 7);
    for (const PolygonClipper clipper :
         {PolygonClipper::SutherlandHodgman, PolygonClipper::SutherlandHodgmanPipeline,
          PolygonClipper::GreinerHormann})
        for (const bool split : {false, true}) {
            ShapeClip clip = window(glm::vec2(3, 0), glm::vec2(6, 9));
            clip.polygons = clipper, clip.split = split;
            const Drawing cut = drawing(bracket, 11, 7, clip);
            for (int y = 0; y < 7; ++y)  // the right side is open, as that of every area
                for (int x = 0; x < 11; ++x)
                    EXPECT_EQ(cut[y][x], 3 <= x && x < 6 ? uncut[y][x] : '.') << x << y;
        }
}

TEST(Windows, OfAnyConvexFormCutAllAreasAndSmoothLines) {
    const Shape box = shape_of(ShapeKind::Rectangle, {{0, 0}, {8, 8}}, ScanAlgorithm::Scanline);
    const ShapeClip diamond = window({{4, 0}, {8, 4}, {4, 8}, {0, 4}});
    const Drawing right =
        drawing(shape_of(ShapeKind::Polygon, diamond.polygon, ScanAlgorithm::ActiveEdges), 9, 9);
    EXPECT_TRUE(same_drawing(drawing(box, 9, 9, diamond), right));
    EXPECT_TRUE(same_drawing(drawing(smooth(box), 9, 9, diamond),
                             drawing(smooth(shape_of(ShapeKind::Polygon, diamond.polygon)), 9, 9)));
    const Shape line = smooth(shape_of(ShapeKind::Line, {{-20, 4}, {20, 4}}));
    EXPECT_EQ(drawing(line, 9, 9, diamond)[4], "2#######2");
}

TEST(Windows, WithADentAreForGreinerAndHormann) {
    const std::vector<glm::vec2> arrow{{0, 0}, {8, 0}, {8, 8}, {4, 2}, {0, 8}};
    const Shape all = shape_of(ShapeKind::Rectangle, {{-1, -1}, {20, 20}}, ScanAlgorithm::Scanline);
    EXPECT_TRUE(same_drawing(drawing(all, 9, 9, window(arrow, PolygonClipper::GreinerHormann)),
                             drawing(shape_of(ShapeKind::Polygon, arrow, ScanAlgorithm::ActiveEdges), 9, 9)));
    EXPECT_TRUE(same_drawing(drawing(all, 2, 1, window(arrow)), {".."}));  // no window: nothing is left
}

TEST(Windows, ThatAreNoneLeaveNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const ShapeClip& clip :
         {window(glm::vec2(3, 0), glm::vec2(2, 9)), window(glm::vec2(nan, 0), glm::vec2(2, 9)),
          window(std::vector<glm::vec2>{{0, 0}, {nan, 0}, {0, 9}}),
          window(std::vector<glm::vec2>{{0, 0}, {9, 9}})})
        for (const Shape& shape :
             {shape_of(ShapeKind::Line, {{0, 0}, {3, 3}}), shape_of(ShapeKind::Rectangle, {{0, 0}, {4, 4}}),
              smooth(shape_of(ShapeKind::Rectangle, {{0, 0}, {4, 4}}))})
            EXPECT_TRUE(same_drawing(drawing(shape, 4, 1, clip), {"...."}));
    const Shape line = shape_of(ShapeKind::Line, {{0, 0}, {3, 0}});
    EXPECT_TRUE(same_drawing(drawing(line, 4, 1, window(glm::vec2(-3e38f), glm::vec2(3e38f))), {"####"}));
}

// --------------------------------------------------------------------------------------------------- samples

TEST(Samples, SharedOnesLeaveNoSeam) {
    const auto pair = [](Antialiasing way) {
        return ShapeScene{{smooth(shape_of(ShapeKind::Triangle, {{0, 0}, {4, 0}, {0, 4}}), way),
                           smooth(shape_of(ShapeKind::Triangle, {{4, 0}, {4, 4}, {0, 4}}), way)},
                          {},
                          {},
                          {0, 0, 0}};
    };
    const auto inner = [&](Antialiasing way) { return drawing(pair(way), 5, 5)[2].substr(1, 3); };
    EXPECT_EQ(inner(Antialiasing::Area), "#7#");
    EXPECT_EQ(inner(Antialiasing::Supersample).at(1), '7');
    EXPECT_EQ(inner(Antialiasing::Multisample), "###");
}

TEST(Samples, AreSharedByNeighboursOfTheListOnly) {
    Shape left = smooth(shape_of(ShapeKind::Rectangle, {{0, 0}, {1, 1}}), Antialiasing::Multisample),
          right = left;
    right.points = {{1, 0}, {2, 1}};
    Shape between = shape_of(ShapeKind::Line, {{0, 5}, {1, 5}});
    const auto middle = [](std::vector<Shape> shapes) {
        return drawn(ShapeScene{std::move(shapes), {}, {}, {0, 0, 0}}, 3, 2).at(1, 0).r;
    };
    EXPECT_EQ(middle({left, right}), 0.5f);              // half a row high, and no seam
    EXPECT_EQ(middle({left, between, right}), 0.4375f);  // a quarter, and a quarter of what is left
    right.samples = 2;
    EXPECT_EQ(middle({left, right}), 0.4375f);
}

// --------------------------------------------------------------------------------------------------
// smoothing

TEST(Smoothing, EveryWayKnowsFullAndEmptyPixels) {
    for (const Antialiasing way :
         {Antialiasing::Area, Antialiasing::Weighted, Antialiasing::Supersample, Antialiasing::Multisample}) {
        const Drawing picture = drawing(smooth(shape_of(ShapeKind::Rectangle, {{2, 2}, {6, 6}}), way), 9, 9);
        EXPECT_EQ(picture[4][4], '#') << int(way);
        EXPECT_EQ(picture[4][8], '.') << int(way);
        EXPECT_EQ(picture[0], ".........") << int(way);
        EXPECT_NE(picture[4][2], '#') << int(way);
        EXPECT_NE(picture[4][2], '.') << int(way);
    }
}

TEST(Smoothing, DiscsAndRingsByArea) {
    Shape disc_shape = smooth(shape_of(ShapeKind::Circle, {{3.5f, 3.5f}}));
    disc_shape.radius_x = disc_shape.radius_y = 3;
    disc_shape.filled = true;
    const auto light = [](const Shape& shape) {
        const Image<LinearRgb> picture = drawn(ShapeScene{{shape}, {}, {}, {0, 0, 0}}, 8, 8);
        double sum = 0;
        for (const LinearRgb& c : picture.pixels()) sum += c.r;
        return sum;
    };
    EXPECT_NEAR(light(disc_shape), 28.274, 0.01);  // 9 pi
    disc_shape.filled = false;
    EXPECT_NEAR(light(disc_shape), 18.85, 0.01);  // (3.5^2 - 2.5^2) pi
}

TEST(Smoothing, ByAConeIsWiderThanTheLine) {
    const Shape line = shape_of(ShapeKind::Line, {{-9, 2}, {9, 2}}, ScanAlgorithm::GuptaSproull);
    const Drawing picture = drawing(line, 1, 5);
    EXPECT_EQ(picture[0] + picture[4], "..");
    EXPECT_NE(picture[1], ".");
    EXPECT_EQ(picture[1], picture[3]);
    EXPECT_GT(picture[2], picture[1]);
}

// -------------------------------------------------------------------------------------------------- the rest

TEST(Machine, LaterShapesLieOnTop) {
    Shape below = shape_of(ShapeKind::Rectangle, {{0, 0}, {4, 1}}), above = below;
    above.points = {{2, 0}, {4, 1}};
    above.color = {0.5f, 0.5f, 0.5f};
    EXPECT_TRUE(same_drawing(drawing(ShapeScene{{below, above}, {}, {}, {0, 0, 0}}, 4, 1), {"##55"}));
    EXPECT_TRUE(same_drawing(drawing(ShapeScene{{above, below}, {}, {}, {0, 0, 0}}, 4, 1), {"####"}));
    below.opacity = 0.5f;
    EXPECT_TRUE(same_drawing(drawing(ShapeScene{{below, below}, {}, {}, {0, 0, 0}}, 4, 1), {"7777"}));
}

TEST(Machine, NothingIsDrawnWithoutShapes) {
    EXPECT_TRUE(same_drawing(drawing(ShapeScene{{}, {}, {}, {0, 0, 0}}, 3, 1), {"..."}));
    EXPECT_TRUE(same_drawing(drawing(ShapeScene{{}, {}, {}, {1, 1, 1}}, 3, 1), {"###"}));
}

struct Refusals {
    int refused = 0, painted = 0;
    void on(const ShapeRefused&) { ++refused; }
    void on(const SpanPainted&) { ++painted; }
};

TEST(Machine, LeavesOutWhatIsNotFiniteOrTooFar) {
    const float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                         -3e38f, 32768};
    const auto refused = [](const Shape& shape) {
        Image<LinearRgb> picture(4, 4);
        Refusals refusals;
        draw_shapes(ShapeScene{{shape}, {}, {}, {0, 0, 0}}, picture, refusals);
        return refusals.refused == 1 && refusals.painted == 0;
    };
    for (const float number : bad)
        for (const ShapeKind kind :
             {ShapeKind::Line, ShapeKind::Polyline, ShapeKind::Circle, ShapeKind::Ellipse,
              ShapeKind::Rectangle, ShapeKind::Triangle, ShapeKind::Polygon}) {
            Shape shape = shape_of(kind, {{1, 1}, {2, 2}, {1, 3}});
            shape.radius_x = shape.radius_y = 1;
            EXPECT_FALSE(refused(shape));
            shape.points[0].y = number;
            EXPECT_TRUE(refused(shape)) << number << ' ' << int(kind);
            shape.points[0].y = 1, shape.radius_y = number;
            EXPECT_TRUE(refused(shape)) << number << ' ' << int(kind);
        }
    EXPECT_TRUE(refused(shape_of(ShapeKind::Polygon, {{0, 0}, {1, 1}})));
    EXPECT_TRUE(refused(shape_of(ShapeKind::Line, {})));
    EXPECT_TRUE(refused(smooth(shape_of(ShapeKind::Line, {{-32767, 0}, {0, 0}}))));  // half a pixel too wide
    EXPECT_FALSE(refused(shape_of(ShapeKind::Line, {{-32767, 0}, {0, 0}})));
}

TEST(Machine, ShapesThatReachFarAwayAreDrawn) {
    const float far = largest_place;
    const Shape all = shape_of(ShapeKind::Rectangle, {{-far, -far}, {far, far}});
    EXPECT_TRUE(same_drawing(drawing(all, 3, 2), {"###", "###"}));
    EXPECT_TRUE(same_drawing(drawing(smooth(all), 3, 2), {"###", "###"}));
    EXPECT_TRUE(
        same_drawing(drawing(shape_of(ShapeKind::Line, {{-far, -far}, {far, far}}), 3, 2), {"#..", ".#."}));
}

TEST(Machine, TheWatcherHearsEveryPixelThatChanges) {
    struct Painted {
        Image<int> coverage{6, 6};
        void on(const SpanPainted& e) {
            for (int x = e.x0; x < e.x1; ++x) coverage.at(x, e.y) += e.coverage;
        }
    } painted;
    const ShapeScene scene{
        {smooth(shape_of(ShapeKind::Triangle, {{0, 0}, {5, 1}, {2, 5}}))}, {}, {}, {0, 0, 0}};
    Image<LinearRgb> picture(6, 6);
    draw_shapes(scene, picture, painted);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 6; ++x)
            EXPECT_EQ(picture.at(x, y).g, float(painted.coverage.at(x, y)) / full_coverage);
}

TEST(Machine, EncodesEveryPixel) {
    Image<LinearRgb> picture(2, 1);
    picture.at(1, 0) = {1, 0.5f, 0};
    EXPECT_EQ(encoded(picture, Output::Raw).at(1, 0), (Rgba8{255, 128, 0, 255}));
    EXPECT_EQ(encoded(picture, Output::Srgb).at(1, 0), (Rgba8{255, 188, 0, 255}));
}

}  // namespace
}  // namespace relevo::raster
