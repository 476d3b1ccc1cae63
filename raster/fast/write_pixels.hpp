// Colours of N pixels into the tile's memory, and into the picture of linear light where somebody asked for
// it.
//
//   fragments   each at a place of its own        p p p p | p p p p | ...
//   a block     4 wide: its lanes are rows of it   0 1 2 3 / 4 5 6 7 / ...
#pragma once
#include "raster/fast/tile_at.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// Where N pixels stand, and which lanes show something.
struct FragmentsTo {
    const std::uint32_t* place;  // in the tile, and above bit 16 anything
    std::uint32_t which;
};
struct BlockTo {
    int row, column;  // of its first pixel
    std::uint32_t which;
};

[[gnu::noinline]] static void write_linear(const TileAt& at, RgbOf<Floats> c, const std::uint32_t* place,
                                           std::uint32_t which) {
    alignas(64) float rgb[3][lanes];
    store(c.r, rgb[0]), store(c.g, rgb[1]), store(c.b, rgb[2]);
    const int stride = at.scratch.tile.stride;
    for (; which != 0; which &= which - 1) {
        const int k = std::countr_zero(which), place_of = static_cast<int>(place[k] & 0xffff);
        *linear_at(at, place_of / stride, place_of % stride) = {rgb[0][k], rgb[1][k], rgb[2][k]};
    }
}

RELEVO_LANE void write_pixels(const TileAt& at, const FragmentsTo& to, Words packed, const RgbOf<Floats>& c) {
    alignas(64) std::uint32_t colors[lanes];
    store(to_whole(packed), colors);
    std::uint32_t* plane = at.scratch.tile.color;
    if (to.which == all_bits) {
        for (int k = 0; k < lanes; ++k) plane[to.place[k] & 0xffff] = colors[k];
    } else {
        for (std::uint32_t rest = to.which; rest != 0; rest &= rest - 1) {
            const int k = std::countr_zero(rest);
            plane[to.place[k] & 0xffff] = colors[k];
        }
    }
    if (at.draw.linear != nullptr) write_linear(at, c, to.place, to.which);
}

// The blocks of a row. What every one needs stands here, in registers: after a store through a pointer the
// compiler would load it again.
struct BlockRow {
    std::uint32_t* colors;
    int row, stride;
    Output output;
    bool linear;

    RELEVO_LANE BlockRow(const TileAt& at, int first_row)
        : colors(at.color_row(first_row)),
          row(first_row),
          stride(at.scratch.tile.stride),
          output(at.draw.settings.output),
          linear(at.draw.linear != nullptr) {}

    RELEVO_LANE void write(const TileAt& at, int column, std::uint32_t which, Words packed,
                           const RgbOf<Floats>& c) const {
        std::uint32_t* first = colors + column;
        Ints all = to_whole(packed);
        if (which != all_bits) all = select(from_bits(which), all, load_block(first, stride));
        store_block(all, first, stride);
        if (!linear) return;
        alignas(64) std::uint32_t place[lanes];
        store((Ints(row) + lane_rows()) * Ints(stride) + Ints(column) + lane_columns(), place);
        write_linear(at, c, place, which);
    }
};
RELEVO_LANE void write_pixels(const TileAt& at, const BlockTo& to, Words packed, const RgbOf<Floats>& c) {
    BlockRow(at, to.row).write(at, to.column, to.which, packed, c);
}

// One or the other.
struct PixelsTo {
    FragmentsTo fragments;  // of a block: nowhere
    BlockTo block;

    PixelsTo() = default;
    RELEVO_LANE PixelsTo(const FragmentsTo& to) : fragments(to), block() {}
    RELEVO_LANE PixelsTo(const BlockTo& to) : fragments(), block(to) {}
};
RELEVO_LANE void write_pixels(const TileAt& at, const PixelsTo& to, Words packed, const RgbOf<Floats>& c) {
    if (to.fragments.place != nullptr)
        write_pixels(at, to.fragments, packed, c);
    else
        write_pixels(at, to.block, packed, c);
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
