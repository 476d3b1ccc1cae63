#include "samples/io/compare.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace relevo::io {
namespace {

using raster::Image;
using raster::Rgba8;

constexpr double infinity = std::numeric_limits<double>::infinity();

Pixels floats(int width, int height, int channels, std::vector<float> numbers) {
    return {width, height, channels, std::move(numbers)};
}

TEST(Compare, EqualPicturesAreTheSame) {
    const Image<Rgba8> image(5, 4, {1, 2, 3, 4});
    const Comparison comparison = compare(image, image);
    EXPECT_TRUE(comparison.same());
    EXPECT_FALSE(comparison.first || comparison.worst);
    EXPECT_EQ(describe(comparison, "a.png", "b.png"),
              "a.png and b.png are the same: 5 x 4 pixels, 4 channels, every number equal");
}

TEST(Compare, FindsTheFirstAndTheWorstPixel) {
    const Image<Rgba8> a(5, 4, {10, 20, 30, 255});
    Image<Rgba8> b = a;
    b.at(3, 1).g = 21;
    b.at(1, 2).b = 0;
    b.at(4, 3).r = 40;  // as bad as the one before
    const Comparison comparison = compare(a, b);
    EXPECT_FALSE(comparison.same());
    EXPECT_EQ(comparison.different, 3u);
    EXPECT_EQ(comparison.first->x, 3);
    EXPECT_EQ(comparison.first->y, 1);
    EXPECT_EQ(comparison.first->difference, 1);
    EXPECT_EQ(comparison.worst->x, 1);
    EXPECT_EQ(comparison.worst->y, 2);
    EXPECT_EQ(comparison.worst->difference, 30);
    EXPECT_EQ(describe(comparison, "a", "b"),
              "a and b differ in 3 of 20 pixels (15 %)\n"
              "  first wrong pixel  x 3, y 1: 10 20 30 255 against 10 21 30 255, difference 1\n"
              "  worst pixel        x 1, y 2: 10 20 30 255 against 10 20 0 255, difference 30");
}

TEST(Compare, EveryChannelCounts) {
    const Image<Rgba8> a(1, 1, {10, 20, 30, 40});
    for (const Rgba8 other : {Rgba8{11, 20, 30, 40}, {10, 21, 30, 40}, {10, 20, 31, 40}, {10, 20, 30, 41}})
        EXPECT_EQ(compare(a, Image<Rgba8>(1, 1, other)).different, 1u);
}

TEST(Compare, SizesChannelsAndKindsMustAgree) {
    EXPECT_EQ(compare(Image<Rgba8>(2, 3), Image<Rgba8>(3, 2)).not_comparable,
              "the sizes are 2 x 3 pixels and 3 x 2 pixels");
    const Pixels a = floats(2, 1, 1, {0, 0});
    EXPECT_EQ(compare(a, floats(1, 2, 1, {0, 0})).not_comparable,
              "the sizes are 2 x 1 pixels and 1 x 2 pixels");
    EXPECT_EQ(compare(a, floats(2, 1, 2, {0, 0, 0, 0})).not_comparable, "they have 1 and 2 channels");
    const Comparison kinds = compare(a, Pixels{2, 1, 1, std::vector<std::uint16_t>{0, 0}});
    EXPECT_FALSE(kinds.same());
    EXPECT_EQ(describe(kinds, "a", "b"), "a and b cannot be compared: they hold float and 16-bit numbers");
}

TEST(Compare, FloatsAreComparedWithoutTolerance) {
    const float next = std::nextafter(0.5f, 1.f);
    const Comparison comparison = compare(floats(2, 1, 1, {0.25f, 0.5f}), floats(2, 1, 1, {0.25f, next}));
    EXPECT_EQ(comparison.different, 1u);
    EXPECT_EQ(comparison.worst->difference, double(next) - 0.5);
    EXPECT_EQ(describe(comparison, "a", "b").find("0.5 against 0.50000006, difference 5.96046448e-08"),
              describe(comparison, "a", "b").find("0.5 against"));
}

TEST(Compare, InfinitiesAndNotNumbers) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(compare(floats(2, 1, 1, {nan, inf}), floats(2, 1, 1, {nan, inf})).same());
    EXPECT_EQ(compare(floats(1, 1, 1, {nan}), floats(1, 1, 1, {0})).worst->difference, infinity);
    EXPECT_EQ(compare(floats(1, 1, 1, {inf}), floats(1, 1, 1, {0})).worst->difference, infinity);
}

TEST(DifferencePicture, ShowsBothAndEightTimesTheDifference) {
    const Image<Rgba8> a(2, 1, {10, 20, 30, 255});
    Image<Rgba8> b = a;
    b.at(1, 0) = {12, 20, 130, 255};
    const Rgba8 white{255, 255, 255, 255}, black{0, 0, 0, 255};
    EXPECT_EQ(difference_picture(a, b).pixels(),
              (Image<Rgba8>::Pixels{
                  a.at(0, 0), a.at(1, 0), white, b.at(0, 0), b.at(1, 0), white, black, {16, 0, 255, 255}}));
}

TEST(DifferencePicture, ShowsADifferenceOfAlpha) {
    EXPECT_EQ(
        difference_picture(Image<Rgba8>(1, 1, {1, 1, 1, 10}), Image<Rgba8>(1, 1, {1, 1, 1, 12})).at(4, 0),
        (Rgba8{16, 16, 16, 255}));
}

TEST(DifferencePicture, TheLargestFloatDifferenceIsWhite) {
    const Pixels a = floats(3, 1, 1, {0, 0.5f, 1}), b = floats(3, 1, 1, {0, 0.5f + 1e-6f, 1 + 1e-3f});
    const Image<Rgba8> picture = difference_picture(a, b);
    EXPECT_EQ(picture.at(0, 0).r, 0);
    EXPECT_EQ(picture.at(1, 0).g, 128);
    EXPECT_EQ(picture.at(8, 0), (Rgba8{0, 0, 0, 255}));
    EXPECT_EQ(picture.at(9, 0), (Rgba8{1, 1, 1, 255}));  // small, but to be seen
    EXPECT_EQ(picture.at(10, 0), (Rgba8{255, 255, 255, 255}));
}

}  // namespace
}  // namespace relevo::io
