// The end of stage 3: depth and colour go to the picture, past the caches where the addresses allow: a
// picture is written once and not read again, and ordinary stores would first fetch what they overwrite.
//
// Memory takes such lines in its own time. So rows leave as soon as they are shaded, and tiles that nothing
// touches are written a row at a time between other work: the core computes while memory is busy.
#pragma once
#include <algorithm>
#include <cstdint>

#include "raster/fast/draw_state.hpp"
#include "raster/fast/lanes.hpp"
#include "raster/fast/stages.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

RELEVO_LANE TileBox tile_box(const DrawState& draw, int number) {
    const int x0 = number % draw.tiles_across * draw.tile, y0 = number / draw.tiles_across * draw.tile;
    return {x0, y0, std::min(draw.tile, draw.viewport.width - x0),
            std::min(draw.tile, draw.viewport.height - y0)};
}

// How depths compare: forward depths turn their sign, so that greater is nearer.
struct Nearness {
    Ints flip;
    RELEVO_LANE Floats operator()(Floats z) const { return bits_float(float_bits(z) ^ flip); }
};
RELEVO_LANE Nearness nearness_of(const DrawState& draw) {
    return {Ints(draw.settings.depth == DepthFormat::Float32Reversed ? 0 : INT32_MIN)};
}

// Of a pixel that nothing covers: less than that of any triangle.
RELEVO_LANE Floats cleared_nearness(const DrawState& draw) {
    return Floats(draw.settings.depth == DepthFormat::Float32Reversed ? 0.f : -1.f);
}

// `count` numbers of 32 bits: value(k) gives N of them from the k-th on. What value() reads may lie past the
// count, the picture's row may not be written past it.
template <class Value>
RELEVO_LANE void write_row(std::uint32_t* to, int count, Value&& value) {
    constexpr std::uintptr_t line =
        64;  // a cache line: streaming a part of one is far slower than storing it
    const int before = static_cast<int>((line - reinterpret_cast<std::uintptr_t>(to) % line) % line / 4);
    const auto part = [&](int k, int n) {  // n <= N numbers
        alignas(64) std::uint32_t some[lanes];
        store(value(k), some);
        for (int i = 0; i < n; ++i) to[k + i] = some[i];
    };
    const int head = before < count ? before : count;
    for (int k = 0; k < head; k += lanes) part(k, head - k < lanes ? head - k : lanes);
    int k = head;
    constexpr int in_line = line / 4;
    for (; k + in_line <= count; k += in_line)
        for (int i = 0; i < in_line; i += lanes) stream(value(k + i), to + k + i);
    for (; k < count; k += lanes) part(k, count - k < lanes ? count - k : lanes);
}

// Row y of the tile; its colours by color(k).
template <class Color>
RELEVO_LANE void write_tile_row(const DrawState& draw, const TileScratch& scratch, const TileBox& box, int y,
                                Color&& color) {
    const Nearness nearness = nearness_of(draw);
    const std::size_t at = std::size_t(box.y0 + y) * std::size_t(draw.viewport.width) + std::size_t(box.x0);
    const int from = y * scratch.tile.stride;
    write_row(reinterpret_cast<std::uint32_t*>(draw.color + at), box.width, color);
    const float* near = scratch.tile.nearness + from;
    write_row(reinterpret_cast<std::uint32_t*>(draw.depth + at), box.width,
              [=](int k) { return float_bits(nearness(load(near + k))); });
    for (int x = 0; draw.visible != nullptr && x < box.width; ++x) {
        const std::uint32_t number = scratch.tile.visible[from + x];
        draw.visible[at + std::size_t(x)] =
            number == nothing ? nothing : primitive_of(draw, scratch.ids[number & ~kept_bit]);
    }
}

// The next row of the tiles that nothing touches, if there is one.
RELEVO_LANE void write_background_row(const DrawState& draw, Background& background) {
    if (background.count == 0) return;
    if (background.row == 0) background.box = tile_box(draw, *background.tiles);
    const TileBox& box = background.box;
    const Ints color(std::bit_cast<std::int32_t>(draw.background8));
    const Ints depth(std::bit_cast<std::int32_t>(cleared_depth(draw.settings.depth)));
    const std::size_t at =
        std::size_t(box.y0 + background.row) * std::size_t(draw.viewport.width) + std::size_t(box.x0);
    write_row(reinterpret_cast<std::uint32_t*>(draw.color + at), box.width, [&](int) { return color; });
    write_row(reinterpret_cast<std::uint32_t*>(draw.depth + at), box.width, [&](int) { return depth; });
    for (int x = 0; x < box.width; ++x) {
        if (draw.linear != nullptr) draw.linear[at + std::size_t(x)] = draw.background;
        if (draw.visible != nullptr) draw.visible[at + std::size_t(x)] = nothing;
    }
    if (++background.row == box.height) background.row = 0, ++background.tiles, --background.count;
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
