#include "samples/io/picture.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "samples/io/png.hpp"
#include "tests/samples/io/size_limit.hpp"
#include "tests/samples/io/temporary_folder.hpp"
#include "tests/samples/io/tiny_png.hpp"

namespace relevo::io {
namespace {

using Bytes = std::vector<std::uint8_t>;
using pipeline::Scalar;
using raster::Image;

const std::string jpeg = "/usr/share/assimp/models/OBJ/SpiderTex.jpg";  // of the package assimp-testmodels

Picture picture_of(std::string_view bytes) {
    const TemporaryFolder folder;
    const auto picture = read_picture(folder.write("x.png", bytes));
    EXPECT_TRUE(picture) << picture.error().text();
    return picture ? *picture : Picture();
}

std::string error_of(std::string_view bytes, std::string_view name = "x.png") {
    const TemporaryFolder folder;
    const auto picture = read_picture(folder.write(name, bytes));
    return picture ? "no error" : folder.without_path(picture.error().text());
}

TEST(ReadPicture, GreyBecomesRgb) {
    const Picture picture = picture_of(tiny_png(2, 2, 8, 0, std::string_view("\0\x01\x02\0\x03\xff", 6)));
    EXPECT_EQ(picture.width, 2);
    EXPECT_EQ(picture.height, 2);
    EXPECT_EQ(picture.channels, 3);
    EXPECT_EQ(picture.pixels, (Bytes{1, 1, 1, 2, 2, 2, 3, 3, 3, 255, 255, 255}));  // top row first
}

TEST(ReadPicture, GreyAndAlphaBecomeRgba) {
    const Picture picture = picture_of(tiny_png(2, 1, 8, 4, std::string_view("\0\x64\x00\x07\x80", 5)));
    EXPECT_EQ(picture.channels, 4);
    EXPECT_EQ(picture.pixels, (Bytes{100, 100, 100, 0, 7, 7, 7, 128}));
}

TEST(ReadPicture, AlphaIsStraight) {
    const Picture picture =
        picture_of(tiny_png(2, 1, 8, 6, std::string_view("\0\x01\x02\x03\x00\xff\x80\x40\x01", 9)));
    EXPECT_EQ(picture.pixels, (Bytes{1, 2, 3, 0, 255, 128, 64, 1}));
}

TEST(ReadPicture, SixteenBitsAreRounded) {
    // 0x0080 = 128 is just under half of 257, 0x0081 just above.
    const std::string_view rows("\0\x00\x80\x00\x81\xff\xff\x80\x80", 9);
    const Picture picture = picture_of(tiny_png(4, 1, 16, 0, rows));
    EXPECT_EQ(picture.pixels, (Bytes{0, 0, 0, 1, 1, 1, 255, 255, 255, 128, 128, 128}));
}

TEST(ReadPicture, FloatIsLinearLight) {
    const TemporaryFolder folder;
    Image<Scalar> image(3, 1);
    image.pixels() = {0, Scalar(0.5), 7};
    ASSERT_FALSE(write_exr(folder.path("x.exr"), image));
    const auto picture = read_picture(folder.path("x.exr"));
    ASSERT_TRUE(picture) << picture.error().text();
    const std::uint8_t half = raster::to_srgb8(Scalar(0.5));
    EXPECT_EQ(picture->pixels, (Bytes{0, 0, 0, half, half, half, 255, 255, 255}));
}

TEST(ReadPicture, ReadsJpeg) {
    const auto picture = read_picture(jpeg);
    ASSERT_TRUE(picture) << picture.error().text();
    EXPECT_EQ(picture->width, 249);
    EXPECT_EQ(picture->height, 250);
    EXPECT_EQ(picture->channels, 3);
    EXPECT_EQ(picture->pixels.size(), 249u * 250u * 3u);
}

TEST(ReadPixels, KeepsTheNumbersOfTheFile) {
    const TemporaryFolder folder;
    const auto pixels =
        read_pixels(folder.write("x.png", tiny_png(2, 1, 16, 0, std::string_view("\0\x12\x34\xff\xfe", 5))));
    ASSERT_TRUE(pixels) << pixels.error().text();
    EXPECT_EQ(pixels->channels, 1);
    EXPECT_EQ(std::get<std::vector<std::uint16_t>>(pixels->samples),
              (std::vector<std::uint16_t>{0x1234, 0xfffe}));
}

TEST(PictureErrors, FilesThatAreMissingOrNoImages) {
    const TemporaryFolder folder;
    EXPECT_EQ(folder.without_path(read_picture(folder.path("no.png")).error().text()),
              "no.png: there is no such file");
    EXPECT_EQ(folder.without_path(read_picture(folder.path(".")).error().text()),
              ".: is a directory, a file is needed");
    EXPECT_EQ(error_of(""), "x.png: the file is empty");
    EXPECT_EQ(error_of("hello world\n"), "x.png: cannot be read as an image: Not a PNG file");
    EXPECT_EQ(error_of("hello world\n", "notes.txt").find("notes.txt: cannot be read as an image: "), 0u);
    EXPECT_EQ(error_of("hello\nworld\n", "notes.txt").find('\n'), std::string::npos);
}

TEST(PictureErrors, APngCutInHalf) {
    const TemporaryFolder folder;
    Image<raster::Rgba8> image(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            image.at(x, y) = {std::uint8_t(x * y), std::uint8_t(x ^ y), std::uint8_t(y), 255};
    ASSERT_FALSE(write_png(folder.path("x.png"), image));
    const std::string whole = bytes_of(folder.path("x.png"));
    testing::internal::CaptureStderr();
    for (const std::size_t size : {whole.size() / 2, whole.size() - 1, std::size_t(8), std::size_t(20)})
        EXPECT_EQ(error_of(whole.substr(0, size)),
                  "x.png: the PNG file is cut off after " + std::to_string(size) + " bytes");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");  // the decoder adds no words of its own
    EXPECT_EQ(error_of(whole), "no error");
}

TEST(PictureErrors, APngWithAWrongByte) {
    std::string bytes = tiny_png(2, 1, 8, 0, std::string_view("\0ab", 3));
    bytes[bytes.size() - 20] ^= 1;
    EXPECT_EQ(error_of(bytes), "x.png: the PNG file is damaged near byte 33: a checksum is wrong");
}

TEST(PictureErrors, AJpegCutInHalf) {
    const std::string whole = bytes_of(jpeg);
    ASSERT_GT(whole.size(), 1000u) << jpeg << " is missing: install assimp-testmodels";
    const std::string error = error_of(whole.substr(0, whole.size() / 2), "x.jpg");
    EXPECT_EQ(error.find("x.jpg: cannot be read as an image: JPEG error: Premature end of JPEG file"), 0u)
        << error;
}

TEST(PictureErrors, AnExrCutInHalf) {
    const TemporaryFolder folder;
    ASSERT_FALSE(write_exr(folder.path("x.exr"), Image<Scalar>(200, 200, Scalar(0.5))));
    const std::string whole = bytes_of(folder.path("x.exr"));
    const std::string error = error_of(whole.substr(0, whole.size() / 2), "x.exr");
    EXPECT_EQ(error.find("x.exr: cannot be read as an image: "), 0u) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

TEST(PictureErrors, SizesThatAreNotAccepted) {
    const auto error = [](std::uint32_t width, std::uint32_t height) {
        return error_of(tiny_png(width, height, 8, 0, std::string_view("\0a", 2)));
    };
    const std::string accepted = " pixels, accepted are 1 to 16384 a side";
    EXPECT_EQ(error(0, 0), "x.png: the image has 0 x 0" + accepted);
    EXPECT_EQ(error(1, 0), "x.png: the image has 1 x 0" + accepted);
    EXPECT_EQ(error(16385, 1), "x.png: the image has 16385 x 1" + accepted);
    EXPECT_EQ(error(1, 1000000000), "x.png: the image has 1 x 1000000000" + accepted);
    // The same for a file that only the decoder understands: a picture in Targa's uncompressed grey.
    const std::string_view wide_targa("\0\0\x03\0\0\0\0\0\0\0\0\0\xff\xff\x01\0\x08\0 ", 19);
    EXPECT_EQ(error_of(wide_targa, "x.tga"), "x.tga: the image has 65535 x 1" + accepted);
}

TEST(Exr, ReadsBackBitForBit) {
    const TemporaryFolder folder;
    Image<Scalar> image(37, 23);
    std::uint32_t state = 1;
    for (Scalar& number : image.pixels())
        number = Scalar(std::bit_cast<float>(state = state * 1664525 + 1013904223));
    image.at(0, 0) = -Scalar(0);
    image.at(1, 0) = std::numeric_limits<float>::denorm_min();
    image.at(2, 0) = std::numeric_limits<Scalar>::infinity();
    image.at(3, 0) = std::numeric_limits<float>::max();
    ASSERT_FALSE(write_exr(folder.path("x.exr"), image));
    const auto again = read_exr(folder.path("x.exr"));
    ASSERT_TRUE(again) << again.error().text();
    ASSERT_EQ(again->width(), 37);
    ASSERT_EQ(again->height(), 23);
    for (std::size_t i = 0; i < image.pixels().size(); ++i)
        EXPECT_EQ(std::bit_cast<std::uint32_t>(again->pixels()[i]),
                  std::bit_cast<std::uint32_t>(static_cast<float>(image.pixels()[i])));
}

TEST(Exr, HasOneChannelNamedZ) {
    const TemporaryFolder folder;
    ASSERT_FALSE(write_exr(folder.path("x.exr"), Image<Scalar>(2, 2, 1)));
    // A channel list is: name, 0, type (2 = float), ...
    EXPECT_NE(bytes_of(folder.path("x.exr")).find(std::string("Z\0\2\0\0\0", 6)), std::string::npos);
    EXPECT_EQ(read_pixels(folder.path("x.exr"))->channels, 1);
}

TEST(Exr, TheSameNumbersGiveTheSameBytes) {
    const TemporaryFolder folder;
    ASSERT_FALSE(write_exr(folder.path("a.exr"), Image<Scalar>(100, 100, Scalar(0.25))));
    ASSERT_FALSE(write_exr(folder.path("b.exr"), Image<Scalar>(100, 100, Scalar(0.25))));
    EXPECT_EQ(bytes_of(folder.path("a.exr")), bytes_of(folder.path("b.exr")));
}

TEST(Exr, SaysWhatIsWrongAndLeavesNothingBehind) {
    const TemporaryFolder folder;
    const auto error = [&](const std::string& name, const Image<Scalar>& image) {
        const Failure failure = write_exr(folder.path(name), image);
        return failure ? folder.without_path(failure->text()) : "no error";
    };
    EXPECT_EQ(error("x.exr", {}), "x.exr: cannot be written: the image has no pixels");
    EXPECT_EQ(error("no/x.exr", Image<Scalar>(2, 2)),
              "no/x.exr: cannot be written: No such file or directory");
    {
        const SizeLimit limit(100);
        EXPECT_EQ(error("x.exr", Image<Scalar>(50, 50)), "x.exr: cannot be written: File too large");
    }
    EXPECT_TRUE(folder.names().empty());
    const std::string integers = folder.write("x.png", tiny_png(1, 1, 8, 0, std::string_view("\0a", 2)));
    EXPECT_EQ(folder.without_path(read_exr(integers).error().text()),
              "x.png: holds integers, an image of float numbers is needed");
}

}  // namespace
}  // namespace relevo::io
