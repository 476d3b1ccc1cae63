// What a tile draws: the ids of its lists in drawing order, and the corners of these triangles side by side.
#pragma once
#include <hwy/cache_control.h>

#include <algorithm>

#include "raster/fast/bins.hpp"
#include "raster/fast/corners.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// The ids of a tile in drawing order: chunk after chunk, each list merged with the chunk's wide ones. They
// are written block after block, as they are wanted: the next block is on its way from memory meanwhile.
// After the last there is room for `first_block` more.
class TileIds {
  public:
    RELEVO_LANE TileIds(const DrawState& draw, const Chunk* chunks, int chunk_count, int tile,
                        std::uint32_t* ids)
        : draw_(draw), chunk_(chunks), last_(chunks + chunk_count), tile_(tile), ids_(ids), end_(ids) {
        enter();
    }
    RELEVO_LANE int known() const { return static_cast<int>(end_ - ids_); }
    // Until so many are known, or all.
    RELEVO_LANE void read(int number) {
        while (known() < number && chunk_ != last_) {
            if (chunk_->wide_count > 0)
                read_with_wide();
            else if (left_ > 0)
                read_block();
            if (left_ == 0) ++chunk_, enter();
        }
    }

  private:
    RELEVO_LANE void enter() {
        if (chunk_ == last_) return;
        const TileList& list = chunk_->lists[tile_];
        block_ = chunk_->words + list.first, left_ = list.count, size_ = first_block;
    }
    RELEVO_LANE void read_block() {
        const std::uint32_t taken = std::min(size_ - 1, left_);
        left_ -= taken, size_ = later_block;
        const std::uint32_t* next = block_;
        if (left_ > 0) {
            next = chunk_->words + block_[taken];
            for (std::uint32_t k = 0; k < later_block; k += 16) hwy::Prefetch(next + k);
        }
        for (std::uint32_t k = 0; k < taken; k += lanes) store(load(block_ + k), end_ + k);
        end_ += taken, block_ = next;
    }
    // All of the chunk: the listed ones stand behind room for the wide ones, which then come in between.
    RELEVO_LANE void read_with_wide() {
        std::uint32_t* to = end_;
        const std::uint32_t* listed = end_ += chunk_->wide_count;
        while (left_ > 0) read_block();
        for (std::uint32_t w = 0; w < chunk_->wide_count; ++w) {
            while (listed != end_ && !is_before(draw_, chunk_->wide[w], *listed)) *to++ = *listed++;
            *to++ = chunk_->wide[w];
        }
    }

    const DrawState& draw_;
    const Chunk *chunk_, *last_;
    int tile_;
    std::uint32_t *ids_, *end_;
    const std::uint32_t* block_ = nullptr;         // to be read, and its size in words
    std::uint32_t left_ = 0, size_ = first_block;  // ids of the list
};

// Triangles ahead whose corners are asked for.
inline constexpr int ids_ahead = 32;

// The corners of the first n <= N triangles; they are of any models, whole or pieces. `known`: ids.
// Meanwhile it asks for what later calls will want: the corners stand all over memory, and their numbers,
// too.
RELEVO_LANE GroupCorners load_group(const DrawState& draw, const std::uint32_t* ids, int n, int known) {
    const ModelState* model = &draw.models[0];
    if (draw.models.size() > 1 && !(ids[0] & piece_bit)) model = &draw.models[model_of(draw, ids[0])];
    const std::uint32_t first = model->first_primitive, triangles = model->triangles;
    alignas(64) std::uint32_t number[3][lanes];
    int k = 0;
    for (; k < n; ++k) {
        const std::uint32_t local = ids[k] - first;
        if (local >= triangles) break;
        const std::uint32_t* index = &model->indices[3 * std::size_t{local}];
        for (int c = 0; c < 3; ++c) number[c][k] = index[c];
        if (k + 2 * ids_ahead < known) {
            const std::uint32_t far = ids[k + 2 * ids_ahead] - first;
            if (far < triangles) hwy::Prefetch(&model->indices[3 * std::size_t{far}]);
        }
        if (k + ids_ahead >= known) continue;
        const std::uint32_t later = ids[k + ids_ahead] - first;
        if (later >= triangles) continue;
        index = &model->indices[3 * std::size_t{later}];
        hwy::Prefetch(&model->window[index[0]]), hwy::Prefetch(&model->window[index[2]]);
    }
    if (k == n) {
        for (; k < lanes; ++k)
            for (int c = 0; c < 3; ++c) number[c][k] = 0;
        const auto corners = [&](int c) RELEVO_INSIDE {
            return corner_of(load_quads([&](int lane) RELEVO_INSIDE {
                return reinterpret_cast<const float*>(model->window + number[c][lane]);
            }));
        };
        return {
            corners(0), corners(1), corners(2), model, {load(number[0]), load(number[1]), load(number[2])}};
    }
    alignas(64) SnappedCorner staged[3][lanes]{};
    for (k = 0; k < n; ++k) {
        const std::uint32_t id = ids[k];
        if (id & piece_bit) {
            Piece again;
            const Piece& p = piece(draw, id, again);
            for (int corner = 0; corner < 3; ++corner) copy_corner(p.window[corner], staged[corner][k]);
            continue;
        }
        model = &draw.models[model_of(draw, id)];
        const std::uint32_t* index = &model->indices[3 * (std::size_t{id} - model->first_primitive)];
        for (int corner = 0; corner < 3; ++corner)
            copy_corner(model->window[index[corner]], staged[corner][k]);
    }
    return {load_corners(staged[0]), load_corners(staged[1]), load_corners(staged[2]), nullptr, {}};
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
