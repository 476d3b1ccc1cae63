// Light, texture and output, against real arithmetic.
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "pipeline/light.hpp"
#include "raster/output.hpp"
#include "raster/texture.hpp"
#include "tests/accuracy/measurement.hpp"

namespace relevo::accuracy {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;
using pipeline::Scalar;
using pipeline::Vec3;
using Long = long double;

// ---------------------------------------------------------------------------------------------------- light
struct LongVec {
    Long x, y, z;
};
Long dot(const LongVec& a, const LongVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
LongVec unit(const LongVec& v) {
    const Long length = std::sqrt(dot(v, v));
    return {v.x / length, v.y / length, v.z / length};
}
Vec3 to_vec3(const LongVec& v) {
    return {static_cast<Scalar>(v.x), static_cast<Scalar>(v.y), static_cast<Scalar>(v.z)};
}
LongVec to_long(const Vec3& v) { return {v.x, v.y, v.z}; }

Vec3 random_vec3(Random& random, double size) {
    return {static_cast<Scalar>(random.between(-size, size)),
            static_cast<Scalar>(random.between(-size, size)),
            static_cast<Scalar>(random.between(-size, size))};
}

Measured measure_light() {
    Random random(21);
    Measured worst;
    for (int i = 0; i < 50000; ++i) {
        const Vec3 point = random_vec3(random, 5) - Vec3{0, 0, 8}, lamp = random_vec3(random, 10);
        const Vec3 n = to_vec3(unit(to_long(random_vec3(random, 1))));
        const pipeline::EyeLight light{false, lamp, {1, 1, 1}};
        const pipeline::Lighting lighting{{&light, 1}, Scalar(0.125), 1, 1, pipeline::exponent(32), false};
        const auto ours = pipeline::reflect(lighting, point, n);
        const LongVec p = to_long(point), m = to_long(n);
        const LongVec l = unit({Long(lamp.x) - p.x, Long(lamp.y) - p.y, Long(lamp.z) - p.z});
        const LongVec v = unit({-p.x, -p.y, -p.z});
        const Long nl = dot(m, l);
        Long amount = Long(0.125), gloss = 0;
        if (nl > 0) {
            const Long rv = 2 * nl * dot(m, v) - dot(l, v);
            amount += nl, gloss = 1;
            for (int k = 0; k < 32; ++k) gloss *= std::max(rv, Long(0));
        }
        const Long error = std::max(std::abs(ours.amount.r - amount), std::abs(ours.gloss.r - gloss));
        worst.see(double(error) / float_unit, [&] {
            return text("point (%.9g, %.9g, %.9g), light (%.9g, %.9g, %.9g)", point.x, point.y, point.z,
                        lamp.x, lamp.y, lamp.z);
        });
    }
    return worst;
}

// -------------------------------------------------------------------------------------------------- texture
Long fraction(Long u) { return u - std::floor(u); }

// How far beyond the border of the texel found the exact place lies.
Measured measure_nearest() {
    Random random(22);
    Measured worst;
    raster::Texture texture{1024, 1, {}, 1};
    for (int x = 0; x < texture.width; ++x) texture.texels.push_back({std::uint16_t(x), 0, 0, 0});
    for (int i = 0; i < 200000; ++i) {
        const double near_border = random.whole(-1024, 2048) / 1024.0 + random.between(-1e-6, 1e-6);
        const auto u = static_cast<Scalar>(i % 2 ? near_border : random.between(-1, 2));
        const Long found = raster::sample_nearest(texture, {u, 0}).r, place = fraction(u) * texture.width;
        Long beyond = texture.width;
        for (const int turn : {-texture.width, 0, texture.width})  // the texture repeats
            beyond = std::min(beyond, std::max({found + turn - place, place - (found + turn + 1), Long(0)}));
        worst.see(double(beyond), [&] { return text("u = %.9g, 1024 texels", u); });
    }
    return worst;
}

// As a share of the difference between the texels.
Measured measure_bilinear() {
    Random random(23);
    Measured worst;
    const int size = 64;
    raster::Texture texture{size, size, {}, 1};
    for (int i = 0; i < size * size; ++i)
        texture.texels.push_back({std::uint16_t(((i % size) ^ (i / size)) & 1 ? 65535 : 0), 0, 0, 0});
    const auto along = [&](Scalar u) {  // 0 on the centre of an even texel, 1 on that of an odd one
        const Long t = fraction(u) * size - Long(0.5), low = std::floor(t);
        return int(low) & 1 ? 1 - (t - low) : t - low;
    };
    for (int i = 0; i < 200000; ++i) {
        const auto u = static_cast<Scalar>(random.between(-2, 2)),
                   v = static_cast<Scalar>(random.between(-2, 2));
        const Long a = along(u), b = along(v);
        const Long exact = a * (1 - b) + b * (1 - a);
        const Long ours = Long(raster::sample_bilinear(texture, {u, v}).r) / 65535;
        worst.see(double(std::abs(ours - exact)), [&] { return text("u = %.9g, v = %.9g", u, v); });
    }
    return worst;
}

// --------------------------------------------------------------------------------------------------- output
Exact srgb_curve(const Exact& c) {
    if (c <= Exact("0.0031308")) return c * Exact("12.92");
    return Exact("1.055") * pow(c, 1 / Exact("2.4")) - Exact("0.055");
}

Measured measure_srgb_output() {
    Random random(24);
    Measured worst;
    const auto look = [&](Scalar c) {
        const Exact exact = 255 * srgb_curve(Exact(c));
        worst.see(double(abs(exact - raster::to_srgb8(c))), [&] { return text("linear light %.9g", c); });
    };
    for (int k = 1; k < 256; ++k) {
        const float at = raster::srgb_thresholds[k];
        look(at), look(std::nextafter(at, 0.0f));
    }
    for (int i = 0; i < 2000; ++i) look(static_cast<Scalar>(random.between(0, 1)));
    return worst;
}

Measured measure_raw_output() {
    Measured worst;
    for (int k = 1; k < 256; ++k) {
        auto c = static_cast<float>((k - 0.5) / 255);
        for (int i = 0; i < 8; ++i) c = std::nextafter(c, 0.0f);
        for (int i = 0; i < 16; ++i, c = std::nextafter(c, 1.0f))
            worst.see(double(std::abs(255 * Long(c) - raster::to_raw8(static_cast<Scalar>(c)))),
                      [&] { return text("linear light %.9g", c); });
    }
    return worst;
}

Measured measure_srgb_decoding() {
    Measured worst;
    for (int k = 0; k < 256; ++k) {
        const Exact s = Exact(k) / 255;
        const Exact linear = s <= Exact("0.04045")
                                 ? Exact(s / Exact("12.92"))
                                 : Exact(pow((s + Exact("0.055")) / Exact("1.055"), Exact("2.4")));
        worst.see(double(abs(65535 * linear - raster::srgb_decoded[k])), [&] { return text("code %d", k); });
    }
    return worst;
}

constexpr Measurement measurements[] = {
    {"light", measure_light},
    {"texture, nearest", measure_nearest},
    {"texture, bilinear", measure_bilinear},
    {"output, srgb", measure_srgb_output},
    {"output, raw", measure_raw_output},
    {"srgb texel", measure_srgb_decoding},
};

}  // namespace

std::span<const Measurement> surface_measurements() { return measurements; }

}  // namespace relevo::accuracy
