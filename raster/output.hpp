// From linear light to the 8-bit picture.
//
// raw:  int(clamp(c, 0, 1) * 255 + 0.5)
// sRGB: the code k whose interval holds c. The 255 interval ends are the floats where the sRGB curve (IEC
// 61966-2-1)
//       crosses k - 1/2; they stand in a table, so no power function runs and no compiler can move a pixel.
#pragma once
#include <cstdint>

#include "pipeline/color.hpp"
#include "pipeline/lane.hpp"

namespace relevo::raster {

using pipeline::LinearRgb;
using pipeline::RgbOf;
using pipeline::Scalar;
using pipeline::Whole;
using pipeline::Word;

enum class Output { Srgb, Raw };

struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    friend constexpr bool operator==(const Rgba8&, const Rgba8&) = default;
};

// The smallest linear light that is written as code k, for k = 1..255 (element 0 is 0).
extern const float srgb_thresholds[256];

// How to find the code without a search: light is cut into cells of 1/4096, and no cell holds two thresholds.
//   entry = (code at the cell's beginning + 1) 2^24 - (threshold, or the end, in 2^-23 of the cell)   mod
//   2^32
// Adding a place in the cell, in the same unit, carries into the code exactly when the threshold is reached.
inline constexpr int srgb_cells = 4096;
struct SrgbTable {
    std::uint32_t cell[srgb_cells + 1];  // the last one: light 1
};
extern const SrgbTable srgb_table;

// Codes 0..255. Not-a-number is written as 0, infinities as 0 and 255.
template <class Real>
Real clamped_light(Real c) {
    using pipeline::greater, pipeline::smaller;
    return smaller(greater(c, Real(0)), Real(1));
}
// Displayable: known to be in [0, 1], or beyond by 2^-20 at most, as rounded interpolation between colours of
// that range is at covered pixels, whose weights are finite and not negative. Without a clamp it has the same
// raw codes.
enum class Light { Any, Displayable };
template <class Real, Light light = Light::Any>
Whole<Real> raw_code(Real c) {
    using pipeline::truncated;
    return truncated((light == Light::Any ? clamped_light(c) : c) * Scalar(255) + Scalar(0.5));
}
template <class Real>
Whole<Real> srgb_code(Real c) {
    using pipeline::look_up, pipeline::to_real, pipeline::to_whole, pipeline::to_word, pipeline::truncated;
    const Real place = clamped_light(c) * Scalar(srgb_cells);  // exact
    const Whole<Real> cell = truncated(place);
    const Word<Real> rest = to_word(truncated((place - to_real(cell)) * Scalar(1 << 23)));
    return to_whole((look_up(srgb_table.cell, cell) + rest) >> 24);
}

inline std::uint8_t to_raw8(Scalar c) { return static_cast<std::uint8_t>(raw_code(c)); }
inline std::uint8_t to_srgb8(Scalar c) { return static_cast<std::uint8_t>(srgb_code(c)); }

inline Rgba8 to_rgba8(LinearRgb c, Output output) {
    if (output == Output::Raw) return {to_raw8(c.r), to_raw8(c.g), to_raw8(c.b), 255};
    return {to_srgb8(c.r), to_srgb8(c.g), to_srgb8(c.b), 255};
}
// The four bytes of Rgba8 in one number, red the lowest.
template <class Real, Light light = Light::Any>
Word<Real> packed_rgba8(const RgbOf<Real>& c, Output output) {
    const auto pack = [](const Whole<Real>& r, const Whole<Real>& g, const Whole<Real>& b) {
        using pipeline::to_word;
        return to_word(r) | (to_word(g) << 8) | (to_word(b) << 16) | (to_word(Whole<Real>(255)) << 24);
    };
    if (output == Output::Srgb) return pack(srgb_code(c.r), srgb_code(c.g), srgb_code(c.b));
    return pack(raw_code<Real, light>(c.r), raw_code<Real, light>(c.g), raw_code<Real, light>(c.b));
}

// The linear light that a stored sRGB code means, in steps of 1/65535 (rounded to nearest).
extern const std::uint16_t srgb_decoded[256];

}  // namespace relevo::raster
