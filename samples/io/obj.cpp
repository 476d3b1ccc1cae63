#include "samples/io/obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "samples/io/corners.hpp"
#include "samples/io/file.hpp"
#include "samples/io/mtl.hpp"
#include "samples/io/polygon.hpp"
#include "samples/io/suggest.hpp"
#include "samples/io/words.hpp"

namespace relevo::io {
namespace {

using pipeline::Scalar;
using pipeline::Vec2;
using pipeline::Vec3;

constexpr std::string_view drawn_statements[] = {"v", "vt", "vn", "f", "o", "g", "usemtl", "mtllib"};
constexpr std::string_view skipped_statements[] = {
    "l",     "p",     "s",        "mg",       "vp",   "cstype", "deg",    "bmat",       "step",
    "curv",  "curv2", "surf",     "parm",     "trim", "hole",   "scrv",   "sp",         "end",
    "con",   "bevel", "c_interp", "d_interp", "lod",  "usemap", "maplib", "shadow_obj", "trace_obj",
    "ctech", "stech", "call",     "csh",      "res",  "bsp",    "bzp",    "cdc",        "cdp"};

bool is_one_of(std::string_view word, std::span<const std::string_view> list) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

// ---- first walk: the lists of numbers ----

struct Lists {
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> uvs;
};

// Reads at least `count` numbers; more of them (weights, colours of vertices) are checked and dropped.
Failure read_numbers(const std::string& file, Words& words, std::string_view keyword, std::span<float> out) {
    std::size_t count = 0;
    for (Word word = words.in_line(); !word.text.empty(); word = words.in_line(), ++count) {
        const auto number = parse_float(word.text);
        if (!number)
            return error_at(file, word, fmt::format("{} is no finite float32 number", in_quotes(word.text)));
        if (count < out.size()) out[count] = *number;
    }
    if (count >= out.size()) return std::nullopt;
    return error_at(
        file, words.in_line(),
        fmt::format("a coordinate is missing: {} needs {} numbers, here are {}", keyword, out.size(), count));
}

Failure read_list_entry(const std::string& file, Words& words, std::string_view keyword, Lists& lists) {
    std::array<float, 3> n{};
    const std::size_t count = keyword == "vt" ? 2 : 3;
    if (const Failure failure = read_numbers(file, words, keyword, std::span(n).first(count))) return failure;
    if (keyword == "v") lists.positions.emplace_back(n[0], n[1], n[2]);
    if (keyword == "vn") lists.normals.emplace_back(n[0], n[1], n[2]);
    if (keyword == "vt") lists.uvs.emplace_back(n[0], n[1]);
    return std::nullopt;
}

bool is_list(std::string_view keyword) { return keyword == "v" || keyword == "vt" || keyword == "vn"; }

FileResult<Lists> read_lists(const std::string& file, std::string_view text) {
    Lists lists;
    Words words(text);
    do {
        const Word keyword = words.in_line();
        if (!is_list(keyword.text)) continue;
        if (const Failure failure = read_list_entry(file, words, keyword.text, lists)) return *failure;
    } while (words.next_line());
    return lists;
}

// ---- second walk: the faces ----

// A part that is being read. Its vertices are made at the end, from the corners.
struct OpenPart {
    std::string name, material;
    Word first_use;  // of the material's name, for the message when there is no such material
    Corners corners;
    std::vector<std::uint32_t> indices;
};

struct Reading {
    const std::string& file;
    const Lists& lists;
    Words words;
    std::array<std::int64_t, 3> seen{};  // v, vt and vn statements so far: what negative indices count from

    std::string object{}, group{};
    Word material{};
    bool has_library = false;
    std::vector<ObjMaterial> materials{};

    std::vector<OpenPart> parts{};
    std::map<std::pair<std::string, std::string>, std::size_t> part_of{};  // by name and material
    std::size_t part = 0;                                                  // the one that faces go to ...
    bool part_is_known = false;  // ... unless a name or a material has changed

