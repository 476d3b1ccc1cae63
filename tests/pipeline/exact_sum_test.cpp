#include "pipeline/exact_sum.hpp"

#include <gtest/gtest.h>

#include "tests/pipeline/clip_oracle.hpp"

namespace relevo::pipeline {
namespace {

using tests::exact::Rational;
namespace hard = tests::hard;

// A formula over any number: sums and products of five floats at most.
template <class Number>
std::vector<Number> formulas(const std::array<Number, 5>& v) {
    const auto& [a, b, c, d, e] = v;
    return {a + b,
            a - b + c - d + e,
            a * b - c * d,
            (a - b) * (c - d) - (a - c) * (b - d),
            a * b * c - b * c * d + c * d * e - d * e * a,
            (a * b + c * d) * (b * c + d * e) - a * b * c * d,
            (a + b) * (b + c) * (c + d) * (d + e) * (e + a) - a * b * c * d * e};
}

std::array<float, 5> numbers(hard::Random& r, int kind) {
    std::array<float, 5> v;
    for (float& f : v)
        f = kind == 0 ? r.any_finite_float() : kind == 1 ? hard::real(r, -1, 1) : hard::whole(r, -3, 3);
    if (kind == 3) v[1] = hard::moved(v[0], r.integer(-1, 1)), v[3] = v[2];
    return v;
}

TEST(ExactSum, IsExact) {
    hard::Random random(1);
    int zeros = 0;
    for (int i = 0; i < hard::cases(2000); ++i) {
        const auto v = numbers(random, i % 4);
        std::array<Exact, 5> as_sum;
        std::array<Bounded, 5> as_bounded;
        std::array<Rational, 5> truth;
        for (std::size_t k = 0; k < 5; ++k)
            as_sum[k] = double{v[k]}, as_bounded[k] = double{v[k]}, truth[k] = Rational(v[k]);
        const auto sums = formulas(as_sum);
        const auto bounded = formulas(as_bounded);
        const auto right = formulas(truth);
        for (std::size_t k = 0; k < right.size(); ++k) {
            ASSERT_EQ(sums[k].sign(), right[k].sign()) << "case " << i << ", formula " << k;
            ASSERT_LE(abs(Rational(sums[k].value()) - right[k]), abs(right[k]) * Rational(0x1p-50));
            ASSERT_LE(abs(Rational(bounded[k].value) - right[k]), Rational(bounded[k].error))
                << "case " << i << ", formula " << k;
            zeros += right[k] == 0;
        }
    }
    EXPECT_GT(zeros, 500);
}

TEST(ExactSum, HoldsNumbersThatNeedEveryBitOfFiveFactors) {
    // (2^100 + 2^-100 + ...)^2 minus itself piece by piece: many parts, and nothing in the end.
    Exact comb;
    for (int power = -140; power <= 120; power += 4) comb = comb + Exact(std::ldexp(1.0, power));
    Exact product = comb * comb, left = product;
    EXPECT_EQ(product.sign(), 1);
    for (int power = -140; power <= 120; power += 4) left = left - comb * Exact(std::ldexp(1.0, power));
    EXPECT_EQ(left.sign(), 0);
    left = left - Exact(0x1p-700);
    EXPECT_EQ(left.sign(), -1);
    EXPECT_EQ(comb.half().half().value(), comb.value() / 4);
}

TEST(ExactSum, SignsOfNearTies) {
    // (1 + ka e) (1 + kb e) - (1 + kc e) (1 + kd e): e^2 decides, which a rounded product loses.
    int lost = 0;
    for (int i = 0; i < 6 * 6 * 6 * 6; ++i) {
        const auto v = [&](int power) { return 1 + static_cast<float>(i / power % 6) * 0x1p-23f; };
        const float a = v(1), b = v(6), c = v(36), d = v(216);
        const int right = (Rational(a) * Rational(b) - Rational(c) * Rational(d)).sign();
        EXPECT_EQ(sign_of([&](auto n) { return n(a) * n(b) - n(c) * n(d); }), right);
        const float rounded = a * b - c * d;
        lost += (rounded > 0) - (rounded < 0) != right;
    }
    EXPECT_GT(lost, 50) << "float alone must fail, or this proves nothing";
}

TEST(ExactSum, NearestFloatIsCorrectlyRounded) {
    hard::Random random(2);
    int checked = 0;
    const auto check = [&](float a, float b, float c, float d) {
        const Rational bottom = Rational(c) - Rational(d);
        if (bottom == 0) return;
        const Rational right = Rational(a) * Rational(b) / bottom;
        if (abs(right) > Rational(std::numeric_limits<float>::max())) return;
        const float got = nearest_float([&](auto n) { return Fraction{n(a) * n(b), n(c) - n(d)}; });
        ASSERT_EQ(got, tests::exact::rounded(right)) << a << " " << b << " " << c << " " << d;
        ASSERT_FALSE(got == 0 && std::signbit(got)) << "zero is +0";
        ++checked;
    };
    for (int i = 0; i < hard::cases(4000); ++i) {
        const auto v = numbers(random, i % 4);
        check(v[0], v[1], v[2], v[3]);
        // ties: odd multiples of half an ulp, and a hair beside them
        const float odd = static_cast<float>(2 * random.integer(1 << 23, (1 << 24) - 1) + 1 - (1 << 24));
        check(odd, 1 + 0x1p-23f, 2, 0), check(odd, hard::whole(random, 1, 9), 2, 0);
        check(odd, 0x1p-149f, hard::whole(random, 1, 9), 0);
        check(0x1.000002p0f, 0x1.000002p0f, 1, 0), check(0x1.fffffep127f, 1, 1, 0);
    }
    EXPECT_GT(checked, 10'000);
}

}  // namespace
}  // namespace relevo::pipeline
