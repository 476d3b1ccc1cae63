// What a tile draws: the ids of its lists in drawing order, and the corners of these triangles side by side.
#pragma once
#include <hwy/cache_control.h>

#include <algorithm>

#include "raster/fast/bins.hpp"
#include "raster/fast/corners.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// Writes the ids of a tile in drawing order: chunk after chunk, each list merged with the chunk's wide ones.
// Returns their number; after the last there is room for `first_block` more.
RELEVO_LANE int read_list(const DrawState& draw, const Chunk* chunks, int chunk_count, int tile,
                          std::uint32_t* ids) {
    std::uint32_t* end = ids;
    for (const Chunk* chunk = chunks; chunk != chunks + chunk_count; ++chunk) {
        const TileList& list = chunk->lists[tile];
        // the listed ones stand behind room for the wide ones, which then come in between
        const std::uint32_t* listed = end + chunk->wide_count;
        std::uint32_t* to = end + chunk->wide_count;
        const std::uint32_t* block = chunk->words + list.first;
        std::uint32_t size = first_block;
        for (std::uint32_t left = list.count; left > 0; size = later_block) {
            const std::uint32_t taken = std::min(size - 1, left);
            left -= taken;
            const std::uint32_t* next = block;
            if (left > 0) {
                next = chunk->words + block[taken];
                for (std::uint32_t k = 0; k < later_block; k += 16) hwy::Prefetch(next + k);
            }
            for (std::uint32_t k = 0; k < taken; k += lanes) store(load(block + k), to + k);
            to += taken;
            block = next;
        }
        for (std::uint32_t w = 0; w < chunk->wide_count; ++w) {
            while (listed != to && !is_before(draw, chunk->wide[w], *listed)) *end++ = *listed++;
            *end++ = chunk->wide[w];
        }
        end = to;
    }
    return static_cast<int>(end - ids);
}

inline constexpr int cover_batch = 64;

// Copies the corners of the first n triangles side by side; they are of any models, whole or pieces.
// Meanwhile it asks for what a later call will want and, with `carried`, shading: the corners, and what they
// carry, stand all over memory.
template <bool carried>
RELEVO_LANE void stage_corners(const DrawState& draw, const std::uint32_t* ids, int n, int listed,
                               SnappedCorner (&staged)[3][cover_batch + 16]) {
    std::uint32_t model_first = 1, model_last = 0;  // of the model at hand: none yet
    const ModelState* model = nullptr;
    for (int k = 0; k < n; ++k) {
        const std::uint32_t id = ids[k];
        if (id & piece_bit) {
            Piece again;
            const Piece& p = piece(draw, id, again);
            for (int corner = 0; corner < 3; ++corner) copy_corner(p.window[corner], staged[corner][k]);
            continue;
        }
        if (!(model_first <= id && id < model_last)) {
            model = &draw.models[model_of(draw, id)];
            model_first = model->first_primitive, model_last = model_first + model->triangles;
        }
        const std::uint32_t* index = &model->indices[3 * (std::size_t{id} - model_first)];
        for (int corner = 0; corner < 3; ++corner)
            copy_corner(model->window[index[corner]], staged[corner][k]);
        if constexpr (carried)
            for (const int corner : {0, 2})  // two of three are all, in strips and grids
                __builtin_prefetch(model->carried + index[corner] * std::size_t(model->stride), 0, 2);
        if (k + cover_batch >= listed) continue;
        const std::uint32_t later = ids[k + cover_batch];
        if (!(model_first <= later && later < model_last)) continue;
        index = &model->indices[3 * (std::size_t{later} - model_first)];
        hwy::Prefetch(&model->window[index[0]]), hwy::Prefetch(&model->window[index[2]]);
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
