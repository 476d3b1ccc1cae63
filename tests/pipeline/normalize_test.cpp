#include "pipeline/normalize.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/hard.hpp"

namespace relevo::pipeline {
namespace {

namespace hard = tests::hard;

constexpr Scalar inf = std::numeric_limits<Scalar>::infinity(),
                 nan_of = std::numeric_limits<Scalar>::quiet_NaN(), most = std::numeric_limits<Scalar>::max(),
                 least = std::numeric_limits<Scalar>::denorm_min();

double worst_component(const Vec3& v, const Vec3& got) {
    const long double x = v.x, y = v.y, z = v.z, length = std::sqrt(x * x + y * y + z * z);
    return static_cast<double>(std::max(
               {std::abs(got.x - x / length), std::abs(got.y - y / length), std::abs(got.z - z / length)})) /
           std::numeric_limits<Scalar>::epsilon();
}

TEST(Normalize, AnyFiniteVectorGetsLengthOne) {
    hard::Random r(1);
    double worst = 0;
    for (int i = 0; i < 200'000; ++i) {
        const auto any = [&] {
            return static_cast<Scalar>(i % 2 ? static_cast<double>(r.any_finite_float()) : r.between(-1, 1));
        };
        const Vec3 v{any(), any(), any()};
        if (v == Vec3(0, 0, 0)) continue;
        worst = std::max(worst, worst_component(v, normalize(v)));
    }
    EXPECT_LT(worst, 3) << "ulp of 1";
}

TEST(Normalize, TheExtremes) {
    EXPECT_EQ(normalize({0, 0, 0}), Vec3(0, 0, 0));
    EXPECT_EQ(normalize({Scalar(-0.0), 0, 0}), Vec3(0, 0, 0));
    for (const Scalar s :
         {least, 3 * least, Scalar(1e-23), Scalar(1e-16), Scalar(1), Scalar(1e14), Scalar(1e20), most}) {
        EXPECT_EQ(normalize({s, 0, 0}), Vec3(1, 0, 0)) << s;
        EXPECT_EQ(normalize({0, -s, 0}), Vec3(0, -1, 0)) << s;
        EXPECT_LT(worst_component({1, 1, -1}, normalize({s, s, -s})), 3) << s;
    }
    EXPECT_LT(worst_component({1, 0, 0}, normalize({most, least, 1})), 3);
    for (const Scalar bad : {inf, -inf, nan_of}) {
        EXPECT_EQ(normalize({bad, 1, 1}), Vec3(0, 0, 0));
        EXPECT_EQ(normalize({1, bad, 1}), Vec3(0, 0, 0));
        EXPECT_EQ(normalize({1, 1, bad}), Vec3(0, 0, 0));
    }
}

// "Always scale", "never" and "when needed" are one: a power of two rounds nothing.
TEST(Normalize, ScalingFirstChangesNoBitInTheNormalRange) {
    hard::Random r(2);
    for (int i = 0; i < 100'000; ++i) {
        const double size = exp2(r.between(-45, 45));
        const auto any = [&] { return static_cast<Scalar>(size * r.between(0.01, 1) * (r.coin() ? 1 : -1)); };
        const Vec3 v{any(), any(), any()};
        ASSERT_EQ(normalize(v), normalize_extreme(v)) << v.x << " " << v.y << " " << v.z;
    }
}

TEST(Normalize, DotAndCrossAreTheContractsSums) {
    const Vec3 a{Scalar(0.1), Scalar(0.7), Scalar(-3)}, b{Scalar(5), Scalar(-0.3), Scalar(0.9)};
    EXPECT_EQ(dot(a, b), (a.x * b.x + a.y * b.y) + a.z * b.z);
    EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), Vec3(0, 0, 1));
    EXPECT_EQ(cross(a, b), -cross(b, a));
}

}  // namespace
}  // namespace relevo::pipeline
