#include "samples/io/png.hpp"

#include <gtest/gtest.h>

#include "samples/io/picture.hpp"
#include "tests/samples/io/size_limit.hpp"
#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::io {
namespace {

using raster::Image;
using raster::Rgba8;

// Every byte differs from its neighbours'.
Image<Rgba8> noise(int width, int height, bool opaque) {
    Image<Rgba8> image(width, height);
    std::uint32_t state = 1;
    const auto next = [&] { return static_cast<std::uint8_t>((state = state * 1664525 + 1013904223) >> 24); };
    for (Rgba8& pixel : image.pixels()) {
        pixel = {next(), next(), next(), next()};
        if (opaque) pixel.a = 255;
    }
    return image;
}

TEST(WritePng, ReadsBackTheSame) {
    const TemporaryFolder folder;
    for (const bool opaque : {true, false}) {
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(7, 3), std::pair(256, 100)}) {
            const Image<Rgba8> image = noise(width, height, opaque);
            ASSERT_FALSE(write_png(folder.path("x.png"), image));
            const auto again = read_image(folder.path("x.png"));
            ASSERT_TRUE(again) << again.error().text();
            EXPECT_EQ(again->width(), width);
            EXPECT_EQ(again->pixels(), image.pixels());  // also the colours where alpha is 0
        }
    }
}

TEST(WritePng, LeavesOutAnAlphaThatIsAlwaysOpaque) {
    const TemporaryFolder folder;
    Image<Rgba8> image(3, 2, {1, 2, 3, 255});
    ASSERT_FALSE(write_png(folder.path("x.png"), image));
    EXPECT_EQ(read_picture(folder.path("x.png"))->channels, 3);
    image.at(2, 1).a = 254;
    ASSERT_FALSE(write_png(folder.path("x.png"), image));
    EXPECT_EQ(read_picture(folder.path("x.png"))->channels, 4);
}

TEST(WritePng, TheSamePictureGivesTheSameBytes) {
    const TemporaryFolder folder;
    ASSERT_FALSE(write_png(folder.path("a.png"), noise(50, 50, true)));
    ASSERT_FALSE(write_png(folder.path("b.png"), noise(50, 50, true)));
    EXPECT_EQ(bytes_of(folder.path("a.png")), bytes_of(folder.path("b.png")));
}

TEST(WritePng, SaysWhatIsWrongAndLeavesNothingBehind) {
    const TemporaryFolder folder;
    const auto error = [&](const std::string& name, const Image<Rgba8>& image) {
        const Failure failure = write_png(folder.path(name), image);
        return failure ? folder.without_path(failure->text()) : "no error";
    };
    EXPECT_EQ(error("x.png", {}), "x.png: cannot be written: the picture has no pixels");
    EXPECT_EQ(error("no/x.png", noise(2, 2, true)), "no/x.png: cannot be written: No such file or directory");
    {
        const SizeLimit limit(1000);
        EXPECT_EQ(error("x.png", noise(50, 50, true)), "x.png: cannot be written: File too large");
    }
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace relevo::io
