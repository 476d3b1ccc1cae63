// Meshes straight to the screen, boxes of six faces, exchanged roles, unseen triangles.
#include "relief/box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "relief/capture_raster.hpp"
#include "relief/role_swap.hpp"
#include "relief/surface_mesh.hpp"
#include "relief/surface_plane_step.hpp"
#include "relief/unseen.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "samples/scene/shapes/torus.hpp"
#include "tests/relief/image_experiment.hpp"

namespace relevo::relief {
namespace {

using tests::experiment_source;
using tests::experiment_viewer;

const Box unit_box{{-1, -1, -1}, {1, 1, 1}};

ReliefCamera viewer_round(double azimuth, double elevation, int size, double distance = 3.2) {
    using pipeline::Degrees;
    const Degrees a{azimuth}, e{elevation};
    const glm::dvec3 eye = distance * glm::dvec3(sin(a) * cos(e), sin(e), cos(a) * cos(e));
    return *perspective_camera({-eye, {0, 1, 0}, size, size}, eye, 1, {45});
}

// ---------------------------------------------------------------------------------------------- mesh
TEST(ViewMesh, APerspectiveSourceSeenFromItsOwnEyeIsItself) {
    const ReliefCamera source =
        *perspective_camera({{0.2, -0.1, -1}, {0, 1, 0}, 64, 64}, {-0.6, 0.3, 3}, 1.5, {42});
    const ReliefTexture texture = ray_cast(scene::complex_object, source);
    for (const double jump : {0.05, 1e9}) {
        ViewImage image(64, 64);
        draw_view_mesh(texture, source, jump, image);
        const ErrorSet error = error_set(image, as_seen(texture));
        EXPECT_EQ(error.missing_percent, 0);
        EXPECT_LT(error.extra_percent, 4);  // borders are half a texel wide, and snapped
        EXPECT_LT(error.mean_depth_error, 2e-3);
    }
}

TEST(ViewMesh, AFlatReliefIsAPlaneWhereverItIsSeenFrom) {
    const ReliefTexture texture =
        ray_cast(PlaneStep{1e-9}, *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 64, 64}, {0, 0, 0.5}, 2));
    const ReliefCamera viewer = viewer_round(50, 20, 96);
    ViewImage image(96, 96);
    draw_view_mesh(texture, viewer, 0.1, image, 7);
    const ViewImage truth = ray_cast_view(PlaneStep{1e-9}, viewer);
    int differ = 0, covered = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            differ += (image.coverage.at(x, y) != 0) != (truth.coverage.at(x, y) != 0);
            if (!image.coverage.at(x, y) || !truth.coverage.at(x, y)) continue;
            ++covered;
            EXPECT_EQ(image.coverage.at(x, y), 7);
            EXPECT_NEAR(image.depth.at(x, y), truth.depth.at(x, y), 3e-3);  // snapped to 1/256 pixel
        }
    EXPECT_GT(covered, 1000);
    EXPECT_LT(differ, 4);
    ViewImage behind(96, 96);
    draw_view_mesh(texture, viewer_round(180, 0, 96), 0.1, behind);
    EXPECT_EQ(std::count(behind.coverage.pixels().begin(), behind.coverage.pixels().end(), 0), 96 * 96);
    draw_view_mesh(texture, viewer_round(180, 0, 96), 0.1, behind, 1, Sides::Both);
    EXPECT_GT(std::count(behind.coverage.pixels().begin(), behind.coverage.pixels().end(), 1), 3000);
}

