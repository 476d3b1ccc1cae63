#include "pipeline/link_rings.hpp"

#include <gtest/gtest.h>

namespace relevo::pipeline {
namespace {

using Rings = std::vector<std::vector<std::size_t>>;

// Pieces between numbered points.
std::vector<RingPiece> pieces(std::span<const glm::vec2> points,
                              const std::vector<std::pair<std::size_t, std::size_t>>& ends) {
    std::vector<RingPiece> out;
    for (const auto& [from, to] : ends) {
        const ClipLine line{points[from], points[to]};
        out.push_back({from, to, line, line});
    }
    return out;
}

TEST(LinkRings, FollowsPiecesInAnyOrder) {
    const glm::vec2 points[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    EXPECT_EQ(link_rings(pieces(points, {{2, 3}, {0, 1}, {3, 0}, {1, 2}})), (Rings{{0, 2, 1, 3}}));
    EXPECT_TRUE(link_rings({}).empty());
}

// An hourglass: two triangles, clockwise as seen, that touch in point 0. One ring would be an eight.
TEST(LinkRings, RingsThatTouchAreSeparate) {
    const glm::vec2 points[] = {{0, 0}, {2, 4}, {-2, 4}, {-2, -4}, {2, -4}};
    const Rings two{{0, 1, 2}, {3, 4, 5}};
    EXPECT_EQ(link_rings(pieces(points, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}})), two);
    EXPECT_EQ(link_rings(pieces(points, {{0, 3}, {3, 4}, {4, 0}, {0, 1}, {1, 2}, {2, 0}})), two);
}

TEST(LinkRings, SharpestTurnToTheInside) {
    const ClipLine east{{0, 0}, {1, 0}}, west{{0, 0}, {-1, 0}}, north{{0, 0}, {0, -1}}, south{{0, 0}, {0, 1}},
        back_south{{0, 0}, {-1, 1}}, ahead_south{{0, 0}, {1, 1}}, back_north{{0, 0}, {-1, -1}};
    const ClipLine order[] = {back_south, south, ahead_south, east, north, back_north, west};
    for (std::size_t i = 0; i < std::size(order); ++i)
        for (std::size_t k = 0; k < std::size(order); ++k)
            EXPECT_EQ(turns_sooner(east, order[i], order[k]), i < k) << i << " " << k;
}

TEST(LinkRings, WhatDoesNotCloseIsLeftOut) {
    const glm::vec2 points[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {9, 9}};
    EXPECT_EQ(link_rings(pieces(points, {{3, 4}, {0, 1}, {1, 2}, {2, 0}})), (Rings{{1, 2, 3}}));
}

}  // namespace
}  // namespace relevo::pipeline
