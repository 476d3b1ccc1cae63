#include "pipeline/clip_shape_pipeline.hpp"

#include <gtest/gtest.h>

#include "tests/pipeline/shape_oracle.hpp"

namespace relevo::pipeline {
namespace {

namespace hard = tests::hard;
using Points = std::vector<glm::vec2>;

bool same_bits(const ClippedRing& a, const ClippedRing& b) {
    const auto equal = [](const glm::vec2& p, const glm::vec2& q) {
        return std::bit_cast<std::uint64_t>(std::array{p.x, p.y}) ==
               std::bit_cast<std::uint64_t>(std::array{q.x, q.y});
    };
    return std::ranges::equal(a.points, b.points, equal) && a.edge_side == b.edge_side &&
           a.point_side == b.point_side;
}

TEST(ShapePipeline, IsFourPassesToTheLastBit) {
    const ClipBox box{{0, 0}, {10, 10}};
    const Points polygon_window{{1, 1}, {4, -3}, {8, -4}, {12, 0}, {12.5f, 3}, {9, 9}, {3, 7.25f}};
    int clipped = 0;
    for (int i = 0; i < hard::cases(20'000); ++i) {
        hard::Random r{std::uint64_t(i)};
        Points polygon = i % 4 == 0   ? hard::tangle(r, static_cast<int>(r.integer(0, 12)), 12)
                         : i % 4 == 1 ? hard::star(r, 12, 14, 2)
                                      : hard::star(r, 12, 14, 1e6);
        for (glm::vec2& p : polygon) p += glm::vec2(4, 4);
        if (i % 4 == 3)
            for (glm::vec2& p : polygon) p = {r.any_finite_float(), r.any_finite_float()};
        const ClippedRing passes = clip_ring_sutherland_hodgman(polygon, box);
        ASSERT_TRUE(same_bits(clip_ring_pipeline(polygon, box), passes)) << i;
        ASSERT_TRUE(same_bits(clip_ring_pipeline(polygon, polygon_window),
                              clip_ring_sutherland_hodgman(polygon, polygon_window)))
            << i;
        clipped += !passes.points.empty() && passes.points != polygon;
    }
    EXPECT_GT(clipped, 5000);
}

TEST(ShapePipeline, HoldsOnlyFirstAndLast) {
    struct Watch {
        std::vector<ShapeStageHolds> held;
        int emitted = 0;
        void on(const ShapeStageHolds& e) { held.push_back(e); }
        void on(const ShapePointEmitted& e) { emitted += e.side == 0; }
    } w;
    const Points polygon{{5, 5}, {-5, 5}, {-5, 7}, {5, 9}};
    EXPECT_EQ(clip_shape_pipeline(polygon, ClipBox{{0, 0}, {10, 10}}, w).size(), 4u);
    int first_stage = 0;
    for (const ShapeStageHolds& e : w.held)
        if (e.side == 0) {
            ++first_stage;
            EXPECT_EQ(e.first, polygon[0]);
        }
    EXPECT_EQ(first_stage, 4) << "each corner once";
    EXPECT_EQ(w.emitted, 4);
}

TEST(ShapePipeline, RefusesTheSame) {
    const Points triangle{{1, 1}, {5, 1}, {1, 5}};
    EXPECT_TRUE(clip_shape_pipeline(triangle, ClipBox{{3, 0}, {2, 9}}).empty());
    EXPECT_TRUE(clip_shape_pipeline(triangle, Points{{0, 0}, {9, 0}, {1, 1}, {0, 9}}).empty());
    EXPECT_TRUE(clip_shape_pipeline(Points{{1, 1}, {NAN, 1}, {1, 5}}, ClipBox{{0, 0}, {9, 9}}).empty());
}

TEST(ShapePipeline, AWindowOfManySides) {  // no stage calls the next one
    Points window;
    for (int i = 0; i < 2000; ++i)
        window.emplace_back(9 * cos(Degrees{0.18 * i}), 9 * sin(Degrees{0.18 * i}));
    ASSERT_TRUE(is_convex(window));
    EXPECT_EQ(clip_shape_pipeline(Points{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, window).size(), 2000u);
}

}  // namespace
}  // namespace relevo::pipeline
