// Which triangles touch which tile: for each chunk of triangles and each tile a list of ids in drawing order.
//
//   Chunk   lists[tile] -> block -> block -> ...      a block: 15 ids and the number of the next block, 64
//   bytes
//           wide[0], wide[1], ...                     triangles over many tiles: every tile looks at these
//
// A tile draws the lists of all chunks in their order, each merged with its chunk's `wide` ones. Where the
// room for blocks ends, ids go to `wide`: slower, but nothing is lost and memory is bounded.
#pragma once
#include <cstdint>

#include "raster/fast/draw_state.hpp"

namespace relevo::raster::fast {

struct Block {
    static constexpr std::uint32_t capacity = 15, none = 0xffffffffu;
    std::uint32_t ids[capacity];
    std::uint32_t next;
};
struct TileList {
    std::uint32_t first = Block::none, last = Block::none;
    std::uint32_t count = 0, in_last = Block::capacity;  // ids in all, in the last block
};

struct Chunk {
    std::uint32_t number = 0, first = 0, last = 0;  // primitives first..last-1
    TileList* lists = nullptr;                      // of each tile
    Block* blocks = nullptr;
    std::uint32_t block_count = 0, block_capacity = 0;
    const std::uint32_t* wide = nullptr;
    std::uint32_t wide_count = 0;
    Counts counts;
};

// A triangle that may touch more tiles than this is wide.
inline constexpr int max_listed_tiles = 64;

// The rare ways, compiled without any instruction set of their own (draw_fast.cpp).
bool grow_blocks(Chunk& chunk);  // false: no more room
void append_wide(Chunk& chunk, std::uint32_t id);
void clip_into_bins(const DrawState& draw, Chunk& chunk, const ModelState& model, std::uint32_t primitive);

[[gnu::always_inline]] inline void append(Chunk& chunk, int tile, std::uint32_t id) {
    TileList& list = chunk.lists[tile];
    if (list.in_last == Block::capacity) {
        if (chunk.block_count == chunk.block_capacity && !grow_blocks(chunk)) return append_wide(chunk, id);
        const std::uint32_t block = chunk.block_count++;
        (list.count == 0 ? list.first : chunk.blocks[list.last].next) = block;
        list.last = block, list.in_last = 0;
    }
    chunk.blocks[list.last].ids[list.in_last++] = id;
    ++list.count;
}

// The triangle may touch the tiles x0..x1 by y0..y1.
[[gnu::always_inline]] inline void append(const DrawState& draw, Chunk& chunk, std::uint32_t id, int x0,
                                          int y0, int x1, int y1) {
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > max_listed_tiles) return append_wide(chunk, id);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) append(chunk, y * draw.tiles_across + x, id);
}

}  // namespace relevo::raster::fast
