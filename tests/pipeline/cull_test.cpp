#include "pipeline/cull.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace relevo::pipeline {
namespace {

TEST(Cull, CounterClockwiseAsSeenIsTheFront) {
    // y runs down: counter-clockwise as seen has a negative area
    EXPECT_EQ(facing(-1, false), Facing::Front);
    EXPECT_EQ(facing(1, false), Facing::Back);
    EXPECT_EQ(facing(-1, true), Facing::Back) << "a mirror turns it around";
    EXPECT_EQ(facing(1, true), Facing::Front);
    EXPECT_EQ(facing(std::numeric_limits<std::int64_t>::min(), false), Facing::Front);
    EXPECT_EQ(facing(std::numeric_limits<std::int64_t>::max(), false), Facing::Back);
}

TEST(Cull, DropsTheSideItIsNamedAfter) {
    EXPECT_TRUE(is_culled(Facing::Back, Cull::Back));
    EXPECT_FALSE(is_culled(Facing::Front, Cull::Back));
    EXPECT_TRUE(is_culled(Facing::Front, Cull::Front));
    EXPECT_FALSE(is_culled(Facing::Back, Cull::Front));
    EXPECT_FALSE(is_culled(Facing::Front, Cull::None));
    EXPECT_FALSE(is_culled(Facing::Back, Cull::None));
}

}  // namespace
}  // namespace relevo::pipeline