TEST(ViewMesh, TheNearestOfTwoTexturesWinsInAnyOrder) {
    const ReliefTexture one = ray_cast(scene::bumpy_object, experiment_source(64));
    const Spheres aside{{{{0.5, 0.2, -0.9}, 0.4}}};
    const ReliefTexture two =
        ray_cast(aside, *orthographic_camera({{-1, 0, 0.5}, {0, 1, 0}, 64, 64}, {1, 0, -1.2}, 2));
    const ReliefCamera viewer = experiment_viewer(30, 128);
    ViewImage first(128, 128), second(128, 128);
    draw_view_mesh(one, viewer, 0.1, first, 1), draw_view_mesh(two, viewer, 0.1, first, 2);
    draw_view_mesh(two, viewer, 0.1, second, 2), draw_view_mesh(one, viewer, 0.1, second, 1);
    EXPECT_EQ(first.coverage.pixels(), second.coverage.pixels());
    EXPECT_EQ(first.depth.pixels(), second.depth.pixels());
    EXPECT_GT(std::count(first.coverage.pixels().begin(), first.coverage.pixels().end(), 2), 300);
}

TEST(ViewMesh, ASkinIsDrawnOrCut) {
    const ReliefTexture texture =
        ray_cast(PlaneStep{0.5}, *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 64, 64}, {0, 0, 0.5}, 2));
    const ReliefCamera viewer = viewer_round(-40, 0, 128, 4);  // looks at the riser
    const ViewImage truth = ray_cast_view(PlaneStep{0.5}, viewer);
    ViewImage skin(128, 128), cut(128, 128);
    draw_view_mesh(texture, viewer, 1, skin), draw_view_mesh(texture, viewer, 0.1, cut);
    const ErrorSet with_skin = error_set(skin, truth), with_cut = error_set(cut, truth);
    EXPECT_LT(with_skin.missing_percent, 0.5);
    EXPECT_GT(with_cut.missing_percent, 8);
}

// ---------------------------------------------------------------------------------------------- box
TEST(Box, TheSixFacesOfACubeAreItsSides) {
    std::set<std::array<int, 3>> directions;
    for (const Face face : all_faces) {
        const ReliefCamera camera = *face_camera({{-1, -2, -3}, {1, 2, 3}}, face, 60);
        const glm::dvec3 f = forward(camera),
                         middle = plane_point(camera, camera.width / 2.0, camera.height / 2.0);
        const double half = 1 + axis_of(face);
        glm::dvec3 outwards(0);
        outwards[axis_of(face)] = sign_of(face);
        EXPECT_LT(glm::length(f + outwards), 1e-12);
        EXPECT_LT(glm::length(middle - half * outwards), 1e-12);
        EXPECT_NEAR(glm::length(camera.a), 0.1, 1e-12);
        const int sides[3] = {20, 40, 60};  // texels along x, y, z
        EXPECT_EQ(camera.width * camera.height, 20 * 40 * 60 / sides[axis_of(face)]);
        EXPECT_LT(glm::dot(camera.b, glm::dvec3(0, 1, axis_of(face) == 1 ? -outwards.y : 0)), 1e-12);
        directions.insert({int(f.x), int(f.y), int(f.z)});
    }
    EXPECT_EQ(directions.size(), 6u);
}

TEST(Box, SpaceHasTwentySixRegionsRoundIt) {
    std::set<int> numbers;
    int faces[4] = {0, 0, 0, 0};
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 viewer(2 * (i % 3) - 2, 2 * (i / 3 % 3) - 2, 2 * (i / 9) - 2);
        const BoxRegion region = box_region(unit_box, viewer);
        numbers.insert(region.number());
        ++faces[region.faces()];
        for (const Face face : all_faces) {  // shown: in front of the face's plane
            const ReliefCamera camera = *face_camera(unit_box, face, 8);
            EXPECT_EQ(region.shows(face), glm::dot(camera.corner - viewer, forward(camera)) > 0);
        }
    }
    EXPECT_EQ(numbers.size(), 27u);
    EXPECT_EQ(faces[0], 1);
    EXPECT_EQ(faces[1], 6);
    EXPECT_EQ(faces[2], 12);
    EXPECT_EQ(faces[3], 8);
    EXPECT_EQ(box_region(unit_box, {0, 0, 0}).number(), 13);
}

