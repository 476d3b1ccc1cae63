#include "pipeline/split_bridges.hpp"

#include <gtest/gtest.h>

#include "tests/pipeline/shape_oracle.hpp"

namespace relevo::pipeline {
namespace {

namespace exact = tests::exact;
namespace hard = tests::hard;
using Points = std::vector<glm::vec2>;
using Rings = std::vector<Points>;

struct Watch {
    std::vector<BridgeRemoved> bridges;
    std::vector<PieceFound> pieces;
    void on(const BridgeRemoved& e) { bridges.push_back(e); }
    void on(const PieceFound& e) { pieces.push_back(e); }
};

// Fig. 4.9: a U that hangs into the window falls into its two legs.
TEST(SplitBridges, TheConcaveCaseOfTheTextbook) {
    const Points u{{1, -2}, {9, -2}, {9, 6}, {7, 6}, {7, -1}, {3, -1}, {3, 6}, {1, 6}};
    const ClippedRing clipped = clip_ring_sutherland_hodgman(u, ClipBox{{0, 0}, {10, 8}});
    EXPECT_EQ(clipped.points.size(), 8u) << "one polygon with an edge there and back along the top";
    Watch w;
    const auto pieces = split_bridges(clipped, w);
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_EQ(w.pieces.size(), 2u);
    ASSERT_EQ(w.bridges.size(), 1u);
    EXPECT_EQ(w.bridges[0].side, 0u) << "the top";
    EXPECT_EQ(w.bridges[0].from, glm::vec2(3, 0));
    EXPECT_EQ(w.bridges[0].to, glm::vec2(7, 0));
    for (const Points& piece : pieces) {
        EXPECT_EQ(piece.size(), 4u);
        EXPECT_EQ(exact::twice_area(piece), 24);
    }
}

TEST(SplitBridges, CombsOfManyTeethInBothWindings) {
    for (const int teeth : {1, 2, 5, 1000})
        for (const bool reversed : {false, true}) {
            Points polygon = hard::comb(teeth);
            if (reversed) std::ranges::reverse(polygon);
            const ClipBox box{{-1, 0}, {static_cast<float>(4 * teeth), 3}};
            const auto pieces = split_bridges(clip_ring_sutherland_hodgman(polygon, box));
            ASSERT_EQ(pieces.size(), std::size_t(teeth));
            for (const Points& piece : pieces) {
                ASSERT_EQ(piece.size(), 4u);
                ASSERT_EQ(exact::twice_area(piece), reversed ? -12 : 12);
            }
        }
}

TEST(SplitBridges, PiecesThatTouchInAPoint) {
    // two teeth that meet in (4, 0), and a notch whose tip touches the top from below
    const Points teeth{{-2, -4}, {10, -4}, {10, -1}, {6, 5}, {4, 0}, {2, 5}, {-2, -1}};
    const auto two = split_bridges(clip_ring_sutherland_hodgman(teeth, ClipBox{{-9, 0}, {19, 9}}));
    EXPECT_EQ(two.size(), 2u);
    for (const Points& piece : two) EXPECT_EQ(piece.size(), 3u);
    const Points notched{{0, -2}, {8, -2}, {8, 6}, {6, 6}, {4, 0}, {2, 6}, {0, 6}};
    const auto legs = split_bridges(clip_ring_sutherland_hodgman(notched, ClipBox{{-9, 0}, {19, 9}}));
    ASSERT_EQ(legs.size(), 2u);
    for (const Points& leg : legs) EXPECT_EQ(exact::twice_area(leg), 36);
}

TEST(SplitBridges, WhatNeedsNoSplittingStays) {
    const ClipBox box{{0, 0}, {10, 10}};
    const Points inside{{1, 1}, {9, 2}, {5, 3}, {4, 9}};
    EXPECT_EQ(split_bridges(clip_ring_sutherland_hodgman(inside, box)), Rings{inside});
    EXPECT_TRUE(split_bridges(ClippedRing{}).empty());
    const Points touching{{0, 5}, {5, 1}, {9, 5}, {5, 9}};  // one corner on the border
    EXPECT_EQ(split_bridges(clip_ring_sutherland_hodgman(touching, box)), Rings{touching});
    const Points round{{-5, -5}, {15, -5}, {15, 15}, {-5, 15}};
    const auto all = split_bridges(clip_ring_sutherland_hodgman(round, box));
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(exact::twice_area(all[0]), 200);
}

// Areas of the pieces sum to the exact area; for simple polygons every piece has the winding of the whole,
// and no point or edge is shared by two pieces along the border.
TEST(SplitBridges, AreasSumToTheExactOne) {
    const Points windows[] = {{{1, -5}, {9, -5}, {9, 5}, {1, 5}},
                              {{-7, -7}, {7, -3}, {3, 9}},
                              {{-6, 4}, {-3, 1}, {4, 2}, {6, 5}, {1, 9}}};
    std::size_t most = 0;
    for (int i = 0; i < hard::cases(1500); ++i) {
        hard::Random r{std::uint64_t(i)};
        const bool simple = i % 4 != 0;
        const Points polygon = simple ? hard::star(r, 14, 14, i % 4 == 1 ? 1 : 1e5) : hard::tangle(r, 9, 9);
        const Points& window = windows[std::size_t(i) % std::size(windows)];
        const ClippedRing clipped = clip_ring_sutherland_hodgman(polygon, window);
        const auto pieces = split_bridges(clipped);
        const exact::Rational whole = exact::twice_area(clipped.points),
                              sum = exact::twice_area_of_all(pieces);
        if (i % 3 == 0) {
            ASSERT_EQ(sum, whole) << i << ": an upright window";
        } else {
            ASSERT_LE(static_cast<double>(abs(sum - whole)), exact::area_slack(pieces)) << i;
        }
        const auto right = exact::twice_common_area(polygon, window) * exact::twice_area(window).sign();
        ASSERT_LE(static_cast<double>(abs(exact::twice_area(clipped.points) - right)),
                  exact::area_slack({clipped.points}))
            << i;
        most = std::max(most, pieces.size());
        if (!simple) continue;
        for (const Points& piece : pieces) {
            ASSERT_GE(piece.size(), 3u);
            // a sliver may turn over where its corners are rounded
            if (static_cast<double>(abs(exact::twice_area(piece))) > exact::area_slack({piece})) {
                ASSERT_EQ(exact::twice_area(piece).sign(), exact::twice_area(polygon).sign()) << i;
            }
        }
    }
    EXPECT_GE(most, 3u);
}

}  // namespace
}  // namespace relevo::pipeline
