#include "relief/error_set.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

namespace relevo::relief {
namespace {

// '#' is a covered pixel of grey g and depth z, anything else is empty.
ViewImage picture(std::string_view pixels, Scalar g = 1, Scalar z = 2) {
    ViewImage image(static_cast<int>(pixels.size()), 1);
    for (int x = 0; x < image.width(); ++x)
        if (pixels[std::size_t(x)] == '#')
            image.color.at(x, 0) = {g, g, g}, image.depth.at(x, 0) = z, image.coverage.at(x, 0) = 1;
    return image;
}

TEST(ErrorSet, EqualPicturesHaveNoError) {
    const ErrorSet error = error_set(picture("..##."), picture("..##."));
    EXPECT_EQ(error.missing_percent, 0);
    EXPECT_EQ(error.extra_percent, 0);
    EXPECT_TRUE(std::isinf(error.psnr) && error.psnr > 0);
    EXPECT_EQ(error.mean_depth_error, 0);
    EXPECT_EQ(error.bad_percent, 0);
    EXPECT_EQ(error.union_pixels, 2);
}

TEST(ErrorSet, CountsHolesAndSkinsAgainstTheTruth) {
    const ErrorSet error = error_set(picture("..#####.."), picture("####....."));
    EXPECT_DOUBLE_EQ(error.missing_percent, 50);
    EXPECT_DOUBLE_EQ(error.extra_percent, 75);
    EXPECT_EQ(error.union_pixels, 7);
    EXPECT_DOUBLE_EQ(error.bad_percent, 500.0 / 7);  // white against black
    EXPECT_NEAR(error.psnr, -10 * std::log10(5.0 / 7), 1e-12);
    EXPECT_EQ(error.mean_depth_error, 0);  // over the two pixels that both cover
}

TEST(ErrorSet, MeasuresColorsAndDepthsWhereBothAreCovered) {
    const ErrorSet near =
        error_set(picture("##", Scalar(0.5), 3), picture("##", Scalar(0.5625), Scalar(2.5)));
    EXPECT_DOUBLE_EQ(near.mean_depth_error, 0.5);
    EXPECT_DOUBLE_EQ(error_set(picture("##", 1, 2), picture("##", 1, Scalar(2.5))).mean_depth_error, 0.5);
    EXPECT_NEAR(near.psnr, -20 * std::log10(0.0625), 1e-12);
    EXPECT_EQ(near.bad_percent, 0);
    EXPECT_EQ(error_set(picture("##", Scalar(0.5)), picture("##", Scalar(0.625))).bad_percent, 100);
}

TEST(ErrorSet, ABadColorIsMeasuredOverItsThreeParts) {
    ViewImage red = picture("#");
    red.color.at(0, 0).r -= Scalar(0.15);  // root mean square 0.0866
    EXPECT_EQ(error_set(red, picture("#")).bad_percent, 0);
    red.color.at(0, 0).r -= Scalar(0.05);  // 0.115
    EXPECT_EQ(error_set(red, picture("#")).bad_percent, 100);
}

TEST(ErrorSet, TheBackgroundDoesNotFlatter) {
    const ErrorSet alone = error_set(picture("#", Scalar(0.25)), picture("#"));
    const ErrorSet framed = error_set(picture("....#....", Scalar(0.25)), picture("....#...."));
    EXPECT_EQ(alone.psnr, framed.psnr);
    EXPECT_EQ(alone.bad_percent, framed.bad_percent);
}

TEST(ErrorSet, EmptyPictures) {
    const ErrorSet both = error_set(picture("..."), picture("..."));
    EXPECT_TRUE(std::isinf(both.psnr) && both.union_pixels == 0 && both.bad_percent == 0);
    const ErrorSet nothing_true = error_set(picture("##."), picture("..."));
    EXPECT_EQ(nothing_true.missing_percent, 0);
    EXPECT_EQ(nothing_true.extra_percent, 200);
    EXPECT_EQ(nothing_true.bad_percent, 100);
    const ErrorSet nothing_seen = error_set(picture("..."), picture("##."));
    EXPECT_EQ(nothing_seen.missing_percent, 100);
    EXPECT_EQ(nothing_seen.extra_percent, 0);
}

TEST(ErrorSet, WhatIsNotANumberIsNeverGood) {
    ViewImage image = picture("##");
    image.color.at(0, 0).g = std::nanf("");
    image.depth.at(1, 0) = std::nanf("");
    const ErrorSet error = error_set(image, picture("##"));
    EXPECT_EQ(error.bad_percent, 50);
    EXPECT_TRUE(std::isnan(error.psnr));
    EXPECT_TRUE(std::isnan(error.mean_depth_error));
}

}  // namespace
}  // namespace relevo::relief
