#include "samples/io/png_check.hpp"

#include <gtest/gtest.h>

#include "tests/samples/io/tiny_png.hpp"

namespace relevo::io {
namespace {

const std::string good = tiny_png(2, 1, 8, 0, std::string_view("\0ab", 3));

std::string damage_of(std::string_view bytes) {
    PngSize size;
    return png_damage(bytes, size);
}

// The check value of every description of this CRC.
TEST(Crc32, KnowsItsCheckValue) {
    EXPECT_EQ(crc32("123456789"), 0xcbf43926u);
    EXPECT_EQ(crc32(""), 0u);
}

TEST(PngDamage, AWholeFileHasNone) {
    PngSize size;
    EXPECT_EQ(png_damage(good, size), "");
    EXPECT_EQ(size.width, 2u);
    EXPECT_EQ(size.height, 1u);
    EXPECT_EQ(png_damage(good + "what follows the end", size), "");
}

TEST(PngDamage, EveryCutIsSeen) {
    for (std::size_t size = png_signature.size(); size < good.size(); ++size)
        EXPECT_EQ(damage_of(good.substr(0, size)),
                  "the PNG file is cut off after " + std::to_string(size) + " bytes");
}

TEST(PngDamage, EveryChangedByteIsSeen) {
    for (std::size_t at = png_signature.size(); at < good.size(); ++at) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x10);
        EXPECT_NE(damage_of(bad), "") << at;
    }
}

TEST(PngDamage, SaysWhere) {
    std::string bad = good;
    bad[20] ^= 1;
    EXPECT_EQ(damage_of(bad), "the PNG file is damaged near byte 8: a checksum is wrong");
    EXPECT_EQ(damage_of(std::string(png_signature) + png_chunk("IEND", "")),
              "the PNG file is damaged: it does not start with its header");
}

}  // namespace
}  // namespace relevo::io