TEST(Box, ShowsConvexObjectsFromEverySide) {
    struct Row {
        const char* name;
        const Spheres* object;
        double missing, psnr;
    };
    for (const auto& [name, object, missing, psnr] :
         {Row{"sphere", &scene::sphere_object, 0.05, 30}, Row{"bumpy", &scene::bumpy_object, 0.05, 23.5}}) {
        const BoxRelief box = *capture_box(RayCapture{*object}, unit_box, 192);
        double most_missing = 0, most_extra = 0, least_psnr = 1e9;
        for (const double elevation : {0.0, 60.0, -60.0})
            for (double azimuth = 0; azimuth < 360; azimuth += 45) {
                const ReliefCamera viewer = viewer_round(azimuth, elevation, 256);
                const ErrorSet error = error_set(draw_box(box, viewer), ray_cast_view(*object, viewer));
                most_missing = std::max(most_missing, error.missing_percent);
                most_extra = std::max(most_extra, error.extra_percent);
                least_psnr = std::min(least_psnr, error.psnr);
            }
        std::printf(
            "%s, a full turn at three elevations: missing at most %.3f %%, extra %.2f %%, PSNR at least "
            "%.2f dB\n",
            name, most_missing, most_extra, least_psnr);
        EXPECT_LT(most_missing, missing);  // 1 % is asked for
        EXPECT_LT(most_extra, 1.2);
        EXPECT_GT(least_psnr, psnr);
    }
}

TEST(Box, ByDepthIsRightWhereTheOrderOfFacesIsNot) {
    const BoxRelief box = *capture_box(RayCapture{scene::complex_object}, unit_box, 128);
    double by_depth = 0, by_order = 0;
    for (const double azimuth : {0.0, 35.0, 80.0, 200.0}) {
        const ReliefCamera viewer = viewer_round(azimuth, 25, 200);
        const ViewImage truth = ray_cast_view(scene::complex_object, viewer);
        by_depth += error_set(draw_box(box, viewer), truth).bad_percent / 4;
        by_order += error_set(draw_box(box, viewer, {0.1, Composite::FaceOrder}), truth).bad_percent / 4;
    }
    std::printf("complex: bad pixels by depth %.2f %%, in the order of faces %.2f %%\n", by_depth, by_order);
    EXPECT_LT(by_depth, 12);
    EXPECT_GT(by_order, 1.4 * by_depth);
}

TEST(Box, TheLabelsSayWhichFaceWasSeen) {
    const BoxRelief box = *capture_box(RayCapture{scene::sphere_object}, unit_box, 64);
    const ViewImage image = draw_box(box, viewer_round(45, 0, 64));
    const auto label = [](Face face) { return 1 + static_cast<int>(face); };
    EXPECT_EQ(image.coverage.at(12, 32), label(Face::Front));
    EXPECT_EQ(image.coverage.at(52, 32), label(Face::Right));
    // In the order of faces the one seen most frontally overwrites the other where both have something.
    for (const auto& [azimuth, last] : {std::pair(35.0, Face::Front), {55.0, Face::Right}}) {
        const ViewImage ordered = draw_box(box, viewer_round(azimuth, 0, 64), {0.1, Composite::FaceOrder});
        EXPECT_EQ(ordered.coverage.at(32, 32), label(last));
    }
}

