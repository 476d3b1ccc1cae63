// Sine, cosine, tangent, powers and logarithms of our own.
//
// The math library's versions differ from one processor and one release to the next, and a last bit can move
// a pixel. These use only + - * / and exact scalings, so they give the same bits everywhere. Their errors
// stand in the accuracy table. Angles are in degrees, because then a quarter turn is exact.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "pipeline/lane.hpp"

namespace relevo::pipeline {

inline constexpr double pi = 0x1.921fb54442d18p+1;

struct Degrees {
    double value;
};

// sin and cos of any finite angle; exact at multiples of 90 degrees, else within 1 ulp of 1. Not finite: not
// a number.
double sin(Degrees angle);
double cos(Degrees angle);
// sin / cos; infinite at odd multiples of 90 degrees.
double tan(Degrees angle);

// The angle whose tangent is x, in radians, for |x| <= 1 (error < 2^-52).
double arc_tangent(double x);
// The direction of (x, y), counter-clockwise from +x, in (-180, 180]; exact along the axes, else within 2^-44
// degrees. (0, 0): 0. Not finite: not a number.
Degrees angle_of(double x, double y);

// log2(x) for x > 0 (relative error < 2^-50); -infinity for 0, not a number below.
double log2(double x);
// 2^x (relative error < 2^-50); 0 below -1100, infinity above 1100.
double exp2(double x);

// x^n for the light equation: x is a cosine, n >= 0. x <= 0 gives 0, also for n = 0: no light from behind.
// An integer n in 1..128: square and multiply from the highest bit of n down, in this order (relative error <
// 2 n ulp). Any other n: exp2(n log2(x)) in double, rounded once; x > 1, a rounding accident, then counts
// as 1. Where the power would be below 2^-126 it is 0: light too faint to see is not worth denormal numbers,
// which cost a processor a hundred times a usual product.

// The same with what depends on n alone taken out of the loop over pixels.
struct Exponent {
    Scalar value;
    int integer;      // 1..128, or 0 for any other exponent
    int highest;      // the highest bit of `integer`
    Scalar smallest;  // x whose power is 2^-126; > 0
};
inline Exponent exponent(Scalar n) {
    const bool small_integer = n >= 1 && n <= 128 && static_cast<Scalar>(static_cast<int>(n)) == n;
    const int integer = small_integer ? static_cast<int>(n) : 0;
    using Limits = std::numeric_limits<Scalar>;
    const double smallest = n > 0 ? exp2((Limits::min_exponent - 1) / static_cast<double>(n)) : 0;
    return {n, integer, static_cast<int>(std::bit_floor(static_cast<unsigned>(integer))),
            std::max(static_cast<Scalar>(smallest), Limits::denorm_min())};
}
Scalar general_power(Scalar x, Scalar n);

template <class Real>
[[gnu::always_inline]] inline Real power(Real x, Exponent n) {
    const Mask<Real> counts = x >= n.smallest;
    if (!any(counts)) return 0;
    x = select(counts, x, Real(0));
    if (n.integer == 0) return each_lane([&](Scalar lane) { return general_power(lane, n.value); }, x);
    Real result = x;
    for (int bit = n.highest >> 1; bit > 0; bit >>= 1) {
        result = result * result;
        if (n.integer & bit) result = result * x;
    }
    return result;
}
inline Scalar power(Scalar x, Scalar n) { return power(x, exponent(n)); }

}  // namespace relevo::pipeline
