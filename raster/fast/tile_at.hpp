// A tile that is being shaded, and where its colours go.
//
//   color   with kept fragments, or where some is painted: a plane, as large as the tile
//           without: the rows of the blocks at hand
// The background's pixels hold nothing: they get their colour as the row leaves.
#pragma once
#include "raster/fast/draw_state.hpp"
#include "raster/fast/lanes.hpp"
#include "raster/fast/stages.hpp"
#include "raster/fast/write_tile.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// Calls use(Program{}) with the program of the model: textured or not.
template <template <bool> class Program, class Use>
RELEVO_LANE void with_texture(const ModelState& model, Use&& use) {
    model.textured ? use(Program<true>{}) : use(Program<false>{});
}

struct TileAt {
    const DrawState& draw;
    TileScratch& scratch;
    TileBox box;
    int listed = 0;  // ids that are known
    // These two are right once the tile is covered: shading makes a TileAt of its own.
    bool has_plane = scratch.fragments.group_count > 0 || scratch.painted;
    int row_mask = has_plane ? -1 : block_rows - 1;

    RELEVO_LANE int rows_of_blocks() const { return (box.height + block_rows - 1) / block_rows * block_rows; }
    RELEVO_LANE std::uint32_t* color_row(int row) const {
        return scratch.tile.color + (row & row_mask) * scratch.tile.stride;
    }
};

RELEVO_LANE pipeline::LinearRgb* linear_at(const TileAt& at, int row, int column) {
    return at.draw.linear + std::size_t(at.box.y0 + row) * std::size_t(at.draw.viewport.width) + at.box.x0 +
           column;
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
