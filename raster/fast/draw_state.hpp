// What the stages of the fast path hand to each other. No algorithm here; plain arrays only, because the
// stages are compiled once for each instruction set.
//
//   mesh --transform--> window, carried --bin--> lists of each tile --tile--> depth, visible --shade-->
//   colour
//
// A triangle is known by one number, its `id`:
//   0 .. 2^31-1             primitive: the number of a triangle over all models in their order
//   2^31 + chunk, index     piece: what clipping made of one (bits 25..30: chunk, bits 0..24: index in it)
//   2^32-1                  nothing: the background
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>

#include "pipeline/cull.hpp"
#include "pipeline/mesh.hpp"
#include "pipeline/transform.hpp"
#include "pipeline/viewport.hpp"
#include "raster/depth.hpp"
#include "raster/events.hpp"
#include "raster/model_setup.hpp"
#include "raster/scene.hpp"
#include "raster/shading.hpp"

namespace relevo::raster::fast {

using pipeline::Facing;
using pipeline::Scalar;
using pipeline::SnappedCorner;

inline constexpr std::uint32_t nothing = 0xffffffffu, piece_bit = 0x80000000u;
inline constexpr int piece_index_bits = 25, max_chunks = 64;
inline constexpr std::uint32_t max_chunk_triangles = 1u << 20;  // at most 30 pieces each: fits 25 bits
inline constexpr int max_carried = 8;                           // numbers that a corner carries at most

// One model in one shading program. `window` and `carried` have an entry for each vertex:
//
//   window   x y z rw | x y z rw | ...     16 bytes a vertex; with a clip code: rw = 0, x = code
//   carried  a0 .. a3 [a4 .. a7] | ...     `stride` floats a vertex (0, 4 or 8), of which `size` count:
//                                          raster/shading.hpp's corner(), towards the front
struct ModelState {
    std::span<const pipeline::Vertex> vertices;
    std::span<const std::uint32_t> indices;
    std::uint32_t number = 0, first_primitive = 0, triangles = 0;
    ModelSetup setup;
    Shading shading = Shading::Unlit;
    bool textured = false;
    int size = 0, stride = 0;
    SnappedCorner* window = nullptr;
    Scalar* carried = nullptr;
};

// A piece of a clipped triangle, in the order of its polygon's fan; `carried` already belongs to the side
// that is seen.
struct Piece {
    SnappedCorner window[3];
    Scalar carried[3][max_carried];
};
struct PieceName {
    std::uint32_t primitive, part;  // the number of the piece in its polygon's fan
};
// The pieces that a chunk made. Only so many are kept: the rest is clipped again when it is asked for.
struct Pieces {
    std::span<const PieceName> names;
    std::span<const Piece> kept;  // the first of them
};

// Everything about a picture that the stages read.
struct DrawState {
    std::span<const ModelState> models;
    std::span<const Pieces> pieces;  // of each chunk
    Settings settings;
    pipeline::Viewport viewport{};
    int tile = 128;  // pixels a side: 32, 64 or 128
    int tiles_across = 0, tiles_down = 0;
    pipeline::LinearRgb background;
    Rgba8 background8;
    Rgba8* color = nullptr;  // rows of viewport.width pixels
    Scalar* depth = nullptr;
    pipeline::LinearRgb* linear = nullptr;  // null: nobody asked
    std::uint32_t* visible = nullptr;       // primitive of each pixel; null: nobody asked
    bool paints = false;                    // can_be_painted()
};

inline const Pieces& pieces_of(const DrawState& draw, std::uint32_t id) {
    return draw.pieces[(id & ~piece_bit) >> piece_index_bits];
}
inline std::uint32_t piece_index(std::uint32_t id) { return id & ((1u << piece_index_bits) - 1); }
inline std::uint32_t primitive_of(const DrawState& draw, std::uint32_t id) {
    return id & piece_bit ? pieces_of(draw, id).names[piece_index(id)].primitive : id;
}
Piece clipped_piece(const DrawState& draw, const PieceName& name);  // draw_fast.cpp
// `again` is room for a piece that is not kept.
inline const Piece& piece(const DrawState& draw, std::uint32_t id, Piece& again) {
    const Pieces& pieces = pieces_of(draw, id);
    if (piece_index(id) < pieces.kept.size()) return pieces.kept[piece_index(id)];
    again = clipped_piece(draw, pieces.names[piece_index(id)]);
    return again;
}
// Whether triangle `a` is drawn before `b`: at equal depth it is seen.
inline bool is_before(const DrawState& draw, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t p = primitive_of(draw, a), q = primitive_of(draw, b);
    return p != q ? p < q : a < b;
}
inline std::uint32_t model_of(const DrawState& draw, std::uint32_t primitive) {
    std::uint32_t m = static_cast<std::uint32_t>(draw.models.size()) - 1;
    while (m > 0 && primitive < draw.models[m].first_primitive) --m;
    return m;
}

// Every pixel that anything covers has the same colour, and nobody asks which triangle it shows.
inline bool shows_one_color(const DrawState& draw) {
    return draw.settings.shading == Shading::Unlit && draw.models.size() == 1 && !draw.models[0].textured &&
           draw.linear == nullptr && draw.visible == nullptr;
}

// Every pixel can be coloured as soon as it is seen (paint_triangles.hpp).
inline bool can_be_painted(const DrawState& draw) {
    const auto textured = [](const ModelState& model) { return model.textured; };
    return (draw.settings.shading == Shading::Flat || draw.settings.shading == Shading::Gouraud) &&
           draw.linear == nullptr && draw.visible == nullptr &&
           std::none_of(draw.models.begin(), draw.models.end(), textured);
}

// The memory of one tile, of one worker. Rows are `stride` long: a register may reach past the tile's end.
//
//   nearness  of each pixel: its depth, with the sign turned when forward depth is drawn: greater is nearer
//   visible   of each pixel: the triangle that is seen, by its place in the tile's list (and kept_bit:
//             fragments.hpp); nothing while the tile is painted; null where all triangles have one colour,
//             and depth alone tells what is covered
//   color     of each pixel, or of the few rows that are being shaded (tile_at.hpp)
struct TileMemory {
    int stride = 0;
    Scalar* nearness = nullptr;
    std::uint32_t* visible = nullptr;
    std::uint32_t* color = nullptr;
};

// How many of each; the same as a probe counts on the textbook path.
struct Counts {
    std::uint64_t vertices = 0, triangles = 0, rejected[5] = {}, clipped = 0, shaded_pixels = 0;
};

}  // namespace relevo::raster::fast
