#include "pipeline/space.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "pipeline/transform.hpp"
#include "tests/support/hard.hpp"

namespace relevo::pipeline {
namespace {

namespace hard = tests::hard;

// One rounding after the other, in the order of the contract, each through memory so that nothing is fused
// or kept longer.
float in_order(const float (&m)[4], float x, float y, float z) {
    volatile float a = m[0], b = m[1], c = m[2];
    a = a * x;
    b = b * y;
    c = c * z;
    volatile float sum = a;
    sum = sum + b;
    sum = sum + c;
    sum = sum + m[3];
    return sum;
}

glm::dmat4 some_matrix(hard::Random& r) {
    glm::dmat4 m;
    for (int c = 0; c < 4; ++c)
        for (int k = 0; k < 4; ++k)
            m[c][k] = r.between(-2, 2) * (r.integer(0, 9) ? 1 : exp2(r.between(-20, 20)));
    return m;
}

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

// 250,000 matrices times vertices, four rows each: a million products. In double there is no float to
// compare.
TEST(Space, ARoundedMatrixTimesAVertexIsTheContractToTheBit) {
    hard::Random r(1);
    int products = 0, glm_differs = 0;
    for (int i = 0; i < 250'000; ++i) {
        const glm::dmat4 m = some_matrix(r);
        const auto map = rounded(Projective<Clip, Object>{m});
        const Vec3 p{static_cast<Scalar>(r.between(-3, 3)), static_cast<Scalar>(r.between(-3, 3)),
                     static_cast<Scalar>(r.between(-3, 3))};
        const HPoint<Clip> got = map * Point<Object>{p};
        const glm::vec<4, Scalar> by_glm = glm::mat<4, 4, Scalar>(m) * glm::vec<4, Scalar>(p, 1);
        for (int k = 0; k < 4; ++k) {
            if constexpr (sizeof(Scalar) == 4) {
                const float row[4] = {static_cast<float>(m[0][k]), static_cast<float>(m[1][k]),
                                      static_cast<float>(m[2][k]), static_cast<float>(m[3][k])};
                const float right =
                    in_order(row, static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
                ASSERT_TRUE(same_bits(static_cast<float>(got.v[k]), right)) << i;
            }
            ++products;
            glm_differs += got.v[k] != by_glm[k];
        }
    }
    EXPECT_EQ(products, 1'000'000);
    EXPECT_GT(glm_differs, products / 20) << "another order of the sums must show, or this test cannot fail";
}

TEST(Space, AffineMapsMoveLikeProjectiveOnesAndDirectionsStay) {
    hard::Random r(2);
    for (int i = 0; i < 10'000; ++i) {
        glm::dmat4 m = some_matrix(r);
        for (int c = 0; c < 4; ++c) m[c][3] = c == 3;
        const auto affine = rounded(Affine<Eye, Object>{m});
        const auto projective = rounded(Projective<Eye, Object>{m});
        const Vec3 p{static_cast<Scalar>(r.between(-3, 3)), static_cast<Scalar>(r.between(-3, 3)),
                     static_cast<Scalar>(r.between(-3, 3))};
        const HPoint<Eye> h = projective * Point<Object>{p};
        const Point<Eye> a = affine * Point<Object>{p};
        const Vec<Eye> d = affine * Vec<Object>{p};
        for (int k = 0; k < 3; ++k) {
            ASSERT_EQ(a.v[k], h.v[k]);
            ASSERT_EQ(a.v[k], d.v[k] + static_cast<Scalar>(m[3][k])) << "a direction is not translated";
        }
        ASSERT_EQ(h.v.w, 1);
    }
}

TEST(Space, MapsComposeInDoubleAndAreRoundedOnce) {
    const Affine<World, Object> far_away = translate<World>({1e7, 0, 0}) * Affine<World, Object>{};
    const Affine<Eye, World> eye{translation_matrix({-1e7 - 0.25, 0, 0})};
    const Point<Eye> p = rounded(eye * far_away) * Point<Object>{{5, 0, 0}};
    EXPECT_EQ(p.v.x, Scalar(4.75)) << "float world coordinates would have lost the quarter";
    const Projective<Clip, Eye> projection{glm::dmat4(2.0)};
    const Projective<Clip, Object> all = projection * (eye * far_away);
    EXPECT_EQ(all.m[3][0], -0.5);
}

TEST(Space, PointsAndDisplacements) {
    const Point<World> a{{1, 2, 3}}, b{{0, 0, 1}};
    const Vec<World> d = a - b;
    EXPECT_EQ(d.v, Vec3(1, 2, 2));
    EXPECT_EQ((b + d).v, a.v);
    EXPECT_EQ((d + Scalar(2) * d).v, Vec3(3, 6, 6));
}

TEST(Space, MovingCameraAndWorldTogetherChangesNothing) {
    hard::Random r(3);
    for (const double t : {0x1p10, 0x1p17, 0x1p23}) {
        const auto world = [&](double offset) {
            return translate<World>({offset, -offset, offset}) *
                   Affine<World, Object>{scaling_matrix({0.5, 0.75, 2})};
        };
        const auto eye = [&](double offset) {
            return Affine<Eye, World>{translation_matrix({-offset - 3, offset + 0.5, -offset - 8})};
        };
        const auto near_map = rounded(eye(0) * world(0)), far_map = rounded(eye(t) * world(t));
        EXPECT_EQ(std::memcmp(&near_map, &far_map, sizeof near_map), 0) << "offset " << t;
    }
}

}  // namespace
}  // namespace relevo::pipeline
