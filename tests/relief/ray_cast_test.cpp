#include "relief/ray_cast.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "relief/surface_checker_cube.hpp"
#include "relief/surface_plane_step.hpp"
#include "samples/scene/shapes/spheres.hpp"

namespace relevo::relief {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

ReliefCamera front_camera(int size) {  // the plane touches the ball of radius 1 round the origin
    return *orthographic_camera({{0, 0, -1}, {0, 1, 0}, size, size}, {0, 0, 1}, 2);
}
ReliefCamera viewer(int size, double distance = 3.2) {
    return *perspective_camera({{0, 0, -1}, {0, 1, 0}, size, size}, {0, 0, distance}, 1, {45});
}

// ---------------------------------------------------------------------------------------------- spheres
TEST(SurfaceSpheres, TheDisplacementOfABallIsItsEquation) {
    const ReliefTexture texture = ray_cast(scene::sphere_object, front_camera(64));
    int covered = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const double px = (x + 0.5) / 32 - 1, py = 1 - (y + 0.5) / 32, rest = 1 - px * px - py * py;
            ASSERT_EQ(texture.coverage.at(x, y), rest >= 0) << x << ' ' << y;
            if (rest < 0) continue;
            ++covered;
            const glm::dvec3 p(px, py, std::sqrt(rest));
            EXPECT_NEAR(texture.depth.at(x, y), 1 - p.z, 1e-7);
            const Vec3 n = texture.normal.at(x, y);
            EXPECT_LT(glm::length(glm::dvec3(n) - p), 2e-7);
            EXPECT_NEAR(texture.color.at(x, y).g, 0.5 + 0.5 * std::sin(9 * p.y + 2 * p.z), 1e-6);
            EXPECT_NEAR(texture.color.at(x, y).b, 0.5 + 0.5 * std::sin(9 * p.z + 3 * p.x), 1e-6);
        }
    EXPECT_NEAR(covered, pipeline::pi / 4 * 64 * 64, 30);
}

TEST(SurfaceSpheres, ARayMayStartFarAwayInsideOrBehind) {
    const Spheres one{{{{0, 0, 0}, 1}}};
    EXPECT_NEAR(first_hit(one, {{0.5, 0, 1e6}, {0, 0, -1}})->t, 1e6 - std::sqrt(0.75), 1e-9);
    EXPECT_DOUBLE_EQ(first_hit(one, {{0, 0, 0}, {0, 0, -2}})->t, 0.5);
    EXPECT_FALSE(first_hit(one, {{0, 0, -2}, {0, 0, -1}}));
    EXPECT_EQ(first_hit(one, {{0, 0, 2}, {0, 0, -1}, 1.5})->t, 3);  // from inside: where it leaves
    EXPECT_TRUE(first_hit(one, {{1, 0, 2}, {0, 0, -1}}));           // touches
    EXPECT_FALSE(first_hit(one, {{1 + 1e-9, 0, 2}, {0, 0, -1}}));
}

TEST(SurfaceSpheres, TheNearestOfManyIsSeen) {
    for (const Spheres* object : {&scene::bumpy_object, &scene::complex_object}) {
        const ReliefTexture texture = ray_cast(*object, front_camera(48));
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x) {  // the other way: the highest of all balls over the texel
                const double px = (x + 0.5) / 24 - 1, py = 1 - (y + 0.5) / 24;
                double highest = -infinity;
                for (const auto& [c, r] : object->sphere) {
                    const double rest = r * r - (px - c.x) * (px - c.x) - (py - c.y) * (py - c.y);
                    if (rest >= 0) highest = std::max(highest, c.z + std::sqrt(rest));
                }
                ASSERT_EQ(texture.coverage.at(x, y) == 1, highest > -infinity);
                if (texture.coverage.at(x, y)) {
                    EXPECT_NEAR(texture.depth.at(x, y), 1 - highest, 1e-6);
                    EXPECT_NEAR(glm::length(glm::dvec3(texture.normal.at(x, y))), 1, 1e-6);
                }
            }
    }
}

