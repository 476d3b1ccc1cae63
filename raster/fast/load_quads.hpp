// Four numbers of each lane, from a place of its own: 16 bytes at a time, then 4 x 4 transposes. Gathering
// them one by one would ask memory four times as often.
//
//   place(0)  a0 b0 c0 d0        a  a0 a1 a2 ... aN-1
//   place(1)  a1 b1 c1 d1   ->   b  b0 b1 b2 ...
//   ...                          c, d
#pragma once
#include "raster/fast/lanes.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

struct Quad {
    Floats a, b, c, d;
};
// place(k): where the four numbers of lane k stand.
template <class Place>
RELEVO_LANE Quad load_quads(Place&& place) {
    const hn::Full128<float> four;
    const hn::Half<TagF> half;
    const auto rows = [&](auto j) RELEVO_INSIDE {  // of the lanes j, j + 4, j + 8, j + 12
        if constexpr (lanes == 4) {
            return hn::LoadU(four, place(j));
        } else if constexpr (lanes == 8) {
            return hn::Combine(TagF(), hn::LoadU(four, place(j + 4)), hn::LoadU(four, place(j)));
        } else {
            const auto low = hn::Combine(half, hn::LoadU(four, place(j + 4)), hn::LoadU(four, place(j)));
            const auto high =
                hn::Combine(half, hn::LoadU(four, place(j + 12)), hn::LoadU(four, place(j + 8)));
            return hn::Combine(TagF(), high, low);
        }
    };
    const auto r0 = rows(0), r1 = rows(1), r2 = rows(2), r3 = rows(3);
    const auto pairs = [](auto x) RELEVO_INSIDE { return hn::BitCast(TagU64(), x); };
    const auto low01 = pairs(hn::InterleaveLower(TagF(), r0, r1)),
               low23 = pairs(hn::InterleaveLower(TagF(), r2, r3)),
               high01 = pairs(hn::InterleaveUpper(TagF(), r0, r1)),
               high23 = pairs(hn::InterleaveUpper(TagF(), r2, r3));
    const auto floats = [](auto x) RELEVO_INSIDE { return Floats(hn::BitCast(TagF(), x)); };
    return {floats(hn::InterleaveLower(TagU64(), low01, low23)),
            floats(hn::InterleaveUpper(TagU64(), low01, low23)),
            floats(hn::InterleaveLower(TagU64(), high01, high23)),
            floats(hn::InterleaveUpper(TagU64(), high01, high23))};
}

// base + 8 offset bytes: where the four numbers of a lane stand.
RELEVO_LANE Quad load_quads(const void* base, const std::uint32_t (&offset)[lanes]) {
    return load_quads([&](int k) RELEVO_INSIDE {
        return reinterpret_cast<const float*>(static_cast<const char*>(base) + std::size_t{offset[k]} * 8);
    });
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
