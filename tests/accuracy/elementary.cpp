// The functions of pipeline/elementary.hpp and normalize.hpp against 50 digits.
#include "pipeline/elementary.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "pipeline/normalize.hpp"
#include "tests/accuracy/measurement.hpp"

namespace relevo::accuracy {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;
using pipeline::Degrees;
using pipeline::Scalar;
using pipeline::Vec3;

Exact radians(double degrees) { return Exact(degrees) * boost::math::constants::pi<Exact>() / 180; }

double distance(double ours, const Exact& exact) { return double(abs(Exact(ours) - exact)); }
double relative(double ours, const Exact& exact) { return double(abs((Exact(ours) - exact) / exact)); }

template <class Ours, class Theirs>
Measured over_angles(Ours ours, Theirs error) {
    Random random(1);
    Measured worst;
    for (int i = 0; i < 6000; ++i) {
        const double a = i % 3 == 0 ? random.between(-1e6, 1e6) : random.between(-360, 360);
        worst.see(error(ours(Degrees{a}), radians(a)), [&] { return text("%.17g degrees", a); });
    }
    return worst;
}

Measured measure_sin() {
    return over_angles(pipeline::sin, [](double s, const Exact& a) { return distance(s, sin(a)) / 0x1p-52; });
}
Measured measure_cos() {
    return over_angles(pipeline::cos, [](double c, const Exact& a) { return distance(c, cos(a)) / 0x1p-52; });
}
Measured measure_tan() {
    return over_angles(pipeline::tan, [](double t, const Exact& a) { return relative(t, tan(a)) / 0x1p-52; });
}

Measured measure_direction() {
    Random random(9);
    Measured worst;
    for (int i = 0; i < 6000; ++i) {
        const double x = random.between(-1, 1), y = random.between(-1, 1);
        worst.see(distance(pipeline::angle_of(x, y).value, atan2(Exact(y), Exact(x)) / radians(1)) / 0x1p-44,
                  [&] { return text("(%.17g, %.17g)", x, y); });
    }
    return worst;
}
Measured measure_log2() {
    Random random(2);
    Measured worst;
    for (int i = 0; i < 8000; ++i) {
        const double x = i % 2 ? random.of_any_size(0x1p-149, 1) : random.between(0.5, 2);
        if (x == 1) continue;
        const Exact exact = log(Exact(x)) / log(Exact(2));
        worst.see(relative(pipeline::log2(x), exact) / 0x1p-52, [&] { return text("x = %.17g", x); });
    }
    return worst;
}
Measured measure_exp2() {
    Random random(3);
    Measured worst;
    for (int i = 0; i < 8000; ++i) {
        const double x = i % 2 ? random.between(-1000, 1000) : random.between(-1, 1);
        worst.see(relative(pipeline::exp2(x), pow(Exact(2), Exact(x))) / 0x1p-52,
                  [&] { return text("x = %.17g", x); });
    }
    return worst;
}

Exact whole_power(Scalar x, int n) {
    Exact product = 1;
    for (int i = 0; i < n; ++i) product *= Exact(x);
    return product;
}

Measured measure_whole_power(int low, int high) {
    Random random(4);
    Measured worst;
    for (int i = 0; i < 20000; ++i) {
        const int n = random.whole(low, high);
        const auto x = static_cast<Scalar>(random.between(0.4, 1));
        const Scalar ours = pipeline::power(x, static_cast<Scalar>(n));
        if (ours < Scalar(0x1p-120)) continue;
        worst.see(relative(ours, whole_power(x, n)) / float_unit,
                  [&] { return text("%.9g to the power of %d", double(x), n); });
    }
    return worst;
}
Measured measure_power_32() { return measure_whole_power(32, 32); }
Measured measure_power_128() { return measure_whole_power(1, 128); }

Measured measure_general_power() {
    Random random(5);
    Measured worst;
    for (int i = 0; i < 4000; ++i) {
        const auto n = static_cast<Scalar>(random.of_any_size(0.01, 1000));
        const auto x = static_cast<Scalar>(random.between(i % 2 ? 0.9 : 0.01, 1));
        const Scalar ours = pipeline::general_power(x, n);
        if (ours < Scalar(0x1p-120)) continue;
        worst.see(relative(ours, pow(Exact(x), Exact(n))) / float_unit,
                  [&] { return text("%.9g to the power of %.9g", double(x), double(n)); });
    }
    return worst;
}

Measured measure_normalize() {
    Random random(6);
    Measured worst;
    for (int i = 0; i < 20000; ++i) {
        const double size = i % 4 == 0 ? random.of_any_size(1e-37, 1e37) : 1;
        const Vec3 v{static_cast<Scalar>(random.between(-size, size)),
                     static_cast<Scalar>(random.between(-size, size)),
                     static_cast<Scalar>(random.between(-size, size))};
        const Exact x = v.x, y = v.y, z = v.z, length = sqrt(x * x + y * y + z * z);
        const Vec3 ours = pipeline::normalize(v);
        const double error = std::max(
            {distance(ours.x, x / length), distance(ours.y, y / length), distance(ours.z, z / length)});
        worst.see(error / float_unit,
                  [&] { return text("(%.9g, %.9g, %.9g)", double(v.x), double(v.y), double(v.z)); });
    }
    return worst;
}

constexpr Measurement measurements[] = {
    {"sin", measure_sin},
    {"cos", measure_cos},
    {"tan", measure_tan},
    {"direction", measure_direction},
    {"log2", measure_log2},
    {"exp2", measure_exp2},
    {"power, exponent 32", measure_power_32},
    {"power, whole exponent", measure_power_128},
    {"power, any exponent", measure_general_power},
    {"normalize", measure_normalize},
};

}  // namespace

std::span<const Measurement> elementary_measurements() { return measurements; }

}  // namespace relevo::accuracy
