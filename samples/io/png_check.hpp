// Is a PNG file whole? Walks over its chunks and checks their lengths and checksums, so that a file that was
// cut off or damaged is refused before anything is decoded.
//
// Source: W3C, Portable Network Graphics (PNG) Specification, sections 5 (chunks) and annex D (CRC).
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace relevo::io {

inline constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

// The remainder of the polynomial division by x^32 + x^26 + ... + 1, lowest bit first, a byte a table
// look-up.
inline std::uint32_t crc32(std::string_view bytes) {
    static constexpr std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> out{};
        for (std::uint32_t n = 0; n < 256; ++n) {
            std::uint32_t c = n;
            for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
            out[n] = c;
        }
        return out;
    }();
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) crc = table[(crc ^ static_cast<unsigned char>(byte)) & 255] ^ (crc >> 8);
    return ~crc;
}

inline std::uint32_t big_endian_32(std::string_view bytes, std::size_t at) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < 4; ++i) out = out << 8 | static_cast<unsigned char>(bytes[at + i]);
    return out;
}

struct PngSize {
    std::uint32_t width = 0, height = 0;
};

// What is wrong with the bytes of a file that starts with the signature; "" when the chunks are whole up to
// IEND. `size` is what the header says.
inline std::string png_damage(std::string_view bytes, PngSize& size) {
    const std::string cut_off = "the PNG file is cut off after " + std::to_string(bytes.size()) + " bytes";
    constexpr std::size_t around = 12;  // length, type and checksum of a chunk
    for (std::size_t at = png_signature.size();;) {
        if (bytes.size() - at < around) return cut_off;
        const std::size_t length = big_endian_32(bytes, at);
        if (bytes.size() - at - around < length) return cut_off;
        const std::string_view type = bytes.substr(at + 4, 4);
        if (crc32(bytes.substr(at + 4, 4 + length)) != big_endian_32(bytes, at + 8 + length))
            return "the PNG file is damaged near byte " + std::to_string(at) + ": a checksum is wrong";
        if (at == png_signature.size()) {
            if (type != "IHDR" || length != 13)
                return "the PNG file is damaged: it does not start with its header";
            size = {big_endian_32(bytes, at + 8), big_endian_32(bytes, at + 12)};
        }
        if (type == "IEND") return "";
        at += around + length;
    }
}

}  // namespace relevo::io
