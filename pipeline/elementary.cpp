#include "pipeline/elementary.hpp"

#include <limits>

namespace relevo::pipeline {
namespace {

// c[0] + c[1] x + ... by Horner's rule.
template <int N>
double polynomial(const double (&c)[N], double x) {
    double sum = c[N - 1];
    for (int i = N - 2; i >= 0; --i) sum = sum * x + c[i];
    return sum;
}

// Taylor series on |x| <= pi/4: the first term left out is below 2^-58.
double sin_reduced(double x) {
    static constexpr double c[] = {1.0 / 6,        -1.0 / 120,          1.0 / 5040,           -1.0 / 362880,
                                   1.0 / 39916800, -1.0 / 6227020800.0, 1.0 / 1307674368000.0};
    return x - x * (x * x) * polynomial(c, x * x);
}
double cos_reduced(double x) {
    static constexpr double c[] = {
        1.0 / 2,       -1.0 / 24,          1.0 / 720,           -1.0 / 40320,
        1.0 / 3628800, -1.0 / 479001600.0, 1.0 / 87178291200.0, -1.0 / 20922789888000.0};
    return 1 - (x * x) * polynomial(c, x * x);
}

struct Reduced {
    int quarter;     // 0..3
    double radians;  // -pi/4..pi/4
};

// angle = 90 (4 k + quarter) + rest. fmod and the subtraction are exact.
Reduced reduce(Degrees angle) {
    const double turn = std::fmod(angle.value, 360.0);
    const double quarters = std::floor(turn / 90 + 0.5);
    return {static_cast<int>(quarters) & 3, (turn - 90 * quarters) * (pi / 180)};
}

}  // namespace

double sin(Degrees angle) {
    if (!std::isfinite(angle.value)) return std::numeric_limits<double>::quiet_NaN();
    const auto [quarter, x] = reduce(angle);
    const double s = (quarter & 1) ? cos_reduced(x) : sin_reduced(x);
    return (quarter & 2) ? -s : s;
}

double cos(Degrees angle) {
    if (!std::isfinite(angle.value)) return std::numeric_limits<double>::quiet_NaN();
    const auto [quarter, x] = reduce(angle);
    const double c = (quarter & 1) ? sin_reduced(x) : cos_reduced(x);
    return (quarter == 1 || quarter == 2) ? -c : c;
}

double tan(Degrees angle) { return sin(angle) / cos(angle); }

// Two halvings of the angle, atan x = 2 atan(x / (1 + sqrt(1 + x^2))), bring |x| <= 1 below 0.199; then the
// series x - x^3/3 + x^5/5 ..., whose first term left out is below 2^-59.
double arc_tangent(double x) {
    for (int i = 0; i < 2; ++i) x /= 1 + std::sqrt(1 + x * x);
    double sum = 0;
    for (int n = 23; n > 0; n -= 2) sum = 1.0 / n - x * x * sum;
    return 4 * x * sum;
}

Degrees angle_of(double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return {std::numeric_limits<double>::quiet_NaN()};
    const double across = std::fabs(x), up = std::fabs(y), larger = std::fmax(across, up);
    if (larger == 0) return {0};
    double angle = arc_tangent(std::fmin(across, up) / larger) * (180 / pi);
    if (up > across) angle = 90 - angle;
    if (x < 0) angle = 180 - angle;
    return {y < 0 ? -angle : angle};
}

// x = 2^e m with sqrt(1/2) <= m < sqrt(2);  log2 m = 2/ln 2 (t + t^3/3 + t^5/5 ...),  t = (m - 1) / (m + 1).
double log2(double x) {
    if (!(x > 0))
        return x == 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    if (std::isinf(x)) return x;
    int e;
    double m = std::frexp(x, &e);
    if (m < 0x1.6a09e667f3bcdp-1) m *= 2, e -= 1;
    static constexpr double c[] = {1.0,      1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9, 1.0 / 11,
                                   1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21};
    const double t = (m - 1) / (m + 1);
    return e + 0x1.71547652b82fep+1 * (t * polynomial(c, t * t));
}

// 2^x = 2^i e^(f ln 2) with |f| <= 1/2, by the Taylor series of e^y on |y| <= 0.347.
double exp2(double x) {
    if (std::isnan(x)) return x;
    if (x < -1100) return 0;
    if (x > 1100) return std::numeric_limits<double>::infinity();
    const double i = std::floor(x + 0.5);
    static constexpr double c[] = {1.0,
                                   1.0,
                                   1.0 / 2,
                                   1.0 / 6,
                                   1.0 / 24,
                                   1.0 / 120,
                                   1.0 / 720,
                                   1.0 / 5040,
                                   1.0 / 40320,
                                   1.0 / 362880,
                                   1.0 / 3628800,
                                   1.0 / 39916800,
                                   1.0 / 479001600.0,
                                   1.0 / 6227020800.0};
    return std::ldexp(polynomial(c, (x - i) * 0x1.62e42fefa39efp-1), static_cast<int>(i));
}

Scalar general_power(Scalar x, Scalar n) {
    if (!(x > 0)) return 0;
    return x < 1 ? static_cast<Scalar>(exp2(static_cast<double>(n) * log2(static_cast<double>(x))))
                 : Scalar(1);
}

}  // namespace relevo::pipeline
