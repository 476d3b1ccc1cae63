#include "relief/draw_relief.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"
#include "raster/draw.hpp"
#include "relief/error_set.hpp"
#include "relief/map_plane.hpp"
#include "relief/surface_spheres.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/relief/image_experiment.hpp"
#include "tests/support/drawing.hpp"

namespace relevo::relief {
namespace {

constexpr int size = 256;
constexpr double near_plane = 0.5;

struct Seen {
    ReliefCamera screen;
    raster::Scene scene;
    Prewarped picture;
    ReliefCamera source;
    Warp warp;
    ReliefModel model() const {
        return {&picture, source, viewer_at(screen.eye), {}, Reading::Bilinear, Scalar(0.1)};
    }
};
Seen seen(double azimuth) {
    Seen s;
    s.screen = tests::experiment_viewer(azimuth, size);
    s.source = tests::experiment_source(256);
    const ReliefTexture texture = ray_cast(scene::sphere_object, s.source);
    s.warp = *make_warp(s.source, viewer_at(s.screen.eye));
    s.picture = prewarp(texture, s.warp, *target_window(s.source, s.warp, depth_range(texture)));
    s.scene.camera.eye_from_world = *pipeline::look_at(s.screen.eye, {0, 0, 0}, {0, 1, 0});
    s.scene.camera.clip_from_eye = *pipeline::perspective(
        {45}, 1, near_plane, std::numeric_limits<double>::infinity(), pipeline::DepthRange::Reversed);
    s.scene.background = {0, 0, 0};
    return s;
}
raster::Frame drawn(const Seen& s, const raster::Settings& settings) {
    raster::Frame frame = tests::frame_of(size, size, true);
    raster::draw(s.scene, settings, frame);
    draw_relief(s.model(), s.scene, settings, frame);
    return frame;
}

TEST(DrawRelief, IsThePictureOfThePlaneSeenFromTheViewer) {
    for (const double azimuth : {0.0, 10.0, 25.0, 40.0}) {
        const Seen s = seen(azimuth);
        const raster::Frame frame = drawn(s, tests::unlit());
        const ViewImage right = map_plane(s.picture, s.source, s.warp, s.screen);
        int differ = 0, covered = 0;
        double color = 0, depth = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const bool there = frame.depth.at(x, y) > 0;
                differ += there != (right.coverage.at(x, y) != 0);
                if (!there || !right.coverage.at(x, y)) continue;
                ++covered;
                color = std::max(
                    color, std::sqrt(mean_square_difference(frame.linear.at(x, y), right.color.at(x, y))));
                // reversed depth, infinite far plane: z = near / distance
                depth = std::max(depth, std::abs(near_plane / double(frame.depth.at(x, y)) -
                                                 double(right.depth.at(x, y))));
            }
        EXPECT_GT(covered, 5000);
        // the corners are snapped to 1/256 pixel
        EXPECT_LE(differ, 5) << azimuth;
        EXPECT_LT(color, 0.05) << azimuth;
        EXPECT_LT(depth, 0.03) << azimuth;
    }
}

// A slanted plane through the sphere: in front of it the sphere hides the plane, behind it the plane
// hides the sphere, pixel by pixel as with the true depth of both.
TEST(DrawRelief, CutsAnotherObjectWhereTheSurfaceDoes) {
    Seen s = seen(25);
    const pipeline::Mesh plane =
        tests::mesh_of({{{{-3, -3, Scalar(-1.9)}, {3, -3, Scalar(0.5)}, {3, 3, Scalar(0.5)}}},
                        {{{-3, -3, Scalar(-1.9)}, {3, 3, Scalar(0.5)}, {-3, 3, Scalar(-1.9)}}}});
    pipeline::Material white;
    white.color = {1, 1, 1};
    s.scene.models.push_back({&plane, {}, white, nullptr, true});
    const raster::Frame frame = drawn(s, tests::unlit());
    const ViewImage truth = ray_cast_view(scene::sphere_object, s.screen);
    int plane_seen = 0, sphere_seen = 0, wrong = 0, wrong_flat = 0;
    const double flat_depth = view_depth(s.screen, s.source.corner);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            if (!truth.coverage.at(x, y)) continue;
            // where the line of sight meets z = -0.7 + 0.4 x
            const SourceRay ray = source_ray(s.screen, x + 0.5, y + 0.5);
            const double t = (-0.7 + 0.4 * ray.origin.x - ray.origin.z) /
                             (ray.direction.z - 0.4 * ray.direction.x),
                         distance = view_depth(s.screen, ray.origin + t * ray.direction);
            const bool sphere_right = double(truth.depth.at(x, y)) < distance,
                       sphere_got = !(frame.linear.at(x, y) == LinearRgb{1, 1, 1});
            sphere_seen += sphere_right, plane_seen += !sphere_right;
            wrong += sphere_right != sphere_got;
            wrong_flat += sphere_right != (flat_depth < distance);
        }
    std::printf("%d pixels of the sphere, %d of the plane before it: %d wrong; a flat sprite has %d\n",
                sphere_seen, plane_seen, wrong, wrong_flat);
    EXPECT_GT(sphere_seen, 2000);
    EXPECT_GT(plane_seen, 2000);
    EXPECT_LE(wrong, (sphere_seen + plane_seen) / 200);
    EXPECT_GT(wrong_flat, (sphere_seen + plane_seen) / 10);
}