// ---------------------------------------------------------------------------------------------- roles
TEST(RoleSwap, IsTheClosedFormOfLeftAndRightFaces) {
    // The front face looks along +z: a = x, b = y; the left one along a, its columns along f.
    ReliefCamera front, left, right;
    front.corner = {-1, -1, -1}, front.a = {0.02, 0, 0}, front.b = {0, 0.03, 0};
    left.corner = front.corner, left.a = {0, 0, 0.05}, left.b = front.b;
    right = left, right.corner = front.corner + 100.0 * front.a;
    front.width = 100, front.height = 60, left.width = right.width = 40, left.height = right.height = 60;
    left.corner += 40.0 * left.a, left.a = -left.a;  // so that it looks along +x
    EXPECT_LT(glm::length(forward(left) - glm::dvec3(1, 0, 0)), 1e-12);
    EXPECT_LT(glm::length(forward(right) - glm::dvec3(-1, 0, 0)), 1e-12);
    double worst = 0;
    for (const double u : {0.5, 13.25, 39.5})
        for (const double v : {0.5, 30.75})
            for (const Scalar d : {Scalar(0), Scalar(0.375), Scalar(1.5)}) {
                const double texels = double{d} / 0.02;
                worst = std::max(worst, glm::length(role_swap(front, left)(u, v, Displacement{d}) -
                                                    glm::dvec3(texels, v, (40 - u) * 0.05)));
                worst = std::max(worst, glm::length(role_swap(front, right)(u, v, Displacement{d}) -
                                                    glm::dvec3(100 - texels, v, u * 0.05)));
            }
    EXPECT_LT(worst, 1e-11);
}

TEST(RoleSwap, NamesTheSamePointOfTheWorldForEveryPairOfFaces) {
    const Box box{{-1, -2, -0.5}, {1.5, 1, 2}};
    for (const Face carrier : all_faces)
        for (const Face face : all_faces) {
            const ReliefCamera to = *face_camera(box, carrier, 50), from = *face_camera(box, face, 70);
            const RoleSwap swap = role_swap(to, from);
            const glm::dvec3 p = swap(12.5, 33.25, Displacement{Scalar(0.375)});
            const glm::dvec3 world = plane_point(to, p.x, p.y) + p.z * forward(to);
            EXPECT_LT(glm::length(world - world_point(from, 12.5, 33.25, Displacement{Scalar(0.375)})),
                      1e-12);
        }
}

// ---------------------------------------------------------------------------------------------- unseen
TEST(Unseen, TheInsideOfABowlBehindItsRimIsSeenByNoFace) {
    const pipeline::Mesh torus = scene::torus_mesh(24, 16, 0.4);
    raster::Scene scene;
    scene.models.emplace_back().mesh = &torus;
    std::vector<ReliefCamera> cameras;
    const Box box{{-1.4, -1.4, -0.4}, {1.4, 1.4, 0.4}};
    for (const Face face : all_faces) cameras.push_back(*face_camera(box, face, 256));
    const auto unseen = [&](std::size_t count) {
        const auto seen = seen_triangles(scene, std::span(cameras).first(count));
        return std::count(seen.begin(), seen.end(), 0);
    };
    // Along the ring's axis all but the triangles edge-on to it are seen; from the sides the outer half is.
    const auto all = unseen(6), sides = unseen(4);
    EXPECT_EQ(torus.triangles(), 24u * 16 * 2);
    EXPECT_EQ(all, 0);
    EXPECT_GT(sides, static_cast<std::ptrdiff_t>(torus.triangles() / 4));
    EXPECT_EQ(unseen(0), static_cast<std::ptrdiff_t>(torus.triangles()));
    // A second, smaller ring round the first one's tube hides in its hole from the sides; a wall closes it.
    pipeline::Mesh hidden = scene::torus_mesh(12, 8, 0.2);
    for (pipeline::Vertex& v : hidden.vertices) v.position.v *= Scalar(0.3);
    pipeline::Mesh lid;
    for (const double z : {0.4, -0.4})
        for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            lid.vertices.push_back({{Vec3(x, y, z)}, {{0, 0, 1}}});
    lid.indices = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6};
    scene.models.emplace_back().mesh = &hidden;
    scene.models.emplace_back().mesh = &lid;
    const auto seen = seen_triangles(scene, cameras);
    const auto first = seen.begin() + static_cast<std::ptrdiff_t>(torus.triangles());
    EXPECT_EQ(std::count(first, first + static_cast<std::ptrdiff_t>(hidden.triangles()), 1), 0);
    EXPECT_EQ(std::count(seen.end() - 4, seen.end(), 1), 4);
}

}  // namespace
}  // namespace relevo::relief
