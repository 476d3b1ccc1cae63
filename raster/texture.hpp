// Texture look-up: nearest texel and bilinear, the image repeated in both directions.
//
// Source: textbook chapter 9; sub-texel weights of 8 bits as Direct3D 11.3 functional specification 7.18.7
// asks.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/color.hpp"
#include "pipeline/lane_vector.hpp"

namespace relevo::raster {

using pipeline::LinearRgb;
using pipeline::RgbOf;
using pipeline::Scalar;
using pipeline::Vec2;
using pipeline::Vec2Of;
using pipeline::Whole;
using pipeline::Word;

// Texel coordinates are kept in 1/256 texel; with 16384 texels a side they stay exact in float.
inline constexpr int max_texture_size = 16384;

enum class Filter { Nearest, Bilinear };
enum class Encoding {
    Raw,
    Srgb
};  // how the 8-bit numbers of an image file mean light: as they are, or by the sRGB curve

struct Texture {
    int width = 0, height = 0;  // 1..max_texture_size
    std::vector<std::array<std::uint16_t, 4>>
        texels;       // row 0 is the BOTTOM row (v = 0); red, green, blue, unused
    Scalar unit = 1;  // linear light of one step: 1/255 (raw) or 1/65535 (decoded sRGB)
};

// A texture from 8-bit RGB(A) rows, top row first; sRGB is decoded to 16-bit linear light (rounded to
// nearest).
Texture make_texture(int width, int height, int channels, std::span<const std::uint8_t> top_down,
                     Encoding encoding);

// The two texels of a row or column whose centres a coordinate lies between, and how far towards the second.
template <class Real>
struct TexelPositionOf {
    Whole<Real> low, high;  // both in 0..size-1
    Word<Real> weight;      // of `high`, in 1/256: 0..255
};
using TexelPosition = TexelPositionOf<Scalar>;

// The fraction of a repeating coordinate, in [0, 1]; u = -1e-9f gives exactly 1. Not a number counts as 0.
template <class Real>
Real repeat(Real u) {
    using pipeline::floor, pipeline::select;
    const Real f = u - floor(u);
    return select(f >= 0, f, Real(0));
}

template <class Real>
TexelPositionOf<Real> texel_position(Real u, int size) {
    using pipeline::select, pipeline::to_word, pipeline::truncated;
    const Whole<Real> t = truncated(repeat(u) * static_cast<Scalar>(256 * size) + Scalar(0.5)) - 128;
    const Whole<Real> texel = t >> 8;
    const Whole<Real> low = select(texel < 0, Whole<Real>(size - 1), texel), next = low + 1;
    return {low, select(next == size, Whole<Real>(0), next), to_word(t & 255)};
}

// The stored numbers of the texel `index` (y width + x) of each lane.
template <class Real>
struct TexelOf {
    Word<Real> r, g, b;
};
inline TexelOf<Scalar> texel(const Texture& texture, std::int32_t index) {
    const auto& t = texture.texels[std::size_t(index)];
    return {t[0], t[1], t[2]};
}

template <class Real = Scalar>
RgbOf<Real> sample_nearest(const Texture& texture, const Vec2Of<Real>& uv) {
    using pipeline::select, pipeline::to_real, pipeline::truncated;
    const auto place = [](Real u, int size) {
        const Whole<Real> t = truncated(repeat(u) * static_cast<Scalar>(size));
        return select(t == size, Whole<Real>(0), t);
    };
    const Whole<Real> x = place(uv.x, texture.width), y = place(uv.y, texture.height);
    const TexelOf<Real> t = texel(texture, y * texture.width + x);
    return {to_real(t.r) * texture.unit, to_real(t.g) * texture.unit, to_real(t.b) * texture.unit};
}

// The weighted sum is done in integers (16 + 8 + 8 bits) mod 2^32, so it is exact and its order does not
// matter; one conversion and one product follow. A constant texture gives a constant picture.
template <class Real = Scalar>
RgbOf<Real> sample_bilinear(const Texture& texture, const Vec2Of<Real>& uv) {
    using pipeline::to_real;
    const auto x = texel_position(Real(uv.x), texture.width), y = texel_position(Real(uv.y), texture.height);
    const Whole<Real> low_row = y.low * texture.width, high_row = y.high * texture.width;
    const TexelOf<Real> t00 = texel(texture, low_row + x.low), t10 = texel(texture, low_row + x.high),
                        t01 = texel(texture, high_row + x.low), t11 = texel(texture, high_row + x.high);
    const auto between = [](Word<Real> a, Word<Real> b, Word<Real> weight) {
        return (a << 8) + (b - a) * weight;
    };
    const Scalar unit = texture.unit * Scalar(1.0 / 65536);
    const auto light = [&](Word<Real> c00, Word<Real> c10, Word<Real> c01, Word<Real> c11) {
        return to_real(between(between(c00, c10, x.weight), between(c01, c11, x.weight), y.weight)) * unit;
    };
    return {light(t00.r, t10.r, t01.r, t11.r), light(t00.g, t10.g, t01.g, t11.g),
            light(t00.b, t10.b, t01.b, t11.b)};
}

template <class Real = Scalar>
RgbOf<Real> sample(const Texture& texture, Filter filter, const Vec2Of<Real>& uv) {
    return filter == Filter::Nearest ? sample_nearest<Real>(texture, uv) : sample_bilinear<Real>(texture, uv);
}

}  // namespace relevo::raster
