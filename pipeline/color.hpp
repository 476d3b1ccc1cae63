// Colour as the pipeline computes with it: linear light, red green blue.
#pragma once
#include <type_traits>

#include "pipeline/lane.hpp"

namespace relevo::pipeline {

// A colour in each lane.
template <class Real>
struct RgbOf {
    Real r = 0, g = 0, b = 0;
    // the same colour in all lanes
    template <class Lanes>
    requires(std::is_same_v<Real, Scalar> && !std::is_same_v<Lanes, Scalar>) constexpr operator RgbOf<Lanes>()
        const {
        return {r, g, b};
    }
};
using LinearRgb = RgbOf<Scalar>;
constexpr bool operator==(const LinearRgb& a, const LinearRgb& b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

template <class Real>
constexpr RgbOf<Real> operator+(RgbOf<Real> a, RgbOf<Real> b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
template <class Real>
constexpr RgbOf<Real> operator*(RgbOf<Real> a, RgbOf<Real> b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
template <class Real>
constexpr RgbOf<Real> operator*(std::type_identity_t<Real> k, RgbOf<Real> a) {
    return {k * a.r, k * a.g, k * a.b};
}
template <class Real>
requires(!std::is_same_v<Real, Scalar>) constexpr RgbOf<Real> select(std::type_identity_t<Mask<Real>> mask,
                                                                     const RgbOf<Real>& yes,
                                                                     const RgbOf<Real>& no) {
    return {select(mask, yes.r, no.r), select(mask, yes.g, no.g), select(mask, yes.b, no.b)};
}

}  // namespace relevo::pipeline
