#include "relief/capture_raster.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/transform.hpp"
#include "relief/layered_depth_image.hpp"
#include "relief/surface_mesh.hpp"
#include "samples/scene/shapes/torus.hpp"

namespace relevo::relief {
namespace {

static_assert(Capture<RasterCapture> && Capture<RayCapture<MeshSurface>>);

raster::Scene scene_of(const pipeline::Mesh& mesh) {
    raster::Scene scene;
    scene.models.emplace_back().mesh = &mesh;
    scene.models[0].material.color = {Scalar(0.25), Scalar(0.5), Scalar(0.75)};
    return scene;
}

ReliefCamera slanted_camera(int size) {
    return *orthographic_camera({{-0.3, -0.4, -1}, {0, 1, 0}, size, size}, {0.5, 0.7, 1.6}, 3);
}
ReliefCamera perspective_slanted_camera(int size) {
    return *perspective_camera({{-0.3, -0.4, -1}, {0, 1, 0}, size, size}, {1.2, 1.6, 4}, 1.5, {42});
}

struct Difference {
    int covered = 0, edge = 0, coverage = 0;
    double depth = 0, normal = 0;
};

// Rays a hair beside the texel's: where they see another depth or nothing, an edge of the picture passes, and
// a corner snapped by 1/512 texel may decide otherwise.
template <class Surface>
bool on_an_edge(const Surface& surface, const ReliefCamera& camera, int x, int y) {
    const double hair = 1.0 / 256;
    const auto centre = first_hit(surface, capture_ray(camera, x + 0.5, y + 0.5));
    for (const glm::dvec2 by : {glm::dvec2(-hair, -hair), {-hair, hair}, {hair, -hair}, {hair, hair}}) {
        const auto beside = first_hit(surface, capture_ray(camera, x + 0.5 + by.x, y + 0.5 + by.y));
        if (beside.has_value() != centre.has_value()) return true;
        if (centre && std::fabs(beside->t - centre->t) > 1e-3) return true;
    }
    return false;
}

// Rays see back faces, too.
Difference compare(const pipeline::Mesh& mesh, const ReliefCamera& camera,
                   pipeline::Cull cull = pipeline::Cull::Back) {
    const raster::Scene scene = scene_of(mesh);
    const MeshSurface surface{mesh, scene.models[0].material.color};
    const ReliefTexture raster =
                            *RasterCapture{scene, {.shading = raster::Shading::Unlit, .cull = cull}}(camera),
                        ray = *RayCapture{surface}(camera);
    EXPECT_FALSE(refusal(raster));
    Difference difference;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            if (!raster.coverage.at(x, y) && !ray.coverage.at(x, y)) continue;
            const bool edge = on_an_edge(surface, camera, x, y);
            difference.edge += edge;
            if (raster.coverage.at(x, y) != ray.coverage.at(x, y)) {
                difference.coverage += !edge;
                continue;
            }
            ++difference.covered;
            if (edge) continue;
            const double off = std::fabs(double(raster.depth.at(x, y)) - double(ray.depth.at(x, y)));
            difference.depth = std::max(difference.depth, off);
            difference.normal = std::max(difference.normal, glm::length(glm::dvec3(raster.normal.at(x, y)) -
                                                                        glm::dvec3(ray.normal.at(x, y))));
            EXPECT_EQ(raster.color.at(x, y), ray.color.at(x, y));
        }
    return difference;
}

TEST(CaptureRaster, SeesWhatRaysSee) {
    const pipeline::Mesh torus = scene::torus_mesh(24, 12, 0.4);
    for (const ReliefCamera& camera : {slanted_camera(128), perspective_slanted_camera(128)}) {
        const Difference difference = compare(torus, camera);
        std::printf("%d texels, %d at edges, coverage differs in %d, depth by %.2g, normal by %.2g\n",
                    difference.covered, difference.edge, difference.coverage, difference.depth,
                    difference.normal);
        EXPECT_GT(difference.covered, 3000);
        EXPECT_LT(difference.edge, difference.covered / 50);
        EXPECT_EQ(difference.coverage, 0);
        EXPECT_LT(difference.depth, 1e-4);
        EXPECT_LT(difference.normal, 2e-2);
    }
}

TEST(CaptureRaster, SkewedAxesAreNoObstacle) {
    const pipeline::Mesh torus = scene::torus_mesh(24, 12, 0.4);
    ReliefCamera camera = slanted_camera(64);
    camera.b += 0.4 * camera.a;
    camera.corner -= 0.4 * 32 * camera.a;
    const Difference difference = compare(torus, camera);
    EXPECT_GT(difference.covered, 800);
    EXPECT_EQ(difference.coverage, 0);
    EXPECT_LT(difference.depth, 1e-4);
}

TEST(CaptureRaster, ModelsStandWhereTheyArePlacedAndTheNearestIsSeen) {
    const pipeline::Mesh torus = scene::torus_mesh(24, 12, 0.4);
    raster::Scene scene = scene_of(torus);
    scene.models.push_back(scene.models[0]);
    scene.models[1].material.color = {1, 0, 0};
    scene.models[1].world_from_object.m =
        pipeline::translation_matrix({0.5, 0, 0.75}) * *pipeline::rotation_matrix({1, 0, 0}, {90});
    const ReliefCamera camera = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 96, 96}, {0, 0, 3}, 4);
    const ReliefTexture both = *capture_raster(scene, camera);
    pipeline::Mesh turned = torus;
    for (pipeline::Vertex& v : turned.vertices) {  // x, y, z -> x + .5, -z, y + .75
        v.position.v = {v.position.v.x + Scalar(0.5), -v.position.v.z, v.position.v.y + Scalar(0.75)};
        v.normal.v = {v.normal.v.x, -v.normal.v.z, v.normal.v.y};
    }
    const ReliefTexture first = *capture_raster(scene_of(torus), camera);
    const ReliefTexture second = *capture_raster(scene_of(turned), camera);
    int red = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            const bool one = first.coverage.at(x, y), two = second.coverage.at(x, y);
            ASSERT_EQ(both.coverage.at(x, y) == 1, one || two);
            if (!one && !two) continue;
            const bool nearer = two && (!one || second.depth.at(x, y) < first.depth.at(x, y));
            const ReliefTexture& seen = nearer ? second : first;
            EXPECT_NEAR(both.depth.at(x, y), seen.depth.at(x, y), 1e-5);
            EXPECT_LT(glm::length(both.normal.at(x, y) - seen.normal.at(x, y)), 1e-4);
            EXPECT_EQ(both.color.at(x, y).g, nearer ? 0 : Scalar(0.5));
            red += nearer;
        }
    EXPECT_GT(red, 300);
}

