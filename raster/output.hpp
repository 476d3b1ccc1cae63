// From linear light to the 8-bit picture.
//
// raw:  int(clamp(c, 0, 1) * 255 + 0.5)
// sRGB: the code k whose interval holds c. The 255 interval ends are the floats where the sRGB curve (IEC
// 61966-2-1)
//       crosses k - 1/2; they stand in a table, so no power function runs and no compiler can move a pixel.
#pragma once
#include <cstdint>

#include "pipeline/color.hpp"

namespace relevo::raster {

using pipeline::LinearRgb;
using pipeline::Scalar;

enum class Output { Srgb, Raw };

struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    friend constexpr bool operator==(const Rgba8&, const Rgba8&) = default;
};

// The smallest linear light that is written as code k, for k = 1..255 (element 0 is 0).
extern const float srgb_thresholds[256];

// Not-a-number is written as 0, infinities as 0 and 255.
inline std::uint8_t to_raw8(Scalar c) {
    const Scalar positive = c > 0 ? c : Scalar(0);
    const Scalar clamped = positive < 1 ? positive : Scalar(1);
    return static_cast<std::uint8_t>(static_cast<int>(clamped * Scalar(255) + Scalar(0.5)));
}
std::uint8_t to_srgb8(Scalar c);

inline Rgba8 to_rgba8(LinearRgb c, Output output) {
    if (output == Output::Raw) return {to_raw8(c.r), to_raw8(c.g), to_raw8(c.b), 255};
    return {to_srgb8(c.r), to_srgb8(c.g), to_srgb8(c.b), 255};
}

// The linear light that a stored sRGB code means, in steps of 1/65535 (rounded to nearest).
extern const std::uint16_t srgb_decoded[256];

}  // namespace relevo::raster
