#include "pipeline/clip_line_midpoint.hpp"

#include <gtest/gtest.h>

#include "tests/pipeline/clip_oracle.hpp"

namespace relevo::pipeline {
namespace {

struct Watch {
    std::vector<SegmentHalved> halved;
    void on(const SegmentHalved& e) { halved.push_back(e); }
};

const ClipBox box{{0, 0}, {4, 4}};

TEST(MidpointSubdivision, HalvesUntilTheEndIsFound) {
    Watch w;
    EXPECT_EQ(clip_line_midpoint({{-4, 2}, {12, 2}}, box, w), (Segment{{0, 2}, {4, 2}}));
    ASSERT_FALSE(w.halved.empty());
    EXPECT_EQ(w.halved[0].search, MidpointSearch::Visible);
    EXPECT_EQ(w.halved[0].middle, glm::vec2(4, 2)) << "visible at once";
    EXPECT_EQ(w.halved[1].search, MidpointSearch::FirstVisible);
    EXPECT_EQ(w.halved[1].middle, glm::vec2(0, 2));
    EXPECT_TRUE(w.halved[1].keeps_first) << "still visible: the end lies before";
    for (const SegmentHalved& e : w.halved) EXPECT_EQ(e.middle.y, 2);
    EXPECT_LT(w.halved.size(), 400u);
}

TEST(MidpointSubdivision, DropsTheHalfBeyondASide) {
    Watch w;
    EXPECT_EQ(clip_line_midpoint({{-12, 1}, {4, 1}}, box, w), (Segment{{0, 1}, {4, 1}}));
    EXPECT_EQ(w.halved[0].search, MidpointSearch::FirstVisible) << "one end is visible: no search for one";
    EXPECT_EQ(w.halved[0].middle, glm::vec2(-4, 1));
    EXPECT_FALSE(w.halved[0].keeps_first);
    Watch rejected;
    EXPECT_FALSE(clip_line_midpoint({{-3, 3}, {3, 9}}, box, rejected));
    ASSERT_EQ(rejected.halved.size(), 2u)
        << "(0, 6) is below, as (3, 9) is; then (-1.5, 4.5) is below and left";
    EXPECT_TRUE(rejected.halved[0].keeps_first);
    EXPECT_EQ(rejected.halved[1].middle, glm::vec2(-1.5f, 4.5f));
    EXPECT_EQ(rejected.halved[1].middle_code, 0b0101);
}

TEST(MidpointSubdivision, EndsForAllFloats) {
    Watch w;
    const ClipBox tiny{{0, 0}, {0x1p-149f, 0x1p-149f}};
    EXPECT_EQ(clip_line_midpoint({{-3e38f, -3e38f}, {2.9e38f, 2.9e38f}}, tiny, w),
              (Segment{{0, 0}, {0x1p-149f, 0x1p-149f}}));
    EXPECT_LE(w.halved.size(), 3 * 281u);
    Watch corner;  // it only touches, at a third of its length
    EXPECT_EQ(clip_line_midpoint({{-1, 5}, {2, 2}}, {{0, 0}, {0, 4}}, corner), (Segment{{0, 4}, {0, 4}}));
    EXPECT_LT(corner.halved.size(), 200u);
    Watch beside;
    EXPECT_FALSE(clip_line_midpoint({{-1, 5.000001f}, {2, 2}}, {{0, 0}, {0, 4}}, beside));
}

TEST(MidpointSubdivision, Neighbours) {
    EXPECT_TRUE(are_neighbours(1.0f, 1.0f));
    EXPECT_TRUE(are_neighbours(1.0f, 0x1.000002p0f));
    EXPECT_FALSE(are_neighbours(1.0f, 0x1.000004p0f));
    EXPECT_TRUE(are_neighbours(0.0f, -0.0f));
    EXPECT_TRUE(are_neighbours(-0x1p-149f, 0.0f));
    EXPECT_FALSE(are_neighbours(-0x1p-149f, 0x1p-149f));
    EXPECT_FALSE(are_neighbours(-3e38f, 3e38f));
}

}  // namespace
}  // namespace relevo::pipeline
