#include "relief/self_shadow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "relief/inverse_slices.hpp"
#include "relief/surface_plane_step.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/relief/image_experiment.hpp"
#include "tests/relief/random_source.hpp"

namespace relevo::relief {
namespace {

using tests::experiment_source;
using tests::experiment_viewer;

// ---------------------------------------------------------------------------------------- the line of light
TEST(LightRay, RunsFromThePointToTheLight) {
    tests::hard::Random r(3);
    for (int i = 0; i < 500; ++i)
        for (const Projection projection : {Projection::Orthographic, Projection::Perspective}) {
            const ReliefCamera camera = random::source(r, projection);
            const double z = projection == Projection::Orthographic ? r.between(0, 3) : r.between(0, 0.9);
            const glm::dvec3 p(r.between(0, camera.width), r.between(0, camera.height), z);
            const glm::dvec3 x = inward_point(camera, p.x, p.y, p.z);
            const glm::dvec4 place(random::place(r, 4), i % 2 ? r.between(0.5, 2) : 0);
            const LightRay ray = light_ray(camera, p, {place});
            const double end = std::isfinite(ray.end) ? ray.end : 1e-3;
            const glm::dvec3 way = glm::dvec3(place) - place.w * x;
            for (const double share : {0.1, 0.5, 1.0}) {
                const glm::dvec3 q = p + share * end * ray.direction;
                if (projection == Projection::Perspective && !(q.z < 1 - 1e-3))
                    continue;  // nearly at infinity
                const glm::dvec3 there = inward_point(camera, q.x, q.y, q.z) - x;
                EXPECT_LT(glm::length(glm::cross(there, way)),
                          1e-7 * (1 + glm::dot(way, way) + glm::dot(there, there)));
                EXPECT_GT(glm::dot(there, way), 0);
                if (share == 1 && std::isfinite(ray.end)) {
                    EXPECT_LT(glm::length(there - way / place.w), 1e-6 * (1 + glm::length(way)));
                }
            }
        }
}

// ---------------------------------------------------------------------------------------- a wall
TEST(SelfShadow, OfAStepIsAsLongAsTheLightIsLow) {
    // The raised plate x > 0.1 of height 0.5, light from +x at 45 degrees: shadow where -0.4 < x < 0.1.
    const ReliefTexture texture =
        ray_cast(PlaneStep{0.5}, *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 100, 100}, {0, 0, 0.5}, 2));
    const ReliefSolid solid = extruded_solid(texture);
    const auto is_lit = [&](const ReliefHit& hit, const ReliefLight& light) {
        return illumination(texture, solid, hit, light) == Illumination::Lit;
    };
    for (const bool at_infinity : {true, false}) {
        // From (0.1, *, 0.5) the line of light to (3.1, y, 3.5).
        for (int x = 1; x < 99; ++x) {
            const double wx = (x + 0.5) / 50 - 1, y = 0.1;
            if (std::fabs(wx - 0.1) < 0.03 || std::fabs(wx + 0.4) < 0.03) continue;
            const ReliefLight light{at_infinity ? glm::dvec4(1, 0, 1, 0) : glm::dvec4(3.1, y, 3.5, 1)};
            const double z = double{texture.depth.at(x, 45)};
            const ReliefHit hit{x, 45, x + 0.5, 45.5, z};
            EXPECT_EQ(is_lit(hit, light), !(wx > -0.4 && wx < 0.1)) << wx;
            // From below everything is dark; straight from above nothing is.
            EXPECT_EQ(illumination(texture, solid, hit, {{0, 0, -1, 0}}), Illumination::TurnedAway);
            EXPECT_TRUE(is_lit(hit, {{0, 0, 1, 0}}));
        }
    }
    // A light between the point and the wall is not blocked by the wall.
    const ReliefHit near_wall{50, 45, 50.5, 45.5, 0.5};
    EXPECT_EQ(illumination(texture, solid, near_wall, {{0.5, 0.1, 0.3, 1}}), Illumination::Blocked);
    EXPECT_TRUE(is_lit(near_wall, {{0.05, 0.1, 0.03, 1}}));
}