// ---------------------------------------------------------------------------------------------- plane, cube
TEST(SurfacePlaneStep, HasTwoPlatesAndARiser) {
    const PlaneStep plane{0.5};
    const auto down = [&](double x, double y) { return first_hit(plane, {{x, y, 3}, {0, 0, -1}}); };
    EXPECT_EQ(down(0, 0)->t, 3);
    EXPECT_EQ(down(0.1, 0)->t, 3);
    EXPECT_EQ(down(0.2, 0)->t, 2.5);
    EXPECT_EQ(down(-1, 1)->t, 3);
    EXPECT_FALSE(down(1.001, 0));
    EXPECT_FALSE(down(0, -1.001));
    const auto riser = first_hit(plane, {{-1, 0.3, 0.25}, {1, 0, 0}});
    ASSERT_TRUE(riser);
    EXPECT_DOUBLE_EQ(riser->t, 1.1);
    EXPECT_EQ(riser->normal, glm::dvec3(-1, 0, 0));
    EXPECT_FALSE(first_hit(plane, {{-1, 0.3, 0.75}, {1, 0, 0}}));
}

TEST(SurfacePlaneStep, ItsLinesRunStraightAcrossTheStep) {
    const auto is_red = [](LinearRgb c) { return c.r > 4 * c.g; };
    for (const double x : {-0.9, -0.3, 0.09, 0.11, 0.7})
        for (const double y : {-0.5, 0.0, 0.5}) {
            for (const double line : {y, x / 2 + 0.25, x / 2 - 0.25}) {
                const auto at = [&](double off) {
                    return first_hit(PlaneStep{1}, {{x, line + off, 3}, {0, 0, -1}})->color;
                };
                EXPECT_TRUE(is_red(at(0)) && is_red(at(0.015)) && is_red(at(-0.015)));
            }
            EXPECT_FALSE(is_red(first_hit(PlaneStep{1}, {{-0.3, y + 0.017, 3}, {0, 0, -1}})->color));
        }
    const auto color = [](double x, double y) {
        return first_hit(PlaneStep{1}, {{x, y, 3}, {0, 0, -1}})->color;
    };
    EXPECT_FALSE(color(-0.06, 0.06) == color(-0.19, 0.06));  // neighbours of the checkered plane
    EXPECT_TRUE(color(-0.06, 0.06) == color(-0.31, 0.06));
}

TEST(SurfaceCheckerCube, IsTurnedByThirtyDegrees) {
    const CheckerCube cube;
    const glm::dmat3& m = cube.world_from_cube;
    EXPECT_NEAR(glm::determinant(m), 1, 1e-15);
    EXPECT_NEAR(m[0][0] + m[1][1] + m[2][2], 1 + 2 * std::cos(pipeline::pi / 6),
                1e-15);  // the trace: its angle
    const glm::dvec3 axis(std::sqrt(0.5), std::sqrt(0.5), 0);
    EXPECT_LT(glm::length(m * axis - axis), 1e-15);
    EXPECT_GT((m * glm::dvec3(1, -1, 0)).z, -1);
    EXPECT_LT((m * glm::dvec3(0, 0, 1)).y, 0.5);
    EXPECT_GT(glm::dot(glm::cross(glm::dvec3(0, 0, 1), m * glm::dvec3(0, 0, 1)), axis), 0);  // right-handed
    // From any side the points lie on the cube, and their normals look at the ray.
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 from(3 * std::cos(i), 3 * std::sin(i) * std::cos(2.7 * i), 3 * std::sin(2.7 * i));
        const auto hit = first_hit(cube, {from, -from});
        ASSERT_TRUE(hit);
        const glm::dvec3 p = glm::transpose(m) * (from - hit->t * from);
        EXPECT_NEAR(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}), 0.55, 1e-12);
        EXPECT_LT(glm::dot(hit->normal, -from), 0);
        EXPECT_LT(hit->t, 1);
    }
    EXPECT_FALSE(first_hit(cube, {{2, 0, 0}, {0, 1, 0}}));
}

