// A vector of length 1, for any finite input.
#pragma once
#include <algorithm>
#include <cmath>

#include "pipeline/scalar.hpp"

namespace relevo::pipeline {

constexpr Scalar dot(const Vec3& a, const Vec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Squared lengths outside [1e-30, 1e30] are brought back by a power of two first, which rounds nothing.
// Zero stays zero; a vector with an infinite or undefined component becomes zero.
inline Vec3 normalize_extreme(const Vec3& v) {
    if (!(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z))) return {0, 0, 0};
    const Scalar largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0) return {0, 0, 0};
    const int e = std::ilogb(largest);
    const Vec3 s{std::ldexp(v.x, -e), std::ldexp(v.y, -e), std::ldexp(v.z, -e)};
    return s * (1 / std::sqrt(dot(s, s)));
}

// v * (1 / sqrt(v.v)): error below 3 ulp a component.
inline Vec3 normalize(const Vec3& v) {
    const Scalar squared = dot(v, v);
    if (!(squared >= Scalar(1e-30) && squared <= Scalar(1e30))) return normalize_extreme(v);
    return v * (1 / std::sqrt(squared));
}

}  // namespace relevo::pipeline