TEST(CaptureRaster, AVertexWithoutNormalGetsTheFaces) {
    pipeline::Mesh mesh;  // half of the square z = 0, |x|, |y| <= 1
    for (const Vec3 p : {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0)})
        mesh.vertices.push_back({{p}, {{0, 0, 0}}});
    mesh.indices = {0, 1, 2};
    const ReliefCamera camera = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 16, 16}, {0, 0, 0}, 2);
    const ReliefTexture texture = *capture_raster(scene_of(mesh), camera);
    EXPECT_EQ(texture.normal.at(12, 10), Vec3(0, 0, 1));
    EXPECT_EQ((RayCapture{MeshSurface{mesh}})(camera)->normal.at(12, 10), Vec3(0, 0, 1));
    EXPECT_EQ(texture.depth.at(12, 10), 0);  // on the source's plane
    EXPECT_EQ(texture.coverage.at(12, 10), 1);
    EXPECT_EQ(texture.coverage.at(2, 2), 0);
}

TEST(CaptureRaster, WhatLiesBeforeThePlaneIsCut) {
    const pipeline::Mesh torus = scene::torus_mesh(24, 12, 0.4);
    const ReliefCamera cut = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 64, 64}, {0, 0, 0.2}, 3);
    const Difference difference = compare(torus, cut, pipeline::Cull::None);
    EXPECT_GT(difference.covered, 300);
    EXPECT_EQ(difference.coverage, 0);
    EXPECT_LT(difference.depth, 1e-4);
}

