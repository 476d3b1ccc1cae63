// Objects by pictures of themselves: every way is near the truth, and the way to the frame is the machine's.
#include "relief/representation.hpp"

#include <gtest/gtest.h>

#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"
#include "raster/draw.hpp"
#include "relief/error_set.hpp"
#include "relief/screen.hpp"
#include "relief/warp_3d.hpp"
#include "samples/scene/shapes/cube.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "samples/scene/shapes/torus.hpp"

namespace relevo::relief {
namespace {

using pipeline::Degrees;

raster::Scene scene_seen_from(const glm::dvec3& eye,
                              pipeline::DepthRange range = pipeline::DepthRange::Reversed) {
    raster::Scene scene;
    scene.camera.eye_from_world = *pipeline::look_at(eye, glm::dvec3(0), {0, 1, 0});
    scene.camera.clip_from_eye =
        *pipeline::perspective(Degrees{45}, 1.25, 0.5, std::numeric_limits<double>::infinity(), range);
    scene.lights = {{.position = {{4, 6, 8}}}};
    return scene;
}

// ---------------------------------------------------------------------------------------------- the screen

TEST(Screen, ItsPixelsAreTheMachines) {
    for (const auto range : {pipeline::DepthRange::Reversed, pipeline::DepthRange::Forward}) {
        const raster::Scene scene = scene_seen_from({1, 2, 3}, range);
        const bool reversed = range == pipeline::DepthRange::Reversed;
        const auto format =
            reversed ? raster::DepthFormat::Float32Reversed : raster::DepthFormat::Float32Forward;
        const ReliefCamera screen = *screen_camera(scene.camera, format, 100, 80);
        EXPECT_NEAR(view_depth(screen, screen.corner), 0.5, 1e-12);
        for (const glm::dvec3 p : {glm::dvec3(0), {0.3, -0.4, 0.8}, {-0.5, 0.1, -2}}) {
            const glm::dvec4 clip =
                scene.camera.clip_from_eye.m * (scene.camera.eye_from_world.m * glm::dvec4(p, 1));
            const Warped3d seen = warp_3d(p - screen.eye, screen);
            EXPECT_NEAR(seen.u, (clip.x / clip.w + 1) / 2 * 100, 1e-10);
            EXPECT_NEAR(seen.v, (1 - clip.y / clip.w) / 2 * 80, 1e-10);
            EXPECT_NEAR(seen.z * 0.5, view_depth(screen, p), 1e-12);
            EXPECT_NEAR(view_depth(screen, p), clip.w, 1e-12);
        }
    }
}

TEST(Screen, AParallelViewHasNone) {
    raster::Scene scene = scene_seen_from({1, 2, 3});
    scene.camera.parallel = true;
    EXPECT_EQ(screen_camera(scene.camera, {}, 10, 10).error().message, "a parallel view has no eye");
}

// The truth of a mesh, put into a frame, is what the machine draws: the same pixels, depths and colours but
// for the last bits.
TEST(Screen, TheTruthInTheFrameIsTheMachinesPicture) {
    const pipeline::Mesh mesh = *scene::torus(48, 24, 0.4);
    for (const auto format : {raster::DepthFormat::Float32Reversed, raster::DepthFormat::Float32Forward}) {
        const bool reversed = format == raster::DepthFormat::Float32Reversed;
        raster::Scene scene = scene_seen_from(
            {1, 2, 3}, reversed ? pipeline::DepthRange::Reversed : pipeline::DepthRange::Forward);
        scene.models = {{&mesh, {}, {}, nullptr, false}};
        raster::Settings settings;
        settings.depth = format;
        raster::Frame machine{{100, 80}, {100, 80}, {100, 80}}, ours = machine;
        raster::draw(scene, settings, machine);
        raster::Scene none = scene;
        none.models.clear();
        raster::draw(none, settings, ours);
        const Represented geometry = *represent(
            Representation::Geometry, {}, {{&scene, nullptr}, settings, scene.models[0].material, false});
        ASSERT_FALSE(draw_represented(geometry, scene, settings, ours));
        int differ = 0;
        for (std::size_t i = 0; i < machine.depth.pixels().size(); ++i) {
            const auto cleared = raster::cleared_depth(format);
            const bool a = machine.depth.pixels()[i] != cleared, b = ours.depth.pixels()[i] != cleared;
            differ += a != b;
            if (!a || !b) continue;
            // The machine's depth is that of the snapped triangle.
            EXPECT_NEAR(machine.depth.pixels()[i], ours.depth.pixels()[i], 2e-3);
            EXPECT_NEAR(machine.linear.pixels()[i].r, ours.linear.pixels()[i].r, 0.02);
        }
        EXPECT_EQ(differ, 0);
    }
}

TEST(Screen, NearerWinsAndWhatIsBeyondTheFarPlaneIsNotDrawn) {
    raster::Scene scene = scene_seen_from({0, 0, 3});
    scene.camera.clip_from_eye =
        *pipeline::perspective(Degrees{45}, 1, 0.5, 4, pipeline::DepthRange::Reversed);
    raster::Frame frame{{3, 1}, {3, 1}, {}};
    raster::draw(scene, {}, frame);
    ViewImage image(3, 1);
    image.coverage.pixels() = {1, 1, 1};
    image.depth.pixels() = {2, 5, Scalar(0.25)};  // within, beyond far, before near
    image.color.pixels() = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    draw_view_image(image, scene.camera, {}, frame);
    EXPECT_EQ(frame.color.at(0, 0), raster::to_rgba8({1, 0, 0}, raster::Output::Srgb));
    EXPECT_EQ(frame.color.at(1, 0), raster::to_rgba8(scene.background, raster::Output::Srgb));
    EXPECT_EQ(frame.color.at(2, 0), raster::to_rgba8(scene.background, raster::Output::Srgb));
    image.depth.pixels()[0] = 3, image.color.pixels()[0] = {0, 1, 0};
    draw_view_image(image, scene.camera, {}, frame);  // behind what is there
    EXPECT_EQ(frame.color.at(0, 0), raster::to_rgba8({1, 0, 0}, raster::Output::Srgb));
}

// ---------------------------------------------------------------------------------------------- placed
// surfaces

TEST(PlacedSurface, IsHitWhereItsMapPutsIt) {
    const auto turned = pipeline::rotate<pipeline::World>({1, 2, 3}, Degrees{40});
    const glm::dmat4 map = (pipeline::translate<pipeline::World>({0.5, -1, 2}) * *turned *
                            pipeline::scale<pipeline::World>({2, 1, 0.5}))
                               .m;
    const PlacedSurface ball = placed(scene::sphere_object, map);
    const BoundingBall round = bounding_ball(ball);
    EXPECT_NEAR(round.radius, 2, 1e-12);
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 to(0.5 + 0.01 * (i % 20) - 0.1, -1 + 0.02 * (i % 7), 2 - 0.03 * (i % 11));
        const glm::dvec3 from(5 + 0.1 * i, 3, -4);
        const auto hit = first_hit(ball, {from, to - from, 0});
        if (!hit) continue;
        ++hits;
        const glm::dvec3 p = from + hit->t * (to - from);
        const glm::dvec3 own(glm::inverse(map) * glm::dvec4(p, 1));
        EXPECT_NEAR(glm::dot(own, own), 1, 1e-9);
        EXPECT_NEAR(glm::dot(hit->normal, hit->normal), 1, 1e-12);
        // the gradient of |own|^2 in the world
        const double step = 1e-6;
        for (int k = 0; k < 3; ++k) {
            glm::dvec3 aside = p;
            aside[k] += step;
            const glm::dvec3 q(glm::inverse(map) * glm::dvec4(aside, 1));
            const double slope = (glm::dot(q, q) - glm::dot(own, own)) / step;
            const glm::dvec3 gradient = 2.0 * (glm::transpose(glm::inverse(glm::dmat3(map))) * own);
            EXPECT_NEAR(slope, std::sqrt(glm::dot(gradient, gradient)) * hit->normal[k], 1e-4);
        }
    }
    EXPECT_GT(hits, 100);
}

// ---------------------------------------------------------------------------------------------- sources

TEST(SourceCamera, TouchesTheBallAndSeesAllOfIt) {
    const BoundingBall ball{{1, 2, 3}, 0.5};
    for (const auto projection : {Projection::Orthographic, Projection::Perspective})
        for (const double azimuth : {0.0, 37.0, 90.0, 200.0})
            for (const double elevation : {-90.0, -30.0, 0.0, 60.0, 90.0}) {
                RepresentationSettings settings;
                settings.projection = projection, settings.texels = 64;
                settings.azimuth = {azimuth}, settings.elevation = {elevation};
                const ReliefCamera camera = *source_camera(settings, ball);
                ASSERT_FALSE(refusal(camera));
                EXPECT_NEAR(glm::dot(ball.centre - camera.corner, forward(camera)), ball.radius, 1e-12);
                // no point of the ball is outside of the picture or before the plane
                for (int i = 0; i < 500; ++i) {
                    const double z = 1 - (i + 0.5) / 250, r = std::sqrt(1 - z * z);
                    const Degrees turn{137.50776405 * i};
                    const glm::dvec3 p =
                        ball.centre + ball.radius * glm::dvec3(r * cos(turn), r * sin(turn), z);
                    EXPECT_GE(glm::dot(p - camera.corner, forward(camera)), -1e-12);
                    glm::dvec3 at;
                    if (projection == Projection::Orthographic)
                        at = glm::inverse(glm::dmat3(camera.a, camera.b, forward(camera))) *
                             (p - camera.corner);
                    else
                        at = {warp_3d(p - camera.eye, camera).u, warp_3d(p - camera.eye, camera).v, 0};
                    EXPECT_TRUE(at.x >= -1e-9 && at.x <= 64 + 1e-9) << at.x;
                    EXPECT_TRUE(at.y >= -1e-9 && at.y <= 64 + 1e-9) << at.y;
                }
            }
}

// ---------------------------------------------------------------------------------------------- all ways

struct Way {
    Representation representation;
    double least_psnr, most_missing;  // of `bumpy` at 20 degrees, lit
};

TEST(Representations, EachIsAsNearToTheTruthAsItIs) {
    const PlacedSurface bumpy = placed(scene::bumpy_object, glm::dmat4(1));
    const raster::Scene scene = scene_seen_from(3.2 * glm::dvec3(0.342, 0.1, 0.935));
    raster::Scene lights;
    lights.lights = scene.lights;
    const ShapeCapture capture{{&lights, &bumpy}, {}, {}, false};
    RepresentationSettings settings;
    settings.radius = 1;
    settings.texels = 128;
    const ReliefCamera screen = *screen_camera(scene.camera, raster::DepthFormat::Float32Reversed, 320, 256);
    const ViewImage truth = *true_view(capture, screen, scene, {});
    const Way ways[] = {
        {Representation::Geometry, 300, 0},       {Representation::Relief, 24.9, 1.5},
        {Representation::ReliefBox, 26.8, 0.05},  {Representation::ReliefInverse, 27.9, 0.4},
        {Representation::SpriteDepth, 24.2, 1.2}, {Representation::Ldi, 26, 0.4},
        {Representation::Morph, 20, 3.6},         {Representation::Sprite, 12, 9.5},
    };
    double sprite = 0;
    for (const Way& way : ways) {
        const Represented object = *represent(way.representation, settings, capture);
        const ErrorSet error = error_set(*view_of(object, screen, scene, {}), truth);
        EXPECT_GE(error.psnr, way.least_psnr) << int(way.representation);
        EXPECT_LE(error.missing_percent, way.most_missing) << int(way.representation);
        if (way.representation == Representation::Sprite) sprite = error.psnr;
    }
    EXPECT_LT(sprite, 15);
}

TEST(Representations, AViewerBehindTheOnlyPlaneIsRefused) {
    const PlacedSurface ball = placed(scene::sphere_object, glm::dmat4(1));
    const raster::Scene behind = scene_seen_from({0, 0.5, -3}), before = scene_seen_from({0, 0.5, 3});
    raster::Scene lights;
    const ShapeCapture capture{{&lights, &ball}, {}, {}, false};
    RepresentationSettings settings;
    settings.texels = 16;
    for (const auto way : {Representation::Relief, Representation::ReliefInverse, Representation::Sprite,
                           Representation::SpriteDepth}) {
        const Represented object = *represent(way, settings, capture);
        EXPECT_FALSE(refusal(object, before.camera));
        ASSERT_TRUE(refusal(object, behind.camera));
        raster::Frame frame{{20, 16}, {20, 16}, {}};
        EXPECT_EQ(draw_represented(object, behind, {}, frame)->message,
                  refusal(object, behind.camera)->message);
    }
    for (const auto way : {Representation::ReliefBox, Representation::Geometry, Representation::Ldi})
        EXPECT_FALSE(refusal(*represent(way, settings, capture), behind.camera));
}

TEST(Representations, LightIsTheViewersOrTheSources) {
    const PlacedSurface ball = placed(scene::sphere_object, glm::dmat4(1));
    const raster::Scene scene = scene_seen_from({1.2, 0.4, 2.9});
    raster::Scene lights;
    lights.lights = scene.lights;
    const ShapeCapture capture{{&lights, &ball}, {}, {}, false};
    const ReliefCamera screen = *screen_camera(scene.camera, raster::DepthFormat::Float32Reversed, 160, 128);
    const ViewImage truth = *true_view(capture, screen, scene, {});
    RepresentationSettings settings;
    const double drawn =
        error_set(*view_of(*represent(Representation::Relief, settings, capture), screen, scene, {}), truth)
            .psnr;
    settings.lit = Lit::Captured;
    const double captured =
        error_set(*view_of(*represent(Representation::Relief, settings, capture), screen, scene, {}), truth)
            .psnr;
    EXPECT_GT(drawn, captured + 1);  // gloss that stands still is wrong
}

TEST(Representations, WhatHasNoExtentIsRefused) {
    raster::Scene nothing;
    EXPECT_EQ(represent(Representation::Relief, {}, {{&nothing, nullptr}, {}, {}, false}).error().message,
              "the object has no extent");
}

}  // namespace
}  // namespace relevo::relief
