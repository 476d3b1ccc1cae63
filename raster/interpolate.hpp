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

using pipeline::rounded;
using pipeline::to_wide;
using pipeline::Wide;

// A triangle in each lane; one triangle (Real = Scalar) serves the edge values of N lanes, too.
template <class Real>
struct InterpolatorOf {
    Wide<Real> z0, g1, g2;
    Wide<Real> rw0, rw1, rw2;  // 1 / w
};
using Interpolator = InterpolatorOf<Scalar>;

template <class Real>
InterpolatorOf<Real> make_interpolator(const TriangleOf<Real>& t) {
    const auto& [c0, c1, c2] = t.corner;
    const Wide<Real> z0 = to_wide(c0.z), inverse_area = 1.0 / to_wide(t.area);
    return {z0,
            (to_wide(c1.z) - z0) * inverse_area,
            (to_wide(c2.z) - z0) * inverse_area,
            to_wide(c0.rw),
            to_wide(c1.rw),
            to_wide(c2.rw)};
}

// Error against the plane through the snapped corners: at most 2^-23 max |z_i| (half of it is the final
// rounding).
template <class Real = Scalar, class Corners>
Real depth(const InterpolatorOf<Corners>& i, const EdgeValuesOf<Real>& e) {
    return rounded(i.z0 + (to_wide(e.e1) * i.g1 + to_wide(e.e2) * i.g2));
}

template <class Real>
struct PerspectiveWeightsOf {
    Real b1, b2;
    Wide<Real> s;  // area / w of the pixel
};
using PerspectiveWeights = PerspectiveWeightsOf<Scalar>;
// |a - exact| <= (8 max |a_i| + 2 |a|) 2^-24 for every attribute, at any ratio of the corners' w.
template <class Real = Scalar, class Corners>
PerspectiveWeightsOf<Real> perspective_weights(const InterpolatorOf<Corners>& i,
                                               const EdgeValuesOf<Real>& e) {
    const Wide<Real> q0 = to_wide(e.e0) * i.rw0, q1 = to_wide(e.e1) * i.rw1, q2 = to_wide(e.e2) * i.rw2;
    const Wide<Real> s = q0 + (q1 + q2), r = 1.0 / s;
    return {rounded(q1 * r), rounded(q2 * r), s};
}

// The numbers that the corners carry, as a value at corner 0 and two differences.
template <std::size_t N, class Real = Scalar>
struct VaryingPlane {
    std::array<Real, N> a0, d1, d2;
};
template <std::size_t N, class Real = Scalar>
VaryingPlane<N, Real> make_plane(const std::array<Real, N>& a0, const std::array<Real, N>& a1,
                                 const std::array<Real, N>& a2) {
    VaryingPlane<N, Real> plane;
    for (std::size_t k = 0; k < N; ++k)
        plane.a0[k] = a0[k], plane.d1[k] = a1[k] - a0[k], plane.d2[k] = a2[k] - a0[k];
    return plane;
}
template <std::size_t N, class Corners, class Real = Scalar>
std::array<Real, N> interpolate(const VaryingPlane<N, Corners>& plane, const PerspectiveWeightsOf<Real>& b) {
    std::array<Real, N> a;
    for (std::size_t k = 0; k < N; ++k) a[k] = plane.a0[k] + (b.b1 * plane.d1[k] + b.b2 * plane.d2[k]);
    return a;
}

}  // namespace relevo::raster
