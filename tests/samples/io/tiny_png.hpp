// PNG files made by hand for tests: any header, pixels stored without compression.
//
// Source: W3C, Portable Network Graphics (PNG) Specification; RFC 1950 (zlib) and RFC 1951 3.2.4 (stored
// blocks).
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "samples/io/png_check.hpp"

namespace relevo::io {

inline std::string big_endian(std::uint32_t number) {
    std::string out;
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(number >> shift & 255);
    return out;
}

inline std::string png_chunk(const std::string& type, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc32(type + data));
}

inline std::string stored_zlib(std::string_view data) {
    std::uint32_t a = 1, b = 0;
    for (const char byte : data) a = (a + static_cast<unsigned char>(byte)) % 65521, b = (b + a) % 65521;
    const auto low = static_cast<char>(data.size() & 255), high = static_cast<char>(data.size() >> 8);
    const char block[] = {1, low, high, static_cast<char>(~low), static_cast<char>(~high)};
    return "\x78\x01" + std::string(block, sizeof block) + std::string(data) + big_endian(b << 16 | a);
}

// `rows` holds a zero byte (no filter) before each row; less than 64 KiB. Colour types: 0 grey, 2 RGB, 3
// palette, 4 grey and alpha, 6 RGBA.
inline std::string tiny_png(std::uint32_t width, std::uint32_t height, int bits, int color_type,
                            std::string_view rows) {
    const char kind[] = {static_cast<char>(bits), static_cast<char>(color_type), 0, 0, 0};
    return std::string(png_signature) +
           png_chunk("IHDR", big_endian(width) + big_endian(height) + std::string(kind, sizeof kind)) +
           png_chunk("IDAT", stored_zlib(rows)) + png_chunk("IEND", "");
}

}  // namespace relevo::io
