// Forms of antialiasing side by side: how far each is from the exact covered area. It prints the table; the
// figures are checked, so that none gets worse.
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "raster/weighted_coverage.hpp"
#include "tests/accuracy/coverage_families.hpp"

namespace relevo::accuracy {
namespace {

struct Figures {
    double edge_rms, edge_max, level_rms, sliver_missed, tiny_missed;
};

template <class Draw>
Figures figures(Draw draw) {
    const CoverageErrors edge = against_area(CoverageFamily::LongEdge, 800, draw),
                         level = against_area(CoverageFamily::NearlyLevel, 800, draw),
                         sliver = against_area(CoverageFamily::Sliver, 800, draw),
                         tiny = against_area(CoverageFamily::Tiny, 4000, draw);
    return {edge.rms, edge.largest.error, level.rms, 100 * sliver.missed, 100 * tiny.missed};
}

void print(const std::string& name, const Figures& f) {
    std::printf("%-10s  %8.4f  %8.4f  %8.4f  %8.2f %%  %8.2f %%\n", name.c_str(), f.edge_rms, f.edge_max,
                f.level_rms, f.sliver_missed, f.tiny_missed);
}
void print_head() {
    std::printf("%-10s  %8s  %8s  %8s  %10s  %10s\n", "", "edge rms", "edge max", "level", "1/8 missed",
                "tiny missed");
}

// At most these: what is measured, with a little room. A single edge through a pixel is never off by more
// than half the distance of two points.
const std::map<int, Figures> grids = {
    {1, {0.25, 0.5001, 0.29, 91, 88}},     {2, {0.088, 0.25, 0.139, 65, 61}},
    {3, {0.047, 1.0 / 6, 0.09, 37, 42}},   {4, {0.03, 0.125, 0.066, 19, 28}},
    {8, {0.0105, 1.0 / 16, 0.03, 1.3, 4}}, {16, {0.004, 1.0 / 32, 0.0125, 0.05, 0.3}},
};

TEST(CoverageTable, SamplesComeCloserToTheAreaTheMoreThereAre) {
    print_head();
    std::optional<Figures> before;
    for (int n = 1; n <= raster::most_samples; ++n) {
        const Figures f = figures(samples(n));
        print(text("%d x %d", n, n), f);
        if (before) {
            EXPECT_LT(f.edge_rms, before->edge_rms) << n;
            EXPECT_LT(f.sliver_missed, before->sliver_missed) << n;
        }
        before = f;
        EXPECT_LE(f.edge_max, 0.5 / n + 0x1p-16);
        const auto most = grids.find(n);
        if (most == grids.end()) continue;
        EXPECT_LE(f.edge_rms, most->second.edge_rms) << n;
        EXPECT_LE(f.edge_max, most->second.edge_max) << n;
        EXPECT_LE(f.level_rms, most->second.level_rms) << n;
        EXPECT_LE(f.sliver_missed, most->second.sliver_missed) << n;
        EXPECT_LE(f.tiny_missed, most->second.tiny_missed) << n;
    }
}

// The cone answers another question than the square: it differs from the area on purpose, and misses nothing.
TEST(CoverageTable, TheConeMissesNothingThatIsThere) {
    const Figures f = figures([](const std::vector<Ring>& rings, auto cover) {
        raster::weighted_coverage(rings, raster::InsideRule::NonZero, family_box, cover);
    });
    print_head();
    print("weighted", f);
    EXPECT_LT(f.edge_rms, 0.06);
    EXPECT_LT(f.edge_max, 0.15);
    EXPECT_LT(f.sliver_missed, 0.2);
    EXPECT_LT(f.tiny_missed, 0.5);
}

}  // namespace
}  // namespace relevo::accuracy
