// The letters: every printable one is there, no two look the same, and they keep within their cells.
#include "samples/show/font.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace relevo::show {
namespace {

std::string drawing(int glyph) {
    std::string dots;
    for (int y = 0; y < glyph_height; ++y)
        for (int x = 0; x < glyph_width; ++x) dots += glyph_dot(glyph, x, y) ? '#' : '.';
    return dots;
}

TEST(Font, HasEveryPrintableLetter) {
    for (char32_t letter = 32; letter < 127; ++letter)
        EXPECT_EQ(glyph_of(letter), static_cast<int>(letter) - 32) << static_cast<char>(letter);
    for (const char32_t letter : std::u32string(U"°×±→←↑↓≤≥≠·…∞²µ✓"))
        EXPECT_GT(glyph_of(letter), unknown_glyph);
    EXPECT_EQ(glyph_of(U'☃'), unknown_glyph);
}

TEST(Font, NoTwoGlyphsLookTheSame) {
    std::map<std::string, std::size_t> seen;
    for (std::size_t g = 0; g < glyph_order.size(); ++g) {
        const auto [other, fresh] = seen.emplace(drawing(static_cast<int>(g)), g);
        EXPECT_TRUE(fresh) << "glyphs " << other->second << " and " << g;
    }
    EXPECT_EQ(drawing(0), std::string(glyph_width * glyph_height, '.')) << "only the space is empty";
}

TEST(Font, IsDrawnWithDotsAndHashesInFullRows) {
    for (const std::string_view row : glyph_bands) {
        ASSERT_EQ(row.size(), std::size_t(glyphs_a_band * (glyph_width + 1) - 1));
        for (std::size_t i = 0; i < row.size(); ++i)
            EXPECT_NE(std::string_view(i % 6 == 5 ? " " : ".#").find(row[i]), std::string_view::npos)
                << row << " at " << i;
    }
}

TEST(Font, HasNothingOutsideOfTheCell) {
    const int box = unknown_glyph;
    EXPECT_TRUE(glyph_dot(box, 0, 0));
    EXPECT_FALSE(glyph_dot(box, -1, 0));
    EXPECT_FALSE(glyph_dot(box, glyph_width, 0));
    EXPECT_FALSE(glyph_dot(box, 0, -1));
    EXPECT_FALSE(glyph_dot(box, 0, glyph_height));
}

}  // namespace
}  // namespace relevo::show
