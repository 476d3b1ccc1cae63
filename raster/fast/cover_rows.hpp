// Coverage and depth of one triangle in one tile: a pixel a lane, row after row.
//
// Depth needs the edge values in double, where every one (below 2^49) is exact. Coverage asks for their signs
// only: in int32 where they fit (max_small_extent), else in double; and not at all where no edge crosses the
// part of the box at hand. Of large triangles only, whose rows are long, parts and pixels that the triangle
// does not touch are passed over: in short rows a branch for that is guessed wrong too often.
#pragma once
#include <algorithm>

#include "raster/fast/corners.hpp"
#include "raster/fast/write_tile.hpp"
#include "raster/interpolate.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// The set-up of N triangles, for the rows of one of them to read.
struct StoredSetup {
    alignas(64) double z0[lanes], g1[lanes], g2[lanes], area[lanes];
    std::int32_t x0[lanes], y0[lanes], x1[lanes], y1[lanes];  // box, within the tile
    std::int32_t left[lanes], above[lanes];                   // corner 0 to the first centre of the box
    std::int32_t dx1[lanes], dy1[lanes], dx2[lanes], dy2[lanes];
    std::int32_t bias0[lanes], bias1[lanes], bias2[lanes];
};

// How the pixels of a box are found to be covered.
enum class Cover {
    Int,     // edge values in int32
    Double,  // edge values in double
    All,     // no edge crosses it
};

// A part of a triangle's box, and the edge values at its first pixel.
struct BoxPart {
    int x0, y0, x1, y1;  // within the tile
    double e1, e2;
};

// Rows of one triangle, a pixel a lane.
template <Cover cover>
RELEVO_LANE void cover_rows(const StoredSetup& s, int k, const BoxPart& box, std::uint32_t number,
                            const Nearness& nearness, const TileMemory& tile) {
    const Interpolator plane{s.z0[k], s.g1[k], s.g2[k], 0, 0, 0};
    const double step1 = 256.0 * s.dy2[k], step2 = -256.0 * s.dy1[k];
    const Doubles across1(lanes * step1), across2(lanes * step2), down1(-256.0 * s.dx2[k]),
        down2(256.0 * s.dx1[k]);
    const Doubles lane = to_wide(lane_numbers());
    Doubles row1 = Doubles(box.e1) + lane * Doubles(step1), row2 = Doubles(box.e2) + lane * Doubles(step2);

    // int32: values less their bias, so that covered means none is negative
    const Ints bias0(s.bias0[k]), bias1(s.bias1[k]), bias2(s.bias2[k]);
    const Doubles area = s.area[k], wide_bias0 = to_wide(bias0), wide_bias1 = to_wide(bias1),
                  wide_bias2 = to_wide(bias2);
    const auto as_int = [](std::int32_t d) { return cover == Cover::Int ? 256 * d : 0; };
    const std::int32_t i_step1 = as_int(s.dy2[k]), i_step2 = -as_int(s.dy1[k]);
    const Ints i_across1(lanes * i_step1), i_across2(lanes * i_step2), i_down1(-as_int(s.dx2[k])),
        i_down2(as_int(s.dx1[k]));
    Ints i_row0{}, i_row1{}, i_row2{};
    if constexpr (cover == Cover::Int) {
        const Ints e1 = Ints(static_cast<std::int32_t>(box.e1)) + lane_numbers() * Ints(i_step1),
                   e2 = Ints(static_cast<std::int32_t>(box.e2)) + lane_numbers() * Ints(i_step2);
        i_row1 = e1 - bias1, i_row2 = e2 - bias2;
        i_row0 = Ints(static_cast<std::int32_t>(s.area[k])) - e1 - e2 - bias0;
    }

    const Ints numbers(static_cast<std::int32_t>(number));
    const int columns = box.x1 - box.x0 + 1, rows = box.y1 - box.y0 + 1;
    const Bools last_columns = first_lanes((columns - 1) % lanes + 1);
    float* near_row = tile.nearness + box.y0 * tile.stride + box.x0;
    const bool keeps_visible = tile.visible != nullptr;
    std::uint32_t* visible_row = keeps_visible ? tile.visible + box.y0 * tile.stride + box.x0 : nullptr;
    for (int y = 0; y < rows; ++y) {
        Doubles e1 = row1, e2 = row2;
        Ints i0 = i_row0, i1 = i_row1, i2 = i_row2;
        const auto group = [&](int x, Bools in_box) {
            Bools seen = in_box;
            if constexpr (cover == Cover::Int) {
                seen = seen && !is_negative(i0 | i1 | i2);
            }
            if constexpr (cover == Cover::Double) {
                seen = seen && !is_negative(upper_words(area - e1 - e2 - wide_bias0) |
                                            upper_words(e1 - wide_bias1) | upper_words(e2 - wide_bias2));
                if (!any(seen)) return;
            }
            const Floats z = nearness(depth<Floats>(plane, {0.0, e1, e2}));
            const Floats stored = load(near_row + x);
            seen = seen && z > stored;
            store(select(seen, z, stored), near_row + x);
            if (keeps_visible) store(select(seen, numbers, load(visible_row + x)), visible_row + x);
        };
        int x = 0;
        for (; x + lanes < columns; x += lanes) {
            group(x, all_lanes());
            e1 = e1 + across1, e2 = e2 + across2;
            if constexpr (cover == Cover::Int)
                i1 = i1 + i_across1, i2 = i2 + i_across2, i0 = i0 - i_across1 - i_across2;
        }
        group(x, last_columns);
        row1 = row1 + down1, row2 = row2 + down2;
        if constexpr (cover == Cover::Int)
            i_row1 = i_row1 + i_down1, i_row2 = i_row2 + i_down2, i_row0 = i_row0 - i_down1 - i_down2;
        near_row += tile.stride;
        if (keeps_visible) visible_row += tile.stride;
    }
}

