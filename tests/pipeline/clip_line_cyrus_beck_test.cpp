#include "pipeline/clip_line_cyrus_beck.hpp"

#include <gtest/gtest.h>

#include "pipeline/elementary.hpp"
#include "tests/pipeline/clip_oracle.hpp"

namespace relevo::pipeline {
namespace {

namespace exact = tests::exact;
namespace hard = tests::hard;
using Points = std::vector<glm::vec2>;

struct Watch {
    std::vector<SideParameterFound> sides;
    std::vector<Refusal> refused;
    void on(const SideParameterFound& e) { sides.push_back(e); }
    void on(const ClipRefused& e) { refused.push_back(e.reason); }
};

TEST(CyrusBeck, NumbersOfATriangle) {
    const Points window{{0, 0}, {8, 0}, {0, 8}};
    Watch w;
    EXPECT_EQ(clip_line_cyrus_beck(Segment{{-2, 2}, {14, 2}}, window, w), (Segment{{0, 2}, {6, 2}}));
    ASSERT_EQ(w.sides.size(), 3u);
    EXPECT_EQ(w.sides[0].passage, Passage::ParallelInside) << "the top";
    EXPECT_TRUE(std::isnan(w.sides[0].t));
    EXPECT_EQ(w.sides[1].passage, Passage::Leaving) << "the long side";
    EXPECT_EQ(w.sides[1].normal_x, 8) << "its normal points outwards";
    EXPECT_EQ(w.sides[1].normal_y, 8);
    EXPECT_EQ(w.sides[1].numerator, -64) << "N . (P0 - PL) = 8 (-2 - 8) + 8 (2 - 0)";
    EXPECT_EQ(w.sides[1].denominator, -128) << "-N . D = -8 16";
    EXPECT_EQ(w.sides[1].t, 0.5);
    EXPECT_EQ(w.sides[1].t_out, 0.5);
    EXPECT_EQ(w.sides[2].passage, Passage::Entering) << "the left side";
    EXPECT_EQ(w.sides[2].t, 0.125);
    EXPECT_EQ(w.sides[2].t_in, 0.125);
    EXPECT_EQ(clip_line_cyrus_beck(Segment{{-2, 2}, {14, 2}}, Points(window.rbegin(), window.rend())),
              (Segment{{0, 2}, {6, 2}}))
        << "either winding";
}

TEST(CyrusBeck, RefusesWindowsThatAreNotConvex) {
    Watch w;
    const Segment s{{-2, 2}, {14, 2}};
    EXPECT_FALSE(clip_line_cyrus_beck(s, Points{{0, 0}, {8, 0}, {1, 1}, {0, 8}}, w));
    EXPECT_FALSE(clip_line_cyrus_beck(s, Points{{0, 0}, {8, 0}}, w));
    EXPECT_FALSE(clip_line_cyrus_beck(Segment{{NAN, 2}, {14, 2}}, Points{{0, 0}, {8, 0}, {0, 8}}, w));
    EXPECT_EQ(w.refused, (std::vector{Refusal::NotConvex, Refusal::NoArea, Refusal::NotFinite}));
}

// A convex polygon on a circle, some corners twice, some in the middle of a side; either winding.
Points convex_polygon(hard::Random& r) {
    const int corners = static_cast<int>(r.integer(3, 9));
    const double radius = r.between(1, 9), start = r.between(0, 360);
    for (;;) {
        Points polygon;
        for (int i = 0; i < corners; ++i) {
            const Degrees angle{start + 360.0 * i / corners + r.between(0, 300.0 / corners)};
            polygon.emplace_back(std::nearbyint(64 * radius * cos(angle)) / 64,
                                 std::nearbyint(64 * radius * sin(angle)) / 64);
            if (r.integer(0, 5) == 0) polygon.push_back(polygon.back());
            if (i > 0 && r.integer(0, 5) == 0)
                polygon.insert(polygon.end() - 1, (polygon.back() + polygon[polygon.size() - 2]) / 2.0f);
        }
        if (r.coin()) std::reverse(polygon.begin(), polygon.end());
        if (is_convex(polygon)) return polygon;
    }
}

TEST(CyrusBeck, IsRightForAnyConvexWindow) {
    int visible = 0, touching = 0;
    const int cases = hard::cases(4000);
    for (int i = 0; i < cases; ++i) {
        hard::Random r{std::uint64_t(i)};
        const Points window = convex_polygon(r);
        const auto p = [&] { return glm::vec2(hard::real(r, -12, 12), hard::real(r, -12, 12)); };
        Segment s{p(), p()};
        if (i % 3 == 0) {  // through a corner, or an ulp beside it
            const glm::vec2 corner = window[std::size_t(r.integer(0, std::int64_t(window.size()) - 1))],
                            d(hard::whole(r, -40, 40) / 64, hard::whole(r, -40, 40) / 64);
            s = {corner - d * 3.0f, corner + d * hard::whole(r, 1, 9)};
            if (r.coin()) s.a.x = hard::moved(s.a.x, r.integer(-1, 1));
        }
        if (i % 50 == 0) s.a *= 2e37f, s.b *= 2e37f;
        const auto halves = exact::halves_of(window);
        const auto right = exact::right_answer(s, halves);
        ASSERT_EQ(clip_line_cyrus_beck(s, window), right) << i << " " << testing::PrintToString(s);
        auto back = clip_line_cyrus_beck({s.b, s.a}, window);
        if (back) std::swap(back->a, back->b);
        ASSERT_EQ(back, right);
        visible += right.has_value();
        touching += right && right->a == right->b;
    }
    EXPECT_GT(visible, cases / 5);
    EXPECT_LT(visible, cases);
    EXPECT_GT(touching, 100);
}

}  // namespace
}  // namespace relevo::pipeline
