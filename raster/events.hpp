// What can be seen while the machine draws: the moments that raster/draw.hpp names, in the order of the
// pipeline.
//
// A primitive is the number of a triangle over all models in their order; the pieces of a clipped triangle
// share it.
#pragma once
#include <cstdint>
#include <span>

#include "pipeline/clip_codes.hpp"
#include "pipeline/color.hpp"
#include "pipeline/cull.hpp"
#include "pipeline/space.hpp"
#include "pipeline/viewport.hpp"

namespace relevo::raster {

// A vertex went through the transforms; once for each vertex, however many triangles share it.
struct VertexTransformed {
    std::uint32_t model, vertex;
    pipeline::Point<pipeline::Object> object;
    pipeline::Point<pipeline::Eye> eye;
    pipeline::HPoint<pipeline::Clip> clip;
    pipeline::ClipCodes codes;
};

enum class Rejection {
    NonFinite,  // a corner with a coordinate that is infinite or not a number
    Outside,    // all of it beyond the view volume's near or far plane or the guard band
    ZeroArea,   // no area after snapping
    Culled,     // faces the wrong way
    NoPixel,    // no pixel centre of the picture in its box
};
struct TriangleRejected {  // a triangle, or a piece of a clipped one, ends here
    std::uint32_t primitive, model;
    Rejection reason;
};
struct TriangleClipped {  // it crossed near, far or the guard band; `polygon` is what is left, at least 3
                          // corners
    std::uint32_t primitive, model;
    pipeline::ClipCodes crossed;
    std::span<const pipeline::HPoint<pipeline::Clip>> polygon;
};
struct TriangleSnapped {  // it has an area in the window; in the mesh's corner order
    std::uint32_t primitive, model;
    const pipeline::SnappedCorner (&corners)[3];
    std::int64_t area2;
    pipeline::Facing facing;
    bool culled;
};
struct FragmentCovered {  // the centre of pixel (x, y) belongs to the triangle
    std::uint32_t primitive;
    int x, y;
};
struct DepthTested {
    std::uint32_t primitive;
    int x, y;
    pipeline::Scalar z, stored;
    bool passed;
};
struct FragmentShaded {  // drawn; a nearer one may replace it later
    std::uint32_t primitive;
    int x, y;
    pipeline::Scalar z, inv_w;
    pipeline::Scalar b0, b1,
        b2;  // perspective-corrected weights of the corners in canonical order (triangle_edge.hpp)
    std::span<const pipeline::Scalar> varying;  // what the shading interpolated (shading.hpp)
    pipeline::LinearRgb color;
};

}  // namespace relevo::raster
