#include "raster/line_dda.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "raster/line_midpoint.hpp"
#include "tests/raster/line_pixels.hpp"

namespace relevo::raster {
namespace {

using tests::all_pixels;
using tests::Pixels;

Pixels dda_pixels(Pixel a, Pixel b, const PixelBox& box = all_pixels) {
    Pixels pixels;
    line_dda(a, b, box, [&](int x, int y) { pixels.push_back({x, y}); });
    return pixels;
}
Pixels midpoint_pixels(Pixel a, Pixel b) {
    Pixels pixels;
    line_midpoint(a, b, all_pixels, [&](int x, int y) { pixels.push_back({x, y}); });
    return pixels;
}

// Slopes of a few bits are exact in float: then the additions have no error, and ties go where the midpoint
// line takes them.
TEST(LineDda, ExactSlopesGiveTheMidpointLine) {
    for (const int dx : {1, 2, 4, 8, 16})
        for (int dy = -16; dy <= 16; ++dy) {
            if (std::abs(dy) > dx && 16 % std::abs(dy) != 0) continue;
            const Pixels right = midpoint_pixels({3, 5}, {3 + dx, 5 + dy});
            EXPECT_EQ(dda_pixels({3, 5}, {3 + dx, 5 + dy}), right);
            for (int x = 3; x < 8; ++x) {
                const PixelBox box{x, -20, 30, 30};
                EXPECT_EQ(dda_pixels({3, 5}, {3 + dx, 5 + dy}, box), tests::within(right, box));
            }
        }
}

TEST(LineDda, SmallLinesAreOnePixelAStep) {
    for (int code = 0; code < 12 * 12 * 12 * 12; ++code) {
        const Pixel a{code % 12 - 3, code / 12 % 12 - 3}, b{code / 144 % 12 - 3, code / 1728 - 3};
        const Pixels pixels = dda_pixels(a, b);
        ASSERT_EQ(pixels.size(), std::size_t(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y))) + 1);
        ASSERT_EQ(pixels, dda_pixels(b, a));
        ASSERT_TRUE(tests::connected(pixels));
    }
}

struct Drift {
    double pixels = 0, largest = 0;  // share of pixels that differ; |sum - exact| in pixels
};
struct Listener {
    Drift drift;
    LineWalk walk{};
    void on(const DdaStarted& e) { walk = e.walk; }
    void on(const DdaStep& e) {
        const double start = walk.steep ? walk.from.x : walk.from.y;
        const double exact = start + walk.side * double(e.step) * double(walk.minor) / double(walk.major);
        drift.largest = std::max(drift.largest, std::abs(double(e.across) - exact));
    }
};

// Over lines of half this length and more.
Drift drift_of(int longest, int lines) {
    std::mt19937_64 random(static_cast<std::uint64_t>(longest));
    Drift total;
    std::size_t count = 0, different = 0;
    for (int i = 0; i < lines; ++i) {
        const int length = longest / 2 + static_cast<int>(random() % std::uint64_t(longest / 2 + 1));
        const Pixel b{length, static_cast<int>(random() % std::uint64_t(2 * length + 1)) - length};
        Listener listener;
        Pixels sums;
        line_dda(
            {0, 0}, b, all_pixels,
            [&](int x, int y) {
                sums.push_back({x, y});
            },
            listener);
        const Pixels right = midpoint_pixels({0, 0}, b);
        for (std::size_t k = 0; k < right.size(); ++k) different += sums.at(k) == right[k] ? 0 : 1;
        count += right.size();
        total.largest = std::max(total.largest, listener.drift.largest);
    }
    total.pixels = double(different) / double(count);
    return total;
}

// The table of the header: how far the sum is off, and what part of the pixels differs from the midpoint
// line.
TEST(LineDda, DriftGrowsWithLength) {
    struct Row {
        int length, lines;
        double largest, pixels;  // at most
    };
    const Row rows[] = {{10, 2000, 2e-6, 0.0005}, {100, 2000, 1.5e-4, 0.004}, {1000, 1000, 0.016, 0.0015},
                        {10000, 60, 1.5, 0.1},    {100000, 12, 60, 0.9},      {1000000, 4, 6000, 1}};
    double before = 0;
    std::printf("length    largest drift    pixels that differ\n");
    for (const Row& row : rows) {
        const Drift drift = drift_of(row.length, row.lines);
        std::printf("%7d   %12.3g px   %8.4f %%\n", row.length, drift.largest, 100 * drift.pixels);
        EXPECT_LE(drift.largest, row.largest) << row.length;
        EXPECT_LE(drift.pixels, row.pixels) << row.length;
        EXPECT_GT(drift.largest, before) << row.length;
        before = drift.largest;
    }
    EXPECT_GT(before, 10);
}

// In a box: columns before it are skipped, rows outside are left out; any numbers are fine.
TEST(LineDda, ABoxIsNearlyTheSameAsDiscarding) {
    std::mt19937_64 random(3);
    const auto whole = [&](int low, int high) {
        return low + static_cast<int>(random() % std::uint64_t(high - low + 1));
    };
    std::size_t all = 0, different = 0;
    for (int i = 0; i < 3000; ++i) {
        const Pixel a{whole(-400, 400), whole(-400, 400)}, b{whole(-400, 400), whole(-400, 400)};
        const PixelBox box{-50, -60, 70, 80};
        const Pixels in_box = dda_pixels(a, b, box), kept = tests::within(dda_pixels(a, b), box);
        for (const Pixel& p : in_box) ASSERT_TRUE(box.holds(p.x, p.y));
        all += kept.size(), different += in_box == kept ? 0 : 1;
    }
    EXPECT_GT(all, 10000u);
    EXPECT_LT(different, 80u);  // of the lines: a tie, or the sum begun elsewhere
    EXPECT_GT(different, 0u);
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    dda_pixels({least, least}, {most, most}, {most - 9, most - 9, most, most});
    dda_pixels({least, most}, {most, least + 1}, {-5, -5, 5, 5});
    dda_pixels({most, most}, {most - 1, most - 3}, all_pixels);
    EXPECT_TRUE(dda_pixels({0, 0}, {9, 9}, {5, 0, 4, 9}).empty());
    EXPECT_EQ(dda_pixels({4, 4}, {4, 4}), (Pixels{{4, 4}}));
}

}  // namespace
}  // namespace relevo::raster
