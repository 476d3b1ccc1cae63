#include "raster/line_gupta_sproull.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <vector>

#include "tests/raster/cone_integral.hpp"
#include "tests/raster/line_coverage.hpp"
#include "tests/raster/line_pixels.hpp"

namespace relevo::raster {
namespace {

using tests::all_pixels;
using tests::Coverage;
using tests::Random;

Coverage gupta_sproull(glm::dvec2 a, glm::dvec2 b, double width, const PixelBox& box = all_pixels) {
    Coverage coverage;
    line_gupta_sproull(a, b, width, box, std::ref(coverage));
    return coverage;
}

// Along a row the numbers of the strip stand side by side: H(1/2) - H(-1/2) and H(3/2) - H(1/2).
TEST(LineGuptaSproull, ThreePixelsAColumn) {
    const Coverage c = gupta_sproull({0, 5}, {20, 5}, 1);
    const double h = cone_half_plane(0.5);
    for (int x = 2; x < 19; ++x) {
        EXPECT_NEAR(c.of(x, 5), full_coverage * (2 * h - 1), 1);
        EXPECT_NEAR(c.of(x, 4), full_coverage * (1 - h), 1);
        EXPECT_EQ(c.of(x, 4), c.of(x, 6));
        EXPECT_EQ(c.of(x, 3), 0);
        EXPECT_EQ(c.of(x, 7), 0);
    }
    for (const int y : {4, 5, 6}) {  // the end, half way: half the light, and the rest symmetric about it
        EXPECT_NEAR(2 * c.of(0, y), c.of(10, y), 2);
        EXPECT_NEAR(c.of(-1, y) + c.of(1, y), c.of(10, y), 2);
        EXPECT_EQ(c.of(-2, y), 0);
        for (const int x : {-1, 0, 1}) EXPECT_NEAR(c.of(20 - x, y), c.of(x, y), 2);
    }
}

TEST(LineGuptaSproull, AWideLineIsFullInside) {
    const Coverage c = gupta_sproull({0, 0}, {30, 12}, 7);
    int full = 0;
    for (const auto& [place, coverage] : c.at) {
        const double distance = std::abs(place.first * 30 - place.second * 12) / std::hypot(30, 12);
        const double along = (place.second * 30 + place.first * 12) / std::hypot(30, 12);
        const bool inside = distance < 2.5 && along > 1 && along < std::hypot(30, 12) - 1;
        if (inside) {
            EXPECT_EQ(coverage, full_coverage);
        }
        full += inside;
    }
    EXPECT_GT(full, 100);
}

struct Error {
    double middle = 0, ends = 0;  // of full coverage
};

// Every pixel that either of the two lights, against the integral of the cone over the rectangle.
Error error_of(glm::dvec2 a, glm::dvec2 b, double width) {
    const Coverage c = gupta_sproull(a, b, width);
    const double length = std::hypot(b.x - a.x, b.y - a.y), margin = width / 2 + 2;
    Error error;
    for (int y = int(std::floor(std::min(a.y, b.y) - margin)); y <= std::max(a.y, b.y) + margin; ++y)
        for (int x = int(std::floor(std::min(a.x, b.x) - margin)); x <= std::max(a.x, b.x) + margin; ++x) {
            const double exact = tests::cone_over_line(x, y, a.x, a.y, b.x, b.y, width);
            const double along = ((x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y)) / length;
            double& worst = along > 1 && along < length - 1 ? error.middle : error.ends;
            worst = std::max(worst, std::abs(c.of(x, y) / double(full_coverage) - exact));
        }
    return error;
}

TEST(LineGuptaSproull, IsTheIntegralOfTheCone) {
    Random random(1);
    std::printf("width    off by at most: middle     ends    ends of lines shorter than 2\n");
    double worst_end = 0, worst_short = 0;
    for (const double width : {0.25, 0.5, 1.0, 1.5, 2.0, 3.3, 6.0}) {
        Error error, of_short;
        for (int i = 0; i < 150; ++i) {
            const glm::dvec2 a{random.real(0, 1), random.real(0, 1)};
            const double span = i % 3 == 0 ? 2 : 12;
            const glm::dvec2 b{random.real(-span, span), random.real(-span, span)};
            const Error e = error_of(a, b, width);
            Error& group = std::hypot(b.x - a.x, b.y - a.y) < 2 ? of_short : error;
            group.middle = std::max(group.middle, e.middle), group.ends = std::max(group.ends, e.ends);
        }
        std::printf("%5.2f    %23.3g %8.3g %8.3g\n", width, error.middle, error.ends, of_short.ends);
        EXPECT_LE(error.middle, 2e-5) << width;
        worst_end = std::max(worst_end, error.ends), worst_short = std::max(worst_short, of_short.ends);
    }
    EXPECT_LE(worst_end, 0.01);
    EXPECT_GE(worst_end, 0.008);  // the header says so much
    EXPECT_LE(worst_short, 0.014);
}

// Light of a long line: width times length, but for how the pixels happen to sample it.
TEST(LineGuptaSproull, LightIsWidthTimesLength) {
    Random random(2);
    double worst = 0;
    for (const double width : {0.5, 1.0, 1.5, 2.0, 4.0})
        for (int i = 0; i < 200; ++i) {
            const glm::dvec2 a{random.real(0, 1), random.real(0, 1)};
            const double angle = random.real(0, 7), length = random.real(60, 200);
            const glm::dvec2 b{a.x + length * std::cos(angle), a.y + length * std::sin(angle)};
            const double share = gupta_sproull(a, b, width).sum() / (width * length);
            worst = std::max(worst, std::abs(share - 1));
        }
    std::printf("random lines: light off by at most %.3g of width * length\n", worst);
    EXPECT_LE(worst, 0.01);
    // Along a row the pixels sample the strip at whole distances: exact for whole widths, else up to this.
    for (const double width : {1.0, 2.0, 3.0})
        EXPECT_NEAR(gupta_sproull({0, 0.3}, {100, 0.3}, width).sum(), 100 * width, 0.01);
    EXPECT_NEAR(gupta_sproull({0, 0}, {100, 0}, 0.5).sum(), 50, 0.12 * 50);
}

TEST(LineGuptaSproull, AToBIsBToAAndNothingIsToldTwice) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec2 a{random.real(-30, 30), random.real(-30, 30)},
            b{random.real(-30, 30), random.real(-30, 30)};
        const double width = random.real(0.1, 5);
        const Coverage c = gupta_sproull(a, b, width);
        ASSERT_TRUE(c.sound());
        ASSERT_EQ(c, gupta_sproull(b, a, width));
    }
}