TEST(SelfShadow, LooksAtEveryTexelOnTheWay) {
    ReliefTexture texture = make_relief_texture(experiment_source(64));
    for (std::size_t i = 0; i < texture.depth.pixels().size(); ++i)
        texture.coverage.pixels()[i] = 1, texture.depth.pixels()[i] = 1,
        texture.normal.pixels()[i] = {0, 0, -1};
    texture.depth.at(40, 20) = texture.depth.at(12, 30) = 0;  // thin pillars
    const ReliefSolid solid = extruded_solid(texture);
    struct Counter {
        int looks = 0;
        void on(const SolidLookedUp&) { ++looks; }
    };
    Counter counter;
    const LightRay ray{{10.5, 20.5, 1}, {30, 0, -0.5}, 10};  // over the pillar at z = 0.5, out at u = 64
    EXPECT_TRUE(is_blocked(solid, ray, {}));
    EXPECT_FALSE(is_blocked(solid, {{10.5, 21.5, 1}, {30, 0, -0.5}, 10}, {}, counter));
    EXPECT_EQ(counter.looks, 54);
    EXPECT_FALSE(is_blocked(solid, {{10.5, 20.5, 1}, {30, 0, -0.5}, 0.9}, {}));  // the light stands before it
    EXPECT_FALSE(is_blocked(solid, {{10.5, 20.5, 1}, {0, 0, -1}, 10}, {}));
    // One that stands close by, once the line of light is out of the surface.
    EXPECT_TRUE(is_blocked(solid, {{10.5, 30.5, 1}, {30, 0, -0.5}, 10}, {}));
}

// ---------------------------------------------------------------------------------------- against the truth
ShadowError wrong_shadows(const Spheres& object, const ReliefCamera& source, double azimuth,
                          const ReliefLight& light, bool back) {
    const ReliefTexture texture = ray_cast(object, source);
    ReliefSolid solid =
        back ? solid_between(texture, ray_cast(object, opposite_camera(source, 2))) : extruded_solid(texture);
    solid.reading = Reading::Bilinear;
    const ReliefCamera viewer = experiment_viewer(azimuth, 256);
    const Image<Illumination> found = *inverse_shadows(
        texture, solid, viewer,
        [&](const ReliefRay& ray) {
            return find_by_slices(solid, ray, {128, 8});
        },
        light);
    return shadow_error(found, cast_shadows(object, viewer, light));
}
double wrong_percent(const ShadowError& error) { return 100.0 * error.wrong / error.seen; }

TEST(SelfShadow, OnSpheresIsTheTruthButForAFewPixels) {
    struct Row {
        const char* name;
        const Spheres* object;
        double azimuth, most;
    };
    const ReliefLight sun{{0.8, 0.5, -1, 0}}, lamp{{1.2, 1.5, -1.6, 1}};
    for (const auto& [name, object, azimuth, most] :
         {Row{"sphere", &scene::sphere_object, 0, 0.1}, Row{"sphere", &scene::sphere_object, 25, 0.1},
          Row{"bumpy", &scene::bumpy_object, 0, 0.3}, Row{"bumpy", &scene::bumpy_object, 25, 0.8},
          Row{"complex", &scene::complex_object, 0, 9}}) {
        const ShadowError by_sun = wrong_shadows(*object, experiment_source(), azimuth, sun, true),
                          by_lamp = wrong_shadows(*object, experiment_source(), azimuth, lamp, true),
                          extruded = wrong_shadows(*object, experiment_source(), azimuth, sun, false);
        std::printf(
            "%s, %2.0f degrees: wrong shadow pixels %.2f %% by a far light (%.1f %% of %d cast ones), %.2f "
            "%% by a near one; "
            "without a back layer %.2f %%\n",
            name, azimuth, wrong_percent(by_sun),
            100.0 * by_sun.wrong_of_blocked / std::max(by_sun.blocked, 1), by_sun.blocked,
            wrong_percent(by_lamp), wrong_percent(extruded));
        EXPECT_GT(by_sun.seen, 5000);
        EXPECT_LT(wrong_percent(by_sun), most);
        EXPECT_LT(wrong_percent(by_lamp), most);
    }
}

TEST(SelfShadow, APerspectiveSourceDoesIt) {
    const ReliefCamera source =
        *perspective_camera({{0, 0, 1}, {0, 1, 0}, 256, 256}, {0, 0, -3.2}, 2.1, {45});
    const ShadowError wrong = wrong_shadows(scene::bumpy_object, source, 0, {{0.8, 0.5, -1, 0}}, false);
    std::printf("bumpy, perspective source: wrong shadow pixels %.2f %%\n", wrong_percent(wrong));
    EXPECT_LT(wrong_percent(wrong), 0.4);
}

}  // namespace
}  // namespace relevo::relief
