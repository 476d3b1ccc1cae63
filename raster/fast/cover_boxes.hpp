// Coverage and depth of N small triangles in one tile: a triangle a lane, all boxes walked at once.
//
//   step       every lane looks at the same place of its own box: dx = 0, 1, ... of dy = 0, 1, ...
//   fragments  the covered places, compressed: place and lane, edge values           (fragments.hpp)
//   depth      of N fragments at a time, each with its triangle's plane
//   at last    fragment after fragment against the tile's memory; lanes may have met in a pixel in the
//              wrong order, so here the number decides at equal depth
//
// No branch asks whether a step covers anything: guessed wrong, it costs more than the work of an empty one.
#pragma once
#include "raster/fast/cover_strips.hpp"
#include "raster/fast/fragment_groups.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// Boxes of more places are walked slower than their strips are drawn.
inline constexpr int most_walked = 12 * lanes;

// Edge values at the first centre of each box, in int32, and how they change.
struct BoxWalk {
    Ints area, e1, e2, step1, step2, down1, down2, bias0, bias1, bias2;
    Ints place;  // of the first pixel in the tile's memory
    Ints columns, rows;
};

// Appends the fragments of all boxes; e1 and e2 are less their bias. Returns their end.
RELEVO_LANE int walk_boxes(const Fragments& to, const BoxWalk& walk, int stride, int most_columns,
                           int most_rows) {
    Ints row0 = walk.area - walk.e1 - walk.e2 - walk.bias0, row1 = walk.e1 - walk.bias1,
         row2 = walk.e2 - walk.bias2;
    const Ints step0 = Ints(0) - walk.step1 - walk.step2, down0 = Ints(0) - walk.down1 - walk.down2;
    Ints row_place = walk.place + shift_left<16>(lane_numbers());
    int end = to.end;
    for (int y = 0; y < most_rows; ++y) {
        const Bools in_rows = Ints(y) < walk.rows;
        Ints e0 = row0, e1 = row1, e2 = row2;
        for (int x = 0; x < most_columns; ++x) {
            const Bools covered = in_rows && Ints(x) < walk.columns && !is_negative(e0 | e1 | e2);
            store(compress(row_place + Ints(x), covered), to.place + end);
            store(compress(e1, covered), to.e1 + end);
            store(compress(e2, covered), to.e2 + end);
            end += count(covered);
            e0 = e0 + step0, e1 = e1 + walk.step1, e2 = e2 + walk.step2;
        }
        row0 = row0 + down0, row1 = row1 + walk.down1, row2 = row2 + walk.down2;
        row_place = row_place + Ints(stride);
    }
    store(Ints(0), to.place + end);  // what a register holds past the end stands in the tile, too
    return end;
}

// `keep`: fragments stay for shading.
RELEVO_LANE void cover_boxes(const TileMemory& tile, Fragments& fragments, const BoxWalk& walk,
                             const GroupCorners& corners, const OrderedTriangles& triangle,
                             const InterpolatorOf<Floats>& plane, const Nearness& nearness,
                             std::uint32_t first_number, int most_columns, int most_rows, bool keep) {
    static_assert((2 * most_walked + 1) * lanes <= fragment_slack);
    const int first = fragments.end, end = walk_boxes(fragments, walk, tile.stride, most_columns, most_rows);
    alignas(64) float near[(most_walked + 1) * lanes];
    for (int k = first; k < end; k += lanes) {
        const Picked of_triangle(shift_right<16>(load(fragments.place + k)) & Ints(lanes - 1));
        const Ints e1 = load(fragments.e1 + k) + of_triangle(walk.bias1),
                   e2 = load(fragments.e2 + k) + of_triangle(walk.bias2);
        if (keep) store(e1, fragments.e1 + k), store(e2, fragments.e2 + k);
        const InterpolatorOf<Floats> picked{
            of_triangle(plane.z0), of_triangle(plane.g1), of_triangle(plane.g2), {}, {}, {}};
        store(nearness(depth<Floats>(picked, {0.0, to_wide(e1), to_wide(e2)})), near + (k - first));
    }

    const std::uint32_t* place_of = fragments.place + first;
    if (tile.visible == nullptr) {
        for (int k = 0; k < end - first; ++k) {
            float& stored = tile.nearness[place_of[k] & 0xffff];
            stored = near[k] > stored ? near[k] : stored;
        }
        return;
    }
    const std::uint32_t base = first_number | (keep ? kept_bit : 0);
    for (int k = 0; k < end - first; ++k) {
        const std::uint32_t place = place_of[k] & 0xffff, number = base + (place_of[k] >> 16);
        float& stored = tile.nearness[place];
        std::uint32_t& seen = tile.visible[place];
        if (near[k] > stored ||
            (near[k] == stored && seen != nothing && (number & ~kept_bit) < (seen & ~kept_bit)))
            stored = near[k], seen = number;
    }
    if (keep && end > first) {
        FragmentGroup& group = groups_of(fragments)[fragments.group_count++];
        group.first_number = first_number, group.first = first, group.last = end;
        group.one = bits(triangle.one), group.two = bits(triangle.two);
        group.negative = bits(triangle.negative);
        group.model = corners.model;
        for (int c = 0; c < 3; ++c) store(corners.corner[c], group.corner[c]);
        store(walk.area, group.area);
        store(triangle.c0.rw, group.rw[0]), store(triangle.c1.rw, group.rw[1]);
        store(triangle.c2.rw, group.rw[2]);
        fragments.end = whole_registers(end);
        fragments.kept += end - first;
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