TEST(LineGuptaSproull, ABoxIsTheSameAsDiscarding) {
    Random random(4);
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec2 a{random.real(-60, 60), random.real(-60, 60)},
            b{random.real(-60, 60), random.real(-60, 60)};
        const double width = i % 3 == 0 ? 1 : random.real(0.1, 12);
        const int x = random.whole(-60, 60), y = random.whole(-60, 60);
        const PixelBox box{x, y, x + random.whole(0, 40), y + random.whole(0, 40)};
        ASSERT_EQ(gupta_sproull(a, b, width, box), gupta_sproull(a, b, width).within(box))
            << a.x << "," << a.y << " to " << b.x << "," << b.y << " width " << width;
    }
    for (int code = 0; code < 12 * 12 * 12 * 12; code += 7) {
        const glm::dvec2 a{code % 12 - 3, code / 12 % 12 - 3}, b{code / 144 % 12 - 3, code / 1728 - 3};
        const PixelBox box{0, 0, 5, 5};
        ASSERT_EQ(gupta_sproull(a, b, 1, box), gupta_sproull(a, b, 1).within(box));
    }
    EXPECT_TRUE(gupta_sproull({0, 0}, {9, 9}, 1, {5, 0, 4, 9}).at.empty());
}

// Far ends and large widths, a small box: the strip's formula at every pixel, and at once.
TEST(LineGuptaSproull, LongAndWideLinesInASmallBox) {
    Random random(5);
    int seen = 0;
    for (int i = 0; i < 3000; ++i) {
        const double span = i % 2 ? largest_line_place : 1e6;
        const glm::dvec2 a{random.real(-span, span), random.real(-span, span)},
            b{random.real(-span, span), random.real(-span, span)};
        const double part = random.real(0.1, 0.9), width = i % 4 < 2 ? 1 : random.real(0, 1e5);
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const double x = a.x + part * (b.x - a.x) + width / 2 * (b.y - a.y) / length,
                     y = a.y + part * (b.y - a.y) - width / 2 * (b.x - a.x) / length;
        const PixelBox box{int(x) - 4, int(y) - 4, int(x) + 4, int(y) + 4};
        const Coverage c = gupta_sproull(a, b, width, box);
        ASSERT_TRUE(c.sound());
        ASSERT_EQ(c, gupta_sproull(b, a, width, box));
        for (int row = box.y0; row <= box.y1; ++row)
            for (int column = box.x0; column <= box.x1; ++column) {
                const long double t = ((row - (long double)a.y) * ((long double)b.x - a.x) -
                                       (column - (long double)a.x) * ((long double)b.y - a.y)) /
                                      length;
                const double strip =
                    cone_half_plane(double(t + width / 2)) - cone_half_plane(double(t - width / 2));
                ASSERT_NEAR(c.of(column, row) / double(full_coverage), strip, 3e-5);
                ++seen;
            }
    }
    EXPECT_GT(seen, 100000);
}