    std::vector<Corner> face{};  // of the face being read: kept to spare memory requests
    std::vector<std::uint32_t> polygon{};
    std::vector<glm::dvec3> area_vectors{};  // by position, summed over its faces without normals
};

// The index at `text`, 0-based; `kind` is 0 for vertices, 1 for texture coordinates, 2 for normals.
FileResult<std::int32_t> read_index(const Reading& reading, const Word& word, std::string_view text,
                                    std::size_t kind) {
    static constexpr std::string_view one[] = {"vertex", "texture coordinate", "normal"};
    static constexpr std::string_view many[] = {"vertices (v)", "texture coordinates (vt)", "normals (vn)"};
    const auto offset = static_cast<std::size_t>(text.data() - word.text.data());
    const auto wrong = [&](std::string message) {
        return error_at(reading.file, word, std::move(message), offset);
    };
    const auto index = parse_integer(text);
    if (!index)
        return wrong(
            fmt::format("{} is no corner, accepted are v, v/t, v//n and v/t/n", in_quotes(word.text)));
    if (*index == 0)
        return wrong(fmt::format("{} index 0: indices count from 1, or back from -1", one[kind]));
    const std::size_t sizes[] = {reading.lists.positions.size(), reading.lists.uvs.size(),
                                 reading.lists.normals.size()};
    const auto size = static_cast<std::int64_t>(sizes[kind]);
    // Compared before it is added: the sum of two large negative numbers would not fit.
    const bool inside = *index > 0 ? *index <= size : *index >= -reading.seen[kind];
    if (!inside && *index < 0)
        return wrong(fmt::format("{} index {} is outside its list: {} {} come before this line", one[kind],
                                 *index, reading.seen[kind], many[kind]));
    if (!inside)
        return wrong(fmt::format("{} index {} is outside its list: the file has {} {}", one[kind], *index,
                                 size, many[kind]));
    return static_cast<std::int32_t>(*index > 0 ? *index - 1 : reading.seen[kind] + *index);
}

// v, v/t, v//n or v/t/n.
FileResult<Corner> read_corner(const Reading& reading, const Word& word) {
    const std::size_t slash = word.text.find('/');
    const auto position = read_index(reading, word, word.text.substr(0, slash), 0);
    if (!position) return position.error();
    Corner corner{*position};
    if (slash == std::string_view::npos) return corner;

    const std::string_view rest = word.text.substr(slash + 1);
    const std::size_t second = rest.find('/');
    if (second != 0) {
        const auto uv = read_index(reading, word, rest.substr(0, second), 1);
        if (!uv) return uv.error();
        corner.uv = *uv;
    }
    if (second == std::string_view::npos) return corner;
    const auto normal = read_index(reading, word, rest.substr(second + 1), 2);
    if (!normal) return normal.error();
    corner.normal = *normal;
    return corner;
}

OpenPart& current_part(Reading& reading) {
    if (reading.part_is_known) return reading.parts[reading.part];
    const bool both = !reading.object.empty() && !reading.group.empty();
    const std::string name = reading.object + (both ? " " : "") + reading.group;
    const std::string material(reading.material.text);
    const auto [entry, is_new] = reading.part_of.try_emplace({name, material}, reading.parts.size());
    if (is_new) reading.parts.push_back({name, material, reading.material, {}, {}});
    reading.part = entry->second;
    reading.part_is_known = true;
    return reading.parts[reading.part];
}

// What the face gives to the normals of those of its corners that have none.
void add_area_vector(Reading& reading) {
    const auto lacks_normal = [](const Corner& corner) { return corner.normal < 0; };
    if (std::none_of(reading.face.begin(), reading.face.end(), lacks_normal)) return;
    reading.area_vectors.resize(reading.lists.positions.size(), glm::dvec3(0));
    const auto position = [&](std::size_t i) {
        return glm::dvec3(reading.lists.positions[static_cast<std::size_t>(reading.face[i].position)]);
    };
    const glm::dvec3 area = area_vector(reading.face.size(), position);
    for (const Corner& corner : reading.face)
        if (lacks_normal(corner)) reading.area_vectors[static_cast<std::size_t>(corner.position)] += area;
}

Failure read_face(Reading& reading) {
    reading.face.clear();
    Word word = reading.words.in_line();
    for (; !word.text.empty(); word = reading.words.in_line()) {
        const auto corner = read_corner(reading, word);
        if (!corner) return corner.error();
        reading.face.push_back(*corner);
    }
    if (reading.face.size() < 3)
        return error_at(reading.file, word,
                        fmt::format("a face needs at least 3 corners, here are {}", reading.face.size()));
    OpenPart& part = current_part(reading);
    reading.polygon.clear();
    for (const Corner& corner : reading.face) reading.polygon.push_back(part.corners.number(corner));
    append_fan(reading.polygon, part.indices);
    add_area_vector(reading);
    return std::nullopt;
}

// One file; its name may contain blanks.
Failure read_library(Reading& reading) {
    const Word all = reading.words.rest_of_line();
    if (all.text.empty()) return error_at(reading.file, all, "a file name is missing after mtllib");
    reading.has_library = true;
    auto materials = read_mtl(path_beside(reading.file, all.text));
    if (!materials && materials.error().place.line == 0)
        return error_at(reading.file, all, "the material file " + materials.error().text());
    if (!materials) return materials.error();
    reading.materials.insert(reading.materials.end(), materials->begin(), materials->end());
    return std::nullopt;
}

Failure read_name(Reading& reading, std::string_view keyword) {
    const Word name = reading.words.rest_of_line();
    if (keyword == "usemtl" && name.text.empty())
        return error_at(reading.file, name, "a name is missing after usemtl");
    if (keyword == "usemtl") reading.material = name;
    if (keyword == "o") reading.object = name.text, reading.group.clear();
    if (keyword == "g") reading.group = name.text;
    reading.part_is_known = false;
    return std::nullopt;
}

Failure refuse_statement(const Reading& reading, const Word& keyword) {
    return error_at(reading.file, keyword,
                    fmt::format("{} is no statement of OBJ{}", in_quotes(keyword.text),
                                suggestion(keyword.text, drawn_statements)));
}

Failure read_statement(Reading& reading) {
    const Word keyword = reading.words.in_line();
    const std::string_view text = keyword.text;
    if (text.empty()) return std::nullopt;
    if (text == "v") return ++reading.seen[0], std::nullopt;
    if (text == "vt") return ++reading.seen[1], std::nullopt;
    if (text == "vn") return ++reading.seen[2], std::nullopt;
    if (text == "f") return read_face(reading);
    if (text == "o" || text == "g" || text == "usemtl") return read_name(reading, text);
    if (text == "mtllib") return read_library(reading);
    return is_one_of(text, skipped_statements) ? std::nullopt : refuse_statement(reading, keyword);
}

// ---- at the end: materials and vertices ----

FileResult<std::optional<ObjMaterial>> find_material(const Reading& reading, const OpenPart& part) {
    // Without a material file the names only tell parts apart.
    if (part.material.empty() || !reading.has_library) return std::optional<ObjMaterial>();
    std::vector<std::string_view> known;
    for (const ObjMaterial& material : reading.materials) {
        if (material.name == part.material) return std::optional(material);
        known.push_back(material.name);
    }
    return error_at(reading.file, part.first_use,
                    fmt::format("there is no material {} in the material file{}", in_quotes(part.material),
                                suggestion(part.material, known)));
}

void make_vertices(const Reading& reading, const Corners& corners, ObjPart& part) {
    part.had_normals = part.had_uv = true;
    part.mesh.vertices.reserve(corners.list().size());
    for (const Corner& corner : corners.list()) {
        const auto position = static_cast<std::size_t>(corner.position);
        pipeline::Vertex vertex{{reading.lists.positions[position]}, {Vec3(0)}, Vec2(0)};
        if (corner.uv >= 0) vertex.uv = reading.lists.uvs[static_cast<std::size_t>(corner.uv)];
        vertex.normal.v = corner.normal < 0 ? unit(reading.area_vectors[position])
                                            : reading.lists.normals[static_cast<std::size_t>(corner.normal)];
        part.had_uv = part.had_uv && corner.uv >= 0;
        part.had_normals = part.had_normals && corner.normal >= 0;
        part.mesh.vertices.push_back(vertex);
    }
}

FileResult<std::vector<ObjPart>> finished(Reading& reading) {
    std::vector<ObjPart> parts;
    parts.reserve(reading.parts.size());
    for (OpenPart& open : reading.parts) {
        auto material = find_material(reading, open);
        if (!material) return material.error();
        ObjPart part{std::move(open.name), {}, *std::move(material)};
        const Corners corners = std::move(open.corners);  // gone at the end of this turn
        part.mesh.indices = std::move(open.indices);
        part.mesh.indices.shrink_to_fit();
        make_vertices(reading, corners, part);
        parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace

FileResult<std::vector<ObjPart>> read_obj(const std::string& path) {
    const auto text = read_text(path);
    return text ? parse_obj(*text, path) : text.error();
}

FileResult<std::vector<ObjPart>> parse_obj(std::string_view text, const std::string& path) {
    const auto lists = read_lists(path, text);
    if (!lists) return lists.error();
    Reading reading{path, *lists, Words(text)};
    do {
        if (const Failure failure = read_statement(reading)) return *failure;
    } while (reading.words.next_line());
    if (reading.parts.empty()) return error_in(path, "no faces: a mesh needs at least one line 'f v v v'");
    return finished(reading);
}

}  // namespace relevo::io
