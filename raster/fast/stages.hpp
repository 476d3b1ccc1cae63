// One instruction set's stages, as the driver (draw_fast.cpp) calls them.
#pragma once
#include <cstddef>
#include <cstdint>

#include "raster/fast/bins.hpp"
#include "raster/fast/draw_state.hpp"
#include "raster/fast/fragments.hpp"

namespace relevo::raster::fast {

inline constexpr int max_tile = 128;
struct TileBox {
    int x0, y0, width, height;  // pixels of the picture
};

// Tiles that nothing touches, to be written as background between other work.
struct Background {
    const int* tiles = nullptr;
    int count = 0, row = 0;  // of tiles; of the first one: rows that are written
    TileBox box{};           // of the first one, from its first row on
};

// The memory of one worker for one tile at a time.
struct TileScratch {
    TileMemory tile;
    std::uint32_t* ids = nullptr;   // the tile's list; room for first_block ids more
    std::byte* kept = nullptr;      // set-ups of triangles for shading, kept_bytes
    std::byte* waiting = nullptr;   // pixels that wait for light, waiting_bytes
    std::byte* painting = nullptr;  // a triangle's strips that wait for their colours, painting_bytes
    Background background{};        // is empty when the tile is done
    Fragments fragments{};
    bool painted = false;   // some of the tile is coloured before the rest is shaded
    bool in_blocks = true;  // whether triangles are drawn whose fragments are not kept
};
inline constexpr std::size_t kept_triangles = 2048, kept_bytes = kept_triangles * 256,
                             waiting_bytes = 25 << 10, painting_bytes = 137 << 10;

struct Stages {
    // Vertices first..last-1 of a model, `first` a multiple of 16: window and carried numbers.
    void (*transform)(const ModelState& model, const pipeline::Viewport& viewport, std::uint32_t first,
                      std::uint32_t last);
    // The chunk's triangles into its lists.
    void (*bin)(const DrawState& draw, Chunk& chunk);
    // A tile, from its lists to the picture. Returns the number of shaded pixels.
    std::uint64_t (*draw_tile)(const DrawState& draw, const Chunk* chunks, int chunk_count,
                               TileScratch& scratch, int tile);
};

extern const Stages stages_sse4, stages_avx2, stages_avx512;

}  // namespace relevo::raster::fast
