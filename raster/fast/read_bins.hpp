// What a tile draws: the ids of its lists in drawing order, and the corners of these triangles side by side.
#pragma once
#include <algorithm>

#include "raster/fast/bins.hpp"
#include "raster/fast/corners.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// Reads the ids of a tile in drawing order: chunk after chunk, each list merged with the chunk's wide ones.
class TileReader {
  public:
    RELEVO_LANE TileReader(const DrawState& draw, const Chunk* chunks, int chunk_count, int tile)
        : draw_(draw), chunk_(chunks), end_(chunks + chunk_count), tile_(tile) {
        open();
    }
    // Fills `ids` with at most `room` ids; 0 at the end.
    RELEVO_LANE int read(std::uint32_t* ids, int room) {
        int n = 0;
        while (n < room && chunk_ != end_) {
            if (listed_ == 0 && wide_ == chunk_->wide_count) {
                ++chunk_;
                open();
                continue;
            }
            if (wide_ < chunk_->wide_count &&
                (listed_ == 0 || is_before(draw_, chunk_->wide[wide_], block_->ids[place_]))) {
                ids[n++] = chunk_->wide[wide_++];
                continue;
            }
            const std::uint32_t in_block = std::min(Block::capacity - place_, listed_);
            const std::uint32_t taken =
                wide_ < chunk_->wide_count ? 1 : std::min(in_block, static_cast<std::uint32_t>(room - n));
            for (std::uint32_t k = 0; k < taken; ++k) ids[n++] = block_->ids[place_++];
            listed_ -= taken;
            if (place_ == Block::capacity && listed_ > 0) block_ = &chunk_->blocks[block_->next], place_ = 0;
        }
        return n;
    }

  private:
    RELEVO_LANE void open() {
        if (chunk_ == end_) return;
        const TileList& list = chunk_->lists[tile_];
        listed_ = list.count, wide_ = 0, place_ = 0;
        if (listed_ > 0) block_ = &chunk_->blocks[list.first];
    }
    const DrawState& draw_;
    const Chunk *chunk_, *end_;
    int tile_;
    const Block* block_ = nullptr;
    std::uint32_t listed_ = 0, wide_ = 0, place_ = 0;
};

inline constexpr int cover_batch = 64;

// Copies the corners of the triangles side by side; they are of any models, whole or pieces.
RELEVO_LANE void stage_corners(const DrawState& draw, const std::uint32_t* ids, int n,
                               SnappedCorner (&staged)[3][cover_batch + 16]) {
    std::uint32_t model_first = 1, model_last = 0;  // of the model at hand: none yet
    const ModelState* model = nullptr;
    for (int k = 0; k < n; ++k) {
        const std::uint32_t id = ids[k];
        if (id & piece_bit) {
            const Piece& p = piece(draw, id);
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
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
