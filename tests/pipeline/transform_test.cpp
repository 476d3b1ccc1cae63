#include "pipeline/transform.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "pipeline/normalize.hpp"
#include "tests/support/hard.hpp"

namespace relevo::pipeline {
namespace {

namespace hard = tests::hard;

constexpr double inf = std::numeric_limits<double>::infinity(),
                 nan_of = std::numeric_limits<double>::quiet_NaN();

glm::dvec3 apply(const glm::dmat4& m, glm::dvec3 p) { return glm::dvec3(m * glm::dvec4(p, 1)); }
double length_of(glm::dvec3 v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }
double dot_of(glm::dvec3 a, glm::dvec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
glm::dvec3 some_vector(hard::Random& r) { return {r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)}; }

TEST(Transform, TranslatesScalesAndTurnsByTheRightHandRule) {
    EXPECT_EQ(apply(translate<World>({1, 2, 3}).m, {1, 1, 1}), glm::dvec3(2, 3, 4));
    EXPECT_EQ(apply(scale<World>({1, -2, 3}).m, {1, 1, 1}), glm::dvec3(1, -2, 3));
    EXPECT_EQ(apply((*rotate<World>({0, 0, 5}, {90})).m, {1, 0, 0}), glm::dvec3(0, 1, 0)) << "exactly";
    EXPECT_EQ(apply((*rotate<World>({1, 0, 0}, {90})).m, {0, 1, 0}), glm::dvec3(0, 0, 1));
    EXPECT_EQ(apply((*rotate<World>({0, 1, 0}, {90})).m, {0, 0, 1}), glm::dvec3(1, 0, 0));
    EXPECT_EQ(apply((*rotate<World>({0, 0, 1}, {-270})).m, {1, 0, 0}), glm::dvec3(0, 1, 0));
    const auto first_scale = translate<World>({1, 0, 0}) * scale<World>({2, 2, 2});
    EXPECT_EQ(apply(first_scale.m, {1, 1, 1}), glm::dvec3(3, 2, 2)) << "the right one first";
}

TEST(Transform, RotationsKeepLengthsAndTheirAxis) {
    hard::Random r(1);
    for (int i = 0; i < 5000; ++i) {
        const double size = exp2(r.between(-1000, 1000));
        const glm::dvec3 axis = some_vector(r), p = some_vector(r);
        const auto turn = rotate<World>(axis * size, {r.between(-720, 720)});
        ASSERT_TRUE(turn);
        ASSERT_NEAR(length_of(apply((*turn).m, p)), length_of(p), 1e-14);
        ASSERT_LT(length_of(apply((*turn).m, axis) - axis), 1e-14) << "an axis of any length: " << size;
        ASSERT_FALSE(is_mirrored((*turn).m));
    }
    EXPECT_FALSE(rotate<World>({0, 0, 0}, {1}));
    EXPECT_FALSE(rotate<World>({nan_of, 0, 0}, {1}));
    EXPECT_FALSE(rotate<World>({inf, 0, 0}, {1}));
    EXPECT_FALSE(rotate<World>({1, 0, 0}, {inf}));
    EXPECT_FALSE(rotate<World>({1, 0, 0}, {nan_of}));
}

TEST(Transform, TheEyeLooksDownMinusZ) {
    hard::Random r(2);
    for (int i = 0; i < 5000; ++i) {
        const double size = exp2(r.between(-30, 30));
        const glm::dvec3 eye = size * some_vector(r), target = size * some_vector(r),
                         up = some_vector(r) * exp2(r.between(-500, 500));
        const auto map = look_at(eye, target, up);
        ASSERT_TRUE(map);
        const double distance = length_of(target - eye), tolerance = 1e-13 * size;
        const glm::dvec3 origin = apply((*map).m, eye), ahead = apply((*map).m, target);
        ASSERT_LT(length_of(origin), tolerance);
        ASSERT_LT(length_of(ahead - glm::dvec3(0, 0, -distance)), 4 * tolerance);
        const glm::dmat3 m((*map).m);
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) ASSERT_NEAR(dot_of(m[a], m[b]), a == b, 1e-10) << "orthonormal";
        const double largest = std::max({std::abs(up.x), std::abs(up.y), std::abs(up.z)});
        const glm::dvec3 above = m * (up / largest);
        ASSERT_NEAR(above.x, 0, 1e-10);
        ASSERT_GE(above.y, 0) << "up is upwards in the picture";
        ASSERT_FALSE(is_mirrored((*map).m));
    }
}

TEST(Transform, ACameraWithoutDirectionIsRefused) {
    const glm::dvec3 o{0, 0, 0}, z{0, 0, -1};
    EXPECT_TRUE(look_at(o, z, {0, 1, 0}));
    EXPECT_TRUE(look_at(o, z, {0, 1e-9, 1})) << "nearly parallel is still a camera";
    const auto message = [](const auto& result) {
        return result ? std::string("accepted") : result.error().message;
    };
    EXPECT_NE(message(look_at(z, z, {0, 1, 0})).find("same point"), std::string::npos);
    EXPECT_NE(message(look_at(o, z, {0, 0, 0})).find("up is zero"), std::string::npos);
    for (const glm::dvec3 up : {glm::dvec3{0, 0, 1}, glm::dvec3{0, 0, -7}, glm::dvec3{0, 1e-13, 1}})
        EXPECT_NE(message(look_at(o, z, up)).find("parallel"), std::string::npos);
    for (const glm::dvec3 bad : {glm::dvec3{nan_of, 0, 0}, glm::dvec3{0, inf, 0}})
        for (int k = 0; k < 3; ++k)
            EXPECT_NE(message(look_at(k == 0 ? bad : o, k == 1 ? bad : z, k == 2 ? bad : glm::dvec3{0, 1, 0}))
                          .find("finite"),
                      std::string::npos);
    EXPECT_FALSE(look_at({1.7e308, 0, 0}, {-1.7e308, 0, 0}, {0, 1, 0})) << "their difference is not finite";
}

// A tangent and its normal stay at right angles under the map of each.
TEST(Transform, NormalsStayNormalToTheirTangents) {
    hard::Random r(3);
    for (int i = 0; i < 5000; ++i) {
        const double size = exp2(r.between(-63, 63));  // about 1e-19 .. 1e19
        glm::dmat4 m{1.0};
        for (int c = 0; c < 3; ++c)
            for (int k = 0; k < 3; ++k) m[c][k] = size * (r.between(-1, 1) + (c == k ? 2 : 0));
        if (r.coin()) m[0] = -m[0];
        const glm::dvec3 n = some_vector(r), t = some_vector(r);
        const glm::dvec3 tangent = t - n * (dot_of(t, n) / dot_of(n, n));
        const glm::dvec3 moved_n = normal_matrix(m) * n, moved_t = glm::dmat3(m) * tangent;
        ASSERT_GT(length_of(moved_n), 1e-3) << "the scale of the map does not matter: " << size;
        ASSERT_LT(length_of(moved_n), 1e3);
        ASSERT_LT(std::abs(dot_of(moved_n, moved_t)), 1e-12 * length_of(moved_n) * length_of(moved_t));
        // and point to the side to which the map takes the side they were on
        ASSERT_GT(dot_of(moved_n, glm::dmat3(m) * n), 0);
        const glm::dmat3 l = glm::dmat3(m) / size;
        const double determinant = l[0][0] * (l[1][1] * l[2][2] - l[2][1] * l[1][2]) -
                                   l[1][0] * (l[0][1] * l[2][2] - l[2][1] * l[0][2]) +
                                   l[2][0] * (l[0][1] * l[1][2] - l[1][1] * l[0][2]);
        if (std::abs(determinant) > 1e-9) {
            ASSERT_EQ(is_mirrored(m), determinant < 0);
        }
    }
}

TEST(Transform, NormalsOfExtremeMapsAreUsable) {
    for (const double size : {1e-19, 1e-12, 1.0, 1e12, 1e19})
        for (const glm::dvec3 sign : {glm::dvec3{1, 1, 1}, glm::dvec3{-1, 1, 1}, glm::dvec3{-1, -1, -1}}) {
            const Affine<World, Object> map{scaling_matrix(size * sign)};
            const Normal<World> n = normal_map(map) * Normal<Object>{{0, 0, 1}};
            EXPECT_LT(length_of(glm::dvec3(normalize(n.v)) - glm::dvec3(0, 0, sign.z)), 1e-6) << size;
            EXPECT_EQ(is_mirrored(map.m), sign.x * sign.y * sign.z < 0);
        }
    const Affine<World, Object> uneven{scaling_matrix({1e-19, 1e19, 1})};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 along{0, 0, 0};
        along[axis] = 1;
        const Vec3 n = normalize((normal_map(uneven) * Normal<Object>{along}).v);
        EXPECT_LT(length_of(glm::dvec3(n) - glm::dvec3(along)), 1e-6) << axis;
    }
    const Affine<World, Object> flat{scaling_matrix({2, 3, 0})};
    const Vec3 m = normalize((normal_map(flat) * Normal<Object>{{Scalar(0.3), 0, Scalar(0.5)}}).v);
    EXPECT_LT(length_of(glm::dvec3(m) - glm::dvec3(0, 0, 1)), 1e-6) << "the normal of the plane";
    const Affine<World, Object> moved{translation_matrix({1e9, -5, 3})};
    EXPECT_EQ((normal_map(moved) * Normal<Object>{{1, 2, 3}}).v, Vec3(1, 2, 3))
        << "a translation moves no normal";
    EXPECT_FALSE(is_mirrored(glm::dmat4(0.0)));
}

}  // namespace
}  // namespace relevo::pipeline
