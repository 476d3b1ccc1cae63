// Pictures and numbers of relief textures side by side, and how nearly two of them are the same.
#pragma once
#include <optional>
#include <string>

#include "relief/error_set.hpp"
#include "tests/golden/product.hpp"

namespace relevo::golden {

using pipeline::LinearRgb;
using pipeline::Scalar;
using raster::Image;
using raster::Rgba8;

// Raw output, no transfer; what is not covered is transparent black.
template <class Covered>
Image<Rgba8> shown(const Image<LinearRgb>& color, const Covered& coverage) {
    Image<Rgba8> picture(color.width(), color.height(), Rgba8{0, 0, 0, 0});
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        if (coverage.pixels()[i])
            picture.pixels()[i] = raster::to_rgba8(color.pixels()[i], raster::Output::Raw);
    return picture;
}
template <class Covered>
Image<Rgba8> shown(const Image<pipeline::Vec3>& normal, const Covered& coverage) {
    Image<LinearRgb> color(normal.width(), normal.height());
    for (std::size_t i = 0; i < color.pixels().size(); ++i) {
        const pipeline::Vec3& n = normal.pixels()[i];
        const auto light = [](Scalar c) { return Scalar(0.5) + Scalar(0.5) * c; };
        color.pixels()[i] = {light(n.x), light(n.y), light(n.z)};
    }
    return shown(color, coverage);
}
// 0 where it is not covered.
template <class Covered>
Image<float> numbers(const Image<Scalar>& values, const Covered& coverage) {
    Image<float> kept(values.width(), values.height());
    for (std::size_t i = 0; i < kept.pixels().size(); ++i)
        if (coverage.pixels()[i]) kept.pixels()[i] = static_cast<float>(values.pixels()[i]);
    return kept;
}

// To the right of what is there; a picture that is less high is filled up with Pixel{}.
template <class Pixel>
void append(Image<Pixel>& row, const Image<Pixel>& next) {
    Image<Pixel> wider(row.width() + next.width(), std::max(row.height(), next.height()));
    for (const auto& [image, x0] : {std::pair<const Image<Pixel>*, int>{&row, 0}, {&next, row.width()}})
        for (int y = 0; y < image->height(); ++y)
            for (int x = 0; x < image->width(); ++x) wider.at(x0 + x, y) = image->at(x, y);
    row = std::move(wider);
}
template <class Pixel>
void append_below(Image<Pixel>& column, const Image<Pixel>& next) {
    Image<Pixel> higher(std::max(column.width(), next.width()), column.height() + next.height());
    for (const auto& [image, y0] :
         {std::pair<const Image<Pixel>*, int>{&column, 0}, {&next, column.height()}})
        for (int y = 0; y < image->height(); ++y)
            for (int x = 0; x < image->width(); ++x) higher.at(x, y0 + y) = image->at(x, y);
    column = std::move(higher);
}

// "name 0x1.8p+1 ..." a line: no bit is lost.
std::string line(const std::string& name, const std::vector<double>& values);

// How nearly a point must be the same. As it stands: to the bit.
struct Allowed {
    double number = 0;  // numbers, and those of the text, may differ by that much times 1 + |number|
    int level = 0;      // each channel of the 8-bit pictures by that many of 255
    double beyond = 0;  // and so much of all pixels (or numbers) by more: of those on the border of something
    const char* reason = "every bit of it is a whole number, or copied";
    // Views of a scene are compared by the error set: limits of missing %, extra %, least PSNR, depth, bad %.
    // The pictures' tiles are as wide as high; the depths, one tile, are 0 where nothing is.
    bool by_error_set = false;
    double missing = 0, extra = 0, psnr = 0, depth = 0, bad = 0;
};
std::optional<std::string> difference_beyond(const Allowed& allowed, const Product& expected,
                                             const Product& actual);

// For a build of another precision: rounding moves what lies on a border.
Allowed loosened(Allowed allowed);

}  // namespace relevo::golden
