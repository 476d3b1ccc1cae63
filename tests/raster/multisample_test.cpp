// The seam between two shapes: there by area, not there by shared samples.
#include "raster/multisample.hpp"

#include <limits>

#include "tests/raster/coverage_grid.hpp"

namespace relevo::raster {
namespace {

using tests::RandomPlaces;
using tests::Ring;
using tests::Rings;

constexpr LinearRgb white{1, 1, 1}, red{Scalar(0.7), Scalar(0.1), Scalar(0.3)};

Image<LinearRgb> by_samples(int n, const Rings& shapes, LinearRgb color, const PixelBox& box = {0, 0, 9, 9},
                            Scalar opacity = 1) {
    Image<LinearRgb> picture(10, 10, white);
    std::vector<SampledShape> sampled;
    for (const Ring& ring : shapes)
        sampled.push_back({std::span(&ring, 1), InsideRule::NonZero, color, opacity});
    multisample(n, sampled, box, picture);
    return picture;
}
Image<LinearRgb> by_area(const Rings& shapes, LinearRgb color) {
    Image<LinearRgb> picture(10, 10, white);
    for (const Ring& ring : shapes)
        area_coverage(
            std::span<const glm::dvec2>(ring), {0, 0, 9, 9},
            [&](int y, int x0, int x1, int coverage) { over(picture.row(y), x0, x1, color, 1, coverage); });
    return picture;
}

bool all_are(const Image<LinearRgb>& picture, LinearRgb color) {
    return std::all_of(picture.pixels().begin(), picture.pixels().end(),
                       [&](const LinearRgb& c) { return c == color; });
}

// A square whose diagonal goes through the middle of pixels: each half covers half of them.
const Rings halves{{{-1, -1}, {12, -1}, {12, 12}}, {{-1, -1}, {12, 12}, {-1, 12}}};

TEST(Multisample, AreaCoverageLeavesASeam) {
    const Image<LinearRgb> picture = by_area(halves, {0, 0, 0});
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x)
            EXPECT_EQ(picture.at(x, y).r, x == y ? Scalar(0.25) : Scalar(0)) << "75 % and not 100 % of black";
}

TEST(Multisample, SharedSamplesLeaveNone) {
    for (int n = 1; n <= most_samples; ++n) {
        const Image<LinearRgb> picture = by_samples(n, halves, red);
        ASSERT_TRUE(all_are(picture, red)) << n;
    }
}

TEST(Multisample, NoMeshHasASeam) {
    RandomPlaces random(1);
    for (const int n : {1, 2, 3, 4, 7, 16}) {
        const Rings mesh = tests::shaken_mesh(-1, -1, 6, 2, random);
        ASSERT_TRUE(all_are(by_samples(n, mesh, red), red)) << n;
    }
}

TEST(Multisample, OneShapeIsItsSupersampledCoverage) {
    const Rings shape{{{1.25, 0.5}, {8.5, 3.75}, {2, 8.25}}};
    for (const int n : {1, 2, 4, 8, 16}) {
        Image<LinearRgb> right(10, 10, white);
        supersample(n, std::span<const Ring>(shape), InsideRule::NonZero, {0, 0, 9, 9},
                    [&](int y, int x0, int x1, int coverage) {
                        over(right.row(y), x0, x1, LinearRgb{0, 0, 0}, 1, coverage);
                    });
        EXPECT_TRUE(by_samples(n, shape, {0, 0, 0}).pixels() == right.pixels()) << n;
    }
}

TEST(Multisample, TheTopmostShapeOwnsThePoint) {
    Image<LinearRgb> picture(3, 3, white);
    const Ring all{{-5, -5}, {9, -5}, {9, 9}, {-5, 9}}, left{{-5, -5}, {1, -5}, {1, 9}, {-5, 9}};
    const SampledShape shapes[] = {{std::span(&all, 1), InsideRule::NonZero, red, 1},
                                   {std::span(&left, 1), InsideRule::NonZero, {0, 0, 0}, Scalar(0.5)}};
    multisample(4, shapes, {0, 0, 2, 2}, picture);
    EXPECT_EQ(picture.at(2, 1), red);
    EXPECT_EQ(picture.at(0, 1), Scalar(0.5) * red);
    EXPECT_NEAR(picture.at(1, 1).r, Scalar(0.75) * red.r, 1e-7);
}

TEST(Multisample, OnlyTheBoxIsTouchedAndBandsDoNotShow) {
    const Rings shape{{{1.25, 0.5}, {8.5, 3.75}, {2, 8.25}}};
    const Image<LinearRgb> whole = by_samples(4, shape, red), part = by_samples(4, shape, red, {3, 2, 30, 5});
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x)
            EXPECT_EQ(part.at(x, y), PixelBox({3, 2, 30, 5}).holds(x, y) ? whole.at(x, y) : white);
    Image<LinearRgb> tall(100, 200, white),
        again(100, 200, white);  // 512,000 points at 16 x 16: several bands
    const Ring big{{-3, -3}, {90.5, 20}, {40.25, 210}};
    const SampledShape shapes[] = {{std::span(&big, 1), InsideRule::NonZero, red, 1}};
    multisample(16, shapes, {0, 0, 99, 199}, tall);
    for (int y = 0; y < 200; y += 7) multisample(16, shapes, {0, y, 99, y + 6}, again);
    EXPECT_TRUE(tall.pixels() == again.pixels());
}

TEST(Multisample, Refusals) {
    const Rings shape{{{1, 0}, {8, 3}, {2, 8}}};
    for (const int n : {0, 17, -4}) ASSERT_TRUE(all_are(by_samples(n, shape, red), white));
    ASSERT_TRUE(all_are(by_samples(4, shape, red, {5, 5, 4, 9}), white));
    ASSERT_TRUE(all_are(by_samples(4, {{{1, std::nan("")}, {8, 3}, {2, 8}}}, red), white));
}

TEST(Multisample, TheProbeSeesTheSamplesOfMixedPixels) {
    struct Ear {
        int mixed = 0;
        void on(const PixelResolved& e) {
            ++mixed;
            ASSERT_EQ(e.samples.size(), 16u);
            Scalar sum = 0;
            for (const LinearRgb& c : e.samples) sum += c.r;
            EXPECT_NEAR(e.color.r, sum / 16, 1e-6);
        }
    } ear;
    Image<LinearRgb> picture(10, 10, white);
    const SampledShape shapes[] = {{std::span(&halves[0], 1), InsideRule::NonZero, {0, 0, 0}, 1}};
    multisample(4, shapes, {0, 0, 9, 9}, picture, ear);
    EXPECT_EQ(ear.mixed, 10) << "the diagonal";
}

}  // namespace
}  // namespace relevo::raster
