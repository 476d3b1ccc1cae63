#include "raster/clip_circle.hpp"

#include <random>

#include "raster/circle_second_order.hpp"
#include "raster/ellipse_second_order.hpp"
#include "tests/raster/curve_pixels.hpp"

namespace relevo::tests {
namespace {

using raster::CirclePart;

TEST(LastThat, FindsTheLastOrTheNumberBeforeTheFirst) {
    for (int end = -5; end <= 6; ++end)
        EXPECT_EQ(raster::last_that(-4, 5, [&](std::int64_t x) { return x < end; }),
                  std::clamp(end - 1, -5, 5));
    EXPECT_EQ(raster::last_that(3, 2, [](std::int64_t) { return true; }), 2);
}

// Every box whose corners lie near a small circle: cutting is drawing and discarding.
TEST(ClipCircle, EveryBoxGivesThePixelsInsideOnce) {
    for (int r = 0; r <= 7; ++r) {
        const Pixels all = gather([&](auto plot) { raster::circle_midpoint({1, -1}, r, everywhere, plot); });
        const int low = -9, high = 9;
        for (int x0 = low; x0 <= high; ++x0)
            for (int x1 = x0; x1 <= high; ++x1)
                for (int y0 = low; y0 <= high; ++y0)
                    for (int y1 = y0; y1 <= high; ++y1) {
                        const PixelBox box{x0, y0, x1, y1};
                        ASSERT_EQ(gather([&](auto plot) {
                                      raster::circle_midpoint({1, -1}, r, box, plot);
                                  }),
                                  inside(all, box))
                            << r << ": " << x0 << ' ' << y0 << ' ' << x1 << ' ' << y1;
                    }
    }
}

TEST(ClipCircle, RandomBoxesOfLargerCirclesAndEllipses) {
    std::mt19937 bits(1);
    const auto number = [&](int low, int high) { return low + int(bits() % unsigned(high - low + 1)); };
    int cut = 0;
    for (int i = 0; i < 20000; ++i) {
        const int a = number(0, 40), b = i % 3 == 0 ? a : number(0, 40);
        const Pixel center{number(-5, 5), number(-5, 5)};
        PixelBox box{number(-50, 45), number(-50, 45), 0, 0};
        box.x1 = box.x0 + number(0, 50), box.y1 = box.y0 + number(0, 50);
        if (i % 7 == 0) box.x0 = box.x1 = center.x;  // along the axes
        if (i % 7 == 1) box.y0 = box.y1 = center.y;
        const Pixels all =
            gather([&](auto plot) { raster::ellipse_midpoint(center, a, b, everywhere, plot); });
        const Pixels right = inside(all, box);
        cut += !right.empty() && right.size() < all.size();
        ASSERT_EQ(gather([&](auto plot) { raster::ellipse_midpoint(center, a, b, box, plot); }), right)
            << a << ' ' << b << ": " << box.x0 << ' ' << box.y0 << ' ' << box.x1 << ' ' << box.y1;
        ASSERT_EQ(gather([&](auto plot) { raster::ellipse_second_order(center, a, b, box, plot); }), right);
    }
    EXPECT_GT(cut, 5000);
}

struct Heard {
    std::vector<CirclePart> parts;
    int steps = 0;
    void on(const CirclePart& e) { parts.push_back(e); }
    void on(const raster::CircleStep&) { ++steps; }
    void on(const raster::EllipseStep&) { ++steps; }
    int count(CirclePart::Part part, CirclePart::Fate fate) const {
        return int(std::ranges::count_if(
            parts, [&](const CirclePart& p) { return p.part == part && p.fate == fate; }));
    }
};

TEST(ClipCircle, PartsAreTestedFromTheWholeToTheOctants) {
    Heard outside, within, corner;
    const auto nothing = [](int, int) {};
    raster::circle_midpoint({0, 0}, 10, {11, -20, 20, 20}, nothing, outside);
    ASSERT_EQ(outside.parts.size(), 1u);
    EXPECT_EQ(outside.parts[0].fate, CirclePart::Rejected);
    EXPECT_EQ(outside.steps, 0);

    raster::circle_midpoint({0, 0}, 10, {-10, -10, 10, 10}, nothing, within);
    ASSERT_EQ(within.parts.size(), 1u);
    EXPECT_EQ(within.parts[0].fate, CirclePart::Accepted);

    // A box to the lower right of (-2, 1): three quadrants are cut, one is outside of it.
    raster::circle_midpoint({0, 0}, 10, {-2, 1, 20, 20}, nothing, corner);
    EXPECT_EQ(corner.count(CirclePart::Whole, CirclePart::Cut), 1);
    EXPECT_EQ(corner.count(CirclePart::Quadrant, CirclePart::Rejected), 2);  // both upper ones
    EXPECT_EQ(corner.count(CirclePart::Quadrant, CirclePart::Cut), 2);
    EXPECT_EQ(corner.count(CirclePart::Octant, CirclePart::Accepted), 1);  // (0, 10) to the diagonal
    EXPECT_EQ(corner.count(CirclePart::Octant, CirclePart::Cut), 2);
    EXPECT_EQ(corner.count(CirclePart::Octant, CirclePart::Rejected), 1);
}

TEST(ClipCircle, WhatIsOutsideCostsNothing) {
    Heard heard;
    int pixels = 0;
    const int r = 1 << 30;
    raster::circle_midpoint(
        {0, 0}, r, {500000000, 950221817 - 100, 500000100, 950221817 + 100}, [&](int, int) { ++pixels; },
        heard);
    EXPECT_GT(pixels, 50);
    EXPECT_LE(heard.steps, pixels);
    heard = {};
    pixels = 0;
    raster::ellipse_midpoint(
        {0, 0}, 1 << 20, 1 << 19, {-100, (1 << 19) - 50, 100, 1 << 19}, [&](int, int) { ++pixels; }, heard);
    EXPECT_EQ(pixels, 201);
    EXPECT_LE(heard.steps, pixels);
    EXPECT_EQ(heard.count(CirclePart::Octant, CirclePart::Cut), 0);
}

TEST(ClipCircle, AnEmptyBoxHoldsNothing) {
    const auto nothing = [](int, int) { FAIL(); };
    raster::circle_midpoint({0, 0}, 5, {1, 0, 0, 5}, nothing);
    raster::circle_midpoint({0, 0}, 0, {1, 0, 0, 5}, nothing);
    raster::ellipse_midpoint({0, 0}, 5, 4, {1, 0, 0, 5}, nothing);
    raster::ellipse_midpoint({0, 0}, 5, 0, {1, 0, 0, 5}, nothing);
}

}  // namespace
}  // namespace relevo::tests
