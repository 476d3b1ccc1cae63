// Drawings in tests: a picture is rows of text, so that a failed test can be seen.
//
//     EXPECT_TRUE(same_drawing(covered, {"..#.",      on failure:   # right   ! extra   ? missing
//                                        ".##."}));
// And the small scenes that such tests draw, with corners given in pixels or in clip space.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "raster/events.hpp"
#include "raster/scene.hpp"

namespace relevo::tests {

using Drawing = std::vector<std::string>;

inline testing::AssertionResult same_drawing(const Drawing& got, const Drawing& right) {
    if (got == right) return testing::AssertionSuccess();
    testing::AssertionResult failure = testing::AssertionFailure();
    failure << "the drawing differs (# right, ! extra, ? missing, other letters: what was drawn):\n";
    for (std::size_t y = 0; y < std::max(got.size(), right.size()); ++y) {
        const std::string empty, &g = y < got.size() ? got[y] : empty,
                                 &r = y < right.size() ? right[y] : empty;
        for (std::size_t x = 0; x < std::max(g.size(), r.size()); ++x) {
            const char a = x < g.size() ? g[x] : ' ', b = x < r.size() ? r[x] : ' ';
            failure << (a == b ? a : b == '.' || b == ' ' ? '!' : a == '.' || a == ' ' ? '?' : a);
        }
        failure << '\n';
    }
    return failure;
}

// '.' where `empty(pixel)` holds, else what `letter(pixel)` says.
template <class Pixel, class Letter>
Drawing drawing_of(const raster::Image<Pixel>& image, Letter letter) {
    Drawing rows;
    for (int y = 0; y < image.height(); ++y) {
        rows.emplace_back();
        for (int x = 0; x < image.width(); ++x) rows.back() += letter(image.at(x, y));
    }
    return rows;
}
template <class Pixel>
Drawing drawing_of(const raster::Image<Pixel>& image) {
    return drawing_of(image, [](const Pixel& p) { return p == Pixel{} ? '.' : '#'; });
}

inline raster::Frame frame_of(int width, int height, bool with_linear = false) {
    raster::Frame frame{
        raster::Image<raster::Rgba8>(width, height), raster::Image<pipeline::Scalar>(width, height), {}};
    if (with_linear) frame.linear = raster::Image<pipeline::LinearRgb>(width, height);
    return frame;
}

// A flat world whose x and y are pixels (y down) and whose z is the depth, drawn without light. Exact when
// width and height are powers of two.
inline raster::Camera pixel_camera(int width, int height) {
    raster::Camera camera;
    camera.clip_from_eye.m[0][0] = 2.0 / width;
    camera.clip_from_eye.m[1][1] = -2.0 / height;
    camera.clip_from_eye.m[3][0] = -1;
    camera.clip_from_eye.m[3][1] = 1;
    camera.parallel = true;
    return camera;
}

inline raster::Settings unlit() {
    raster::Settings settings;
    settings.shading = raster::Shading::Unlit;
    settings.cull = pipeline::Cull::None;
    settings.output = raster::Output::Raw;
    return settings;
}

inline pipeline::Mesh mesh_of(const std::vector<std::array<pipeline::Vec3, 3>>& triangles) {
    pipeline::Mesh mesh;
    for (const auto& t : triangles)
        for (const pipeline::Vec3& p : t) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back({{p}, {{0, 0, 1}}, {0, 0}});
        }
    return mesh;
}

// One triangle with any corners in clip space: the corners of the mesh are the unit vectors, and the matrix
// moves them there without rounding.
inline pipeline::Mesh unit_corners() { return mesh_of({{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}); }
inline raster::Camera camera_to(const std::array<std::array<double, 4>, 3>& corners) {
    raster::Camera camera;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 4; ++k) camera.clip_from_eye.m[i][k] = corners[std::size_t(i)][std::size_t(k)];
    camera.clip_from_eye.m[3] = {0, 0, 0, 0};
    return camera;
}

// The probe of the tests: how often each pixel was covered, which primitive is seen there, what was dropped
// why; and whatever a test hooks in. One type, so that the watched machine is compiled once (drawing.cpp).
struct Watch {
    raster::Image<int> covered, seen;  // seen: number of the primitive + 1
    int rejected[5] = {0, 0, 0, 0, 0};
    int clipped = 0, snapped = 0, transformed = 0;
    std::function<void(const raster::VertexTransformed&)> on_vertex;
    std::function<void(const raster::TriangleRejected&)> on_rejected;
    std::function<void(const raster::TriangleSnapped&)> on_snapped;
    std::function<void(const raster::DepthTested&)> on_depth;
    std::function<void(const raster::FragmentShaded&)> on_shaded;

    Watch(int width, int height) : covered(width, height), seen(width, height) {}
    int count(raster::Rejection reason) const { return rejected[static_cast<int>(reason)]; }

    void on(const raster::VertexTransformed& e) {
        ++transformed;
        if (on_vertex) on_vertex(e);
    }
    void on(const raster::TriangleRejected& e) {
        ++rejected[static_cast<int>(e.reason)];
        if (on_rejected) on_rejected(e);
    }
    void on(const raster::TriangleClipped&) { ++clipped; }
    void on(const raster::TriangleSnapped& e) {
        ++snapped;
        if (on_snapped) on_snapped(e);
    }
    void on(const raster::FragmentCovered& e) { ++covered.at(e.x, e.y); }
    void on(const raster::DepthTested& e) {
        if (on_depth) on_depth(e);
    }
    void on(const raster::FragmentShaded& e) {
        seen.at(e.x, e.y) = static_cast<int>(e.primitive) + 1;
        if (on_shaded) on_shaded(e);
    }
};

// draw() with a Watch.
void draw_watched(const raster::Scene& scene, const raster::Settings& settings, raster::Frame& frame,
                  Watch& watch);

// Triangles with corners in pixels (x, y) and depth z.
inline Watch watch_pixels(int width, int height, const std::vector<std::array<pipeline::Vec3, 3>>& triangles,
                          raster::Settings settings = unlit()) {
    const pipeline::Mesh mesh = mesh_of(triangles);
    raster::Scene scene;
    scene.models.push_back({&mesh, {}, {}, nullptr, false});
    scene.camera = pixel_camera(width, height);
    scene.background = {0, 0, 0};
    raster::Frame frame = frame_of(width, height);
    Watch watch(width, height);
    draw_watched(scene, settings, frame, watch);
    return watch;
}

}  // namespace relevo::tests
