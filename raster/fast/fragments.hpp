// The fragments of a tile's small triangles, which coverage keeps for shading.
//
//   place    where in the tile; above bit 16: of which triangle of its group      a fragment each
//   e1, e2   its edge values
//   groups   N triangles that follow each other in the tile's list, and where their fragments stand
//
// Where such a fragment is seen, the visibility buffer says so: its triangle's number has `kept_bit`.
#pragma once
#include <cstdint>

#include "raster/fast/draw_state.hpp"

namespace relevo::raster::fast {

inline constexpr std::uint32_t kept_bit = 0x80000000u;

struct FragmentGroup {
    std::uint32_t first_number;         // of its triangles
    std::int32_t first, last;           // fragments; the first stands where a register begins
    std::uint32_t one, two, negative;   // of each triangle a bit: OrderedTriangles' (corners.hpp)
    const ModelState* model;               // of all of them, none a piece; else null, and no `corner`
    alignas(64) std::int32_t area[16];     // of each triangle a number
    float rw[3][16];                       // 1 / w of its corners in canonical order
    std::uint32_t corner[3][16];           // the vertices' numbers, in the order of the mesh
};

struct Fragments {
    std::uint32_t* place = nullptr;
    std::int32_t *e1 = nullptr, *e2 = nullptr;
    FragmentGroup* groups = nullptr;
    int count = 0, room = 0;  // places; there are `fragment_slack` more
    int kept = 0;             // fragments
    int group_count = 0, group_room = 0;
};
// Of one group at most, and a register.
inline constexpr int fragment_slack = 8192;

}  // namespace relevo::raster::fast
