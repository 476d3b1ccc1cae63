#include "pipeline/clip_shape_sutherland_hodgman.hpp"

#include <gtest/gtest.h>

#include "tests/pipeline/shape_oracle.hpp"

namespace relevo::pipeline {
namespace {

namespace exact = tests::exact;
namespace hard = tests::hard;
using Points = std::vector<glm::vec2>;

const ClipBox box{{0, 0}, {10, 10}};

struct Watch {
    std::vector<ShapeEdgeClassified> edges;
    std::vector<ShapePointEmitted> points;
    std::vector<ShapeSideDone> sides;
    std::vector<Refusal> refused;
    void on(const ShapeEdgeClassified& e) { edges.push_back(e); }
    void on(const ShapePointEmitted& e) { points.push_back(e); }
    void on(const ShapeSideDone& e) { sides.push_back(e); }
    void on(const ClipRefused& e) { refused.push_back(e.reason); }
};

// Figures 4.6 to 4.8 on a triangle that only the left side cuts.
TEST(SutherlandHodgman, FourKindsOfEdges) {
    const Points quad{{5, 5}, {-5, 5}, {-5, 7}, {5, 9}};  // leaving, outside, entering, inside
    Watch w;
    const ClipLine left[] = {line_of(box, Side::Left)};
    EXPECT_EQ(clip_shape_sutherland_hodgman(quad, std::span<const ClipLine>(left), w),
              (Points{{5, 5}, {0, 5}, {0, 8}, {5, 9}}));
    ASSERT_EQ(w.edges.size(), 4u);
    EXPECT_EQ(w.edges[0].kind, EdgeKind::Leaving);
    EXPECT_EQ(w.edges[1].kind, EdgeKind::Outside);
    EXPECT_EQ(w.edges[2].kind, EdgeKind::Entering);
    EXPECT_EQ(w.edges[3].kind, EdgeKind::Inside);
    ASSERT_EQ(w.points.size(), 4u) << "1 + 0 + 2 + 1";
    EXPECT_TRUE(w.points[0].crossing && w.points[1].crossing && !w.points[2].crossing &&
                !w.points[3].crossing);
    ASSERT_EQ(w.sides.size(), 1u);
    EXPECT_EQ(w.sides[0].polygon.size(), 4u);
}

TEST(SutherlandHodgman, PointsOnTheWindowAreNotDoubled) {
    const Points diamond{{5, 0}, {10, 5}, {5, 10}, {0, 5}}, same{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    const auto rotated = [](Points p) { return std::rotate(p.begin(), p.begin() + 1, p.end()), p; };
    EXPECT_EQ(clip_shape_sutherland_hodgman(diamond, box).size(), 4u);
    EXPECT_EQ(clip_shape_sutherland_hodgman(same, box).size(), 4u);
    EXPECT_EQ(clip_shape_sutherland_hodgman(rotated(same), box).size(), 4u);
    // leaves and comes back through corners that lie on the border
    EXPECT_EQ(clip_shape_sutherland_hodgman(Points{{0, 2}, {-5, 5}, {0, 8}, {5, 5}}, box),
              (Points{{0, 2}, {0, 8}, {5, 5}}));
    EXPECT_TRUE(clip_shape_sutherland_hodgman(Points{{0, 5}, {-5, 2}, {-5, 8}}, box).empty())
        << "it only touches";
    EXPECT_TRUE(clip_shape_sutherland_hodgman(Points{{0, 2}, {0, 8}, {-5, 5}}, box).empty())
        << "along a side";
}

// Not even between two sides: corner (0, 2) and (0, 8) are their own crossings.
TEST(SutherlandHodgman, ACornerOnTheLineIsNotCrossed) {
    Watch w;
    clip_shape_sutherland_hodgman(Points{{0, 2}, {-5, 5}, {0, 8}, {5, 5}}, box, w);
    for (const ShapePointEmitted& point : w.points) EXPECT_FALSE(point.crossing);
    for (const ShapeSideDone& side : w.sides)
        for (std::size_t i = 0; i < side.polygon.size(); ++i)
            EXPECT_NE(side.polygon[i], side.polygon[(i + 1) % side.polygon.size()]);
}

// The crossing with the left side lies a third of the least float above the corner (0, 0), onto which it is
// rounded: for the top it is outside all the same.
TEST(SutherlandHodgman, CornersAreJudgedWhereTheyAreExactly) {
    const float e = 0x1p-149f;
    const ClipLine lines[] = {line_of(box, Side::Left), line_of(box, Side::Top)};
    Watch w;
    clip_shape_sutherland_hodgman(Points{{-e, 0}, {3, -e}, {3, -5}}, std::span<const ClipLine>(lines), w);
    ASSERT_EQ(w.sides.size(), 2u);
    EXPECT_EQ(std::ranges::count(w.sides[0].polygon, glm::vec2(0, 0)), 1) << "rounded onto the corner";
    EXPECT_TRUE(w.sides[1].polygon.empty());
    for (const ShapeEdgeClassified& edge : w.edges) {
        if (edge.side == 1) {
            EXPECT_EQ(edge.kind, EdgeKind::Outside);
        }
    }
}

TEST(SutherlandHodgman, NothingOfNothing) {
    Watch w;
    const Points triangle{{1, 1}, {5, 1}, {1, 5}};
    EXPECT_TRUE(clip_shape_sutherland_hodgman(Points{}, box, w).empty());
    EXPECT_TRUE(clip_shape_sutherland_hodgman(Points{{1, 1}}, box, w).empty());
    EXPECT_TRUE(clip_shape_sutherland_hodgman(Points{{1, 1}, {2, 2}}, box, w).empty());
    EXPECT_TRUE(clip_shape_sutherland_hodgman(Points{{1, 1}, {1, 1}, {1, 1}, {1, 1}}, box, w).empty());
    EXPECT_EQ(clip_shape_sutherland_hodgman(Points{{1, 1}, {1, 1}, {5, 1}, {1, 5}, {1, 5}, {1, 1}}, box, w),
              triangle)
        << "repeated points come out once";
    EXPECT_TRUE(w.refused.empty());
    EXPECT_TRUE(clip_shape_sutherland_hodgman(Points{{1, 1}, {NAN, 1}, {1, 5}}, box, w).empty());
    EXPECT_TRUE(clip_shape_sutherland_hodgman(Points{{1, 1}, {INFINITY, 1}, {1, 5}}, box, w).empty());
    EXPECT_TRUE(clip_shape_sutherland_hodgman(triangle, ClipBox{{3, 0}, {2, 9}}, w).empty());
    EXPECT_TRUE(clip_shape_sutherland_hodgman(triangle, Points{{0, 0}, {9, 0}, {1, 1}, {0, 9}}, w).empty());
    EXPECT_EQ(w.refused,
              (std::vector{Refusal::NotFinite, Refusal::NotFinite, Refusal::EmptyBox, Refusal::NotConvex}));
    EXPECT_TRUE(clip_shape_sutherland_hodgman(triangle, ClipBox{{20, 0}, {29, 9}}).empty());
    EXPECT_EQ(clip_shape_sutherland_hodgman(triangle, box), triangle);
    EXPECT_EQ(clip_shape_sutherland_hodgman(triangle, ClipBox{{-3e38f, -3e38f}, {3e38f, 3e38f}}), triangle);
}

void expect_right_area(const Points& polygon, const Points& window, const Points& got,
                       const std::string& name) {
    const exact::Rational right =
        exact::twice_common_area(polygon, window) * exact::twice_area(window).sign();
    const exact::Rational off = exact::twice_area(got) - right;
    ASSERT_LE(static_cast<double>(abs(off)), exact::area_slack({got})) << name;
}

// Crossings with 45 degree lines are whole numbers: then the area is exact.
TEST(SutherlandHodgman, ExactAreaOfWholeNumbers) {
    int clipped = 0;
    for (int i = 0; i < hard::cases(1500); ++i) {
        hard::Random r{std::uint64_t(i)};
        Points polygon{{hard::whole(r, -4, 14), hard::whole(r, -4, 14)}};
        for (std::int64_t k = r.integer(3, 9); k > 0; --k) {  // a walk in steps of 45 degrees
            const float length = hard::whole(r, 1, 9);
            polygon.push_back(polygon.back() +
                              length * glm::vec2(hard::whole(r, -1, 1), hard::whole(r, -1, 1)));
        }
        // back to the start, by at most two such steps
        const glm::vec2 d = polygon.front() - polygon.back();
        const float diagonal = std::min(std::abs(d.x), std::abs(d.y));
        polygon.push_back(polygon.back() +
                          glm::vec2(std::copysign(diagonal, d.x), std::copysign(diagonal, d.y)));
        const Points got = clip_shape_sutherland_hodgman(polygon, box);
        ASSERT_EQ(exact::twice_area(got), exact::twice_common_area(polygon, exact::corners(box))) << i;
        clipped += !got.empty() && exact::twice_area(got) != exact::twice_area(polygon);
    }
    EXPECT_GT(clipped, 500);
}

TEST(SutherlandHodgman, AreaIsRightForAnyConvexWindow) {
    const Points windows[] = {exact::corners(box),
                              {{0, 0}, {9, 3}, {2, 8}},
                              {{2, 8}, {9, 3}, {0, 0}},
                              {{1, 1}, {4, -3}, {8, -4}, {12, 0}, {12.5f, 3}, {9, 9}, {3, 7.25f}},
                              {{0, 0}, {1, 0}, {1, 0}, {2, 0}, {9, 0}, {9, 0.25f}}};
    for (int i = 0; i < hard::cases(600); ++i) {
        hard::Random r{std::uint64_t(i)};
        Points polygon = i % 3 == 0 ? hard::tangle(r, 8, 12) : hard::star(r, 9, 14, i % 3 == 1 ? 1e6 : 4);
        const float scale = std::ldexp(1.0f, static_cast<int>(i % 7 == 0 ? r.integer(-140, 120) : 0));
        Points window = windows[std::size_t(i) % std::size(windows)];
        for (glm::vec2& p : polygon) p = (p + glm::vec2(4, 4)) * scale;
        for (glm::vec2& p : window) p *= scale;
        const std::string name = "case " + std::to_string(i);
        const Points got = clip_shape_sutherland_hodgman(polygon, window);
        expect_right_area(polygon, window, got, name);
        for (std::size_t k = 0; k < got.size(); ++k)
            ASSERT_NE(got[k], got[(k + 1) % got.size()]) << name << ": a point twice";
        if (i % 5 != 0) continue;  // the box
        for (const glm::vec2& p : got) ASSERT_EQ(outcode({box.low * scale, box.high * scale}, p), 0) << name;
    }
}

TEST(SutherlandHodgman, AreaOfTheLargestFloats) {
    const float far = 3e38f;
    const Points polygon{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
    EXPECT_EQ(clip_shape_sutherland_hodgman(polygon, box), (Points{{0, 10}, {0, 0}, {10, 0}, {10, 10}}));
    const Points thin{{-far, 5}, {far, 5}, {far, 6}, {-far, 6}};
    EXPECT_EQ(exact::twice_area(clip_shape_sutherland_hodgman(thin, box)), 20);
    const Points diamond{{-far, 5}, {5, -far}, {far, 5}, {5, far}};
    EXPECT_EQ(exact::twice_area(clip_shape_sutherland_hodgman(diamond, box)), 200);
}

// A polygon that winds round the window twice covers it twice; a bow tie's halves have opposite signs.
TEST(SutherlandHodgman, PolygonsThatCrossThemselves) {
    const Points twice{{-1, -1}, {11, -1}, {11, 11}, {-1, 11}, {-2, -2}, {12, -2}, {12, 12}, {-2, 12}};
    EXPECT_EQ(exact::twice_area(clip_shape_sutherland_hodgman(twice, box)), 400);
    const Points tie{{-5, -5}, {15, 15}, {15, -5}, {-5, 15}};
    EXPECT_EQ(exact::twice_area(clip_shape_sutherland_hodgman(tie, box)), 0);
}

TEST(SutherlandHodgman, AMillionPointsInLinearTime) {
    Points polygon;
    const int count = 1'000'000;
    for (int i = 0; i < count; ++i)  // a saw along the circle
        polygon.emplace_back(5 + (i % 2 ? 12 : 8) * cos(Degrees{360.0 * i / count}),
                             5 + (i % 2 ? 12 : 8) * sin(Degrees{360.0 * i / count}));
    struct Count {
        int edges = 0;
        void on(const ShapeEdgeClassified&) { ++edges; }
    } counted;
    EXPECT_EQ(exact::twice_area(clip_shape_sutherland_hodgman(polygon, ClipBox{{4, 4}, {6, 6}}, counted)), 8);
    EXPECT_LT(counted.edges, 4 * count);
}

}  // namespace
}  // namespace relevo::pipeline
