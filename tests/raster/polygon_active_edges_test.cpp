#include "raster/polygon_active_edges.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "raster/rectangle.hpp"
#include "raster/triangle_scan.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/hard.hpp"

namespace relevo::raster {
namespace {

using tests::Drawing;
using tests::hard::Random;
using Ring = std::vector<SnappedPoint>;
using Rings = std::vector<Ring>;

constexpr FillRule rules[] = {FillRule::TopLeft, FillRule::Book};
constexpr InsideRule insides[] = {InsideRule::NonZero, InsideRule::EvenOdd};

// How often each pixel of the box was visited.
struct Count {
    PixelBox box;
    std::vector<int> pixels;

    explicit Count(const PixelBox& b)
        : box(b), pixels(std::size_t(b.x1 - b.x0 + 1) * std::size_t(b.y1 - b.y0 + 1)) {}
    int& at(int x, int y) {
        return pixels[std::size_t(y - box.y0) * std::size_t(box.x1 - box.x0 + 1) + std::size_t(x - box.x0)];
    }
    auto sink() {
        return [this](int y, int x0, int x1) {
            ASSERT_TRUE(x0 < x1 && box.holds(x0, y) && box.holds(x1 - 1, y)) << y << ": " << x0 << " " << x1;
            for (int x = x0; x < x1; ++x) ++at(x, y);
        };
    }
};

Count filled(const Rings& rings, InsideRule inside, FillRule rule, const PixelBox& box) {
    Count count(box);
    polygon_active_edges(rings, inside, rule, box, count.sink());
    return count;
}

// The winding number round a pixel's centre from the definition: a ray to the left from the centre, moved by
// an infinitesimal to the right and by a far smaller one down (the book: up). No division, no order.
int winding_number(const Rings& rings, int x, int y, FillRule rule) {
    const std::int64_t px = std::int64_t{256} * x + 128, py = std::int64_t{256} * y + 128;
    int winding = 0;
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const SnappedPoint a = ring[i], b = ring[(i + 1) % ring.size()];
            const bool a_above = rule == FillRule::TopLeft ? a.y <= py : a.y < py,
                       b_above = rule == FillRule::TopLeft ? b.y <= py : b.y < py;
            if (a_above == b_above) continue;
            // which side of the line a b the centre lies on: > 0 or on it means the crossing is at its left
            const std::int64_t side =
                (std::int64_t{b.y} - a.y) * (px - a.x) - (std::int64_t{b.x} - a.x) * (py - a.y);
            if (a_above ? side >= 0 : side <= 0) winding += a_above ? 1 : -1;
        }
    return winding;
}

bool right(const Rings& rings, const PixelBox& box) {
    for (const FillRule rule : rules)
        for (const InsideRule inside : insides) {
            Count count = filled(rings, inside, rule, box);
            for (int y = box.y0; y <= box.y1; ++y)
                for (int x = box.x0; x <= box.x1; ++x) {
                    const int winding = winding_number(rings, x, y, rule);
                    const bool in = inside == InsideRule::NonZero ? winding != 0 : winding % 2 != 0;
                    if (count.at(x, y) == (in ? 1 : 0)) continue;
                    std::string points;
                    for (const Ring& ring : rings) {
                        points += " ring";
                        for (const SnappedPoint& p : ring)
                            points += " (" + std::to_string(p.x) + "," + std::to_string(p.y) + ")";
                    }
                    ADD_FAILURE() << "pixel " << x << ", " << y << " visited " << count.at(x, y)
                                  << " times, winding " << winding << (rule == FillRule::Book ? ", book" : "")
                                  << points;
                    return false;
                }
        }
    return true;
}

Drawing drawn(const Rings& rings, InsideRule inside, FillRule rule, int width, int height) {
    Drawing picture(std::size_t(height), std::string(std::size_t(width), '.'));
    Count count = filled(rings, inside, rule, {0, 0, width - 1, height - 1});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (const int n = count.at(x, y)) picture[std::size_t(y)][std::size_t(x)] = n == 1 ? '#' : '2';
    return picture;
}

TEST(PolygonActiveEdges, APentagramHasAHoleByTheEvenOddRule) {
    const Rings star{{snapped(8, 0), snapped(13, 15), snapped(0, 6), snapped(16, 6), snapped(3, 15)}};
    const Drawing holed{".................",  //
                        "........#........",  //
                        "........#........",  //
                        ".......##........",  //
                        ".......###.......",  //
                        ".......###.......",  //
                        "######....######.",  //
                        "..####.....####..",  //
                        "...###.....###...",  //
                        "...........#.....",  //
                        ".....#.....#.....",  //
                        ".....###.###.....",  //
                        "....####.###.....",  //
                        "....##.....##....",  //
                        "....#.......#....",  //
                        "................."},
        full{".................",  //
             "........#........",  //
             "........#........",  //
             ".......##........",  //
             ".......###.......",  //
             ".......###.......",  //
             "################.",  //
             "..#############..",  //
             "...###########...",  //
             ".....#######.....",  //
             ".....#######.....",  //
             ".....#######.....",  //
             "....####.###.....",  //
             "....##.....##....",  //
             "....#.......#....",  //
             "................."};
    EXPECT_TRUE(tests::same_drawing(drawn(star, InsideRule::EvenOdd, FillRule::TopLeft, 17, 16), holed));
    EXPECT_TRUE(tests::same_drawing(drawn(star, InsideRule::NonZero, FillRule::TopLeft, 17, 16), full));
}

TEST(PolygonActiveEdges, ARingInARingIsAHoleOrNot) {
    const Ring outer{snapped(1, 1), snapped(8, 1), snapped(8, 7), snapped(1, 7)},
        same{snapped(3, 3), snapped(6, 3), snapped(6, 5), snapped(3, 5)}, back(same.rbegin(), same.rend());
    const Drawing full{".........", ".#######.", ".#######.", ".#######.",
                       ".#######.", ".#######.", ".#######.", "........."},
        holed{".........", ".#######.", ".#######.", ".##...##.",
              ".##...##.", ".#######.", ".#######.", "........."};
    EXPECT_TRUE(
        tests::same_drawing(drawn({outer, same}, InsideRule::NonZero, FillRule::TopLeft, 9, 8), full));
    EXPECT_TRUE(
        tests::same_drawing(drawn({outer, back}, InsideRule::NonZero, FillRule::TopLeft, 9, 8), holed));
    EXPECT_TRUE(
        tests::same_drawing(drawn({outer, same}, InsideRule::EvenOdd, FillRule::TopLeft, 9, 8), holed));
    EXPECT_TRUE(
        tests::same_drawing(drawn({outer, back}, InsideRule::EvenOdd, FillRule::TopLeft, 9, 8), holed));
}

// All closed chains of four points on a small grid: self-crossing, repeated, level, upright, ties on centres.
TEST(PolygonActiveEdges, IsTheWindingNumberOfAllSmallQuadrilaterals) {
    const PixelBox box{-1, -1, 3, 3};
    std::vector<SnappedPoint> points;
    for (const int y : {0, 128, 384, 513})
        for (const int x : {0, 128, 384, 513}) points.push_back({x, y});
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const SnappedPoint& b : points)
            for (const SnappedPoint& c : points)
                for (std::size_t k = i % 3; k < points.size(); k += 3)
                    if (!right({{points[i], b, c, points[k]}}, box)) return;
}

