#include "samples/io/suggest.hpp"

#include <gtest/gtest.h>

namespace relevo::io {
namespace {

constexpr std::string_view known[] = {"shading", "depth", "cull", "width", "v"};

TEST(EditDistance, CountsSlips) {
    EXPECT_EQ(edit_distance("", ""), 0u);
    EXPECT_EQ(edit_distance("cull", "cull"), 0u);
    EXPECT_EQ(edit_distance("cul", "cull"), 1u);
    EXPECT_EQ(edit_distance("culll", "cull"), 1u);
    EXPECT_EQ(edit_distance("dull", "cull"), 1u);
    EXPECT_EQ(edit_distance("", "cull"), 4u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(EditDistance, SwappedNeighboursAreOneSlip) {
    EXPECT_EQ(edit_distance("dpeth", "depth"), 1u);
    EXPECT_EQ(edit_distance("ca", "abc"), 3u);
}

TEST(Suggestion, NamesTheNearestWord) {
    EXPECT_EQ(suggestion("shadng", known), ", did you mean 'shading'?");
    EXPECT_EQ(suggestion("widht", known), ", did you mean 'width'?");
    EXPECT_EQ(suggestion("dpth", known), ", did you mean 'depth'?");
}

TEST(Suggestion, IsSilentWhenNothingIsClose) {
    EXPECT_EQ(suggestion("teapot", known), "");
    EXPECT_EQ(suggestion("", known), "");
    EXPECT_EQ(suggestion("x", known), "");  // one slip away from "v", which has one letter
    EXPECT_EQ(suggestion(std::string(100000, 'w'), known), "");
}

}  // namespace
}  // namespace relevo::io
