// Counts what happens while a scene is drawn: a probe for raster::draw, for `--stats` and for captions.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "raster/events.hpp"
#include "raster/image.hpp"
#include "raster/pixel.hpp"
#include "raster/scene.hpp"
#include "raster/shape_events.hpp"

namespace relevo::scene {

struct Statistics {
    using Count = std::uint64_t;
    Count triangles = 0;  // in the scene: set by statistics_of, no event tells
    Count vertices = 0;   // transformed
    Count clipped = 0;    // triangles that crossed near, far or the guard band and left something
    Count pieces = 0;     // triangles, or pieces of clipped ones, that reached the window with an area
    Count drawn = 0;      // triangles with at least one pixel covered
    Count covered = 0;    // pixels, once for each triangle over them
    Count depth_passed = 0, depth_failed = 0;
    Count shaded = 0;                 // light and texture were computed
    std::array<Count, 5> rejected{};  // by raster::Rejection: triangles, or pieces of clipped ones

    void on(const raster::VertexTransformed&) { ++vertices; }
    void on(const raster::TriangleRejected& event) { ++rejected[static_cast<std::size_t>(event.reason)]; }
    void on(const raster::TriangleClipped&) { ++clipped; }
    void on(const raster::TriangleSnapped&) { ++pieces; }
    void on(const raster::FragmentCovered& event) {
        ++covered;
        if (drawn == 0 || event.primitive != last_drawn) ++drawn, last_drawn = event.primitive;
    }
    void on(const raster::DepthTested& event) { ++(event.passed ? depth_passed : depth_failed); }
    void on(const raster::FragmentShaded&) { ++shaded; }

    Count rejected_for(raster::Rejection reason) const { return rejected[static_cast<std::size_t>(reason)]; }

    std::uint32_t last_drawn = 0;  // the primitive of the last pixel: primitives come one after the other
};

// A fresh probe for drawing this scene.
inline Statistics statistics_of(const raster::Scene& scene) {
    Statistics statistics;
    for (const raster::Model& model : scene.models) statistics.triangles += model.mesh->triangles();
    return statistics;
}

// The same for the shapes of a lesson: a probe for raster::draw_shapes.
struct ShapeStatistics {
    using Count = std::uint64_t;
    Count shapes = 0;     // drawn
    Count refused = 0;    // not drawn: coordinates too large
    Count cut = 0;        // areas and smooth lines that lost or gained corners at the window
    Count gone = 0;       // areas and smooth lines of which the window left nothing
    Count spans = 0;      // runs of equal coverage
    Count painted = 0;    // pixels, once for each shape over them
    Count partly = 0;     // of these: with a coverage below one
    Count lit = 0;        // different pixels of the picture
    double coverage = 0;  // sum over the painted pixels, in pixels: the area of what is drawn

    ShapeStatistics(int width, int height) : seen_(width, height) {}

    void on(const raster::ShapeStarted&) { ++shapes; }
    void on(const raster::ShapeRefused&) { ++refused; }
    void on(const raster::ShapeClipped& event) { ++(event.corners_after == 0 ? gone : cut); }
    void on(const raster::SpanPainted& event) {
        const auto pixels = static_cast<Count>(event.x1 - event.x0);
        ++spans;
        painted += pixels;
        if (event.coverage < raster::full_coverage) partly += pixels;
        coverage += double(pixels) * event.coverage / raster::full_coverage;
        for (int x = event.x0; x < event.x1; ++x)
            if (!std::exchange(seen_.at(x, event.y), std::uint8_t(1))) ++lit;
    }

  private:
    raster::Image<std::uint8_t> seen_;
};

// A count with its name in JSON ("rejected_culled") and in words.
struct NamedCount {
    std::string_view name, words;
    Statistics::Count count;
};
std::vector<NamedCount> named_counts(const Statistics& statistics);
std::vector<NamedCount> named_counts(const ShapeStatistics& statistics);

// {"vertices": 12, ...} on one line, without a line end.
std::string to_json(const std::vector<NamedCount>& counts);

}  // namespace relevo::scene
