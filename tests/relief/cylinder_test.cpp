// Panoramas on a cylinder, with and without parallax.
#include "relief/cylinder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "relief/error_set.hpp"
#include "relief/surface_room.hpp"
#include "tests/support/hard.hpp"

namespace relevo::relief {
namespace {

constexpr double pi = 3.14159265358979323846;

CylinderCamera camera(int width = 1024) {
    CylinderCamera c;
    c.low = -0.8, c.high = 0.8;
    c.width = width, c.height = int(std::lround(width * 1.6 / (2 * pi)));
    return c;
}
ReliefCamera looking(const glm::dvec3& eye, double degrees, int size = 192) {
    const double a = degrees * pi / 180;
    return *perspective_camera({{std::sin(a), 0, -std::cos(a)}, {0, 1, 0}, size, size * 3 / 4}, eye, 0.01,
                               {45});
}

// ---------------------------------------------------------------------------------------- surface
TEST(Room, AllRaysFromInsideHitItAndLieOnIt) {
    const Room room;
    tests::hard::Random r(1);
    int walls = 0, balls = 0;
    for (int i = 0; i < 5000; ++i) {
        const Ray ray{{r.between(-0.3, 0.3), r.between(-0.3, 0.3), r.between(-0.3, 0.3)},
                      {r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)}};
        const auto hit = first_hit(room, ray);
        ASSERT_TRUE(hit);
        EXPECT_LT(glm::dot(hit->normal, ray.direction), 0);
        EXPECT_NEAR(glm::length(hit->normal), 1, 1e-12);
        const glm::dvec3 p = ray.origin + hit->t * ray.direction, near = glm::abs(glm::abs(p) - room.half);
        const bool on_wall = std::min({near.x, near.y, near.z}) < 1e-12;
        double ball = 1;
        for (const Sphere& s : room.balls.sphere)
            ball = std::min(ball, std::fabs(glm::length(p - s.centre) - s.radius));
        EXPECT_TRUE(on_wall || ball < 1e-12);
        (on_wall ? walls : balls) += 1;
    }
    EXPECT_GT(walls, 3000);
    EXPECT_GT(balls, 250);
}

// ---------------------------------------------------------------------------------------- geometry
TEST(Cylinder, ItsPointsAreMetWhereTheyAre) {
    CylinderCamera c = camera(360);
    c.centre = {0.3, -0.2, 0.1}, c.ahead = {0.6, 0, 0.8}, c.radius = 0.7;
    tests::hard::Random r(2);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 viewer =
            c.centre + glm::dvec3(r.between(-0.4, 0.4), r.between(-1, 1), r.between(-0.4, 0.4));
        const CylinderSight sight(c, viewer);
        ASSERT_TRUE(sight.inside());
        const double u = r.between(0, 360), v = r.between(-50, 150), size = r.between(0.1, 5);
        const auto met = sight.meets(size * (cylinder_point(c, u, v) - viewer));
        ASSERT_TRUE(met);
        EXPECT_NEAR(std::remainder(met->u - u, 360), 0, 1e-9);
        EXPECT_NEAR(met->v, v, 1e-9);
        EXPECT_NEAR(met->t * size, 1, 1e-12);
    }
    EXPECT_FALSE(CylinderSight(c, c.centre).meets({0, 1, 0}));
    EXPECT_FALSE(CylinderSight(c, c.centre + glm::dvec3(0.8, 0, 0)).inside());
    // To the right of `ahead` as seen from inside.
    EXPECT_LT(glm::length(cylinder_point(camera(400), 100, 0) - glm::dvec3(1, 0.8, 0)), 1e-12);
}

TEST(Cylinder, TexelsKnowTheirPointsOfTheRoom) {
    const CylinderRelief relief = *capture_cylinder(Room{}, camera(200));
    for (int y = 0; y < relief.camera.height; ++y)
        for (int x = 0; x < 200; ++x) {
            ASSERT_TRUE(relief.coverage.at(x, y));
            const glm::dvec3 p = world_point(relief, x, y);
            const auto again = first_hit(Room{}, Ray{relief.camera.centre, p - relief.camera.centre});
            EXPECT_NEAR(again->t, 1, 1e-6);
        }
}

