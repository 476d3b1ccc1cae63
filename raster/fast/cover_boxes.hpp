// Coverage and depth of N small triangles in one tile: a triangle a lane, all boxes walked at once.
//
//   step      every lane looks at the same place of its own box: dx = 0, 1, ... of dy = 0, 1, ...
//   covered   compressed into a list of fragments (nearness, place and lane), in the order of the steps
//   at last   fragment after fragment against the tile's memory; lanes may have met in a pixel in the wrong
//             order, so here the number decides at equal depth
//
// No branch asks whether a step covers anything: guessed wrong, it costs more than the work of an empty one.
#pragma once
#include "raster/fast/cover_rows.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// Boxes of more places are walked slower than their rows are drawn.
inline constexpr int most_walked = 3 * lanes;

// Edge values at the first centre of each box, in int32, and how they change.
struct BoxWalk {
    Ints e0, e1, e2, step1, step2, down1, down2, bias0, bias1, bias2;
    Ints place;  // of the first pixel in the tile's memory
    Ints columns, rows;
};

RELEVO_LANE void cover_boxes(const TileMemory& tile, const BoxWalk& walk, const InterpolatorOf<Floats>& plane,
                             const Nearness& nearness, std::uint32_t first_number, int most_columns,
                             int most_rows) {
    struct {
        alignas(64) float nearness[(most_walked + 1) * lanes];
        std::uint32_t place[(most_walked + 1) * lanes];  // and the lane above bit 16
    } fragments;
    int count_of_fragments = 0;

    Ints row0 = walk.e0 - walk.bias0, row1 = walk.e1 - walk.bias1, row2 = walk.e2 - walk.bias2;
    const Ints step0 = Ints(0) - walk.step1 - walk.step2, down0 = Ints(0) - walk.down1 - walk.down2;
    Ints row_place = walk.place + shift_left<16>(lane_numbers());
    for (int y = 0; y < most_rows; ++y) {
        const Bools in_rows = Ints(y) < walk.rows;
        Ints e0 = row0, e1 = row1, e2 = row2;
        for (int x = 0; x < most_columns; ++x) {
            const Bools covered = in_rows && Ints(x) < walk.columns && !is_negative(e0 | e1 | e2);
            const Doubles exact1 = to_wide(e1 + walk.bias1), exact2 = to_wide(e2 + walk.bias2);
            const Floats z = nearness(depth<Floats>(plane, {0.0, exact1, exact2}));
            store(compress(z, covered), fragments.nearness + count_of_fragments);
            store(compress(row_place + Ints(x), covered), fragments.place + count_of_fragments);
            count_of_fragments += count(covered);
            e0 = e0 + step0, e1 = e1 + walk.step1, e2 = e2 + walk.step2;
        }
        row0 = row0 + down0, row1 = row1 + walk.down1, row2 = row2 + walk.down2;
        row_place = row_place + Ints(tile.stride);
    }

    if (tile.visible == nullptr) {
        for (int k = 0; k < count_of_fragments; ++k) {
            float& stored = tile.nearness[fragments.place[k] & 0xffff];
            stored = fragments.nearness[k] > stored ? fragments.nearness[k] : stored;
        }
        return;
    }
    for (int k = 0; k < count_of_fragments; ++k) {
        const std::uint32_t place = fragments.place[k] & 0xffff,
                            number = first_number + (fragments.place[k] >> 16);
        const float near = fragments.nearness[k];
        float& stored = tile.nearness[place];
        std::uint32_t& seen = tile.visible[place];
        if (near > stored || (near == stored && number < seen && seen != nothing))
            stored = near, seen = number;
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