// ---------------------------------------------------------------------------------------------- both cameras
TEST(RayCast, WhatTouchesThePlaneIsSeenAndWhatLiesBeforeItIsNot) {
    const auto camera = [](double z) {
        return *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 16, 16}, {0, 0, z}, 2);
    };
    const ReliefTexture on = ray_cast(PlaneStep{0.5}, camera(0.5));
    EXPECT_EQ(on.depth.at(12, 7), 0);
    EXPECT_EQ(on.depth.at(3, 7), Scalar(0.5));
    EXPECT_EQ(ray_cast(PlaneStep{0.5}, camera(0.5 - 1e-12)).coverage.at(12, 7), 1);
    EXPECT_FALSE(refusal(on));
    const ReliefTexture cut = ray_cast(PlaneStep{0.5}, camera(0.25));
    EXPECT_EQ(cut.coverage.at(12, 7), 0);
    EXPECT_EQ(cut.coverage.at(3, 7), 1);
    EXPECT_FALSE(refusal(cut));
    const ReliefTexture through = ray_cast(
        scene::sphere_object, *perspective_camera({{0, 0, -1}, {0, 1, 0}, 17, 17}, {0, 0, 3}, 3, {30}));
    EXPECT_FALSE(refusal(through));
    EXPECT_NEAR(through.depth.at(8, 8), 3.0 / 4, 1e-7);  // the far side of the ball that the plane cuts
}

TEST(RayCast, BothCamerasSeePointsOfTheSurface) {
    const ReliefCamera cameras[] = {front_camera(40), *perspective_camera({{-1, -0.5, -2}, {0, 1, 0}, 40, 40},
                                                                          {1.5, 0.75, 3}, 1.5, {40})};
    for (const ReliefCamera& camera : cameras) {
        const ReliefTexture texture = ray_cast(scene::bumpy_object, camera);
        EXPECT_FALSE(refusal(texture));
        int covered = 0;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x) {
                if (!texture.coverage.at(x, y)) continue;
                ++covered;
                const glm::dvec3 p = world_point(texture, x, y);
                double off = infinity;
                for (const auto& [c, r] : scene::bumpy_object.sphere)
                    off = std::min(off, std::fabs(glm::length(p - c) - r));
                EXPECT_LT(off, 2e-6);
            }
        EXPECT_GT(covered, 500);
    }
}

TEST(RayCast, TheViewersDepthIsMeasuredAlongItsAxis) {
    for (const double distance : {0.5, 1.0, 2.0}) {
        const auto screen = *perspective_camera({{0, 0, -1}, {0, 1, 0}, 33, 33}, {0, 0, 3}, distance, {90});
        const ViewImage image = ray_cast_view(PlaneStep{0.5}, screen);
        EXPECT_NEAR(image.depth.at(16, 16), 3, 1e-6);
        EXPECT_NEAR(image.depth.at(12, 12), 3, 1e-6);
        EXPECT_NEAR(image.depth.at(18, 16), 2.5, 1e-6);
        EXPECT_EQ(image.coverage.at(2, 16), 0);
    }
}

TEST(RayCast, SixteenSamplesAreTheMeanOfSixteenPictures) {
    const ViewImage fine = ray_cast_view(scene::complex_object, viewer(4 * 24));
    const ViewImage coarse = ray_cast_view(scene::complex_object, viewer(24), 4);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            int hits = 0;
            double red = 0;
            for (int k = 0; k < 16; ++k)
                if (fine.coverage.at(4 * x + k % 4, 4 * y + k / 4))
                    ++hits, red += fine.color.at(4 * x + k % 4, 4 * y + k / 4).r;
            ASSERT_EQ(coarse.coverage.at(x, y), hits >= 8);
            if (hits >= 8) {
                EXPECT_NEAR(coarse.color.at(x, y).r, red / hits, 1e-6);
            }
        }
}

TEST(RayCast, NonsenseHitsNothing) {
    const Ray nonsense[] = {{{nan, 0, 3}, {0, 0, -1}},      {{0, 0, 3}, {0, 0, 0}},
                            {{0, 0, 3}, {0, nan, -1}},      {{0, infinity, 3}, {0, 0, -1}},
                            {{0, 0, 3}, {0, 0, -infinity}}, {{2, 2, 2}, {0, 0, 0}}};
    for (const Ray& ray : nonsense) {
        EXPECT_FALSE(first_hit(scene::bumpy_object, ray));
        EXPECT_FALSE(first_hit(CheckerCube{}, ray));
        EXPECT_FALSE(first_hit(PlaneStep{}, ray));
    }
}

}  // namespace
}  // namespace relevo::relief
