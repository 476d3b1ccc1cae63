#include "relief/depth_images.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "relief/box.hpp"
#include "relief/error_set.hpp"
#include "samples/scene/shapes/spheres.hpp"

namespace relevo::relief {
namespace {

// A bowl: the shell between the balls of radius 1 and 0.9 round the origin, below the plane dot(p, open) =
// 0.3.
struct Bowl {
    glm::dvec3 open;  // of length 1
};
std::optional<SurfaceHit> first_hit(const Bowl& bowl, const Ray& ray) {
    constexpr double rim = 0.3;
    std::optional<SurfaceHit> nearest;
    for (const double radius : {1.0, 0.9}) {
        Ray rest = ray;
        for (int i = 0; i < 2; ++i) {  // where the ray goes in and out
            const auto t = first_hit(Sphere{{0, 0, 0}, radius}, rest);
            if (!t) break;
            const glm::dvec3 p = ray.origin + *t * ray.direction;
            if (glm::dot(p, bowl.open) <= rim)
                keep_nearest(nearest, {*t, (radius == 1 ? 1.0 : -1.0) / radius * p, wave_color(p)}, ray);
            rest.from = *t + 1e-9;
        }
    }
    const double t = (rim - glm::dot(ray.origin, bowl.open)) / glm::dot(ray.direction, bowl.open);
    const glm::dvec3 p = ray.origin + t * ray.direction;
    const double square = glm::dot(p, p);
    if (square <= 1 && square >= 0.81) keep_nearest(nearest, {t, bowl.open, wave_color(p)}, ray);
    return nearest;
}

ReliefCamera viewer_from(const glm::dvec3& direction, int size = 160) {
    const glm::dvec3 eye = 3.2 * glm::normalize(direction);
    return *perspective_camera({-eye, {0, 1, 0}, size, size}, eye, 1, {45});
}

std::vector<glm::dvec3> corners() {
    std::vector<glm::dvec3> all;
    for (const auto& [x, y, z] : corner_directions) all.emplace_back(x, y, z);
    return all;
}

const Ball unit_ball{{0, 0, 0}, 1};

TEST(DepthImages, TheirPlanesTouchTheBallAndHoldIt) {
    const Ball ball{{1, 2, 3}, 0.5};
    for (const glm::dvec3& direction :
         {glm::dvec3(1, 2, 3), glm::dvec3(0, 4, 0), glm::dvec3(0, -1, 0), glm::dvec3(-1, 0, 0.1)}) {
        const ReliefCamera camera = *camera_from(ball, direction, 40);
        EXPECT_LT(glm::length(forward(camera) + glm::normalize(direction)), 1e-12);
        EXPECT_NEAR(glm::dot(ball.centre - camera.corner, forward(camera)), 0.5, 1e-12);
        EXPECT_LT(glm::length(plane_point(camera, 20, 20) - (ball.centre + 0.5 * glm::normalize(direction))),
                  1e-12);
        EXPECT_NEAR(40 * glm::length(camera.a), 1, 1e-12);
    }
    EXPECT_FALSE(camera_from(ball, {0, 0, 0}, 40));
    EXPECT_FALSE(camera_from(ball, {0, std::nan(""), 0}, 40));
    EXPECT_FALSE(camera_from(ball, {0, 0, 1}, 0));
}

TEST(DepthImages, EachPixelSaysWhichImageItCameFrom) {
    const auto images = *capture_depth_images(RayCapture{scene::sphere_object}, unit_ball, corners(), 64);
    for (std::size_t i = 0; i < 8; ++i) {
        const ViewImage seen = draw_depth_images(images, viewer_from(corners()[i], 64));
        EXPECT_EQ(seen.coverage.at(32, 32), 1 + i);
        std::set<int> labels(seen.coverage.pixels().begin(), seen.coverage.pixels().end());
        EXPECT_GT(labels.size(), 3u);
    }
}

TEST(DepthImages, OfATiltedBowlEightMissLessThanTheSixFacesOfABox) {
    const Bowl bowl{glm::normalize(glm::dvec3(1, 1.2, 0.9))};
    constexpr int texels = 160;
    const auto images = *capture_depth_images(RayCapture{bowl}, unit_ball, corners(), texels);
    const BoxRelief box = *capture_box(RayCapture{bowl}, {{-1, -1, -1}, {1, 1, 1}}, texels);
    double missing8 = 0, missing6 = 0, extra8 = 0, worst8 = 0, worst6 = 0;
    int views = 0;
    for (const glm::dvec3& direction :
         {glm::dvec3(1, 1, 0.2), glm::dvec3(0.3, 1, 1), glm::dvec3(1, 0.4, 1), glm::dvec3(1, 1, 1),
          glm::dvec3(0.7, 1, 0.1), glm::dvec3(-1, 1, 0.5), glm::dvec3(1, -0.5, -0.3)}) {
        const ReliefCamera viewer = viewer_from(direction);
        const ViewImage truth = ray_cast_view(bowl, viewer);
        const ErrorSet by8 = error_set(draw_depth_images(images, viewer), truth),
                       by6 = error_set(draw_box(box, viewer), truth);
        missing8 += by8.missing_percent, missing6 += by6.missing_percent, extra8 += by8.extra_percent,
            ++views;
        worst8 = std::max(worst8, by8.missing_percent), worst6 = std::max(worst6, by6.missing_percent);
    }
    std::printf(
        "a tilted bowl from %d sides, missing: eight depth images %.2f %% (at most %.2f), six faces %.2f %% "
        "(at most %.2f)\n",
        views, missing8 / views, worst8, missing6 / views, worst6);
    EXPECT_LT(missing8, missing6 / 3);
    EXPECT_LT(missing8 / views, 5.5);
    EXPECT_LT(worst8, 9);  // the inside below the rim, which leans inwards: no picture sees it whole
    EXPECT_LT(extra8 / views, 2);
}

}  // namespace
}  // namespace relevo::relief
