// Animated PNG files, read back by a parser of their own: chunks in order, checksums, and the pixels of each
// frame.
#include "samples/io/apng.hpp"

#include <gtest/gtest.h>

#include "samples/io/picture.hpp"
#include "tests/samples/io/temporary_folder.hpp"
#include "tests/samples/io/tiny_png.hpp"

namespace relevo::io {
namespace {

using Picture = raster::Image<raster::Rgba8>;

struct Chunk {
    std::string type, data;
};

// The chunks of a file; a wrong length or checksum is a failure.
std::vector<Chunk> chunks_of(const std::string& file) {
    std::vector<Chunk> out;
    EXPECT_EQ(file.substr(0, 8), png_signature);
    std::size_t at = 8;
    while (at + 12 <= file.size()) {
        const std::size_t size = big_endian_32(file, at);
        if (size > file.size() - at - 12) break;
        out.push_back({file.substr(at + 4, 4), file.substr(at + 8, size)});
        EXPECT_EQ(file.substr(at, size + 12), png_chunk(out.back().type, out.back().data));
        at += size + 12;
    }
    EXPECT_EQ(at, file.size()) << "nothing after the last chunk";
    return out;
}

struct Shown {
    Picture picture;
    int milliseconds;
};

// Plays the film: each frame's rectangle is decoded as a PNG of its own and laid over the frame before.
std::vector<Shown> played(const std::string& file) {
    const TemporaryFolder folder;
    const std::vector<Chunk> chunks = chunks_of(file);
    std::vector<Shown> out;
    std::uint32_t sequence = 0;
    const std::string header = chunks.at(0).data;
    for (std::size_t i = 2; i + 1 < chunks.size(); i += 2) {
        const std::string& control = chunks[i].data;
        EXPECT_EQ(chunks[i].type, "fcTL");
        EXPECT_EQ(control.size(), 26u);
        EXPECT_EQ(big_endian_32(control, 0), sequence++);
        const auto number = [&](std::size_t at) { return static_cast<int>(big_endian_32(control, at)); };
        const int width = number(4), height = number(8), left = number(12), top = number(16);
        EXPECT_EQ(control.substr(22), std::string("\x03\xe8\0\0", 4)) << "thousandths; no disposal, no blend";
        const int delay =
            static_cast<unsigned char>(control[20]) * 256 + static_cast<unsigned char>(control[21]);
        const Chunk& pixels = chunks.at(i + 1);
        EXPECT_EQ(pixels.type, i == 2 ? "IDAT" : "fdAT");
        if (i != 2) {
            EXPECT_EQ(big_endian_32(pixels.data, 0), sequence++);
        }
        const std::string rebuilt =
            std::string(png_signature) + png_chunk("IHDR", control.substr(4, 8) + header.substr(8)) +
            png_chunk("IDAT", pixels.data.substr(i == 2 ? 0 : 4)) + png_chunk("IEND", "");
        const auto part = read_image(folder.write("part.png", rebuilt));
        if (!part) {
            ADD_FAILURE() << part.error().text();
            return out;
        }
        EXPECT_EQ(part->width(), width);
        EXPECT_EQ(part->height(), height);
        Picture shown = out.empty() ? Picture(width, height) : out.back().picture;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) shown.at(left + x, top + y) = part->at(x, y);
        out.push_back({shown, delay});
    }
    return out;
}

// A dark square on a bright slope.
Picture square_at(int x, int y) {
    Picture picture(40, 30);
    for (int j = 0; j < 30; ++j)
        for (int i = 0; i < 40; ++i)
            picture.at(i, j) = {std::uint8_t(100 + 2 * i), std::uint8_t(200 - j), 250, 255};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) picture.at(x + i, y + j) = {10, 20, 30, 255};
    return picture;
}

std::string film(std::initializer_list<Picture> pictures) {
    AnimatedPng animation;
    for (const Picture& picture : pictures) animation.add(picture, 1000);
    return animation.bytes();
}

TEST(AnimatedPng, PlaysThePicturesThatWentIn) {
    const std::vector<Picture> pictures{square_at(0, 0), square_at(5, 3), square_at(5, 3), square_at(36, 26),
                                        square_at(0, 26)};
    AnimatedPng animation;
    for (std::size_t i = 0; i < pictures.size(); ++i) animation.add(pictures[i], i == 4 ? 3000 : 1000);
    const std::vector<Shown> shown = played(animation.bytes());
    ASSERT_EQ(shown.size(), pictures.size());
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        EXPECT_EQ(shown[i].picture.pixels(), pictures[i].pixels()) << "frame " << i;
        EXPECT_EQ(shown[i].milliseconds, i == 4 ? 3000 : 1000);
    }
}

TEST(AnimatedPng, SaysHowManyFramesAndRunsForEver) {
    const std::vector<Chunk> chunks = chunks_of(film({square_at(0, 0), square_at(1, 0), square_at(2, 0)}));
    std::string types;
    for (const Chunk& chunk : chunks) types += chunk.type + " ";
    EXPECT_EQ(types, "IHDR acTL fcTL IDAT fcTL fdAT fcTL fdAT IEND ");
    EXPECT_EQ(chunks[0].data, big_endian(40) + big_endian(30) + std::string("\x08\x02\0\0\0", 5));
    EXPECT_EQ(chunks[1].data, big_endian(3) + big_endian(0));
}

TEST(AnimatedPng, StoresOnlyWhatChanges) {
    const std::vector<Chunk> chunks = chunks_of(film({square_at(0, 0), square_at(5, 3), square_at(5, 3)}));
    EXPECT_EQ(chunks[4].data.substr(4, 16), big_endian(9) + big_endian(7) + big_endian(0) + big_endian(0));
    EXPECT_EQ(chunks[6].data.substr(4, 8), big_endian(1) + big_endian(1)) << "no frame is empty";
}

TEST(AnimatedPng, IsAPlainPictureForOthers) {
    const TemporaryFolder folder;
    const auto read = read_image(folder.write("film.png", film({square_at(3, 3), square_at(9, 9)})));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->pixels(), square_at(3, 3).pixels());
}

TEST(AnimatedPng, TheSameFilmGivesTheSameBytes) {
    EXPECT_EQ(film({square_at(3, 3), square_at(9, 9)}), film({square_at(3, 3), square_at(9, 9)}));
    EXPECT_EQ(AnimatedPng().bytes(), "");
}

}  // namespace
}  // namespace relevo::io