TEST(PolygonActiveEdges, IsTheWindingNumberOfRandomRings) {
    Random random(1);
    for (int i = 0; i < tests::hard::cases(1500); ++i) {
        const int grain = i % 3 == 0 ? 128 : i % 3 == 1 ? 64 : 1;  // coarse grids make ties
        Rings rings(std::size_t(random.integer(1, 3)));
        for (Ring& ring : rings)
            for (std::int64_t n = random.integer(0, 14); n > 0; --n)
                ring.push_back({static_cast<int>(random.integer(-600, 4600) / grain * grain),
                                static_cast<int>(random.integer(-600, 4600) / grain * grain)});
        if (!right(rings, {0, 0, 15, 15})) return;
    }
}

TEST(PolygonActiveEdges, IsTheWindingNumberOfHugeRings) {
    Random random(4);
    constexpr int far = largest_snapped;
    for (int i = 0; i < tests::hard::cases(500); ++i) {
        Ring ring;
        for (std::int64_t n = random.integer(3, 9); n > 0; --n)
            ring.push_back({random.coin() ? far : static_cast<int>(random.integer(-far, far)),
                            random.coin() ? -far : static_cast<int>(random.integer(-far, far))});
        const int x = static_cast<int>(random.integer(-far, far) >> 8),
                  y = static_cast<int>(random.integer(-far, far) >> 8);
        if (!right({ring}, {x - 8, y - 8, x + 8, y + 8})) return;
    }
}

