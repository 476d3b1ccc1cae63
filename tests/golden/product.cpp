#include "tests/golden/product.hpp"

#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <vector>

namespace relevo::golden {
namespace {

using raster::Image;
using raster::Rgba8;

template <class... Values>
std::string text(const char* format, Values... values) {
    char line[600];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

// ----------------------------------------------------------------------------------------------------- text
std::string_view line_of(std::string_view text, int number) {
    for (; number > 1 && !text.empty(); --number)
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find('\n'));
}

std::optional<std::string> text_difference(const std::string& expected, const std::string& actual) {
    if (expected == actual) return {};
    int number = 1;
    while (line_of(expected, number) == line_of(actual, number)) ++number;
    const auto shown = [&](const std::string& all) {
        const std::string_view line = line_of(all, number);
        return line.empty() ? std::string("(the end)") : std::string(line);
    };
    return "line " + std::to_string(number) + "\n  expected: " + shown(expected) +
           "\n  actual:   " + shown(actual);
}

// --------------------------------------------------------------------------------------------------- pixels
std::string shown(const Rgba8& c) {
    return text("%3d %3d %3d %3d  (red green blue alpha)", c.r, c.g, c.b, c.a);
}
std::string shown(float v) { return text("%.9g  (bits %08x)", double(v), std::bit_cast<std::uint32_t>(v)); }

bool same(const Rgba8& a, const Rgba8& b) { return a == b; }
bool same(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

// A pixel has `share` values, side by side in the image.
template <class Value>
std::optional<std::string> image_difference(const Image<Value>& expected, const Image<Value>& actual,
                                            int share) {
    if (expected.width() != actual.width() || expected.height() != actual.height())
        return text("%d x %d expected, %d x %d drawn", expected.width(), expected.height(), actual.width(),
                    actual.height());
    int wrong = 0, first_x = 0, first_y = 0;
    for (int y = expected.height(); y-- > 0;)
        for (int x = expected.width(); x-- > 0;)
            if (!same(expected.at(x, y), actual.at(x, y))) ++wrong, first_x = x, first_y = y;
    if (wrong == 0) return {};
    const std::string which =
        share == 1 ? "" : text(" (there the value %d of %d)", first_x % share + 1, share);
    return text("%d of %d values differ, the first at pixel (%d, %d)", wrong,
                expected.width() * expected.height(), first_x / share, first_y) +
           which + "\n  expected: " + shown(expected.at(first_x, first_y)) +
           "\n  actual:   " + shown(actual.at(first_x, first_y));
}

// Numbers stand side by side in the rows that the picture shows.
int values_a_pixel(const Product& product) {
    const bool has_both = !product.numbers.empty() && !product.picture.empty();
    return has_both ? std::max(1, product.numbers.width() / product.picture.width()) : 1;
}

// ----------------------------------------------------------------------------------------------------- hash
class Hash {
  public:
    void add(std::uint8_t byte) { state_ = (state_ ^ byte) * 0x100000001b3; }
    void add(std::uint32_t number) {
        for (int shift = 0; shift < 32; shift += 8) add(static_cast<std::uint8_t>(number >> shift));
    }
    void add(int number) { add(static_cast<std::uint32_t>(number)); }
    void add(const Rgba8& c) { add(c.r), add(c.g), add(c.b), add(c.a); }
    void add(float v) { add(std::bit_cast<std::uint32_t>(v)); }
    template <class Pixel>
    void add(const Image<Pixel>& image) {
        add(image.width()), add(image.height());
        for (const Pixel& p : image.pixels()) add(p);
    }
    std::string digits() const { return text("%016" PRIx64, state_); }

  private:
    std::uint64_t state_ = 0xcbf29ce484222325;
};

// ---------------------------------------------------------------------------------------- another precision
int largest_step(const Rgba8& a, const Rgba8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

// The hexadecimal numbers of a text, and the text around them.
std::pair<std::vector<double>, std::string> numbers_of(const std::string& text) {
    std::pair<std::vector<double>, std::string> out;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t used = 0;
        if (text.compare(i, 2, "0x") == 0) out.first.push_back(std::stod(text.substr(i), &used));
        if (used == 0) out.second += text[i], used = 1;
        i += used;
    }
    return out;
}

}  // namespace

std::string hash(const Product& product) {
    Hash hash;
    for (const char c : product.text) hash.add(static_cast<std::uint8_t>(c));
    hash.add(product.picture), hash.add(product.numbers);
    return hash.digits();
}

std::optional<std::string> first_difference(const Product& expected, const Product& actual) {
    if (auto found = text_difference(expected.text, actual.text)) return found;
    if (auto found = image_difference(expected.numbers, actual.numbers, values_a_pixel(expected)))
        return found;
    return image_difference(expected.picture, actual.picture, 1);
}

std::optional<std::string> large_difference(const Product& expected, const Product& actual) {
    const auto [numbers, words] = numbers_of(expected.text);
    const auto [others, other_words] = numbers_of(actual.text);
    if (words != other_words || numbers.size() != others.size()) return text_difference(words, other_words);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!(std::abs(numbers[i] - others[i]) <= 1e-5 * (1 + std::abs(numbers[i]))))
            return text("%.9g expected, %.9g made", numbers[i], others[i]);
    const auto& a = expected.picture.pixels();
    const auto& b = actual.picture.pixels();
    if (a.size() != b.size() || expected.numbers.pixels().size() != actual.numbers.pixels().size())
        return "another size";
    int far_off = 0;
    for (std::size_t i = 0; i < a.size(); ++i) far_off += largest_step(a[i], b[i]) > 2;
    for (std::size_t i = 0; i < expected.numbers.pixels().size(); ++i) {
        const float x = expected.numbers.pixels()[i], y = actual.numbers.pixels()[i];
        far_off += !(std::abs(x - y) <= 1e-4f * (1 + std::abs(x)));
    }
    if (far_off > 8) return text("%d pixels differ by more than rounding", far_off);
    return {};
}

raster::Image<Rgba8> difference_picture(const Product& expected, const Product& actual) {
    const auto& picture = expected.picture;
    Image<Rgba8> out(picture.width(), picture.height());
    const auto dim = [](std::uint8_t c) { return static_cast<std::uint8_t>(c / 3); };
    for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
        const Rgba8& c = picture.pixels()[i];
        out.pixels()[i] =
            c == actual.picture.pixels()[i] ? Rgba8{dim(c.r), dim(c.g), dim(c.b)} : Rgba8{255, 255, 255};
    }
    const int share = values_a_pixel(expected);
    for (int y = 0; y < expected.numbers.height(); ++y)
        for (int x = 0; x < expected.numbers.width(); ++x)
            if (actual.numbers.holds(x, y) && out.holds(x / share, y) &&
                !same(expected.numbers.at(x, y), actual.numbers.at(x, y)))
                out.at(x / share, y) = {255, 255, 255};
    return out;
}

Rgba8 coverage_color(std::uint32_t last, std::uint32_t count) {
    // An odd factor: no two of the 2^24 numbers meet.
    const std::uint32_t spread = ((last & 0xffff) | (count & 0xff) << 16) * 0x5bd1e5u;
    return {static_cast<std::uint8_t>(spread), static_cast<std::uint8_t>(spread >> 8),
            static_cast<std::uint8_t>(spread >> 16)};
}

}  // namespace relevo::golden
