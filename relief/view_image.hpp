// What a viewer gets of an object: colour, depth and coverage of every pixel.
#pragma once
#include <cstdint>

#include "pipeline/color.hpp"
#include "raster/image.hpp"

namespace relevo::relief {

using pipeline::LinearRgb;
using pipeline::Scalar;
using raster::Image;

// Three pictures of one size. Where coverage is 0 nothing was seen, and colour and depth mean nothing.
struct ViewImage {
    Image<LinearRgb> color;
    Image<Scalar> depth;  // world units from the viewer's plane, along its axis
    Image<std::uint8_t> coverage;

    ViewImage() = default;
    ViewImage(int width, int height) : color(width, height), depth(width, height), coverage(width, height) {}
    int width() const { return coverage.width(); }
    int height() const { return coverage.height(); }
};

}  // namespace relevo::relief
