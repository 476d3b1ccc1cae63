#include "pipeline/clip_line_cohen_sutherland.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/pipeline/clip_oracle.hpp"

namespace relevo::pipeline {
namespace {

namespace hard = tests::hard;

struct Watch {
    std::vector<OutcodesCompared> rounds;
    std::vector<SideCrossed> crossings;
    void on(const OutcodesCompared& e) { rounds.push_back(e); }
    void on(const SideCrossed& e) { crossings.push_back(e); }
};

const ClipBox box{{0, 0}, {10, 10}};

TEST(CohenSutherland, TriviallyAcceptedAndRejected) {
    Watch inside, outside;
    EXPECT_EQ(clip_line_cohen_sutherland({{1, 2}, {10, 0}}, box, order_of_the_bits, inside),
              (Segment{{1, 2}, {10, 0}}));
    EXPECT_EQ(inside.rounds.size(), 1u);
    EXPECT_TRUE(inside.rounds[0].accepted());
    EXPECT_FALSE(clip_line_cohen_sutherland({{-4, 14}, {-1, 5}}, box, order_of_the_bits, outside));
    EXPECT_EQ(outside.rounds.size(), 1u);
    EXPECT_TRUE(outside.rounds[0].rejected()) << "0101 & 0001 = 0001";
    EXPECT_EQ(outside.rounds[0].a, 0b0101);
    EXPECT_EQ(outside.rounds[0].b, 0b0001);
    EXPECT_TRUE(inside.crossings.empty() && outside.crossings.empty());
}

// Fig. 4.3: the end above and to the right. The right side is a useful first choice, the bottom is never one.
TEST(CohenSutherland, TheOrderOfSidesDecidesTheWork) {
    const Segment s{{5, 5}, {15, -3}};  // leaves through the top at x = 11.25, through the right at y = 1
    const auto crossed = [&](const SideOrder& order) {
        Watch w;
        EXPECT_EQ(clip_line_cohen_sutherland(s, box, order, w), (Segment{{5, 5}, {10, 1}}));
        return w.crossings;
    };
    const auto wasteful = crossed({Side::Top, Side::Bottom, Side::Right, Side::Left});
    ASSERT_EQ(wasteful.size(), 2u);
    EXPECT_EQ(wasteful[0].side, Side::Top);
    EXPECT_EQ(wasteful[0].to, glm::vec2(11.25f, 0));
    EXPECT_EQ(wasteful[0].before, 0b1010);
    EXPECT_EQ(wasteful[0].after, 0b0010);
    EXPECT_FALSE(wasteful[0].moves_a);
    EXPECT_TRUE(wasteful[0].wasted());
    EXPECT_EQ(wasteful[1].side, Side::Right);
    EXPECT_FALSE(wasteful[1].wasted());
    EXPECT_EQ(crossed({Side::Bottom, Side::Left, Side::Right, Side::Top}).size(), 1u);
}

TEST(CohenSutherland, FourCrossingsAtMost) {
    Watch w;  // round a corner twice: all four sides
    EXPECT_TRUE(clip_line_cohen_sutherland({{-2, -1}, {12, 11.5f}}, box, order_of_the_bits, w));
    EXPECT_EQ(w.crossings.size(), 4u);
    std::size_t most = 0;
    for (const hard::LineFamily& family : hard::line_families())
        for (int i = 0; i < hard::cases(20'000); ++i) {
            hard::Random random(hard::seed_of(family.name, std::uint64_t(i) + 7'000'000));
            const auto [s, window] = family.make(random);
            SideOrder order = order_of_the_bits;
            for (int k = i % 24; k > 0; --k) std::next_permutation(order.begin(), order.end());
            Watch heard;
            const auto visible = clip_line_cohen_sutherland(s, window, order, heard);
            ASSERT_EQ(visible, clip_line_cohen_sutherland(s, window)) << "any order, any probe";
            ASSERT_LE(heard.crossings.size(), 4u);
            ASSERT_EQ(heard.rounds.size(), heard.crossings.size() + 1);
            most = std::max(most, heard.crossings.size());
            for (const SideCrossed& c : heard.crossings)
                ASSERT_EQ(c.after & outcode_of(c.side), 0) << "the endless loop: the bit must be gone";
        }
    EXPECT_EQ(most, 4u);
}

}  // namespace
}  // namespace relevo::pipeline
