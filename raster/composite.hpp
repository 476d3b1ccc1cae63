// A colour laid over what is there: the operator "over" (Porter and Duff 1984).
//
//   result = alpha color + (1 - alpha) beneath,     alpha = opacity * coverage
//
// Coverage counts in 1/65536 of the pixel, as the antialiasing algorithms give it. Full coverage at full
// opacity gives the colour itself, to the bit; coverage or opacity 0 leaves what is there.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "pipeline/color.hpp"
#include "raster/output.hpp"
#include "raster/pixel.hpp"

namespace relevo::raster {

// Linear light. `opacity` is 0..1.
inline LinearRgb over(LinearRgb beneath, LinearRgb color, Scalar opacity, int coverage) {
    const Scalar alpha = opacity * (static_cast<Scalar>(coverage) * Scalar(1.0 / full_coverage));
    if (alpha == 1) return color;
    if (alpha == 0) return beneath;
    return alpha * color + (1 - alpha) * beneath;
}

// Both opaque: (coverage c + (65536 - coverage) d) / 65536 in every channel, rounded as below.
inline void over_opaque(Rgba8& beneath, Rgba8 color, int coverage) {
    const auto mix = [coverage](int c, int d) {
        return static_cast<std::uint8_t>((coverage * (c - d) + full_coverage * d + full_coverage / 2) >> 16);
    };
    beneath.r = mix(color.r, beneath.r);
    beneath.g = mix(color.g, beneath.g);
    beneath.b = mix(color.b, beneath.b);
}

// Eight bits a channel, straight alpha; the colour's alpha is its opacity. Every channel is the exact result
// rounded to the nearest, halves up. With a = alpha of the colour times coverage, b = (1 - a) alpha of what
// is beneath:
//     alpha = a + b,    channel = (a c + b beneath) / (a + b);    where both are 0 the pixel stays as it is.
inline Rgba8 over(Rgba8 beneath, Rgba8 color, int coverage) {
    if (color.a == 255 && beneath.a == 255) return over_opaque(beneath, color, coverage), beneath;
    constexpr std::uint32_t one = 255 * full_coverage;
    const std::uint32_t a = color.a * static_cast<std::uint32_t>(coverage);
    if (beneath.a == 255) {  // 255 * one < 2^32
        const auto mix = [a](std::uint32_t c, std::uint32_t d) {
            return static_cast<std::uint8_t>(((a * c + (one - a) * d + one / 2) >> 16) / 255);
        };
        return {mix(color.r, beneath.r), mix(color.g, beneath.g), mix(color.b, beneath.b), 255};
    }
    const std::uint64_t top = std::uint64_t{255} * a, low = std::uint64_t{one - a} * beneath.a,
                        sum = top + low;
    if (sum == 0) return beneath;
    const auto mix = [&](std::uint64_t c, std::uint64_t d) {
        return static_cast<std::uint8_t>((top * c + low * d + sum / 2) / sum);
    };
    return {mix(color.r, beneath.r), mix(color.g, beneath.g), mix(color.b, beneath.b),
            static_cast<std::uint8_t>((sum + one / 2) / one)};
}

// Pixels x0 <= x < x1 of a row are set, four at a time: compilers do not see that a colour is one number.
inline void fill_run(Rgba8* row, int x0, int x1, Rgba8 color) {
    if (x1 - x0 >= 32) {
        const Rgba8 four[4] = {color, color, color, color};
        for (; x1 - x0 >= 4; x0 += 4) std::memcpy(row + x0, four, sizeof four);
    }
    for (; x0 < x1; ++x0) row[x0] = color;
}

// Pixels x0 <= x < x1 of a row.
inline void over(LinearRgb* row, int x0, int x1, LinearRgb color, Scalar opacity, int coverage) {
    if (opacity == 1 && coverage == full_coverage)
        std::fill(row + x0, row + x1, color);
    else
        for (int x = x0; x < x1; ++x) row[x] = over(row[x], color, opacity, coverage);
}
[[gnu::noinline]] inline void over_run(Rgba8* row, int x0, int x1, Rgba8 color, int coverage) {
    if (color.a == 255 && coverage == full_coverage) return fill_run(row, x0, x1, color);
    for (int x = x0; x < x1; ++x) row[x] = over(row[x], color, coverage);
}
inline void over(Rgba8* row, int x0, int x1, Rgba8 color, int coverage) {
    if (x1 == x0 + 1 && color.a == 255 && row[x0].a == 255)  // an edge's pixels come one by one
        over_opaque(row[x0], color, coverage);
    else
        over_run(row, x0, x1, color, coverage);
}

}  // namespace relevo::raster
