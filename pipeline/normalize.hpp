// A vector of length 1, for any finite input.
#pragma once
#include "pipeline/lane_vector.hpp"

namespace relevo::pipeline {

template <class Real>
constexpr Real dot(const Vec3Of<Real>& a, const Vec3Of<Real>& b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <class Real>
constexpr Vec3Of<Real> cross(const Vec3Of<Real>& a, const Vec3Of<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Squared lengths outside [1e-30, 1e30] are brought back by a power of two first, which rounds nothing.
// Zero stays zero; a vector with an infinite or undefined component becomes zero.
[[gnu::cold]] Vec3 normalize_extreme(Vec3 v);

// v * (1 / sqrt(v.v)): error below 3 ulp a component.
template <class Real>
[[gnu::always_inline]] inline Vec3Of<Real> normalize(const Vec3Of<Real>& v) {
    const Real squared = dot<Real>(v, v);
    const Mask<Real> usual = squared >= Scalar(1e-30) && squared <= Scalar(1e30);
    if (all(usual)) return v * (1 / sqrt(squared));
    return select(usual, v * (1 / sqrt(squared)), each_lane(normalize_extreme, v));
}

// The same for plain numbers: no template, so that GLM's functions of these names are never a better match.
constexpr Scalar dot(const Vec3& a, const Vec3& b) { return pipeline::dot<Scalar>(a, b); }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) { return pipeline::cross<Scalar>(a, b); }
inline Vec3 normalize(const Vec3& v) { return pipeline::normalize<Scalar>(v); }

}  // namespace relevo::pipeline
