#include "pipeline/result.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace relevo::pipeline {
namespace {

TEST(Result, IsAValueOrASentence) {
    const Result<int> good = 3, bad = Error{"no number"};
    ASSERT_TRUE(good);
    EXPECT_EQ(*good, 3);
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().message, "no number");
}

TEST(Result, TheErrorMayBeAnyType) {
    struct Failure {
        std::string text;
    };
    const Result<std::string, Failure> good = std::string("fine"), bad = Failure{"not fine"};
    EXPECT_EQ(good->size(), 4u);
    EXPECT_EQ(bad.error().text, "not fine");
}

TEST(Result, ValuesCanBeMovedOut) {
    Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
    **result = 6;
    const std::unique_ptr<int> out = *std::move(result);
    EXPECT_EQ(*out, 6);
}

}  // namespace
}  // namespace relevo::pipeline
