#include "pipeline/elementary.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdio>
#include <limits>

#include "tests/support/hard.hpp"

namespace relevo::pipeline {
namespace {

namespace hard = tests::hard;
namespace mp = boost::multiprecision;
using Number = mp::cpp_bin_float_50;

const Number radians_of_a_degree =
    Number("3.14159265358979323846264338327950288419716939937510582097494459") / 180;
constexpr double inf = std::numeric_limits<double>::infinity(),
                 nan_of = std::numeric_limits<double>::quiet_NaN();

double far_from(double got, const Number& right) { return static_cast<double>(mp::abs(Number(got) - right)); }

// Angles of all sizes, and close to the multiples of 45 degrees.
double some_angle(hard::Random& r, int i) {
    switch (i % 4) {
        case 0:
            return r.between(-360, 360);
        case 1:
            return 45.0 * static_cast<double>(r.integer(-16, 16)) +
                   r.between(-1, 1) * exp2(-r.between(0, 50));
        case 2:
            return r.between(-1, 1) * exp2(r.between(-40, 40));
        default:
            return static_cast<double>(r.integer(-720, 720));
    }
}

TEST(Elementary, SineAndCosineAreWithinOneUlpOfOne) {
    hard::Random r(1);
    double worst_sin = 0, worst_cos = 0, worst_tan = 0;
    for (int i = 0; i < hard::cases(20'000); ++i) {
        const double a = some_angle(r, i);
        const Number x = mp::fmod(Number(a), Number(360)) * radians_of_a_degree;  // fmod of doubles is exact
        const Number s = mp::sin(x), c = mp::cos(x);
        worst_sin = std::max(worst_sin, far_from(sin(Degrees{a}), s));
        worst_cos = std::max(worst_cos, far_from(cos(Degrees{a}), c));
        if (mp::abs(c) > Number(1e-3))
            worst_tan = std::max(
                worst_tan, far_from(tan(Degrees{a}), s / c) / (1 + static_cast<double>(mp::abs(s / c)) *
                                                                       static_cast<double>(1 / mp::abs(c))));
    }
    std::printf("sin %.3f, cos %.3f x 2^-53\n", worst_sin * 0x1p53, worst_cos * 0x1p53);
    EXPECT_LE(worst_sin, 0x1p-52);
    EXPECT_LE(worst_cos, 0x1p-52);
    EXPECT_LE(worst_tan, 0x1p-50);
}

TEST(Elementary, QuarterTurnsAreExact) {
    for (int k = -4000; k <= 4000; ++k) {
        const Degrees a{90.0 * k};
        const int quarter = ((k % 4) + 4) % 4;
        EXPECT_EQ(sin(a), (std::array{0, 1, 0, -1}[std::size_t(quarter)])) << a.value;
        EXPECT_EQ(cos(a), (std::array{1, 0, -1, 0}[std::size_t(quarter)])) << a.value;
        if (quarter % 2) {
            EXPECT_TRUE(std::isinf(tan(a)));
        } else {
            EXPECT_EQ(tan(a), 0);
        }
    }
    EXPECT_NEAR(tan(Degrees{45}), 1, 0x1p-52);
    for (const double a : {inf, -inf, nan_of})
        EXPECT_TRUE(std::isnan(sin(Degrees{a})) && std::isnan(cos(Degrees{a})));
    hard::Random r(2);
    for (int i = 0; i < 2000; ++i) {
        const double a = some_angle(r, i);
        if (std::fmod(a, 45) == 0) continue;  // the border between sine and cosine: their last bits differ
        EXPECT_EQ(sin(Degrees{-a}), -sin(Degrees{a}));
        EXPECT_EQ(cos(Degrees{-a}), cos(Degrees{a}));
        EXPECT_LE(std::abs(sin(Degrees{a})), 1);
        EXPECT_LE(std::abs(cos(Degrees{a})), 1);
    }
}

TEST(Elementary, TheAngleOfADirectionIsWithinItsError) {
    hard::Random r(8);
    double worst = 0;
    for (int i = 0; i < hard::cases(20'000); ++i) {
        const double size = exp2(r.between(-300, 300)), flat = i % 2 ? 1 : exp2(-r.between(0, 60));
        const double x = size * r.between(-1, 1), y = size * flat * r.between(-1, 1);
        worst = std::max(
            worst, far_from(angle_of(x, y).value, mp::atan2(Number(y), Number(x)) / radians_of_a_degree));
        EXPECT_EQ(angle_of(x, -y).value, -angle_of(x, y).value);
    }
    std::printf("direction: %.3f x 2^-44 degrees\n", worst * 0x1p44);
    EXPECT_LE(worst, 0x1p-44);
    for (const double size : {1e-300, 1.0, 1e300}) {
        EXPECT_EQ(angle_of(size, 0).value, 0);
        EXPECT_EQ(angle_of(0, size).value, 90);
        EXPECT_EQ(angle_of(-size, 0).value, 180);
        EXPECT_EQ(angle_of(0, -size).value, -90);
        EXPECT_NEAR(angle_of(-size, -size).value, -135, 1e-13);
    }
    EXPECT_EQ(angle_of(0, 0).value, 0);
    EXPECT_TRUE(std::isnan(angle_of(inf, 1).value) && std::isnan(angle_of(1, nan_of).value));
}

TEST(Elementary, LogarithmIsWithinItsError) {
    hard::Random r(3);
    double worst = 0;
    for (int i = 0; i < hard::cases(20'000); ++i) {
        double x = std::bit_cast<double>(r.bits() & 0x7FFFFFFFFFFFFFFF);
        if (i % 3 == 0) x = 1 + r.between(-1, 1) * std::ldexp(1.0, -static_cast<int>(r.integer(1, 50)));
        if (!std::isfinite(x) || x == 0 || x == 1) continue;
        const Number right = mp::log(Number(x)) / mp::log(Number(2));
        worst = std::max(worst, far_from(log2(x), right) / static_cast<double>(mp::abs(right)));
    }
    std::printf("log2 %.3f x 2^-53, relative\n", worst * 0x1p53);
    EXPECT_LT(worst, 0x1p-50);
    for (int e = -1074; e < 1024; ++e) EXPECT_EQ(log2(std::ldexp(1.0, e)), e);
    EXPECT_EQ(log2(0), -inf);
    EXPECT_EQ(log2(-0.0), -inf);
    EXPECT_EQ(log2(inf), inf);
    EXPECT_TRUE(std::isnan(log2(-1)) && std::isnan(log2(nan_of)) && std::isnan(log2(-inf)));
}

TEST(Elementary, Exp2IsWithinItsError) {
    hard::Random r(4);
    double worst = 0;
    for (int i = 0; i < hard::cases(20'000); ++i) {
        const double x = i % 2 ? r.between(-1000, 1000) : r.between(-2, 2);
        const Number right = mp::exp(Number(x) * mp::log(Number(2)));
        worst = std::max(worst, static_cast<double>(mp::abs(Number(exp2(x)) / right - 1)));
    }
    std::printf("exp2 %.3f x 2^-53, relative\n", worst * 0x1p53);
    EXPECT_LT(worst, 0x1p-50);
    for (int e = -1074; e < 1024; ++e) EXPECT_EQ(exp2(e), std::ldexp(1.0, e));
    EXPECT_EQ(exp2(-1e300), 0);
    EXPECT_EQ(exp2(-inf), 0);
    EXPECT_EQ(exp2(1e300), inf);
    EXPECT_EQ(exp2(inf), inf);
    EXPECT_EQ(exp2(1024), inf);
    EXPECT_TRUE(std::isnan(exp2(nan_of)));
}

TEST(Elementary, PowersAreWithinTheirErrors) {
    constexpr double ulp = std::numeric_limits<Scalar>::epsilon() / 2;
    hard::Random r(5);
    double worst_integer = 0, worst_general = 0;
    for (int i = 0; i < hard::cases(20'000); ++i) {
        const auto x = static_cast<Scalar>(r.unit());
        const bool integer = i % 2 != 0;
        const auto n =
            static_cast<Scalar>(integer ? static_cast<double>(r.integer(1, 128)) : r.between(0, 300));
        const Number right = mp::pow(Number(x), Number(n));
        if (right < Number(std::numeric_limits<Scalar>::min())) continue;
        const double error = static_cast<double>(mp::abs(Number(power(x, n)) / right - 1)) / ulp;
        if (integer)
            worst_integer = std::max(worst_integer, error / static_cast<double>(n));
        else
            worst_general = std::max(worst_general, error);
    }
    std::printf("power: integer n %.3f n u, any n %.3f u, relative\n", worst_integer, worst_general);
    EXPECT_LE(worst_integer, 2);
    EXPECT_LE(worst_general, sizeof(Scalar) == 4 ? 1.01 : 4000.0)
        << "one rounding; in double the error of exp2(n log2 x) shows";
}

TEST(Elementary, PowerHasNoLightFromBehind) {
    constexpr Scalar scalar_nan = std::numeric_limits<Scalar>::quiet_NaN();
    for (const Scalar n :
         {Scalar(0), Scalar(0.5), Scalar(1), Scalar(32), Scalar(128), Scalar(129), Scalar(1e30)}) {
        for (const Scalar x : {Scalar(0), Scalar(-0.0), Scalar(-0.5), Scalar(-1), scalar_nan})
            EXPECT_EQ(power(x, n), 0) << x << "^" << n;
        EXPECT_EQ(power(Scalar(1), n), 1);
        const Scalar above = power(std::nextafter(Scalar(1), Scalar(2)), n);
        EXPECT_GE(above, 1);
        EXPECT_LT(above, Scalar(1.001)) << "a cosine that rounding took beyond 1 does no harm";
    }
    EXPECT_EQ(power(Scalar(0.3), Scalar(0)), 1);
    EXPECT_EQ(power(Scalar(0.3), Scalar(1)), Scalar(0.3));
    const Scalar least = std::numeric_limits<Scalar>::min();  // the least normal number, 2^-126 in float
    const int digits = 1 - std::numeric_limits<Scalar>::min_exponent;
    EXPECT_EQ(power(Scalar(0.5), static_cast<Scalar>(digits)), least);
    EXPECT_EQ(power(Scalar(0.5), static_cast<Scalar>(digits + 1)), 0) << "no denormal numbers";
    EXPECT_EQ(power(least, Scalar(1)), least);
    EXPECT_EQ(power(least / 2, Scalar(1)), 0);
    EXPECT_EQ(power(Scalar(0.5), digits + Scalar(0.5)), 0) << "any exponent";
    EXPECT_EQ(power(std::numeric_limits<Scalar>::denorm_min(), Scalar(0)), 1);
    EXPECT_EQ(power(Scalar(1), std::numeric_limits<Scalar>::max()), 1);
    // the order of the products is part of the promise: 5 = 101: square, square, times x
    const Scalar x = Scalar(0.7), square = x * x, fourth = square * square;
    EXPECT_EQ(power(x, Scalar(5)), fourth * x);
    EXPECT_EQ(power(x, Scalar(6)), (square * x) * (square * x));
}

// Any compiler, any optimisation, any processor: the same bits.
std::uint64_t hash_of(std::uint64_t hash, double v) {
    return (hash ^ std::bit_cast<std::uint64_t>(v)) * 0x100000001B3u + (hash >> 29);
}

TEST(Elementary, TheBitsAreTheSameEverywhere) {
    hard::Random r(6);
    std::uint64_t h[5] = {1, 2, 3, 4, 5};
    for (int i = 0; i < 100'000; ++i) {
        const auto digits = static_cast<double>(r.integer(-(1 << 30), 1 << 30));
        const double angle = std::ldexp(digits, -static_cast<int>(r.integer(10, 24)));
        const double x = r.unit(), y = r.between(-200, 200);
        h[0] = hash_of(h[0], sin(Degrees{angle}));
        h[1] = hash_of(h[1], cos(Degrees{angle}));
        h[2] = hash_of(h[2], log2(x));
        h[3] = hash_of(h[3], exp2(y));
        h[4] = hash_of(h[4], static_cast<double>(power(static_cast<Scalar>(x),
                                                       static_cast<Scalar>(i % 3 ? i % 128 + 1 : x * 100))));
    }
    constexpr std::uint64_t pinned[4] = {15622051356894610568u, 10518913414764706667u, 1434060753988956658u,
                                         2086702079512479199u};
    constexpr std::uint64_t pinned_power = sizeof(Scalar) == 4 ? 17092629165147858156u : 176343369517302531u;
    const char* const names[4] = {"sin", "cos", "log2", "exp2"};
    for (int i = 0; i < 4; ++i) EXPECT_EQ(h[i], pinned[i]) << names[i];
    EXPECT_EQ(h[4], pinned_power) << "power";
}

}  // namespace
}  // namespace relevo::pipeline
