#include "samples/io/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace relevo::io {
namespace {

using raster::Image;
using raster::Rgba8;

double difference(double a, double b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double distance = std::abs(a - b);
    return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

// Two pictures of the same shape: numbers row by row, `channels` a pixel.
template <class Number>
struct Pair {
    int width, height, channels;
    std::span<const Number> a, b;

    std::size_t pixels() const { return a.size() / static_cast<std::size_t>(channels); }
    PixelDifference at(std::size_t pixel) const {
        const auto columns = static_cast<std::size_t>(width);
        PixelDifference out{static_cast<int>(pixel % columns), static_cast<int>(pixel / columns), {}, {}, 0};
        for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
            const std::size_t i = pixel * static_cast<std::size_t>(channels) + c;
            out.a[c] = static_cast<double>(a[i]);
            out.b[c] = static_cast<double>(b[i]);
            out.difference = std::max(out.difference, difference(out.a[c], out.b[c]));
        }
        return out;
    }
};

Pair<std::uint8_t> pair_of(const Image<Rgba8>& a, const Image<Rgba8>& b) {
    const auto numbers = [](const Image<Rgba8>& image) {
        return std::span(reinterpret_cast<const std::uint8_t*>(image.pixels().data()),
                         image.pixels().size() * 4);
    };
    return {a.width(), a.height(), 4, numbers(a), numbers(b)};
}

// Calls `action` with the Pair of two comparable pictures.
template <class Action>
auto with_pair(const Pixels& a, const Pixels& b, const Action& action) {
    return std::visit(
        [&]<class Number>(const std::vector<Number>& numbers) {
            const auto& others = std::get<std::vector<Number>>(b.samples);
            return action(Pair<Number>{a.width, a.height, a.channels, numbers, others});
        },
        a.samples);
}

template <class Number>
Comparison compare_pair(const Pair<Number>& pair) {
    Comparison out{"", pair.width, pair.height, pair.channels, 0, {}, {}};
    for (std::size_t i = 0; i < pair.pixels(); ++i) {
        const PixelDifference here = pair.at(i);
        if (here.difference == 0) continue;
        ++out.different;
        if (!out.first) out.first = here;
        if (!out.worst || here.difference > out.worst->difference) out.worst = here;
    }
    return out;
}

std::string size_in_words(int width, int height) { return fmt::format("{} x {} pixels", width, height); }

std::string_view kind_in_words(const Pixels& pixels) {
    static constexpr std::string_view names[] = {"8-bit", "16-bit", "float"};
    return names[pixels.samples.index()];
}

std::string difference_of_shapes(const Pixels& a, const Pixels& b) {
    if (a.width != b.width || a.height != b.height)
        return fmt::format("the sizes are {} and {}", size_in_words(a.width, a.height),
                           size_in_words(b.width, b.height));
    if (a.channels != b.channels) return fmt::format("they have {} and {} channels", a.channels, b.channels);
    if (a.samples.index() != b.samples.index())
        return fmt::format("they hold {} and {} numbers", kind_in_words(a), kind_in_words(b));
    return "";
}

std::string numbers_in_words(const std::array<double, 4>& numbers, int channels) {
    std::string out;
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c)
        out += fmt::format("{}{:.9g}", c == 0 ? "" : " ", numbers[c]);
    return out;
}

std::string in_words(const PixelDifference& pixel, int channels) {
    return fmt::format("x {}, y {}: {} against {}, difference {:.9g}", pixel.x, pixel.y,
                       numbers_in_words(pixel.a, channels), numbers_in_words(pixel.b, channels),
                       pixel.difference);
}

// ---- the picture of the difference ----

std::uint8_t shown(std::uint8_t, double number) { return static_cast<std::uint8_t>(number); }
std::uint8_t shown(std::uint16_t, double number) { return static_cast<std::uint8_t>(number / 257); }
std::uint8_t shown(float, double number) { return raster::to_raw8(static_cast<pipeline::Scalar>(number)); }

