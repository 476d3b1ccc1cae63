#include "raster/line_explicit.hpp"

#include <gtest/gtest.h>

#include "raster/line_midpoint.hpp"
#include "tests/raster/line_pixels.hpp"

namespace relevo::raster {
namespace {

using tests::all_pixels;
using tests::Pixels;

struct Listener {
    std::vector<SlopeUndefined> undefined;
    std::vector<ExplicitStarted> started;
    std::vector<ExplicitColumn> columns;
    void on(const SlopeUndefined& e) { undefined.push_back(e); }
    void on(const ExplicitStarted& e) { started.push_back(e); }
    void on(const ExplicitColumn& e) { columns.push_back(e); }
};

Pixels explicit_pixels(Pixel a, Pixel b, const PixelBox& box = all_pixels) {
    Pixels pixels;
    line_explicit(a, b, box, [&](int x, int y) { pixels.push_back({x, y}); });
    return pixels;
}

TEST(LineExplicit, FlatLinesAreTheMidpointLine) {
    for (int dx = 1; dx <= 16; dx *= 2)
        for (int dy = -dx; dy <= dx; ++dy) {
            Pixels right;
            line_midpoint({-3, 2}, {dx - 3, dy + 2}, all_pixels, [&](int x, int y) {
                right.push_back({x, y});
            });
            EXPECT_EQ(explicit_pixels({-3, 2}, {dx - 3, dy + 2}), right);
            EXPECT_EQ(explicit_pixels({dx - 3, dy + 2}, {-3, 2}), right);
        }
}

TEST(LineExplicit, SteepLinesHaveGaps) {
    EXPECT_TRUE(
        tests::same_drawing(tests::drawing_of_pixels(explicit_pixels({0, 0}, {2, 6}), 3, 7), {"#..",  //
                                                                                              "...",  //
                                                                                              "...",  //
                                                                                              ".#.",  //
                                                                                              "...",  //
                                                                                              "...",  //
                                                                                              "..#"}));
}

TEST(LineExplicit, TheVerticalHasNoEquation) {
    for (const Pixel b : {Pixel{3, 9}, Pixel{3, -9}, Pixel{3, 2}}) {
        Listener heard;
        int plotted = 0;
        line_explicit(
            {3, 2}, b, all_pixels, [&](int, int) { ++plotted; }, heard);
        EXPECT_EQ(plotted, 0);
        ASSERT_EQ(heard.undefined.size(), 1u);
        EXPECT_EQ(heard.undefined[0].dy, std::abs(b.y - 2));
        EXPECT_TRUE(heard.started.empty());
    }
}

TEST(LineExplicit, EventsCarryTheEquation) {
    Listener heard;
    line_explicit(
        {1, 2}, {5, 4}, all_pixels, [](int, int) {}, heard);
    ASSERT_EQ(heard.started.size(), 1u);
    EXPECT_EQ(heard.started[0].a, 0.5f);
    EXPECT_EQ(heard.started[0].b, 1.5f);
    ASSERT_EQ(heard.columns.size(), 5u);
    EXPECT_EQ(heard.columns[1].y, 2.5f);
    EXPECT_EQ(heard.columns[1].pixel, (Pixel{2, 2}));
}

TEST(LineExplicit, ABoxIsTheSameAsDiscarding) {
    for (int code = 0; code < 12 * 12 * 12 * 12; ++code) {
        const Pixel a{code % 12 - 3, code / 12 % 12 - 3}, b{code / 144 % 12 - 3, code / 1728 - 3};
        const PixelBox box{0, 0, 5, 5};
        ASSERT_EQ(explicit_pixels(a, b, box), tests::within(explicit_pixels(a, b), box));
    }
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    for (const Pixel& p : explicit_pixels({least, least}, {most, most}, {-5, -5, 5, 5}))
        EXPECT_LE(std::abs(p.y), 5);
    explicit_pixels({most - 1, least}, {most, most}, all_pixels);
    EXPECT_TRUE(explicit_pixels({0, 0}, {9, 9}, {0, 5, 9, 4}).empty());
}

}  // namespace
}  // namespace relevo::raster
