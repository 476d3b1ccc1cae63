// The fragments of a tile's small triangles, which coverage keeps for shading.
//
//   place    where in the tile; above bit 16: of which triangle of its group      a fragment each
//   e1, e2   its edge values
//   groups   N triangles that follow each other in the tile's list, and where their fragments stand
//
// Where such a fragment is seen, the visibility buffer says so: its triangle's number has `kept_bit`.
#pragma once
#include <cstdint>

namespace relevo::raster::fast {

inline constexpr std::uint32_t kept_bit = 0x80000000u;

struct FragmentGroup {
    std::uint32_t first_number;         // of its triangles
    std::int32_t first, last;           // fragments
    std::uint32_t one, two, negative;   // of each triangle a bit: OrderedTriangles' (corners.hpp)
    alignas(64) std::int32_t area[16];  // and a number
    float rw[3][16];                    // 1 / w of its corners in canonical order
};

struct Fragments {
    std::uint32_t* place = nullptr;
    std::int32_t *e1 = nullptr, *e2 = nullptr;
    FragmentGroup* groups = nullptr;
    int count = 0, room = 0;  // there is space for `fragment_slack` more
    int group_count = 0, group_room = 0;
};
// Of one group at most, and a register.
inline constexpr int fragment_slack = 8192;

}  // namespace relevo::raster::fast
