// Outlines that cross or touch themselves, and outlines that do not.
#include "pipeline/simple_polygon.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace relevo::pipeline {
namespace {

using Points = std::vector<glm::vec2>;
using Crossing = std::optional<std::pair<std::size_t, std::size_t>>;

Crossing at(std::size_t i, std::size_t j) { return std::pair(i, j); }

TEST(SimplePolygon, EdgesThatCross) {
    EXPECT_EQ(crossing_of(Points{{0, 0}, {10, 5}, {10, 0}, {0, 5}}), at(0, 2));
    EXPECT_EQ(crossing_of(Points{{0, 0}, {0, 0}, {10, 5}, {10, 0}, {10, 0}, {0, 5}}), at(1, 4))
        << "repeated corners";
    EXPECT_EQ(crossing_of(Points{{0, -9}, {5, 7}, {-9, -3}, {9, -3}, {-5, 7}}), at(0, 2)) << "a star";
    EXPECT_EQ(crossing_of(Points{{0, 0}, {4, 0}, {4, 4}, {2, -1}, {0, 4}}), at(0, 2));
}

TEST(SimplePolygon, EdgesThatTouch) {
    EXPECT_EQ(crossing_of(Points{{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}), at(0, 2)) << "a corner on an edge";
    EXPECT_EQ(crossing_of(Points{{0, 0}, {5, 5}, {0, 10}, {10, 10}, {5, 5}, {10, 0}}), at(0, 3))
        << "one corner twice";
    EXPECT_EQ(crossing_of(Points{{0, 0}, {8, 0}, {8, 8}, {6, 8}, {6, 0}, {2, 0}, {2, 8}, {0, 8}}), at(0, 3))
        << "a common stretch";
}

TEST(SimplePolygon, EdgesThatFoldBack) {
    EXPECT_EQ(crossing_of(Points{{0, 0}, {8, 0}, {8, 12}, {8, 8}, {0, 8}}), at(1, 2));
    EXPECT_EQ(crossing_of(Points{{0, -4}, {0, 0}, {8, 0}, {8, 8}, {0, 8}}), at(0, 4)) << "at the end";
}

TEST(SimplePolygon, SimpleOnes) {
    EXPECT_EQ(crossing_of(Points{{0, 0}, {8, 4}, {0, 8}, {2, 4}}), std::nullopt) << "an arrow";
    EXPECT_EQ(crossing_of(Points{{0, 8}, {0, 0}, {8, 0}, {8, 8}, {6, 8}, {6, 2}, {2, 2}, {2, 8}}),
              std::nullopt);
    EXPECT_EQ(crossing_of(Points{{0, 0}, {4, 0}, {8, 0}, {8, 8}, {8, 8}, {4, 5}, {0, 8}, {0, 0}}),
              std::nullopt)
        << "straight on, and repeated corners";
    EXPECT_EQ(crossing_of(Points{{0, 0}, {8, 0}, {0, 8}}), std::nullopt);
    EXPECT_EQ(crossing_of(Points{{0, 0}, {9, 9}, {4, 4}, {6, 6}}), std::nullopt) << "no area";
    EXPECT_EQ(crossing_of(Points{}), std::nullopt);
}

// The dent ends one unit of the last place before the slanted edge, on it, and behind it.
TEST(SimplePolygon, IsExact) {
    const auto with_dent_to = [](float y) {
        return crossing_of(Points{{0, 0}, {3, 1}, {3, 9}, {1.5f, y}, {0, 9}});
    };
    constexpr float far = std::numeric_limits<float>::max();
    EXPECT_EQ(with_dent_to(std::nextafter(0.5f, far)), std::nullopt);
    EXPECT_EQ(with_dent_to(0.5f), at(0, 2));
    EXPECT_EQ(with_dent_to(std::nextafter(0.5f, -far)), at(0, 2));
}

}  // namespace
}  // namespace relevo::pipeline
