#include "samples/io/png.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "samples/io/file.hpp"

// The encoder of Debian's libstb-dev, compiled here and nowhere else.
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace relevo::io {
namespace {

void take_bytes(void* user, void* bytes, int size) {
    static_cast<std::string*>(user)->assign(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

// The pixels without their alpha.
std::vector<std::uint8_t> rgb_rows(const raster::Image<raster::Rgba8>& image) {
    std::vector<std::uint8_t> rows;
    rows.reserve(image.pixels().size() * 3);
    for (const raster::Rgba8& p : image.pixels()) rows.insert(rows.end(), {p.r, p.g, p.b});
    return rows;
}

// The encoder counts bytes in int.
bool too_large(const raster::Image<raster::Rgba8>& image, int channels) {
    return (std::size_t(image.width()) * std::size_t(channels) + 1) * std::size_t(image.height()) >
           0x7fffffff;
}

}  // namespace

std::string png_bytes(const raster::Image<raster::Rgba8>& image, int channels, PngContents contents) {
    static_assert(sizeof(raster::Rgba8) == 4);
    std::string bytes;
    if (image.empty() || too_large(image, channels)) return bytes;
    const std::vector<std::uint8_t> rgb = channels == 3 ? rgb_rows(image) : std::vector<std::uint8_t>();
    const void* const rows = channels == 3 ? static_cast<const void*>(rgb.data()) : image.pixels().data();
    const bool diagram = contents == PngContents::Diagram;
    stbi_write_force_png_filter = diagram ? 0 : -1;
    stbi_write_png_compression_level = diagram ? 5 : 8;
    stbi_write_png_to_func(take_bytes, &bytes, image.width(), image.height(), channels, rows,
                           image.width() * channels);
    return bytes;
}

Failure write_png(const std::string& path, const raster::Image<raster::Rgba8>& image) {
    if (image.empty()) return error_in(path, "cannot be written: the picture has no pixels");
    const bool opaque = std::all_of(image.pixels().begin(), image.pixels().end(),
                                    [](const raster::Rgba8& pixel) { return pixel.a == 255; });
    const int channels = opaque ? 3 : 4;
    if (too_large(image, channels))
        return error_in(path, "cannot be written: the picture is too large for a PNG file, at most 2 GB");
    const std::string bytes = png_bytes(image, channels, PngContents::Any);
    if (bytes.empty()) return error_in(path, "cannot be written: not enough memory for the PNG encoder");
    return write_file(path, bytes);
}

}  // namespace relevo::io
