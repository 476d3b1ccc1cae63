#include "raster/triangle_scan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "raster/triangle_edge.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/hard.hpp"

namespace relevo::raster {
namespace {

namespace hard = tests::hard;
using Corners = std::array<SnappedPoint, 3>;

struct Row {
    int y, x0, x1;
    friend bool operator==(const Row&, const Row&) = default;
};
using Rows = std::vector<Row>;

constexpr PixelBox all{-40000, -40000, 40000, 40000};

Rows scanned(const Corners& c, FillRule rule, const PixelBox& box) {
    Rows rows;
    const SnappedPoint corner[3] = {c[0], c[1], c[2]};
    triangle_scan(corner, rule, box, [&](int y, int x0, int x1) { rows.push_back({y, x0, x1}); });
    return rows;
}

// The edge functions' answer in the same box.
Rows by_edge_functions(const Corners& c, const PixelBox& box) {
    const SnappedCorner corner[3] = {{c[0].x, c[0].y, 0, 1}, {c[1].x, c[1].y, 0, 1}, {c[2].x, c[2].y, 0, 1}};
    const std::int64_t area = area2(corner[0], corner[1], corner[2]);
    Rows rows;
    if (area == 0) return rows;
    const CornerOrder o = canonical_order(corner[0], corner[1], corner[2], area > 0);
    const Triangle t = make_triangle(corner[o.index[0]], corner[o.index[1]], corner[o.index[2]]);
    const auto [top, bottom] = std::minmax({c[0].y, c[1].y, c[2].y});
    const PixelBox near{box.x0, std::max(box.y0, (top >> 8) - 2), box.x1,
                        std::min(box.y1, (bottom >> 8) + 2)};
    for_each_span(t, near, [&](int y, Span s, const EdgeValues&) { rows.push_back({y, s.x0, s.x1}); });
    return rows;
}

// The book's rule is the top-left rule seen in a mirror that lies on the floor: row y becomes row -1 - y.
Rows by_the_book(Corners c, const PixelBox& box) {
    for (SnappedPoint& p : c) p.y = -p.y;
    Rows rows = by_edge_functions(c, {box.x0, -1 - box.y1, box.x1, -1 - box.y0});
    std::reverse(rows.begin(), rows.end());
    for (Row& row : rows) row.y = -1 - row.y;
    return rows;
}

std::string told(const Corners& c) {
    std::string text = "corners";
    for (const SnappedPoint& p : c) text += " (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
    return text;
}

bool same_as_edge_functions(const Corners& c, const PixelBox& box) {
    const bool top_left = scanned(c, FillRule::TopLeft, box) == by_edge_functions(c, box);
    const bool book = scanned(c, FillRule::Book, box) == by_the_book(c, box);
    EXPECT_TRUE(top_left) << "top-left rule, " << told(c);
    EXPECT_TRUE(book) << "book's rule, " << told(c);
    return top_left && book;
}

tests::Drawing drawn(const Corners& c, FillRule rule, int width, int height) {
    tests::Drawing picture(std::size_t(height), std::string(std::size_t(width), '.'));
    for (const Row& row : scanned(c, rule, {0, 0, width - 1, height - 1}))
        for (int x = row.x0; x < row.x1; ++x) picture[std::size_t(row.y)][std::size_t(x)] = '#';
    return picture;
}

TEST(TriangleScan, DrawsWhatTheBookSays) {
    const Corners c{snapped(1, 0), snapped(6, 0), snapped(1, 5)};
    EXPECT_TRUE(tests::same_drawing(drawn(c, FillRule::TopLeft, 8, 7),  //
                                    {".#####..",                        //
                                     ".####...",                        //
                                     ".###....",                        //
                                     ".##.....",                        //
                                     ".#......",                        //
                                     "........",                        //
                                     "........"}));
    EXPECT_TRUE(tests::same_drawing(drawn(c, FillRule::Book, 8, 7),  //
                                    {"........",                     //
                                     ".####...",                     //
                                     ".###....",                     //
                                     ".##.....",                     //
                                     ".#......",                     //
                                     "........",                     //
                                     "........"}));
}

// All triangles with corners on a grid of half pixels and of thirds of odd subpixels: every tie there is.
TEST(TriangleScan, IsTheEdgeFunctionFormOnWholeGrids) {
    const PixelBox box{-3, -3, 5, 5};
    for (const std::array<int, 5> ticks :
         {std::array<int, 5>{0, 128, 256, 384, 512}, std::array<int, 5>{-128, 127, 128, 129, 641}}) {
        std::array<SnappedPoint, 25> points;
        for (std::size_t i = 0; i < 25; ++i) points[i] = {ticks[i % 5], ticks[i / 5]};
        for (const SnappedPoint& a : points)
            for (const SnappedPoint& b : points)
                for (const SnappedPoint& c : points)
                    if (!same_as_edge_functions({a, b, c}, box)) return;
    }
}

TEST(TriangleScan, IsTheEdgeFunctionFormOnHardTriangles) {
    const int total = hard::cases(60'000);
    std::vector<hard::ScreenFamily> families;
    for (const auto& family : hard::screen_families())
        if (family.in_range) families.push_back(family);
    std::size_t pixels = 0;
    for (int i = 0; i < total; ++i) {
        const auto& family = families[std::size_t(i) % families.size()];
        const int size = i % 3 == 0 ? 8192 : i % 3 == 1 ? 64 : 640;
        const auto s = hard::make(family, std::uint64_t(i), size, size);
        Corners c;
        for (std::size_t k = 0; k < 3; ++k)
            c[k] = {static_cast<int>(std::lrint(s[k].x * 256)), static_cast<int>(std::lrint(s[k].y * 256))};
        if (!std::all_of(c.begin(), c.end(), within_reach)) continue;
        // a window of 64 rows round a corner keeps the big ones quick
        const int row = c[std::size_t(i % 3)].y >> 8;
        const PixelBox box{0, row - 32, size - 1, row + 31};
        if (!same_as_edge_functions(c, box)) {
            ADD_FAILURE() << hard::name(family.name, std::uint64_t(i));
            return;
        }
        pixels += scanned(c, FillRule::TopLeft, box).size();
    }
    EXPECT_GT(pixels, std::size_t(total));
}

TEST(TriangleScan, IsTheEdgeFunctionFormOfRandomAndHugeTriangles) {
    hard::Random random(7);
    for (int i = 0; i < hard::cases(20'000); ++i) {
        const std::int64_t reach = i % 4 == 0 ? largest_snapped : 256 << random.integer(0, 8);
        const auto corner = [&] {
            return SnappedPoint{static_cast<int>(random.integer(-reach, reach)),
                                static_cast<int>(random.integer(-reach, reach))};
        };
        const Corners c{corner(), corner(), corner()};
        const int x = static_cast<int>(random.integer(-reach, reach) >> 8),
                  y = static_cast<int>(random.integer(-reach, reach) >> 8);
        if (!same_as_edge_functions(c, {x - 300, y - 20, x + 300, y + 20})) return;
    }
}

TEST(TriangleScan, TheLargestPlacesAreExact) {
    const int far = 256 * largest_place + 128;
    for (const Corners& c :
         {Corners{SnappedPoint{-far, -far}, SnappedPoint{far, -far + 1}, SnappedPoint{far - 1, far}},
          Corners{SnappedPoint{-far, far}, SnappedPoint{far, -far}, SnappedPoint{far, far}},
          Corners{SnappedPoint{-largest_snapped, -largest_snapped}, SnappedPoint{largest_snapped, 1},
                  SnappedPoint{largest_snapped, largest_snapped}},
          Corners{SnappedPoint{-far, 127}, SnappedPoint{far, 128}, SnappedPoint{0, 129}}})
        EXPECT_TRUE(same_as_edge_functions(c, all));
}

TEST(TriangleScan, OrderOfCornersIsNoMatter) {
    hard::Random random(11);
    for (int i = 0; i < 2000; ++i) {
        const auto corner = [&] {
            return SnappedPoint{static_cast<int>(random.integer(0, 4000)),
                                static_cast<int>(random.integer(0, 4000))};
        };
        const SnappedPoint a = corner(), b = corner(), c = corner();
        for (const FillRule rule : {FillRule::TopLeft, FillRule::Book}) {
            const Rows rows = scanned({a, b, c}, rule, all);
            for (const Corners& other :
                 {Corners{a, c, b}, Corners{b, a, c}, Corners{b, c, a}, Corners{c, a, b}, Corners{c, b, a}})
                EXPECT_EQ(scanned(other, rule, all), rows);
        }
    }
}

TEST(TriangleScan, NothingIsDrawnWithoutAreaOrOutOfReach) {
    const SnappedPoint p = snapped(3, 3), q = snapped(9, 3), r = snapped(3, 9);
    for (const FillRule rule : {FillRule::TopLeft, FillRule::Book}) {
        EXPECT_TRUE(scanned({p, p, p}, rule, all).empty());
        EXPECT_TRUE(scanned({p, q, p}, rule, all).empty());
        EXPECT_TRUE(scanned({p, snapped(5, 3), q}, rule, all).empty());
        EXPECT_TRUE(scanned({p, snapped(4, 5), snapped(5, 7)}, rule, all).empty());
        EXPECT_TRUE(scanned({p, q, SnappedPoint{3, largest_snapped + 1}}, rule, all).empty());
        EXPECT_TRUE(scanned({p, q, SnappedPoint{-largest_snapped - 1, 3}}, rule, all).empty());
        EXPECT_TRUE(scanned({p, q, SnappedPoint{3, std::numeric_limits<int>::min()}}, rule, all).empty());
        EXPECT_TRUE(scanned({p, q, r}, rule, {0, 0, -1, 20}).empty());
        EXPECT_TRUE(scanned({p, q, r}, rule, {0, 5, 20, 4}).empty());
        EXPECT_TRUE(scanned({p, q, r}, rule, {0, 10, 20, 12}).empty());
        EXPECT_FALSE(scanned({p, q, r}, rule, all).empty());
    }
}

TEST(TriangleScan, ABoxOfAnySizeCutsRowsAndColumns) {
    const Corners c{snapped(-20, -9), snapped(17, 3), snapped(2, 21)};
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    EXPECT_EQ(scanned(c, FillRule::TopLeft, {least, least, most, most}), scanned(c, FillRule::TopLeft, all));
    for (const FillRule rule : {FillRule::TopLeft, FillRule::Book})
        for (const PixelBox& box : {PixelBox{-3, -4, 5, 7}, PixelBox{0, 0, 0, 0}, PixelBox{-50, 3, 50, 3}}) {
            Rows cut;
            for (Row row : scanned(c, rule, all)) {
                row.x0 = std::max(row.x0, box.x0), row.x1 = std::min(row.x1, box.x1 + 1);
                if (box.y0 <= row.y && row.y <= box.y1 && row.x0 < row.x1) cut.push_back(row);
            }
            EXPECT_EQ(scanned(c, rule, box), cut);
        }
}

// A fan of triangles round a point, its rim on the border of a square: every centre of the square belongs to
// exactly one. The point is the corner of all (fig. 5.9).
TEST(TriangleScan, ACentreSharedByManyCornersHasOneOwner) {
    hard::Random random(5);
    for (int round = 0; round < 300; ++round) {
        const int size = 12 * 256;
        std::vector<SnappedPoint> rim;
        for (int k = 0; k < size; k += static_cast<int>(random.integer(1, 900))) rim.push_back({k, 0});
        for (int k = 0; k < size; k += static_cast<int>(random.integer(1, 900))) rim.push_back({size, k});
        for (int k = size; k > 0; k -= static_cast<int>(random.integer(1, 900))) rim.push_back({k, size});
        for (int k = size; k > 0; k -= static_cast<int>(random.integer(1, 900))) rim.push_back({0, k});
        const SnappedPoint hub = round % 2 ? snapped(static_cast<double>(random.integer(1, 9)), 6)
                                           : SnappedPoint{static_cast<int>(random.integer(1, size - 1)),
                                                          static_cast<int>(random.integer(1, size - 1))};
        for (const FillRule rule : {FillRule::TopLeft, FillRule::Book}) {
            std::array<std::array<int, 14>, 14> count{};
            for (std::size_t k = 0; k < rim.size(); ++k)
                for (const Row& row : scanned({hub, rim[k], rim[(k + 1) % rim.size()]}, rule, all))
                    for (int x = row.x0; x < row.x1; ++x) ++count[std::size_t(row.y)][std::size_t(x)];
            for (std::size_t y = 0; y < 14; ++y)
                for (std::size_t x = 0; x < 14; ++x)
                    ASSERT_EQ(count[y][x], x < 12 && y < 12 ? 1 : 0) << "pixel " << x << ", " << y;
        }
    }
}

struct Listener {
    std::vector<TriangleClassified> classified;
    std::vector<std::tuple<TriangleEdge, int, int>> started;  // edge, row, first pixel
    std::vector<std::tuple<int, TriangleEdge, TriangleEdge>> rows;
    bool exact = true;
    SnappedPoint corner[3];

    void on(const TriangleClassified& e) { classified.push_back(e); }
    void on(const TriangleEdgeStarted& e) { started.emplace_back(e.edge, e.y, e.at.x); }
    // x - rest / run must be the place of the edge, in rational numbers
    void check(int y, TriangleEdge edge, const ScanEdge& at) {
        const TriangleClassified& c = classified.back();
        const SnappedPoint &a = edge == TriangleEdge::Three ? c.middle : c.top,
                           &b = edge == TriangleEdge::Two ? c.middle : c.bottom;
        const tests::exact::Fraction place =
            tests::exact::crossing({a.x, a.y}, {b.x, b.y}, std::int64_t{256} * y + 128);
        const auto left = (Int128{at.x} * at.run - at.rest) * 256 + Int128{128} * at.run;
        exact =
            exact && left * place.denominator == place.numerator * at.run && 0 <= at.rest && at.rest < at.run;
    }
    void on(const TriangleRow& e) {
        rows.emplace_back(e.y, e.left, e.right);
        check(e.y, e.left, e.left_at);
        check(e.y, e.right, e.right_at);
    }
};

TEST(TriangleScan, ItsMomentsNameTheEdgesAndTheirExactPlaces) {
    Listener heard;
    const SnappedPoint corner[3] = {snapped(9, 4), snapped(2, 0), snapped(0, 9)};
    std::size_t spans = 0;
    triangle_scan(
        corner, FillRule::TopLeft, {0, 0, 20, 20}, [&](int, int, int) { ++spans; }, heard);
    ASSERT_EQ(heard.classified.size(), 1u);
    EXPECT_EQ(heard.classified[0].top, corner[1]);
    EXPECT_EQ(heard.classified[0].middle, corner[0]);
    EXPECT_EQ(heard.classified[0].bottom, corner[2]);
    EXPECT_TRUE(heard.classified[0].long_is_left);
    using E = TriangleEdge;
    EXPECT_EQ(heard.started,
              (std::vector<std::tuple<E, int, int>>{{E::Long, 0, 2}, {E::Two, 0, 2}, {E::Three, 4, 9}}));
    ASSERT_EQ(heard.rows.size(), 9u);
    EXPECT_EQ(spans, 8u);  // row 0 is the corner alone
    for (const auto& [y, left, right] : heard.rows) {
        EXPECT_EQ(left, E::Long);
        EXPECT_EQ(right, y < 4 ? E::Two : E::Three);
    }
    EXPECT_TRUE(heard.exact);

    hard::Random random(3);
    for (int i = 0; i < 300; ++i) {
        SnappedPoint any[3];
        for (SnappedPoint& p : any)
            p = {static_cast<int>(random.integer(-40000, 40000)),
                 static_cast<int>(random.integer(-40000, 40000))};
        triangle_scan(
            any, i % 2 ? FillRule::Book : FillRule::TopLeft, {-40, -60, 40, 60}, [](int, int, int) {}, heard);
    }
    EXPECT_TRUE(heard.exact);
    EXPECT_GT(heard.rows.size(), 10'000u);
}

}  // namespace
}  // namespace relevo::raster
