// PNG files out of pictures.
#pragma once
#include <string>

#include "raster/image.hpp"
#include "raster/output.hpp"
#include "samples/io/place.hpp"

namespace relevo::io {

// Writes an 8-bit PNG, complete or not at all: RGB when every pixel is opaque, else RGBA with straight alpha.
// The same picture gives the same bytes. Errors: an empty picture, and those of write_file.
Failure write_png(const std::string& path, const raster::Image<raster::Rgba8>& image);

// How hard the encoder tries. Diagrams are flat: rows as they are, without PNG's filters, are as small and
// three times as fast (measured: 960x720, 44 kB in 19 ms; with filters 45 kB in 67 ms).
enum class PngContents { Any, Diagram };

// The bytes of such a file with 3 (alpha is left out) or 4 channels; empty for an empty picture, one above
// 2 GB and when memory is short.
std::string png_bytes(const raster::Image<raster::Rgba8>& image, int channels, PngContents contents);

}  // namespace relevo::io
