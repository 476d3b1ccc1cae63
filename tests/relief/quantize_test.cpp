#include "relief/quantize.hpp"

#include <gtest/gtest.h>

#include "relief/occlusion_order.hpp"
#include "relief/warp_table.hpp"
#include "tests/relief/random_source.hpp"

namespace relevo::relief {
namespace {

namespace hard = tests::hard;

ReliefTexture texture_of(hard::Random& r, double low, double high) {
    ReliefTexture texture =
        make_relief_texture(*orthographic_camera({{0, 0, -1}, {0, 1, 0}, 32, 32}, {0, 0, 0}, 2));
    for (std::size_t i = 0; i < texture.depth.pixels().size(); ++i) {
        texture.coverage.pixels()[i] = r.integer(0, 3) > 0;
        texture.depth.pixels()[i] = static_cast<Scalar>(r.between(low, high));
    }
    return texture;
}

template <class Code>
class Quantize : public testing::Test {};
using Codes = testing::Types<std::uint8_t, std::uint16_t>;
TYPED_TEST_SUITE(Quantize, Codes);

TYPED_TEST(Quantize, IsWithinHalfAStepAndKeepsTheEnds) {
    hard::Random r(1);
    for (int i = 0; i < 50; ++i) {
        const double low = r.between(0, 3), high = low + r.between(0, 4);
        const ReliefTexture texture = texture_of(r, low, high);
        const auto q = quantize<TypeParam>(texture);
        const ReliefTexture back = with_depth(texture, q);
        const DepthRange before = depth_range(texture), after = depth_range(back);
        EXPECT_EQ(before.low, after.low);
        EXPECT_EQ(before.high, after.high);
        for (std::size_t k = 0; k < q.code.pixels().size(); ++k) {
            if (texture.coverage.pixels()[k] == 0) {
                ASSERT_EQ(q.code.pixels()[k], q.empty);
                continue;
            }
            ASSERT_LE(q.code.pixels()[k], q.last);
            const double error = double{back.depth.pixels()[k]} - double{texture.depth.pixels()[k]};
            ASSERT_LE(std::abs(error), step(q) / 2 * 1.0001 + 4e-7);  // and the rounding to Scalar
        }
    }
}

TYPED_TEST(Quantize, OneDepthIsCodeZeroAndNothingIsAllEmpty) {
    hard::Random r(2);
    ReliefTexture texture = texture_of(r, 1.5, 1.5);
    auto q = quantize<TypeParam>(texture);
    for (std::size_t k = 0; k < q.code.pixels().size(); ++k)
        EXPECT_EQ(q.code.pixels()[k], texture.coverage.pixels()[k] ? 0 : q.empty);
    EXPECT_EQ(value(q, 0), Scalar(1.5));
    for (auto& covered : texture.coverage.pixels()) covered = 0;
    q = quantize<TypeParam>(texture);
    for (const auto code : q.code.pixels()) EXPECT_EQ(code, q.empty);
}

// The bound of the header, in warped texels; and the figure of eight bits for a viewer as far as two
// radii.
TYPED_TEST(Quantize, MovesAWarpedTexelNoFartherThanTheBound) {
    hard::Random r(3);
    double worst = 0, tightest = 0;
    for (int i = 0; i < 200; ++i) {
        const ReliefTexture texture = texture_of(r, 0.1, 2);
        const auto q = quantize<TypeParam>(texture);
        const ReliefTexture coarse = with_depth(texture, q);
        const glm::dvec3 eye = random::viewer_place(r, texture.camera, r.between(0.3, 4), 2);
        const Warp warp = *make_warp(texture.camera, viewer_at(eye));
        const OcclusionOrder epipole = occlusion_order(warp);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                if (!texture.coverage.at(x, y)) continue;
                const double least = std::min(double{texture.depth.at(x, y)}, double{coarse.depth.at(x, y)}),
                             bound = displacement_error_bound(epipole.u, x + 0.5, warp.h, least, step(q) / 2),
                             got = std::abs(warp_texel(warp, texture, x, y).u -
                                            warp_texel(warp, coarse, x, y).u);
                ASSERT_LE(got, bound * 1.001 + 2e-5);
                worst = std::max(worst, got);
                if (bound > 1e-3) tightest = std::max(tightest, got / bound);
            }
    }
    std::printf("%zu bits: at most %.4f texels, %.2f of the bound\n", 8 * sizeof(TypeParam), worst, tightest);
    if (sizeof(TypeParam) == 1) {
        EXPECT_GT(tightest, 0.9);
    }
}

TYPED_TEST(Quantize, TheTableWarpsAsTheFormulaDoes) {
    hard::Random r(4);
    for (int i = 0; i < 20; ++i) {
        const ReliefTexture texture = texture_of(r, 0, 2);
        const auto q = quantize<TypeParam>(texture);
        const ReliefTexture coarse = with_depth(texture, q);
        const glm::dvec3 eye = random::viewer_place(r, texture.camera, r.between(0.5, 4), 2);
        const Warp warp = *make_warp(texture.camera, viewer_at(eye));
        const WarpTable<TypeParam> table = make_warp_table(warp, q);
        EXPECT_EQ(table.coef1.size(), sizeof(TypeParam) == 1 ? 255u : 65535u);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                if (!texture.coverage.at(x, y)) continue;
                const WarpedPoint right = warp_texel(warp, coarse, x, y);
                const WarpedTexel got = warp_texel(table, Scalar(x + 0.5), Scalar(y + 0.5), q.code.at(x, y));
                ASSERT_NEAR(double{got.u}, right.u, 1e-4);
                ASSERT_NEAR(double{got.v}, right.v, 1e-4);
            }
    }
}

}  // namespace
}  // namespace relevo::relief
