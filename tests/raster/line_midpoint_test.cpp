#include "raster/line_midpoint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <limits>
#include <random>

#include "tests/raster/line_pixels.hpp"

namespace relevo::raster {
namespace {

using tests::all_pixels;
using tests::Pixels;
using Integer = boost::multiprecision::cpp_int;

Pixels midpoint_pixels(Pixel a, Pixel b, const PixelBox& box = all_pixels) {
    Pixels pixels;
    line_midpoint(a, b, box, [&](int x, int y) { pixels.push_back({x, y}); });
    return pixels;
}

TEST(LineMidpoint, TheTextbooksOctant) {
    EXPECT_TRUE(tests::same_drawing(tests::drawing_of_pixels(midpoint_pixels({0, 0}, {7, 3}), 8, 4),
                                    {"##......",  //
                                     "..##....",  //
                                     "....##..",  //
                                     "......##"}));
}

TEST(LineMidpoint, AllOctants) {
    // A star of eight lines around (7, 7). None of them has a tie, so it is symmetric.
    Pixels star;
    for (const int along : {-7, 7})
        for (const int aside : {-3, 3}) {
            std::ranges::copy(midpoint_pixels({7, 7}, {7 + along, 7 + aside}), std::back_inserter(star));
            std::ranges::copy(midpoint_pixels({7, 7}, {7 + aside, 7 + along}), std::back_inserter(star));
        }
    const tests::Drawing right{"....#.....#....", "....#.....#....", ".....#...#.....", ".....#...#.....",
                               "##....#.#....##", "..##..#.#..##..", "....##.#.##....", "......###......",
                               "....##.#.##....", "..##..#.#..##..", "##....#.#....##", ".....#...#.....",
                               ".....#...#.....", "....#.....#....", "....#.....#...."};
    EXPECT_TRUE(tests::same_drawing(tests::drawing_of_pixels(star, 15, 15), right));
}

// The tie rule, seen: a line of slope 1/2 is half way at every other column and stays with its left row;
// a steep one with its upper column.
TEST(LineMidpoint, ATieStaysWithTheStartOfTheWalk) {
    const Pixels down = midpoint_pixels({0, 0}, {4, 2}), up = midpoint_pixels({0, 2}, {4, 0});
    EXPECT_TRUE(tests::same_drawing(tests::drawing_of_pixels(down, 5, 3), {"##...",  //
                                                                           "..##.",  //
                                                                           "....#"}));
    EXPECT_TRUE(tests::same_drawing(tests::drawing_of_pixels(up, 5, 3), {"....#",  //
                                                                         "..##.",  //
                                                                         "##..."}));
    const Pixels steep = midpoint_pixels({2, 4}, {0, 0});
    EXPECT_TRUE(tests::same_drawing(tests::drawing_of_pixels(steep, 3, 5), {"#..",  //
                                                                            "#..",  //
                                                                            ".#.",  //
                                                                            ".#.",  //
                                                                            "..#"}));
}

// The law that each pixel obeys, from the definition: across from the true line at most half a pixel, and on
// a tie the pixel on the side of the walk's start. 2 (k minor - offset major) is twice the way from pixel to
// line, in 1/major.
testing::AssertionResult obeys_the_law(Pixel a, Pixel b, const Pixels& pixels) {
    const int dx = b.x - a.x, dy = b.y - a.y, major = std::max(std::abs(dx), std::abs(dy));
    const bool steep = std::abs(dy) > std::abs(dx);
    if (pixels.size() != std::size_t(major) + 1) return testing::AssertionFailure() << "not one a step";
    if (steep ? a.y > b.y : a.x > b.x) std::swap(a, b);
    if (!(pixels.front() == a) || (major != 0 && !(pixels.back() == b)))
        return testing::AssertionFailure() << "the ends";
    const int minor = steep ? b.x - a.x : b.y - a.y;
    for (int k = 0; k <= major; ++k) {
        const Pixel p = pixels[std::size_t(k)];
        const int along = steep ? p.y - a.y : p.x - a.x, offset = steep ? p.x - a.x : p.y - a.y;
        const int twice = 2 * (k * minor - offset * major);
        const bool tie_ahead = twice == (minor > 0 ? -major : major);  // the pixel lies ahead of the line
        if (along != k || std::abs(twice) > major || (major != 0 && tie_ahead))
            return testing::AssertionFailure() << "step " << k;
    }
    return testing::AssertionSuccess();
}

TEST(LineMidpoint, EverySmallSegment) {
    const PixelBox box{0, 0, 5, 5};
    for (int code = 0; code < 12 * 12 * 12 * 12; ++code) {
        const Pixel a{code % 12 - 3, code / 12 % 12 - 3}, b{code / 144 % 12 - 3, code / 1728 - 3};
        const Pixels pixels = midpoint_pixels(a, b);
        const auto name = [&] {
            return testing::Message() << a.x << "," << a.y << " to " << b.x << "," << b.y;
        };
        ASSERT_TRUE(obeys_the_law(a, b, pixels)) << name();
        ASSERT_EQ(pixels, midpoint_pixels(b, a)) << name();
        ASSERT_TRUE(tests::connected(pixels)) << name();
        ASSERT_EQ(midpoint_pixels(a, b, box), tests::within(pixels, box)) << name();
    }
}

TEST(LineMidpoint, NothingInAnEmptyBox) {
    EXPECT_TRUE(midpoint_pixels({0, 0}, {7, 3}, {3, 0, 2, 9}).empty());
    EXPECT_TRUE(midpoint_pixels({0, 0}, {0, 0}, {0, 5, 9, 4}).empty());
    EXPECT_EQ(midpoint_pixels({4, 4}, {4, 4}), (Pixels{{4, 4}}));
}

// Longer lines through small boxes, against drawing all and discarding.
TEST(LineMidpoint, ABoxIsTheSameAsDiscarding) {
    std::mt19937_64 random(1);
    const auto whole = [&](int low, int high) {
        return low + static_cast<int>(random() % std::uint64_t(high - low + 1));
    };
    for (int i = 0; i < 20000; ++i) {
        const Pixel a{whole(-400, 400), whole(-400, 400)}, b{whole(-400, 400), whole(-400, 400)};
        const int x = whole(-300, 300), y = whole(-300, 300);
        const PixelBox box{x, y, x + whole(0, 200), y + whole(0, 200)};
        ASSERT_EQ(midpoint_pixels(a, b, box), tests::within(midpoint_pixels(a, b), box))
            << a.x << "," << a.y << " to " << b.x << "," << b.y;
    }
}

// The pixels of the box that the formula lights, in big integers: for each step of the box's columns (rows)
// the nearest offset, ties towards the start.
Pixels pixels_by_formula(Pixel a, Pixel b, const PixelBox& box) {
    const Integer width = abs(Integer(b.x) - a.x), height = abs(Integer(b.y) - a.y);
    const bool steep = height > width;
    if (steep ? a.y > b.y : a.x > b.x) std::swap(a, b);
    const Integer major = steep ? height : width, minor = steep ? width : height;
    const int side = (steep ? b.x < a.x : b.y < a.y) ? -1 : 1;
    Pixels pixels;
    for (int along = steep ? box.y0 : box.x0;; ++along) {
        const Integer k = Integer(along) - (steep ? a.y : a.x);
        if (k >= 0 && k <= major) {
            Integer offset = major == 0 ? Integer(0) : (2 * k * minor + major) / (2 * major);
            if (major != 0 && 2 * k * minor + major == 2 * major * offset && offset > 0) --offset;
            const Integer across = (steep ? a.x : a.y) + side * offset;
            if (across >= (steep ? box.x0 : box.y0) && across <= (steep ? box.x1 : box.y1)) {
                const int c = static_cast<int>(across);
                pixels.push_back(steep ? Pixel{c, along} : Pixel{along, c});
            }
        }
        if (along == (steep ? box.y1 : box.x1)) return pixels;
    }
}

TEST(LineMidpoint, SpansOverAllIntegers) {
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    std::mt19937_64 random(2);
    const auto extreme = [&] {
        const int small = static_cast<int>(random() % 7) - 3;
        switch (random() % 5) {
            case 0:
                return least + std::abs(small);
            case 1:
                return most - std::abs(small);
            case 2:
                return small;
            default:
                return static_cast<int>(random());
        }
    };
    int seen = 0;
    for (int i = 0; i < 40000; ++i) {
        const Pixel a{extreme(), extreme()}, b{extreme(), extreme()};
        // A box on the line: around a step that is drawn at random, or at one of the ends.
        const LineWalk walk = line_walk(a, b);
        const auto step = static_cast<std::int64_t>(random() % std::uint64_t(walk.major + 1));
        Pixel middle = line_pixel(walk, step, line_offset(walk, step));
        if (i % 8 == 0) middle = a;
        if (i % 8 == 1) middle = b;
        const int r = static_cast<int>(random() % 9);
        const PixelBox box{
            middle.x < least + r ? least : middle.x - r, middle.y < least + r ? least : middle.y - r,
            middle.x > most - r ? most : middle.x + r, middle.y > most - r ? most : middle.y + r};
        const Pixels pixels = midpoint_pixels(a, b, box);
        ASSERT_EQ(pixels, pixels_by_formula(a, b, box))
            << a.x << "," << a.y << " to " << b.x << "," << b.y << " near " << middle.x << "," << middle.y;
        ASSERT_EQ(pixels, midpoint_pixels(b, a, box));
        seen += static_cast<int>(pixels.size());
    }
    EXPECT_GT(seen, 40000);
    const PixelBox corner{most - 2, most - 2, most, most};
    EXPECT_EQ(midpoint_pixels({least, least}, {most, most}, corner),
              (Pixels{{most - 2, most - 2}, {most - 1, most - 1}, {most, most}}));
    EXPECT_EQ(midpoint_pixels({most, least}, {least, most}, {least, most, least, most}),
              (Pixels{{least, most}}));
}

struct Listener {
    std::vector<LineStarted> started;
    std::vector<LineStep> steps;
    void on(const LineStarted& e) { started.push_back(e); }
    void on(const LineStep& e) { steps.push_back(e); }
};

TEST(LineMidpoint, EventsAreTheTextbooksNumbers) {
    Listener heard;
    Pixels pixels;
    line_midpoint(
        {0, 0}, {7, 3}, all_pixels,
        [&](int x, int y) {
            pixels.push_back({x, y});
        },
        heard);
    ASSERT_EQ(heard.started.size(), 1u);
    EXPECT_EQ(heard.started[0].d, -1);         // 2 * 3 - 7
    EXPECT_EQ(heard.started[0].straight, 6);   // 2 * 3
    EXPECT_EQ(heard.started[0].diagonal, -8);  // 2 * (3 - 7)
    std::vector<std::int64_t> d;
    std::string choices;
    for (const LineStep& e : heard.steps) d.push_back(e.d), choices += e.diagonal ? 'N' : 'E';
    EXPECT_EQ(d, (std::vector<std::int64_t>{-1, 5, -3, 3, -5, 1, -7}));
    EXPECT_EQ(choices, "ENENENE");
    EXPECT_EQ(heard.steps[1].pixel, (Pixel{1, 0}));
    EXPECT_EQ(heard.steps[1].straight_pixel, (GridPoint{2, 0}));
    EXPECT_EQ(heard.steps[1].diagonal_pixel, (GridPoint{2, 1}));
    EXPECT_EQ(heard.steps[1].twice_midpoint, (GridPoint{4, 1}));
    EXPECT_EQ(pixels, midpoint_pixels({0, 0}, {7, 3}));
}

// What the events say fits together, in every octant: d is 2 F at the midpoint by its definition, the choice
// follows from its sign, the next pixel is the chosen candidate; in a box they are the events of the uncut
// line.
TEST(LineMidpoint, EventsFitTogether) {
    for (const Pixel b :
         {Pixel{9, 4}, Pixel{4, 9}, Pixel{-4, 9}, Pixel{-9, 4}, Pixel{-9, -4}, Pixel{-4, -9}, Pixel{4, -9},
          Pixel{9, -4}, Pixel{6, 0}, Pixel{0, -6}, Pixel{5, 5}, Pixel{8, 4}, Pixel{4, -8}}) {
        Listener whole, part;
        Pixels pixels;
        line_midpoint(
            {0, 0}, b, all_pixels,
            [&](int x, int y) {
                pixels.push_back({x, y});
            },
            whole);
        const LineWalk& walk = whole.started.at(0).walk;
        ASSERT_EQ(whole.steps.size() + 1, pixels.size());
        for (std::size_t k = 0; k < whole.steps.size(); ++k) {
            const LineStep& e = whole.steps[k];
            EXPECT_EQ(e.step, std::int64_t(k));
            EXPECT_EQ(e.pixel, pixels[k]);
            EXPECT_EQ(e.diagonal, e.d > 0);
            const GridPoint next = e.diagonal ? e.diagonal_pixel : e.straight_pixel;
            EXPECT_EQ(next, (GridPoint{pixels[k + 1].x, pixels[k + 1].y}));
            const std::int64_t along = e.twice_midpoint.*(walk.steep ? &GridPoint::y : &GridPoint::x) -
                                       2 * (walk.steep ? walk.from.y : walk.from.x),
                               aside = e.twice_midpoint.*(walk.steep ? &GridPoint::x : &GridPoint::y) -
                                       2 * (walk.steep ? walk.from.x : walk.from.y);
            EXPECT_EQ(e.d, walk.minor * along - walk.major * walk.side * aside);
        }
        line_midpoint(
            {0, 0}, b, {-3, -3, 3, 3}, [](int, int) {}, part);
        for (const LineStep& e : part.steps) EXPECT_EQ(e.d, whole.steps.at(std::size_t(e.step)).d);
        EXPECT_FALSE(part.steps.empty());
    }
}

}  // namespace
}  // namespace relevo::raster