// Lit by the normals of the picture: as the same light does on the sphere itself.
TEST(DrawRelief, IsLitAsTheObjectIs) {
    Seen s = seen(10);
    s.scene.lights.push_back({pipeline::Light::Kind::Point, {{2, 3, -4}}, {{0, 0, -1}}, {1, 1, 1}});
    raster::Settings settings = tests::unlit();
    settings.shading = raster::Shading::Phong;
    const raster::Frame frame = drawn(s, settings);
    const ReliefTexture truth = ray_cast(scene::sphere_object, s.screen);
    const auto lights = raster::lights_in_eye_space(s.scene);
    const pipeline::Material material;
    const pipeline::Lighting lighting{
        lights, material.ambient, material.diffuse, material.specular, pipeline::exponent(material.shininess),
        false};
    int compared = 0, off = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            if (!truth.coverage.at(x, y) || frame.depth.at(x, y) == 0) continue;
            const auto& map = s.scene.camera.eye_from_world.m;
            const glm::dvec3 eye(map * glm::dvec4(world_point(truth, x, y), 1)),
                normal(map * glm::dvec4(glm::dvec3(truth.normal.at(x, y)), 0));
            const LinearRgb right = pipeline::reflected(
                truth.color.at(x, y),
                pipeline::reflect(lighting, Vec3(eye), pipeline::normalize(Vec3(normal))));
            ++compared;
            off += mean_square_difference(frame.linear.at(x, y), right) > 0.05 * 0.05;
        }
    std::printf("lit: %d of %d pixels more than 0.05 off\n", off, compared);
    EXPECT_GT(compared, 5000);
    EXPECT_LE(off, compared / 50);
}

TEST(DrawRelief, BehindTheEyeOrBesideThePictureItDrawsNothing) {
    Seen s = seen(10);
    s.scene.camera.eye_from_world = *pipeline::look_at(s.screen.eye, 2.0 * s.screen.eye, {0, 1, 0});
    const raster::Frame frame = drawn(s, tests::unlit());
    for (const Scalar z : frame.depth.pixels()) ASSERT_EQ(z, 0);
}