// Many edges through one place, all changing their order there.
TEST(PolygonActiveEdges, IsTheWindingNumberWhereAllEdgesCross) {
    Random random(6);
    Ring ring;
    for (int i = 0; i < 600; ++i)
        ring.push_back({static_cast<int>(random.integer(0, 24 * 256)), i % 2 ? 1300 : 1500});
    EXPECT_TRUE(right({ring}, {0, 0, 23, 9}));
}

TEST(PolygonActiveEdges, CoversTrianglesAsTriangleScanDoes) {
    Random random(9);
    for (int i = 0; i < tests::hard::cases(20'000); ++i) {
        const int grain = i % 2 ? 1 : 128;
        SnappedPoint c[3];
        for (SnappedPoint& p : c)
            p = {static_cast<int>(random.integer(-900, 5000)) / grain * grain,
                 static_cast<int>(random.integer(-900, 5000)) / grain * grain};
        for (const FillRule rule : rules) {
            Count other({0, 0, 15, 15});
            triangle_scan(c, rule, other.box, other.sink());
            for (const InsideRule inside : insides)
                ASSERT_EQ(filled({{c[0], c[1], c[2]}}, inside, rule, other.box).pixels, other.pixels);
        }
    }
}

TEST(PolygonActiveEdges, CoversRectanglesAsRectangleDoes) {
    Random random(10);
    for (int i = 0; i < 2000; ++i) {
        const auto place = [&] { return static_cast<int>(random.integer(-4, 40)) * (i % 2 ? 128 : 101); };
        const SnappedPoint a{place(), place()}, b{place(), place()};
        for (const FillRule rule : rules) {
            Count other({0, 0, 15, 15});
            rectangle(a, b, rule, other.box, other.sink());
            ASSERT_EQ(filled({{a, {b.x, a.y}, b, {a.x, b.y}}}, InsideRule::NonZero, rule, other.box).pixels,
                      other.pixels);
        }
    }
}

// A star-shaped polygon cut into triangles from a point inside: polygon and triangles cover the same centres,
// each once. The rest of the square, a ring with a hole, covers the others.
TEST(PolygonActiveEdges, APolygonItsTrianglesAndItsSurroundingsCoverEachCentreOnce) {
    Random random(12);
    const PixelBox box{0, 0, 31, 31};
    const SnappedPoint a{0, 0}, b{8192, 0}, c{8192, 8192}, d{0, 8192};
    for (int i = 0; i < 300; ++i) {
        Ring ring;
        const int corners = static_cast<int>(random.integer(3, 40));
        for (int k = 0; k < corners; ++k) {
            const pipeline::Degrees angle{360.0 * k / corners};
            const double length = random.between(1, 15);
            const SnappedPoint p =
                snapped(15.5 + length * pipeline::cos(angle), 15.5 + length * pipeline::sin(angle));
            ring.push_back(i % 2 ? p : SnappedPoint{p.x & ~127, p.y & ~127});
        }
        if (corners < 5) ring.insert(ring.begin() + 1, ring[0]);  // a repeated point
        for (const FillRule rule : rules) {
            Count parts(box);
            // winding numbers of the triangles round the hub add up to the polygon's, sign by sign
            const SnappedPoint hub = snapped(15.5, 15.5);
            std::vector<int> sum(parts.pixels.size());
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const SnappedPoint &p = ring[k], &q = ring[(k + 1) % ring.size()];
                const std::int64_t area =
                    std::int64_t{p.x - hub.x} * (q.y - hub.y) - std::int64_t{p.y - hub.y} * (q.x - hub.x);
                Count one(box);
                triangle_scan({hub, p, q}, rule, box, one.sink());
                for (std::size_t n = 0; n < sum.size(); ++n)
                    sum[n] += area > 0 ? one.pixels[n] : -one.pixels[n];
            }
            EXPECT_EQ(filled({ring}, InsideRule::NonZero, rule, box).pixels, sum);
            polygon_active_edges(Rings{ring}, InsideRule::EvenOdd, rule, box, parts.sink());
            polygon_active_edges(Rings{ring, {a, b, c, d}}, InsideRule::EvenOdd, rule, box, parts.sink());
            for (const int n : parts.pixels) ASSERT_EQ(n, 1);
        }
    }
}

