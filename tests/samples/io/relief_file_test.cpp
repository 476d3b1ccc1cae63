#include "samples/io/relief_file.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "relief/quantize.hpp"
#include "relief/ray_cast.hpp"
#include "samples/io/picture.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/samples/io/size_limit.hpp"
#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::io {
namespace {

using pipeline::LinearRgb;
using pipeline::Scalar;
using pipeline::Vec3;
using relief::ReliefTexture;
using Names = std::vector<std::string>;

constexpr ReliefNumbers all_numbers[] = {ReliefNumbers::Float, ReliefNumbers::Bits16, ReliefNumbers::Bits8};

ReliefTexture orthographic(int size = 48) {
    return ray_cast(scene::bumpy_object, *relief::orthographic_camera(
                                             {{0.3, -0.2, 1}, {0, 1, 0}, size, size + 3}, {0, 0, -1.2}, 2.1));
}
ReliefTexture perspective() {
    return ray_cast(scene::complex_object, *relief::perspective_camera({{0.2, -0.1, 1}, {0, 1, 0}, 40, 31},
                                                                       {-0.6, 0.3, -3}, 1.7, {42}));
}

void expect_same_camera(const relief::ReliefCamera& a, const relief::ReliefCamera& b) {
    EXPECT_EQ(a.projection, b.projection);
    EXPECT_EQ(a.corner, b.corner);
    EXPECT_EQ(a.a, b.a);
    EXPECT_EQ(a.b, b.b);
    EXPECT_EQ(a.eye, b.eye);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
}

ReliefTexture there_and_back(const TemporaryFolder& folder, const ReliefTexture& texture,
                             ReliefNumbers numbers) {
    const Failure failure = write_relief(folder.path("x.json"), texture, numbers);
    EXPECT_FALSE(failure) << failure->text();
    const auto again = read_relief(folder.path("x.json"));
    EXPECT_TRUE(again) << again.error().text();
    return again ? *again : ReliefTexture();
}

// ---- round trips ----

TEST(ReliefFile, FloatComesBackBitForBit) {
    for (ReliefTexture texture : {orthographic(), perspective()}) {
        const TemporaryFolder folder;
        texture.color.at(20, 20) = {Scalar(-0.0f), std::numeric_limits<float>::denorm_min(), 7};
        texture.coverage.at(20, 20) = 1;
        if (texture.camera.projection == relief::Projection::Perspective) texture.depth.at(20, 20) = 1;
        const ReliefTexture again = there_and_back(folder, texture, ReliefNumbers::Float);
        EXPECT_EQ(folder.names(),
                  (Names{"x-color.exr", "x-coverage.png", "x-depth.exr", "x-normal.exr", "x.json"}));
        expect_same_camera(again.camera, texture.camera);
        EXPECT_EQ(again.coverage.pixels(), texture.coverage.pixels());
        const auto bits = [](Scalar number) {
            return std::bit_cast<std::uint32_t>(static_cast<float>(number));
        };
        int covered = 0;
        for (std::size_t i = 0; i < texture.color.pixels().size(); ++i) {
            if (!texture.coverage.pixels()[i]) continue;
            ++covered;
            const LinearRgb c = texture.color.pixels()[i], d = again.color.pixels()[i];
            ASSERT_TRUE(bits(c.r) == bits(d.r) && bits(c.g) == bits(d.g) && bits(c.b) == bits(d.b)) << i;
            for (int k = 0; k < 3; ++k)
                ASSERT_EQ(bits(texture.normal.pixels()[i][k]), bits(again.normal.pixels()[i][k])) << i;
            ASSERT_EQ(bits(texture.depth.pixels()[i]), bits(again.depth.pixels()[i])) << i;
        }
        EXPECT_GT(covered, 200);
    }
}

template <class Code>
void check_bounds(const ReliefTexture& texture, const ReliefTexture& again, double most_color,
                  double most_normal) {
    EXPECT_EQ(again.coverage.pixels(), texture.coverage.pixels());
    const double half_step = step(relief::quantize<Code>(texture)) / 2;
    double depth = 0, color = 0, normal = 0;
    for (std::size_t i = 0; i < texture.color.pixels().size(); ++i) {
        if (!texture.coverage.pixels()[i]) continue;
        depth =
            std::max(depth, std::abs(double{texture.depth.pixels()[i]} - double{again.depth.pixels()[i]}));
        const LinearRgb c = texture.color.pixels()[i], d = again.color.pixels()[i];
        for (const Scalar off : {c.r - d.r, c.g - d.g, c.b - d.b})
            color = std::max(color, std::abs(double{off}));
        normal = std::max(normal, double{glm::length(texture.normal.pixels()[i] - again.normal.pixels()[i])});
    }
    std::printf("%zu bits: depth off by %.3g (half a step: %.3g), colour %.3g, normal %.3g\n",
                8 * sizeof(Code), depth, half_step, color, normal);
    EXPECT_LE(depth, half_step * 1.0001 + 2e-7);
    EXPECT_GT(depth, half_step * 0.5);
    EXPECT_LE(color, most_color);
    EXPECT_LE(normal, most_normal);
}

TEST(ReliefFile, FewerBitsStayWithinTheirBounds) {
    for (const ReliefTexture& texture : {orthographic(), perspective()}) {
        const TemporaryFolder folder;
        const ReliefTexture fine = there_and_back(folder, texture, ReliefNumbers::Bits16);
        EXPECT_EQ(folder.names(), (Names{"x-color.png", "x-depth.png", "x-normal.png", "x.json"}));
        expect_same_camera(fine.camera, texture.camera);
        check_bounds<std::uint16_t>(texture, fine, 1 / 131070.0 + 1e-7, std::sqrt(3) / 65534 + 2e-7);
        // The widest interval of a code of sRGB is the last: 1 - 0.991.
        check_bounds<std::uint8_t>(texture, there_and_back(folder, texture, ReliefNumbers::Bits8), 0.0045,
                                   std::sqrt(3) / 254);
    }
}

TEST(ReliefFile, TheHourLeavesNoTrace) {
    const TemporaryFolder folder;
    const auto written = [&] {
        EXPECT_FALSE(write_relief(folder.path("x.json"), orthographic(), ReliefNumbers::Float));
        return bytes_of(folder.path("x-color.exr")) + bytes_of(folder.path("x-depth.exr"));
    };
    const std::string now = written();
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // EXR keeps seconds
    EXPECT_TRUE(now == written());
}

TEST(ReliefFile, WhatWasReadIsWrittenAsTheSameBytes) {
    for (const ReliefNumbers numbers : all_numbers) {
        const TemporaryFolder folder;
        const ReliefTexture once = there_and_back(folder, orthographic(), numbers);
        ASSERT_FALSE(write_relief(folder.path("y.json"), once, numbers));
        int files = 0;
        for (const std::string& name : folder.names()) {
            if (name[0] != 'x') continue;
            std::string first = bytes_of(folder.path(name)),
                        second = bytes_of(folder.path("y" + name.substr(1)));
            for (std::size_t at; (at = first.find("\"x-")) != std::string::npos;) first[at + 1] = 'y';
            // Normals of few bits are made of length 1 again, which can move them by a code.
            if (numbers != ReliefNumbers::Float && name == "x-normal.png") continue;
            EXPECT_TRUE(first == second) << name;
            ++files;
        }
        EXPECT_EQ(files, numbers == ReliefNumbers::Float ? 5 : 3);
    }
}

TEST(ReliefFile, AxesAreExactInEveryForm) {
    ReliefTexture texture =
        make_relief_texture(*relief::orthographic_camera({{0, 0, -1}, {0, 1, 0}, 3, 2}, {0, 0, 0}, 2));
    for (std::size_t i = 0; i < 6; ++i) {
        texture.coverage.pixels()[i] = 1;
        texture.normal.pixels()[i] = Vec3(0), texture.normal.pixels()[i][int(i % 3)] = i < 3 ? 1 : -1;
        texture.depth.pixels()[i] = i < 3 ? 1 : 2;
        texture.color.pixels()[i] = {0, 1, i < 3 ? Scalar(1) : Scalar(0)};
    }
    for (const ReliefNumbers numbers : all_numbers) {
        const TemporaryFolder folder;
        const ReliefTexture again = there_and_back(folder, texture, numbers);
        EXPECT_EQ(again.normal.pixels(), texture.normal.pixels());
        EXPECT_EQ(again.depth.pixels(), texture.depth.pixels());
        EXPECT_TRUE(again.color.pixels() == texture.color.pixels());
    }
}

TEST(ReliefFile, EmptyOnesAndOneTexelAreFine) {
    ReliefTexture texture =
        make_relief_texture(*relief::orthographic_camera({{0, 0, -1}, {0, 1, 0}, 1, 1}, {0, 0, 0}, 2));
    for (const ReliefNumbers numbers : all_numbers)
        for (const std::uint8_t covered : {0, 1}) {
            const TemporaryFolder folder;
            texture.coverage.at(0, 0) = covered;
            EXPECT_EQ(there_and_back(folder, texture, numbers).coverage.at(0, 0), covered);
        }
}

// ---- errors when writing ----

TEST(ReliefFile, RefusesToWriteWhatItWouldNotRead) {
    const TemporaryFolder folder;
    const auto error = [&](const ReliefTexture& texture, const std::string& name = "x.json") {
        const Failure failure = write_relief(folder.path(name), texture, ReliefNumbers::Float);
        return failure ? folder.without_path(failure->text()) : "no error";
    };
    const Scalar nan = std::numeric_limits<Scalar>::quiet_NaN();
    ReliefTexture texture = orthographic(20);
    texture.color.at(9, 9).g = nan;
    EXPECT_EQ(error(texture), "x.json: cannot be written: texel (9, 9): its colour is not finite");
    texture = orthographic(20), texture.normal.at(9, 9).z = nan;
    EXPECT_EQ(error(texture), "x.json: cannot be written: texel (9, 9): its normal is not finite");
    texture = orthographic(20), texture.depth.at(9, 9) = nan;
    EXPECT_EQ(error(texture), "x.json: cannot be written: texel (9, 9): its depth is not a finite number");
    texture = orthographic(20), texture.color.at(0, 0).g = nan;  // empty: it means nothing
    EXPECT_EQ(error(texture), "no error");
    EXPECT_EQ(error(texture, "x.exr"),
              "x.exr: cannot be written: the name of a relief texture ends in .json");
    EXPECT_EQ(error(texture, "no/x.json"), "no/x-color.exr: cannot be written: No such file or directory");
}

TEST(ReliefFile, AFullDiskLeavesTheOldFilesOrNothing) {
    const TemporaryFolder folder;
    const SizeLimit limit(9000);  // enough for some of the pictures
    EXPECT_TRUE(write_relief(folder.path("x.json"), orthographic(), ReliefNumbers::Float));
    EXPECT_TRUE(folder.names().empty());
    const ReliefTexture small = orthographic(12);
    ASSERT_FALSE(write_relief(folder.path("x.json"), small, ReliefNumbers::Float));
    EXPECT_TRUE(write_relief(folder.path("x.json"), orthographic(), ReliefNumbers::Float));
    EXPECT_EQ(folder.names().size(), 5u);
    EXPECT_EQ(read_relief(folder.path("x.json"))->camera.width, 12);
}

// ---- errors when reading ----

class ReliefFileErrors : public testing::Test {
  protected:
    // The message after one piece of the file was replaced.
    std::string error_of(ReliefNumbers numbers, const std::string& piece, const std::string& by) {
        EXPECT_FALSE(write_relief(folder_.path("x.json"), orthographic(12), numbers));
        std::string text = bytes_of(folder_.path("x.json"));
        const std::size_t at = text.find(piece);
        EXPECT_NE(at, std::string::npos) << text;
        folder_.write("x.json", text.replace(at, piece.size(), by));
        return read();
    }
    std::string read() {
        const auto texture = read_relief(folder_.path("x.json"));
        return texture ? "no error" : folder_.without_path(texture.error().text());
    }
    TemporaryFolder folder_;
};

TEST_F(ReliefFileErrors, TextsThatAreNoJson) {
    EXPECT_EQ(read(), "x.json: there is no such file");
    folder_.write("x.json", "");
    EXPECT_EQ(read(), "x.json: the file is empty");
    folder_.write("x.json", "{\n  \"camera\": nope\n}");
    EXPECT_EQ(read().find("x.json:2:14: this is no JSON: "), 0u) << read();
    folder_.write("x.json", "{\n  \"camera\": {");
    EXPECT_EQ(read().find("x.json:2:14: this is no JSON: "), 0u) << read();
    folder_.write("x.json", "{ \"depth_low\": 1e999 }");
    EXPECT_EQ(read(), "x.json:1:20: this is no JSON: number overflow parsing '1e999'");
    folder_.write("x.json", std::string(100000, '['));
    EXPECT_EQ(read(), "x.json: nested more than 16 deep");
    folder_.write("x.json", "[]");
    EXPECT_EQ(read(), "x.json:1:1: the file: an object of fields is needed: { ... }");
}

TEST_F(ReliefFileErrors, NameThePlaceTheFieldAndWhatIsAccepted) {
    const auto error = [&](const std::string& piece, const std::string& by) {
        return error_of(ReliefNumbers::Bits8, piece, by);
    };
    EXPECT_EQ(error("\"relief_texture\": 1", "\"relief_texture\": 2"),
              "x.json:2:21: relief_texture: version 2 is not known, 1 is accepted");
    EXPECT_EQ(error("\"numbers\"", "\"nubmers\""),
              "x.json:23:14: nubmers: there is no such field, did you mean 'numbers'?");
    EXPECT_EQ(error("\"8 bits\"", "\"8 bit\""),
              "x.json:23:14: numbers: '8 bit' is not known, accepted are 'float', '16 bits', '8 bits'");
    EXPECT_EQ(error("orthographic", "parallel"),
              "x.json:4:19: camera.projection: 'parallel' is not known, accepted are 'orthographic', "
              "'perspective'");
    EXPECT_EQ(error("\"orthographic\"", "\"perspective\""),
              "x.json:3:13: camera.eye: is missing, an array of 3 numbers is needed");
    EXPECT_EQ(error("\"width\": 12", "\"width\": 12.5"),
              "x.json:20:14: camera.width: a whole number is needed");
    EXPECT_EQ(error("\"width\": 12", "\"width\": 0"),
              "x.json:3:13: camera: a relief texture has 1 to 8192 texels a side, not 0 x 15");
    EXPECT_EQ(error("\"width\": 12", "\"width\": 1e12"),
              "x.json:20:14: camera.width: a whole number is needed");
    EXPECT_EQ(error("\"a\": [", "\"a\": [null,"), "x.json:10:10: camera.a: an array of 3 numbers is needed");
    EXPECT_EQ(error("\"x-depth.png\"", "17"), "x.json:26:12: depth: a text in quotes is needed");
    EXPECT_EQ(error("\"depth_low\":", "\"coverage\": \"c.png\", \"depth_low\":"),
              "x.json:27:15: coverage: only float numbers need one");
    EXPECT_EQ(error("\"depth_high\": ", "\"depth_high\": -"),
              "x.json:28:17: depth_high: a number from depth_low up is needed");
    EXPECT_EQ(error_of(ReliefNumbers::Float, "\"depth\":", "\"depth_low\": 1, \"depth\":"),
              "x.json:26:16: depth_low: only 16 and 8 bits need one");
}

TEST_F(ReliefFileErrors, PicturesThatDoNotFit) {
    EXPECT_EQ(error_of(ReliefNumbers::Bits8, "x-depth.png", "none.png"), "none.png: there is no such file");
    EXPECT_EQ(error_of(ReliefNumbers::Bits8, "x-depth.png", "x-color.png"),
              "x-color.png: the image has 12 x 15 pixels of 3 channels, needed are 12 x 15 of 1");
    EXPECT_EQ(error_of(ReliefNumbers::Bits8, "\"height\": 15", "\"height\": 14"),
              "x-color.png: the image has 12 x 15 pixels of 3 channels, needed are 12 x 14 of 3");
    EXPECT_EQ(error_of(ReliefNumbers::Bits8, "\"8 bits\"", "\"16 bits\""),
              "x-color.png: holds 8-bit numbers, 16-bit ones are needed");
    EXPECT_EQ(
        error_of(ReliefNumbers::Float, "x-color.exr", "x.json").find("x.json: cannot be read as an image: "),
        0u);
    folder_.write("x-color.png", bytes_of(folder_.path("x-color.png")).substr(0, 100));
    EXPECT_FALSE(write_relief(folder_.path("x.json"), orthographic(12), ReliefNumbers::Bits8));
    folder_.write("x-color.png", bytes_of(folder_.path("x-color.png")).substr(0, 100));
    EXPECT_EQ(read(), "x-color.png: the PNG file is cut off after 100 bytes");
}

TEST_F(ReliefFileErrors, NumbersThatMeanNothing) {
    const float inf = std::numeric_limits<float>::infinity();
    const auto with = [&](const char* name, int channels, std::size_t texel, float number) {
        EXPECT_FALSE(write_relief(folder_.path("x.json"), orthographic(12), ReliefNumbers::Float));
        Pixels pixels = *read_pixels(folder_.path(name));
        std::get<std::vector<float>>(pixels.samples)[texel * std::size_t(channels)] = number;
        folder_.write(name, *image_bytes(name, pixels));
        return read();
    };
    const std::size_t covered = 7 * 12 + 6;
    EXPECT_EQ(with("x-color.exr", 3, covered, inf), "x-color.exr: texel (6, 7): its colour is not finite");
    EXPECT_EQ(with("x-normal.exr", 3, covered, inf), "x-normal.exr: texel (6, 7): its normal is not finite");
    EXPECT_EQ(with("x-depth.exr", 1, covered, inf),
              "x-depth.exr: texel (6, 7): its depth is not a finite number");
    EXPECT_EQ(with("x-depth.exr", 1, covered, -1),
              "x-depth.exr: texel (6, 7): its displacement is negative: the surface lies behind the plane");
    EXPECT_EQ(with("x-depth.exr", 1, 0, inf), "no error");  // an empty texel
}

// Any byte of the JSON file may be wrong: an error of one line, or a relief texture that can be used.
TEST_F(ReliefFileErrors, ADamagedDescriptionIsRefusedOrHarmless) {
    ASSERT_FALSE(write_relief(folder_.path("x.json"), orthographic(12), ReliefNumbers::Bits8));
    const std::string whole = bytes_of(folder_.path("x.json"));
    std::uint32_t state = 7;
    for (int i = 0; i < 400; ++i) {
        std::string text = whole;
        state = state * 1664525 + 1013904223;
        const std::size_t at = (state >> 8) % text.size();
        state = state * 1664525 + 1013904223;
        if (i % 4 == 0)
            text.resize(at);
        else
            text[at] = "{}[]\",:-+e.09x \x7f"[(state >> 8) % 16];
        if (text.empty()) continue;
        folder_.write("x.json", text);
        const auto texture = read_relief(folder_.path("x.json"));
        if (texture)
            EXPECT_FALSE(refusal(*texture));
        else
            EXPECT_EQ(texture.error().text().find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace relevo::io