// A parallel view of the ball from aside: its viewer is a direction, and so is the viewer of its highlight.
TEST(DrawRelief, AParallelViewIsRightLitAndUnlit) {
    Seen s = seen(0);
    const glm::dvec3 toward = glm::normalize(glm::dvec3(-0.3, -0.2, 1));
    const ReliefCamera screen = *orthographic_camera({toward, {0, 1, 0}, size, size}, -3.0 * toward, 2.6);
    const ReliefTexture texture = ray_cast(scene::sphere_object, s.source),
                        truth = ray_cast(scene::sphere_object, screen);
    const Viewer viewer = viewer_toward(-toward);
    s.warp = *make_warp(s.source, viewer);
    s.picture = prewarp(texture, s.warp, *target_window(s.source, s.warp, depth_range(texture)));
    ReliefModel model = s.model();
    model.viewer = viewer, model.material.specular = 1, model.material.shininess = 8;
    s.scene.camera.eye_from_world = *pipeline::look_at(-3.0 * toward, {0, 0, 0}, {0, 1, 0});
    s.scene.camera.clip_from_eye =
        *pipeline::orthographic(-1.3, 1.3, -1.3, 1.3, 0, 8, pipeline::DepthRange::Reversed);
    s.scene.camera.parallel = true;
    s.scene.lights.push_back({pipeline::Light::Kind::Directional, {{0, 0, 0}}, {{1, -2, 3}}, {1, 1, 1}});
    const auto lights = raster::lights_in_eye_space(s.scene);
    const pipeline::Lighting lighting{lights, model.material.ambient, model.material.diffuse,
                                      1,      pipeline::exponent(8),  true};
    for (const auto shading : {raster::Shading::Unlit, raster::Shading::Phong}) {
        raster::Settings settings = tests::unlit();
        settings.shading = shading;
        raster::Frame frame = tests::frame_of(size, size, true);
        raster::draw(s.scene, settings, frame);
        draw_relief(model, s.scene, settings, frame);
        int compared = 0, missing = 0, extra = 0, off = 0, far_off = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const bool there = frame.depth.at(x, y) > 0, right = truth.coverage.at(x, y) != 0;
                missing += right && !there, extra += there && !right;
                if (!there || !right) continue;
                ++compared;
                LinearRgb color = truth.color.at(x, y);
                if (shading == raster::Shading::Phong) {
                    const glm::dmat3 map(s.scene.camera.eye_from_world.m);
                    const Vec3 normal(map * glm::dvec3(truth.normal.at(x, y)));
                    color = pipeline::reflected(
                        color, pipeline::reflect(lighting, Vec3(0, 0, -3), pipeline::normalize(normal)));
                }
                off += mean_square_difference(frame.linear.at(x, y), color) > 0.05 * 0.05;
                // reversed: 1 at the eye's plane, 0 at distance 8
                far_off +=
                    std::abs(8 * (1 - double{frame.depth.at(x, y)}) - double{truth.depth.at(x, y)}) > 0.03;
            }
        std::printf("parallel view: %d compared, %d missing, %d extra, %d colours off, %d depths off\n",
                    compared, missing, extra, off, far_off);
        EXPECT_GT(compared, 20'000);
        // of the ball's disc the source does not see the part beyond its own outline
        EXPECT_NEAR(missing, (1 - toward.z) / 2 * compared, 0.01 * compared);
        EXPECT_LE(extra, compared / 100);
        EXPECT_LE(off, compared / 50);
        EXPECT_LE(far_off, compared / 100);
    }
}

TEST(DrawRelief, AHomogeneousViewerMayHaveAnyWeight) {
    const Seen s = seen(25);
    raster::Frame frames[2] = {tests::frame_of(size, size, true), tests::frame_of(size, size, true)};
    for (const int i : {0, 1}) {
        ReliefModel model = s.model();
        model.viewer.place *= i ? 4.0 : 1.0;
        raster::draw(s.scene, tests::unlit(), frames[i]);
        draw_relief(model, s.scene, tests::unlit(), frames[i]);
    }
    EXPECT_EQ(frames[0].depth.pixels(), frames[1].depth.pixels());
}

// What lies beyond the far plane is not drawn, though the polygon itself is near enough.
TEST(DrawRelief, IsCutByTheFarPlaneAtItsOwnDepth) {
    Seen s = seen(10);
    const raster::Frame whole = drawn(s, tests::unlit());
    constexpr double far = 2.5;
    s.scene.camera.clip_from_eye =
        *pipeline::perspective({45}, 1, near_plane, far, pipeline::DepthRange::Reversed);
    const raster::Frame cut = drawn(s, tests::unlit());
    int kept = 0, dropped = 0;
    for (std::size_t i = 0; i < whole.depth.pixels().size(); ++i) {
        const double z = double{whole.depth.pixels()[i]}, distance = near_plane / z;
        if (z == 0 || std::abs(distance - far) < 1e-3) continue;
        // z = 0 would be the far plane itself: a pixel that was drawn has more
        EXPECT_EQ(cut.depth.pixels()[i] > 0, distance < far);
        ++(distance < far ? kept : dropped);
        if (distance > far) {
            EXPECT_EQ(cut.linear.pixels()[i], s.scene.background);
        }
    }
    EXPECT_GT(kept, 5000);
    EXPECT_GT(dropped, 5000);
}

TEST(DrawRelief, WritesTheOutputThatTheSettingsAskFor) {
    const Seen s = seen(10);
    for (const auto output : {raster::Output::Raw, raster::Output::Srgb}) {
        raster::Settings settings = tests::unlit();
        settings.output = output;
        const raster::Frame frame = drawn(s, settings);
        int covered = 0;
        for (std::size_t i = 0; i < frame.depth.pixels().size(); ++i) {
            if (!(frame.depth.pixels()[i] > 0)) continue;
            ++covered;
            ASSERT_EQ(frame.color.pixels()[i], raster::to_rgba8(frame.linear.pixels()[i], output));
        }
        EXPECT_GT(covered, 5000);
    }
}

}  // namespace
}  // namespace relevo::relief
