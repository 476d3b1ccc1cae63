#include "tests/golden/relief/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace relevo::golden {
namespace {

using relief::ErrorSet;
using relief::ViewImage;

template <class... Values>
std::string said(const char* format, Values... values) {
    char text[300];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

template <class Value, class Off>
std::optional<std::string> images_apart(const Image<Value>& a, const Image<Value>& b, double beyond,
                                        const char* what, Off&& off) {
    if (a.width() != b.width() || a.height() != b.height())
        return said("%s: %d x %d expected, %d x %d made", what, a.width(), a.height(), b.width(), b.height());
    int wrong = 0, x0 = 0, y0 = 0;
    for (int y = a.height(); y-- > 0;)
        for (int x = a.width(); x-- > 0;)
            if (off(a.at(x, y), b.at(x, y))) ++wrong, x0 = x, y0 = y;
    if (wrong <= beyond * a.width() * a.height()) return {};
    return said("%s: %d of %d are too far off, the first at (%d, %d)", what, wrong, a.width() * a.height(),
                x0, y0);
}

bool apart(double a, double b, double limit) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) != std::isnan(b);
    return !(a == b || std::abs(a - b) <= limit * (1 + std::abs(a)));
}

// The words of a text, and its numbers in hexadecimal.
std::pair<std::string, std::vector<double>> taken_apart(const std::string& text) {
    std::pair<std::string, std::vector<double>> out;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t used = 0;
        const bool sign = text[i] == '-';
        if (text.compare(i + sign, 2, "0x") == 0) out.second.push_back(std::stod(text.substr(i), &used));
        if (used == 0) out.first += text[i], used = 1;
        i += used;
    }
    return out;
}

// The k-th square tile of a picture with the depths as a view of a scene.
ViewImage view_of(const Product& product, int tile) {
    const int size = product.numbers.height();
    ViewImage view(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Rgba8& c = product.picture.at(tile * size + x, y);
            view.color.at(x, y) = {Scalar(c.r / 255.0), Scalar(c.g / 255.0), Scalar(c.b / 255.0)};
            view.depth.at(x, y) = Scalar(product.numbers.at(x, y));
            view.coverage.at(x, y) = c.a != 0;
        }
    return view;
}

std::optional<std::string> views_apart(const Allowed& allowed, const Product& expected,
                                       const Product& actual) {
    if (expected.picture.width() != actual.picture.width() ||
        expected.picture.height() != actual.picture.height())
        return "another size";
    for (int tile = 0; tile < expected.picture.width() / expected.numbers.height(); ++tile) {
        const ErrorSet e = relief::error_set(view_of(actual, tile), view_of(expected, tile));
        if (e.missing_percent <= allowed.missing && e.extra_percent <= allowed.extra &&
            e.psnr >= allowed.psnr && e.mean_depth_error <= allowed.depth && e.bad_percent <= allowed.bad)
            continue;
        return said(
            "picture %d against the one that was: missing %.2f %%, extra %.2f %%, PSNR %.1f dB, depth %.5f, "
            "bad %.2f %%",
            tile + 1, e.missing_percent, e.extra_percent, e.psnr, e.mean_depth_error, e.bad_percent);
    }
    return {};
}

std::optional<std::string> first_beyond(const Allowed& allowed, const Product& expected,
                                        const Product& actual) {
    const auto [words, numbers] = taken_apart(expected.text);
    const auto [other_words, other_numbers] = taken_apart(actual.text);
    if (words != other_words || numbers.size() != other_numbers.size())
        return "the text: expected\n" + expected.text + "actual\n" + actual.text;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (apart(numbers[i], other_numbers[i], allowed.number))
            return said("the text: %.9g expected, %.9g made", numbers[i], other_numbers[i]);
    if (allowed.by_error_set) return views_apart(allowed, expected, actual);
    if (auto found = images_apart(expected.numbers, actual.numbers, allowed.beyond, "numbers",
                                  [&](float a, float b) { return apart(a, b, allowed.number); }))
        return found;
    return images_apart(expected.picture, actual.picture, allowed.beyond, "the picture",
                        [&](const Rgba8& a, const Rgba8& b) {
                            return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b),
                                             std::abs(a.a - b.a)}) > allowed.level;
                        });
}

}  // namespace

std::string line(const std::string& name, const std::vector<double>& values) {
    std::string out = name;
    for (const double v : values) out += said(" %a", v);
    return out + '\n';
}

std::optional<std::string> difference_beyond(const Allowed& allowed, const Product& expected,
                                             const Product& actual) {
    auto found = first_beyond(allowed, expected, actual);
    if (found) *found += std::string("\n(allowed here: ") + allowed.reason + ')';
    return found;
}

Allowed loosened(Allowed allowed) {
    allowed.number = std::max(allowed.number, 1e-4), allowed.level = std::max(allowed.level, 2);
    allowed.beyond = std::max(allowed.beyond, 0.02);
    return allowed;
}

}  // namespace relevo::golden
