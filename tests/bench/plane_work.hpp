// The primitives that the benchmark of the plane draws: random lines, circles, discs and triangles on a
// picture of 1024 x 1024 pixels, one opaque colour each.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/image.hpp"
#include "raster/output.hpp"

namespace relevo::bench {

using Picture = raster::Image<raster::Rgba8>;
inline constexpr int plane_size = 1024;

enum class Kind { Lines, Circles, Discs, Triangles };
inline constexpr const char* kind_names[] = {"lines", "circles", "discs", "triangles"};

// Places are in window coordinates: pixel (i, j) is [i, i + 1) x [j, j + 1), y down.
struct Primitive {
    float x[3], y[3];  // line: two ends; triangle: three corners; circle, disc: the centre
    float radius;
    raster::Rgba8 color;
};

// Always the same sequence. Lines are 1 pixel wide and 2..128 long, radii 2..64, triangles lie in a box of 64
// pixels.
std::vector<Primitive> primitives(Kind kind, int count);

}  // namespace relevo::bench
