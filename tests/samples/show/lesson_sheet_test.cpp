// Pages and strips of lessons: what is lit is where it should be, nothing leaves its place, and the bytes are
// those of the picture kept beside this test.
#include "samples/show/lesson_sheet.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "samples/io/picture.hpp"
#include "samples/io/png.hpp"
#include "tests/samples/show/demo_lesson.hpp"

namespace relevo::show {
namespace {

using Kind = Mark::Kind;

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
const scene::LessonAxes axes{};

// The colour near the lower right corner of a pixel's square, where no shape of the demo passes.
Rgba8 color_of(const LessonPage& page, int x, int y) {
    const Rect square = page.grid.square(x, y);
    return page.picture.at(square.right() - 6, square.bottom() - 6);
}

// Whether the pictures differ anywhere outside of the rectangle.
::testing::AssertionResult same_outside(const Picture& a, const Picture& b, Rect rect) {
    if (a.width() != b.width() || a.height() != b.height()) return ::testing::AssertionFailure() << "sizes";
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (a.at(x, y) != b.at(x, y) &&
                (x < rect.x || x >= rect.right() || y < rect.y || y >= rect.bottom()))
                return ::testing::AssertionFailure() << "pixel " << x << ", " << y;
    return ::testing::AssertionSuccess();
}

std::string drawing(const Lesson& lesson, std::size_t frame) {
    const LessonPage page = draw_lesson_frame(lesson, axes, frame);
    std::string out;
    for (int y = lesson.view.y0; y <= lesson.view.y1; ++y) {
        for (int x = lesson.view.x0; x <= lesson.view.x1; ++x) {
            const Rgba8 color = color_of(page, x, y);
            out += color == blue ? '#' : color == paper ? '.' : '?';
        }
        out += '\n';
    }
    return out;
}

// The demo without what hides corners.
Lesson cells_only() {
    Lesson lesson = demo_lesson();
    lesson.ground.clear();
    for (LessonFrame& frame : lesson.frames) frame.now.clear();
    return lesson;
}

TEST(LessonFrame, LightsThePixelsThatAreThereAndKeepsThem) {
    EXPECT_EQ(drawing(cells_only(), 0),
              "...........\n"
              ".#.........\n"
              "...........\n"
              "...........\n"
              "...........\n"
              "...........\n"
              "...........\n");
    EXPECT_EQ(drawing(cells_only(), 7),
              "...........\n"
              ".##........\n"
              "...##......\n"
              ".....##....\n"
              ".......##..\n"
              "...........\n"
              "...........\n")
        << "columns 0 to 7, from row 0 to row 3";
}

TEST(LessonFrame, ALevelIsAPartOfTheColour) {
    Lesson lesson = cells_only();
    lesson.frames[0].stays = {{Kind::Cell, vermilion, {{2, 2}}, 0, 0, 100, ""},
                              {Kind::Cell, vermilion, {{3.4, 1.6}}, 0, 0, 300, ""}};
    const LessonPage page = draw_lesson_frame(lesson, axes, 0);
    EXPECT_EQ(color_of(page, 2, 2), mixed(paper, vermilion, 100));
    EXPECT_EQ(color_of(page, 3, 2), vermilion);
}

TEST(LessonFrame, MarksLieOverThePixels) {
    Lesson lesson = cells_only();
    for (int x = 0; x < 9; ++x)
        for (int y = 0; y < 5; ++y)
            lesson.frames[0].stays.push_back({Kind::Cell, blue, {{double(x), double(y)}}});
    const auto color_at = [&](const Mark& mark, double x, double y) {
        Lesson with = lesson;
        with.ground = {mark};
        const LessonPage page = draw_lesson_frame(with, axes, 0);
        const Spot spot = page.grid.spot(x, y);
        return page.picture.at(static_cast<int>(spot.x), static_cast<int>(spot.y));
    };
    const double half_border = 0.5 - 0.04;
    EXPECT_EQ(color_at({Kind::Dot, vermilion, {{3, 2}}}, 3, 2), vermilion);
    EXPECT_EQ(color_at({Kind::Cross, vermilion, {{3, 2}}}, 3, 2), vermilion);
    EXPECT_EQ(color_at({Kind::Frame, vermilion, {{3, 2}}}, 3 + half_border, 2), vermilion);
    EXPECT_EQ(color_at({Kind::Frame, vermilion, {{3, 2}}}, 3, 2), blue);
    EXPECT_EQ(color_at({Kind::Segment, vermilion, {{0, 2}, {8, 2}}}, 4, 2), vermilion);
    EXPECT_EQ(color_at({Kind::Dashes, vermilion, {{0, 2}, {8, 2}}}, 0, 2), vermilion);
    EXPECT_EQ(color_at({Kind::Arrow, vermilion, {{0, 2}, {8, 2}}}, 4, 2), vermilion);
    EXPECT_EQ(color_at({Kind::Path, vermilion, {{0, 2}, {8, 2}, {8, 4}}}, 8, 3), vermilion);
    EXPECT_EQ(color_at({Kind::Outline, vermilion, {{0, 0}, {8, 0}, {8, 4}}}, 4, 2), vermilion) << "closed";
    EXPECT_EQ(color_at({Kind::Area, vermilion, {{0, 0}, {8, 0}, {8, 4}}}, 6, 1), [] {
        Picture one(1, 1, blue);
        blend(one, 0, 0, with_opacity(vermilion, 70));
        return one.at(0, 0);
    }());
    EXPECT_EQ(color_at({Kind::Box, vermilion, {{1, 1}, {5, 3}}}, 5, 2), vermilion);
    for (const Spot place : {Spot{6, 2}, Spot{2, 2}, Spot{4, 1}, Spot{4, 3}})
        EXPECT_EQ(color_at({Kind::Curve, vermilion, {{4, 2}}, 2, 1}, place.x, place.y), vermilion);
}

TEST(LessonFrame, NoMarkLeavesTheGrid) {
    const Lesson plain = demo_lesson();
    Lesson wild = plain;
    const Spot far{1e300, -1e300}, near_far{5000, -4000}, none{nan, infinity}, edge{9.49, -1.49};
    for (const Spot a : {far, near_far, none, edge})
        for (const Kind kind :
             {Kind::Cell, Kind::Frame, Kind::Dot, Kind::Cross, Kind::Segment, Kind::Dashes, Kind::Arrow,
              Kind::Path, Kind::Outline, Kind::Area, Kind::Curve, Kind::Box, Kind::Text})
            for (const std::size_t points : {0u, 1u, 2u, 3u}) {
                Mark mark{kind, vermilion, std::vector<Spot>(points, a), 3, 1e300, 255, std::string(99, 'W')};
                if (points > 1) mark.points[1] = {4, 2};
                wild.ground.push_back(mark);
                mark.radius_y = 60;
                wild.frames[3].now.push_back(mark);
            }
    const LessonPage before = draw_lesson_frame(plain, axes, 3), after = draw_lesson_frame(wild, axes, 3);
    const Rect area = before.grid.area;
    EXPECT_EQ(after.grid.area, area);
    EXPECT_TRUE(same_outside(before.picture, after.picture, area));
    EXPECT_NE(before.picture.pixels(), after.picture.pixels());
    EXPECT_FALSE(draw_lesson_strip(wild, axes).empty());
}

TEST(LessonFrame, AllPagesOfALessonAreLaidOutAlike) {
    Lesson lesson = demo_lesson();
    lesson.frames[2].caption = std::string(300, 'c');
    lesson.frames[4].equation = "a = " + std::string(120, '1');
    lesson.frames[5].row = {"a long cell", "another long cell", "7", "and the last one"};
    lesson.frames[6].row = {};
    const LessonPage first = draw_lesson_frame(lesson, axes, 0);
    for (std::size_t i = 1; i < lesson.frames.size(); ++i) {
        const LessonPage page = draw_lesson_frame(lesson, axes, i);
        EXPECT_EQ(page.picture.width(), first.picture.width());
        EXPECT_EQ(page.picture.height(), first.picture.height());
        EXPECT_EQ(page.grid.area, first.grid.area);
    }
}

TEST(LessonFrame, EndlessWordsStayOnThePage) {
    const std::string endless(400, 'W');
    Lesson lesson = demo_lesson();
    lesson.title = lesson.sentence = lesson.source = endless;
    lesson.columns = std::vector<std::string>(30, endless);
    for (LegendEntry& entry : lesson.legend) entry.words = endless;
    for (LessonFrame& frame : lesson.frames)
        frame.title = frame.equation = frame.caption = endless, frame.row = lesson.columns;
    const LessonPage page = draw_lesson_frame(lesson, axes, 3);
    const Picture strip = draw_lesson_strip(lesson, axes);
    for (const Picture* picture : {&page.picture, &strip}) {
        const int from = picture == &strip ? 0 : 80;
        for (int y = from; y < picture->height(); ++y)
            for (const int x : {0, 10, picture->width() - 10, picture->width() - 1})
                ASSERT_EQ(picture->at(x, y), paper) << x << ", " << y;
        for (int x = 0; x < picture->width(); ++x) ASSERT_EQ(picture->at(x, picture->height() - 1), paper);
    }
}

TEST(LessonFrame, PixelsAreAsLargeAsThereIsRoom) {
    struct Case {
        raster::PixelBox view;
        int least, most;
    };
    for (const Case& c :
         {Case{{0, 0, 11, 8}, 40, 64}, Case{{0, 0, 0, 0}, 64, 64}, Case{{-20, -20, 43, 27}, 8, 14},
          Case{{0, 0, 319, 239}, 1, 2}, Case{{0, 0, 2047, 9}, 1, 1}, Case{{0, 0, 9, 2047}, 1, 1}}) {
        Lesson lesson = demo_lesson();
        lesson.view = c.view;
        const LessonPage page = draw_lesson_frame(lesson, axes, 1);
        EXPECT_GE(page.grid.cell, c.least);
        EXPECT_LE(page.grid.cell, c.most);
        EXPECT_GE(page.picture.width(), lesson_width);
        EXPECT_GE(page.picture.height(), lesson_height);
        const Rect area = page.grid.area;
        EXPECT_EQ(common(area, inset({0, 0, page.picture.width(), page.picture.height()}, 20)), area);
        EXPECT_EQ(area.width, page.grid.cell * (c.view.x1 - c.view.x0 + 1));
    }
}

TEST(LessonFrame, SmallPixelsHaveNoLinesBetweenThem) {
    Lesson lesson = cells_only();
    const auto colors = [&](raster::PixelBox view) {
        lesson.view = view;
        lesson.frames[0].stays.clear();
        const LessonPage page = draw_lesson_frame(lesson, axes, 0);
        std::set<int> reds;
        const Rect area = inset(page.grid.area, 2);
        for (int y = area.y; y < area.bottom(); ++y)
            for (int x = area.x; x < area.right(); ++x) reds.insert(page.picture.at(x, y).r);
        return reds.size();
    };
    EXPECT_EQ(colors({0, 0, 63, 47}), 2u);
    EXPECT_EQ(colors({0, 0, 319, 239}), 1u);
    lesson.grid = false;
    EXPECT_EQ(colors({0, 0, 63, 47}), 1u);
}

// The words along the edges change with the axes, the grid does not.
TEST(LessonFrame, TheEdgesSpeakOfTheAxes) {
    const Lesson lesson = demo_lesson();
    const LessonPage page = draw_lesson_frame(lesson, {}, 2),
                     moved = draw_lesson_frame(lesson, {2, 3, false}, 2);
    EXPECT_EQ(page.grid.area, moved.grid.area);
    const auto part = [](const Picture& picture, Rect rect) {
        std::vector<int> reds;
        for (int y = rect.y; y < rect.bottom(); ++y)
            for (int x = rect.x; x < rect.right(); ++x) reds.push_back(picture.at(x, y).r);
        return reds;
    };
    const auto above = [&](const LessonPage& p, int x) {
        const Rect square = p.grid.square(x, p.grid.view.y0);
        return part(p.picture, {square.x, square.y - 24, square.width, 20});
    };
    const auto beside = [&](const LessonPage& p, int y) {
        const Rect square = p.grid.square(p.grid.view.x0, y);
        return part(p.picture, {square.x - 20, square.y, 14, square.height});
    };
    EXPECT_EQ(above(page, 6), above(moved, 4)) << "pixel 4 is called 6";
    EXPECT_NE(above(page, 4), above(moved, 4));
    EXPECT_EQ(beside(page, 4), beside(moved, 1));
    const LessonPage up = draw_lesson_frame(lesson, {0, 4, true}, 2);
    EXPECT_EQ(beside(page, 3), beside(up, 1)) << "y grows upwards: row 1 is called 4 - 1";
}

TEST(LessonFrame, TheRowOfTheFrameIsSetOff) {
    const Lesson lesson = demo_lesson();
    const auto yellow_rows = [&](std::size_t i) {
        const Picture picture = draw_lesson_frame(lesson, axes, i).picture;
        std::set<int> rows;
        for (int y = 100; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (picture.at(x, y) == yellow) rows.insert(y);
        return rows;
    };
    EXPECT_EQ(yellow_rows(0).size(), 26u);
    EXPECT_GT(*yellow_rows(3).begin(), *yellow_rows(2).begin());
    EXPECT_EQ(yellow_rows(6), yellow_rows(7)) << "full: older rows leave";
}

TEST(LessonStrip, PrintsAllFramesOrTwelveWithBothEnds) {
    EXPECT_EQ(frames_to_print(1), (std::vector<std::size_t>{0}));
    EXPECT_EQ(frames_to_print(12).size(), 12u);
    for (std::size_t frames = 13; frames < 200; ++frames) {
        const std::vector<std::size_t> chosen = frames_to_print(frames);
        ASSERT_EQ(chosen.size(), printed_frames);
        EXPECT_EQ(chosen.front(), 0u);
        EXPECT_EQ(chosen.back(), frames - 1);
        EXPECT_EQ(std::adjacent_find(chosen.begin(), chosen.end(), std::greater_equal<>()), chosen.end());
    }
}

// The picture is kept in the tree. To look at a new one: it is in the test's temporary folder.
TEST(LessonStrip, IsThePictureInTheTree) {
    Lesson lesson = demo_lesson();
    lesson.frames.resize(3);
    lesson.view = {-1, -1, 4, 2};
    const Picture strip = draw_lesson_strip(lesson, {0, 3, true});
    const auto kept = io::read_image(RELEVO_SOURCE_DIR "/tests/samples/show/data/lesson_strip.png");
    ASSERT_TRUE(kept) << kept.error().text();
    const bool same = kept->width() == strip.width() && kept->pixels() == strip.pixels();
    if (!same) {
        EXPECT_FALSE(io::write_png(::testing::TempDir() + "lesson_strip.png", strip));
    }
    EXPECT_TRUE(same) << "the new one: " << ::testing::TempDir() << "lesson_strip.png";
}

TEST(LessonStrip, AndThePagesAreTheSameEachTime) {
    EXPECT_EQ(draw_lesson_strip(demo_lesson(), axes).pixels(),
              draw_lesson_strip(demo_lesson(), axes).pixels());
    EXPECT_EQ(draw_lesson_frame(demo_lesson(), axes, 2).picture.pixels(),
              draw_lesson_frame(demo_lesson(), axes, 2).picture.pixels());
}

}  // namespace
}  // namespace relevo::show
