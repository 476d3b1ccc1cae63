// The end of stage 3: a tile's depth and colour go to the picture, past the caches where the addresses allow:
// a picture is written once and not read again, and ordinary stores would first fetch what they overwrite.
#pragma once
#include <cstdint>

#include "raster/fast/cover_tile.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// `count` numbers of 32 bits: value(k) gives N of them from the k-th on. The tile's memory may be read past
// its end, the picture's row may not be written past it.
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

RELEVO_LANE void write_tile(const DrawState& draw, const TileScratch& scratch, const TileBox& box) {
    const TileMemory& tile = scratch.tile;
    const Nearness nearness{Ints(draw.settings.depth == DepthFormat::Float32Reversed ? 0 : INT32_MIN)};
    for (int y = 0; y < box.height; ++y) {
        const std::size_t at =
            std::size_t(box.y0 + y) * std::size_t(draw.viewport.width) + std::size_t(box.x0);
        const int from = y * tile.stride;
        write_row(reinterpret_cast<std::uint32_t*>(draw.color + at), box.width,
                  [&](int k) { return load(tile.color + from + k); });
        write_row(reinterpret_cast<std::uint32_t*>(draw.depth + at), box.width,
                  [&](int k) { return float_bits(nearness(load(tile.nearness + from + k))); });
        if (draw.visible != nullptr)
            for (int x = 0; x < box.width; ++x) {
                const std::uint32_t number = tile.visible[from + x];
                draw.visible[at + std::size_t(x)] =
                    number == nothing ? nothing : primitive_of(draw, scratch.ids[number]);
            }
    }
}

RELEVO_LANE void write_empty_tile(const DrawState& draw, const TileBox& box) {
    const Ints color(std::bit_cast<std::int32_t>(draw.background8));
    const Ints depth(std::bit_cast<std::int32_t>(cleared_depth(draw.settings.depth)));
    for (int y = 0; y < box.height; ++y) {
        const std::size_t at =
            std::size_t(box.y0 + y) * std::size_t(draw.viewport.width) + std::size_t(box.x0);
        write_row(reinterpret_cast<std::uint32_t*>(draw.color + at), box.width, [&](int) { return color; });
        write_row(reinterpret_cast<std::uint32_t*>(draw.depth + at), box.width, [&](int) { return depth; });
        for (int x = 0; x < box.width; ++x) {
            if (draw.linear != nullptr) draw.linear[at + std::size_t(x)] = draw.background;
            if (draw.visible != nullptr) draw.visible[at + std::size_t(x)] = nothing;
        }
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
