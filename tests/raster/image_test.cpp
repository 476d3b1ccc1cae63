#include "raster/image.hpp"

#include <gtest/gtest.h>

namespace relevo::raster {
namespace {

TEST(Image, RowsFromTheTopWithoutPadding) {
    Image<int> image(3, 2, 7);
    EXPECT_EQ(image.width(), 3);
    EXPECT_EQ(image.height(), 2);
    EXPECT_EQ(image.pixels(), Image<int>::Pixels(6, 7));
    image.at(2, 0) = 1;
    image.row(1)[0] = 2;
    EXPECT_EQ(image.pixels(), (Image<int>::Pixels{7, 7, 1, 2, 7, 7}));
    EXPECT_EQ(image.row(1), image.row(0) + 3);
    const Image<int>& same = image;
    EXPECT_EQ(same.at(2, 0), 1);
    EXPECT_EQ(same.row(1)[0], 2);
}

TEST(Image, HoldsItsPixelsAndNoOthers) {
    const Image<int> image(3, 2);
    EXPECT_TRUE(image.holds(0, 0));
    EXPECT_TRUE(image.holds(2, 1));
    EXPECT_FALSE(image.holds(3, 1));
    EXPECT_FALSE(image.holds(0, 2));
    EXPECT_FALSE(image.holds(-1, 0));
    EXPECT_FALSE(image.holds(0, -1));
    EXPECT_FALSE(image.empty());
    EXPECT_TRUE(Image<int>().empty());
    EXPECT_TRUE(Image<int>(0, 5).empty());
}

}  // namespace
}  // namespace relevo::raster
