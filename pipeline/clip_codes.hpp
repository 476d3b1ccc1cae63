// Which planes of the clip volume a corner lies beyond: one bit a plane (Cohen and Sutherland's outcode, in
// clip space).
//
// Near and far are z = 0 and z = w; the sides are the guard band |x|, |y| = 7 w: what lies between the
// screen's edge and the guard band is cut by the pixel box, without new vertices. Only comparisons, so no
// rounding decides.
#pragma once
#include <cmath>
#include <cstdint>

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

inline ClipCodes clip_codes(const HPoint<Clip>& p, Scalar side = guard_band) {
    const Scalar x = p.v.x, y = p.v.y, z = p.v.z, w = p.v.w;
    if (!(std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && std::isfinite(w)))
        return code_non_finite;
    const Scalar limit = side * w;
    const int planes = (z <= w ? 0 : code_z_high) | (z >= 0 ? 0 : code_z_low) |
                       (x >= -limit ? 0 : code_x_low) | (x <= limit ? 0 : code_x_high) |
                       (y >= -limit ? 0 : code_y_low) | (y <= limit ? 0 : code_y_high);
    if (planes != 0) return static_cast<ClipCodes>(planes);
    if (w == 0) return code_origin;
    return std::isfinite(1 / w) ? ClipCodes{0} : code_non_finite;
}

}  // namespace relevo::pipeline
