// The colours of the step pictures: dark ink on paper, and eight accents that stay apart for colour-blind
// eyes (Okabe and Ito 2008, "Color Universal Design"). A colour never speaks alone: shapes, dashes and words
// go with it.
#pragma once
#include <array>
#include <cstdint>

#include "raster/output.hpp"

namespace relevo::show {

using raster::Rgba8;

inline constexpr Rgba8 paper{255, 255, 255}, mist{243, 245, 248}, rule{221, 226, 232}, haze{176, 184, 193},
    muted{86, 97, 109}, ink{24, 30, 37}, navy{20, 44, 72}, night{17, 21, 27}, sky{86, 180, 233},
    blue{0, 114, 178}, orange{230, 159, 0}, vermilion{213, 94, 0}, green{0, 158, 115}, purple{170, 80, 140},
    rose{204, 121, 167}, yellow{240, 228, 66};

constexpr Rgba8 with_opacity(Rgba8 color, std::uint8_t opacity) {
    return {color.r, color.g, color.b, opacity};
}

// `part` (0..255) of `b` in `a`.
constexpr Rgba8 mixed(Rgba8 a, Rgba8 b, int part) {
    const auto mix = [part](int x, int y) {
        return static_cast<std::uint8_t>((x * (255 - part) + y * part + 127) / 255);
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 255};
}

// The colour of the n-th model, light or axis of a kind.
constexpr Rgba8 accent(std::size_t n) {
    constexpr std::array<Rgba8, 6> accents{blue, vermilion, green, purple, orange, sky};
    return accents[n % accents.size()];
}

// A pleasant colour for a number, far from those of its neighbours: the hue walks round the circle in steps
// of the golden ratio (Knuth, The Art of Computer Programming 3, 6.4: multiplicative hashing), lightness in
// steps of three.
constexpr Rgba8 color_of_number(std::uint32_t number) {
    const std::uint32_t hue = ((number * 2654435769u) >> 16) * 6;  // 0..6 in 1/65536
    const int rise = static_cast<int>((hue & 65535u) >> 8), fall = 255 - rise;
    const std::array<std::array<int, 3>, 6> wheel{
        {{255, rise, 0}, {fall, 255, 0}, {0, 255, rise}, {0, fall, 255}, {rise, 0, 255}, {255, 0, fall}}};
    const int top = 225 - 35 * static_cast<int>(number % 3), bottom = 95 - 25 * static_cast<int>(number % 3);
    const auto level = [&](int c) {
        return static_cast<std::uint8_t>(bottom + (top - bottom) *
                                                      wheel[hue >> 16][static_cast<std::size_t>(c)] / 255);
    };
    return {level(0), level(1), level(2)};
}

}  // namespace relevo::show
