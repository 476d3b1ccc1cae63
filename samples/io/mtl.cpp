#include "samples/io/mtl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "samples/io/file.hpp"
#include "samples/io/words.hpp"

namespace relevo::io {
namespace {

using pipeline::Scalar;

struct Materials {
    std::vector<ObjMaterial> all;
    // Of the last one. Exporters differ in what they mean by Tr, so d decides where both stand.
    std::optional<float> d, tr;
    bool map_d = false;

    void set_transparent() { all.back().transparent = map_d || (d ? *d < 1 : tr && *tr > 0); }
};

// Ka Kd Ks: one number (grey) or three.
FileResult<std::array<Scalar, 3>> read_color(const std::string& file, Words& words, const Word& keyword) {
    std::array<Scalar, 3> color{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Word word = words.in_line();
        if (word.text.empty() && i == 1) return std::array{color[0], color[0], color[0]};
        if (word.text.empty())
            return error_at(file, word,
                            fmt::format("a number is missing: {} needs red, green and blue", keyword.text));
        const auto number = parse_float(word.text);
        if (!number || *number < 0)
            return error_at(file, word,
                            fmt::format("{} is no colour channel, a number from 0 to 1 is accepted",
                                        in_quotes(word.text)));
        color[i] = std::min(Scalar(*number), Scalar(1));
    }
    return color;
}

Scalar mean(const std::array<Scalar, 3>& c) { return ((c[0] + c[1]) + c[2]) / 3; }

void set_color(pipeline::Material& material, std::string_view keyword, const std::array<Scalar, 3>& c) {
    if (keyword == "Ka") material.ambient = mean(c) * Scalar(0.1);
    if (keyword == "Ks") material.specular = mean(c);
    if (keyword != "Kd") return;
    material.diffuse = std::max({c[0], c[1], c[2]});
    const Scalar scale = material.diffuse > 0 ? material.diffuse : Scalar(1);
    material.color = {c[0] / scale, c[1] / scale, c[2] / scale};
}

Failure read_shininess(const std::string& file, Words& words, pipeline::Material& material) {
    const Word word = words.in_line();
    const auto number = parse_float(word.text);
    if (!number || *number < 0)
        return error_at(file, word,
                        fmt::format("{} is no exponent, Ns takes a number from 0 up", in_quotes(word.text)));
    material.shininess = *number;
    return std::nullopt;
}

// d (1 is opaque) and Tr (0 is). Both may stand there: exporters differ in what they mean by Tr, so d
// decides.
Failure read_opacity(const std::string& file, Words& words, const Word& keyword, Materials& materials) {
    const bool is_d = keyword.text == "d";
    Word word = words.in_line();
    if (is_d && word.text == "-halo") word = words.in_line();
    const auto number = parse_float(word.text);
    if (!number || *number < 0 || *number > 1)
        return error_at(file, word,
                        fmt::format("{} is no {}, {} takes a number from 0 to 1", in_quotes(word.text),
                                    is_d ? "opacity" : "transparency", keyword.text));
    (is_d ? materials.d : materials.tr) = number;
    materials.set_transparent();
    return std::nullopt;
}

Failure read_texture(const std::string& file, Words& words, ObjMaterial& material) {
    const Word name = words.rest_of_line();
    if (name.text.empty()) return error_at(file, name, "a file name is missing after map_Kd");
    if (name.text.front() == '-')
        return error_at(file, name, "options of map_Kd are not supported, write only the name of the image");
    material.texture_path = path_beside(file, name.text);
    return std::nullopt;
}

Failure read_statement(const std::string& file, Words& words, Materials& materials) {
    const Word keyword = words.in_line();
    if (keyword.text == "newmtl") {
        const Word name = words.rest_of_line();
        if (name.text.empty()) return error_at(file, name, "a name is missing after newmtl");
        materials.all.push_back({std::string(name.text), {}, ""});
        materials.d = materials.tr = std::nullopt, materials.map_d = false;
        return std::nullopt;
    }
    const bool is_color = keyword.text == "Ka" || keyword.text == "Kd" || keyword.text == "Ks";
    const bool is_opacity = keyword.text == "d" || keyword.text == "Tr" || keyword.text == "map_d";
    if (!is_color && !is_opacity && keyword.text != "Ns" && keyword.text != "map_Kd") return std::nullopt;
    if (materials.all.empty())
        return error_at(file, keyword, fmt::format("{} before the first newmtl", in_quotes(keyword.text)));
    if (keyword.text == "Ns") return read_shininess(file, words, materials.all.back().material);
    if (keyword.text == "map_Kd") return read_texture(file, words, materials.all.back());
    if (keyword.text == "map_d") {
        materials.map_d = true, materials.set_transparent();
        return std::nullopt;
    }
    if (is_opacity) return read_opacity(file, words, keyword, materials);
    const auto color = read_color(file, words, keyword);
    if (!color) return color.error();
    set_color(materials.all.back().material, keyword.text, *color);
    return std::nullopt;
}

}  // namespace

std::string path_beside(const std::string& file, std::string_view name) {
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    return (std::filesystem::path(file).parent_path() / slashed).lexically_normal().string();
}

FileResult<std::vector<ObjMaterial>> read_mtl(const std::string& path) {
    const auto text = read_text(path);
    if (!text) return text.error();
    Materials materials;
    Words words(*text);
    do {
        if (const Failure failure = read_statement(path, words, materials)) return *failure;
    } while (words.next_line());
    return std::move(materials.all);
}

}  // namespace relevo::io
