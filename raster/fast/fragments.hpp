// The fragments of a tile's small triangles, which coverage keeps for shading.
//
//   place    where in the tile; above bit 16: of which triangle of its group      a fragment each
//   e1, e2   its edge values
//   groups   N triangles that follow each other in the tile's list, and where their fragments stand
//            (fragment_groups.hpp)
//
// Where such a fragment is seen, the visibility buffer says so: its triangle's number has `kept_bit`.
#pragma once
#include <cstddef>
#include <cstdint>

namespace relevo::raster::fast {

inline constexpr std::uint32_t kept_bit = 0x80000000u;

struct Fragments {
    std::uint32_t* place = nullptr;
    std::int32_t *e1 = nullptr, *e2 = nullptr;
    int room = 0;  // for so many, and `fragment_slack` more
    std::byte* groups = nullptr;
    std::size_t group_bytes = 0;

    int end = 0;   // of the places in use
    int kept = 0;  // fragments
    int group_count = 0;
    bool stays_full = false;  // dropping what is hidden frees too little
};
// Of the last group that is kept, of one that is not, and of a register.
inline constexpr int fragment_slack = 8192;

}  // namespace relevo::raster::fast
