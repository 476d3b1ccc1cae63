#include "samples/show/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace relevo::show {
namespace {

TEST(Number, HasFourSignificantDigits) {
    EXPECT_EQ(number(0), "0");
    EXPECT_EQ(number(-0.0), "0");
    EXPECT_EQ(number(1.0 / 3), "0.3333");
    EXPECT_EQ(number(-12.5), "-12.5");
    EXPECT_EQ(number(123456), "1.235e5");
    EXPECT_EQ(number(1.2341e-7), "1.234e-7");
    EXPECT_EQ(number(std::numeric_limits<double>::infinity()), "∞");
    EXPECT_EQ(number(-std::numeric_limits<double>::infinity()), "-∞");
    EXPECT_EQ(number(std::nan("")), "nan");
}

TEST(Grouped, SetsACommaBeforeEveryThreeDigits) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1,000");
    EXPECT_EQ(grouped(69666), "69,666");
    EXPECT_EQ(grouped(1234567), "1,234,567");
    EXPECT_EQ(grouped(-1000), "-1,000");
    EXPECT_EQ(grouped(-100), "-100");
}

TEST(Counted, KnowsOneFromMany) {
    EXPECT_EQ(counted(1, "triangle"), "1 triangle");
    EXPECT_EQ(counted(0, "triangle"), "0 triangles");
    EXPECT_EQ(counted(1200, "model"), "1,200 models");
}

TEST(NiceStep, IsOneTwoOrFiveTimesAPowerOfTen) {
    EXPECT_DOUBLE_EQ(nice_step(1), 1);
    EXPECT_DOUBLE_EQ(nice_step(1.1), 2);
    EXPECT_DOUBLE_EQ(nice_step(4), 5);
    EXPECT_DOUBLE_EQ(nice_step(6), 10);
    EXPECT_NEAR(nice_step(0.03), 0.05, 1e-12);
    EXPECT_NEAR(nice_step(720), 1000, 1e-9);
    for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(nice_step(bad), 1);
}

}  // namespace
}  // namespace relevo::show
