#include "samples/io/polygon.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace relevo::io {
namespace {

using Indices = std::vector<std::uint32_t>;

glm::dvec3 area_of(const std::vector<glm::dvec3>& corners) {
    return area_vector(corners.size(), [&](std::size_t i) { return corners[i]; });
}

TEST(AreaVector, IsTwiceTheAreaAlongTheNormal) {
    EXPECT_EQ(area_of({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}), glm::dvec3(0, 0, 6));
    EXPECT_EQ(area_of({{0, 0, 5}, {0, 3, 5}, {2, 0, 5}}), glm::dvec3(0, 0, -6));
    EXPECT_EQ(area_of({{1, 1, 1}, {1, 2, 1}, {1, 2, 2}, {1, 1, 2}}), glm::dvec3(2, 0, 0));
}

TEST(AreaVector, IsRightForPolygonsThatAreNotConvex) {
    // An arrow head whose first triangle of the fan turns the other way.
    EXPECT_EQ(area_of({{1, 1, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}).z, 2 * (16 - 2));
    EXPECT_EQ(area_of({{0, 0, 0}, {1, 3, 0}, {0, 1, 0}, {-1, 3, 0}}).z, 2.0);
}

TEST(Unit, HasLengthOneOrZero) {
    EXPECT_EQ(unit({0, 0, 6}), pipeline::Vec3(0, 0, 1));
    EXPECT_EQ(unit({0, 0, 0}), pipeline::Vec3(0, 0, 0));
    EXPECT_EQ(unit({0, -1e-90, 0}), pipeline::Vec3(0, -1, 0));
    EXPECT_EQ(unit({1e77, 0, 0}), pipeline::Vec3(1, 0, 0));
}

TEST(AppendFan, StartsAtTheFirstCorner) {
    Indices indices{9};
    append_fan(Indices{4, 5, 6, 7}, indices);
    EXPECT_EQ(indices, (Indices{9, 4, 5, 6, 4, 6, 7}));
}

}  // namespace
}  // namespace relevo::io
