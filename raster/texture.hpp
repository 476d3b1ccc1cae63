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
#include "pipeline/scalar.hpp"

namespace relevo::raster {

using pipeline::LinearRgb;
using pipeline::Scalar;
using pipeline::Vec2;

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
struct TexelPosition {
    int low, high;         // both in 0..size-1
    std::uint32_t weight;  // of `high`, in 1/256: 0..255
};

// The fraction of a repeating coordinate, in [0, 1]; u = -1e-9f gives exactly 1. Not a number counts as 0.
inline Scalar repeat(Scalar u) {
    const Scalar f = u - std::floor(u);
    return f >= 0 ? f : 0;
}

inline TexelPosition texel_position(Scalar u, int size) {
    const int t = static_cast<int>(repeat(u) * static_cast<Scalar>(256 * size) + Scalar(0.5)) - 128;
    const int texel = t >> 8;
    const int low = texel < 0 ? size - 1 : texel;
    return {low, low + 1 == size ? 0 : low + 1, static_cast<std::uint32_t>(t & 255)};
}

inline LinearRgb sample_nearest(const Texture& texture, Vec2 uv) {
    const auto texel = [](Scalar u, int size) {
        const int t = static_cast<int>(repeat(u) * static_cast<Scalar>(size));
        return std::size_t(t == size ? 0 : t);
    };
    const std::size_t x = texel(uv.x, texture.width), y = texel(uv.y, texture.height);
    const auto& t = texture.texels[y * std::size_t(texture.width) + x];
    return {static_cast<Scalar>(t[0]) * texture.unit, static_cast<Scalar>(t[1]) * texture.unit,
            static_cast<Scalar>(t[2]) * texture.unit};
}

// The weighted sum is done in integers (16 + 8 + 8 bits), so it is exact and its order does not matter; one
// conversion and one product follow. A constant texture gives a constant picture: the weights sum to 65536.
inline LinearRgb sample_bilinear(const Texture& texture, Vec2 uv) {
    const TexelPosition x = texel_position(uv.x, texture.width), y = texel_position(uv.y, texture.height);
    const auto* low_row = texture.texels.data() + std::size_t(y.low) * std::size_t(texture.width);
    const auto* high_row = texture.texels.data() + std::size_t(y.high) * std::size_t(texture.width);
    const auto &t00 = low_row[x.low], &t10 = low_row[x.high], &t01 = high_row[x.low], &t11 = high_row[x.high];
    const std::uint32_t w11 = x.weight * y.weight, w10 = (x.weight << 8) - w11, w01 = (y.weight << 8) - w11,
                        w00 = 65536 - w10 - w01 - w11;
    std::array<std::uint32_t, 4> sum;
    for (std::size_t c = 0; c < 4; ++c)
        sum[c] = (w00 * t00[c] + w10 * t10[c]) + (w01 * t01[c] + w11 * t11[c]);
    const Scalar unit = texture.unit * Scalar(1.0 / 65536);
    const auto light = [&](std::uint32_t steps) { return static_cast<Scalar>(std::int64_t{steps}) * unit; };
    return {light(sum[0]), light(sum[1]), light(sum[2])};
}

inline LinearRgb sample(const Texture& texture, Filter filter, Vec2 uv) {
    return filter == Filter::Nearest ? sample_nearest(texture, uv) : sample_bilinear(texture, uv);
}

}  // namespace relevo::raster