// ---------------------------------------------------------------------------------------- at the axis
TEST(Cylinder, SeenFromItsCentreItIsTheSourceToTheBit) {
    const CylinderRelief relief = *capture_cylinder(Room{}, camera(600));
    for (const glm::dvec3& viewer : {glm::dvec3(0), relief.camera.centre}) {
        const ViewImage warped = *warp_cylinder(relief, viewer);
        EXPECT_TRUE(warped.color.pixels() == relief.color.pixels());
        EXPECT_TRUE(warped.coverage.pixels() == relief.coverage.pixels());
    }
    const ViewImage warped = *warp_cylinder(relief, relief.camera.centre);
    const ReliefCamera viewer = looking(relief.camera.centre, 130, 200);
    const ViewImage seen = look_at_cylinder(relief.camera, warped, viewer, Reading::Nearest);
    for (int y = 0; y < seen.height(); ++y)
        for (int x = 0; x < seen.width(); ++x) {
            const glm::dvec3 d = plane_point(viewer, x + 0.5, y + 0.5) - viewer.eye;
            const double turn = std::atan2(d.x, -d.z) / (2 * pi), up = d.y / std::sqrt(d.x * d.x + d.z * d.z);
            const int i = int(std::floor((turn < 0 ? turn + 1 : turn) * 600)),
                      j = int(std::floor((0.8 - up) / 1.6 * relief.camera.height));
            ASSERT_TRUE(seen.coverage.at(x, y));
            EXPECT_EQ(seen.color.at(x, y), relief.color.at(i, j));
        }
}

TEST(Cylinder, HasNoSeam) {
    // Nothing differs where the picture's ends meet: another beginning gives the same view.
    CylinderCamera turned = camera(720);
    turned.ahead = {0, 0, 1};
    const CylinderRelief at_back = *capture_cylinder(Room{}, camera(720)),
                         at_front = *capture_cylinder(Room{}, turned);
    const glm::dvec3 eye(0.2, 0.05, 0.1);
    for (const double degrees : {0.0, 180.0}) {
        const ReliefCamera viewer = looking(eye, degrees, 128);
        const auto view = [&](const CylinderRelief& relief) {
            return look_at_cylinder(relief.camera, *warp_cylinder(relief, eye), viewer);
        };
        const ErrorSet error = error_set(view(at_back), view(at_front));
        EXPECT_EQ(error.missing_percent, 0);
        EXPECT_EQ(error.extra_percent, 0);
        EXPECT_LT(error.bad_percent, 0.1);
        EXPECT_GT(error.psnr, 45);
    }
}

// ---------------------------------------------------------------------------------------- off the axis
TEST(Cylinder, OffTheAxisParallaxIsRight) {
    const Room room;
    const CylinderRelief relief = *capture_cylinder(room, camera());
    const ViewImage flat = unwarped(relief);
    struct Row {
        double off, most_bad, most_missing, least_psnr, worse_without;
    };
    for (const auto& [off, most_bad, most_missing, least_psnr, worse_without] :
         {Row{0, 7, 0.01, 22, 0.9}, Row{0.1, 11.1, 0.8, 18, 1.25}, Row{0.2, 11.6, 1.5, 17, 2},
          Row{0.4, 14.1, 3.6, 13.5, 2.9}}) {
        ErrorSet with, without;
        with.psnr = without.psnr = 1e9;
        for (const double direction : {30.0, 210.0}) {
            const double a = direction * pi / 180;
            const glm::dvec3 eye = off * glm::dvec3(std::sin(a), 0, -std::cos(a));
            const ViewImage warped = *warp_cylinder(relief, eye);
            for (const double degrees : {0.0, 90.0, 180.0, 270.0}) {
                const ReliefCamera viewer = looking(eye, degrees);
                const ViewImage truth = ray_cast_view(room, viewer);
                const auto add = [&](ErrorSet& sum, const ViewImage& picture) {
                    const ErrorSet e = error_set(look_at_cylinder(relief.camera, picture, viewer), truth);
                    sum.missing_percent += e.missing_percent / 8, sum.bad_percent += e.bad_percent / 8;
                    sum.mean_depth_error += e.mean_depth_error / 8, sum.psnr = std::min(sum.psnr, e.psnr);
                };
                add(with, warped), add(without, flat);
            }
        }
        std::printf(
            "room, %.1f off the axis: with parallax bad %.2f %%, missing %.2f %%, PSNR >= %.2f dB, depth "
            "%.4f; "
            "without bad %.2f %%, missing %.2f, PSNR >= %.2f, depth %.3f\n",
            off, with.bad_percent, with.missing_percent, with.psnr, with.mean_depth_error,
            without.bad_percent, without.missing_percent, without.psnr, without.mean_depth_error);
        EXPECT_LT(with.bad_percent, most_bad);
        EXPECT_LT(with.missing_percent, most_missing);
        EXPECT_GT(with.psnr, least_psnr);
        EXPECT_LT(with.mean_depth_error, 0.01);
        EXPECT_GT(without.bad_percent, worse_without * with.bad_percent);
        EXPECT_GT(without.mean_depth_error, 0.1);
    }
}

