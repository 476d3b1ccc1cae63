// The groups of kept fragments (fragments.hpp), and how room is made for more of them.
//
// What the visibility buffer does not show is hidden for good, as nothing that is seen moves away:
//   before   f f h f | h h . . | h f . .       three groups; h: hidden, .: nothing
//   after    f f f . | f . . .                 two
#pragma once
#include "raster/fast/draw_state.hpp"
#include "raster/fast/fragments.hpp"
#include "raster/fast/lanes.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// N triangles: of each a bit, or a number.
struct FragmentGroup {
    std::uint32_t first_number;        // of the triangles in the tile's list
    std::int32_t first, last;          // fragments; the first stands where a register begins
    std::uint32_t one, two, negative;  // OrderedTriangles' (corners.hpp)
    const ModelState* model;           // of all of them, none a piece; else null, and `corner` unknown
    alignas(64) std::int32_t area[lanes];
    float rw[3][lanes];              // 1 / w of OrderedTriangles' corners
    std::uint32_t corner[3][lanes];  // the vertices' numbers in the order of the mesh
};

RELEVO_LANE FragmentGroup* groups_of(const Fragments& f) {
    return reinterpret_cast<FragmentGroup*>(f.groups);
}
RELEVO_LANE int group_room(const Fragments& f) {
    return static_cast<int>(f.group_bytes / sizeof(FragmentGroup));
}
RELEVO_LANE bool is_full(const Fragments& f) { return f.end >= f.room || f.group_count >= group_room(f); }
// Where a register begins, at or after k.
RELEVO_LANE int whole_registers(int k) { return (k + lanes - 1) / lanes * lanes; }

RELEVO_LANE void drop_hidden(const TileMemory& tile, Fragments& fragments) {
    FragmentGroup* groups = groups_of(fragments);
    int to = 0, left = 0;  // fragments, groups
    fragments.kept = 0;
    for (int g = 0; g < fragments.group_count; ++g) {
        FragmentGroup& group = groups[g];
        const Ints first_number(static_cast<std::int32_t>(group.first_number | kept_bit));
        const int first = to;
        for (int k = group.first; k < group.last; k += lanes) {
            const Ints place = load(fragments.place + k), e1 = load(fragments.e1 + k),
                       e2 = load(fragments.e2 + k);
            const Ints seen_there = gather(tile.visible, place & Ints(0xffff));
            const Bools seen = seen_there == first_number + shift_right<16>(place) &&
                               first_lanes(group.last - k < lanes ? group.last - k : lanes);
            store(compress(place, seen), fragments.place + to);  // to <= k: what follows has been read
            store(compress(e1, seen), fragments.e1 + to);
            store(compress(e2, seen), fragments.e2 + to);
            to += count(seen);
        }
        if (to == first) continue;
        group.first = first, group.last = to;
        fragments.kept += to - first;
        to = whole_registers(to);
        if (left != g) groups[left] = group;
        ++left;
    }
    fragments.end = to, fragments.group_count = left;
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
