#include "raster/line_wu.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/raster/line_coverage.hpp"
#include "tests/raster/line_pixels.hpp"
#include "tests/support/exact_rational.hpp"

namespace relevo::raster {
namespace {

using tests::all_pixels;
using tests::Coverage;
using tests::Random;
using tests::exact::Integer;
using tests::exact::Rational;

Coverage wu(glm::dvec2 a, glm::dvec2 b, const PixelBox& box = all_pixels) {
    Coverage coverage;
    line_wu(a, b, box, std::ref(coverage));
    return coverage;
}

TEST(LineWu, PairsShareByDistance) {
    const Coverage c = wu({0, 0}, {4, 1});
    EXPECT_EQ(c.of(0, 0), 32768);  // half a column
    EXPECT_EQ(c.of(1, 0), 49152);
    EXPECT_EQ(c.of(1, 1), 16384);
    EXPECT_EQ(c.of(2, 0), 32768);
    EXPECT_EQ(c.of(2, 1), 32768);
    EXPECT_EQ(c.of(3, 1), 49152);
    EXPECT_EQ(c.of(4, 1), 32768);
    EXPECT_EQ(c.at.size(), 8u);
}

TEST(LineWu, EndsArePartsOfAColumn) {
    const Coverage c = wu({0.25, 2}, {3.125, 2});
    EXPECT_EQ(c.of(0, 2), 16384);  // from 0.25 to 0.5
    EXPECT_EQ(c.of(1, 2), 65536);
    EXPECT_EQ(c.of(3, 2), 40960);  // from 2.5 to 3.125
    EXPECT_EQ(c.at.size(), 4u);
    EXPECT_EQ(wu({1.125, 0}, {1.375, 0}).of(1, 0), 16384);  // both ends in one column
    EXPECT_EQ(wu({0.5, 0}, {1.5, 0}).at.size(), 1u);        // ends between columns: no empty pair
    EXPECT_TRUE(wu({1.5, 3}, {1.5, 3}).at.empty());
    EXPECT_TRUE(wu({1, 3}, {1, 3}).at.empty());
}

struct Listener {
    std::vector<WuPair> pairs;
    std::vector<WuStarted> started;
    void on(const WuPair& e) { pairs.push_back(e); }
    void on(const WuStarted& e) { started.push_back(e); }
};

Rational rational(double x) { return Rational(x); }

// Against exact numbers: each column's position, pair and extent.
TEST(LineWu, EveryPairIsTheRoundedTruth) {
    Random random(1);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        glm::dvec2 a{random.real(-300, 300), random.real(-300, 300)},
            b{random.real(-300, 300), random.real(-300, 300)};
        if (i % 3 == 0) a = {std::floor(a.x), std::floor(a.y)}, b = {std::floor(b.x), std::floor(b.y)};
        Listener heard;
        line_wu(
            a, b, all_pixels, [](int, int, int, int) {}, heard);
        const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
        if (steep) std::swap(a.x, a.y), std::swap(b.x, b.y);
        if (a.x > b.x) std::swap(a, b);
        const Rational slope = (rational(b.y) - rational(a.y)) / (rational(b.x) - rational(a.x));
        std::int64_t light = 0;
        for (const WuPair& pair : heard.pairs) {
            const Rational y = rational(a.y) + slope * (Rational(pair.column) - rational(a.x));
            const Rational low = std::max(rational(a.x), Rational(2 * pair.column - 1) / 2),
                           high = std::min(rational(b.x), Rational(2 * pair.column + 1) / 2);
            ASSERT_NEAR(pair.extent, double((high - low) * full_coverage), 0.5000001);
            ASSERT_EQ(pair.light[0] + pair.light[1], pair.extent);
            ASSERT_NEAR(pair.position, double(y), 1e-9);
            // both weights by distance, times the extent
            const double second = double((y - Rational(pair.row)) * (high - low) * full_coverage);
            worst = std::max(worst, std::abs(second - pair.light[1]));
            if (pair.extent == full_coverage) {
                ASSERT_NEAR(pair.light[1], second, 0.50001);
            }
            light += pair.extent;
        }
        ASSERT_NEAR(double(light) / full_coverage, b.x - a.x, 1.01 / full_coverage);
    }
    EXPECT_LE(worst, 1.51);  // ends: the extent and the share are rounded
}

TEST(LineWu, AToBIsBToAAndNothingIsToldTwice) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec2 a{random.real(-30, 30), random.real(-30, 30)},
            b{random.real(-30, 30), random.real(-30, 30)};
        const Coverage c = wu(a, b);
        ASSERT_TRUE(c.sound());
        ASSERT_EQ(c, wu(b, a));
        ASSERT_NEAR(c.sum(), std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)), 2e-5);
    }
    for (int code = 0; code < 12 * 12 * 12 * 12; ++code) {
        const glm::dvec2 a{code % 12 - 3, code / 12 % 12 - 3}, b{code / 144 % 12 - 3, code / 1728 - 3};
        ASSERT_EQ(wu(a, b), wu(b, a));
    }
}

