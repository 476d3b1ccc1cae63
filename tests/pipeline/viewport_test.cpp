#include "pipeline/viewport.hpp"

#include <gtest/gtest.h>

#include "tests/support/exact_rational.hpp"
#include "tests/support/hard.hpp"

namespace relevo::pipeline {
namespace {

namespace hard = tests::hard;
using tests::exact::Rational;

HPoint<Clip> some_point(hard::Random& r) {
    const double w = exp2(r.between(-20, 20));
    return {{static_cast<Scalar>(r.between(-7, 7) * w), static_cast<Scalar>(r.between(-7, 7) * w),
             static_cast<Scalar>(r.unit() * w), static_cast<Scalar>(w)}};
}

TEST(Viewport, SnapsWithinHalfASubpixelOfTheExactPlace) {
    hard::Random r(1);
    const Viewport views[] = {{1, 1}, {640, 480}, {641, 479}, {8192, 8192}};
    for (int i = 0; i < 20'000; ++i) {
        const Viewport view = views[i % 4];
        const HPoint<Clip> p = some_point(r);
        const SnappedCorner got = to_window(p, view);
        const Rational x = (Rational(p.v.x) / Rational(p.v.w) + 1) * (128 * view.width),
                       y = (1 - Rational(p.v.y) / Rational(p.v.w)) * (128 * view.height);
        ASSERT_LE(static_cast<double>(abs(Rational(got.x) - x)), 0.5 + 1e-8) << "1/512 pixel";
        ASSERT_LE(static_cast<double>(abs(Rational(got.y) - y)), 0.5 + 1e-8);
        ASSERT_EQ(got.z, p.v.z / p.v.w);
        ASSERT_EQ(got.rw, 1 / p.v.w);
    }
}

TEST(Viewport, TiesGoToEven) {
    const Viewport view{1024, 1024};  // one subpixel is 2^-17 of ndc: all of this is exact
    const auto at = [&](double subpixels) {
        const auto ndc = static_cast<Scalar>(subpixels * 0x1p-17 - 1);
        return to_window({{ndc, -ndc, 0, 1}}, view);
    };
    for (int k = -2000; k < 2000; ++k) {
        EXPECT_EQ(at(k).x, k);
        EXPECT_EQ(at(k).y, k) << "y runs down";
        EXPECT_EQ(at(k + 0.5).x, k % 2 == 0 ? k : k + 1);
        EXPECT_EQ(at(k + 0.5).y, k % 2 == 0 ? k : k + 1);
        EXPECT_EQ(at(k + 0.49).x, k);
        EXPECT_EQ(at(k + 0.51).x, k + 1);
    }
}

TEST(Viewport, CornersOfTheVolumeAreCornersOfThePicture) {
    for (const Viewport view : {Viewport{1, 1}, Viewport{640, 480}, Viewport{8191, 3}}) {
        const SnappedCorner top_left = to_window({{-1, 1, 0, 1}}, view),
                            bottom_right = to_window({{3, -3, 0, 3}}, view);
        EXPECT_EQ(top_left.x, 0);
        EXPECT_EQ(top_left.y, 0);
        EXPECT_EQ(bottom_right.x, 256 * view.width);
        EXPECT_EQ(bottom_right.y, 256 * view.height);
    }
}

TEST(Viewport, TheGuardBandStaysWithin2To23) {
    const Viewport view{max_picture_size, max_picture_size};
    for (const Scalar w : {Scalar(1), Scalar(0.3), Scalar(1e-30), Scalar(1e30)})
        for (const Scalar s : {Scalar(-1), Scalar(1)}) {
            const SnappedCorner c = to_window({{s * (7 * w), -s * (7 * w), w, w}}, view);
            EXPECT_LE(std::abs(c.x), 1 << 23);
            EXPECT_LE(std::abs(c.y), 1 << 23);
        }
}

TEST(Viewport, WholePixelsAndOrderAreKept) {
    hard::Random r(2);
    const Viewport view{256, 256};
    for (int i = 0; i < 5000; ++i) {
        const double x =
            std::ldexp(static_cast<double>(r.integer(-(1 << 20), 1 << 20)), -20);  // exact with a pixel added
        const auto at = [&](double ndc) { return to_window({{static_cast<Scalar>(ndc), 0, 0, 1}}, view).x; };
        const auto pixels = static_cast<int>(r.integer(-100, 100));
        EXPECT_EQ(at(x + pixels / 128.0), at(x) + 256 * pixels);
        EXPECT_LE(at(x), at(x + std::ldexp(1.0, -20)));
    }
}

TEST(Viewport, TheDivisionAloneGivesTheSameDepth) {
    hard::Random r(3);
    for (int i = 0; i < 5000; ++i) {
        const HPoint<Clip> p = some_point(r);
        const Divided d = perspective_divide(p);
        const SnappedCorner c = to_window(p, {512, 512});
        EXPECT_EQ(d.ndc.v.z, c.z);
        EXPECT_EQ(d.rw, c.rw);
        EXPECT_NEAR((static_cast<double>(d.ndc.v.x) + 1) * 65536, c.x, 1.1);
    }
}

}  // namespace
}  // namespace relevo::pipeline
