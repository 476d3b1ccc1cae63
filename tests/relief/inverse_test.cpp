// The inverse mapping: rays, solids, slices, bisection, texel by texel.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "relief/inverse_slices.hpp"
#include "relief/inverse_texels.hpp"
#include "relief/inverse_view.hpp"
#include "relief/surface_plane_step.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/relief/image_experiment.hpp"
#include "tests/relief/slice_workload.hpp"

namespace relevo::relief {
namespace {

using tests::experiment_source;
using tests::experiment_viewer;

ReliefCamera perspective_source(int size = 128) {
    return *perspective_camera({{0.2, -0.1, 1}, {0, 1, 0}, size, size}, {-0.6, 0.3, -3}, 1.7, {42});
}

// ---------------------------------------------------------------------------------------------- rays
TEST(ReliefRay, RunsThroughTheSamePointsAsTheLineOfSight) {
    for (const ReliefCamera& source : {experiment_source(), perspective_source()})
        for (const double azimuth : {0.0, 25.0, 40.0}) {
            const ReliefCamera viewer = experiment_viewer(azimuth);
            const ReliefRays rays = *relief_rays(source, viewer);
            for (const double x : {0.5, 130.25, 500.0})
                for (const double y : {3.0, 256.0, 400.5}) {
                    const ReliefRay ray = *rays.through(x, y);
                    const glm::dvec3 sight = glm::normalize(plane_point(viewer, x, y) - viewer.eye);
                    for (const double z : {0.0, 0.2, 0.6}) {
                        const glm::dvec2 place = ray.at(z);
                        const glm::dvec3 p = inward_point(source, place.x, place.y, z) - viewer.eye;
                        EXPECT_LT(glm::length(glm::cross(p, sight)), 1e-9) << azimuth << ' ' << z;
                        EXPECT_GT(glm::dot(p, sight), 0);
                    }
                }
        }
}

TEST(ReliefRay, LinesOfSightThatMissThePlaneAreNone) {
    const ReliefCamera away = *perspective_camera({{1, 0, 0.2}, {0, 1, 0}, 64, 64}, {0, 0, -3}, 1, {90});
    const ReliefRays rays = *relief_rays(experiment_source(), away);
    int hits = 0;
    for (int x = 0; x < 64; ++x) {
        const glm::dvec3 sight = plane_point(away, x + 0.5, 32) - away.eye;
        EXPECT_EQ(rays.through(x + 0.5, 32).has_value(), sight.z > 0);
        hits += sight.z > 0;
    }
    EXPECT_TRUE(0 < hits && hits < 64);
    EXPECT_FALSE(relief_rays(experiment_source(), experiment_viewer(0, 64, 0.9)));  // behind the plane
}

// ---------------------------------------------------------------------------------------------- shares
TEST(TexelShares, AreBilinearInsideAndCutAtBorders) {
    const int width = 3, height = 2;
    const char* covered[] = {"##.", "###"};
    const double depth[2][3] = {{0, 0.05, 0}, {0.1, 2, 0.02}};
    const auto shares = [&](double u, double v, Reading reading, double jump) {
        return texel_shares(
            width, height, u, v, reading, jump, [&](int x, int y) { return covered[y][x] == '#'; },
            [&](int x, int y) { return depth[y][x]; });
    };
    const auto all = *shares(1.25, 0.75, Reading::Bilinear, 10);
    EXPECT_EQ(all.x, 0);
    EXPECT_EQ(all.y, 0);
    EXPECT_EQ(all.share, (std::array<double, 4>{0.25 * 0.75, 0.75 * 0.75, 0.25 * 0.25, 0.75 * 0.25}));
    const auto cut = *shares(1.25, 0.75, Reading::Bilinear, 0.1);  // the texel of depth 2 does not count
    EXPECT_EQ(cut.share[3], 0);
    EXPECT_NEAR(cut.share[0] + cut.share[1] + cut.share[2], 1, 1e-15);
    EXPECT_NEAR(cut.share[1] / cut.share[0], 3, 1e-12);
    EXPECT_TRUE(shares(1.9, 0.5, Reading::Bilinear, 1));
    EXPECT_FALSE(shares(2.1, 0.5, Reading::Bilinear, 1));  // more than half of it is empty
    EXPECT_TRUE(shares(2.1, 1.2, Reading::Bilinear, 10));
    EXPECT_TRUE(shares(0.1, 0.5, Reading::Bilinear, 1));
    EXPECT_FALSE(shares(0.1, 0.1, Reading::Bilinear, 1));  // corners are rounded off
    EXPECT_FALSE(shares(-0.1, 0.1, Reading::Bilinear, 1));
    EXPECT_FALSE(shares(1, 2, Reading::Nearest, 1));
    EXPECT_FALSE(shares(2.9, 0.9, Reading::Nearest, 1));
    EXPECT_EQ(shares(2.9, 1.9, Reading::Nearest, 1)->x, 2);
    EXPECT_EQ(weighted_sum(all, 0.0, [&](int x, int y, double share) { return share * depth[y][x]; }),
              0.75 * 0.75 * 0.05 + 0.25 * 0.25 * 0.1 + 0.75 * 0.25 * 2);
}

// ---------------------------------------------------------------------------------------------- solids
TEST(ReliefSolid, EndsWhereItIsSaidTo) {
    const ReliefCamera source = experiment_source(64);
    const ReliefTexture front = ray_cast(scene::sphere_object, source);
    const ReliefSolid extruded = extruded_solid(front), thick = solid_of_thickness(front, 0.25);
    const ReliefSolid between =
        solid_between(front, ray_cast(scene::sphere_object, opposite_camera(source, 2)));
    for (const double u : {10.5, 25.5, 40.5}) {
        const double x = u / 32 - 1, y = 1 - 30.5 / 32, top = std::sqrt(1 - x * x - y * y);
        for (double z = 0.01; z < 2; z += 0.02) {
            EXPECT_EQ(extruded.contains(u, 30.5, z), z > 1 - top);
            EXPECT_EQ(thick.contains(u, 30.5, z), z > 1 - top && z < 1.25 - top);
            EXPECT_EQ(between.contains(u, 30.5, z), std::fabs(z - 1) < top);
        }
    }
    EXPECT_FALSE(extruded.contains(0.5, 0.5, 1.5));
    EXPECT_FALSE(extruded.contains(-0.5, 30.5, 1.5));
    EXPECT_NEAR(between.high, 2, 0.01);
    EXPECT_LE(extruded.high, 1);
}

TEST(ReliefSolid, ThicknessIsInWorldUnitsForBothCameras) {
    const ReliefTexture front =
        ray_cast(PlaneStep{1}, *perspective_camera({{0, 0, -1}, {0, 1, 0}, 32, 32}, {0, 0, 4}, 2.5, {30}));
    const ReliefSolid solid = solid_of_thickness(front, 0.5);
    const glm::dvec3 begin = inward_point(front.camera, 8.5, 8.5, solid.front.at(8, 8));
    const glm::dvec3 end = inward_point(front.camera, 8.5, 8.5, solid.back.at(8, 8));
    EXPECT_NEAR(begin.z, 0, 1e-6);
    EXPECT_NEAR(end.z, -0.5, 1e-6);
}

// ---------------------------------------------------------------------------------------------- searches
template <class Find>
void for_each_ray(const ReliefRays& rays, int size, Find&& find) {
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (const auto ray = rays.through(x + 0.5, y + 0.5)) find(*ray);
}

TEST(InverseTexels, FindsWhatVeryManySlicesFind) {
    for (const ReliefCamera& source : {experiment_source(32), perspective_source(32)}) {
        const ReliefTexture texture = ray_cast(scene::bumpy_object, source);
        for (const ReliefSolid& solid : {extruded_solid(texture), solid_of_thickness(texture, 0.15)}) {
            const double slice = (solid.high - solid.low) / 4000;
            int hits = 0, differ = 0;
            for_each_ray(*relief_rays(source, experiment_viewer(40, 64)), 64, [&](const ReliefRay& ray) {
                const auto exact = find_by_texels(solid, ray);
                const auto sliced = find_by_slices(solid, ray, {4000, 0});
                hits += exact.has_value();
                // what is thinner than a slice may be missed by slices, never the other way round
                if (sliced) {
                    ASSERT_TRUE(exact);
                    ASSERT_LE(exact->z, sliced->z + 1e-12);
                }
                differ += exact && (!sliced || sliced->z - exact->z > slice * 1.01);
            });
            EXPECT_GT(hits, 500);
            EXPECT_LT(differ, hits / 100);
        }
    }
}

TEST(InverseTexels, VisitsEveryTexelUnderTheRayOnce) {
    struct Visits {
        std::vector<glm::ivec2> texels;
        void on(const SolidLookedUp& look) { texels.emplace_back(int(look.place.x), int(look.place.y)); }
    };
    ReliefTexture texture = make_relief_texture(experiment_source(32));
    texture.coverage.at(0, 0) = 1;  // the rest is empty
    ReliefSolid solid = extruded_solid(texture);
    solid.low = 0, solid.high = 2;
    const ReliefRay ray{{3.25, 20.75}, {10, -7.5}};
    Visits visits;
    EXPECT_FALSE(find_by_texels(solid, ray, visits));
    // from u = 3.25 to 23.25 and from v = 20.75 to 5.75: 20 borders of columns and 15 of rows
    EXPECT_EQ(visits.texels.size(), 36u);
}

TEST(InverseSlices, TheErrorIsOneOverNAndBisectionsHalveIt) {
    const ReliefCamera source = experiment_source(), viewer = experiment_viewer(0, 128);
    const ReliefTexture texture = ray_cast(scene::sphere_object, source);
    ReliefSolid solid = extruded_solid(texture);
    solid.reading = Reading::Bilinear;
    const ViewImage truth = ray_cast_view(scene::sphere_object, viewer);
    const auto depth_error = [&](int slices, int bisections) {
        return error_set(*inverse_view(texture, solid, viewer,
                                       [&](const ReliefRay& ray) {
                                           return find_by_slices(solid, ray, {slices, bisections});
                                       }),
                         truth)
            .mean_depth_error;
    };
    std::vector<double> error;
    for (int n = 8; n <= 256; n *= 2) {
        error.push_back(depth_error(n, 0));
        std::printf("%d slices: mean depth error %.5f\n", n, error.back());
        EXPECT_NEAR(error.back(), 0.5 * (solid.high - solid.low) / n, 0.05 / n);
        if (n > 8) {
            EXPECT_NEAR(error[error.size() - 2] / error.back(), 2, 0.1);
        }
    }
    const double refined = depth_error(32, 8);
    std::printf("32 slices and 8 bisections: %.5f\n", refined);
    EXPECT_LT(refined, error.back() / 10);
}

// The thesis's tables 6.1 and 6.2 as laws: what slices cost grows as N and their error falls as 1/N; 32 of
// them with 8 bisections cost less than a third of 256 and are more exact.
TEST(InverseSlices, CostTimesErrorIsConstantAndBisectionsBreakTheLaw) {
    for (const tests::SliceWork& work : tests::slice_works()) {
        std::vector<double> looks, error;
        for (int n = 8; n <= 256; n *= 2) {
            looks.push_back(double(look_ups(work, {n, 0})) / double(work.rays.size()));
            error.push_back(slice_error(work, {n, 0}));
            std::printf("%s, %d slices: %.1f look-ups a ray, depth error %.5f\n", work.name, n, looks.back(),
                        error.back());
        }
        for (std::size_t i = 1; i < error.size(); ++i)
            EXPECT_NEAR(error[i - 1] / error[i], 2, 0.15) << work.name << ' ' << i;
        for (std::size_t i = 2; i < looks.size(); ++i)  // each slice more costs the same
            EXPECT_NEAR((looks[i] - looks[i - 1]) / (looks[i - 1] - looks[i - 2]), 2, 0.1)
                << work.name << ' ' << i;
        const double fewer = double(look_ups(work, {32, 8})) / double(work.rays.size()),
                     finer = slice_error(work, {32, 8});
        std::printf("%s, 32 slices and 8 bisections: %.1f look-ups a ray, depth error %.5f\n", work.name,
                    fewer, finer);
        EXPECT_LE(fewer, looks.back() / 3) << work.name;
        EXPECT_LE(finer, error.back()) << work.name;
    }
}

TEST(InverseSlices, LookAtNoMoreThanTheySay) {
    struct Counter {
        int looks = 0;
        void on(const SolidLookedUp&) { ++looks; }
    };
    const ReliefTexture texture = ray_cast(scene::sphere_object, experiment_source(64));
    const ReliefSolid solid = extruded_solid(texture);
    const ReliefRay straight{{32.5, 31.5}, {0, 0}}, beside{{0.5, 0.5}, {0, 0}}, out{{-3, 5}, {0, 0}};
    Counter hit, miss, none;
    EXPECT_TRUE(find_by_slices(solid, straight, {100, 5}, hit));
    EXPECT_LE(hit.looks, 8);  // the top of the ball is the nearest point
    EXPECT_FALSE(find_by_slices(solid, beside, {100, 5}, miss));
    EXPECT_EQ(miss.looks, 101);
    EXPECT_FALSE(find_by_slices(solid, out, {100, 5}, none));
    EXPECT_EQ(none.looks, 0);
}

TEST(InverseSlices, FlatReliefsAndEmptyOnesAreFine) {
    ReliefTexture texture = make_relief_texture(experiment_source(8));
    const ReliefRay ray{{4.5, 4.5}, {0.5, 0}};
    EXPECT_FALSE(find_by_slices(extruded_solid(texture), ray, {8, 0}));
    EXPECT_FALSE(find_by_texels(extruded_solid(texture), ray));
    for (std::uint8_t& c : texture.coverage.pixels()) c = 1;
    EXPECT_EQ(find_by_slices(extruded_solid(texture), ray, {8, 3})->z, 0);
    EXPECT_EQ(find_by_texels(extruded_solid(texture), ray)->z, 0);
}

// ---------------------------------------------------------------------------------------------- pictures
// PSNR, dB, of 128 slices with nearest and with bilinear reading. `required` is to be reached within 0.1 dB
// by nearest texels; where no thickness ends them, the slices go on to depth 2, twice the radius.
TEST(InverseView, TheImageExperiment) {
    struct Row {
        const char* name;
        const Spheres* object;
        double azimuth, thickness, required, bilinear;
    };
    constexpr double none = 0;
    const Row rows[] = {{"sphere", &scene::sphere_object, 0, none, 26.40, 44},
                        {"sphere", &scene::sphere_object, 25, none, 16.16, 16.4},
                        {"sphere", &scene::sphere_object, 25, 0.1, 24.9, 27.3},
                        {"sphere", &scene::sphere_object, 40, none, 10.89, 10.9},
                        {"sphere", &scene::sphere_object, 40, 0.2, 19.9, 20.2},
                        {"bumpy", &scene::bumpy_object, 10, none, 24.89, 27.7},
                        {"bumpy", &scene::bumpy_object, 25, none, 13.94, 14.0},
                        {"complex", &scene::complex_object, 0, none, 12.29, 12.35},
                        {"complex", &scene::complex_object, 25, none, 9.03, 8.95},
                        {"complex", &scene::complex_object, 25, 0.1, 12.6, 12.9}};
    for (const auto& [name, object, azimuth, thickness, required, bilinear] : rows) {
        const ReliefTexture texture = ray_cast(*object, experiment_source());
        const ReliefCamera viewer = experiment_viewer(azimuth);
        ReliefSolid solid = thickness > 0 ? solid_of_thickness(texture, thickness) : extruded_solid(texture);
        if (thickness == none) solid.low = 0, solid.high = 2;
        const ViewImage truth = ray_cast_view(*object, viewer);
        double psnr[2];
        for (const Reading reading : {Reading::Nearest, Reading::Bilinear}) {
            solid.reading = reading;
            const ViewImage image = *inverse_view(texture, solid, viewer, [&](const ReliefRay& ray) {
                return find_by_slices(solid, ray, {128, 0});
            });
            psnr[reading == Reading::Bilinear] = error_set(image, truth).psnr;
        }
        std::printf("%-8s %2.0f degrees, thickness %.1f: %.2f dB nearest (%.2f), %.2f bilinear\n", name,
                    azimuth, thickness, psnr[0], required, psnr[1]);
        EXPECT_GE(psnr[0], required - 0.1);
        EXPECT_GE(psnr[1], bilinear);
    }
}

TEST(InverseView, ABackLayerIsBetterThanAThickness) {
    const ReliefCamera source = experiment_source(128);
    const ReliefCamera viewer = experiment_viewer(40, 256);
    const ReliefTexture texture = ray_cast(scene::bumpy_object, source);
    const ReliefTexture back = ray_cast(scene::bumpy_object, opposite_camera(source, 2));
    const ViewImage truth = ray_cast_view(scene::bumpy_object, viewer);
    const auto error = [&](ReliefSolid solid) {
        solid.reading = Reading::Bilinear;
        return error_set(*inverse_view(texture, solid, viewer,
                                       [&](const ReliefRay& ray) {
                                           return find_by_slices(solid, ray, {64, 6});
                                       }),
                         truth);
    };
    const ErrorSet thick = error(solid_of_thickness(texture, 0.2)),
                   between = error(solid_between(texture, back));
    std::printf("bumpy 40: thickness 0.2 misses %.2f %%, adds %.2f; back layer %.2f, %.2f\n",
                thick.missing_percent, thick.extra_percent, between.missing_percent, between.extra_percent);
    EXPECT_LT(between.missing_percent, 0.5);
    EXPECT_LT(between.extra_percent, 0.5);
    EXPECT_GT(between.psnr, thick.psnr + 1);
}

TEST(InverseView, AnOpenSurfaceIsASheet) {
    // The step's plates have no back of their own: the opposite camera sees the same plates.
    const ReliefCamera source = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 128, 128}, {0, 0, 0.5}, 2);
    const glm::dvec3 eye(-1.2, 0.4, 3);
    const ReliefCamera viewer = *perspective_camera({-eye, {0, 1, 0}, 128, 128}, eye, 1, {45});
    const PlaneStep plates{0.5};
    const ReliefTexture texture = ray_cast(plates, source),
                        back = ray_cast(plates, opposite_camera(source, 1));
    const ViewImage truth = ray_cast_view(plates, viewer);
    const auto missing = [&](ReliefSolid solid) {
        solid.reading = Reading::Bilinear;
        const auto find = [&](const ReliefRay& ray) { return find_by_slices(solid, ray, {64, 6}); };
        return error_set(*inverse_view(texture, solid, viewer, find), truth).missing_percent;
    };
    EXPECT_GT(missing(solid_between(texture, back)), 20);
    EXPECT_LT(missing(solid_between(texture, back, 0.1)), 10);  // what lies between the plates
    EXPECT_LT(missing(extruded_solid(texture)),
              0.5);  // the deepest plate is hit although nothing lies behind
    // A body has its back: its outline, too, stays as it is.
    const ReliefTexture ball = ray_cast(scene::sphere_object, experiment_source(64)),
                        behind = ray_cast(scene::sphere_object, opposite_camera(experiment_source(64), 2));
    EXPECT_EQ(solid_between(ball, behind, 0.1).back.pixels(), solid_between(ball, behind).back.pixels());
}

TEST(InverseView, APerspectiveSourceSeenFromItsOwnEyeIsItself) {
    const ReliefCamera source = perspective_source();
    const ReliefTexture texture = ray_cast(scene::complex_object, source);
    const ReliefSolid solid = extruded_solid(texture);
    const ViewImage image = *inverse_view(texture, solid, source,
                                          [&](const ReliefRay& ray) { return find_by_texels(solid, ray); });
    const ErrorSet error = error_set(image, as_seen(texture));
    EXPECT_EQ(error.missing_percent, 0);
    EXPECT_EQ(error.extra_percent, 0);
    EXPECT_TRUE(std::isinf(error.psnr));
    EXPECT_LT(error.mean_depth_error, 1e-6);
}

}  // namespace
}  // namespace relevo::relief
