#include "raster/curve_coverage.hpp"

#include <limits>
#include <map>
#include <random>

#include "tests/raster/curve_area.hpp"
#include "tests/raster/curve_pixels.hpp"

namespace relevo::tests {
namespace {

using raster::disc_coverage;
using raster::full_coverage;
using raster::ring_coverage;

constexpr double unit = full_coverage;
const Real pi = std::acos(Real(-1));

struct Covered {
    std::map<std::pair<int, int>, int> at;  // (y, x)
    std::string fault;
    double sum = 0;
    void operator()(int y, int x0, int x1, int coverage) {
        if (x0 >= x1) fault = "an empty run";
        if (coverage < 1 || coverage > full_coverage) fault = "a coverage out of range";
        for (int x = x0; x < x1; ++x)
            if (!at.emplace(std::pair{y, x}, coverage).second) fault = "a pixel twice";
        sum += (x1 - double(x0)) * coverage / unit;
    }
    double operator()(int y, int x) const {
        const auto found = at.find({y, x});
        return found == at.end() ? 0 : found->second / unit;
    }
};

const PixelBox view{-70, -70, 70, 70};

struct Sizes {
    double a, b;
};
const Sizes sizes[] = {{5, 5},      {8.25, 8.25}, {33.7, 33.7},   {64, 64},     {0.3, 0.3},
                       {0.5, 0.5},  {1, 1},       {1.4, 2},       {20, 3},      {3, 20.5},
                       {50, 0.2},   {0.1, 40},    {60, 59},       {0.01, 0.01}, {2, 2},
                       {12.5, 7.5}, {10, 10},     {0.707, 0.707}, {1, 0.25},    {64, 32}};
const glm::dvec2 centers[] = {{0, 0},   {0.5, 0.5},   {0.25, -0.4}, {-0.123456, 0.987654},
                              {0.5, 0}, {1e-9, -1e-9}};

TEST(CurveCoverage, EveryPixelOfADiscIsItsExactArea) {
    double worst = 0;
    for (const Sizes& s : sizes)
        for (const glm::dvec2& c : centers) {
            Covered covered;
            ASSERT_TRUE(disc_coverage(c, s.a, s.b, view, covered));
            ASSERT_EQ(covered.fault, "") << s.a << ", " << s.b;
            for (int y = -int(s.b) - 3; y <= int(s.b) + 3; ++y)
                for (int x = -int(s.a) - 3; x <= int(s.a) + 3; ++x)
                    worst = std::max(worst, std::abs(covered(y, x) - double(exact_pixel(c, s.a, s.b, x, y))));
        }
    EXPECT_LT(worst * unit, 1.5);  // 2^-16 of a pixel
    EXPECT_GT(worst * unit, 0.5);
}

TEST(CurveCoverage, EveryPixelOfARingIsItsExactArea) {
    double worst = 0;
    for (const Sizes& s : sizes)
        for (const double width : {1.0, 0.1, 2.5, 9.0})
            for (const glm::dvec2& c : {centers[0], centers[3]}) {
                Covered covered;
                ASSERT_TRUE(ring_coverage(c, s.a, s.b, width, view, covered));
                ASSERT_EQ(covered.fault, "") << s.a << ", " << s.b << ", " << width;
                const double half = width / 2;
                const bool hole = s.a > half && s.b > half;
                for (int y = -int(s.b + half) - 2; y <= int(s.b + half) + 2; ++y)
                    for (int x = -int(s.a + half) - 2; x <= int(s.a + half) + 2; ++x) {
                        Real area = exact_pixel(c, s.a + half, s.b + half, x, y);
                        if (hole) area -= exact_pixel(c, s.a - half, s.b - half, x, y);
                        if (!view.holds(x, y)) continue;
                        worst = std::max(worst, std::abs(covered(y, x) - double(area)));
                    }
            }
    EXPECT_LT(worst * unit, 2.5);
}

TEST(CurveCoverage, TheSumIsTheAreaOfTheEllipse) {
    std::mt19937_64 bits(3);
    const auto between = [&](double low, double high) {
        return low + (high - low) * (double(bits() >> 11) * 0x1p-53);
    };
    for (int i = 0; i < 500; ++i) {
        const double a = i % 2 ? between(0.05, 60) : between(0.05, 3), b = i % 3 ? between(0.05, 60) : a;
        const glm::dvec2 c{between(-5, 5), between(-5, 5)};
        Covered disc, ring;
        disc_coverage(c, a, b, view, disc);
        ASSERT_NEAR(disc.sum, double(pi * a * b), (2 * b + 2) * 2 / unit) << a << ", " << b;
        ring_coverage(c, a, a, 1, view, ring);
        const double right = a > 0.5 ? double(2 * pi * a) : double(pi) * (a + 0.5) * (a + 0.5);
        ASSERT_NEAR(ring.sum, right, (2 * a + 3) * 4 / unit) << a;
    }
}

TEST(CurveCoverage, TheBoxCutsOnly) {
    std::mt19937 bits(4);
    const auto number = [&](int low, int high) { return low + int(bits() % unsigned(high - low + 1)); };
    for (int i = 0; i < 1500; ++i) {
        const double a = number(1, 200) / 8.0, b = i % 2 ? a : number(1, 200) / 8.0, w = number(1, 40) / 8.0;
        const glm::dvec2 c{number(-80, 80) / 16.0, number(-80, 80) / 16.0};
        PixelBox box{number(-30, 25), number(-30, 25), 0, 0};
        box.x1 = box.x0 + number(0, 30), box.y1 = box.y0 + number(0, 30);
        Covered all, some, all_ring, some_ring;
        disc_coverage(c, a, b, view, all), disc_coverage(c, a, b, box, some);
        ring_coverage(c, a, b, w, view, all_ring), ring_coverage(c, a, b, w, box, some_ring);
        const auto cut = [&](auto pixels) {
            std::erase_if(pixels, [&](const auto& p) { return !box.holds(p.first.second, p.first.first); });
            return pixels;
        };
        ASSERT_EQ(some.fault + some_ring.fault, "");
        ASSERT_EQ(some.at, cut(all.at)) << a << ", " << b;
        ASSERT_EQ(some_ring.at, cut(all_ring.at)) << a << ", " << b << ", " << w;
    }
}

TEST(CurveCoverage, TinyAndHugeOnes) {
    Covered none, dot, thin;
    EXPECT_TRUE(disc_coverage({0, 0}, 0, 5, view, none));
    EXPECT_TRUE(disc_coverage({0, 0}, 5, -1, view, none));
    EXPECT_TRUE(disc_coverage({0, 0}, 5e-324, 0x1p30, view, none));
    EXPECT_TRUE(ring_coverage({0, 0}, 5, 5, 0, view, none));
    EXPECT_TRUE(ring_coverage({0, 0}, -5, 5, 1, view, none));
    EXPECT_TRUE(ring_coverage({0, 0}, 0, 0, 5e-324, view, none));
    EXPECT_TRUE(disc_coverage({0, 0}, 3, 3, {2, 0, 1, 5}, none));
    EXPECT_TRUE(none.at.empty());
    EXPECT_TRUE(ring_coverage({3, 4}, 0, 0, 1, view, dot));  // a round dot of the pen
    EXPECT_EQ(dot.at.size(), 1u);
    EXPECT_NEAR(dot(4, 3), double(pi) / 4, 2 / unit);
    EXPECT_TRUE(ring_coverage({0, 0}, 30, 0, 2, view, thin));  // no hole: an ellipse of radii 31 and 1
    EXPECT_NEAR(thin.sum, double(pi) * 31, 8 / unit);

    for (const double r : {0x1p20, 0x1p30}) {  // the lowest point of a huge circle, where it is flat
        Covered covered;
        ASSERT_TRUE(disc_coverage({0.25, -r}, r, r, {-30, -5, 30, 5}, covered));
        for (int x = -30; x <= 30; ++x) {
            EXPECT_EQ(covered(-1, x), 1);
            EXPECT_NEAR(covered(0, x), 0.5, 0x1p-11);
            EXPECT_EQ(covered(1, x), 0);
        }
    }
    // the box may be all there is, and the ring reach beyond it
    Covered far;
    const int end = std::numeric_limits<int>::max();
    EXPECT_TRUE(ring_coverage({0x1p30, -0x1p30}, 2, 2, 1, {-end - 1, -end - 1, end, end}, far));
    EXPECT_NEAR(far.sum, double(4 * pi), 1e-3);
}

TEST(CurveCoverage, LargeOnesKeepTheirBounds) {
    struct Case {
        double a, b, bound;  // 2^-16 of a pixel
    };
    std::mt19937_64 bits(5);
    const auto between = [&](double low, double high) {
        return low + (high - low) * (double(bits() >> 11) * 0x1p-53);
    };
    for (const Case& k : {Case{4096, 4096, 2}, Case{0x1p20, 0x1p20, 2}, Case{0x1p20, 1024, 2},
                          Case{3, 0x1p20, 2}, Case{0x1p24, 0x1p24, 2}, Case{0x1p30, 100, 2},
                          Case{0x1p30, 0x1p30, 128}, Case{0x1p20, 0.4, 2 + 0x1p-27 * 0x1p20 * 0.9 * unit}})
        for (const double width : {0.0, 1.0}) {
            double worst = 0;
            for (int i = 0; i < 200; ++i) {  // a few pixels somewhere on the edge, and near the tips
                const double size = between(0.5, 1), a = k.a * size,
                             b = k.a == k.b ? a : k.b * between(0.5, 1);
                double t = between(-4, 4);
                if (i % 4 == 0) t = double(pi) / 2 * double(i % 3) + between(0, 1e-2) * between(0, 1e-4);
                const glm::dvec2 c{between(-1, 1), between(-1, 1)};
                const int x0 = int(std::floor(c.x + a * std::cos(t))),
                          y0 = int(std::floor(c.y + b * std::sin(t)));
                const PixelBox box{x0 - 2, y0 - 2, x0 + 3, y0 + 3};
                Covered covered;
                const double half = width / 2;
                if (width > 0)
                    ring_coverage(c, a, b, width, box, covered);
                else
                    disc_coverage(c, a, b, box, covered);
                ASSERT_EQ(covered.fault, "");
                for (int y = box.y0; y <= box.y1; ++y)
                    for (int x = box.x0; x <= box.x1; ++x) {
                        Real area = exact_pixel(c, a + half, b + half, x, y);
                        if (width > 0 && b > half) area -= exact_pixel(c, a - half, b - half, x, y);
                        worst = std::max(worst, std::abs(covered(y, x) - double(area)));
                    }
            }
            EXPECT_LT(worst * unit, k.bound) << k.a << ", " << k.b << ", width " << width;
        }
}

TEST(CurveCoverage, WhatIsNoNumberOrTooLargeIsRefused) {
    const auto nothing = [](int, int, int, int) { FAIL(); };
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf, 0x1p31}) {
        EXPECT_FALSE(disc_coverage({bad, 0}, 5, 5, view, nothing));
        EXPECT_FALSE(disc_coverage({0, bad}, 5, 5, view, nothing));
        EXPECT_FALSE(ring_coverage({0, bad}, 5, 5, 1, view, nothing));
        if (bad == -inf) continue;  // negative: nothing to draw
        EXPECT_FALSE(disc_coverage({0, 0}, bad, 5, view, nothing));
        EXPECT_FALSE(disc_coverage({0, 0}, 5, bad, view, nothing));
        EXPECT_FALSE(ring_coverage({0, 0}, bad, 5, 1, view, nothing));
        EXPECT_FALSE(ring_coverage({0, 0}, 5, 5, bad, view, nothing));
    }
}

TEST(CurveCoverage, RowsAreHeard) {
    struct Probe {
        double area = 0;
        int inner = 0;
        void on(const raster::CurveRow& e) {
            area += e.inner ? -2 * e.area : 2 * e.area;
            inner += e.inner;
        }
    } probe;
    ring_coverage(
        {0.3, 0.1}, 9, 9, 2, view, [](int, int, int, int) {}, probe);
    EXPECT_NEAR(probe.area, double(2 * pi * 9 * 2), 1e-6);
    EXPECT_EQ(probe.inner, 17);
}

}  // namespace
}  // namespace relevo::tests
