#include "samples/io/picture.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <string_view>
#include <utility>

#include "raster/texture.hpp"
#include "samples/io/file.hpp"
#include "samples/io/oiio_module.hpp"
#include "samples/io/png_check.hpp"

namespace relevo::io {
namespace {

using pipeline::Scalar;
using raster::max_texture_size;

constexpr std::size_t max_image_file = std::size_t(1) << 30;

// ---- the module ----

// The module lies in lib/relevo/ in one of the folders above the program: in the build tree as when
// installed. It stays open: opening it again costs nothing.
pipeline::Result<void*> open_module() {
    std::error_code error;
    std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    for (int levels = 0; levels < 6 && !folder.empty(); ++levels, folder = folder.parent_path()) {
        const std::filesystem::path file = folder / module_file;
        if (!std::filesystem::exists(file, error)) continue;
        if (void* const module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return module;
        return pipeline::Error{fmt::format("the module for image files cannot be opened: {}", ::dlerror())};
    }
    return pipeline::Error{
        fmt::format("the module for image files, {}, is in no folder above the program", module_file)};
}

template <class Function>
pipeline::Result<Function*> module_function(const char* name) {
    const auto module = open_module();
    if (!module) return module.error();
    if (void* const found = ::dlsym(*module, name)) return reinterpret_cast<Function*>(found);
    return pipeline::Error{fmt::format("the module for image files has no function {}", name)};
}

// ---- reading ----

std::string wrong_size(std::int64_t width, std::int64_t height) {
    if (width >= 1 && height >= 1 && width <= max_texture_size && height <= max_texture_size) return "";
    return fmt::format("the image has {} x {} pixels, accepted are 1 to {} a side", width, height,
                       max_texture_size);
}

// Checks that need no decoder, with better messages than a decoder's.
Failure check_file(const std::string& path) {
    const auto bytes = read_file(path, max_image_file);
    if (!bytes) return bytes.error();
    if (bytes->empty()) return error_in(path, "the file is empty");
    if (!bytes->starts_with(png_signature)) return std::nullopt;
    PngSize size;
    std::string damage = png_damage(*bytes, size);
    if (damage.empty()) damage = wrong_size(size.width, size.height);
    return damage.empty() ? Failure() : error_in(path, damage);
}

struct Target {
    const PixelShape* needed;  // or null
    Pixels pixels;
    std::string refusal;
};

std::string wrong_shape(const ImageShape& shape, const PixelShape* needed) {
    if (std::string wrong = wrong_size(shape.width, shape.height); !wrong.empty()) return wrong;
    if (shape.channels < 1 || shape.channels > 4)
        return fmt::format("the image has {} channels, accepted are 1 to 4", shape.channels);
    if (!needed || (shape.width == needed->width && shape.height == needed->height &&
                    shape.channels == needed->channels))
        return "";
    return fmt::format("the image has {} x {} pixels of {} channels, needed are {} x {} of {}", shape.width,
                       shape.height, shape.channels, needed->width, needed->height, needed->channels);
}

void* allocate(void* user, const ImageShape* shape) {
    Target& target = *static_cast<Target*>(user);
    target.refusal = wrong_shape(*shape, target.needed);
    if (!target.refusal.empty()) return nullptr;
    Pixels& pixels = target.pixels;
    pixels.width = shape->width, pixels.height = shape->height, pixels.channels = shape->channels;
    if (shape->kind == NumberKind::Uint8) pixels.samples = std::vector<std::uint8_t>();
    if (shape->kind == NumberKind::Uint16) pixels.samples = std::vector<std::uint16_t>();
    if (shape->kind == NumberKind::Float) pixels.samples = std::vector<float>();
    const auto take = [&](auto& samples) -> void* {
        samples.resize(std::size_t(shape->width) * std::size_t(shape->height) * std::size_t(shape->channels));
        return samples.data();
    };
    try {
        return std::visit(take, pixels.samples);
    } catch (const std::bad_alloc&) {
        target.refusal = "the image does not fit into memory";
        return nullptr;
    }
}

std::uint8_t to_8_bits(std::uint8_t number, bool) { return number; }
std::uint8_t to_8_bits(std::uint16_t number, bool) {
    return static_cast<std::uint8_t>((std::uint32_t(number) * 255 + 32767) / 65535);
}
std::uint8_t to_8_bits(float number, bool is_alpha) {
    return is_alpha ? raster::to_raw8(number) : raster::to_srgb8(number);
}

template <class Number>
std::vector<std::uint8_t> to_8_bits(const std::vector<Number>& samples, std::size_t channels) {
    const std::size_t colors = channels < 3 ? 1 : 3, out_channels = channels % 2 == 0 ? 4 : 3;
    std::vector<std::uint8_t> out(samples.size() / channels * out_channels);
    for (std::size_t in = 0, to = 0; in < samples.size(); in += channels, to += out_channels) {
        for (std::size_t c = 0; c < 3; ++c)
            out[to + c] = to_8_bits(samples[in + std::min(c, colors - 1)], false);
        if (out_channels == 4) out[to + 3] = to_8_bits(samples[in + colors], true);
    }
    return out;
}

// The numbers as float; `copy` holds them when the library computes in double.
template <class Numbers>
const float* float_rows(const Numbers& numbers, std::vector<float>& copy) {
    if constexpr (std::is_same_v<typename Numbers::value_type, float>) {
        return numbers.data();
    } else {
        copy.assign(numbers.begin(), numbers.end());
        return copy.data();
    }
}

FileResult<Pixels> read_shape(const std::string& path, const PixelShape* needed) {
    if (const Failure failure = check_file(path)) return *failure;
    const auto read = module_function<ReadImageFunction>(read_image_name);
    if (!read) return error_in(path, "cannot be read: " + read.error().message);
    Target target{needed, {}, {}};
    char message[256] = "";
    if ((*read)(path.c_str(), allocate, &target, message, sizeof message) == 0)
        return std::move(target.pixels);
    if (!target.refusal.empty()) return error_in(path, target.refusal);
    return error_in(path, fmt::format("cannot be read as an image: {}", message));
}

FileResult<std::string> encode(const std::string& path, const ImageShape& shape, const void* rows) {
    const auto encode_image = module_function<EncodeImageFunction>(encode_image_name);
    if (!encode_image) return error_in(path, "cannot be written: " + encode_image.error().message);
    std::string file;
    const TakeBytes take = [](void* user, const void* bytes, std::size_t size) {
        static_cast<std::string*>(user)->assign(static_cast<const char*>(bytes), size);
    };
    char message[256] = "";
    if ((*encode_image)(&shape, rows, take, &file, message, sizeof message) == 0) return file;
    return error_in(path, fmt::format("cannot be written: {}", message));
}

}  // namespace

FileResult<Pixels> read_pixels(const std::string& path) { return read_shape(path, nullptr); }
FileResult<Pixels> read_pixels(const std::string& path, const PixelShape& needed) {
    return read_shape(path, &needed);
}

FileResult<Picture> read_picture(const std::string& path) {
    auto pixels = read_pixels(path);
    if (!pixels) return pixels.error();
    const auto channels = static_cast<std::size_t>(pixels->channels);
    Picture picture{pixels->width, pixels->height, channels % 2 == 0 ? 4 : 3, {}};
    if (auto* const bytes = std::get_if<std::vector<std::uint8_t>>(&pixels->samples); bytes && channels >= 3)
        picture.pixels = std::move(*bytes);
    else
        picture.pixels =
            std::visit([&](const auto& samples) { return to_8_bits(samples, channels); }, pixels->samples);
    return picture;
}

FileResult<raster::Image<raster::Rgba8>> read_image(const std::string& path) {
    const auto picture = read_picture(path);
    if (!picture) return picture.error();
    raster::Image<raster::Rgba8> image(picture->width, picture->height);
    const auto channels = static_cast<std::size_t>(picture->channels);
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const std::uint8_t* const p = picture->pixels.data() + i * channels;
        image.pixels()[i] = {p[0], p[1], p[2], channels == 4 ? p[3] : std::uint8_t(255)};
    }
    return image;
}

FileResult<raster::Image<float>> read_exr(const std::string& path) {
    const auto pixels = read_pixels(path);
    if (!pixels) return pixels.error();
    const auto* const samples = std::get_if<std::vector<float>>(&pixels->samples);
    if (samples == nullptr) return error_in(path, "holds integers, an image of float numbers is needed");
    raster::Image<float> image(pixels->width, pixels->height);
    for (std::size_t i = 0; i < image.pixels().size(); ++i)
        image.pixels()[i] = (*samples)[i * static_cast<std::size_t>(pixels->channels)];
    return image;
}

FileResult<std::string> image_bytes(const std::string& path, const Pixels& pixels) {
    const NumberKind kinds[] = {NumberKind::Uint8, NumberKind::Uint16, NumberKind::Float};
    const ImageShape shape{pixels.width, pixels.height, pixels.channels, kinds[pixels.samples.index()]};
    return encode(
        path, shape,
        std::visit([](const auto& samples) -> const void* { return samples.data(); }, pixels.samples));
}

Failure write_exr(const std::string& path, const raster::Image<Scalar>& image) {
    if (image.empty()) return error_in(path, "cannot be written: the image has no pixels");
    std::vector<float> copy;
    const auto bytes =
        encode(path, {image.width(), image.height(), 1, NumberKind::Float}, float_rows(image.pixels(), copy));
    return bytes ? write_file(path, *bytes) : bytes.error();
}

}  // namespace relevo::io
