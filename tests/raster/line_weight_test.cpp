#include "raster/line_weight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace relevo::raster {
namespace {

TEST(LineWeight, AxesAreDimmedAndDiagonalsFull) {
    EXPECT_EQ(line_weight({0, 0}, {9, 0}), 46341);  // 65536 / sqrt 2
    EXPECT_EQ(line_weight({3, 9}, {3, -4}), 46341);
    EXPECT_EQ(line_weight({0, 0}, {7, 7}), full_coverage);
    EXPECT_EQ(line_weight({0, 0}, {-7, 7}), full_coverage);
    EXPECT_EQ(line_weight({4, 4}, {4, 4}), full_coverage);
}

// What it is for: pixels times weight per length is the same for every slope.
TEST(LineWeight, LightPerLengthDoesNotDependOnTheSlope) {
    for (int dx = -40; dx <= 40; ++dx)
        for (int dy = -40; dy <= 40; ++dy) {
            if (dx == 0 && dy == 0) continue;
            const int weight = line_weight({5, -3}, {5 + dx, dy - 3});
            const double light = weight * double(std::max(std::abs(dx), std::abs(dy))) / std::hypot(dx, dy);
            ASSERT_NEAR(light, full_coverage / std::sqrt(2.0), 0.5) << dx << "," << dy;
            ASSERT_EQ(weight, line_weight({5 + dx, dy - 3}, {5, -3}));
        }
}

TEST(LineWeight, AnyPixels) {
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    EXPECT_EQ(line_weight({least, least}, {most, most}), full_coverage);
    EXPECT_EQ(line_weight({least, 0}, {most, 0}), 46341);
    EXPECT_EQ(line_weight({0, most}, {1, least}), 46341);
}

}  // namespace
}  // namespace relevo::raster
