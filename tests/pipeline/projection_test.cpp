#include "pipeline/projection.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/exact_rational.hpp"
#include "tests/support/hard.hpp"

namespace relevo::pipeline {
namespace {

namespace hard = tests::hard;
using tests::exact::Rational;

constexpr double inf = std::numeric_limits<double>::infinity(),
                 nan_of = std::numeric_limits<double>::quiet_NaN();

// The image of an eye-space point under the matrix rounded to Scalar, without any further rounding.
struct Ndc3 {
    Rational x, y, z;
};
Ndc3 exact_ndc(const Projective<Clip, Eye>& map, double x, double y, double z) {
    const auto m = rounded(map);
    Rational clip[4];
    for (int r = 0; r < 4; ++r)
        clip[r] = Rational(m.row[r][0]) * Rational(x) + Rational(m.row[r][1]) * Rational(y) +
                  Rational(m.row[r][2]) * Rational(z) + Rational(m.row[r][3]);
    return {clip[0] / clip[3], clip[1] / clip[3], clip[2] / clip[3]};
}
double far_from(const Rational& got, double right) { return static_cast<double>(abs(got - Rational(right))); }

constexpr double u = std::numeric_limits<Scalar>::epsilon() / 2;

void expect_corners(const Projective<Clip, Eye>& map, const double (&window)[4], double near, double far,
                    bool perspective, DepthRange range) {
    const double at_near = range == DepthRange::Reversed ? 1 : 0;
    for (const double d : {near, far}) {
        if (std::isinf(d)) continue;
        const double k = perspective ? d / near : 1;
        for (const int i : {0, 1})
            for (const int j : {2, 3}) {
                const Ndc3 p = exact_ndc(map, window[i] * k, window[j] * k, -d);
                const double ratio =
                    std::max({std::abs((window[0] + window[1]) / (window[1] - window[0])),
                              std::abs((window[2] + window[3]) / (window[3] - window[2])), 1.0});
                EXPECT_LE(far_from(p.x, i == 0 ? -1 : 1), 4 * u * (1 + ratio));
                EXPECT_LE(far_from(p.y, j == 2 ? -1 : 1), 4 * u * (1 + ratio));
                // the two numbers of the depth row are f / (f - n) and n / (f - n) large, and rounded
                const double depth_scale = (std::abs(near) + std::abs(far)) / (far - near);
                EXPECT_LE(far_from(p.z, d == near ? at_near : 1 - at_near), 4 * u * depth_scale);
            }
    }
}

TEST(Projection, CornersOfTheFrustumAreCornersOfTheVolume) {
    hard::Random r(1);
    for (int i = 0; i < 300; ++i) {
        const double near = exp2(r.between(-8, 4)), far = near * (1 + exp2(r.between(-3, 20)));
        const double window[4] = {r.between(-2, 0), r.between(0.1, 2), r.between(-2, 0), r.between(0.1, 2)};
        for (const DepthRange range : {DepthRange::Reversed, DepthRange::Forward}) {
            const auto f = frustum(window[0], window[1], window[2], window[3], near, far, range);
            ASSERT_TRUE(f);
            expect_corners(*f, window, near, far, true, range);
            const auto o = orthographic(window[0], window[1], window[2], window[3], near, far, range);
            ASSERT_TRUE(o);
            expect_corners(*o, window, near, far, false, range);
            const double fov = r.between(1, 170), aspect = r.between(0.2, 5),
                         top = near * tan(Degrees{fov / 2});
            const auto p = perspective(Degrees{fov}, aspect, near, far, range);
            ASSERT_TRUE(p);
            expect_corners(*p, {-top * aspect, top * aspect, -top, top}, near, far, true, range);
        }
    }
}

TEST(Projection, InfiniteFarIsExactAtBothEnds) {
    for (const double near : {0.1, 1.0, 1e-6, 3.7, 1e6}) {
        const auto n = static_cast<Scalar>(near);
        const auto reversed = rounded(*perspective({60}, 1, near, inf, DepthRange::Reversed));
        const HPoint<Clip> at_near = reversed * Point<Eye>{{0, 0, -n}};
        EXPECT_EQ(at_near.v.z / at_near.v.w, 1);
        // a direction is a point at infinity
        EXPECT_EQ(row_times_direction(reversed.row[2], {0, 0, -1}), 0);
        EXPECT_GT(row_times_direction(reversed.row[3], {0, 0, -1}), 0);
        const auto forward = rounded(*perspective({60}, 1, near, inf, DepthRange::Forward));
        const HPoint<Clip> forward_near = forward * Point<Eye>{{0, 0, -n}};
        EXPECT_EQ(forward_near.v.z / forward_near.v.w, 0);
        EXPECT_EQ(row_times_direction(forward.row[2], {0, 0, -1}),
                  row_times_direction(forward.row[3], {0, 0, -1}));
    }
}

TEST(Projection, DepthIsMonotoneBetweenNeighbouringFloats) {
    hard::Random r(2);
    for (const double far : {1e4, inf}) {
        const auto m = rounded(*perspective({60}, 1, 0.1, far, DepthRange::Reversed));
        const auto depth = [&](Scalar distance) {
            const HPoint<Clip> p = m * Point<Eye>{{0, 0, -distance}};
            return p.v.z / p.v.w;
        };
        for (int i = 0; i < 10'000; ++i) {
            const auto d = static_cast<Scalar>(0.1 * exp2(r.between(0, 16)));
            EXPECT_GE(depth(d), depth(std::nextafter(d, std::numeric_limits<Scalar>::infinity()))) << d;
            EXPECT_LE(depth(d), 1 + 4 * u);
        }
        for (const auto& [a, b] : {std::pair{0.2, 0.2000001}, {1000.0, 1000.001}})
            EXPECT_GT(depth(static_cast<Scalar>(a)), depth(static_cast<Scalar>(b)));
    }
}

TEST(Projection, PerspectiveIsTheCentredFrustum) {
    const auto a = perspective({90}, 2, 0.5, 100, DepthRange::Reversed),
               b = frustum(-1, 1, -0.5, 0.5, 0.5, 100, DepthRange::Reversed);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) EXPECT_DOUBLE_EQ((*a).m[c][r], (*b).m[c][r]);
}

template <class T>
void expect_error(const Result<T>& result, const char* named) {
    ASSERT_FALSE(result) << named;
    EXPECT_NE(result.error().message.find(named), std::string::npos) << result.error().message;
}

TEST(Projection, WhatIsNoCameraIsRefusedByName) {
    const DepthRange d = DepthRange::Reversed;
    for (const double fov : {0.0, 180.0, -1.0, 360.0, nan_of, inf})
        expect_error(perspective({fov}, 1, 0.1, 10, d), "fov_y");
    for (const double aspect : {0.0, -1.0, nan_of, inf})
        expect_error(perspective({60}, aspect, 0.1, 10, d), "aspect");
    for (const double near : {0.0, -1.0, nan_of, inf}) {
        expect_error(perspective({60}, 1, near, inf, d), "near");
        expect_error(frustum(-1, 1, -1, 1, near, 10, d), "near");
    }
    for (const double far : {0.1, 0.05, -1.0, nan_of}) expect_error(perspective({60}, 1, 0.1, far, d), "far");
    for (const auto& [a, b] : {std::pair{1.0, 1.0}, {2.0, 1.0}, {nan_of, 1.0}, {0.0, inf}, {-inf, 0.0}}) {
        expect_error(frustum(a, b, -1, 1, 0.1, 10, d), "left");
        expect_error(frustum(-1, 1, a, b, 0.1, 10, d), "bottom");
        expect_error(orthographic(a, b, -1, 1, 0.1, 10, d), "left");
        expect_error(orthographic(-1, 1, a, b, 0.1, 10, d), "bottom");
        expect_error(orthographic(-1, 1, -1, 1, a, b, d), "near");
    }
    if constexpr (sizeof(Scalar) == 4) {
        expect_error(perspective({60}, 1, 1e-50, inf, d), "near");  // 0 once it is rounded
    }
    EXPECT_TRUE(orthographic(-1, 1, -1, 1, -5, 5, d)) << "a box may lie behind the eye, too";
    expect_error(perspective({1e-300}, 1e-300, 0.1, 10, d), "range");
    expect_error(orthographic(0, 1e-320, -1, 1, 0, 1, d), "range");
}

}  // namespace
}  // namespace relevo::pipeline
