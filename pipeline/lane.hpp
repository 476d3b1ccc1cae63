// The words of the arithmetic that every path through the machine shares, for one lane: a plain number.
//
// The formulas that decide a pixel (transform, division, depth, weights, light, texture, output) are written
// once, as templates over a number `Real`. Here Real is Scalar and the reader may take select() for ?: and
// any() for nothing at all. The fast path puts N numbers side by side in its place (raster/fast/lanes.hpp)
// and gets, operation by operation, the same bits.
//
//   Real      the number itself                      Mask<Real>     what a comparison of two gives
//   Wide      a double for each lane                 Whole<Real>    an int32 for each lane
//   BigWhole  a whole number below 2^53              Word<Real>     32 bits for each lane, sums mod 2^32
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
    using BigWhole = std::int64_t;
    using Word = std::uint32_t;
};
template <class Real>
using Mask = typename LaneTypes<Real>::Mask;
template <class Real>
using Wide = typename LaneTypes<Real>::Wide;
template <class Real>
using Whole = typename LaneTypes<Real>::Whole;
template <class Real>
using BigWhole = typename LaneTypes<Real>::BigWhole;
template <class Real>
using Word = typename LaneTypes<Real>::Word;

using std::floor;
using std::sqrt;

constexpr bool any(bool mask) { return mask; }
constexpr bool all(bool mask) { return mask; }
template <class T>
constexpr T select(bool mask, const T& yes, const T& no) {
    return mask ? yes : no;
}

// a where a > b (a < b), else b: b where one is not a number, and of two zeros b.
constexpr Scalar greater(Scalar a, Scalar b) { return a > b ? a : b; }
constexpr Scalar smaller(Scalar a, Scalar b) { return a < b ? a : b; }

inline bool is_finite(Scalar x) { return std::isfinite(x); }

// Between the number types: to_wide, to_big, to_word and to_whole are exact; rounded() and to_real() round
// once, to nearest even; nearest() goes to the nearest int32, ties to even; truncated() drops the fraction of
// a number within int32.
constexpr double to_wide(Scalar x) { return x; }
constexpr double to_wide(std::int32_t x) { return x; }
constexpr double to_wide(std::int64_t x) { return static_cast<double>(x); }
constexpr std::int64_t to_big(std::int32_t x) { return x; }
constexpr std::uint32_t to_word(std::int32_t x) { return static_cast<std::uint32_t>(x); }
constexpr std::int32_t to_whole(std::uint32_t x) { return static_cast<std::int32_t>(x); }
constexpr Scalar rounded(double x) { return static_cast<Scalar>(x); }
inline std::int32_t nearest(double x) { return static_cast<std::int32_t>(std::lrint(x)); }
constexpr std::int32_t truncated(Scalar x) { return static_cast<std::int32_t>(x); }
constexpr Scalar to_real(std::int32_t x) { return static_cast<Scalar>(x); }
constexpr Scalar to_real(std::uint32_t x) { return static_cast<Scalar>(std::int64_t{x}); }

// table[index] of each lane.
constexpr std::uint32_t look_up(const std::uint32_t* table, std::int32_t index) { return table[index]; }

// f of each lane, for the rare formula that is only written for one.
template <class F, class T>
T each_lane(F&& f, const T& x) {
    return f(x);
}

}  // namespace relevo::pipeline
