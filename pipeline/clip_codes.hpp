// Which planes of the clip volume a corner lies beyond: one bit a plane (Cohen and Sutherland's outcode, in
// clip space).
//
// Near and far are z = 0 and z = w; the sides are the guard band |x|, |y| = 7 w: what lies between the
// screen's edge and the guard band is cut by the pixel box, without new vertices. Only comparisons, so no
// rounding decides.
#pragma once
#include <cstdint>

#include "pipeline/lane_vector.hpp"
#include "pipeline/space.hpp"

namespace relevo::pipeline {

using ClipCodes = std::uint16_t;

// Bits 0..5 are planes, in the order in which clipping takes them (near before far before the sides, with
// reversed depth; with forward depth z = 0 is the near one).
inline constexpr ClipCodes code_z_high = 1;   // z > w
inline constexpr ClipCodes code_z_low = 2;    // z < 0
inline constexpr ClipCodes code_x_low = 4;    // x < -7 w
inline constexpr ClipCodes code_x_high = 8;   // x > 7 w
inline constexpr ClipCodes code_y_low = 16;   // y < -7 w
inline constexpr ClipCodes code_y_high = 32;  // y > 7 w
inline constexpr ClipCodes code_planes = 63;
inline constexpr ClipCodes code_origin = 64;       // (0, 0, 0, 0): its triangle projects to a line
inline constexpr ClipCodes code_non_finite = 128;  // not a number, infinite, or 1/w would be

template <class Real>
Whole<Real> lanes_clip_codes(const Vec4Of<Real>& p, Scalar side = guard_band) {
    using Codes = Whole<Real>;
    const auto code_unless = [](const Mask<Real>& inside, ClipCodes code) {
        return select(inside, Codes(0), Codes(code));
    };
    const Real limit = side * p.w;
    const Codes planes = code_unless(p.z <= p.w, code_z_high) | code_unless(p.z >= 0, code_z_low) |
                         code_unless(p.x >= -limit, code_x_low) | code_unless(p.x <= limit, code_x_high) |
                         code_unless(p.y >= -limit, code_y_low) | code_unless(p.y <= limit, code_y_high);
    const Codes inside =
        select(p.w == 0, Codes(code_origin), code_unless(is_finite(1 / p.w), code_non_finite));
    return select(is_finite(p.x) && is_finite(p.y) && is_finite(p.z) && is_finite(p.w),
                  select(planes == 0, inside, planes), Codes(code_non_finite));
}
inline ClipCodes clip_codes(const HPoint<Clip>& p, Scalar side = guard_band) {
    return static_cast<ClipCodes>(lanes_clip_codes<Scalar>(p.v, side));
}

}  // namespace relevo::pipeline
