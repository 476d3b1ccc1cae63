#include "raster/ellipse_textbook.hpp"

#include "tests/raster/curve_pixels.hpp"

namespace relevo::tests {
namespace {

Pixels textbook(int a, int b) {
    return gather([&](auto plot) { raster::ellipse_textbook({0, 0}, a, b, everywhere, plot); });
}

TEST(EllipseTextbook, AFlatOneHasNoTip) {
    EXPECT_TRUE(same_drawing(drawing_of(textbook(10, 1), {-10, -1, 10, 1}), {"..#################..",  //
                                                                             ".#.................#.",  //
                                                                             "..#################.."}));
    struct Probe {
        int x = 0;
        void on(const raster::EllipseStopped& e) { x = e.x; }
    } probe;
    raster::ellipse_textbook(
        {0, 0}, 100, 1, everywhere, [](int, int) {}, probe);
    EXPECT_EQ(probe.x, 87);
}

TEST(EllipseTextbook, AtEqualPartsOfTheGradientRegion2Begins) {
    struct Probe {
        int x = -1, y = -1;
        void on(const raster::EllipseTurned& e) { x = e.x, y = e.y; }
    } probe;  // at (1, 1) both are 4
    raster::ellipse_textbook(
        {0, 0}, 2, 1, everywhere, [](int, int) {}, probe);
    EXPECT_EQ(probe.x, 1);
    EXPECT_EQ(probe.y, 1);
}

// Of the 128 x 128 ellipses: how many are open, how many others miss a nearest pixel.
TEST(EllipseTextbook, HowOftenItFails) {
    int open = 0, other = 0, twins = 0;
    for (int a = 1; a <= 128; ++a)
        for (int b = 1; b <= 128; ++b) {
            const Pixels printed = textbook(a, b);
            const Pixels right = gather([&](auto plot) {
                raster::ellipse_midpoint({0, 0}, a, b, everywhere, plot);
            });
            twins += has_twins(printed);
            const bool is_open = printed.back().x < a;
            open += is_open;
            other += !is_open && printed != right;
        }
    EXPECT_EQ(twins, 0);
    EXPECT_EQ(open, 319);
    EXPECT_EQ(other, 176);
}

TEST(EllipseTextbook, BoxesAndLimits) {
    const PixelBox box{-3, -8, 9, 2};
    EXPECT_EQ(gather([&](auto plot) {
                  raster::ellipse_textbook({0, 0}, 12, 7, box, plot);
              }),
              inside(textbook(12, 7), box));
    const auto nothing = [](int, int) { FAIL(); };
    EXPECT_TRUE(raster::ellipse_textbook({0, 0}, -1, 7, box, nothing));
    EXPECT_FALSE(raster::ellipse_textbook({0, 0}, (1 << 20) + 1, 7, box, nothing));
    EXPECT_EQ(textbook(0, 0), Pixels({{0, 0}}));
    EXPECT_EQ(textbook(5, 0), Pixels({{0, 0}}));  // the row is missing: all tip
}

}  // namespace
}  // namespace relevo::tests
