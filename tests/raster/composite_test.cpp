// "Over" against rational numbers.
#include "raster/composite.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/exact_area.hpp"

namespace relevo::raster {
namespace {

using tests::exact::Rational;

struct Exact {
    Rational r, g, b, a;
};
Exact exact_over(Rgba8 d, Rgba8 s, int coverage) {
    const Rational alpha = Rational(s.a, 255) * Rational(coverage, full_coverage),
                   below = (1 - alpha) * Rational(d.a, 255);
    const Rational sum = alpha + below;
    if (sum == 0) return {d.r, d.g, d.b, d.a};
    return {(alpha * s.r + below * d.r) / sum, (alpha * s.g + below * d.g) / sum,
            (alpha * s.b + below * d.b) / sum, 255 * sum};
}
// Nearest, halves up.
bool is_rounded(int c, const Rational& exact) {
    return exact - Rational(1, 2) < c && c <= exact + Rational(1, 2);
}

TEST(Composite, EightBitsAreRoundedExactly) {
    std::mt19937_64 bits(1);
    const auto byte = [&] {
        return static_cast<std::uint8_t>(bits() % 4 == 0 ? 255 * (bits() & 1) : bits() & 255);
    };
    for (int i = 0; i < 30000; ++i) {
        const Rgba8 d{byte(), byte(), byte(), i % 2 ? std::uint8_t(255) : byte()},
            s{byte(), byte(), byte(), byte()};
        const int coverage = i % 5 == 0 ? 32768 * int(bits() % 3) : int(bits() % 65537);
        const Rgba8 ours = over(d, s, coverage);
        const Exact right = exact_over(d, s, coverage);
        ASSERT_TRUE(is_rounded(ours.r, right.r) && is_rounded(ours.g, right.g) &&
                    is_rounded(ours.b, right.b) && is_rounded(ours.a, right.a))
            << int(d.r) << " a " << int(d.a) << " under " << int(s.r) << " a " << int(s.a) << " by "
            << coverage;
    }
}

TEST(Composite, FullCoverageIsTheColourAndNoneIsNothing) {
    const Rgba8 d{1, 2, 3, 77}, s{200, 100, 50, 255};
    EXPECT_EQ(over(d, s, full_coverage), s);
    EXPECT_EQ(over(d, s, 0), d);
    EXPECT_EQ(over(d, Rgba8{9, 9, 9, 0}, full_coverage), d);
    EXPECT_EQ(over(Rgba8{5, 6, 7, 0}, Rgba8{9, 9, 9, 0}, 1234), (Rgba8{5, 6, 7, 0}));
    const LinearRgb below{Scalar(0.1), Scalar(0.2), Scalar(0.3)}, color{Scalar(0.7), Scalar(1.0) / 3, 17};
    EXPECT_EQ(over(below, color, 1, full_coverage), color);
    EXPECT_EQ(over(below, color, 1, 0), below);
    EXPECT_EQ(over(below, color, 0, full_coverage), below);
    EXPECT_EQ(over(LinearRgb{0, 0, 0}, LinearRgb{1, 1, 1}, 1, 1).r, Scalar(0x1p-16));
    EXPECT_EQ(over(LinearRgb{1, 1, 1}, LinearRgb{0, 0, 0}, Scalar(0.5), 32768).r, Scalar(0.75));
}

TEST(Composite, ARunIsItsPixels) {
    std::vector<Rgba8> row(9, Rgba8{10, 20, 30, 255});
    std::vector<LinearRgb> linear(9, LinearRgb{Scalar(0.25), 0, 1});
    for (const int coverage : {1, 30000, 65535, 65536})
        for (const std::uint8_t alpha : {1, 128, 255})
            for (int x0 = 0; x0 < 9; ++x0)
                for (int x1 = x0; x1 <= 9; ++x1) {
                    auto run = row;
                    auto linear_run = linear;
                    const Rgba8 s{250, 130, 0, alpha};
                    const LinearRgb c{1, Scalar(0.5), 0};
                    const Scalar opacity = Scalar(alpha) / 255;
                    over(run.data(), x0, x1, s, coverage);
                    over(linear_run.data(), x0, x1, c, opacity, coverage);
                    for (int x = 0; x < 9; ++x) {
                        const bool in = x0 <= x && x < x1;
                        const auto i = static_cast<std::size_t>(x);
                        ASSERT_EQ(run[i], in ? over(row[i], s, coverage) : row[i]);
                        ASSERT_EQ(linear_run[i], in ? over(linear[i], c, opacity, coverage) : linear[i]);
                    }
                }
}

TEST(Composite, LongRunsEndWhereTheyShould) {
    const Rgba8 beneath{10, 20, 30, 255}, color{250, 130, 7, 255};
    for (int x0 = 0; x0 < 5; ++x0)
        for (int x1 = x0; x1 < 80; ++x1) {
            std::vector<Rgba8> row(81, beneath);
            over(row.data(), x0, x1, color, full_coverage);
            for (int x = 0; x < 81; ++x)
                ASSERT_EQ(row[static_cast<std::size_t>(x)], x0 <= x && x < x1 ? color : beneath);
        }
}

// The exact area of two halves: 1 - 1/2 1/2 (multisample.hpp).
TEST(Composite, TwoHalvesAreThreeQuarters) {
    const Rgba8 black{0, 0, 0, 255};
    EXPECT_EQ(over(over(Rgba8{200, 200, 200, 255}, black, 32768), black, 32768).r, 50);
}

}  // namespace
}  // namespace relevo::raster
