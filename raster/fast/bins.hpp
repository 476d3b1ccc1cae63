// Which triangles touch which tile: for each chunk of triangles and each tile a list of ids in drawing order.
//
//   Chunk   lists[tile] -> 15 ids, link -> 127 ids, link -> 127 ids, link ...   one cache line, then eight
//           wide[0], wide[1], ...                     triangles over many tiles: every tile looks at these
//
// A tile draws the lists of all chunks in their order, each merged with its chunk's `wide` ones. Where the
// room for ids ends, they go to `wide`: slower, but nothing is lost and memory is bounded.
#pragma once
#include <cstddef>
#include <cstdint>

#include "raster/fast/draw_state.hpp"

namespace relevo::raster::fast {

// A block of ids and the link to the next one, in words. Few triangles touch most tiles: the first is small.
inline constexpr std::uint32_t first_block = 16, later_block = 128;

struct TileList {
    std::uint32_t first = 0, end = 0;   // words: the first block; where the next id, or the link, goes
    std::uint32_t room = 0, count = 0;  // ids: that fit into the last block; in all
};

struct Chunk {
    std::uint32_t number = 0, first = 0, last = 0;  // primitives first..last-1
    TileList* lists = nullptr;                      // of each tile
    std::uint32_t* words = nullptr;                 // of all blocks
    std::uint32_t word_count = 0, word_capacity = 0;
    const std::uint32_t* wide = nullptr;
    std::uint32_t wide_count = 0;
    Counts counts;
};

// The ids of a tile.
inline std::size_t listed_in(const Chunk* chunks, int count, int tile) {
    std::size_t sum = 0;
    for (const Chunk* chunk = chunks; chunk != chunks + count; ++chunk)
        sum += std::size_t{chunk->lists[tile].count} + chunk->wide_count;
    return sum;
}

// A triangle that may touch more tiles than this is wide.
inline constexpr int max_listed_tiles = 64;

// The rare ways, compiled without any instruction set of their own (draw_fast.cpp).
bool grow_words(Chunk& chunk);  // room for one more block; false: there is no more
void append_wide(Chunk& chunk, std::uint32_t id);
void clip_into_bins(const DrawState& draw, Chunk& chunk, const ModelState& model, std::uint32_t primitive);

[[gnu::always_inline]] inline void append(Chunk& chunk, int tile, std::uint32_t id) {
    TileList& list = chunk.lists[tile];
    if (list.room == 0) {
        const std::uint32_t size = list.count == 0 ? first_block : later_block;
        if (chunk.word_count + size > chunk.word_capacity && !grow_words(chunk))
            return append_wide(chunk, id);
        (list.count == 0 ? list.first : chunk.words[list.end]) = chunk.word_count;
        list.end = chunk.word_count, list.room = size - 1;
        chunk.word_count += size;
    }
    chunk.words[list.end++] = id;
    --list.room, ++list.count;
}

// The triangle may touch the tiles x0..x1 by y0..y1.
[[gnu::always_inline]] inline void append(const DrawState& draw, Chunk& chunk, std::uint32_t id, int x0,
                                          int y0, int x1, int y1) {
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > max_listed_tiles) return append_wide(chunk, id);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) append(chunk, y * draw.tiles_across + x, id);
}

}  // namespace relevo::raster::fast
