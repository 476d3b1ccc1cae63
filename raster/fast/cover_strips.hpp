// Coverage and depth of one triangle in one tile, a pixel a lane: in strips of N columns or, where what
// follows costs more than to begin a strip (paint_triangles.hpp), of 8, several rows at a time.
//
//        x0              x1
//   | . . . / | - - - \ | . . . . |     strips begin where registers do, so that none reaches over two
//   | . . / - | - - - - | \ . . . |     lines of the cache; each has rows of its own, the first and the last
//   | . / - - | - - - - | - \ . . |     that an edge may leave covered
//
// Depth needs the edge values in double, where every one (below 2^49) is exact. Coverage asks for their signs
// only. From a pixel's centre to the next one an edge value changes by a multiple of 256, so
//
//   E >= bias   is   S >= 0   with   S = (E - bias) / 256, rounded down
//
// S is exact and fits int32: for small triangles anyway, and of large ones in parts of 64 x 64 pixels that
// the edge crosses. Edges that do not cross the part are not asked.
#pragma once
#include <algorithm>
#include <cmath>

#include "raster/fast/corners.hpp"
#include "raster/fast/write_tile.hpp"
#include "raster/interpolate.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// The set-up of N triangles, for the strips of one of them to read.
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

// S of the three edges at the first pixel of a part, and how they change.
struct EdgeSigns {
    std::int32_t first[3], across[3], down[3];
};
RELEVO_LANE EdgeSigns steps_of(const StoredSetup& s, int k) {
    const std::int32_t dx1 = s.dx1[k], dy1 = s.dy1[k], dx2 = s.dx2[k], dy2 = s.dy2[k];
    return {{0, 0, 0}, {dy1 - dy2, dy2, -dy1}, {dx2 - dx1, -dx2, dx1}};
}

// The rows of each strip that an edge may leave covered: those where S at the strip's best pixel is 0 or
// more.
//   S + y down >= 0   is   y >= S (-1 / down)   or, where down < 0,   y <= S (-1 / down)
// The quotients are not exact, so that a row too many may be there: never one too few.
struct StripRows {
    alignas(64) std::int32_t first[max_tile / 4 + lanes], last[max_tile / 4 + lanes];  // empty: first > last

    // Of `columns` columns each; column: of the first strip's first pixel, from the part's first one.
    RELEVO_LANE StripRows(const EdgeSigns& signs, int rows, int column, int columns, int strips) {
        constexpr double slack = 1e-6;
        const double end = rows;
        for (int n = 0; n < strips; n += lanes) {
            const Doubles x = to_wide(Ints(column) + (lane_numbers() + Ints(n)) * Ints(columns));
            Doubles from = 0.0, to = end - 1;
            for (int j = 0; j < 3; ++j) {
                const double across = signs.across[j], down = signs.down[j],
                             quotient = -1 / (down == 0 ? 1e-300 : down);
                const Doubles s = x * across + (signs.first[j] + (across > 0 ? (columns - 1) * across : 0));
                // S times these bounds the rows from above, or from below; with factor 0 it does not.
                const bool is_first = down >= 0;
                from = greater(from, s * (is_first ? quotient : 0));
                to = smaller(to, s * (is_first ? 0 : quotient) + (is_first ? end : 0));
            }
            store(truncated(smaller(from, Doubles(end)) + (1 - slack)), first + n);
            store(truncated(greater(to, Doubles(-1.0)) + (1 + slack)) - Ints(1), last + n);
        }
    }
};

// What becomes of the pixels that are seen, beside their depth. Here: each shows a number, or one colour, in
// rows of `to`.
struct ShowNumber {
    static constexpr int columns = lanes;  // of a strip
    Ints number;
    std::uint32_t* to;  // null: nowhere
    int stride;
    std::uint32_t* row = nullptr;

    // at: its first pixel in the tile's memory; so many registers; the edge values of the first one, and what
    // their sum changes by from register to register.
    RELEVO_LANE void begin_strip(int at, int, const Doubles&, const Doubles&, double) {
        if (to != nullptr) row = to + at;
    }
    RELEVO_LANE void show(Bools seen, const Doubles&, const Doubles&) {
        if (to != nullptr) store_where(seen, number, row), row += stride;
    }
};

