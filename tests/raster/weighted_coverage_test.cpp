// The volume of the cone over a polygon against sums over fine rows, and its sums over the frame.
#include "raster/weighted_coverage.hpp"

#include <limits>

#include "tests/raster/coverage_grid.hpp"

namespace relevo::raster {
namespace {

using tests::CoverageGrid;
using tests::RandomPlaces;
using tests::Ring;
using tests::Rings;

constexpr PixelBox small{-2, -2, 11, 11};

template <class Probe = NoProbe>
CoverageGrid weighted(const Rings& rings, const PixelBox& box = small,
                      InsideRule inside = InsideRule::NonZero, Probe&& probe = Probe{}) {
    CoverageGrid grid(box);
    weighted_coverage(std::span<const Ring>(rings), inside, box, grid, probe);
    return grid;
}

// Slices through the cone on the origin: in the row y the outline is crossed at some places, and between them
// the height 3/pi (1 - r) has a closed integral. `slices` rows between any two corners.
double volume(const Ring& ring, glm::dvec2 centre, int slices) {
    const auto up_to = [](double x, double y) {
        const double c = std::sqrt(std::max(0.0, 1 - y * y));
        x = std::clamp(x, -c, c);
        const double r = std::sqrt(x * x + y * y);
        return 3 / 3.14159265358979323846 * (x - (x * r + y * y * std::asinh(x / std::abs(y))) / 2);
    };
    std::vector<double> heights{-1, 1};
    for (const glm::dvec2& p : ring)
        if (std::abs(p.y - centre.y) < 1) heights.push_back(p.y - centre.y);
    std::sort(heights.begin(), heights.end());
    double sum = 0;
    for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
        const double thick = (heights[k + 1] - heights[k]) / slices;
        for (int i = 0; i < slices; ++i) {
            const double y = heights[k] + (i + 0.5) * thick;
            for (std::size_t e = 0; e < ring.size(); ++e) {
                const glm::dvec2 a = ring[e] - centre, b = ring[(e + 1) % ring.size()] - centre;
                if ((a.y <= y) == (b.y <= y)) continue;
                const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
                sum += (a.y < b.y ? 1 : -1) * thick * (up_to(10, y) - up_to(x, y));
            }
        }
    }
    return std::abs(sum);
}

TEST(WeightedCoverage, IsTheVolumeOfTheCone) {
    RandomPlaces random(1);
    for (std::size_t family = 0; family < std::size(tests::triangle_families); ++family)
        for (int i = 0; i < 6; ++i) {
            const Ring t = tests::hard_triangle(family, random);
            weighted({t}).each([&](int x, int y, int c) {
                ASSERT_NEAR(c, 65536 * volume(t, {x, y}, 300), 4)
                    << tests::triangle_families[family] << " " << i << " at " << x << ", " << y;
            });
        }
}

// The unrounded shares: those of the edges of triangles around any point, all across the cone.
TEST(WeightedCoverage, TheWeightsIntegrateToOne) {
    RandomPlaces random(2);
    const auto right_of = [](glm::dvec2 a, glm::dvec2 b) {
        if (a.y == b.y) return 0.0;
        const double sign = a.y < b.y ? 1 : -1;
        if (sign < 0) std::swap(a, b);
        const glm::dvec2 d = b - a;
        const auto at = [&](double y) { return glm::dvec2{a.x + (y - a.y) / d.y * d.x, y}; };
        if (b.y <= -1 || a.y >= 1) return 0.0;
        ConeEdge e{a.y < -1 ? at(-1) : a, b.y > 1 ? at(1) : b, d / std::sqrt(d.x * d.x + d.y * d.y), 0, 0};
        e.slice_a = cone_half_plane(e.a.y), e.slice_b = cone_half_plane(e.b.y);
        return sign * cone_right_of(e);
    };
    for (int turn = 0; turn < 2000; ++turn) {
        const glm::dvec2 middle{random.between(-1.2, 1.2), random.between(-1.2, 1.2)};
        const Ring rim{{-3, -3}, {random.between(-2, 2), -3}, {3, -3},
                       {3, 3},   {random.between(-2, 2), 3},  {-3, 3}};
        double sum = 0;
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const glm::dvec2 p = rim[i], q = rim[(i + 1) % rim.size()];
            const double part = right_of(middle, p) + right_of(p, q) + right_of(q, middle);
            ASSERT_LE(part, 1e-9) << "all turn the same way";
            sum -= part;
        }
        ASSERT_NEAR(sum, 1, 1e-10) << "fan around " << middle.x << ", " << middle.y;
    }
}

// A place is seen by several cones. Over a whole pixel, or any shape with corners on pixel centres whose
// repetition fills the plane, their sum is 1.
TEST(WeightedCoverage, SumsToTheAreaOfWhatPixelsSampleEvenly) {
    const PixelBox box{-4, -4, 24, 24};
    for (const glm::dvec2 at : {glm::dvec2{0, 0}, glm::dvec2{0.5, 0.5}, glm::dvec2{0.3, 0.7}}) {
        const Ring pixel{at, at + glm::dvec2{1, 0}, at + glm::dvec2{1, 1}, at + glm::dvec2{0, 1}};
        EXPECT_NEAR(double(weighted({pixel}, box).sum()), 65536, 16);
        const Ring slanted{at, at + glm::dvec2{9, 2}, at + glm::dvec2{14, 9}, at + glm::dvec2{5, 7}};
        EXPECT_NEAR(double(weighted({slanted}, box).sum()) / 65536, 53, 120 * 0x1p-16);
    }
}

