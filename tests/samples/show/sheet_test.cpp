// Pages: nothing overflows, whatever the names and sizes are.
#include "samples/show/sheet.hpp"

#include <gtest/gtest.h>

namespace relevo::show {
namespace {

Heading heading() { return {7, 16, "window", "What happens here.", "scene · 640×480"}; }

TEST(Wrapped, BreaksBetweenWords) {
    EXPECT_EQ(wrapped("one two three", 7), (std::vector<std::string>{"one two", "three"}));
    EXPECT_EQ(wrapped("one two three", 100), (std::vector<std::string>{"one two three"}));
    EXPECT_EQ(wrapped("", 5), (std::vector<std::string>{""}));
    EXPECT_EQ(wrapped("incomprehensible", 8), (std::vector<std::string>{"incom..."}));
    EXPECT_EQ(wrapped("≤≤≤ ≥≥≥", 7).size(), 1u);
}

TEST(Page, GivesTheAreaThatWasAskedFor) {
    for (const auto& [width, height] :
         {std::pair(1, 1), {3, 5}, {804, 800}, {2048, 64}, {64, 2048}, {2048, 2048}}) {
        const Page page = lay_out(heading(), {{"Block", {pair("name", "value")}}}, width, height);
        EXPECT_GE(page.area.width, width);
        EXPECT_GE(page.area.height, height);
        EXPECT_EQ(common(page.area, {0, 0, page.picture.width(), page.picture.height()}), page.area);
        EXPECT_GE(page.picture.width(), 1000);
    }
}

TEST(Page, ALongPanelMakesALongPage) {
    std::vector<PanelBlock> panel(40, {"Block", {pair("name", "value"), words("some words")}});
    EXPECT_GT(lay_out(heading(), panel, 804, 800).picture.height(), 40 * 60);
    EXPECT_LT(lay_out(heading(), {}, 804, 800).picture.height(), 1000);
}

TEST(Page, LongNamesStayInThePanel) {
    const std::string endless(300, 'W');
    const Heading long_heading{16, 16, endless, endless, endless};
    const std::vector<PanelBlock> panel{
        {endless,
         {pair(endless, endless), words(endless), quiet(endless), ramp(ink, paper, endless, endless),
          sample(PanelRow::Kind::Square, blue, endless, endless)}}};
    const Page page = lay_out(long_heading, panel, 804, 800);
    for (int y = 100; y < page.picture.height(); ++y) {
        for (int x = page.area.x; x < page.area.right(); ++x)
            if (y >= page.area.y) {
                ASSERT_EQ(page.picture.at(x, y), paper) << "text in the picture's area";
            }
        for (int x = page.picture.width() - page_margin; x < page.picture.width(); ++x)
            ASSERT_EQ(page.picture.at(x, y), paper) << "text in the margin";
    }
}

TEST(Matrix, HasFourRowsOfEightLettersANumber) {
    const double m[4][4] = {{1, -0.123456, 1e-20, 12345678}, {0, 1, 0, -1.5e-9}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    const std::vector<PanelRow> rows = matrix_rows(m);
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0].left, "       1 -0.1235       0 1.235e7");
    for (const PanelRow& row : rows) EXPECT_LE(letters(row.left), panel_columns);
}

TEST(Label, StaysInsideAndNeedsAPlace) {
    Picture picture(120, 60, paper);
    const Canvas canvas = within(canvas_of(picture), {10, 10, 100, 40});
    for (const Align align : {Align::Left, Align::Middle, Align::Right})
        for (const Spot at :
             {Spot{-500, 20}, Spot{5000, 20}, Spot{50, -1e20}, Spot{50, 1e20}, Spot{50, std::nan("")}})
            label(canvas, at, "a rather long label", ink, align);
    for (int x = 0; x < 120; ++x)
        for (int y = 0; y < 60; ++y)
            if (x < 10 || x >= 110 || y < 10 || y >= 50) {
                ASSERT_EQ(picture.at(x, y), paper);
            }
}

}  // namespace
}  // namespace relevo::show
