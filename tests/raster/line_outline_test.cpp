#include "raster/line_outline.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace relevo::raster {
namespace {

double area_of(const std::array<glm::dvec2, 4>& c) {  // positive: clockwise on the page, y down
    double twice = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 &p = c[i], &q = c[(i + 1) % 4];
        twice += (p.x - c[0].x) * (q.y - c[0].y) - (q.x - c[0].x) * (p.y - c[0].y);
    }
    return twice / 2;
}

TEST(LineOutline, ALineAlongTheRow) {
    const auto c = line_outline({1, 2}, {5, 2}, 3);
    EXPECT_EQ(c, (std::array<glm::dvec2, 4>{{{1, 3.5}, {1, 0.5}, {5, 0.5}, {5, 3.5}}}));
    EXPECT_EQ(area_of(c), 12);
}

TEST(LineOutline, AreaIsWidthTimesLengthAndEndsAreUpright) {
    std::mt19937_64 random(1);
    const auto real = [&](double low, double high) {
        return low + (high - low) * double(random() >> 11) * 0x1p-53;
    };
    for (int i = 0; i < 10000; ++i) {
        const glm::dvec2 a{real(-100, 100), real(-100, 100)}, b{real(-100, 100), real(-100, 100)};
        const double width = real(0.01, 20), length = std::hypot(b.x - a.x, b.y - a.y);
        const auto c = line_outline(a, b, width);
        ASSERT_NEAR(area_of(c), width * length, 1e-12 * width * length + 1e-10);
        // The ends stand upright on the line, and the line is in the middle.
        const glm::dvec2 middle{(c[0].x + c[1].x) / 2, (c[0].y + c[1].y) / 2};
        ASSERT_NEAR(middle.x, a.x, 1e-12 * 200);
        ASSERT_NEAR(middle.y, a.y, 1e-12 * 200);
        ASSERT_NEAR((c[0].x - c[1].x) * (b.x - a.x) + (c[0].y - c[1].y) * (b.y - a.y), 0, 1e-9);
        ASSERT_NEAR(std::hypot(c[0].x - c[1].x, c[0].y - c[1].y), width, 1e-11);
    }
}

TEST(LineOutline, WithoutLengthOrWidthThereIsNothing) {
    const glm::dvec2 a{3, 4};
    for (const auto& c : {line_outline(a, a, 5), line_outline(a, {9, 9}, 0), line_outline(a, {9, 9}, -2)})
        EXPECT_EQ(c, (std::array<glm::dvec2, 4>{a, a, a, a}));
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
        const std::array<glm::dvec2, 4> none{};
        EXPECT_EQ(line_outline({bad, 0}, a, 1), none);
        EXPECT_EQ(line_outline({0, bad}, a, 1), none);
        EXPECT_EQ(line_outline(a, {bad, 0}, 1), none);
        EXPECT_EQ(line_outline(a, {0, bad}, 1), none);
        EXPECT_EQ(line_outline(a, {9, 9}, bad), none);
    }
    EXPECT_EQ(line_outline({-1.7e308, 0}, {1.7e308, 0}, 1), (std::array<glm::dvec2, 4>{}));
}

TEST(LineOutline, LargeAndSmallLines) {
    EXPECT_EQ(vector_length(3, -4), 5);
    EXPECT_EQ(vector_length(0, 0), 0);
    EXPECT_NEAR(vector_length(3e200, 4e200) / 5e200, 1, 1e-15);
    EXPECT_NEAR(vector_length(3e-200, 4e-200) / 5e-200, 1, 1e-15);
    EXPECT_NEAR(area_of(line_outline({0, 0}, {3e-100, 4e-100}, 1e-100)) / 5e-200, 1, 1e-12);
}

}  // namespace
}  // namespace relevo::raster
