// What a golden keeps of a stage: exact data that decide, and a picture for people.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "raster/image.hpp"
#include "raster/output.hpp"

namespace relevo::golden {

struct Product {
    std::string text;                      // clipped, window: every number in hexadecimal, no bit is lost
    raster::Image<raster::Rgba8> picture;  // colour; coverage as colours that name triangles; else a preview
    raster::Image<float> numbers;          // depth, attributes
};

// 64 bits of everything in it (Fowler, Noll and Vo's hash 1a), as 16 hexadecimal digits.
std::string hash(const Product& product);

// The first place where they differ, with both values; nothing when they are the same to the bit.
std::optional<std::string> first_difference(const Product& expected, const Product& actual);

// Like it, for a machine of another precision (the double preset): the words are equal, the numbers agree to
// 1e-5, at most 8 pixels are off by more than rounding.
std::optional<std::string> large_difference(const Product& expected, const Product& actual);

// White where they differ, a dim copy of what was expected elsewhere. Sizes must agree.
raster::Image<raster::Rgba8> difference_picture(const Product& expected, const Product& actual);

// The colour that names what covers a pixel: the last triangle (its number + 1) and how many do. Distinct
// for distinct pairs.
raster::Rgba8 coverage_color(std::uint32_t last, std::uint32_t count);

}  // namespace relevo::golden