template <class Number>
Rgba8 shown(const std::array<double, 4>& numbers, int channels) {
    const auto channel = [&](std::size_t c) { return shown(Number(), numbers[channels < 3 ? 0 : c]); };
    return {channel(0), channel(1), channel(2), 255};
}

// The differences of the colours; one of alpha brightens all three.
Rgba8 shown_difference(const PixelDifference& pixel, int channels, double scale) {
    const auto d = [&](std::size_t c) { return difference(pixel.a[c], pixel.b[c]); };
    const double alpha = channels % 2 == 0 ? d(static_cast<std::size_t>(channels) - 1) : 0;
    const auto channel = [&](std::size_t c) {
        const double value = std::max(d(channels < 3 ? 0 : c), alpha);
        // Rounded up: a difference, however small, is not black. Infinity is white.
        return value == 0 ? std::uint8_t(0)
                          : static_cast<std::uint8_t>(std::ceil(std::clamp(value * scale, 1.0, 255.0)));
    };
    return {channel(0), channel(1), channel(2), 255};
}

template <class Number>
Image<Rgba8> difference_picture(const Pair<Number>& pair) {
    const Rgba8 white{255, 255, 255, 255};
    const int second = pair.width + 1, third = 2 * second;
    const auto worst = compare_pair(pair).worst;
    const bool is_8_bit = sizeof(Number) == 1;
    const double scale = is_8_bit                                    ? 8
                         : worst && std::isfinite(worst->difference) ? 255 / worst->difference
                                                                     : 255;
    Image<Rgba8> out(third + pair.width, pair.height, white);
    for (std::size_t i = 0; i < pair.pixels(); ++i) {
        const PixelDifference pixel = pair.at(i);
        out.at(pixel.x, pixel.y) = shown<Number>(pixel.a, pair.channels);
        out.at(second + pixel.x, pixel.y) = shown<Number>(pixel.b, pair.channels);
        out.at(third + pixel.x, pixel.y) = shown_difference(pixel, pair.channels, scale);
    }
    return out;
}

}  // namespace

Comparison compare(const Pixels& a, const Pixels& b) {
    if (std::string reason = difference_of_shapes(a, b); !reason.empty())
        return {std::move(reason), 0, 0, 0, 0, {}, {}};
    return with_pair(a, b, [](const auto& pair) { return compare_pair(pair); });
}

Comparison compare(const Image<Rgba8>& a, const Image<Rgba8>& b) {
    if (a.width() == b.width() && a.height() == b.height()) return compare_pair(pair_of(a, b));
    return {fmt::format("the sizes are {} and {}", size_in_words(a.width(), a.height()),
                        size_in_words(b.width(), b.height())),
            0,
            0,
            0,
            0,
            {},
            {}};
}

std::string describe(const Comparison& c, const std::string& name_a, const std::string& name_b) {
    if (!c.not_comparable.empty())
        return fmt::format("{} and {} cannot be compared: {}", name_a, name_b, c.not_comparable);
    const std::size_t pixels = std::size_t(c.width) * std::size_t(c.height);
    if (c.same())
        return fmt::format("{} and {} are the same: {}, {} channel{}, every number equal", name_a, name_b,
                           size_in_words(c.width, c.height), c.channels, c.channels == 1 ? "" : "s");
    return fmt::format(
        "{} and {} differ in {} of {} pixels ({:.3g} %)\n  first wrong pixel  {}\n  worst pixel        {}",
        name_a, name_b, c.different, pixels,
        100 * static_cast<double>(c.different) / static_cast<double>(pixels), in_words(*c.first, c.channels),
        in_words(*c.worst, c.channels));
}

Image<Rgba8> difference_picture(const Pixels& a, const Pixels& b) {
    return with_pair(a, b, [](const auto& pair) { return difference_picture(pair); });
}

Image<Rgba8> difference_picture(const Image<Rgba8>& a, const Image<Rgba8>& b) {
    return difference_picture(pair_of(a, b));
}

}  // namespace relevo::io
