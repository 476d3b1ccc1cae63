#include "samples/io/relief_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <variant>

#include "raster/output.hpp"
#include "relief/quantize.hpp"
#include "samples/io/file.hpp"
#include "samples/io/json_fields.hpp"
#include "samples/io/mtl.hpp"
#include "samples/io/picture.hpp"

namespace relevo::io {
namespace {

using pipeline::LinearRgb;
using pipeline::Scalar;
using pipeline::Vec3;
using raster::Image;
using relief::ReliefTexture;

constexpr int version = 1;
constexpr std::string_view kinds_of_numbers[] = {"float", "16 bits", "8 bits"};
constexpr std::string_view projections[] = {"orthographic", "perspective"};

// ---- one number ----

std::uint16_t color_code(Scalar light, std::uint16_t) {
    const double clamped = std::isnan(light) ? 0 : std::clamp(double{light}, 0.0, 1.0);
    return static_cast<std::uint16_t>(clamped * 65535 + 0.5);
}
std::uint8_t color_code(Scalar light, std::uint8_t) { return raster::to_srgb8(light); }
float color_code(Scalar light, float) { return static_cast<float>(light); }
Scalar light_of(std::uint16_t code) { return static_cast<Scalar>(code / 65535.0); }
Scalar light_of(std::uint8_t code) { return static_cast<Scalar>(raster::srgb_decoded[code] / 65535.0); }
Scalar light_of(float light) { return light; }

// 0, 1 and -1 are exact.
template <class Number>
constexpr int one = std::is_same_v<Number, std::uint8_t> ? 127 : 32767;
template <class Number>
Number normal_code(Scalar n) {
    if constexpr (std::is_same_v<Number, float>)
        return static_cast<float>(n);
    else
        return static_cast<Number>(one<Number> + 1 +
                                   std::floor(std::clamp(double{n}, -1.0, 1.0) * one<Number> + 0.5));
}
template <class Number>
Vec3 normal_of(const Number* code) {
    if constexpr (std::is_same_v<Number, float>) {
        return {code[0], code[1], code[2]};
    } else {
        glm::dvec3 n;
        for (int k = 0; k < 3; ++k) n[k] = (double(code[k]) - (one<Number> + 1)) / one<Number>;
        const double length = std::sqrt(glm::dot(n, n));
        return length > 0 ? Vec3(n / length) : Vec3(0);
    }
}

// What relief::refusal does not look at.
const char* wrong_texel(const LinearRgb& color, const Vec3& normal) {
    if (!std::isfinite(color.r) || !std::isfinite(color.g) || !std::isfinite(color.b))
        return "its colour is not finite";
    if (!std::isfinite(normal.x) || !std::isfinite(normal.y) || !std::isfinite(normal.z))
        return "its normal is not finite";
    return nullptr;
}
Failure not_finite(const ReliefTexture& texture, const std::string& color_file,
                   const std::string& normal_file) {
    for (int y = 0; y < texture.camera.height; ++y)
        for (int x = 0; x < texture.camera.width; ++x) {
            if (!texture.coverage.at(x, y)) continue;
            const char* const color = wrong_texel(texture.color.at(x, y), Vec3(0));
            const char* const wrong = color ? color : wrong_texel({}, texture.normal.at(x, y));
            if (wrong)
                return error_in(color ? color_file : normal_file,
                                fmt::format("texel ({}, {}): {}", x, y, wrong));
        }
    return std::nullopt;
}

// ---- writing ----

template <class Number>
Pixels picture_of(const ReliefTexture& texture, int channels) {
    Pixels pixels{texture.camera.width, texture.camera.height, channels, std::vector<Number>()};
    std::get<std::vector<Number>>(pixels.samples)
        .reserve(texture.color.pixels().size() * std::size_t(channels));
    return pixels;
}
template <class Number>
std::vector<Number>& samples(Pixels& pixels) {
    return std::get<std::vector<Number>>(pixels.samples);
}

template <class Number>
Pixels color_picture(const ReliefTexture& texture) {
    Pixels pixels = picture_of<Number>(texture, 3);
    for (std::size_t i = 0; i < texture.color.pixels().size(); ++i) {
        const LinearRgb c = texture.coverage.pixels()[i] ? texture.color.pixels()[i] : LinearRgb{};
        for (const Scalar light : {c.r, c.g, c.b})
            samples<Number>(pixels).push_back(color_code(light, Number{}));
    }
    return pixels;
}
template <class Number>
Pixels normal_picture(const ReliefTexture& texture) {
    Pixels pixels = picture_of<Number>(texture, 3);
    for (std::size_t i = 0; i < texture.normal.pixels().size(); ++i) {
        const Vec3 n = texture.coverage.pixels()[i] ? texture.normal.pixels()[i] : Vec3(0);
        for (int k = 0; k < 3; ++k) samples<Number>(pixels).push_back(normal_code<Number>(n[k]));
    }
    return pixels;
}

struct Encoded {
    std::vector<FileToWrite> files;
    nlohmann::ordered_json fields;
};

template <class Number>
Failure encode(const std::string& path, const ReliefTexture& texture, Encoded& encoded) {
    const std::string beside = path.substr(0, path.size() - std::string_view(".json").size());
    Failure failure;
    const auto add = [&](const std::string& name, const Pixels& pixels) {
        const bool is_float = std::holds_alternative<std::vector<float>>(pixels.samples);
        const std::string file = fmt::format("{}-{}.{}", beside, name, is_float ? "exr" : "png");
        encoded.fields[name] = std::filesystem::path(file).filename().string();
        auto bytes = failure ? FileResult<std::string>(*failure) : image_bytes(file, pixels);
        if (!bytes)
            failure = bytes.error();
        else
            encoded.files.push_back({file, *std::move(bytes)});
    };
    add("color", color_picture<Number>(texture));
    add("normal", normal_picture<Number>(texture));
    if constexpr (std::is_same_v<Number, float>) {
        Pixels depth = picture_of<float>(texture, 1), coverage = picture_of<std::uint8_t>(texture, 1);
        for (std::size_t i = 0; i < texture.depth.pixels().size(); ++i) {
            const bool covered = texture.coverage.pixels()[i] != 0;
            samples<float>(depth).push_back(covered ? static_cast<float>(texture.depth.pixels()[i]) : 0);
            samples<std::uint8_t>(coverage).push_back(covered ? 255 : 0);
        }
        add("depth", depth), add("coverage", coverage);
    } else {
        const auto codes = relief::quantize<Number>(texture);
        Pixels depth = picture_of<Number>(texture, 1);
        samples<Number>(depth).assign(codes.code.pixels().begin(), codes.code.pixels().end());
        add("depth", depth);
        encoded.fields["depth_low"] = double{codes.range.low};
        encoded.fields["depth_high"] = double{codes.range.high};
    }
    return failure;
}

nlohmann::ordered_json to_json(const relief::ReliefCamera& camera) {
    const auto vector = [](const glm::dvec3& v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
    const bool perspective = camera.projection == relief::Projection::Perspective;
    nlohmann::ordered_json json{{"projection", projections[perspective]},
                                {"corner", vector(camera.corner)},
                                {"a", vector(camera.a)},
                                {"b", vector(camera.b)}};
    if (perspective) json["eye"] = vector(camera.eye);
    json["width"] = camera.width, json["height"] = camera.height;
    return json;
}

// ---- reading ----

// The picture that a field names, of one kind of numbers.
template <class Number>
FileResult<std::vector<Number>> read_samples(const std::string& file, const relief::ReliefCamera& camera,
                                             int channels) {
    auto pixels = read_pixels(file, {camera.width, camera.height, channels});
    if (!pixels) return pixels.error();
    if (auto* const numbers = std::get_if<std::vector<Number>>(&pixels->samples)) return std::move(*numbers);
    constexpr std::string_view held[] = {"8-bit", "16-bit", "float"};
    const std::size_t needed = std::is_same_v<Number, float> ? 2 : sizeof(Number) - 1;
    return error_in(file, fmt::format("holds {} numbers, {} ones are needed", held[pixels->samples.index()],
                                      held[needed]));
}

struct Description {
    std::string file;  // of the description
    relief::ReliefCamera camera;
    std::string color, normal, depth, coverage;  // files
    relief::DepthRange range;
};

template <class Number>
FileResult<ReliefTexture> read_pictures(const Description& from) {
    const relief::ReliefCamera& camera = from.camera;
    const auto color = read_samples<Number>(from.color, camera, 3);
    if (!color) return color.error();
    const auto normal = read_samples<Number>(from.normal, camera, 3);
    if (!normal) return normal.error();
    const auto depth = read_samples<Number>(from.depth, camera, 1);
    if (!depth) return depth.error();
    ReliefTexture texture = make_relief_texture(camera);
    auto& covered = texture.coverage.pixels();
    if constexpr (std::is_same_v<Number, float>) {
        const auto coverage = read_samples<std::uint8_t>(from.coverage, camera, 1);
        if (!coverage) return coverage.error();
        for (std::size_t i = 0; i < covered.size(); ++i) {
            covered[i] = (*coverage)[i] != 0;
            if (covered[i]) texture.depth.pixels()[i] = (*depth)[i];
        }
    } else {
        const relief::QuantizedDepth<Number> codes{from.range, {}};
        for (std::size_t i = 0; i < covered.size(); ++i) {
            covered[i] = (*depth)[i] != codes.empty;
            if (covered[i]) texture.depth.pixels()[i] = value(codes, (*depth)[i]);
        }
    }
    for (std::size_t i = 0; i < covered.size(); ++i) {
        if (!covered[i]) continue;
        const Number* const c = &(*color)[3 * i];
        texture.color.pixels()[i] = {light_of(c[0]), light_of(c[1]), light_of(c[2])};
        texture.normal.pixels()[i] = normal_of(&(*normal)[3 * i]);
    }
    if (const auto refused = refusal(texture)) return error_in(from.depth, refused->message);
    if (const Failure failure = not_finite(texture, from.color, from.normal)) return *failure;
    return texture;
}

relief::ReliefCamera read_camera(JsonFields& json) {
    relief::ReliefCamera camera;
    json.no_others({"camera"}, {"projection", "corner", "a", "b", "eye", "width", "height"});
    const bool perspective = json.choice({"camera", "projection"}, {projections[0], projections[1]}) == 1;
    camera.projection = perspective ? relief::Projection::Perspective : relief::Projection::Orthographic;
    camera.corner = json.vector({"camera", "corner"});
    camera.a = json.vector({"camera", "a"}), camera.b = json.vector({"camera", "b"});
    if (perspective) camera.eye = json.vector({"camera", "eye"});
    if (!perspective && json.has({"camera", "eye"}))
        json.refuse({"camera", "eye"}, "only a perspective camera has one");
    camera.width = json.integer({"camera", "width"}), camera.height = json.integer({"camera", "height"});
    if (const auto refused = json.failure() ? std::nullopt : refusal(camera))
        json.refuse({"camera"}, refused->message);
    return camera;
}

FileError cannot_write(const std::string& path, const std::string& why) {
    return error_in(path, "cannot be written: " + why);
}

}  // namespace

Failure refused_relief_name(const std::string& path) {
    if (path.ends_with(".json")) return {};
    return cannot_write(path, "the name of a relief texture ends in .json");
}

Failure write_relief(const std::string& path, const ReliefTexture& texture, ReliefNumbers numbers) {
    if (const Failure failure = refused_relief_name(path)) return failure;
    if (const auto refused = refusal(texture)) return cannot_write(path, refused->message);
    if (const Failure failure = not_finite(texture, path, path)) return cannot_write(path, failure->message);
    Encoded encoded;
    encoded.fields = {{"relief_texture", version},
                      {"camera", to_json(texture.camera)},
                      {"numbers", kinds_of_numbers[static_cast<std::size_t>(numbers)]}};
    const Failure failure = numbers == ReliefNumbers::Float    ? encode<float>(path, texture, encoded)
                            : numbers == ReliefNumbers::Bits16 ? encode<std::uint16_t>(path, texture, encoded)
                                                               : encode<std::uint8_t>(path, texture, encoded);
    if (failure) return failure;
    encoded.files.push_back(
        {path, encoded.fields.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"});
    return write_files(encoded.files);
}

FileResult<ReliefTexture> read_relief(const std::string& path) {
    JsonFields json(path);
    json.no_others({}, {"relief_texture", "camera", "numbers", "color", "normal", "depth", "coverage",
                        "depth_low", "depth_high"});
    if (const int found = json.integer({"relief_texture"}); found != version)
        json.refuse({"relief_texture"},
                    fmt::format("version {} is not known, {} is accepted", found, version));
    const auto numbers = static_cast<ReliefNumbers>(
        json.choice({"numbers"}, {kinds_of_numbers[0], kinds_of_numbers[1], kinds_of_numbers[2]}));
    const auto file = [&](const char* field) { return path_beside(path, json.text({field})); };
    Description from{path, read_camera(json), file("color"), file("normal"), file("depth"), "", {}};
    if (numbers == ReliefNumbers::Float) {
        from.coverage = file("coverage");
        for (const char* const field : {"depth_low", "depth_high"})
            if (json.has({field})) json.refuse({field}, "only 16 and 8 bits need one");
    } else {
        if (json.has({"coverage"})) json.refuse({"coverage"}, "only float numbers need one");
        const double low = json.number({"depth_low"}), high = json.number({"depth_high"});
        from.range = {static_cast<Scalar>(low), static_cast<Scalar>(high), false};
        if (!(low <= high && std::isfinite(from.range.low) && std::isfinite(from.range.high)))
            json.refuse({"depth_high"}, "a number from depth_low up is needed");
    }
    if (json.failure()) return *json.failure();
    if (numbers == ReliefNumbers::Float) return read_pictures<float>(from);
    return numbers == ReliefNumbers::Bits16 ? read_pictures<std::uint16_t>(from)
                                            : read_pictures<std::uint8_t>(from);
}

}  // namespace relevo::io
