// The words of the arithmetic that every path through the machine shares, for one lane: a plain number.
//
// The formulas that decide a pixel (transform, division, depth, weights, light, texture, output) are written
// once, as templates over a number `Real`. Here Real is Scalar and the reader may take select() for ?: and
// any() for nothing at all. The fast path puts N numbers side by side in its place (raster/fast/lanes.hpp)
// and gets, operation by operation, the same bits.
//
//   Real      the number itself                      Mask<Real>     what a comparison of two gives
//   Wide      a double for each lane                 Whole<Real>    an int32 for each lane
#pragma once
#include <cmath>
#include <cstdint>

#include "pipeline/scalar.hpp"

namespace relevo::pipeline {

template <class Real>
struct LaneTypes;
template <>
struct LaneTypes<Scalar> {
    using Mask = bool;
    using Wide = double;
    using Whole = std::int32_t;
};
template <class Real>
using Mask = typename LaneTypes<Real>::Mask;
template <class Real>
using Wide = typename LaneTypes<Real>::Wide;
template <class Real>
using Whole = typename LaneTypes<Real>::Whole;

using std::floor;
using std::sqrt;

constexpr bool any(bool mask) { return mask; }
constexpr bool all(bool mask) { return mask; }
template <class T>
constexpr T select(bool mask, const T& yes, const T& no) {
    return mask ? yes : no;
}

// Between the number types: to_wide and to_whole's inverses are exact; rounded() rounds once, to nearest
// even; truncated() drops the fraction of a number within int32.
constexpr double to_wide(Scalar x) { return x; }
constexpr double to_wide(std::int32_t x) { return x; }
constexpr Scalar rounded(double x) { return static_cast<Scalar>(x); }
constexpr std::int32_t truncated(Scalar x) { return static_cast<std::int32_t>(x); }
constexpr Scalar to_real(std::int32_t x) { return static_cast<Scalar>(x); }

// f of each lane, for the rare formula that is only written for one.
template <class F>
Scalar each_lane(F&& f, Scalar x) {
    return f(x);
}

}  // namespace relevo::pipeline
