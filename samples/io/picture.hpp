// Pictures out of image files (PNG, JPEG, EXR and whatever else OpenImageIO reads), and EXR files.
//
// OpenImageIO takes a quarter of a second and 130 MiB at the start of every program that links it. So it
// lives in a module of its own (oiio_module.cpp) that is opened here, when the first image file is read or an
// EXR written.
#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/scalar.hpp"
#include "raster/image.hpp"
#include "raster/output.hpp"
#include "samples/io/place.hpp"

namespace relevo::io {

// What an image file holds, number for number: rows from top to bottom, channels side by side, straight
// alpha. 8 and 16 bit numbers stay what they are, every other kind becomes float.
struct Pixels {
    int width = 0, height = 0, channels = 0;  // 1..max_texture_size a side, 1..4 channels
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> samples;
};

// An 8-bit picture, top row first, as make_texture wants it.
struct Picture {
    int width = 0, height = 0, channels = 0;  // 3 = RGB, 4 = RGB and straight alpha
    std::vector<std::uint8_t> pixels;
};

// Errors of all readers: no such file, no image, cut off in the middle, no pixels, more than max_texture_size
// a side, more than 4 channels.
FileResult<Pixels> read_pixels(const std::string& path);

// The same for an image that must have this shape: any other is an error, before memory is taken for it.
struct PixelShape {
    int width, height, channels;
};
FileResult<Pixels> read_pixels(const std::string& path, const PixelShape& needed);

// Grey becomes RGB; 16 bits are rounded to 8; float is linear light and becomes sRGB codes.
FileResult<Picture> read_picture(const std::string& path);

// The same as a picture of the rasterizer; without an alpha channel it is opaque.
FileResult<raster::Image<raster::Rgba8>> read_image(const std::string& path);

// The first channel of an image file as float: what write_exr wrote comes back bit for bit.
FileResult<raster::Image<float>> read_exr(const std::string& path);

// The bytes of an image file of these numbers: EXR (lossless) for float, else PNG. Its colours are stored as
// they are. The same numbers give the same bytes. `path` stands in errors.
FileResult<std::string> image_bytes(const std::string& path, const Pixels& pixels);

// One channel "Z" of 32-bit float (lossless), complete or not at all.
Failure write_exr(const std::string& path, const raster::Image<pipeline::Scalar>& image);

}  // namespace relevo::io