TEST(PolygonActiveEdges, NothingIsDrawnWithoutAreaOrOutOfReach) {
    const PixelBox box{0, 0, 15, 15};
    const auto empty = [&](const Rings& rings) {
        for (const FillRule rule : rules)
            for (const InsideRule inside : insides)
                for (const int n : filled(rings, inside, rule, box).pixels)
                    if (n != 0) return false;
        return true;
    };
    const SnappedPoint p = snapped(1, 1), q = snapped(9, 4), r = snapped(3, 12);
    EXPECT_TRUE(empty({}));
    EXPECT_TRUE(empty({{}}));
    EXPECT_TRUE(empty({{p}}));
    EXPECT_TRUE(empty({{p, q}}));
    EXPECT_TRUE(empty({{p, p, q, q, q, p}}));
    EXPECT_TRUE(empty({{p, q, r, q}}));  // there and back
    EXPECT_TRUE(empty({{snapped(0, 5), snapped(4, 5), snapped(9, 5)}}));
    EXPECT_TRUE(empty({{p, q, r}, {p, r, q}}));  // the second ring undoes the first
    EXPECT_FALSE(empty({{p, q, r}}));
    EXPECT_TRUE(empty({{p, q, r}, {{largest_snapped + 1, 0}}}));
    EXPECT_TRUE(empty({{p, q, r, {0, std::numeric_limits<int>::min()}}}));
}

TEST(PolygonActiveEdges, ABoxCutsAndNothingElseChanges) {
    Random random(14);
    for (int i = 0; i < 200; ++i) {
        Ring ring;
        for (int k = 0; k < 9; ++k)
            ring.push_back(
                {static_cast<int>(random.integer(0, 8000)), static_cast<int>(random.integer(0, 8000))});
        for (const InsideRule inside : insides) {
            Count whole = filled({ring}, inside, FillRule::TopLeft, {-5, -5, 40, 40});
            for (const PixelBox& box :
                 {PixelBox{7, 9, 13, 20}, PixelBox{0, 0, 0, 31}, PixelBox{12, 12, 12, 12}}) {
                Count part = filled({ring}, inside, FillRule::TopLeft, box);
                for (int y = box.y0; y <= box.y1; ++y)
                    for (int x = box.x0; x <= box.x1; ++x) ASSERT_EQ(part.at(x, y), whole.at(x, y));
            }
        }
    }
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    std::int64_t pixels = 0;
    const Rings square{{snapped(-3, -3), snapped(4, -3), snapped(4, 6), snapped(-3, 6)}};
    const auto add = [&](int, int x0, int x1) { pixels += x1 - x0; };
    polygon_active_edges(square, InsideRule::NonZero, FillRule::TopLeft, {least, least, most, most}, add);
    EXPECT_EQ(pixels, 63);
    polygon_active_edges(square, InsideRule::NonZero, FillRule::TopLeft, {3, 0, 2, 9}, add);
    polygon_active_edges(square, InsideRule::NonZero, FillRule::TopLeft, {0, 3, 9, 2}, add);
    polygon_active_edges(square, InsideRule::NonZero, FillRule::TopLeft, {least, least, least, least}, add);
    EXPECT_EQ(pixels, 63);
}

