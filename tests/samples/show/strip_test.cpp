#include "samples/show/strip.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace relevo::show {
namespace {

TEST(Strip, AThumbnailFitsAndKeepsTheShape) {
    const Picture wide = thumbnail(Picture(960, 240)), tall = thumbnail(Picture(100, 3600)),
                  tiny = thumbnail(Picture(3, 1));
    EXPECT_EQ(wide.width(), 240);
    EXPECT_EQ(wide.height(), 60);
    EXPECT_EQ(tall.width(), 5);
    EXPECT_EQ(tall.height(), 180);
    EXPECT_EQ(tiny.width(), 3);
    EXPECT_EQ(tiny.height(), 1);
    EXPECT_EQ(thumbnail(Picture(1, 2000)).width(), 1);
}

TEST(Strip, APixelIsTheAverageOfThoseItStandsFor) {
    Picture page(480, 360, Rgba8{10, 20, 30, 255});
    page.at(2, 0) = {50, 20, 30, 255};
    page.at(3, 1) = {50, 20, 31, 255};
    const Picture small = thumbnail(page);
    EXPECT_EQ(small.at(0, 0), (Rgba8{10, 20, 30, 255}));
    EXPECT_EQ(small.at(1, 0), (Rgba8{30, 20, 30, 255}));  // (10 + 50 + 10 + 50 + 2) / 4
}

TEST(Strip, ThumbnailsStandInRowsOfFourTheLastInTheMiddle) {
    std::vector<Picture> five(5, Picture(240, 100, Rgba8{1, 2, 3, 255}));
    five[4] = Picture(240, 40, Rgba8{9, 9, 9, 255});
    const Picture all = strip(five);
    EXPECT_EQ(all.width(), 4 * 244 + 4);
    EXPECT_EQ(all.height(), 4 + 104 + 44);
    EXPECT_EQ(all.at(4 + 3 * 244, 4), (Rgba8{1, 2, 3, 255}));
    EXPECT_EQ(all.at(4 + 3 * 122, 108), (Rgba8{9, 9, 9, 255}));
    EXPECT_EQ(all.at(4 + 3 * 122 - 1, 108), rule);
    EXPECT_EQ(strip(std::span(five).first(1)).at(4, 4), (Rgba8{1, 2, 3, 255}));
    EXPECT_GT(strip({}).width(), 0);
}

}  // namespace
}  // namespace relevo::show
