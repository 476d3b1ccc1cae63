// Two, three or four numbers of each lane: for one lane GLM's vectors, for N a struct with the same x y z w.
#pragma once
#include <type_traits>

#include "pipeline/lane.hpp"

namespace relevo::pipeline {

template <class Real>
struct LaneVec2 {
    Real x, y;
};

template <class Real>
struct LaneVec3 {
    Real x, y, z;
    LaneVec3() = default;
    constexpr LaneVec3(Real x_, Real y_, Real z_) : x(x_), y(y_), z(z_) {}
    constexpr LaneVec3(const Vec3& all_lanes) : x(all_lanes.x), y(all_lanes.y), z(all_lanes.z) {}
};

template <class Real>
struct LaneVec4 {
    Real x, y, z, w;
};

template <class Real>
using Vec2Of = std::conditional_t<std::is_same_v<Real, Scalar>, Vec2, LaneVec2<Real>>;
template <class Real>
using Vec3Of = std::conditional_t<std::is_same_v<Real, Scalar>, Vec3, LaneVec3<Real>>;
template <class Real>
using Vec4Of = std::conditional_t<std::is_same_v<Real, Scalar>, Vec4, LaneVec4<Real>>;

template <class Real>
constexpr LaneVec3<Real> operator+(const LaneVec3<Real>& a, const LaneVec3<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
constexpr LaneVec3<Real> operator-(const LaneVec3<Real>& a, const LaneVec3<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
constexpr LaneVec3<Real> operator-(const LaneVec3<Real>& a) {
    return {-a.x, -a.y, -a.z};
}
template <class Real>
constexpr LaneVec3<Real> operator*(const LaneVec3<Real>& a, std::type_identity_t<Real> k) {
    return {a.x * k, a.y * k, a.z * k};
}
template <class Real>
constexpr LaneVec3<Real> operator*(std::type_identity_t<Real> k, const LaneVec3<Real>& a) {
    return {k * a.x, k * a.y, k * a.z};
}
template <class Real>
constexpr LaneVec3<Real> select(std::type_identity_t<Mask<Real>> mask, const LaneVec3<Real>& yes,
                                const LaneVec3<Real>& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

}  // namespace relevo::pipeline
