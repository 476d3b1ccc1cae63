// n x n points a pixel against the definition of the top-left rule, point by point.
#include "raster/supersample.hpp"

#include <limits>

#include "raster/polygon_active_edges.hpp"
#include "tests/raster/coverage_grid.hpp"
#include "tests/support/exact.hpp"

namespace relevo::raster {
namespace {

using tests::CoverageGrid;
using tests::RandomPlaces;
using tests::Ring;
using tests::Rings;

constexpr PixelBox small{-1, -1, 10, 10};

template <class Probe = NoProbe>
CoverageGrid sampled(int n, const Rings& rings, const PixelBox& box = small,
                     InsideRule inside = InsideRule::NonZero, Probe&& probe = Probe{}) {
    CoverageGrid grid(box);
    supersample(n, std::span<const Ring>(rings), inside, box, grid, probe);
    return grid;
}

// How many of the pixel's points the polygon covers (even-odd), in units of 1/(256 n) pixel.
int exact_count(int n, const Ring& ring, int x, int y) {
    std::vector<tests::exact::Site> sites;
    for (const glm::dvec2& p : ring) {
        const SnappedPoint s = snapped(p.x, p.y);
        sites.push_back({std::int64_t{n} * s.x, std::int64_t{n} * s.y});
    }
    int count = 0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            count += tests::exact::covers(sites, tests::exact::centre(n * x + i, n * y + j));
    return count;
}

TEST(Supersample, CountsThePointsInside) {
    RandomPlaces random(1);
    for (int n = 1; n <= most_samples; ++n)
        for (std::size_t family = 0; family < std::size(tests::triangle_families); ++family) {
            const Ring t = tests::hard_triangle(family, random);
            sampled(n, {t}).each([&](int x, int y, int c) {
                const int count = exact_count(n, t, x, y);
                ASSERT_NEAR(c, 65536.0 * count / (n * n), 0.5)
                    << n << " " << tests::triangle_families[family];
                if (65536 % (n * n) == 0) {
                    ASSERT_EQ(c, 65536 / (n * n) * count);
                }
            });
        }
}

TEST(Supersample, OnePointIsNoAntialiasing) {
    RandomPlaces random(2);
    for (int i = 0; i < 200; ++i) {
        const Ring t = tests::hard_triangle(std::size_t(i) % 8, random);
        std::vector<SnappedPoint> corners;
        bool near = true;
        for (const glm::dvec2& p : t) {
            corners.push_back(snapped(p.x, p.y));
            near = near && std::abs(p.x) < 32000 && std::abs(p.y) < 32000;
        }
        if (!near) continue;
        CoverageGrid grid(small);
        polygon_active_edges(std::span<const std::vector<SnappedPoint>>(&corners, 1), InsideRule::NonZero,
                             FillRule::TopLeft, small,
                             [&](int y, int x0, int x1) { grid(y, x0, x1, full_coverage); });
        ASSERT_TRUE(grid == sampled(1, {t}));
    }
}

TEST(Supersample, TheTrianglesOfAMeshFillEveryPixelExactly) {
    RandomPlaces random(3);
    for (const int n : {1, 2, 4, 8, 16})
        for (const double size : {0.5, 1.25, 4.0}) {
            const Rings mesh = tests::shaken_mesh(random.place(-0.9, 0.4), random.place(-0.9, 0.4),
                                                  int(std::ceil(8.0 / size)), size, random);
            std::vector<int> sums(25, 0);
            for (const Ring& triangle : mesh)
                sampled(n, {triangle}, {2, 2, 6, 6}).each([&](int x, int y, int c) {
                    sums[std::size_t((y - 2) * 5 + x - 2)] += c;
                });
            for (const int sum : sums) ASSERT_EQ(sum, full_coverage) << n;
        }
}

TEST(Supersample, MoreSamplesComeCloserToTheArea) {
    RandomPlaces random(4);
    double worst[5] = {};
    const int n[5] = {1, 2, 4, 8, 16};
    for (int i = 0; i < 100; ++i) {
        const Ring t{random.point(-2, 11, 1.0 / 256), random.point(-2, 11, 1.0 / 256),
                     random.point(-2, 11, 1.0 / 256)};
        CoverageGrid area(small);
        area_coverage(std::span<const glm::dvec2>(t), small, area);
        for (int k = 0; k < 5; ++k)
            sampled(n[k], {t}).each([&](int x, int y, int c) {
                worst[k] = std::max(worst[k], std::abs(c - area.at(x, y)) / 65536.0);
            });
    }
    for (int k = 0; k < 4; ++k) EXPECT_GT(worst[k], 1.5 * worst[k + 1]) << n[k];
    EXPECT_LT(worst[4], 0.05);
}

TEST(Supersample, RulesBoxesAndDirections) {
    const Ring outer{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, inner{{2, 2}, {6, 2}, {6, 6}, {2, 6}};
    EXPECT_EQ(sampled(4, {outer, inner}, small, InsideRule::EvenOdd).sum(), 48 * 65536ll);
    EXPECT_EQ(sampled(4, {outer, inner}).sum(), 64 * 65536ll);
    const Ring bow{{-0.25, -0.25}, {0.25, 0.25}, {0.25, -0.25}, {-0.25, 0.25}};
    EXPECT_EQ(sampled(16, {bow}).at(0, 0), 8192) << "points know no average: half of the quarter";
    RandomPlaces random(5);
    for (int i = 0; i < 100; ++i) {
        const Ring t = tests::hard_triangle(std::size_t(i) % 8, random);
        const int n = random.whole(1, 16), x0 = random.whole(-1, 10), y0 = random.whole(-1, 10);
        const CoverageGrid whole = sampled(n, {t});
        EXPECT_TRUE(whole == sampled(n, {{t[1], t[0], t[2]}}));
        const PixelBox part{x0, y0, random.whole(x0, 10), random.whole(y0, 10)};
        sampled(n, {t}, part).each([&](int x, int y, int c) { ASSERT_EQ(c, whole.at(x, y)); });
    }
}

TEST(Supersample, Refusals) {
    const Ring good{{0, 0}, {9, 0}, {0, 9}};
    for (const int n : {0, -1, 17, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()})
        EXPECT_EQ(sampled(n, {good}).runs, 0);
    for (const double bad : {std::numeric_limits<double>::infinity(), std::nan(""), 65535.0, -3e38})
        EXPECT_EQ(sampled(4, {good, {{1, bad}, {2, 3}, {4, 4}}}).runs, 0);
    EXPECT_EQ(sampled(4, {{{1, 1}, {5, 7}}, {{2, 2}, {2, 2}, {2, 2}}, {}}).runs, 0);
    const Ring all{{-65534, -65534}, {65534, -65534}, {65534, 65534}, {-65534, 65534}};
    EXPECT_EQ(sampled(16, {all}).sum(), 144 * 65536ll);
    const auto never = [](int, int, int, int) { ADD_FAILURE(); };
    supersample(4, std::span<const Ring>(&good, 1), InsideRule::NonZero, {5, 5, 4, 4}, never);
}

TEST(Supersample, TheProbeHearsEveryPoint) {
    struct Ear {
        int points = 0;
        void on(const SamplesInside& e) { points += e.x1 - e.x0; }
    } ear;
    const CoverageGrid grid =
        sampled(4, {{{0.5, 0.5}, {7.5, 0.5}, {7.5, 3.5}, {0.5, 3.5}}}, small, InsideRule::NonZero, ear);
    EXPECT_EQ(ear.points, 7 * 3 * 16);
    EXPECT_EQ(grid.sum(), 21 * 65536ll);
}

}  // namespace
}  // namespace relevo::raster