// One triangle in strips. Without `crossed` every pixel of the part is covered.
template <bool crossed, class Show>
RELEVO_LANE void cover_strips(const StoredSetup& s, int k, const BoxPart& box, const EdgeSigns& signs,
                              Show& show, const Nearness& nearness, const TileMemory& tile) {
    constexpr int columns = Show::columns, rows = rows_of_lanes<columns>;
    const Interpolator plane{s.z0[k], s.g1[k], s.g2[k], 0, 0, 0};
    const double step1 = 256.0 * s.dy2[k], step2 = -256.0 * s.dy1[k], down1 = -256.0 * s.dx2[k],
                 down2 = 256.0 * s.dx1[k];
    const Ints lane_x = lane_columns_of<columns>(), lane_y = lane_rows_of<columns>();
    // What a plane is at each lane's pixel more than at the first one's.
    const auto of_lanes = [&]<class Number>(Number x, Number y, auto across, auto down) {
        if constexpr (rows == 1)
            return x * Number(across);
        else
            return x * Number(across) + y * Number(down);
    };
    const Doubles wide_x = to_wide(lane_x), wide_y = to_wide(lane_y);
    const Doubles lane1 = of_lanes(wide_x, wide_y, step1, down1),
                  lane2 = of_lanes(wide_x, wide_y, step2, down2);
    const auto sign_of_lanes = [&](int j) {
        return of_lanes(lane_x, lane_y, signs.across[j], signs.down[j]);
    };
    const Ints lane_sign0 = sign_of_lanes(0), lane_sign1 = sign_of_lanes(1), lane_sign2 = sign_of_lanes(2);
    const int first_x = box.x0 / columns * columns, strips = (box.x1 - first_x) / columns + 1;
    const StripRows strip_rows(signs, box.y1 - box.y0 + 1, first_x - box.x0, columns, crossed ? strips : 0);
    for (int n = 0; n < strips; ++n) {
        const int x = first_x + n * columns, column = x - box.x0;
        int first_row = 0, last_row = box.y1 - box.y0;
        if constexpr (crossed) {
            first_row = strip_rows.first[n], last_row = strip_rows.last[n];
            if (first_row > last_row) continue;
        }
        // mod 2^32: a strip may begin before the part, where S needs not fit
        const auto first_sign = [&](int j, Ints of_lane) {
            const auto word = [](std::int32_t a) { return static_cast<std::uint32_t>(a); };
            return of_lane + Ints(static_cast<std::int32_t>(word(signs.first[j]) +
                                                            word(column) * word(signs.across[j]) +
                                                            word(first_row) * word(signs.down[j])));
        };
        Ints sign0 = first_sign(0, lane_sign0), sign1 = first_sign(1, lane_sign1),
             sign2 = first_sign(2, lane_sign2);
        Doubles e1 = lane1 + (box.e1 + (column * step1 + first_row * down1)),
                e2 = lane2 + (box.e2 + (column * step2 + first_row * down2));
        const Ints place = Ints(x) + lane_x;
        const Bools in_box = !(place < Ints(box.x0)) && !(place > Ints(box.x1));
        const int at = (box.y0 + first_row) * tile.stride + x;
        float* near = tile.nearness + at;
        show.begin_strip(at, (last_row - first_row + rows) / rows, e1, e2, rows * (down1 + down2));
        Ints left = Ints(last_row - first_row) - lane_y;
        for (int y = first_row; y <= last_row; y += rows) {
            const Floats z = nearness(depth<Floats>(plane, {0.0, e1, e2}));
            Bools seen = in_box && z > load_rows<columns>(near, tile.stride);
            Ints sign(0);
            if constexpr (rows > 1) sign = left, left = left - Ints(rows);
            if constexpr (crossed) sign = sign | sign0 | sign1 | sign2;
            if constexpr (crossed || rows > 1) seen = seen && sign > Ints(-1);
            store_rows_where<columns>(seen, z, near, tile.stride);
            show.show(seen, e1, e2);
            near += rows * tile.stride;
            e1 = e1 + rows * down1, e2 = e2 + rows * down2;
            if constexpr (crossed)
                sign0 = sign0 + Ints(rows * signs.down[0]), sign1 = sign1 + Ints(rows * signs.down[1]),
                sign2 = sign2 + Ints(rows * signs.down[2]);
        }
    }
}

// A part of a large triangle. Where an edge crosses it, S changes its sign there, so that it is nowhere
// larger than what it changes by from corner to corner.
inline constexpr int part_side = 64;
inline constexpr std::int64_t largest_difference =  // of two corners' coordinates
    std::int64_t{pipeline::guard_band} * pipeline::max_picture_size * pipeline::subpixels;
static_assert((part_side - 1) * 2 * largest_difference < std::int64_t{1} << 31);
template <class Show>
RELEVO_LANE void cover_part(const StoredSetup& s, int k, const BoxPart& box, Show& show,
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
            signs.across[j] = signs.down[j] = 0;  // is 0 everywhere: no need to ask
        }
        return true;
    };
    if (!touches(0, s.area[k] - box.e1 - box.e2 - s.bias0[k]) || !touches(1, box.e1 - s.bias1[k]) ||
        !touches(2, box.e2 - s.bias2[k]))
        return;
    if (crossed)
        cover_strips<true>(s, k, box, signs, show, nearness, tile);
    else
        cover_strips<false>(s, k, box, signs, show, nearness, tile);
}

// Triangle k. Of a large one the box is taken in parts: fewer of them are crossed by an edge.
template <class Show>
RELEVO_LANE void cover_triangle(const StoredSetup& s, int k, bool small, Show& show, const Nearness& nearness,
                                const TileMemory& tile) {
    const double px = s.left[k], py = s.above[k];
    // + 0.0: an edge value of 0 is +0, as a whole number's is
    const double e1 = (px * s.dy2[k] - py * s.dx2[k]) + 0.0, e2 = (s.dx1[k] * py - s.dy1[k] * px) + 0.0;
    const int x0 = s.x0[k], y0 = s.y0[k], x1 = s.x1[k], y1 = s.y1[k];
    if (small) {
        EdgeSigns signs = steps_of(s, k);
        const double e[3] = {s.area[k] - e1 - e2 - s.bias0[k], e1 - s.bias1[k], e2 - s.bias2[k]};
        for (int j = 0; j < 3; ++j) signs.first[j] = static_cast<std::int32_t>(e[j]) >> 8;
        return cover_strips<true>(s, k, {x0, y0, x1, y1, e1, e2}, signs, show, nearness, tile);
    }
    for (int y = y0, last_y; y <= y1; y = last_y + 1) {
        last_y = std::min(y | (part_side - 1), y1);
        for (int x = x0, last_x; x <= x1; x = last_x + 1) {
            last_x = std::min(x | (part_side - 1), x1);
            const double across = 256.0 * (x - x0), down = 256.0 * (y - y0);
            cover_part(s, k,
                       {x, y, last_x, last_y, e1 + (across * s.dy2[k] - down * s.dx2[k]),
                        e2 + (down * s.dx1[k] - across * s.dy1[k])},
                       show, nearness, tile);
        }
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