// Elsewhere it is the area within 12 % at worst (a speck), and closer the larger the shape is.
TEST(WeightedCoverage, SumsToTheAreaNearly) {
    RandomPlaces random(3);
    const PixelBox box{-3, -3, 103, 103};
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
        const Ring t{random.point(0, 100), random.point(0, 100), random.point(0, 100)};
        const double area =
            std::abs((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x)) / 2;
        if (area < 50) continue;
        worst = std::max(worst, std::abs(double(weighted({t}, box).sum()) / 65536 - area) / area);
    }
    EXPECT_LT(worst, 4e-3);
    EXPECT_GT(worst, 1e-6);
    for (const glm::dvec2 at : {glm::dvec2{5, 5}, glm::dvec2{5.5, 5.5}}) {
        const double s = 0x1p-5;
        const Ring speck{at + glm::dvec2{-s, -s}, at + glm::dvec2{s, -s}, at + glm::dvec2{s, s},
                         at + glm::dvec2{-s, s}};
        const double found = double(weighted({speck}, box).sum()) / 65536 / (4 * s * s);
        EXPECT_NEAR(found, at.x == 5 ? 0.95 : 1.11, 0.02);
    }
}

TEST(WeightedCoverage, TheTrianglesOfAMeshFillEveryPixel) {
    RandomPlaces random(4);
    for (const double size : {0.5, 1.0, 1.75, 4.0})
        for (int turn = 0; turn < 6; ++turn) {
            const Rings mesh = tests::shaken_mesh(random.place(-0.5, 0.5), random.place(-0.5, 0.5),
                                                  int(std::ceil(9 / size)), size, random);
            std::vector<int> sums(25, 0), parts(25, 0);
            for (const Ring& triangle : mesh)
                weighted({triangle}, {2, 2, 6, 6}).each([&](int x, int y, int c) {
                    const auto i = std::size_t((y - 2) * 5 + x - 2);
                    sums[i] += c, parts[i] += c != 0;
                });
            for (std::size_t i = 0; i < 25; ++i)
                ASSERT_NEAR(sums[i], full_coverage, 0.5 * (parts[i] + 6)) << "half a unit each";
        }
}

TEST(WeightedCoverage, PixelsBesideTheShapeGetWeight) {
    const CoverageGrid grid = weighted({{{4.6, -5}, {8, -5}, {8, 20}, {4.6, 20}}});
    const int weight = int(std::lrint(65536 * cone_half_plane(-0.6)));
    EXPECT_GT(weight, 1000);
    EXPECT_EQ(grid.at(4, 5), weight) << "pixel 4 ends at 4.5: the shape does not touch it";
    EXPECT_EQ(grid.at(3, 5), 0);
    EXPECT_EQ(grid.at(6, 5), full_coverage);
}

// Fig. 8.6: the same area in the middle of a pixel counts more than at its side.
TEST(WeightedCoverage, TheMiddleCountsMore) {
    const auto of = [](double from, double to) {
        return weighted({{{from, -5}, {to, -5}, {to, 20}, {from, 20}}}).at(5, 5);
    };
    EXPECT_EQ(of(4.75, 5.25), of(4.75, 5.25));
    EXPECT_GT(of(4.75, 5.25), of(4.5, 5));
    EXPECT_NEAR(of(4.5, 5), of(5, 5.5), 1);
}

TEST(WeightedCoverage, NeitherBoxNorCornerOrderMatter) {
    RandomPlaces random(5);
    for (int i = 0; i < 200; ++i) {
        const Ring t = tests::hard_triangle(std::size_t(i) % 8, random);
        const CoverageGrid whole = weighted({t});
        EXPECT_TRUE(whole == weighted({{t[2], t[1], t[0]}}));
        const int x0 = random.whole(-2, 11), y0 = random.whole(-2, 11);
        const PixelBox part{x0, y0, random.whole(x0, 11), random.whole(y0, 11)};
        weighted({t}, part).each([&](int x, int y, int c) { ASSERT_EQ(c, whole.at(x, y)); });
    }
}

TEST(WeightedCoverage, HolesAndRefusals) {
    const Ring outer{{-5, -5}, {15, -5}, {15, 15}, {-5, 15}}, inner{{2, 2}, {8, 2}, {8, 8}, {2, 8}};
    const CoverageGrid ring = weighted({outer, inner}, small, InsideRule::EvenOdd);
    EXPECT_EQ(ring.at(5, 5), 0);
    EXPECT_EQ(ring.at(0, 0), full_coverage);
    EXPECT_EQ(weighted({outer, inner}).at(5, 5), full_coverage);
    EXPECT_EQ(weighted({{{1, 1}, {5, 7}}}).runs, 0);
    EXPECT_EQ(weighted({}).runs, 0);
    for (const double bad : {std::numeric_limits<double>::infinity(), std::nan(""), 1e9})
        EXPECT_EQ(weighted({outer, {{1, bad}, {2, 3}, {4, 4}}}).runs, 0);
    weighted_coverage(std::span<const Ring>(&outer, 1), InsideRule::NonZero, {3, 3, 2, 9},
                      [](int, int, int, int) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace relevo::raster
