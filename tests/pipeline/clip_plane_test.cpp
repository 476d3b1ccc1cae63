#include "pipeline/clip_plane.hpp"

#include <gtest/gtest.h>

#include "tests/pipeline/clip_oracle.hpp"

namespace relevo::pipeline {
namespace {

namespace exact = tests::exact;
namespace hard = tests::hard;
using Points = std::vector<glm::vec2>;

std::optional<Refusal> refusal(const Points& polygon) {
    const auto window = convex_window(polygon);
    return window ? std::nullopt : std::optional(window.error());
}

TEST(ClipPlane, SidesOfABoxRunClockwise) {
    const ClipBox box{{1, 2}, {7, 5}};
    for (const ClipLine& line : lines_of(box)) {
        EXPECT_EQ(side_of(line, {4, 3}), 1);
        EXPECT_EQ(side_of(line, line.from + 9.0f * (line.to - line.from)), 0);
    }
    EXPECT_EQ(side_of(line_of(box, Side::Top), {4, 1}), -1) << "the top is where y is small";
    EXPECT_EQ(side_of(line_of(box, Side::Left), {0, 3}), -1);
    EXPECT_EQ(side_of(line_of(box, Side::Right), {8, 3}), -1);
    EXPECT_EQ(side_of(line_of(box, Side::Bottom), {4, 6}), -1);
}

// Fig. 4.2: above, below, right, left.
TEST(ClipPlane, TheNineRegions) {
    const ClipBox box{{0, 0}, {4, 4}};
    const int codes[3][3] = {{0b1001, 0b1000, 0b1010}, {0b0001, 0b0000, 0b0010}, {0b0101, 0b0100, 0b0110}};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            EXPECT_EQ(outcode(box, {static_cast<float>(4 * column - 2), static_cast<float>(4 * row - 2)}),
                      codes[row][column]);
    EXPECT_EQ(outcode(box, {0, 4}), 0) << "the border is inside";
    EXPECT_EQ(outcode(box, {-0.0f, 0}), 0);
    EXPECT_EQ(outcode(box, {-0x1p-149f, 0}), 1);
}

TEST(ClipPlane, ConvexWindows) {
    const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    EXPECT_TRUE(is_convex(square));
    EXPECT_TRUE(is_convex(Points(square.rbegin(), square.rend()))) << "either winding";
    EXPECT_EQ(convex_window(square)->size(), 4u);
    for (const auto& polygon : {square, Points(square.rbegin(), square.rend())}) {
        const auto window = convex_window(polygon);
        for (const ClipLine& side : *window) EXPECT_EQ(side_of(side, {2, 2}), 1);
    }
    EXPECT_TRUE(is_convex(Points{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 4}, {0, 4}}))
        << "repeated corners";
    EXPECT_EQ(convex_window(Points{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}})->size(), 4u);
    EXPECT_TRUE(is_convex(Points{{0, 0}, {1, 0}, {3, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}}))
        << "straight corners";
    EXPECT_TRUE(is_convex(Points{{-0.0f, 0}, {0.0f, -0.0f}, {1, 0}, {0, 1}})) << "-0 is 0";
    EXPECT_TRUE(is_convex(Points{{-3e38f, -3e38f}, {3e38f, -3e38f}, {0, 3e38f}}));
    EXPECT_TRUE(is_convex(Points{{0, 0}, {0x1p-149f, 0}, {0, 0x1p-149f}}));
}

TEST(ClipPlane, WindowsThatAreRefused) {
    const auto not_convex = Refusal::NotConvex, no_area = Refusal::NoArea;
    EXPECT_EQ(refusal({{0, 0}, {4, 0}, {1, 1}, {0, 4}}), not_convex) << "a dent";
    EXPECT_EQ(refusal({{0, 0}, {4, 4}, {4, 0}, {0, 4}}), not_convex) << "a bow tie";
    EXPECT_EQ(refusal({{0, -5}, {3, 4}, {-5, -2}, {5, -2}, {-3, 4}}), not_convex) << "a pentagram";
    EXPECT_EQ(refusal({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}), not_convex)
        << "twice";
    EXPECT_EQ(refusal({{0, 0}, {6, 0}, {4, 0}, {4, 4}, {0, 4}}), not_convex) << "a spike";
    EXPECT_EQ(refusal({{0, 0}, {4, 0}, {4, 6}, {4, 4}, {0, 4}}), not_convex) << "a spike upwards";
    EXPECT_EQ(refusal({}), no_area);
    EXPECT_EQ(refusal({{1, 1}, {2, 3}}), no_area);
    EXPECT_EQ(refusal({{1, 1}, {1, 1}, {1, 1}}), no_area);
    EXPECT_EQ(refusal({{0, 0}, {1, 1}, {3, 3}, {2, 2}}), no_area);
    EXPECT_EQ(refusal({{0, 0}, {1, NAN}, {3, 0}}), Refusal::NotFinite);
    EXPECT_EQ(refusal({{0, 0}, {1, INFINITY}, {3, 0}}), Refusal::NotFinite);
}

// A corner a hair inside or outside of the side between its neighbours: exact or wrong.
TEST(ClipPlane, ConvexityIsExact) {
    hard::Random random(1);
    int dented = 0;
    for (int i = 0; i < hard::cases(5000); ++i) {
        const glm::vec2 a(hard::real(random, 0, 1), hard::real(random, 0, 1)), b = a + glm::vec2(8, 3);
        const glm::vec2 middle(hard::moved((a.x + b.x) / 2, random.integer(-1, 1)),
                               hard::moved((a.y + b.y) / 2, random.integer(-1, 1)));
        const bool right = exact::twice_area(Points{a, middle, b}) >= 0;
        dented += !right;
        ASSERT_EQ(is_convex(Points{a, middle, b, {2, 20}}), right);
    }
    EXPECT_GT(dented, 1000);
}

// cross_side: the point is rounded, its code is not.
TEST(ClipPlane, TheCodeOfACrossingIsThatOfTheExactPlace) {
    const ClipBox box{{0, 0}, {10, 10}};
    const float e = 0x1p-149f;
    const Segment past{{-e, 0}, {3, -e}};  // the least float beyond the corner (0, 0)
    const SideCrossing left = cross_side(past, box, Side::Left);
    EXPECT_EQ(left.point, glm::vec2(0, 0)) << "rounding moves it onto the corner,";
    EXPECT_EQ(left.code, outcode_of(Side::Top)) << "but it lies beyond";
    EXPECT_EQ(cross_side({past.b, past.a}, box, Side::Left).code, left.code);
    const Segment through{{-3, 3}, {3, -3}};
    EXPECT_EQ(cross_side(through, box, Side::Left).code, 0);
    EXPECT_EQ(cross_side(through, box, Side::Top).code, 0);
}

}  // namespace
}  // namespace relevo::pipeline
