// The snapped corners of N triangles, a lane each; and their canonical order, as triangle_edge.hpp has it.
#pragma once
#include "raster/fast/draw_state.hpp"
#include "raster/fast/lanes.hpp"
#include "raster/fast/load_quads.hpp"
#include "raster/interpolate.hpp"
#include "raster/triangle_edge.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

using LaneCorner = pipeline::SnappedCornerOf<Floats>;

// Of N triangles.
struct GroupCorners {
    LaneCorner a, b, c;
    const ModelState* model = nullptr;  // of all of them, none a piece; null: not known
    Ints corner[3];                     // then: the numbers of the vertices
};

RELEVO_LANE LaneCorner corner_of(const Quad& q) { return {float_bits(q.a), float_bits(q.b), q.c, q.d}; }
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

// Triangles whose corners lie closer than this in x and in y (110 pixels) have edge values within int32.
inline constexpr std::int32_t max_small_extent = 110 * 256;
static_assert(2 * std::int64_t{max_small_extent} * max_small_extent < std::int64_t{1} << 31);

// N triangles in canonical order as triangle_edge.hpp has it: corner 0 is the topmost (of these, the
// leftmost), and the area is positive. With a negative one the corners 1 and 2 would change places; the
// formulas treat them alike, so it is enough to turn the signs of the edges.
struct OrderedTriangles {
    Bools one, two;  // corner 0 is the caller's 1, or 2; the others follow it in the caller's order
    Bools negative;  // the caller's area
    LaneCorner c0, c1, c2;
    Ints dx1, dy1, dx2, dy2;  // corner k - corner 0, with the sign of the area
    Doubles area;             // without it
};
// What belongs to a triangle's corners, from the corner on that comes first.
template <class T>
RELEVO_LANE std::array<T, 3> in_order(Bools one, Bools two, const T& a, const T& b, const T& c) {
    return {select(two, c, select(one, b, a)), select(two, a, select(one, c, b)),
            select(two, b, select(one, a, c))};
}
RELEVO_LANE OrderedTriangles canonical_order(const LaneCorner& a, const LaneCorner& b, const LaneCorner& c) {
    OrderedTriangles t;
    t.one = is_above(b, a), t.two = is_above(c, select(t.one, b, a));
    const auto [c0, c1, c2] = in_order(t.one, t.two, a, b, c);
    t.c0 = c0, t.c1 = c1, t.c2 = c2;
    const Doubles signed_area = area2<Floats>(c0, c1, c2);
    t.negative = is_negative(signed_area);
    const auto turned = [&](Ints d) RELEVO_INSIDE { return select(t.negative, Ints(0) - d, d); };
    t.dx1 = turned(c1.x - c0.x), t.dy1 = turned(c1.y - c0.y);
    t.dx2 = turned(c2.x - c0.x), t.dy2 = turned(c2.y - c0.y);
    t.area = select(t.negative, Doubles(0.0) - signed_area, signed_area);
    return t;
}
RELEVO_LANE InterpolatorOf<Floats> make_interpolator(const OrderedTriangles& t) {
    return make_interpolator(TriangleOf<Floats>{{t.c0, t.c1, t.c2}, t.area, {}, {}, {}, {}, {}});
}

// Sixteen bytes from one place to another.
RELEVO_LANE void copy_corner(const SnappedCorner& from, SnappedCorner& to) {
    const hn::Full128<float> tag;
    hn::Store(hn::LoadU(tag, reinterpret_cast<const float*>(&from)), tag, reinterpret_cast<float*>(&to));
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
