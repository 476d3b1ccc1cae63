// Division by w, viewport and snapping: clip space to subpixels of the window, in one step of double
// arithmetic.
//
//   X = rint((x/w) 128 W + 128 W)     Y = rint(128 H - (y/w) 128 H)     in 1/256 pixel, ties to even
//   z = z_clip / w                    rw = 1 / w                        rounded once each
// Source: Direct3D 11.3 functional specification 3.4.1 and 15.16 (n.8 snapping); textbook 3.2 (window and
// viewport). Error of X and Y: 1/512 pixel. With |x|, |y| <= 7 w and W, H <= 8192: |X|, |Y| <= 2^23.
#pragma once
#include "pipeline/lane_vector.hpp"
#include "pipeline/space.hpp"

namespace relevo::pipeline {

struct Viewport {
    int width, height;  // pixels, 1..max_picture_size
};

// A corner in the window: what the rasterizer works with.
template <class Real>
struct SnappedCornerOf {
    Whole<Real> x, y;  // 1/256 pixel, y down
    Real z;            // depth
    Real rw;           // 1 / w
};
using SnappedCorner = SnappedCornerOf<Scalar>;

struct Divided {
    Point<Ndc> ndc;
    Scalar rw;
};

// For pictures and lessons; the machine goes from clip space to subpixels directly (to_window). w must not be
// 0.
inline Divided perspective_divide(const HPoint<Clip>& p) {
    const double i = 1.0 / static_cast<double>(p.v.w);
    return {{{static_cast<Scalar>(p.v.x * i), static_cast<Scalar>(p.v.y * i), p.v.z / p.v.w}}, 1 / p.v.w};
}

// `p` passed every clip test (no clip code): w > 0, |x|, |y| <= 7 w.
template <class Real>
SnappedCornerOf<Real> lanes_to_window(const Vec4Of<Real>& p, const Viewport& viewport) {
    const Wide<Real> i = 1.0 / to_wide(p.w);
    const double half_width = 128.0 * viewport.width, half_height = 128.0 * viewport.height;
    const Wide<Real> x = (to_wide(p.x) * i) * half_width + half_width;
    const Wide<Real> y = half_height - (to_wide(p.y) * i) * half_height;
    return {nearest(x), nearest(y), p.z / p.w, 1 / p.w};
}
inline SnappedCorner to_window(const HPoint<Clip>& p, const Viewport& viewport) {
    return lanes_to_window<Scalar>(p.v, viewport);
}

}  // namespace relevo::pipeline
