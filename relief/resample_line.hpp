// What rows and columns share: pixels between two places of a line, whether two neighbours hang
// together, and what sticks out where they do not.
//
// A pixel belongs to the stretch from a to b when its centre lies in [min(a, b), max(a, b)), so
// stretches that follow one another never paint a pixel twice. Interpolation starts from the texel of
// the lower number: a centre that coincides with a texel gets exactly what the texel has, which makes a
// warp by nothing an exact copy.
//
// A texel is a square, not a point: where it has no neighbour, the half of it that is left sticks out,
// or a run of one texel would vanish. The surface goes on falling there. At a round outline the depth
// grows like a root, so over the half texel beyond it grows about as much as over the whole texel before
// (1.4 times as much on average, a plane half as much); at the texel's own depth the half texel would
// stand out too far. On a sphere seen 25 degrees from the side that is worth 2 dB, at the edges of a
// cube it costs 0.02.
#pragma once
#include "relief/prewarp.hpp"

namespace relevo::relief {

// The first pixel of 0..size-1 whose centre is at `place` or beyond; `size` when there is none. What is
// not a number counts as 0.
inline int first_pixel(Scalar place, Scalar size) {
    Scalar x = place - Scalar(0.5);
    x = x > 0 ? x : 0, x = x < size ? x : size;
    const int below = static_cast<int>(x);
    return below + (static_cast<Scalar>(below) < x);
}

inline Gap gap_between(bool first_covered, bool second_covered, Scalar first_depth, Scalar second_depth,
                       Jump jump, Scalar jump_depth) {
    if (!first_covered || !second_covered)
        return static_cast<Gap>(int{first_covered} + 2 * int{second_covered});
    if (!(std::abs(first_depth - second_depth) > jump_depth)) return Gap::Joined;
    return jump == Jump::Cut ? Gap::Cut : Gap::Across;
}

inline bool is_covered(const PreparedRelief& relief, int x, int y) {
    const Gap after = relief.gap.row(y)[x + 1];
    return after != Gap::Empty && after != Gap::BeforeSecond;
}

// How fast the depth grows beyond a texel that sticks out on one side and is joined on the other, per
// texel; else 0.
inline Scalar slope_beyond(Gap one, Scalar at_one, Gap other, Scalar at_other, Scalar here) {
    if (sticks_out(one) && other == Gap::Joined) return here - at_other;
    if (sticks_out(other) && one == Gap::Joined) return here - at_one;
    return 0;
}
inline Scalar depth_beyond(Scalar depth, Scalar slope) { return std::max(depth + slope, Scalar(0)); }

// What a pixel at `x` between a and b is: one of them when it is within half a pixel, else invented.
inline Kind kind_between(Scalar x, Scalar a, Scalar b, Kind kind_a, Kind kind_b, bool across) {
    const Scalar to_a = std::abs(x - a), to_b = std::abs(x - b);
    if (std::min(to_a, to_b) > Scalar(0.5)) return across ? Kind::FilledAcross : Kind::Filled;
    return to_a <= to_b ? kind_a : kind_b;
}

}  // namespace relevo::relief
