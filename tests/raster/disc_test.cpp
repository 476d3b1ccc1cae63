#include "raster/disc.hpp"

#include <map>

#include "tests/raster/curve_pixels.hpp"

namespace relevo::tests {
namespace {

struct Rows {
    std::map<int, raster::Span> spans;
    bool twice = false, empty_span = false;
    void operator()(int y, int x0, int x1) {
        twice |= !spans.emplace(y, raster::Span{x0, x1}).second;
        empty_span |= x0 >= x1;
    }
};

Rows disc(Pixel center, int a, int b, const PixelBox& box) {
    Rows rows;
    raster::disc(center, a, b, box, rows);
    return rows;
}

// From the outline: of each row all from its first to its last pixel.
std::map<int, raster::Span> filled(const Pixels& outline, const PixelBox& box) {
    std::map<int, raster::Span> spans;
    for (const Pixel& p : outline) {
        auto& span = spans.try_emplace(p.y, raster::Span{p.x, p.x + 1}).first->second;
        span = {std::min(span.x0, p.x), std::max(span.x1, p.x + 1)};
    }
    for (auto row = spans.begin(); row != spans.end();) {
        row->second = {std::max(row->second.x0, box.x0), std::min(row->second.x1, box.x1 + 1)};
        const bool visible = row->first >= box.y0 && row->first <= box.y1 && row->second.x0 < row->second.x1;
        row = visible ? std::next(row) : spans.erase(row);
    }
    return spans;
}

bool same(const std::map<int, raster::Span>& p, const std::map<int, raster::Span>& q) {
    return std::ranges::equal(p, q, [](const auto& s, const auto& t) {
        return s.first == t.first && s.second.x0 == t.second.x0 && s.second.x1 == t.second.x1;
    });
}

TEST(Disc, IsItsOutlineAndAllBetweenEachRowOnce) {
    for (int a = 0; a <= 70; ++a)
        for (int b = 0; b <= 70; ++b) {
            const Pixels outline = gather([&](auto plot) {
                raster::ellipse_midpoint({3, 4}, a, b, everywhere, plot);
            });
            for (const PixelBox& box :
                 {PixelBox{-100, -100, 100, 100}, PixelBox{-20, -20, 9, 9}, PixelBox{5, 10, 40, 100},
                  PixelBox{-100, 4, 100, 4}, PixelBox{3, -100, 3, 100}, PixelBox{-100, -100, 100, -20}}) {
                const Rows rows = disc({3, 4}, a, b, box);
                ASSERT_FALSE(rows.twice || rows.empty_span) << a << ", " << b;
                ASSERT_TRUE(same(rows.spans, filled(outline, box))) << a << ", " << b;
            }
        }
}

TEST(Disc, CirclesUpTo512) {
    for (int r = 71; r <= 512; ++r) {
        const PixelBox box{-512, -512, 512, 512};
        const Rows rows = disc({0, 0}, r, r, box);
        ASSERT_FALSE(rows.twice) << r;
        ASSERT_TRUE(same(rows.spans, filled(gather([&](auto plot) {
                                                raster::circle_midpoint({0, 0}, r, box, plot);
                                            }),
                                            box)))
            << r;
    }
}

TEST(Disc, HugeOnesInASmallBox) {
    const int r = 1 << 30;
    const Rows top = disc({0, r}, r, r, {-50, -3, 50, 3});
    EXPECT_EQ(top.spans.size(), 4u);  // row 0 and below: the whole width
    for (const auto& [y, span] : top.spans) EXPECT_TRUE(y >= 0 && span.x0 == -50 && span.x1 == 51);
    const Rows side =
        disc({2147483647, -2147483647}, r, r, {1073741813, -2147483647, 1073741833, -2147483600});
    EXPECT_EQ(side.spans.size(), 48u);
    EXPECT_EQ(side.spans.begin()->second.x0, 2147483647 - r);
    const Rows ellipse = disc({0, 0}, 1 << 20, 1 << 10, {-(1 << 20), -1, (1 << 20), 1});
    EXPECT_EQ(ellipse.spans.at(0).x1, (1 << 20) + 1);
    EXPECT_EQ(ellipse.spans.at(0).x0, -(1 << 20));
}

TEST(Disc, Limits) {
    const auto nothing = [](int, int, int) { FAIL(); };
    const PixelBox box{-9, -9, 9, 9};
    EXPECT_TRUE(raster::disc({0, 0}, -1, 4, box, nothing));
    EXPECT_TRUE(raster::disc({0, 0}, 4, 4, {0, 0, -1, 5}, nothing));
    EXPECT_FALSE(raster::disc({0, 0}, (1 << 30) + 1, (1 << 30) + 1, box, nothing));
    EXPECT_FALSE(raster::disc({0, 0}, (1 << 20) + 1, 1, box, nothing));
    EXPECT_EQ(disc({2, 2}, 0, 0, box).spans.at(2).x0, 2);
}

}  // namespace
}  // namespace relevo::tests
