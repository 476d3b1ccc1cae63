// Two pictures, number by number: are they the same, and if not, where and by how much?
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "raster/image.hpp"
#include "raster/output.hpp"
#include "samples/io/picture.hpp"

namespace relevo::io {

struct PixelDifference {
    int x = 0, y = 0;
    std::array<double, 4> a{}, b{};  // the first `channels` of them count
    double difference = 0;           // the largest one over the channels
};

struct Comparison {
    std::string not_comparable;  // why; empty when sizes, channels and kinds of number agree
    int width = 0, height = 0, channels = 0;
    std::size_t different = 0;  // pixels with at least one unequal channel
    std::optional<PixelDifference> first,
        worst;  // first row by row from the top; of equally bad ones the first

    bool same() const { return not_comparable.empty() && different == 0; }
};

// Exact: no tolerance. Two not-a-numbers are equal; one against a number differs by infinity.
Comparison compare(const Pixels& a, const Pixels& b);
Comparison compare(const raster::Image<raster::Rgba8>& a, const raster::Image<raster::Rgba8>& b);

// One friendly paragraph: the verdict, the first and the worst pixel.
std::string describe(const Comparison& comparison, const std::string& name_a, const std::string& name_b);

// Side by side with white lines between them: a, b, and on black the difference (8-bit numbers: times 8;
// others: the largest difference is white). Both must be comparable.
raster::Image<raster::Rgba8> difference_picture(const Pixels& a, const Pixels& b);
raster::Image<raster::Rgba8> difference_picture(const raster::Image<raster::Rgba8>& a,
                                                const raster::Image<raster::Rgba8>& b);

}  // namespace relevo::io
