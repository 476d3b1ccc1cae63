#include "raster/ellipse_second_order.hpp"

#include "tests/raster/curve_pixels.hpp"

namespace relevo::tests {
namespace {

TEST(EllipseSecondOrder, TheSamePixelsAsByFirstDifferences) {
    for (int a = 0; a <= 128; ++a)
        for (int b = 0; b <= 128; ++b)
            ASSERT_EQ(gather([&](auto plot) {
                          raster::ellipse_second_order({7, -3}, a, b, everywhere, plot);
                      }),
                      gather([&](auto plot) {
                          raster::ellipse_midpoint({7, -3}, a, b, everywhere, plot);
                      }))
                << a << ", " << b;
}

TEST(EllipseSecondOrder, TheIncrementsOfTheFormula) {
    struct Probe {
        int count = 0;
        void on(const raster::EllipseSecondOrderStep& e) {
            ++count;
            EXPECT_EQ(e.along_x, 25 * 25 * (2 * e.x + (e.region == 1 ? 3 : 2)));
            EXPECT_EQ(e.along_y, 60 * 60 * ((e.region == 1 ? 2 : 3) - 2 * e.y));
        }
    } probe;
    raster::ellipse_second_order(
        {0, 0}, 60, 25, everywhere, [](int, int) {}, probe);
    EXPECT_GT(probe.count, 60);
}

TEST(EllipseSecondOrder, LargeOnes) {
    for (const auto& [a, b] :
         {std::pair{38000, 37999}, {38000, 3800}, {3800, 38000}, {1 << 20, (1 << 20) - 1}}) {
        const PixelBox quarter{0, 0, a, b};
        EXPECT_EQ(gather([&](auto plot) {
                      raster::ellipse_second_order({0, 0}, a, b, quarter, plot);
                  }),
                  gather([&](auto plot) {
                      raster::ellipse_midpoint({0, 0}, a, b, quarter, plot);
                  }))
            << a << ", " << b;
    }
    EXPECT_FALSE(
        raster::ellipse_second_order({0, 0}, (1 << 20) + 1, 1, everywhere, [](int, int) { FAIL(); }));
}

}  // namespace
}  // namespace relevo::tests
