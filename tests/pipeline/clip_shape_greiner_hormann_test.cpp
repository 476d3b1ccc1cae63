#include "pipeline/clip_shape_greiner_hormann.hpp"

#include <gtest/gtest.h>

#include "pipeline/split_bridges.hpp"
#include "tests/pipeline/shape_oracle.hpp"

namespace relevo::pipeline {
namespace {

namespace exact = tests::exact;
namespace hard = tests::hard;
using Points = std::vector<glm::vec2>;
using Rings = std::vector<Points>;

Rings inside(const Points& p, const Points& w) { return clip_shape_greiner_hormann(p, w); }
Rings outside(const Points& p, const Points& w) {
    return clip_shape_greiner_hormann(p, w, ClipKeep::Outside);
}

const Points square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

TEST(GreinerHormann, OneInTheOther) {
    const Points small{{3, 3}, {6, 3}, {6, 6}}, hole{{6, 6}, {6, 3}, {3, 3}};
    EXPECT_EQ(inside(small, square), Rings{small});
    EXPECT_TRUE(outside(small, square).empty());
    EXPECT_EQ(inside(square, small), Rings{small}) << "the window in the polygon";
    const Rings ring = outside(square, small);
    ASSERT_EQ(ring.size(), 2u) << "outline and hole";
    EXPECT_EQ(ring[0], square);
    EXPECT_EQ(exact::twice_area(ring[1]), -9) << "the hole winds the other way";
    const Points away{{20, 20}, {30, 20}, {30, 30}};
    EXPECT_TRUE(inside(square, away).empty());
    EXPECT_EQ(outside(square, away), Rings{square});
    EXPECT_EQ(inside(square, square), Rings{square});
    EXPECT_TRUE(outside(square, square).empty());
    EXPECT_EQ(exact::twice_area(inside(Points(small.rbegin(), small.rend()), square)[0]), -9)
        << "the winding of the polygon stays";
}

TEST(GreinerHormann, PolygonsThatTouch) {
    EXPECT_TRUE(inside(square, {{10, 0}, {20, 0}, {20, 10}, {10, 10}}).empty())
        << "a shared edge, side by side";
    EXPECT_EQ(inside(square, {{5, 0}, {10, 0}, {10, 10}, {5, 10}}),
              (Rings{{{5, 0}, {10, 0}, {10, 10}, {5, 10}}}));
    EXPECT_TRUE(inside(square, {{10, 10}, {20, 10}, {20, 20}}).empty()) << "a shared corner";
    EXPECT_TRUE(inside(square, {{10, 5}, {20, 0}, {20, 10}}).empty()) << "a corner on an edge";
    const Points diamond{{5, 0}, {10, 5}, {5, 10}, {0, 5}};
    EXPECT_EQ(inside(square, diamond), Rings{diamond}) << "corners on edges from within";
    EXPECT_EQ(outside(square, diamond).size(), 4u) << "four corners that touch in points";
}

TEST(GreinerHormann, AConcaveWindow) {
    const Points c{{0, 0}, {10, 0}, {10, 2}, {2, 2}, {2, 8}, {10, 8}, {10, 10}, {0, 10}};
    const Points bar{{6, -5}, {8, -5}, {8, 15}, {6, 15}};
    const Rings rings = inside(bar, c);
    ASSERT_EQ(rings.size(), 2u);
    for (const Points& ring : rings) EXPECT_EQ(exact::twice_area(ring), 8);
    EXPECT_EQ(outside(bar, c).size(), 3u);
    struct Watch {
        int enters = 0, leaves = 0, along_window = 0, along_polygon = 0;
        void on(const OutlinesMeet& e) {
            enters += e.kind == MeetingKind::Enters, leaves += e.kind == MeetingKind::Leaves;
        }
        void on(const OutlineWalked& e) { ++(e.along_window ? along_window : along_polygon); }
    } w;
    clip_shape_greiner_hormann(bar, c, ClipKeep::Inside, w);
    EXPECT_EQ(w.enters, 4);
    EXPECT_EQ(w.leaves, 4);
    EXPECT_EQ(w.along_window, 4);
    EXPECT_EQ(w.along_polygon, 4);
}

TEST(GreinerHormann, BadInput) {
    struct Watch {
        std::vector<Refusal> refused;
        void on(const ClipRefused& e) { refused.push_back(e.reason); }
    } w;
    const auto clip = [&](const Points& p, const Points& window) {
        return clip_shape_greiner_hormann(p, window, ClipKeep::Inside, w);
    };
    EXPECT_TRUE(clip({{0, 0}, {NAN, 0}, {0, 1}}, square).empty());
    EXPECT_TRUE(clip(square, {{0, 0}, {INFINITY, 0}, {0, 1}}).empty());
    EXPECT_TRUE(clip(square, {{0, 0}, {1, 1}, {2, 2}}).empty());
    EXPECT_TRUE(clip(square, {}).empty());
    EXPECT_TRUE(clip_shape_greiner_hormann(square, ClipBox{{3, 0}, {2, 9}}, ClipKeep::Inside, w).empty());
    EXPECT_EQ(w.refused, (std::vector{Refusal::NotFinite, Refusal::NotFinite, Refusal::NoArea,
                                      Refusal::NoArea, Refusal::EmptyBox}));
    EXPECT_TRUE(clip({}, square).empty());
    EXPECT_TRUE(clip({{1, 1}, {2, 2}}, square).empty());
    EXPECT_TRUE(clip({{1, 1}, {2, 2}, {3, 3}}, square).empty());
    EXPECT_EQ(clip({{1, 1}, {1, 1}, {2, 1}, {2, 2}, {2, 2}, {1, 1}}, square).size(), 1u);
    EXPECT_EQ(w.refused.size(), 5u) << "a polygon without area is not an error";
    const float far = 3e38f;
    const Rings all = inside({{-far, -far}, {far, -far}, {far, far}, {-far, far}}, square);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(exact::twice_area(all[0]), 200);
    for (int i = 0; i < hard::cases(3000); ++i) {  // crossing themselves: whatever it is, it ends
        hard::Random r{std::uint64_t(i)};
        inside(hard::tangle(r, 9, 3), hard::tangle(r, 8, 3));
    }
}

// On a coarse grid polygons share corners and edges all the time, on a fine one they hardly touch.
TEST(GreinerHormann, AreasAreExact) {
    int pieces = 0, shared = 0;
    for (int i = 0; i < hard::cases(900); ++i) {
        hard::Random r{std::uint64_t(i)};
        const double grid = i % 3 == 0 ? 1e5 : 1;
        const Points p = hard::star(r, 10, i % 3 == 2 ? 3 : 9, grid);
        Points w = hard::star(r, 9, i % 3 == 2 ? 3 : 9, grid);
        const glm::vec2 shift(hard::whole(r, -2, 2), hard::whole(r, -2, 2));
        for (glm::vec2& q : w) q += shift;
        if (p.size() < 3 || w.size() < 3) continue;
        const Rings in = inside(p, w), out = outside(p, w);
        const auto right = exact::twice_common_area(p, w) * exact::twice_area(w).sign();
        ASSERT_LE(static_cast<double>(abs(exact::twice_area_of_all(in) - right)), exact::area_slack(in)) << i;
        ASSERT_LE(static_cast<double>(abs(exact::twice_area_of_all(out) + right - exact::twice_area(p))),
                  exact::area_slack(out))
            << i;
        for (const Points& ring : in)
            if (static_cast<double>(abs(exact::twice_area(ring))) > exact::area_slack({ring})) {
                ASSERT_EQ(exact::twice_area(ring).sign(), exact::twice_area(p).sign()) << i << ": no holes";
            }
        pieces += static_cast<int>(in.size());
        for (const glm::vec2& corner : p) shared += std::ranges::count(w, corner) > 0;
    }
    EXPECT_GT(pieces, 800);
    EXPECT_GT(shared, 400);
}

// Two meeting points that are one in floats (20000000 and 20000001, where floats are 2 apart) keep their
// order.
TEST(GreinerHormann, OrderAlongAnEdgeIsExact) {
    const Points large{{0, 0}, {32e6f, 0}, {32e6f, 32e6f}, {0, 32e6f}};
    Points needle{{20'000'000, -8}, {20'000'002, -8}, {20'000'000, 8}};
    for (int turn = 0; turn < 3; ++turn) {
        std::rotate(needle.begin(), needle.begin() + 1, needle.end());
        for (const Points& ring : inside(large, needle)) EXPECT_LE(abs(exact::twice_area(ring)), 16);
        const Rings rest = outside(large, needle);
        ASSERT_EQ(rest.size(), 1u);
        EXPECT_LE(abs(exact::twice_area(rest[0]) - exact::twice_area(large)), 32);
    }
}

// All pairs of triangles on a grid of 3 x 3 points: every way in which corners and edges can touch.
TEST(GreinerHormann, AllSmallTriangles) {
    std::vector<Points> triangles;
    const auto point = [](int k) { return glm::vec2(static_cast<float>(k % 3), static_cast<float>(k / 3)); };
    for (int a = 0; a < 9; ++a)
        for (int b = a + 1; b < 9; ++b)
            for (int c = b + 1; c < 9; ++c)
                if (const Points t{point(a), point(b), point(c)}; exact::twice_area(t) != 0)
                    triangles.push_back(t);
    EXPECT_EQ(triangles.size(), 76u);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = 0; j < triangles.size(); ++j) {
            const Points &p = triangles[i], &w = triangles[j];
            const auto right = exact::twice_common_area(p, w) * exact::twice_area(w).sign();
            const Rings in = inside(p, w), out = outside(p, w);
            ASSERT_LE(static_cast<double>(abs(exact::twice_area_of_all(in) - right)), exact::area_slack(in));
            ASSERT_LE(static_cast<double>(abs(exact::twice_area_of_all(out) + right - exact::twice_area(p))),
                      exact::area_slack(out));
            ASSERT_LE(in.size(), 1u) << "convex";
            ASSERT_EQ(in.empty(), right == 0) << i << " " << j;
        }
}

// For a convex window it gives the pieces that Sutherland and Hodgman give once bridges are removed.
TEST(GreinerHormann, AgreesWithSutherlandHodgmanWithoutBridges) {
    const ClipBox box{{4, -12}, {13, 12}};
    const auto least_first = [](Rings rings) {
        for (Points& ring : rings) {
            std::rotate(ring.begin(), std::ranges::min_element(ring, comes_before), ring.end());
        }
        std::ranges::sort(rings, [](const Points& a, const Points& b) {
            return std::ranges::lexicographical_compare(a, b, comes_before);
        });
        return rings;
    };
    int several = 0;
    for (int i = 0; i < hard::cases(2000); ++i) {
        hard::Random r{std::uint64_t(i)};
        const Points p = hard::star(r, 40, 14, 1e5);
        const Rings one = least_first(clip_shape_greiner_hormann(p, box)),
                    two = least_first(split_bridges(clip_ring_sutherland_hodgman(p, box)));
        ASSERT_EQ(one, two) << i;
        several += one.size() > 1;
    }
    EXPECT_GT(several, 200);
}

}  // namespace
}  // namespace relevo::pipeline
