// The snapped corners of N triangles, a lane each; and their canonical order, as triangle_edge.hpp has it.
#pragma once
#include "raster/fast/draw_state.hpp"
#include "raster/fast/lanes.hpp"
#include "raster/triangle_edge.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

using LaneCorner = pipeline::SnappedCornerOf<Floats>;

// N corners in a row: x y z rw | x y z rw | ...
RELEVO_LANE LaneCorner load_corners(const SnappedCorner* corners) {
    hn::Vec<TagF> x, y, z, rw;
    hn::LoadInterleaved4(TagF(), reinterpret_cast<const float*>(corners), x, y, z, rw);
    return {float_bits(Floats(x)), float_bits(Floats(y)), Floats(z), Floats(rw)};
}
RELEVO_LANE LaneCorner select(Bools mask, const LaneCorner& yes, const LaneCorner& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z),
            select(mask, yes.rw, no.rw)};
}
RELEVO_LANE Bools is_above(const LaneCorner& p, const LaneCorner& q) {
    return p.y < q.y || (p.y == q.y && p.x < q.x);
}

// Triangles whose corners lie closer than this in x and in y (110 pixels) have edge values within int32, also
// at the 15 pixels by which a row of lanes may reach past their box: (110 + 15) 256 * 110 256 + (110 256)^2.
inline constexpr std::int32_t max_small_extent = 110 * 256;
static_assert(std::int64_t{125 * 256} * max_small_extent + std::int64_t{max_small_extent} * max_small_extent <
              std::int64_t{1} << 31);

// Corner 0 is the topmost (of these, the leftmost), corners 1 and 2 give a positive area: triangle_edge.hpp's
// canonical order.
struct OrderedCorners {
    LaneCorner c0, c1, c2;
};
RELEVO_LANE OrderedCorners canonical_order(const LaneCorner& a, const LaneCorner& b, const LaneCorner& c) {
    const Bools b_first = is_above(b, a), c_first = is_above(c, select(b_first, b, a));
    const LaneCorner next = select(c_first, a, select(b_first, c, b));
    const LaneCorner last = select(c_first, b, select(b_first, a, c));
    const Bools negative = is_negative(area2<Floats>(a, b, c));
    return {select(c_first, c, select(b_first, b, a)), select(negative, last, next),
            select(negative, next, last)};
}

// Sixteen bytes from one place to another.
RELEVO_LANE void copy_corner(const SnappedCorner& from, SnappedCorner& to) {
    const hn::Full128<float> tag;
    hn::Store(hn::LoadU(tag, reinterpret_cast<const float*>(&from)), tag, reinterpret_cast<float*>(&to));
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
