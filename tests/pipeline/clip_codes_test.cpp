#include "pipeline/clip_codes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/hard.hpp"

namespace relevo::pipeline {
namespace {

namespace hard = tests::hard;

constexpr Scalar inf = std::numeric_limits<Scalar>::infinity(),
                 nan_of = std::numeric_limits<Scalar>::quiet_NaN(),
                 least = std::numeric_limits<Scalar>::denorm_min(), most = std::numeric_limits<Scalar>::max();

ClipCodes codes(Scalar x, Scalar y, Scalar z, Scalar w, Scalar side = guard_band) {
    return clip_codes(HPoint<Clip>{{x, y, z, w}}, side);
}

TEST(ClipCodes, OnePlaneOneBit) {
    EXPECT_EQ(codes(0, 0, Scalar(0.5), 1), 0);
    EXPECT_EQ(codes(0, 0, Scalar(1.5), 1), code_z_high);
    EXPECT_EQ(codes(0, 0, Scalar(-0.5), 1), code_z_low);
    EXPECT_EQ(codes(-8, 0, Scalar(0.5), 1), code_x_low);
    EXPECT_EQ(codes(8, 0, Scalar(0.5), 1), code_x_high);
    EXPECT_EQ(codes(0, -8, Scalar(0.5), 1), code_y_low);
    EXPECT_EQ(codes(0, 8, Scalar(0.5), 1), code_y_high);
    EXPECT_EQ(codes(8, -8, Scalar(1.5), 1), code_x_high | code_y_low | code_z_high);
    EXPECT_EQ(codes(Scalar(1.5), 0, Scalar(0.5), 1, 1), code_x_high) << "the view volume itself";
}

TEST(ClipCodes, OnAPlaneIsInside) {
    for (const Scalar w : {Scalar(1), Scalar(0.3), Scalar(1e-30), Scalar(1e30)})
        for (const Scalar s : {Scalar(-1), Scalar(1)}) {
            EXPECT_EQ(codes(s * (7 * w), s * (7 * w), 0, w), 0);
            EXPECT_EQ(codes(s * (7 * w), s * (7 * w), w, w), 0);
            EXPECT_NE(codes(s * std::nextafter(7 * w, inf), 0, 0, w), 0);
        }
    EXPECT_EQ(codes(0, 0, Scalar(-0.0), 1), 0);
    EXPECT_EQ(codes(0, 0, std::nextafter(Scalar(1), inf), 1), code_z_high);
    EXPECT_EQ(codes(0, 0, -least, 1), code_z_low);
}

TEST(ClipCodes, BehindTheEyeIsBeyondAPlane) {
    hard::Random r(1);
    for (int i = 0; i < 10'000; ++i) {
        const auto any = [&] { return static_cast<Scalar>(r.any_finite_float()); };
        EXPECT_NE(codes(any(), any(), any(), -std::abs(any())), 0);
    }
}

TEST(ClipCodes, TheEyeItselfHasACodeOfItsOwn) {
    EXPECT_EQ(codes(0, 0, 0, 0), code_origin);
    EXPECT_EQ(codes(Scalar(-0.0), 0, 0, Scalar(-0.0)), code_origin);
    EXPECT_EQ(codes(1, 0, 0, 0), code_x_high);
}

TEST(ClipCodes, WhatIsNotFiniteIsNamed) {
    for (const Scalar bad : {nan_of, inf, -inf}) {
        EXPECT_EQ(codes(bad, 0, 0, 1), code_non_finite);
        EXPECT_EQ(codes(0, bad, 0, 1), code_non_finite);
        EXPECT_EQ(codes(0, 0, bad, 1), code_non_finite);
        EXPECT_EQ(codes(0, 0, 0, bad), code_non_finite);
    }
    EXPECT_EQ(codes(0, 0, 0, least), code_non_finite) << "1/w would be infinite";
    EXPECT_EQ(codes(0, 0, 0, most), 0);
    EXPECT_EQ(codes(most, most, most, most), 0) << "7 w may overflow: nothing lies beyond";
}

// Without a code, division and snapping are safe.
TEST(ClipCodes, WithoutACodeTheDivisionIsInRange) {
    hard::Random r(2);
    int without = 0;
    for (int i = 0; i < 200'000; ++i) {
        const auto any = [&] { return static_cast<Scalar>(r.any_finite_float()); };
        const Vec4 p{any(), any(), std::abs(any()), std::abs(any())};
        if (clip_codes(HPoint<Clip>{p}) != 0) continue;
        ++without;
        ASSERT_GT(p.w, 0);
        ASSERT_TRUE(std::isfinite(1 / p.w));
        ASSERT_LE(std::abs(static_cast<double>(p.x) / static_cast<double>(p.w)), 7.000001);
        ASSERT_LE(p.z / p.w, 1);
        ASSERT_GE(p.z / p.w, 0);
    }
    EXPECT_GT(without, 1000);
}

}  // namespace
}  // namespace relevo::pipeline
