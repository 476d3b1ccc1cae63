// The laws that all four line clippers keep.
#include <gtest/gtest.h>

#include <functional>

#include "pipeline/clip_line_cohen_sutherland.hpp"
#include "pipeline/clip_line_cyrus_beck.hpp"
#include "pipeline/clip_line_liang_barsky.hpp"
#include "pipeline/clip_line_midpoint.hpp"
#include "tests/pipeline/clip_oracle.hpp"

namespace relevo::pipeline {
namespace {

namespace exact = tests::exact;
namespace hard = tests::hard;

struct Clipper {
    const char* name;
    std::optional<Segment> (*clip)(const Segment&, const ClipBox&);
};
constexpr Clipper clippers[] = {
    {"Cohen-Sutherland", [](const Segment& s, const ClipBox& b) { return clip_line_cohen_sutherland(s, b); }},
    {"Liang-Barsky", [](const Segment& s, const ClipBox& b) { return clip_line_liang_barsky(s, b); }},
    {"Cyrus-Beck", [](const Segment& s, const ClipBox& b) { return clip_line_cyrus_beck(s, b); }},
    {"midpoint", [](const Segment& s, const ClipBox& b) { return clip_line_midpoint(s, b); }},
};

// All segments with coordinates -3..8 on the window 0..5.
TEST(ClipLines, AgreeOnAllSmallSegments) {
    const ClipBox box{{0, 0}, {5, 5}};
    const auto window = exact::halves_of(box);
    int visible = 0;
    for (int code = 0; code < 12 * 12 * 12 * 12; ++code) {
        const auto c = [&](int power) { return static_cast<float>(code / power % 12 - 3); };
        const Segment s{{c(1), c(12)}, {c(144), c(1728)}};
        const auto right = exact::right_answer(s, window);
        visible += right.has_value();
        for (const Clipper& clipper : clippers) ASSERT_EQ(clipper.clip(s, box), right) << clipper.name;
    }
    EXPECT_EQ(visible, 14228);
}

// Decisions and both ends, to the last bit, for every kind of float. (-0 equals 0.)
TEST(ClipLines, AreRightOnHardSegments) {
    for (const hard::LineFamily& family : hard::line_families()) {
        int visible = 0;
        const int cases = hard::cases(1200);
        for (int i = 0; i < cases; ++i) {
            hard::Random random(hard::seed_of(family.name, std::uint64_t(i)));
            const auto [s, box] = family.make(random);
            const auto right = exact::right_answer(s, exact::halves_of(box));
            visible += right.has_value();
            for (const Clipper& clipper : clippers)
                ASSERT_EQ(clipper.clip(s, box), right)
                    << clipper.name << ", " << family.name << ":" << i << " " << testing::PrintToString(s)
                    << " in " << testing::PrintToString(box);
        }
        EXPECT_GT(visible, cases / 50) << family.name << " must not only be rejected";
        EXPECT_LT(visible, family.all_visible ? cases + 1 : cases) << family.name;
    }
}

TEST(ClipLines, DirectionOnlySwapsTheEnds) {
    for (const hard::LineFamily& family : hard::line_families())
        for (int i = 0; i < hard::cases(20'000); ++i) {
            hard::Random random(hard::seed_of(family.name, std::uint64_t(i) + 1'000'000));
            const auto [s, box] = family.make(random);
            const auto there = clip_line_cohen_sutherland(s, box);
            auto back = clip_line_cohen_sutherland({s.b, s.a}, box);
            if (back) std::swap(back->a, back->b);
            ASSERT_EQ(there, back) << family.name << " " << testing::PrintToString(s);
            // The others are compared more cheaply with the first than with the oracle.
            ASSERT_EQ(there, clip_line_liang_barsky(s, box)) << testing::PrintToString(s);
            ASSERT_EQ(there, clip_line_cyrus_beck(s, box)) << testing::PrintToString(s);
            if (i % 16 == 0) {
                ASSERT_EQ(there, clip_line_midpoint(s, box)) << testing::PrintToString(s);
            }
            if (there) {
                ASSERT_EQ(outcode(box, there->a) | outcode(box, there->b), 0) << "an end outside";
                ASSERT_EQ(clip_line_cohen_sutherland(*there, box), there) << "clipped twice";
            }
        }
}

// The failures of clippers in plain float, as measured for them.
TEST(ClipLines, DoNotFailWhereFloatsDo) {
    const ClipBox box{{0, 0}, {10, 10}};
    const auto is = [&](const Segment& s, const std::optional<Segment>& right) {
        for (const Clipper& clipper : clippers)
            EXPECT_EQ(clipper.clip(s, box), right) << clipper.name << " " << testing::PrintToString(s);
    };
    is({{-3e38f, 5}, {3e38f, 5}}, Segment{{0, 5}, {10, 5}});            // 0 * infinity
    is({{-3e38f, -3e38f}, {3e38f, 3e38f}}, Segment{{0, 0}, {10, 10}});  // infinity - infinity
    is({{5, -3e38f}, {5.0001f, 3e38f}}, Segment{{5.00005f, 0}, {5.00005f, 10}});
    is({{-5, 5.0000005f}, {5, 15.0000005f}}, std::nullopt);  // an ulp beyond the corner
    is({{-5, 5}, {5, 15}}, Segment{{0, 10}, {0, 10}});       // through the corner
    is({{-0.0f, -0.0f}, {-0.0f, 20}}, Segment{{0, 0}, {0, 10}});
    is({{0x1p-149f, 0x1p-149f}, {0x1p-149f, 20}}, Segment{{0x1p-149f, 0x1p-149f}, {0x1p-149f, 10}});
    is({{-0x1p-149f, 5}, {-0x1p-149f, 7}}, std::nullopt);  // outside by the least float
}

TEST(ClipLines, RefuseWhatIsNotANumber) {
    struct Watch {
        std::vector<Refusal> heard;
        void on(const ClipRefused& e) { heard.push_back(e.reason); }
    };
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const auto refused = [&](const Segment& s, const ClipBox& box, Refusal reason) {
        Watch w;
        EXPECT_FALSE(clip_line_cohen_sutherland(s, box, order_of_the_bits, w));
        EXPECT_FALSE(clip_line_liang_barsky(s, box, w));
        EXPECT_FALSE(clip_line_cyrus_beck(s, box, w));
        EXPECT_FALSE(clip_line_midpoint(s, box, w));
        EXPECT_EQ(w.heard, std::vector(4, reason));
    };
    const ClipBox box{{0, 0}, {10, 10}};
    const Segment inside{{1, 1}, {2, 2}};
    for (const float bad : {nan, inf, -inf})
        for (int k = 0; k < 4; ++k) {
            Segment s = inside;
            (k & 2 ? s.b : s.a)[k & 1] = bad;
            refused(s, box, Refusal::NotFinite);
            ClipBox b = box;
            (k & 2 ? b.high : b.low)[k & 1] = bad;
            refused(inside, b, Refusal::NotFinite);
        }
    refused(inside, {{3, 0}, {2, 10}}, Refusal::EmptyBox);
    refused(inside, {{0, 3}, {10, 2}}, Refusal::EmptyBox);
}

}  // namespace
}  // namespace relevo::pipeline
