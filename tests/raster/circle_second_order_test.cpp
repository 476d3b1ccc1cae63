#include "raster/circle_second_order.hpp"

#include "tests/raster/curve_pixels.hpp"

namespace relevo::tests {
namespace {

TEST(CircleSecondOrder, TheSamePixelsAsByFirstDifferences) {
    for (int r = 0; r <= 512; ++r)
        ASSERT_EQ(gather([&](auto plot) {
                      raster::circle_second_order({7, -3}, r, everywhere, plot);
                  }),
                  gather([&](auto plot) {
                      raster::circle_midpoint({7, -3}, r, everywhere, plot);
                  }))
            << r;
}

TEST(CircleSecondOrder, TheSameDecisionsAndTheIncrementsOfTheFormula) {
    struct Probe {
        int count = 0;
        void on(const raster::CircleSecondOrderStep& e) {
            ++count;
            EXPECT_EQ(e.delta_east, 2 * e.x + 3);
            EXPECT_EQ(e.delta_south_east, 2 * e.x - 2 * e.y + 5);
            EXPECT_EQ(e.d, raster::CircleMidpoint::at(e.x, e.y, 300).d);
            EXPECT_EQ(e.east, e.d < 0);
        }
    } probe;
    raster::circle_second_order(
        {0, 0}, 300, everywhere, [](int, int) {}, probe);
    EXPECT_GT(probe.count, 200);
}

TEST(CircleSecondOrder, TheLargestCircleInASmallBox) {
    const int r = 1 << 30;
    for (const PixelBox box :
         {PixelBox{-20, r - 20, 20, r + 20}, PixelBox{759250114, 759250114, 759250140, 759250140},
          PixelBox{-r - 5, -40, -r + 5, 40}}) {
        const Pixels pixels = gather([&](auto plot) { raster::circle_second_order({0, 0}, r, box, plot); });
        EXPECT_FALSE(pixels.empty());
        EXPECT_EQ(pixels, gather([&](auto plot) { raster::circle_midpoint({0, 0}, r, box, plot); }));
    }
    EXPECT_FALSE(raster::circle_second_order({0, 0}, r + 1, everywhere, [](int, int) { FAIL(); }));
}

}  // namespace
}  // namespace relevo::tests
