#include "raster/cone_table.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <limits>
#include <numbers>

#include "tests/raster/cone_integral.hpp"

namespace relevo::raster {
namespace {

using Long = long double;
using Gauss = boost::math::quadrature::gauss<Long, 30>;

// The part of the cone beyond s, ring by ring: height 3/pi (1 - r), and of the ring of radius r the angle
// 2 acos(s / r) lies beyond. With r = s + (1 - s) q^2 the integrand has no corner at r = s.
Long beyond(Long s) {
    const auto ring = [s](Long q) -> Long {
        const Long r = s + (1 - s) * q * q;
        return 3 / std::numbers::pi_v<Long> * (1 - r) * r * 2 * std::acos(s / r) * 2 * q * (1 - s);
    };
    Long sum = 0;
    for (int i = 0; i < 8; ++i) sum += Gauss::integrate(ring, Long(i) / 8, Long(i + 1) / 8);
    return sum;
}

TEST(ConeTable, TheFormulaIsTheIntegral) {
    for (int i = 1; i < 1000; ++i) {
        const double s = i / 1000.0;
        ASSERT_NEAR(cone_half_plane(s), double(1 - beyond(s)), 1e-13) << s;
        ASSERT_NEAR(cone_half_plane(-s), double(beyond(s)), 1e-13) << s;
    }
    EXPECT_EQ(cone_half_plane(0), 0.5);
    EXPECT_EQ(cone_half_plane(1e-300), 0.5);
    EXPECT_NEAR(cone_half_plane(1e-6), 0.5 + 3e-6 / std::numbers::pi, 1e-16);
    EXPECT_EQ(cone_half_plane(1), 1);
    EXPECT_EQ(cone_half_plane(-1), 0);
    EXPECT_EQ(cone_half_plane(7), 1);
    EXPECT_EQ(cone_half_plane(-std::numeric_limits<double>::infinity()), 0);
    EXPECT_TRUE(std::isnan(cone_half_plane(std::numeric_limits<double>::quiet_NaN())));
    // The other oracle of these tests, by slices.
    EXPECT_NEAR(tests::cone_over_rectangle(-1, 0.3, -1, 1), cone_half_plane(0.3), 1e-9);
}

// The cone's volume: height 3/pi is what makes it 1.
TEST(ConeTable, WeightsSumToOne) {
    const Long volume = Gauss::integrate([](Long r) -> Long { return 6 * r * (1 - r); }, Long(0), Long(1));
    EXPECT_NEAR(double(volume), 1, 1e-15);
    EXPECT_NEAR(tests::cone_over_rectangle(-2, 2, -2, 2), 1, 1e-9);
}

constexpr std::int64_t one = std::int64_t{1} << 32;
double from_table(std::int64_t s) { return cone_table()(s) * 0x1p-30; }

TEST(ConeTable, TheTableIsWithinItsBound) {
    double worst = 0;
    for (int i = -(1 << 17); i <= 1 << 17; ++i) {
        const std::int64_t s = std::int64_t{i} << 15;
        worst = std::max(worst, std::abs(from_table(s) - cone_half_plane(double(i) * 0x1p-17)));
        ASSERT_NEAR(from_table(s) + from_table(-s), 1, 0x1p-29) << i;
    }
    std::printf("table: off by at most %.3g\n", worst);
    EXPECT_LT(worst, 3e-6);
    EXPECT_GT(worst, 1e-6);  // the bound is no idle one
    EXPECT_EQ(cone_table()(one), 1 << 30);
    EXPECT_EQ(cone_table()(-one), 0);
    EXPECT_EQ(cone_table()(0), 1 << 29);
    EXPECT_EQ(cone_table()(std::numeric_limits<std::int64_t>::max() / 2), 1 << 30);
    EXPECT_EQ(cone_table()(std::numeric_limits<std::int64_t>::min() / 2), 0);
}

TEST(ConeTable, GoesOnBeyondTheCone) {
    const std::int64_t reach = ConeTable::reach * one;
    for (std::int64_t s = -reach; s <= reach; s += 999'983)
        ASSERT_EQ(cone_table().within(s), cone_table()(s)) << s;
    EXPECT_EQ(cone_table().within(-reach), 0);
    EXPECT_EQ(cone_table().within(reach), 1 << 30);
}

TEST(ConeTable, NeverFalls) {
    std::int32_t before = 0;
    for (std::int64_t s = -one; s <= one; s += 1 << 14) {
        ASSERT_GE(cone_table()(s), before);
        before = cone_table()(s);
    }
}

// A strip of any width, summed over all distances by the table, weighs its width.
TEST(ConeTable, AStripWeighsItsWidth) {
    for (const double width : {0.01, 0.3, 1.0, 1.7, 2.0, 5.0}) {
        const auto half = static_cast<std::int64_t>(width / 2 * 0x1p32);
        const std::int64_t step = 1 << 20, reach = half + one + step;
        double sum = 0;
        for (std::int64_t t = -reach; t <= reach; t += step)
            sum += from_table(t + half) - from_table(t - half);
        EXPECT_NEAR(sum * double(step) * 0x1p-32, width, 1e-6 * width) << width;
    }
}

}  // namespace
}  // namespace relevo::raster
