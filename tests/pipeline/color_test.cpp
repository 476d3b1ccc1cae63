#include "pipeline/color.hpp"

#include <gtest/gtest.h>

namespace relevo::pipeline {
namespace {

TEST(Color, SumsAndProductsAChannel) {
    constexpr LinearRgb a{1, 2, 4}, b{Scalar(0.5), Scalar(0.25), 8};
    static_assert(a + b == LinearRgb{Scalar(1.5), Scalar(2.25), 12});
    static_assert(a * b == LinearRgb{Scalar(0.5), Scalar(0.5), 32});
    static_assert(Scalar(2) * a == LinearRgb{2, 4, 8});
    EXPECT_EQ(a + b, b + a);
    EXPECT_FALSE(a == b);
    EXPECT_EQ(LinearRgb{}, (LinearRgb{0, 0, 0}));
}

}  // namespace
}  // namespace relevo::pipeline
