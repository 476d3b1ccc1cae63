// Colours for numbers, and what to paint where there is none.
#pragma once
#include <fmt/format.h>
#include <algorithm>

#include <cmath>

#include "samples/show/numbers.hpp"
#include "samples/show/stage.hpp"

namespace relevo::show {

// "1,234 (56.7 %)"
inline std::string share(std::int64_t part, std::int64_t whole) {
    const double percent = whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    return fmt::format("{} ({:.1f} %)", grouped(part), percent);
}

// Stripes that no surface shows: a pixel without a triangle. Finer where pixels are drawn large.
inline Rgba8 empty_pixel(int x, int y, int width) {
    const int stripe = width < 200 ? 1 : 4;
    return (x + y) / stripe % 2 == 0 ? night : Rgba8{38, 46, 60};
}

// The span of the numbers added; what is not finite is left out.
struct Range {
    double low = 0, high = 0;
    bool empty = true;
    void add(double v) {
        if (!std::isfinite(v)) return;
        low = empty ? v : std::min(low, v), high = empty ? v : std::max(high, v);
        empty = false;
    }
    // 0 at `low`, 1 at `high`; 1 when there is no span.
    double share_of(double v) const { return high > low ? (v - low) / (high - low) : 1; }
    std::string text() const { return empty ? "none" : range(low, high); }
};

inline std::uint8_t level(double share_of_255) {
    return static_cast<std::uint8_t>(std::clamp(share_of_255, 0.0, 1.0) * 255 + 0.5);
}
inline Rgba8 grey(double share_of_range) {
    const std::uint8_t g = level(0.14 + 0.86 * share_of_range);
    return {g, g, g};
}

// A direction as a colour of the wheel, and the share of the longest as its strength.
inline Rgba8 direction_color(double u, double v, double longest) {
    const double length = std::sqrt(u * u + v * v);
    if (!(length > 0)) return paper;
    // the wheel: red right, green and blue a third of a turn on; a piecewise linear hue without an angle
    const double x = u / length, y = v / length, root = std::sqrt(0.75);
    const double channel[3] = {x, -0.5 * x + root * y, -0.5 * x - root * y};
    const double strength = std::sqrt(longest > 0 ? length / longest : 0);
    const auto tone = [&](double c) { return level(1 - strength * (0.5 - 0.5 * c)); };
    return {tone(channel[0]), tone(channel[1]), tone(channel[2])};
}
inline PanelBlock legend_of_directions() {
    using Kind = PanelRow::Kind;
    return {"Legend",
            {sample(Kind::Square, direction_color(1, 0, 1), "to the right"),
             sample(Kind::Square, direction_color(0, 1, 1), "down"),
             sample(Kind::Square, direction_color(-1, 0, 1), "to the left"),
             sample(Kind::Square, direction_color(0, -1, 1), "up"), sample(Kind::Square, paper, "stays")}};
}

}  // namespace relevo::show
