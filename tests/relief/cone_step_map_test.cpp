#include "relief/cone_step_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "relief/inverse_slices.hpp"
#include "relief/relaxed_cone_map.hpp"
#include "relief/surface_plane_step.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/relief/image_experiment.hpp"

namespace relevo::relief {
namespace {

using tests::experiment_source;
using tests::experiment_viewer;

struct Counter {
    long looks = 0;
    void on(const SolidLookedUp&) { ++looks; }
};

ReliefTexture relief_of(const Spheres& object, int size) { return ray_cast(object, experiment_source(size)); }

TEST(ConeStepMap, FindsExactlyWhatVisitingEveryTexelFinds) {
    for (const Spheres* object : {&scene::sphere_object, &scene::bumpy_object, &scene::complex_object}) {
        const ReliefTexture texture = relief_of(*object, 64);
        for (const ReliefSolid& solid : {extruded_solid(texture), solid_of_thickness(texture, 0.1)}) {
            const ConeStepMap map = make_cone_step_map(solid);
            Counter every, cones;
            int hits = 0, differ = 0;
            const ReliefCamera viewer = experiment_viewer(40, 128);
            const ReliefRays rays = *relief_rays(texture.camera, viewer);
            for (int y = 0; y < 128; ++y)
                for (int x = 0; x < 128; ++x) {
                    const ReliefRay ray = *rays.through(x + 0.5, y + 0.5);
                    const auto a = find_by_texels(solid, ray, every),
                               b = find_by_cones(solid, map, ray, cones);
                    hits += a.has_value();
                    differ += a.has_value() != b.has_value() ||
                              (a && (a->x != b->x || a->y != b->y || a->z != b->z));
                }
            std::printf("%d hits, look-ups: every texel %.2f a ray, cones %.2f\n", hits,
                        double(every.looks) / (128 * 128), double(cones.looks) / (128 * 128));
            EXPECT_GT(hits, 1500);
            EXPECT_EQ(differ, 0);
            EXPECT_LT(cones.looks, 0.85 * double(every.looks));
        }
    }
}

TEST(ConeStepMap, NoConeHoldsAnythingOfTheRelief) {
    const ReliefSolid solid = extruded_solid(relief_of(scene::complex_object, 32));
    const ConeStepMap map = make_cone_step_map(solid);
    int narrow = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const double here = std::min(double(solid.front.at(x, y)), solid.high);
            double widest = widest_cone;
            for (int j = 0; j < 32; ++j)
                for (int i = 0; i < 32; ++i) {  // the distance between the squares, another way
                    const double above = here - std::min(double(solid.front.at(i, j)), solid.high);
                    const double gx = std::fmax(std::fabs(i - x) - 1, 0),
                                 gy = std::fmax(std::fabs(j - y) - 1, 0);
                    if (above > 0) widest = std::min(widest, std::hypot(gx, gy) / above);
                }
            ASSERT_NEAR(map.at(x, y), widest, 2e-6 * widest);
            narrow += widest < widest_cone;
        }
    EXPECT_GT(narrow, 900);
}

TEST(ConeStepMap, OverAStepTheConeIsAsWideAsTheWay) {
    const ReliefTexture texture =
        ray_cast(PlaneStep{0.5}, *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 20, 20}, {0, 0, 0.5}, 2));
    const ConeStepMap map = make_cone_step_map(extruded_solid(texture));
    EXPECT_EQ(map.at(15, 10), widest_cone * Scalar(1 - 1e-6));  // on the upper plate
    EXPECT_NEAR(map.at(3, 10), 7 / 0.5, 1e-4);                  // column 11 is the first of the upper plate
    EXPECT_EQ(map.at(10, 10), 0);                               // right beside it
}

TEST(RelaxedConeMap, IsWiderAndFasterAndSeldomWrong) {
    const ReliefTexture texture = relief_of(scene::bumpy_object, 64);
    const ReliefSolid solid = extruded_solid(texture);
    const ConeStepMap safe = make_cone_step_map(solid), relaxed = make_relaxed_cone_map(solid);
    int wider = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) wider += relaxed.at(x, y) > safe.at(x, y);
    EXPECT_GT(wider, 64 * 64 / 2);
    for (const double azimuth : {10.0, 40.0}) {
        Counter cones, jumps;
        int hits = 0, wrong = 0;
        const ReliefRays rays = *relief_rays(texture.camera, experiment_viewer(azimuth, 128));
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) {
                const ReliefRay ray = *rays.through(x + 0.5, y + 0.5);
                const auto a = find_by_cones(solid, safe, ray, cones),
                           b = find_by_relaxed_cones(solid, relaxed, ray, 10);
                find_by_relaxed_cones(solid, relaxed, ray, 0, jumps);
                hits += a.has_value();
                wrong += a.has_value() != b.has_value() || (a && std::fabs(a->z - b->z) > 0.01);
            }
        std::printf("%2.0f degrees: %d hits, look-ups: safe cones %.2f a ray, relaxed %.2f, wrong %.2f %%\n",
                    azimuth, hits, double(cones.looks) / (128 * 128), double(jumps.looks) / (128 * 128),
                    100.0 * wrong / hits);
        EXPECT_LT(jumps.looks, 0.6 * double(cones.looks));
        EXPECT_LT(wrong, 0.03 * hits);
    }
}

TEST(ConeStepMap, FlatAndEmptyReliefs) {
    ReliefTexture texture = make_relief_texture(experiment_source(8));
    const ReliefRay ray{{4.5, 4.5}, {0.5, 0.25}};
    ReliefSolid solid = extruded_solid(texture);
    EXPECT_FALSE(find_by_cones(solid, make_cone_step_map(solid), ray));
    EXPECT_FALSE(find_by_relaxed_cones(solid, make_relaxed_cone_map(solid), ray, 4));
    for (std::uint8_t& c : texture.coverage.pixels()) c = 1;
    solid = extruded_solid(texture);
    EXPECT_EQ(find_by_cones(solid, make_cone_step_map(solid), ray)->z, 0);
    EXPECT_EQ(find_by_relaxed_cones(solid, make_relaxed_cone_map(solid), ray, 4)->z, 0);
}

// What the searches cost: 32 slices and 8 bisections against 256 slices.
TEST(InverseCost, ThirtyTwoSlicesAndEightBisectionsReplaceTwoHundredAndFiftySix) {
    const ReliefTexture texture = relief_of(scene::sphere_object, 256);
    const ReliefSolid solid = extruded_solid(texture);
    Counter refined, sliced;
    const ReliefRays rays = *relief_rays(texture.camera, experiment_viewer(0, 128));
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const ReliefRay ray = *rays.through(x + 0.5, y + 0.5);
            find_by_slices(solid, ray, {32, 8}, refined), find_by_slices(solid, ray, {256, 0}, sliced);
        }
    std::printf("look-ups a ray: 32 + 8 %.2f, 256 slices %.2f\n", double(refined.looks) / (128 * 128),
                double(sliced.looks) / (128 * 128));
    EXPECT_LT(3 * refined.looks, sliced.looks);
}

}  // namespace
}  // namespace relevo::relief
