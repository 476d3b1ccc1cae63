// What a texel takes along on its way through the resamplers, and the arithmetic of it.
//
// All of it is interpolated perspective-correctly: not by the share t of the way in the warped picture, but
// by
//
//     t' = t w_B / ((1 - t) w_A + t w_B)          w = h / (h + d), itself linear in t
//
// one correction for all numbers, as in raster/interpolate.hpp. At t = 0 they come out as they are, to the
// bit.
#pragma once
#include "relief/warp.hpp"

namespace relevo::relief {

// Four numbers side by side. Each operation is that of the numbers one by one, whatever the machine makes of
// it.
using Four __attribute__((vector_size(4 * sizeof(Scalar)))) = Scalar;

template <bool maps>
struct Carried {
    static constexpr int parts = maps ? 3 : 2;
    // red green blue depth | normal x y z, slope | source u v, two unused
    Four part[parts];

    // behind the plane, in world units
    Scalar depth() const { return part[0][3]; }
    // how fast the depth grows beyond the row of texels, where the surface ends (resample_line.hpp)
    Scalar slope() const { return part[1][3]; }
    void set_depth(Scalar depth) { part[0][3] = depth; }
};

template <bool maps>
[[gnu::always_inline]] inline Carried<maps> lerp(const Carried<maps>& a, const Carried<maps>& b,
                                                 Scalar corrected) {
    Carried<maps> c;
    for (int k = 0; k < Carried<maps>::parts; ++k)
        c.part[k] = a.part[k] + corrected * (b.part[k] - a.part[k]);
    return c;
}
// t', from distances that are in the ratio of t and 1 - t, both of one sign.
inline Scalar corrected_share(Scalar weight_a, Scalar weight_b, Scalar from_a, Scalar to_b) {
    const Scalar share_a = to_b * weight_a, share_b = from_a * weight_b;
    return share_b / (share_a + share_b);
}

// The constants of a warp as the loops use them: rounded once, and for a depth d behind the plane in world
// units, of either source:
//
//     w = 1 / (1 + d / h)       1 / (1 + k3 q) = w (1 + d / H)       q / (1 + k3 q) = w d s
//
// with H the height of the source's eye, 1 / H = 0 and s = 1 for an orthographic source, else s = -1 / H. So
// the place in the warped picture needs no division once the weight is known.
struct DepthWarp {
    Scalar inverse_h, inverse_source_h, k1s, k2s;
    explicit DepthWarp(const Warp& warp)
        : inverse_h(static_cast<Scalar>(1 / warp.h)),
          inverse_source_h(static_cast<Scalar>(1 / warp.source_h)) {
        const double s = warp.projection == Projection::Orthographic ? 1 : -1 / warp.source_h;
        k1s = static_cast<Scalar>(s * warp.k1), k2s = static_cast<Scalar>(s * warp.k2);
    }
};

inline Scalar weight_at(Scalar depth, const DepthWarp& warp) { return 1 / (1 + depth * warp.inverse_h); }
// The place u_i or v_i to which depth and weight take place u or v of the source; in texels of the plane.
inline Scalar warped_u(Scalar u, Scalar depth, Scalar weight, const DepthWarp& warp) {
    return weight * (u * (1 + depth * warp.inverse_source_h) + depth * warp.k1s);
}
inline Scalar warped_v(Scalar v, Scalar depth, Scalar weight, const DepthWarp& warp) {
    return weight * (v * (1 + depth * warp.inverse_source_h) + depth * warp.k2s);
}

}  // namespace relevo::relief
