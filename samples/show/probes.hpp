// The probes behind the step pictures: they watch raster::draw and write down what it says. The machine knows
// nothing of them.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/probe.hpp"
#include "raster/events.hpp"
#include "raster/image.hpp"

namespace relevo::show {

using pipeline::Scalar;

struct SeenVertex {
    glm::dvec3 object, eye;
    glm::dvec4 clip;
};
struct SeenFace {  // a triangle, or a piece of a clipped one, in the window
    std::uint32_t primitive, model;
    std::array<pipeline::SnappedCorner, 3> corners;
    pipeline::Facing facing;
    bool culled;
};

// What happens to vertices and triangles.
struct GeometryProbe {
    std::vector<std::vector<SeenVertex>> models;  // the caller gives it one list a model
    std::vector<SeenFace> faces;
    std::array<std::int64_t, 5> rejected{};  // by raster::Rejection
    std::int64_t clipped = 0;                // triangles cut at near, far or the guard band

    void on(const raster::VertexTransformed& e) {
        models[e.model].push_back({glm::dvec3(e.object.v), glm::dvec3(e.eye.v), glm::dvec4(e.clip.v)});
    }
    void on(const raster::TriangleRejected& e) { ++rejected[static_cast<std::size_t>(e.reason)]; }
    void on(const raster::TriangleClipped&) { ++clipped; }
    void on(const raster::TriangleSnapped& e) {
        faces.push_back(
            {e.primitive, e.model, {e.corners[0], e.corners[1], e.corners[2]}, e.facing, e.culled});
    }
};

// What a pixel shows in the end, as Phong shading carries it.
struct SeenPixel {
    static constexpr std::uint32_t nothing = 0xFFFFFFFFu;
    std::uint32_t primitive = nothing;
    std::array<Scalar, 3> weights{}, normal{};
    std::array<Scalar, 2> uv{};
    Scalar inv_w = 0;
    bool textured = false;
    std::int32_t times_shaded = 0;
    bool empty() const { return primitive == nothing; }
};

// What happens to pixels. For attributes the machine must draw with Phong shading.
struct PixelProbe {
    raster::Image<SeenPixel> pixels;  // the caller gives it the picture's size
    std::int64_t covered = 0, passed = 0;

    void on(const raster::FragmentCovered&) { ++covered; }
    void on(const raster::FragmentShaded& e) {
        ++passed;
        SeenPixel& pixel = pixels.at(e.x, e.y);
        ++pixel.times_shaded;
        pixel.primitive = e.primitive, pixel.inv_w = e.inv_w, pixel.weights = {e.b0, e.b1, e.b2};
        pixel.textured = e.varying.size() >= 8;
        if (e.varying.size() >= 6) pixel.normal = {e.varying[3], e.varying[4], e.varying[5]};
        if (pixel.textured) pixel.uv = {e.varying[6], e.varying[7]};
    }
};

// Both at once.
struct RecordingProbe {
    GeometryProbe geometry;
    PixelProbe pixels;

    template <class Event>
    requires pipeline::Wants<GeometryProbe, Event>
    void on(const Event& e) { geometry.on(e); }
    template <class Event>
    requires pipeline::Wants<PixelProbe, Event>
    void on(const Event& e) { pixels.on(e); }
};

}  // namespace relevo::show