// A sawtooth of a million points, and a million points at random in a strip of a few rows, whose edges change
// their order all the time. Single pixels against the definition: it takes a million steps each.
TEST(PolygonActiveEdges, AMillionPoints) {
    Random random(20);
    Ring saw{snapped(31250, 12), snapped(-31250, 12)}, wild;
    for (int k = 0; k < 1'000'000; ++k) saw.push_back({16 * (k - 500'000), k % 2 ? 0 : 256 * 9});
    for (int k = 0; k < 1'000'000; ++k)
        wild.push_back(
            {static_cast<int>(random.integer(0, 1 << 18)), static_cast<int>(random.integer(0, 800))});
    for (const Rings& rings : {Rings{saw}, Rings{wild}}) {
        const PixelBox box{0, 0, 1023, 13};
        int inside_pixels = 0;
        Count odd = filled(rings, InsideRule::EvenOdd, FillRule::TopLeft, box),
              book = filled(rings, InsideRule::NonZero, FillRule::Book, box);
        for (int k = 0; k < 60; ++k) {
            const int x = static_cast<int>(random.integer(0, 1023)), y = k % 14;
            EXPECT_EQ(odd.at(x, y), winding_number(rings, x, y, FillRule::TopLeft) & 1) << x << ", " << y;
            EXPECT_EQ(book.at(x, y), winding_number(rings, x, y, FillRule::Book) != 0) << x << ", " << y;
            inside_pixels += odd.at(x, y);
        }
        EXPECT_GT(inside_pixels, 3);
        EXPECT_LT(inside_pixels, 57);
    }
}

TEST(PolygonActiveEdges, ItsMomentsTellTheTwoLists) {
    struct {
        std::vector<int> table, entered, left;
        std::vector<std::pair<int, std::size_t>> rows;
        std::vector<int> windings, span_windings;
        bool ordered = true;
        void on(const EdgeTableBuilt& e) {
            for (const TableEdge& edge : e.edges) table.push_back(edge.number);
        }
        void on(const EdgeEnters& e) { entered.push_back(e.edge.number); }
        void on(const EdgeLeaves& e) { left.push_back(e.edge.number); }
        void on(const RowCrossed& e) {
            rows.emplace_back(e.y, e.edges.size());
            for (std::size_t i = 1; i < e.edges.size(); ++i)
                ordered = ordered && e.edges[i - 1].at.x <= e.edges[i].at.x;
        }
        void on(const PolygonSpan& e) { span_windings.push_back(e.winding); }
    } heard;
    // an M: the valley's edges (1, 2) end before the legs' (0, 3); edge 4 is level
    const Rings letter{{snapped(0, 8), snapped(2, 0), snapped(5, 5), snapped(8, 0), snapped(10, 8)}};
    polygon_active_edges(
        letter, InsideRule::NonZero, FillRule::TopLeft, {-5, -5, 20, 20}, [](int, int, int) {}, heard);
    EXPECT_EQ(heard.table, (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(heard.entered, heard.table);
    EXPECT_EQ(heard.left, (std::vector<int>{1, 2, 0, 3}));
    ASSERT_EQ(heard.rows.size(), 8u);
    for (const auto& [y, edges] : heard.rows) EXPECT_EQ(edges, y < 5 ? 4u : 2u) << y;
    EXPECT_TRUE(heard.ordered);
    EXPECT_EQ(heard.span_windings.size(), 11u);  // none in row 0, two each in rows 1 to 4, one each in 5 to 7
    for (const int winding : heard.span_windings) EXPECT_EQ(winding, -1);  // edge 0 runs up
}

}  // namespace
}  // namespace relevo::raster
