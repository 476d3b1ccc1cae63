#include "samples/io/corners.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace relevo::io {
namespace {

TEST(Corners, AreNumberedByFirstUse) {
    Corners corners;
    EXPECT_EQ(corners.number({5, -1, -1}), 0u);
    EXPECT_EQ(corners.number({3, -1, -1}), 1u);
    EXPECT_EQ(corners.number({5, -1, 0}), 2u);
    EXPECT_EQ(corners.number({5, 0, -1}), 3u);
    EXPECT_EQ(corners.number({5, -1, -1}), 0u);
    EXPECT_EQ(corners.list().size(), 4u);
    EXPECT_EQ(corners.list()[2], (Corner{5, -1, 0}));
}

TEST(Corners, AgreeWithASortedMap) {
    Corners corners;
    std::map<std::tuple<int, int, int>, std::uint32_t> expected;
    std::uint32_t state = 1;
    const auto next = [&] {
        return static_cast<std::int32_t>((state = state * 1664525 + 1013904223) >> 26) - 1;
    };
    for (int i = 0; i < 200000; ++i) {
        const Corner corner{next() + 1, next(), next()};
        const auto size = static_cast<std::uint32_t>(expected.size());
        const auto number =
            expected.try_emplace({corner.position, corner.normal, corner.uv}, size).first->second;
        ASSERT_EQ(corners.number(corner), number);
    }
}

}  // namespace
}  // namespace relevo::io