TEST(LineWu, ABoxIsTheSameAsDiscarding) {
    Random random(3);
    for (int i = 0; i < 4000; ++i) {
        const glm::dvec2 a{random.real(-90, 90), random.real(-90, 90)},
            b{random.real(-90, 90), random.real(-90, 90)};
        const int x = random.whole(-80, 80), y = random.whole(-80, 80);
        const PixelBox box{x, y, x + random.whole(0, 40), y + random.whole(0, 40)};
        ASSERT_EQ(wu(a, b, box), wu(a, b).within(box)) << a.x << "," << a.y << " to " << b.x << "," << b.y;
    }
    for (int code = 0; code < 12 * 12 * 12 * 12; ++code) {
        const glm::dvec2 a{code % 12 - 3, code / 12 % 12 - 3}, b{code / 144 % 12 - 3, code / 1728 - 3};
        const PixelBox box{0, 0, 5, 5};
        ASSERT_EQ(wu(a, b, box), wu(a, b).within(box)) << a.x << "," << a.y << " to " << b.x << "," << b.y;
    }
    EXPECT_TRUE(wu({0, 0}, {9, 9}, {5, 0, 4, 9}).at.empty());
}

// Far ends, a small box: as exact as the header says, and at once.
TEST(LineWu, LongLinesInASmallBox) {
    Random random(4);
    int seen = 0;
    for (int i = 0; i < 1500; ++i) {
        const double span = i % 2 ? largest_line_place : 1e6;
        glm::dvec2 a{random.real(-span, span), random.real(-span, span)},
            b{random.real(-span, span), random.real(-span, span)};
        const double part = random.real(0, 1);
        const int x = int(a.x + part * (b.x - a.x)), y = int(a.y + part * (b.y - a.y));
        const PixelBox box{x - 5, y - 5, x + 5, y + 5};
        Listener heard;
        Coverage c;
        line_wu(a, b, box, std::ref(c), heard);
        ASSERT_TRUE(c.sound());
        ASSERT_EQ(c, wu(b, a, box));
        const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
        if (steep) std::swap(a.x, a.y), std::swap(b.x, b.y);
        const Rational slope = (rational(b.y) - rational(a.y)) / (rational(b.x) - rational(a.x));
        for (const WuPair& pair : heard.pairs) {
            const Rational y_true = rational(a.y) + slope * (Rational(pair.column) - rational(a.x));
            if (pair.extent == full_coverage) {
                ASSERT_NEAR(pair.light[1], double((y_true - Rational(pair.row)) * full_coverage),
                            0.5 + 0x1p-5);
            }
            ++seen;
        }
    }
    EXPECT_GT(seen, 5000);
}

TEST(LineWu, LinesThatFollowAddUp) {
    const Coverage whole = wu({0.3, 1}, {40.7, 13}), first = wu({0.3, 1}, {20.5, 7}),
                   rest = wu({20.5, 7}, {40.7, 13});
    for (const auto& [place, coverage] : whole.at) {
        const int x = place.second, y = place.first;
        EXPECT_NEAR(first.of(x, y) + rest.of(x, y), coverage, 2) << x << "," << y;
    }
}

TEST(LineWu, BadEndsAreRefused) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf, 1e300, 2 * largest_line_place}) {
        EXPECT_TRUE(wu({bad, 0}, {9, 9}).at.empty());
        EXPECT_TRUE(wu({0, bad}, {9, 9}).at.empty());
        EXPECT_TRUE(wu({0, 0}, {bad, 9}).at.empty());
        EXPECT_TRUE(wu({0, 0}, {9, -bad}).at.empty());
    }
    EXPECT_FALSE(wu({-0.0, 5e-324}, {9, 9}).at.empty());
    EXPECT_TRUE(wu({0, 0}, {5e-324, 0}).at.empty());  // less than half of 1/65536
}

}  // namespace
}  // namespace relevo::raster