// The part of a large triangle, the cheapest way that is exact.
RELEVO_LANE void cover_part(const StoredSetup& s, int k, const BoxPart& box, std::uint32_t number,
                            const Nearness& nearness, const TileMemory& tile) {
    const double width = box.x1 - box.x0, height = box.y1 - box.y0;
    const double step1 = 256.0 * s.dy2[k], step2 = -256.0 * s.dy1[k], down1 = -256.0 * s.dx2[k],
                 down2 = 256.0 * s.dx1[k];
    bool touches = true, crosses = false;  // the box
    const auto edge = [&](double e, double step, double down, double bias) {
        const double across = step * width, along = down * height;
        touches = touches && e + (across > 0 ? across : 0) + (along > 0 ? along : 0) >= bias;
        crosses = crosses || e + (across < 0 ? across : 0) + (along < 0 ? along : 0) < bias;
    };
    edge(s.area[k] - box.e1 - box.e2, -step1 - step2, -down1 - down2, s.bias0[k]);
    edge(box.e1, step1, down1, s.bias1[k]);
    edge(box.e2, step2, down2, s.bias2[k]);
    if (!touches) return;
    if (crosses)
        cover_rows<Cover::Double>(s, k, box, number, nearness, tile);
    else
        cover_rows<Cover::All>(s, k, box, number, nearness, tile);
}

// The rows of triangle k. Of a large one the box is taken in parts: fewer of them are crossed by an edge.
inline constexpr int part_side = 64;
RELEVO_LANE void cover_triangle(const StoredSetup& s, int k, bool small, std::uint32_t number,
                                const Nearness& nearness, const TileMemory& tile) {
    const double px = s.left[k], py = s.above[k];
    // + 0.0: an edge value of 0 is +0, as a whole number's is
    const double e1 = (px * s.dy2[k] - py * s.dx2[k]) + 0.0, e2 = (s.dx1[k] * py - s.dy1[k] * px) + 0.0;
    const int x0 = s.x0[k], y0 = s.y0[k], x1 = s.x1[k], y1 = s.y1[k];
    if (small) return cover_rows<Cover::Int>(s, k, {x0, y0, x1, y1, e1, e2}, number, nearness, tile);
    for (int y = y0, last_y; y <= y1; y = last_y + 1) {
        last_y = std::min(y | (part_side - 1), y1);
        for (int x = x0, last_x; x <= x1; x = last_x + 1) {
            last_x = std::min(x | (part_side - 1), x1);
            const double across = 256.0 * (x - x0), down = 256.0 * (y - y0);
            cover_part(s, k,
                       {x, y, last_x, last_y, e1 + (across * s.dy2[k] - down * s.dx2[k]),
                        e2 + (down * s.dx1[k] - across * s.dy1[k])},
                       number, nearness, tile);
        }
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
