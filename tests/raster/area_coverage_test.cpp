// Covered area against rational numbers, its sums, and the partition of unity.
#include "raster/area_coverage.hpp"

#include <limits>
#include <map>

#include "tests/raster/coverage_grid.hpp"
#include "tests/support/exact_area.hpp"

namespace relevo::raster {
namespace {

using tests::CoverageGrid;
using tests::RandomPlaces;
using tests::Ring;
using tests::Rings;
namespace exact = tests::exact;
using exact::Rational;

constexpr PixelBox small{-1, -1, 10, 10};

template <class Probe = NoProbe>
CoverageGrid covered(const Rings& rings, const PixelBox& box = small, InsideRule inside = InsideRule::NonZero,
                     Probe&& probe = Probe{}) {
    CoverageGrid grid(box);
    area_coverage(std::span<const Ring>(rings), inside, box, grid, probe);
    return grid;
}
template <class Probe = NoProbe>
CoverageGrid covered_convex(const Ring& ring, const PixelBox& box = small, Probe&& probe = Probe{}) {
    CoverageGrid grid(box);
    area_coverage(std::span<const glm::dvec2>(ring), box, grid, probe);
    return grid;
}

double distance(int coverage, const Rational& area) {
    return static_cast<double>(abs(abs(area) * full_coverage - coverage));
}

// How many edges touch a pixel.
struct Touches {
    std::map<std::pair<int, int>, int> edges;
    void on(const EdgeShared& e) { ++edges[{e.x, e.y}]; }
    int at(int x, int y) const {
        const auto found = edges.find({x, y});
        return found == edges.end() ? 0 : found->second;
    }
};

TEST(AreaCoverage, ASquareBetweenPixelCentres) {
    const CoverageGrid grid = covered({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {-1, -1, 3, 3});
    const int quarter = 16384, half = 32768, all = 65536;
    const int right[5][5] = {{0, 0, 0, 0, 0},
                             {0, quarter, half, quarter, 0},
                             {0, half, all, half, 0},
                             {0, quarter, half, quarter, 0},
                             {0, 0, 0, 0, 0}};
    grid.each([&](int x, int y, int c) { EXPECT_EQ(c, right[y + 1][x + 1]) << x << ", " << y; });
}

class AreaCoverageOf : public testing::TestWithParam<std::size_t> {};

// The bound of the header: half a unit an edge, so one unit where two edges pass.
TEST_P(AreaCoverageOf, TrianglesIsTheExactArea) {
    RandomPlaces random(100 + GetParam());
    int covered_pixels = 0;
    for (int i = 0; i < 30; ++i) {
        const Ring triangle = tests::hard_triangle(GetParam(), random);
        Touches touches;
        const CoverageGrid grid = covered_convex(triangle, small, touches);
        const exact::RationalRing ring = exact::rational(triangle);
        grid.each([&](int x, int y, int c) {
            const Rational area = exact::area_in_pixel(ring, x, y);
            const double away = distance(c, area);
            const int edges = touches.at(x, y);
            ASSERT_LE(away, 0.5 * edges) << "triangle " << i << " at " << x << ", " << y;
            covered_pixels += c != 0;
        });
        EXPECT_TRUE(grid == covered({triangle})) << "the two forms differ at triangle " << i;
    }
    EXPECT_GT(covered_pixels, 30);
}

INSTANTIATE_TEST_SUITE_P(Families, AreaCoverageOf,
                         testing::Range<std::size_t>(0, std::size(tests::triangle_families)));

// What lies to the right of an edge in its rows, as a polygon.
Rational exact_share(const EdgeShared& e) {
    const Rational far = 100000;
    const exact::RationalPoint a{Rational(e.from.x), Rational(e.from.y)},
        b{Rational(e.to.x), Rational(e.to.y)};
    return -exact::area_in_pixel({a, b, {far, b.y}, {far, a.y}}, e.x, e.y);
}

TEST(AreaCoverage, EverySharedPartIsTheExactOneRoundedOnce) {
    struct Check {
        int seen = 0, ties = 0;
        void on(const EdgeShared& e) {
            const Rational share = exact_share(e) * full_coverage;
            const double away = static_cast<double>(abs(share - e.share));
            ASSERT_LE(away, 0.5) << "share " << e.share << " of pixel " << e.x << ", " << e.y;
            if (abs(share - e.share) == Rational(1, 2)) {
                ++ties;
                ASSERT_EQ(e.share % 2, 0);
            }
            ++seen;
        }
    } check;
    RandomPlaces random(7);
    for (std::size_t family = 0; family < std::size(tests::triangle_families); ++family)
        for (int i = 0; i < 12; ++i) covered_convex(tests::hard_triangle(family, random), small, check);
    // Ties are made: an odd height, and a vertical edge, or one that leans by whole pixels, through halves.
    for (int i = 1; i < 40; i += 2) {
        const double bits = 0x1p-16 * i;
        covered_convex({{3, 0.25}, {3, 0.25 + bits}, {5, 0.25 + bits}, {5, 0.25}}, small, check);
        covered_convex({{2.5, 1}, {6.5, 1 + bits}, {8.5, 1 + bits}, {4.5, 1}}, small, check);
        covered_convex({{6.5, 1}, {2.5, 1 + bits}, {4.5, 1 + bits}, {8.5, 1}}, small, check);
    }
    EXPECT_GT(check.seen, 1000);
    EXPECT_GE(check.ties, 40);
}

TEST(AreaCoverage, SumsToTheAreaOfThePolygon) {
    RandomPlaces random(3);
    for (int i = 0; i < 300; ++i) {
        Ring ring;
        const int corners =
            random.whole(3, 12);  // of any form: the sum of winding numbers is the signed area
        for (int k = 0; k < corners; ++k) ring.push_back(random.point(-0.9, 60));
        struct Sum {
            long long edges = 0;
            void on(const EdgeShared&) { ++edges; }
        } shares;
        const PixelBox box{-2, -2, 62, 62};
        const Ring triangle(ring.begin(), ring.begin() + 3);
        const CoverageGrid grid = covered_convex(triangle, box, shares);
        const Rational area = abs(exact::signed_area(exact::rational(triangle))) * full_coverage;
        EXPECT_LE(static_cast<double>(abs(area - grid.sum())), double(shares.edges)) << i;
        EXPECT_LE(static_cast<double>(abs(area - grid.sum())), 3 * std::sqrt(double(shares.edges)) + 2) << i;
    }
}

// A line of width w and length l: the rectangle around it.
TEST(AreaCoverage, ALineSumsToWidthTimesLength) {
    RandomPlaces random(4);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec2 a = random.point(10, 90), b = random.point(10, 90);
        const double width = random.between(0.1, 6), dx = b.x - a.x, dy = b.y - a.y,
                     length = std::sqrt(dx * dx + dy * dy);
        const glm::dvec2 across{-dy / length * width / 2, dx / length * width / 2};
        const CoverageGrid grid =
            covered_convex({a + across, b + across, b - across, a - across}, {0, 0, 100, 100});
        EXPECT_NEAR(double(grid.sum()) / full_coverage, width * length, (length + width + 4) * 0x1p-16 * 4);
    }
}

TEST(AreaCoverage, TheTrianglesOfAMeshFillEveryPixelExactly) {
    RandomPlaces random(5);
    for (const double size : {0.25, 0.5, 1.0, 1.75, 3.0, 11.0})
        for (int turn = 0; turn < 12; ++turn) {
            const int cells = int(std::ceil(8 / size));
            const double x0 = random.place(-0.9, 0.9), y0 = random.place(-0.9, 0.9);
            const Rings mesh = tests::shaken_mesh(x0, y0, cells, size, random);
            const PixelBox box{2, 2, 6, 6};
            std::vector<int> sums(25, 0);
            for (const Ring& triangle : mesh)
                covered_convex(triangle, box).each([&](int x, int y, int c) {
                    sums[std::size_t((y - 2) * 5 + x - 2)] += c;
                });
            for (const int sum : sums) ASSERT_EQ(sum, full_coverage) << "cells of " << size << " pixels";
        }
}

// Edges shared by huge triangles, whose slopes no double holds.
TEST(AreaCoverage, AFanOfHugeTrianglesFillsEveryPixelExactly) {
    RandomPlaces random(6);
    for (int turn = 0; turn < 100; ++turn) {
        const glm::dvec2 middle = random.point(0, 4);
        const double r = 65000;
        const Ring rim{{-r, random.place(-r, r)},
                       {random.place(-r, r), -r},
                       {r, random.place(-r, r)},
                       {random.place(-r, r), r}};
        std::vector<int> sums(25, 0);
        for (std::size_t i = 0; i < 4; ++i)
            covered_convex({middle, rim[i], rim[(i + 1) % 4]}, {0, 0, 4, 4}).each([&](int x, int y, int c) {
                sums[std::size_t(y * 5 + x)] += c;
            });
        for (const int sum : sums) ASSERT_EQ(sum, full_coverage);
    }
}

// Three edges that cut three corners off a pixel round by themselves: the bound of half a unit an edge is
// reached, since the neighbours must be right, too.
TEST(AreaCoverage, ThreeEdgesInAPixelCanBeOffByMoreThanOneUnit) {
    RandomPlaces random(11);
    double worst = 0;
    for (int i = 0; i < 3000; ++i) {
        Ring t{random.point(-0.5, 0.5), random.point(-0.5, 0.5), random.point(-0.5, 0.5)};
        worst = std::max(worst, distance(covered_convex(t, {0, 0, 0, 0}).at(0, 0),
                                         exact::area_in_pixel(exact::rational(t), 0, 0)));
    }
    EXPECT_GT(worst, 1);
    EXPECT_LE(worst, 1.5);
}

TEST(AreaCoverage, NeitherCornerOrderNorDirectionMatter) {
    RandomPlaces random(8);
    for (int i = 0; i < 200; ++i) {
        const Ring t = tests::hard_triangle(std::size_t(i) % 8, random);
        const CoverageGrid grid = covered_convex(t);
        EXPECT_TRUE(grid == covered_convex({t[1], t[2], t[0]}));
        EXPECT_TRUE(grid == covered_convex({t[2], t[1], t[0]}));
        EXPECT_TRUE(grid == covered({{t[0], t[2], t[1]}}));
    }
}

TEST(AreaCoverage, ABoxCutsOutPixelsAndChangesNone) {
    RandomPlaces random(9);
    for (int i = 0; i < 300; ++i) {
        const Ring t = tests::hard_triangle(std::size_t(i) % 8, random);
        const CoverageGrid whole = covered({t});
        const int x0 = random.whole(-1, 10), y0 = random.whole(-1, 10);
        const PixelBox part{x0, y0, random.whole(x0, 10), random.whole(y0, 10)};
        const auto same = [&](int x, int y, int c) { ASSERT_EQ(c, whole.at(x, y)); };
        covered_convex(t, part).each(same);
        covered({t}, part).each(same);
    }
}

TEST(AreaCoverage, ManyCornersGoTheGeneralWay) {
    Ring circle;
    for (int i = 0; i < 1000; ++i) {  // the rational points of the unit circle
        const double t = i < 500 ? i / 250.0 - 1 : (i - 500) / 250.0 - 1, d = 1 + t * t,
                     side = i < 500 ? 1 : -1;
        circle.push_back({5 + side * 4 * (1 - t * t) / d, 5 + side * 4 * 2 * t / d});
    }
    const CoverageGrid grid = covered_convex(circle);
    EXPECT_TRUE(grid == covered({circle}));
    EXPECT_NEAR(double(grid.sum()) / full_coverage, 3.14159265 * 16, 1e-3);
}

TEST(AreaCoverage, FewCornersOfAnyFormGoByTheNonZeroRule) {
    RandomPlaces random(13);
    for (int i = 0; i < 500; ++i) {
        Ring ring;
        for (int corners = random.whole(3, 8); corners > 0; --corners)
            ring.push_back(i % 2 ? random.point(-2, 11) : random.point(-2, 11, 0.5));
        EXPECT_TRUE(covered_convex(ring) == covered({ring})) << i;
    }
}

TEST(AreaCoverage, RingsInsideEachOther) {
    const Ring outer{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, inner{{2, 2}, {6, 2}, {6, 6}, {2, 6}};
    const Ring turned(inner.rbegin(), inner.rend());
    EXPECT_EQ(covered({outer, inner}, small, InsideRule::EvenOdd).sum(), (64 - 16) * 65536ll);
    EXPECT_EQ(covered({outer, inner}, small, InsideRule::NonZero).sum(), 64 * 65536ll);
    EXPECT_EQ(covered({outer, turned}, small, InsideRule::NonZero).sum(), (64 - 16) * 65536ll);
    EXPECT_EQ(covered({outer, turned}, small, InsideRule::EvenOdd).sum(), (64 - 16) * 65536ll);
}

// A pentagram: its heart is wound twice. Exact but in the few pixels where its edges cross.
TEST(AreaCoverage, ASelfCrossingStar) {
    const Ring star{{5, 0}, {8, 9}, {0.25, 3.5}, {9.75, 3.5}, {2, 9}};
    const CoverageGrid filled = covered({star}), striped = covered({star}, small, InsideRule::EvenOdd);
    EXPECT_EQ(filled.at(5, 5), 65536);
    EXPECT_EQ(striped.at(5, 5), 0);
    EXPECT_EQ(filled.at(5, 2), 65536);
    EXPECT_EQ(striped.at(5, 2), 65536);
    filled.each([&](int x, int y, int c) { EXPECT_GE(c, striped.at(x, y)); });
}

// The statement of covered_part: where an outline crosses itself inside a pixel only the average winding
// number is known. The two halves of this bow tie cancel out.
TEST(AreaCoverage, ABowTieInOnePixelCancelsOut) {
    const Ring bow{{-0.25, -0.25}, {0.25, 0.25}, {0.25, -0.25}, {-0.25, 0.25}};
    EXPECT_EQ(covered({bow}).sum(), 0);
    EXPECT_EQ(covered_convex(bow).sum(), 0);
    EXPECT_EQ(covered_part(-full_coverage / 2, InsideRule::NonZero), full_coverage / 2);
    EXPECT_EQ(covered_part(3 * full_coverage / 2, InsideRule::NonZero), full_coverage);
    EXPECT_EQ(covered_part(3 * full_coverage / 2, InsideRule::EvenOdd), full_coverage / 2);
    EXPECT_EQ(covered_part(-5 * (full_coverage / 4), InsideRule::EvenOdd), 3 * (full_coverage / 4));
}

TEST(AreaCoverage, WhatHasNoAreaCoversNothing) {
    for (const Ring& ring : {Ring{}, Ring{{1, 1}}, Ring{{1, 1}, {5, 7}}, Ring{{1, 1}, {5, 5}, {9, 9}},
                             Ring{{2, 2}, {2, 2}, {2, 2}, {2, 2}}, Ring{{1, 2}, {7, 2}, {4, 2}}}) {
        EXPECT_EQ(covered({ring}).runs, 0);
        EXPECT_EQ(covered_convex(ring).runs, 0);
    }
    EXPECT_EQ(covered({}).runs, 0);
    const Ring repeated{{1, 1}, {1, 1}, {6, 1}, {6, 1}, {6, 7}, {6, 7}, {6, 7}};
    EXPECT_TRUE(covered_convex(repeated) == covered_convex({{1, 1}, {6, 1}, {6, 7}}));
}

TEST(AreaCoverage, AnEmptyBoxIsNotVisited) {
    const Ring ring{{0, 0}, {9, 0}, {0, 9}};
    const auto never = [](int, int, int, int) { ADD_FAILURE(); };
    for (const PixelBox& box :
         {PixelBox{1, 0, 0, 5}, PixelBox{0, 5, 9, 4},
          PixelBox{std::numeric_limits<int>::max(), 0, std::numeric_limits<int>::min(), 0},
          PixelBox{20, 20, 30, 30}, PixelBox{-9, -9, -3, 30}}) {
        area_coverage(std::span<const glm::dvec2>(ring), box, never);
        area_coverage(std::span<const Ring>(&ring, 1), InsideRule::NonZero, box, never);
    }
}

TEST(AreaCoverage, WhatIsNotFiniteOrTooFarIsRefused) {
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {inf, -inf, std::nan(""), 65534.5, -65535.0, 3e38, 1e300})
        for (std::size_t i = 0; i < 6; ++i) {
            Ring ring{{0, 0}, {9, 0}, {0, 9}};
            (i < 3 ? ring[i].x : ring[i - 3].y) = bad;
            EXPECT_EQ(covered_convex(ring).runs, 0);
            EXPECT_EQ(covered({{{0, 0}, {9, 0}, {0, 9}}, ring}).runs, 0) << "one bad ring refuses all";
        }
    const Ring all{{-65534, -65534}, {65534, -65534}, {65534, 65534}, {-65534, 65534}};
    EXPECT_EQ(covered_convex(all).sum(), 144 * 65536ll);
}

TEST(AreaCoverage, TheWholePlaneIsOneRunARow) {
    constexpr int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();
    const Ring all{{-65534, -1}, {65534, -1}, {65534, 2}, {-65534, 2}};
    long long pixels = 0;
    int runs = 0;
    area_coverage(std::span<const glm::dvec2>(all), {least, least, most, most},
                  [&](int, int x0, int x1, int coverage) {
                      pixels += (x1 - x0) * static_cast<long long>(coverage);
                      ++runs;
                  });
    EXPECT_EQ(pixels, 3 * 2 * 65534 * 65536ll);
    EXPECT_LE(runs, 4 * 3);
}

TEST(AreaCoverage, AMillionCorners) {
    RandomPlaces random(10);
    Ring ring;
    for (int i = 0; i < 500000; ++i) ring.push_back({i * 0x1p-10, 100 + random.place(0, 1)});
    for (int i = 500000; i > 0; --i) ring.push_back({i * 0x1p-10, 2 + random.place(0, 1)});
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        twice += (b.x - a.x) * (a.y + b.y);
    }
    const CoverageGrid grid = covered({ring}, {0, 0, 500, 110});
    EXPECT_EQ(grid.at(250, 50), full_coverage);
    EXPECT_NEAR(double(grid.sum()) / full_coverage, std::abs(twice) / 2, 0.1);  // a million roundings
}

TEST(AreaCoverage, TheProbeHearsWhatTheSinkGets) {
    struct Ear {
        CoverageGrid grid{small};
        void on(const RunCovered& e) { grid(e.y, e.x0, e.x1, e.coverage); }
    };
    RandomPlaces random(12);
    for (int i = 0; i < 40; ++i) {
        const Ring t = tests::hard_triangle(std::size_t(i) % 8, random);
        Ear one, two;
        EXPECT_TRUE(covered_convex(t, small, one) == one.grid);
        EXPECT_TRUE(covered({t}, small, InsideRule::NonZero, two) == two.grid);
        EXPECT_TRUE(one.grid == covered_convex(t));
    }
}

}  // namespace
}  // namespace relevo::raster
