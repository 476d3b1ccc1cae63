// What a texel takes along on its way through the resamplers, and the arithmetic of it.
//
// All of it is interpolated perspective-correctly: not by the share t of the way in the warped picture,
// but by
//
//     t' = t w_B / ((1 - t) w_A + t w_B)          w = h / (h + d), itself linear in t
//
// one correction for all numbers, as in raster/interpolate.hpp. At t = 0 they come out as they are, to
// the bit.
#pragma once
#include "relief/warp.hpp"

namespace relevo::relief {

// Four numbers side by side. Each operation is that of the numbers one by one, whatever the machine
// makes of it.
using Four __attribute__((vector_size(4 * sizeof(Scalar)))) = Scalar;

template <bool maps>
struct Carried {
    static constexpr int parts = maps ? 3 : 2;
    // red green blue depth | normal x y z, growth | source u v, two unused
    Four part[parts];

    // behind the plane, in world units
    Scalar depth() const { return part[0][3]; }
    // how much deeper the surface gets beyond its last texel in a column (resample_line.hpp)
    Scalar growth() const { return part[1][3]; }
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

// The constants of a warp as the loops use them: rounded once, and for a depth d behind the plane in
// world units, of either source: q = d of an orthographic one, q = -d / (H + d) of a perspective one
// whose eye is H from the plane.
struct DepthWarp {
    Scalar k1, k2, k3, inverse_h;
    Scalar inverse_source_h;  // 1 / H; 0: orthographic
    explicit DepthWarp(const Warp& warp)
        : k1(static_cast<Scalar>(warp.k1)),
          k2(static_cast<Scalar>(warp.k2)),
          k3(static_cast<Scalar>(warp.k3)),
          inverse_h(static_cast<Scalar>(1 / warp.h)),
          inverse_source_h(static_cast<Scalar>(1 / warp.source_h)) {}
};

inline Scalar weight_at(Scalar depth, const DepthWarp& warp) { return 1 / (1 + depth * warp.inverse_h); }
inline Scalar parameter_at(Scalar depth, Scalar inverse_source_h) {
    const Scalar share = depth * inverse_source_h;
    return inverse_source_h == 0 ? depth : -share / (1 + share);
}
// The place u_i or v_i to which a depth takes place u or v of the source; in texels of the plane.
inline Scalar warped_u(Scalar u, Scalar depth, const DepthWarp& warp) {
    const Scalar q = parameter_at(depth, warp.inverse_source_h);
    return (u + warp.k1 * q) * (1 / (1 + warp.k3 * q));
}
inline Scalar warped_v(Scalar v, Scalar depth, const DepthWarp& warp) {
    const Scalar q = parameter_at(depth, warp.inverse_source_h);
    return (v + warp.k2 * q) * (1 / (1 + warp.k3 * q));
}

}  // namespace relevo::relief
