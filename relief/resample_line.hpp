// What rows and columns share: pixels between two places of a line, whether two neighbours hang
// together, and what sticks out where they do not.
//
// A pixel belongs to the stretch from a to b when its centre lies in [min(a, b), max(a, b)), so
// stretches that follow one another never paint a pixel twice. Interpolation starts from the texel of
// the lower number: a centre that coincides with a texel gets exactly what the texel has, which makes a
// warp by nothing an exact copy.
//
// A texel is a square, not a point: where it has no neighbour, the half of it that is left sticks out,
// or a run of one texel would vanish. The surface goes on falling there, to the depth of its outline: at the
// texel's own depth the half texel would stand out too far, by 2 dB on a sphere seen 25 degrees from the
// side. How deep the outline is, the texels of one line alone tell badly where the surface is steep: the last
// texel of one line lies just before the outline, that of the next nearly a texel, which may be many of
// depth, away from it, and seen from the side the outline would fray. So the lines beside it are asked, too
// (prepare.cpp).
#pragma once
#include <cmath>
#include <optional>

#include "relief/prewarp.hpp"

namespace relevo::relief {

// The first pixel of 0..size-1 whose centre is at `place` or beyond; `size` when there is none. What is
// not a number counts as 0. As a number of the kind of all others: four are computed at a time.
inline Scalar first_pixel(Scalar place, Scalar size) {
    Scalar x = place - Scalar(0.5);
    x = x > 0 ? x : 0, x = x < size ? x : size;
    const int below = static_cast<int>(x);
    return static_cast<Scalar>(below + (static_cast<Scalar>(below) < x));
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

// How much deeper a surface gets from its last texel in a line to its end, at most half a texel on, judged by
// the depths of that texel and of the two before it. At a round outline the depth D - c sqrt(s) grows like
// the root of the distance s from the end, in texels, so with its last differences p and q
//
//     (D - d)^2 is linear in the line:   e = D - d = (q^2 + 2 p q - p^2) / (2 (p - q)),   c^2 = 2 e p + p^2
//
// Where it does not grow faster and faster it is continued as a plane, or not at all where it rises.
inline Scalar growth_beyond(Scalar here, Scalar before, std::optional<Scalar> second) {
    const Scalar p = here - before, q = second ? before - *second : p;
    if (p <= 0 || q <= 0) return 0;
    if (q >= p) return p / 2;
    const Scalar e = (q * q + 2 * p * q - p * p) / (2 * (p - q)), half_a_texel = p * (e + p / 2);
    return e <= 0 ? 0 : e - std::sqrt(std::max(e * e - half_a_texel, Scalar(0)));
}
inline Scalar depth_beyond(Scalar depth, Scalar growth) { return std::max(depth + growth, Scalar(0)); }

// What a pixel at `x` between a and b is: one of them when it is within half a pixel, else invented.
inline Kind kind_between(Scalar x, Scalar a, Scalar b, Kind kind_a, Kind kind_b, bool across) {
    const Scalar to_a = std::abs(x - a), to_b = std::abs(x - b);
    if (std::min(to_a, to_b) > Scalar(0.5)) return across ? Kind::FilledAcross : Kind::Filled;
    return to_a <= to_b ? kind_a : kind_b;
}

}  // namespace relevo::relief
