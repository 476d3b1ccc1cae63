#include "pipeline/clip_line_liang_barsky.hpp"

#include <gtest/gtest.h>

namespace relevo::pipeline {
namespace {

struct Watch {
    std::vector<BoxParameterFound> sides;
    void on(const BoxParameterFound& e) { sides.push_back(e); }
};

// Table 4.1 on the segment (-2, 1) (6, 5) and the window 0..4 x 0..4.
TEST(LiangBarsky, TheTableWithNumbers) {
    Watch w;
    EXPECT_EQ(clip_line_liang_barsky({{-2, 1}, {6, 5}}, {{0, 0}, {4, 4}}, w), (Segment{{0, 2}, {4, 4}}));
    ASSERT_EQ(w.sides.size(), 4u);
    const struct {
        Side side;
        double numerator, denominator;
        Passage passage;
        double t_in, t_out;
    } right[] = {{Side::Left, 2, 8, Passage::Entering, 0.25, 1},
                 {Side::Right, -6, -8, Passage::Leaving, 0.25, 0.75},
                 {Side::Top, -1, 4, Passage::Entering, 0.25, 0.75},
                 {Side::Bottom, -3, -4, Passage::Leaving, 0.25, 0.75}};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(w.sides[i].side, right[i].side);
        EXPECT_EQ(w.sides[i].numerator, right[i].numerator);
        EXPECT_EQ(w.sides[i].denominator, right[i].denominator);
        EXPECT_EQ(w.sides[i].t, right[i].numerator / right[i].denominator);
        EXPECT_EQ(w.sides[i].passage, right[i].passage);
        EXPECT_EQ(w.sides[i].t_in, right[i].t_in);
        EXPECT_EQ(w.sides[i].t_out, right[i].t_out);
        EXPECT_FALSE(w.sides[i].empty);
    }
}

TEST(LiangBarsky, ParallelSegments) {
    Watch inside, outside;
    EXPECT_EQ(clip_line_liang_barsky({{-2, 4}, {6, 4}}, {{0, 0}, {4, 4}}, inside), (Segment{{0, 4}, {4, 4}}));
    EXPECT_EQ(inside.sides[2].passage, Passage::ParallelInside);
    EXPECT_TRUE(std::isnan(inside.sides[2].t));
    EXPECT_FALSE(clip_line_liang_barsky({{-2, 5}, {6, 5}}, {{0, 0}, {4, 4}}, outside));
    EXPECT_EQ(outside.sides.back().side, Side::Bottom);
    EXPECT_EQ(outside.sides.back().passage, Passage::ParallelOutside);
    EXPECT_TRUE(outside.sides.back().empty);
}

TEST(LiangBarsky, StopsAtTheSideThatEmptiesTheInterval) {
    Watch w;
    EXPECT_FALSE(clip_line_liang_barsky({{-3, 3}, {3, 9}}, {{0, 0}, {4, 4}}, w));
    EXPECT_EQ(w.sides.size(), 4u);
    EXPECT_EQ(w.sides.back().side, Side::Bottom);
    EXPECT_TRUE(w.sides.back().empty) << "it leaves by the bottom at t = 1/6, before it enters from the left";
}

}  // namespace
}  // namespace relevo::pipeline
