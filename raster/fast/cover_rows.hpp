// Coverage and depth of one triangle in one tile: a pixel a lane, row after row.
//
// Depth needs the edge values in double, where every one (below 2^49) is exact. Coverage asks for their signs
// only. From a pixel's centre to the next one an edge value changes by a multiple of 256, so
//
//   E >= bias   is   S >= 0   with   S = (E - bias) / 256, rounded down
//
// S is exact and fits int32: for small triangles anyway, and of large ones in parts of 64 x 64 pixels that
// the edge crosses. Edges that cross no part, which are most, are not asked.
#pragma once
#include <algorithm>
#include <cmath>

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

// A part of a triangle's box, and the edge values at its first pixel.
struct BoxPart {
    int x0, y0, x1, y1;  // within the tile
    double e1, e2;
};

// S of the three edges at the first pixel of a part, and how they change. Of an edge that does not cross it
// all are 0.
struct EdgeSigns {
    std::int32_t first[3], across[3], down[3];
};
RELEVO_LANE EdgeSigns steps_of(const StoredSetup& s, int k) {
    const std::int32_t dx1 = s.dx1[k], dy1 = s.dy1[k], dx2 = s.dx2[k], dy2 = s.dy2[k];
    return {{0, 0, 0}, {dy1 - dy2, dy2, -dy1}, {dx2 - dx1, -dx2, dx1}};
}

// Rows of one triangle, a pixel a lane. Without `crossed` every pixel of the part is covered.
template <bool crossed>
RELEVO_LANE void cover_rows(const StoredSetup& s, int k, const BoxPart& box, const EdgeSigns& signs,
                            std::uint32_t number, const Nearness& nearness, const TileMemory& tile) {
    const Interpolator plane{s.z0[k], s.g1[k], s.g2[k], 0, 0, 0};
    const double step1 = 256.0 * s.dy2[k], step2 = -256.0 * s.dy1[k];
    const Doubles across1(lanes * step1), across2(lanes * step2), down1(-256.0 * s.dx2[k]),
        down2(256.0 * s.dx1[k]);
    const Doubles lane = to_wide(lane_numbers());
    Doubles row1 = Doubles(box.e1) + lane * Doubles(step1), row2 = Doubles(box.e2) + lane * Doubles(step2);
    const auto sign_row = [&](int j) {
        return crossed ? Ints(signs.first[j]) + lane_numbers() * Ints(signs.across[j]) : Ints(0);
    };
    Ints sign_row0 = sign_row(0), sign_row1 = sign_row(1), sign_row2 = sign_row(2);

    const Ints numbers(static_cast<std::int32_t>(number));
    const int columns = box.x1 - box.x0 + 1, rows = box.y1 - box.y0 + 1;
    const Bools last_columns = first_lanes((columns - 1) % lanes + 1);
    float* near_row = tile.nearness + box.y0 * tile.stride + box.x0;
    const bool keeps_visible = tile.visible != nullptr;
    std::uint32_t* visible_row = keeps_visible ? tile.visible + box.y0 * tile.stride + box.x0 : nullptr;
    for (int y = 0; y < rows; ++y) {
        Doubles e1 = row1, e2 = row2;
        Ints sign0 = sign_row0, sign1 = sign_row1, sign2 = sign_row2;
        const auto group = [&](int x, Bools in_box) {
            const Floats z = nearness(depth<Floats>(plane, {0.0, e1, e2}));
            Bools seen = in_box && z > load(near_row + x);
            if constexpr (crossed) seen = seen && !is_negative(sign0 | sign1 | sign2);
            store_where(seen, z, near_row + x);
            if (keeps_visible) store_where(seen, numbers, visible_row + x);
        };
        int x = 0;
        for (; x + lanes < columns; x += lanes) {
            group(x, all_lanes());
            e1 = e1 + across1, e2 = e2 + across2;
            if constexpr (crossed) {
                const auto next = [&](Ints& sign, int j) { sign = sign + Ints(lanes * signs.across[j]); };
                next(sign0, 0), next(sign1, 1), next(sign2, 2);
            }
        }
        group(x, last_columns);
        row1 = row1 + down1, row2 = row2 + down2;
        if constexpr (crossed) {
            const auto below = [&](Ints& sign, int j) { sign = sign + Ints(signs.down[j]); };
            below(sign_row0, 0), below(sign_row1, 1), below(sign_row2, 2);
        }
        near_row += tile.stride;
        if (keeps_visible) visible_row += tile.stride;
    }
}

// A part of a large triangle. S is 0 somewhere in it if the edge crosses it, so that it is nowhere larger
// than what it changes by from corner to corner.
inline constexpr int part_side = 64;
inline constexpr std::int64_t largest_difference = std::int64_t{2 * 7 * 128} * 8192;  // within the guard band
static_assert((part_side - 1) * 2 * largest_difference < std::int64_t{1} << 31);
RELEVO_LANE void cover_part(const StoredSetup& s, int k, const BoxPart& box, std::uint32_t number,
                            const Nearness& nearness, const TileMemory& tile) {
    const int width = box.x1 - box.x0, height = box.y1 - box.y0;
    EdgeSigns signs = steps_of(s, k);
    bool crossed = false;
    // Whether any of the part may be covered.
    const auto touches = [&](int j, double e) {
        const double across = 256.0 * signs.across[j] * width, down = 256.0 * signs.down[j] * height;
        if (e + (across > 0 ? across : 0) + (down > 0 ? down : 0) < 0) return false;
        if (e + (across < 0 ? across : 0) + (down < 0 ? down : 0) < 0) {
            crossed = true;
            signs.first[j] = static_cast<std::int32_t>(std::floor(e * (1 / 256.0)));
        } else {
            signs.across[j] = signs.down[j] = 0;
        }
        return true;
    };
    if (!touches(0, s.area[k] - box.e1 - box.e2 - s.bias0[k]) || !touches(1, box.e1 - s.bias1[k]) ||
        !touches(2, box.e2 - s.bias2[k]))
        return;
    if (crossed)
        cover_rows<true>(s, k, box, signs, number, nearness, tile);
    else
        cover_rows<false>(s, k, box, signs, number, nearness, tile);
}

// The rows of triangle k. Of a large one the box is taken in parts: fewer of them are crossed by an edge.
RELEVO_LANE void cover_triangle(const StoredSetup& s, int k, bool small, std::uint32_t number,
                                const Nearness& nearness, const TileMemory& tile) {
    const double px = s.left[k], py = s.above[k];
    // + 0.0: an edge value of 0 is +0, as a whole number's is
    const double e1 = (px * s.dy2[k] - py * s.dx2[k]) + 0.0, e2 = (s.dx1[k] * py - s.dy1[k] * px) + 0.0;
    const int x0 = s.x0[k], y0 = s.y0[k], x1 = s.x1[k], y1 = s.y1[k];
    if (small) {
        EdgeSigns signs = steps_of(s, k);
        const double e[3] = {s.area[k] - e1 - e2 - s.bias0[k], e1 - s.bias1[k], e2 - s.bias2[k]};
        for (int j = 0; j < 3; ++j) signs.first[j] = static_cast<std::int32_t>(e[j]) >> 8;
        return cover_rows<true>(s, k, {x0, y0, x1, y1, e1, e2}, signs, number, nearness, tile);
    }
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
