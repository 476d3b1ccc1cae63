#include "raster/ellipse_midpoint.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include "tests/raster/curve_pixels.hpp"

namespace relevo::tests {
namespace {

using Whole = boost::multiprecision::int128_t;
using raster::ellipse_midpoint;

// Where region 2 begins: the row above its first one.
struct Turn {
    int y = 0;
    std::vector<raster::EllipseStep> steps;
    void on(const raster::EllipseTurned& e) { y = e.y; }
};

Pixels ellipse(Pixel center, int a, int b, const PixelBox& box = everywhere) {
    return gather([&](auto plot) { ellipse_midpoint(center, a, b, box, plot); });
}

// 4 F at (x, y) / 2
template <class Number>
Number four_f(Number a, Number b, Number x2, Number y2) {
    return b * b * x2 * x2 + a * a * y2 * y2 - 4 * a * a * b * b;
}
// Within half a pixel of the curve along the column (region 1) or the row (region 2).
template <class Number>
bool is_near(Number a, Number b, Number x, Number y, bool region1) {
    if (!region1) return is_near(b, a, y, x, true);
    return x <= a && (y == 0 || four_f<Number>(a, b, 2 * x, 2 * y - 1) <= 0) &&
           four_f<Number>(a, b, 2 * x, 2 * y + 1) >= 0;
}

TEST(EllipseMidpoint, Drawings) {
    EXPECT_TRUE(same_drawing(drawing_of(ellipse({6, 3}, 6, 3), {0, 0, 12, 6}), {"...#######...",  //
                                                                                ".##.......##.",  //
                                                                                "#...........#",  //
                                                                                "#...........#",  //
                                                                                "#...........#",  //
                                                                                ".##.......##.",  //
                                                                                "...#######..."}));
    // a tip that the midpoint test alone does not reach
    EXPECT_TRUE(same_drawing(drawing_of(ellipse({10, 1}, 10, 1), {0, 0, 20, 2}), {"..#################..",  //
                                                                                  "##.................##",  //
                                                                                  "..#################.."}));
    EXPECT_TRUE(same_drawing(drawing_of(ellipse({1, 4}, 1, 4), {0, 0, 2, 8}),
                             {".#.", "#.#", "#.#", "#.#", "#.#", "#.#", "#.#", "#.#", ".#."}));
}

TEST(EllipseMidpoint, AllEllipsesUpTo128AreSymmetricClosedAndNearest) {
    for (int a = 1; a <= 128; ++a)
        for (int b = 1; b <= 128; ++b) {
            Turn turn;
            Pixels pixels;
            ellipse_midpoint(
                {0, 0}, a, b, everywhere,
                [&](int x, int y) {
                    pixels.push_back({x, y});
                },
                turn);
            std::sort(pixels.begin(), pixels.end(), before);
            ASSERT_EQ(fault_of_outline(pixels, a, b), "") << a << ", " << b;
            if (a == b) continue;  // circle_midpoint_test
            for (const Pixel& p : pixels)
                if (p.x >= 0 && p.y >= 0) {
                    ASSERT_TRUE(is_near<std::int64_t>(a, b, p.x, p.y, p.y >= turn.y))
                        << a << ", " << b << ": " << p.x << ", " << p.y;
                }
        }
}

TEST(EllipseMidpoint, LargeOnesAreExact) {
    const int top = raster::largest_ellipse_radius;
    const std::pair<int, int> radii[] = {{38000, 37999}, {37999, 38000}, {38000, 3800},  {3800, 38000},
                                         {38000, 1},     {1, 38000},     {top, top - 1}, {top, 104857},
                                         {104857, top},  {top, 1},       {top, 1024}};
    for (const auto& [a, b] : radii) {
        Turn turn;
        std::int64_t count = 0, wrong = 0, last_x = -1, last_y = -1;
        // one quarter, in the order of drawing
        ellipse_midpoint(
            {0, 0}, a, b, {0, 0, top, top},
            [&](int x, int y) {
                ++count;
                const bool region1 = turn.y == 0;
                if (region1 ? x < last_x || x > last_x + 1 : y != last_y - 1 && last_y > 0 && count > 1)
                    ++wrong;
                wrong += !is_near<Whole>(a, b, x, y, region1);
                last_x = x, last_y = y;
            },
            turn);
        EXPECT_EQ(wrong, 0) << a << ", " << b;
        EXPECT_GE(count, std::max(a, b)) << a << ", " << b;
        EXPECT_EQ(last_x, a) << a << ", " << b;
        EXPECT_EQ(last_y, 0) << a << ", " << b;
    }
}

TEST(EllipseMidpoint, EqualRadiiAreTheCircle) {
    for (int r = 0; r <= 200; ++r)
        ASSERT_EQ(ellipse({4, 5}, r, r), gather([&](auto plot) {
                      raster::circle_midpoint({4, 5}, r, everywhere, plot);
                  }));
    // even where an ellipse would be refused
    EXPECT_TRUE(ellipse_midpoint({0, 0}, 1 << 30, 1 << 30, {0, 0, 9, 9}, [](int, int) { FAIL(); }));
}

TEST(EllipseMidpoint, WithoutARadiusItIsALine) {
    EXPECT_EQ(ellipse({1, 2}, 2, 0), Pixels({{-1, 2}, {0, 2}, {1, 2}, {2, 2}, {3, 2}}));
    EXPECT_EQ(ellipse({1, 2}, 0, 1), Pixels({{1, 3}, {1, 2}, {1, 1}}));
    EXPECT_EQ(ellipse({1, 2}, 0, 0), Pixels({{1, 2}}));
    EXPECT_EQ(ellipse({1, 2}, 1000000, 0, {5, 0, 6, 4}), Pixels({{5, 2}, {6, 2}}));
    EXPECT_TRUE(ellipse({1, 2}, 1000000, 0, {5, 3, 6, 4}).empty());
    EXPECT_TRUE(ellipse({1, 2}, 0, 1000000, {2, 0, 6, 4}).empty());
    EXPECT_EQ(ellipse({2147483647, 0}, 5, 0, {2147483646, 0, 2147483647, 0}),
              Pixels({{2147483646, 0}, {2147483647, 0}}));
}

TEST(EllipseMidpoint, NegativeIsNothingAndTooLargeIsRefused) {
    const auto nothing = [](int, int) { FAIL(); };
    EXPECT_TRUE(ellipse_midpoint({0, 0}, -1, 5, everywhere, nothing));
    EXPECT_TRUE(ellipse_midpoint({0, 0}, 5, -2147483647 - 1, everywhere, nothing));
    EXPECT_FALSE(ellipse_midpoint({0, 0}, (1 << 20) + 1, 5, everywhere, nothing));
    EXPECT_FALSE(ellipse_midpoint({0, 0}, 5, 2147483647, everywhere, nothing));
    EXPECT_FALSE(ellipse_midpoint({0, 0}, (1 << 30) + 1, (1 << 30) + 1, everywhere, nothing));
}

TEST(EllipseMidpoint, CentresAtTheEndOfTheNumbers) {
    const Pixels pixels =
        ellipse({2147483647, -2147483647}, 9, 5, {2147483640, -2147483647, 2147483647, -2147483640});
    const Pixels right = mapped(ellipse({0, 0}, 9, 5, {-7, 0, 0, 7}), [](Pixel p) {
        return Pixel{2147483647 + p.x, -2147483647 + p.y};
    });
    EXPECT_FALSE(right.empty());
    EXPECT_EQ(pixels, right);
}

TEST(EllipseMidpoint, EventsCarryTheDecisionVariable) {
    struct Probe {
        int steps[3] = {0, 0, 0};
        int a = 20, b = 9;
        void on(const raster::EllipseStep& e) {
            ++steps[e.region];
            const std::int64_t mid_x = 2 * e.x + (e.region == 1 ? 2 : 1),
                               mid_y = 2 * e.y - (e.region == 1 ? 1 : 2);
            const std::int64_t f4 = four_f<std::int64_t>(a, b, mid_x, mid_y);
            EXPECT_EQ(e.d, (f4 - ((f4 % 4 + 4) % 4)) / 4);  // without its fraction
            EXPECT_EQ(e.choice == raster::EllipseChoice::E, e.region == 1 && f4 < 0);
            EXPECT_EQ(e.choice == raster::EllipseChoice::S, e.region == 2 && f4 >= 0);
        }
    } probe;
    ellipse_midpoint(
        {5, 5}, probe.a, probe.b, everywhere, [](int, int) {}, probe);
    EXPECT_GT(probe.steps[1], 10);
    EXPECT_GT(probe.steps[2], 2);
}

}  // namespace
}  // namespace relevo::tests
