// Interpolation over a triangle: weights from the exact edge values, depth, perspective correction
// (Heckbert and Moreton 1991; Blinn 1992; textbook 9.3).
//
//   l_i = E_i / area              z = z0 + (l1 (z1 - z0) + l2 (z2 - z0))          linear in the window
//   q_i = l_i / w_i    s = q0 + (q1 + q2)    b_i = q_i / s    a = a0 + (b1 (a1 - a0) + b2 (a2 - a0))
// The differences make a constant come out exactly constant, and treat corners 1 and 2 alike.
#pragma once
#include <array>
#include <cmath>

#include "raster/triangle_edge.hpp"

namespace relevo::raster {

struct Weights {
    Scalar l0, l1, l2;  // barycentric in the window; each within 1.5 ulp
};

struct Interpolator {
    Scalar inverse_area;
    Scalar z0, dz1, dz2;
    Scalar rw0, rw1, rw2;  // 1 / w, times a power of two when they are huge or tiny
    Scalar rw_unit;        // that power's inverse
};

// Perspective weights do not change when all 1/w are scaled together; a power of two rounds nothing and keeps
// the sums in range for any w that a float can hold.
inline Interpolator make_interpolator(const Triangle& t) {
    const auto& [c0, c1, c2] = t.corner;
    Interpolator i{1 / static_cast<Scalar>(t.area), c0.z, c1.z - c0.z, c2.z - c0.z, c0.rw, c1.rw, c2.rw, 1};
    const Scalar largest = std::max({c0.rw, c1.rw, c2.rw});
    if (largest > Scalar(0x1p96) || largest < Scalar(0x1p-96)) {
        const int e = std::ilogb(largest);
        i.rw0 = std::ldexp(c0.rw, -e), i.rw1 = std::ldexp(c1.rw, -e), i.rw2 = std::ldexp(c2.rw, -e);
        i.rw_unit = std::ldexp(Scalar(1), e);
    }
    return i;
}

inline Weights weights(const Interpolator& i, const EdgeValues& e) {
    return {static_cast<Scalar>(e.e0) * i.inverse_area, static_cast<Scalar>(e.e1) * i.inverse_area,
            static_cast<Scalar>(e.e2) * i.inverse_area};
}

// Error against the plane through the snapped corners: at most 2^-23 max |z_i|.
inline Scalar depth(const Interpolator& i, Scalar l1, Scalar l2) { return i.z0 + (l1 * i.dz1 + l2 * i.dz2); }

struct PerspectiveWeights {
    Scalar b1, b2;
    Scalar s;  // 1/w of the pixel, in units of rw_unit
};
inline PerspectiveWeights perspective_weights(const Interpolator& i, const Weights& l) {
    const Scalar q0 = l.l0 * i.rw0, q1 = l.l1 * i.rw1, q2 = l.l2 * i.rw2;
    const Scalar s = q0 + (q1 + q2), r = 1 / s;
    return {q1 * r, q2 * r, s};
}

// The numbers that the corners carry, as a value at corner 0 and two differences.
template <std::size_t N>
struct VaryingPlane {
    std::array<Scalar, N> a0, d1, d2;
};
template <std::size_t N>
VaryingPlane<N> make_plane(const std::array<Scalar, N>& a0, const std::array<Scalar, N>& a1,
                           const std::array<Scalar, N>& a2) {
    VaryingPlane<N> plane;
    for (std::size_t k = 0; k < N; ++k)
        plane.a0[k] = a0[k], plane.d1[k] = a1[k] - a0[k], plane.d2[k] = a2[k] - a0[k];
    return plane;
}
template <std::size_t N>
std::array<Scalar, N> interpolate(const VaryingPlane<N>& plane, const PerspectiveWeights& b) {
    std::array<Scalar, N> a;
    for (std::size_t k = 0; k < N; ++k) a[k] = plane.a0[k] + (b.b1 * plane.d1[k] + b.b2 * plane.d2[k]);
    return a;
}

}  // namespace relevo::raster