TEST(LineGuptaSproull, BadNumbersAreRefused) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf, 1e300, 2 * largest_line_place}) {
        EXPECT_TRUE(gupta_sproull({bad, 0}, {9, 9}, 1).at.empty());
        EXPECT_TRUE(gupta_sproull({0, bad}, {9, 9}, 1).at.empty());
        EXPECT_TRUE(gupta_sproull({0, 0}, {bad, 9}, 1).at.empty());
        EXPECT_TRUE(gupta_sproull({0, 0}, {9, -bad}, 1).at.empty());
        EXPECT_TRUE(gupta_sproull({0, 0}, {9, 9}, bad).at.empty());
    }
    EXPECT_TRUE(gupta_sproull({0, 0}, {9, 9}, 0).at.empty());
    EXPECT_TRUE(gupta_sproull({0, 0}, {9, 9}, -1).at.empty());
    EXPECT_TRUE(gupta_sproull({4, 4}, {4, 4}, 9).at.empty());
    EXPECT_TRUE(gupta_sproull({4, 4}, {4 + 1e-300, 4}, 3).at.empty());
    EXPECT_TRUE(gupta_sproull({0, 0}, {5e-324, 0}, 3).at.empty());
    EXPECT_FALSE(gupta_sproull({-0.0, 5e-324}, {9, 9}, 1).at.empty());
    gupta_sproull({-largest_line_place, -largest_line_place}, {largest_line_place, largest_line_place},
                  largest_line_place, {-3, -3, 3, 3});
}

struct Listener {
    std::vector<GuptaSproullStarted> started;
    std::vector<GuptaSproullColumn> columns;
    std::vector<GuptaSproullPixel> pixels;
    void on(const GuptaSproullStarted& e) { started.push_back(e); }
    void on(const GuptaSproullColumn& e) { columns.push_back(e); }
    void on(const GuptaSproullPixel& e) { pixels.push_back(e); }
};

// For ends on pixels the distance is the midpoint line's d: t = (d + major - 2 minor) / (2 length).
TEST(LineGuptaSproull, EventsCarryTheDistance) {
    Listener heard;
    Coverage c;
    line_gupta_sproull({0, 0}, {7, 3}, 1, all_pixels, std::ref(c), heard);
    ASSERT_EQ(heard.started.size(), 1u);
    EXPECT_DOUBLE_EQ(heard.started[0].length, std::sqrt(58));
    EXPECT_EQ(c, gupta_sproull({0, 0}, {7, 3}, 1));
    const int d[] = {-1, 5, -3, 3, -5, 1, -7}, rows[] = {0, 0, 1, 1, 2, 2, 3};
    for (const GuptaSproullColumn& e : heard.columns)
        if (e.column >= 0 && e.column < 7) {
            const auto k = static_cast<std::size_t>(e.column);
            EXPECT_EQ(e.row, rows[k]);
            EXPECT_NEAR(-e.distance, (d[k] + 7 - 6) / (2 * std::sqrt(58)), 1e-9);
        }
    EXPECT_EQ(heard.pixels.size(), c.at.size());
    for (const GuptaSproullPixel& e : heard.pixels) {
        EXPECT_EQ(e.coverage, c.of(e.pixel.x, e.pixel.y));
        EXPECT_NEAR(e.distance, (7 * e.pixel.y - 3 * e.pixel.x) / std::sqrt(58), 1e-9);
        EXPECT_NEAR(e.coverage, full_coverage * e.strip * e.end, 0.51);
    }
}

}  // namespace
}  // namespace relevo::raster