TEST(CaptureRaster, ColorsAreLitWhenTheSettingsSaySo) {
    const pipeline::Mesh torus = scene::torus_mesh(24, 12, 0.4);
    raster::Scene scene = scene_of(torus);
    scene.models[0].material = {.ambient = 0, .diffuse = 1, .specular = 0, .color = {1, 1, 1}};
    scene.lights.push_back({.kind = pipeline::Light::Kind::Directional, .direction = {{1, 2, -2}}});
    const ReliefTexture lit = *capture_raster(scene, slanted_camera(64), {.shading = raster::Shading::Phong});
    int covered = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            if (!lit.coverage.at(x, y)) continue;
            ++covered;
            const double cosine = glm::dot(glm::dvec3(lit.normal.at(x, y)), glm::dvec3(-1, -2, 2)) / 3;
            EXPECT_NEAR(lit.color.at(x, y).r, std::max(cosine, 0.0), 1e-5);
        }
    EXPECT_GT(covered, 800);
}

TEST(CaptureRaster, RefusesABadCamera) {
    const pipeline::Mesh torus = scene::torus_mesh(8, 6, 0.4);
    ReliefCamera camera = slanted_camera(16);
    camera.width = 0;
    EXPECT_FALSE(capture_raster(scene_of(torus), camera));
    EXPECT_FALSE((RayCapture{MeshSurface{torus}})(camera));
}

// ---------------------------------------------------------------------------------------------- layers

TEST(CaptureRasterLayers, AreWhatPeelingByRaysFinds) {
    const pipeline::Mesh mesh = *scene::torus(40, 20, 0.4);
    const raster::Scene scene = scene_of(mesh);
    const MeshSurface surface{mesh, scene.models[0].material.color};
    const glm::dvec3 toward(-1, -0.1, -0.15);  // through the ring: up to four surfaces
    for (const ReliefCamera& camera :
         {*orthographic_camera({toward, {0, 1, 0}, 48, 48}, -1.6 * toward, 3),
          *perspective_camera({toward, {0, 1, 0}, 48, 48}, -4.0 * toward, 1.5, {42})}) {
        const auto raster = *capture_raster_layers(scene, camera, 4);
        const auto ray = ray_cast_layers(surface, camera, 4);
        ASSERT_EQ(raster.size(), 4u);
        int compared[4] = {}, edge = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_FALSE(refusal(raster[k]));
            for (int y = 0; y < 48; ++y)
                for (int x = 0; x < 48; ++x) {
                    const bool there = raster[k].coverage.at(x, y) != 0;
                    if (there != (ray[k].coverage.at(x, y) != 0)) {
                        ++edge;
                        continue;
                    }
                    if (!there) continue;
                    edge +=
                        std::fabs(double{raster[k].depth.at(x, y)} - double{ray[k].depth.at(x, y)}) > 1e-4;
                    ++compared[k];
                    EXPECT_EQ(raster[k].color.at(x, y), scene.models[0].material.color);
                }
        }
        for (const int count : compared) EXPECT_GT(count, 30);
        EXPECT_LT(edge, 40);  // of more than 2,000: where the border of a triangle passes a texel's centre
    }
}

TEST(CaptureRasterLayers, TheFirstIsTheCapture) {
    const pipeline::Mesh mesh = *scene::torus(40, 20, 0.4);
    const raster::Scene scene = scene_of(mesh);
    const ReliefCamera camera = slanted_camera(64);
    const ReliefTexture one = *capture_raster(scene, camera);
    const ReliefTexture first = capture_raster_layers(scene, camera, 2)->front();
    EXPECT_EQ(one.coverage.pixels(), first.coverage.pixels());
    for (std::size_t i = 0; i < one.depth.pixels().size(); ++i) {
        EXPECT_NEAR(one.depth.pixels()[i], first.depth.pixels()[i], 1e-5);
        EXPECT_EQ(one.color.pixels()[i], first.color.pixels()[i]);
    }
}

}  // namespace
}  // namespace relevo::relief
