#include "raster/circle_midpoint.hpp"

#include <cmath>

#include "tests/raster/curve_pixels.hpp"

namespace relevo::tests {
namespace {

using raster::circle_midpoint;
using raster::CircleStep;
using raster::Int128;

Pixels circle(Pixel center, int radius, const PixelBox& box = everywhere) {
    return gather([&](auto plot) { circle_midpoint(center, radius, box, plot); });
}

// |x^2 + y^2 - r^2|
Int128 miss(Int128 x, Int128 y, Int128 r) {
    const Int128 f = x * x + y * y - r * r;
    return f < 0 ? -f : f;
}
// Within half a pixel of the circle along the column (or, seen from the side, the row): by the definition.
bool near_circle(Int128 x, Int128 y, Int128 r) {
    if (x < 0) x = -x;
    if (y < 0) y = -y;
    if (x > y) std::swap(x, y);
    const Int128 square = 4 * (r * r - x * x);  // (2 Y)^2
    return (y == 0 || (2 * y - 1) * (2 * y - 1) < square) && square < (2 * y + 1) * (2 * y + 1);
}

TEST(CircleMidpoint, Drawings) {
    EXPECT_TRUE(same_drawing(drawing_of(circle({0, 0}, 1), {-2, -2, 2, 2}), {".....",  //
                                                                             "..#..",  //
                                                                             ".#.#.",  //
                                                                             "..#..",  //
                                                                             "....."}));
    EXPECT_TRUE(same_drawing(drawing_of(circle({5, 4}, 4), {0, 0, 9, 8}), {"....###...",  //
                                                                           "..##...##.",  //
                                                                           "..#.....#.",  //
                                                                           ".#.......#",  //
                                                                           ".#.......#",  //
                                                                           ".#.......#",  //
                                                                           "..#.....#.",  //
                                                                           "..##...##.",  //
                                                                           "....###..."}));
}

TEST(CircleMidpoint, AllCirclesUpTo512AreSymmetricClosedAndNearest) {
    for (int r = 1; r <= 512; ++r) {
        const Pixels pixels = circle({0, 0}, r);
        ASSERT_EQ(fault_of_outline(pixels, r, r), "") << r;
        ASSERT_EQ(mapped(pixels, [](Pixel p) { return Pixel{p.y, p.x}; }), pixels) << r;
        int octant = 0;
        for (const Pixel& p : pixels) {
            ASSERT_TRUE(near_circle(p.x, p.y, r)) << r << ": " << p.x << ", " << p.y;
            if (p.x < 0 || p.y < p.x) continue;
            ++octant;
            ASSERT_LT(miss(p.x, p.y, r), miss(p.x, p.y + 1, r)) << r << ": " << p.x << ", " << p.y;
            if (p.y > 0) {
                ASSERT_LT(miss(p.x, p.y, r), miss(p.x, p.y - 1, r)) << r << ": " << p.x << ", " << p.y;
            }
        }
        // as many columns as there are up to the diagonal, give or take the one that it cuts
        ASSERT_NEAR(octant, r * std::sqrt(0.5) + 1, 1) << r;
    }
}

TEST(CircleMidpoint, TheDecisionsOfRadiusEight) {
    struct Probe {
        std::vector<std::array<int, 4>> steps;
        void on(const CircleStep& e) { steps.push_back({e.x, e.y, e.d, e.east}); }
    } probe;
    circle_midpoint(
        {100, -50}, 8, everywhere, [](int, int) {}, probe);
    const std::vector<std::array<int, 4>> right = {{0, 8, -7, 1}, {1, 8, -4, 1}, {2, 8, 1, 0},
                                                   {3, 7, -6, 1}, {4, 7, 3, 0},  {5, 6, 2, 0}};
    EXPECT_EQ(probe.steps, right);
}

TEST(CircleMidpoint, RadiusZeroIsOnePixelAndANegativeOneNothing) {
    EXPECT_EQ(circle({3, -4}, 0), Pixels({{3, -4}}));
    EXPECT_TRUE(circle({3, -4}, 0, {4, -4, 9, 9}).empty());
    EXPECT_TRUE(circle({3, -4}, -1).empty());
    EXPECT_TRUE(circle({3, -4}, -2147483647 - 1).empty());
}

TEST(CircleMidpoint, RadiiAboveTheLargestAreRefused) {
    const auto nothing = [](int, int) { FAIL(); };
    EXPECT_FALSE(circle_midpoint({0, 0}, (1 << 30) + 1, everywhere, nothing));
    EXPECT_FALSE(circle_midpoint({0, 0}, 2147483647, everywhere, nothing));
    EXPECT_TRUE(circle_midpoint({0, 0}, 1 << 30, {0, 0, 5, 5}, nothing));
}

TEST(CircleMidpoint, TheLargestCircleIsRightWhereverOneLooks) {
    const std::int64_t r = 1 << 30;
    const auto diagonal = std::int64_t(std::sqrt(0.5) * double(r));
    struct Place {
        std::int64_t x, y;
    };
    const Place places[] = {{0, r},
                            {0, -r},
                            {r, 0},
                            {-r, 0},
                            {diagonal, diagonal},
                            {-diagonal, diagonal},
                            {diagonal, -diagonal},
                            {600000000, std::int64_t(std::sqrt(double(r * r) - 36e16))},
                            {-std::int64_t(std::sqrt(double(r * r) - 36e16)), 600000000}};
    // The second centre lies so that the circle leaves the whole numbers of 32 bits.
    for (const Pixel center : {Pixel{0, 0}, Pixel{2147483647, -2147483647}, Pixel{-2147483647, 2147483647}})
        for (const Place& place : places) {
            const std::int64_t cx = center.x + place.x, cy = center.y + place.y;
            if (std::max(std::abs(cx), std::abs(cy)) > 2147483000) continue;
            const PixelBox box{int(cx) - 20, int(cy) - 15, int(cx) + 25, int(cy) + 30};
            Pixels right;
            for (int y = box.y0; y <= box.y1; ++y)
                for (int x = box.x0; x <= box.x1; ++x)
                    if (near_circle(std::int64_t{x} - center.x, std::int64_t{y} - center.y, r))
                        right.push_back({x, y});
            std::sort(right.begin(), right.end(), before);
            EXPECT_FALSE(right.empty());
            EXPECT_EQ(circle(center, int(r), box), right) << place.x << ", " << place.y;
        }
}

TEST(CircleMidpoint, TheLargestCircleWalksAWholeOctantIn32Bits) {
    raster::NoProbe none;
    auto s = raster::CircleMidpoint::at(0, 1 << 30, 1 << 30);
    for (int i = 0; i < 1000000; ++i) s.step(none);
    auto late = raster::CircleMidpoint::at(s.x, s.y, 1 << 30);
    EXPECT_EQ(s.d, late.d);
    const raster::CircleOctant octant{1 << 30};
    const int last = int(octant.last_column(true));
    late = raster::CircleMidpoint::at(last - 1000000, int(octant.row(last - 1000000)), 1 << 30);
    for (int i = 0; i < 1000000; ++i) late.step(none);
    EXPECT_EQ(late.x, last);
    EXPECT_EQ(late.y, octant.row(last));
    EXPECT_EQ(late.d, raster::CircleMidpoint::at(last, late.y, 1 << 30).d);
}

}  // namespace
}  // namespace relevo::tests