TEST(Cylinder, WhereNothingIsNothingIsSeen) {
    const Spheres two{{{{0, 0, -2}, 0.3}, {{0, 0, 2}, 0.3}}};  // one before, across the seam, one behind
    const CylinderRelief relief = *capture_cylinder(two, camera(512));
    EXPECT_TRUE(relief.coverage.at(0, 65) && relief.coverage.at(511, 65) && relief.coverage.at(256, 65));
    EXPECT_FALSE(relief.coverage.at(128, 65) || relief.coverage.at(384, 65));
    const glm::dvec3 eye(0.3, 0, 0.1);
    const ViewImage warped = *warp_cylinder(relief, eye);
    for (const double degrees : {-10.0, 190.0}) {
        const ReliefCamera viewer = looking(eye, degrees);
        const ErrorSet error =
            error_set(look_at_cylinder(relief.camera, warped, viewer), ray_cast_view(two, viewer));
        EXPECT_GT(error.union_pixels, 1000);
        EXPECT_LT(error.missing_percent, 7);  // the side of a ball that was turned away
        EXPECT_LT(error.extra_percent, 4);
        EXPECT_LT(error.mean_depth_error, 0.01);
    }
    const CylinderRelief empty = *capture_cylinder(Spheres{}, camera(64));
    const ViewImage nothing = *warp_cylinder(empty, eye);
    for (const std::uint8_t covered : nothing.coverage.pixels()) EXPECT_EQ(covered, 0);
}

// ---------------------------------------------------------------------------------------- refusals
TEST(Cylinder, RefusesWhatItCannotShow) {
    const auto refused = [](auto&& change) {
        CylinderCamera c = camera(64);
        change(c);
        return refusal(c).has_value() && !capture_cylinder(Room{}, c);
    };
    EXPECT_FALSE(refused([](CylinderCamera&) {}));
    EXPECT_TRUE(refused([](CylinderCamera& c) { c.width = 3; }));
    EXPECT_TRUE(refused([](CylinderCamera& c) { c.height = 8193; }));
    EXPECT_TRUE(refused([](CylinderCamera& c) { c.ahead = {0, 0, -2}; }));
    EXPECT_TRUE(refused([](CylinderCamera& c) { c.up = {0, 0, -1}; }));
    EXPECT_TRUE(refused([](CylinderCamera& c) { c.radius = 0; }));
    EXPECT_TRUE(refused([](CylinderCamera& c) { c.low = c.high; }));
    EXPECT_TRUE(refused([](CylinderCamera& c) { c.centre.x = std::nan(""); }));
    const CylinderRelief relief = *capture_cylinder(Room{}, camera(256));
    EXPECT_FALSE(warp_cylinder(relief, {1.1, 0, 0}));  // outside
    EXPECT_FALSE(warp_cylinder(relief, {0.6, 0, 0}));  // past a ball
    EXPECT_TRUE(warp_cylinder(relief, {0.4, 0, 0}));
}

}  // namespace
}  // namespace relevo::relief
