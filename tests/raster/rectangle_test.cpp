#include "raster/rectangle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "raster/triangle_scan.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/hard.hpp"

namespace relevo::raster {
namespace {

using tests::Drawing;

constexpr FillRule rules[] = {FillRule::TopLeft, FillRule::Book};

Drawing drawn(SnappedPoint a, SnappedPoint b, FillRule rule, int width, int height) {
    Drawing picture(std::size_t(height), std::string(std::size_t(width), '.'));
    rectangle(a, b, rule, {0, 0, width - 1, height - 1}, [&](int y, int x0, int x1) {
        for (int x = x0; x < x1; ++x) {
            char& pixel = picture[std::size_t(y)][std::size_t(x)];
            pixel = pixel == '.' ? '#' : '2';
        }
    });
    return picture;
}

TEST(Rectangle, IsHalfOpenAsInFigure58) {
    EXPECT_TRUE(tests::same_drawing(drawn(snapped(1, 1), snapped(5, 4), FillRule::TopLeft, 7, 6),  //
                                    {".......",                                                    //
                                     ".####..",                                                    //
                                     ".####..",                                                    //
                                     ".####..",                                                    //
                                     ".......",                                                    //
                                     "......."}));
    EXPECT_TRUE(tests::same_drawing(drawn(snapped(1, 1), snapped(5, 4), FillRule::Book, 7, 6),  //
                                    {".......",                                                 //
                                     ".......",                                                 //
                                     ".####..",                                                 //
                                     ".####..",                                                 //
                                     ".####..",                                                 //
                                     "......."}));
}

TEST(Rectangle, AnyTwoOppositeCornersWillDo) {
    for (const FillRule rule : rules) {
        const Drawing right = drawn(snapped(1.5, 0.25), snapped(5, 4), rule, 8, 8);
        EXPECT_TRUE(tests::same_drawing(drawn(snapped(5, 4), snapped(1.5, 0.25), rule, 8, 8), right));
        EXPECT_TRUE(tests::same_drawing(drawn(snapped(1.5, 4), snapped(5, 0.25), rule, 8, 8), right));
        EXPECT_TRUE(tests::same_drawing(drawn(snapped(5, 0.25), snapped(1.5, 4), rule, 8, 8), right));
    }
}

TEST(Rectangle, WithoutWidthOrHeightItIsEmpty) {
    for (const FillRule rule : rules)
        for (const SnappedPoint& b : {snapped(2, 2), snapped(2, 6), snapped(6, 2)})
            EXPECT_TRUE(
                tests::same_drawing(drawn(snapped(2, 2), b, rule, 8, 8), Drawing(8, std::string(8, '.'))));
    // thinner than a pixel: a column of centres or none
    EXPECT_EQ(drawn(snapped(2.1, 0), snapped(2.9, 3), FillRule::TopLeft, 5, 1)[0], ".....");
    EXPECT_EQ(drawn(snapped(1.9, 0), snapped(2.1, 3), FillRule::TopLeft, 5, 1)[0], "..#..");
}

// Two triangles make the same rectangle: the diagonal's centres belong to exactly one of them.
TEST(Rectangle, IsTheTwoTrianglesOfIt) {
    tests::hard::Random random(2);
    for (int i = 0; i < 3000; ++i) {
        const auto place = [&] {
            return static_cast<int>(random.integer(-300, 12 * 256)) / (i % 2 ? 1 : 128) * (i % 2 ? 1 : 128);
        };
        const SnappedPoint a{place(), place()}, b{place(), place()}, c{a.x, b.y}, d{b.x, a.y};
        for (const FillRule rule : rules) {
            Drawing picture(10, std::string(10, '.'));
            const auto add = [&](int y, int x0, int x1) {
                for (int x = x0; x < x1; ++x) {
                    char& pixel = picture[std::size_t(y)][std::size_t(x)];
                    pixel = pixel == '.' ? '#' : '2';
                }
            };
            triangle_scan({a, b, c}, rule, {0, 0, 9, 9}, add);
            triangle_scan({a, b, d}, rule, {0, 0, 9, 9}, add);
            ASSERT_TRUE(tests::same_drawing(drawn(a, b, rule, 10, 10), picture));
        }
    }
}

// Fig. 5.9: the pixel where four rectangles meet.
TEST(Rectangle, APixelSharedByFourCornersHasOneOwner) {
    for (const FillRule rule : rules)
        for (int dx = 0; dx < 256; dx += 64)
            for (int dy = 0; dy < 256; dy += 64) {
                const SnappedPoint middle{4 * 256 + dx, 4 * 256 + dy};
                std::array<std::array<int, 8>, 8> count{};
                for (const SnappedPoint& corner : {SnappedPoint{0, 0}, SnappedPoint{2048, 0},
                                                   SnappedPoint{0, 2048}, SnappedPoint{2048, 2048}})
                    rectangle(middle, corner, rule, {0, 0, 7, 7}, [&](int y, int x0, int x1) {
                        for (int x = x0; x < x1; ++x) ++count[std::size_t(y)][std::size_t(x)];
                    });
                for (const auto& row : count)
                    for (const int n : row) ASSERT_EQ(n, 1);
            }
}

TEST(Rectangle, AllCoordinatesAndBoxesAreRight) {
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    for (const FillRule rule : rules) {
        int rows = 0;
        rectangle({least, least}, {most, most}, rule, {-2, -3, 4, 5}, [&](int y, int x0, int x1) {
            EXPECT_EQ(y, rows++ - 3);
            EXPECT_EQ(x0, -2);
            EXPECT_EQ(x1, 5);
        });
        EXPECT_EQ(rows, 9);
        const auto never = [](int, int, int) { ADD_FAILURE(); };
        rectangle({least, least}, {most, most}, rule, {4, 0, 3, 5}, never);
        rectangle({least, least}, {most, most}, rule, {0, 4, 5, 3}, never);
        rectangle(snapped(0, 0), snapped(9, 9), rule, {20, 0, 30, 9}, never);
        rectangle(snapped(0, 0), snapped(9, 9), rule, {0, 20, 9, 30}, never);
        rows = 0;
        rectangle(snapped(0, 0), snapped(9, 9), rule, {least, least, most, most},
                  [&](int, int, int) { ++rows; });
        EXPECT_EQ(rows, 9);
    }
}

TEST(Rectangle, ItsMomentNamesThePixels) {
    struct {
        std::optional<RectangleBounded> heard;
        void on(const RectangleBounded& e) { heard = e; }
    } probe;
    rectangle(
        snapped(5, 4), snapped(1, 1), FillRule::Book, {0, 0, 2, 2}, [](int, int, int) {}, probe);
    ASSERT_TRUE(probe.heard);
    EXPECT_EQ(probe.heard->upper_left, snapped(1, 1));
    EXPECT_EQ(probe.heard->lower_right, snapped(5, 4));
    EXPECT_EQ(probe.heard->pixels.x0, 1);
    EXPECT_EQ(probe.heard->pixels.x1, 4);
    EXPECT_EQ(probe.heard->pixels.y0, 2);
    EXPECT_EQ(probe.heard->pixels.y1, 4);
}

}  // namespace
}  // namespace relevo::raster
