// Drawing: nothing leaves the clip rectangle, whatever the numbers; what is drawn is where it should be.
#include "samples/show/canvas.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace relevo::show {
namespace {

constexpr Rgba8 black{0, 0, 0}, white{255, 255, 255};

// '#' where the picture is darker than middle grey.
std::string drawing(const Picture& picture) {
    std::string out;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) out += picture.at(x, y).r < 128 ? '#' : '.';
        out += '\n';
    }
    return out;
}

TEST(Canvas, FillsFramesAndCutsAtItsBorders) {
    Picture picture(8, 4, white);
    fill(canvas_of(picture), {-3, 1, 5, 2}, black);
    frame(canvas_of(picture), {4, -1, 6, 4}, black);
    EXPECT_EQ(drawing(picture),
              "....#...\n"
              "##..#...\n"
              "##..####\n"
              "........\n");
}

TEST(Canvas, LinesGoFromCentreToCentre) {
    Picture picture(6, 5, white);
    line(canvas_of(picture), {0.5, 0.5}, {4.5, 4.5}, {black, 1});
    EXPECT_EQ(drawing(picture),
              "#.....\n"
              ".#....\n"
              "..#...\n"
              "...#..\n"
              "....#.\n");
    Picture flat(6, 3, white);
    line(canvas_of(flat), {1.5, 1.5}, {4.5, 1.5}, {black, 1});
    EXPECT_EQ(drawing(flat),
              "......\n"
              ".####.\n"
              "......\n");
}

TEST(Canvas, ALineIsTheSameFromBothEnds) {
    Picture there(40, 30, white), back(40, 30, white);
    line(canvas_of(there), {3.2, 4.7}, {36.1, 21.4}, {blue, 2.5});
    line(canvas_of(back), {36.1, 21.4}, {3.2, 4.7}, {blue, 2.5});
    int different = 0;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) different += std::abs(there.at(x, y).r - back.at(x, y).r) > 1;
    EXPECT_EQ(different, 0);
}

TEST(Canvas, PolygonsCoverTheirInside) {
    Picture picture(8, 6, white);
    const std::array<Spot, 4> corners{{{1, 1}, {7, 1}, {7, 5}, {1, 5}}};
    polygon(canvas_of(picture), corners, black);
    EXPECT_EQ(drawing(picture),
              "........\n"
              ".######.\n"
              ".######.\n"
              ".######.\n"
              ".######.\n"
              "........\n");
    Picture half(3, 1, white);
    const std::array<Spot, 4> bar{{{0.5, 0}, {1.5, 0}, {1.5, 1}, {0.5, 1}}};
    polygon(canvas_of(half), bar, black);
    EXPECT_NEAR(half.at(0, 0).r, 127, 1);
    EXPECT_NEAR(half.at(1, 0).r, 127, 1);
    EXPECT_EQ(half.at(2, 0), white);
}

TEST(Canvas, NothingLeavesTheClipRectangle) {
    constexpr double huge = 1e300, infinite = std::numeric_limits<double>::infinity();
    const double odd[] = {-huge, -1e9, -20, -0.5, 0,        3.25,      9.999,
                          10,    25,   1e9, huge, infinite, -infinite, std::nan("")};
    Picture picture(20, 20, white);
    const Canvas canvas = within(canvas_of(picture), {5, 6, 7, 8});
    for (const double a : odd)
        for (const double b : odd) {
            line(canvas, {a, b}, {b, 7}, {black, 3});
            line(canvas, {a, 9}, {9, b}, {black, 0.5, 2});
            arrow(canvas, {a, b}, {10, 10}, {black, 2});
            disc(canvas, {a, b}, 4, black);
            ring(canvas, {a, b}, 30, {black, 2});
            const std::array<Spot, 3> corners{{{a, b}, {b, a}, {12, 3}}};
            polygon(canvas, corners, black);
            path(canvas, corners, {black, 1}, true);
        }
    for (const int at : {-1000, -3, 4, 19, 1000}) {
        text(canvas, at, at, "Wg|°", black, 3);
        fill(canvas, {at, at, 2000, 3}, black);
        paste(canvas, Picture(3, 3, black), at, at, 5);
    }
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x)
            if (x < 5 || x >= 12 || y < 6 || y >= 14) {
                EXPECT_EQ(picture.at(x, y), white) << x << ", " << y;
            }
    EXPECT_NE(picture.at(8, 9), white);
}

TEST(Canvas, AnEmptyClipRectangleTakesNothing) {
    Picture picture(4, 4, white);
    const Canvas nowhere = within(canvas_of(picture), {9, 9, 5, 5});
    fill(nowhere, {0, 0, 20, 20}, black);
    line(nowhere, {0, 0}, {20, 20}, {black, 9});
    const std::array<Spot, 3> corners{{{0, 0}, {20, 0}, {0, 20}}};
    polygon(nowhere, corners, black);
    disc(nowhere, {9, 9}, 9, black);
    text(nowhere, 0, 0, "text", black);
    EXPECT_EQ(drawing(picture), "....\n....\n....\n....\n");
}

TEST(Canvas, BlendsByOpacity) {
    Picture picture(1, 1, white);
    blend(picture, 0, 0, {0, 0, 0, 51});
    EXPECT_EQ(picture.at(0, 0), (Rgba8{204, 204, 204}));
    blend(picture, 0, 0, {0, 0, 0, 255}, 0);
    EXPECT_EQ(picture.at(0, 0), (Rgba8{204, 204, 204}));
}

TEST(Text, DrawsTheDotsOfTheFont) {
    Picture picture(6, 8, white);
    text(canvas_of(picture), 0, 0, "E", black, 1);
    EXPECT_EQ(drawing(picture),
              "#####.\n"
              "#.....\n"
              "#.....\n"
              "####..\n"
              "#.....\n"
              "#.....\n"
              "#####.\n"
              "......\n");
}

TEST(Text, CountsLettersNotBytes) {
    EXPECT_EQ(letters("a ≤ b"), 5);
    EXPECT_EQ(letters(""), 0);
    EXPECT_EQ(letters("\xff\xfe\xc3"), 3) << "damaged UTF-8: a letter a byte";
    EXPECT_EQ(text_width("abc", 2), 34);
    EXPECT_EQ(text_width("", 2), 0);
}

TEST(Text, IsCutWithAnEllipsis) {
    EXPECT_EQ(shortened("teapot", 6), "teapot");
    EXPECT_EQ(shortened("a long name", 8), "a lon...");
    EXPECT_EQ(shortened("°°°°°°", 5), "°°...");
    EXPECT_EQ(shortened("teapot", 2), "..");
    EXPECT_EQ(shortened("teapot", 0), "");
    EXPECT_EQ(shortened("teapot", -3), "");
}

}  // namespace
}  // namespace relevo::show
