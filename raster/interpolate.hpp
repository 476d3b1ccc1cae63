// Interpolation over a triangle: depth and perspective-correct weights from the exact edge values
// (Heckbert and Moreton 1991; Blinn 1992; textbook 9.3).
//
//   z = z0 + (E1 g1 + E2 g2)      g_i = (z_i - z0) (1 / area)                     linear in the window
//   q_i = E_i / w_i    s = q0 + (q1 + q2)    b_i = q_i (1 / s)    a = a0 + (b1 (a1 - a0) + b2 (a2 - a0))
//
// Depth and weights are computed in double, where an edge value is exact, and rounded once; float ones would
// miss the bounds below (their rounded differences alone cost 3 * 2^-24 max |z|). The attributes themselves
// are Scalar. The differences make a constant come out exactly constant, and treat corners 1 and 2 alike.
#pragma once
#include <array>

#include "raster/triangle_edge.hpp"

namespace relevo::raster {

struct Interpolator {
    double z0, g1, g2;
    double rw0, rw1, rw2;  // 1 / w
};

inline Interpolator make_interpolator(const Triangle& t) {
    const auto& [c0, c1, c2] = t.corner;
    const double z0 = c0.z, inverse_area = 1 / static_cast<double>(t.area);
    return {z0, (c1.z - z0) * inverse_area, (c2.z - z0) * inverse_area, c0.rw, c1.rw, c2.rw};
}

// Error against the plane through the snapped corners: at most 2^-23 max |z_i| (half of it is the final
// rounding).
inline Scalar depth(const Interpolator& i, const EdgeValues& e) {
    return static_cast<Scalar>(i.z0 + (static_cast<double>(e.e1) * i.g1 + static_cast<double>(e.e2) * i.g2));
}

struct PerspectiveWeights {
    Scalar b1, b2;
    double s;  // area / w of the pixel
};
// |a - exact| <= (8 max |a_i| + 2 |a|) 2^-24 for every attribute, at any ratio of the corners' w.
inline PerspectiveWeights perspective_weights(const Interpolator& i, const EdgeValues& e) {
    const double q0 = static_cast<double>(e.e0) * i.rw0, q1 = static_cast<double>(e.e1) * i.rw1,
                 q2 = static_cast<double>(e.e2) * i.rw2;
    const double s = q0 + (q1 + q2), r = 1 / s;
    return {static_cast<Scalar>(q1 * r), static_cast<Scalar>(q2 * r), s};
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
