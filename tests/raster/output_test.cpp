#include "raster/output.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

namespace relevo::raster {
namespace {

using Number = boost::multiprecision::cpp_bin_float_50;

// IEC 61966-2-1: the linear light of the sRGB value s.
Number light_of(const Number& s) {
    return s <= Number("0.04045") ? Number(s / Number("12.92"))
                                  : Number(pow((s + Number("0.055")) / Number("1.055"), Number("2.4")));
}

TEST(Output, EachThresholdIsTheFirstFloatBeyondItsHalfCode) {
    EXPECT_EQ(srgb_thresholds[0], 0);
    for (int k = 1; k < 256; ++k) {
        const Number border = light_of((Number(k) - Number(0.5)) / 255);
        const float t = srgb_thresholds[k], below = std::nextafter(t, 0.0f);
        EXPECT_GE(Number(t), border) << k;
        EXPECT_LT(Number(below), border) << k;
    }
}

TEST(Output, NeighboursOfEachThresholdGetTheirCodes) {
    for (int k = 1; k < 256; ++k) {
        const Scalar t = static_cast<Scalar>(srgb_thresholds[k]);
        EXPECT_EQ(to_srgb8(t), k);
        EXPECT_EQ(to_srgb8(std::nextafter(t, Scalar(2))), k);
        EXPECT_EQ(to_srgb8(std::nextafter(t, Scalar(0))), k - 1);
    }
}

TEST(Output, SrgbIsMonotoneAndEveryCodeIsReached) {
    int last = 0, codes = 1;
    for (int i = 0; i <= 1'000'000; ++i) {
        const int code = to_srgb8(static_cast<Scalar>(i * 1e-6));
        ASSERT_TRUE(code == last || code == last + 1) << "at " << i * 1e-6;
        codes += code != last;
        last = code;
    }
    EXPECT_EQ(codes, 256);
}

TEST(Output, DecodedCodesAreTheNearestSteps) {
    for (int k = 0; k < 256; ++k) {
        const Number exact = light_of(Number(k) / 255) * 65535;
        EXPECT_LE(abs(Number(srgb_decoded[k]) - exact), Number(0.5)) << k;
        EXPECT_EQ(to_srgb8(static_cast<Scalar>(srgb_decoded[k]) * Scalar(1.0 / 65535)), k)
            << "back to the same code";
    }
}

TEST(Output, RawRoundsToNearestAndClamps) {
    for (int k = 0; k < 256; ++k) {
        EXPECT_EQ(to_raw8(static_cast<Scalar>(k / 255.0)), k);
        EXPECT_EQ(to_raw8(static_cast<Scalar>((k + 0.49) / 255.0)), k);
        if (k > 0) {
            EXPECT_EQ(to_raw8(static_cast<Scalar>((k - 0.49) / 255.0)), k);
        }
    }
}

TEST(Output, DisplayableLightNeedsNoClamp) {
    const auto unclamped = [](Scalar c) { return raw_code<Scalar, Light::Displayable>(c); };
    const Scalar beyond = Scalar(0x1p-20);
    for (Scalar c = beyond; c > Scalar(1e-30); c *= Scalar(0.999)) ASSERT_EQ(unclamped(-c), 0) << c;
    for (Scalar c = beyond; c > Scalar(1e-9); c *= Scalar(0.999)) ASSERT_EQ(unclamped(1 + c), 255) << c;
    for (int k = 0; k <= 1'000'000; ++k)
        ASSERT_EQ(unclamped(Scalar(k * 1e-6)), raw_code(Scalar(k * 1e-6))) << k;
}

TEST(Output, WhatIsNoColourHasADefinedCode) {
    constexpr Scalar inf = std::numeric_limits<Scalar>::infinity(),
                     nan = std::numeric_limits<Scalar>::quiet_NaN(),
                     most = std::numeric_limits<Scalar>::max(),
                     least = std::numeric_limits<Scalar>::denorm_min();
    for (const auto code : {to_srgb8, +[](Scalar c) { return to_raw8(c); }}) {
        for (const Scalar c : {nan, -nan, -inf, -most, Scalar(-1), Scalar(-0.0), Scalar(0), least})
            EXPECT_EQ(code(c), 0) << c;
        for (const Scalar c : {Scalar(1), std::nextafter(Scalar(1), Scalar(2)), Scalar(255), most, inf})
            EXPECT_EQ(code(c), 255) << c;
        EXPECT_EQ(code(std::nextafter(Scalar(1), Scalar(0))), 255);
    }
    EXPECT_EQ(to_rgba8({nan, inf, Scalar(0.5)}, Output::Raw), (Rgba8{0, 255, 128, 255}));
    EXPECT_EQ(to_rgba8({nan, inf, Scalar(0.5)}, Output::Srgb), (Rgba8{0, 255, 188, 255}));
}

}  // namespace
}  // namespace relevo::raster
