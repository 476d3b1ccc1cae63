#include "samples/io/solid.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <map>
#include <span>

#include "samples/io/corners.hpp"
#include "samples/io/file.hpp"
#include "samples/io/polygon.hpp"
#include "samples/io/suggest.hpp"
#include "samples/io/words.hpp"

namespace relevo::io {
namespace {

using pipeline::Scalar;
using pipeline::Vec2;
using pipeline::Vec3;

struct Reading {
    const std::string& file;
    Words words;
};

// A list's size, checked against the bytes that its elements need at least: no file can claim more memory
// than a few times its own size.
FileResult<std::size_t> read_count(Reading& reading, const Word& word, std::string_view things,
                                   std::size_t least_bytes) {
    const auto wrong = [&](std::string message) { return error_at(reading.file, word, std::move(message)); };
    const auto count = parse_integer(word.text);
    if (!count || *count < 0)
        return wrong(fmt::format("{} is no number of {}, an integer from 0 up is accepted",
                                 in_quotes(word.text), things));
    const std::size_t remaining = reading.words.remaining();
    // The last element may end without a blank.
    if (static_cast<std::uint64_t>(*count) > (remaining + 1) / least_bytes)
        return wrong(
            fmt::format("{} {} cannot be in the remaining {} bytes of the file", *count, things, remaining));
    return static_cast<std::size_t>(*count);
}

FileResult<float> read_number(Reading& reading) {
    const Word word = reading.words.anywhere();
    if (word.text.empty()) return error_at(reading.file, word, "the file ends where a coordinate is needed");
    const auto number = parse_float(word.text);
    if (!number)
        return error_at(reading.file, word,
                        fmt::format("{} is no finite float32 number", in_quotes(word.text)));
    return *number;
}

// `count` vectors of `Dimensions` coordinates.
template <int Dimensions>
FileResult<std::vector<glm::vec<Dimensions, Scalar>>> read_vectors(Reading& reading, std::size_t count) {
    std::vector<glm::vec<Dimensions, Scalar>> out(count);
    for (auto& vector : out) {
        for (int i = 0; i < Dimensions; ++i) {
            const auto number = read_number(reading);
            if (!number) return number.error();
            vector[i] = *number;
        }
    }
    return out;
}

// The index at `word` into a list of `size` elements.
FileResult<std::int32_t> index_of(const Reading& reading, const Word& word, std::string_view kind,
                                  std::size_t size) {
    const auto wrong = [&](std::string message) { return error_at(reading.file, word, std::move(message)); };
    if (word.text.empty())
        return wrong(fmt::format("the file ends inside a face, where a {} index is needed", kind));
    const auto index = parse_integer(word.text);
    if (!index)
        return wrong(fmt::format("{} is no {} index, an integer is accepted", in_quotes(word.text), kind));
    if (size == 0) return wrong(fmt::format("{} index {}, but that list is empty", kind, *index));
    if (*index < 0 || *index >= static_cast<std::int64_t>(size))
        return wrong(
            fmt::format("{} index {} is outside its list, 0 to {} are accepted", kind, *index, size - 1));
    return static_cast<std::int32_t>(*index);
}

Failure too_few_corners(const Reading& reading, const Word& word, std::size_t corners) {
    if (corners >= 3) return std::nullopt;
    return error_at(reading.file, word, fmt::format("a face needs at least 3 corners, here are {}", corners));
}

// ---- first format: a number of vertices, their coordinates, faces of indices ended by -1 ----

// Vertices of the face's own: neighbours have other normals.
void append_flat_face(std::span<const std::int32_t> face, std::span<const Vec3> positions,
                      pipeline::Mesh& mesh) {
    const auto position = [&](std::size_t i) { return positions[static_cast<std::size_t>(face[i])]; };
    const Vec3 normal =
        unit(area_vector(face.size(), [&](std::size_t i) { return glm::dvec3(position(i)); }));
    std::vector<std::uint32_t> polygon;
    for (std::size_t i = 0; i < face.size(); ++i) {
        polygon.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back({{position(i)}, {normal}, Vec2(0)});
    }
    append_fan(polygon, mesh.indices);
}

FileResult<SolidMesh> read_first_format(Reading& reading, const Word& first) {
    const auto count = read_count(reading, first, "vertices", 6);  // "0 0 0 "
    if (!count) return count.error();
    const auto positions = read_vectors<3>(reading, *count);
    if (!positions) return positions.error();
    SolidMesh solid;
    std::vector<std::int32_t> face;
    for (Word word = reading.words.anywhere(); !word.text.empty(); word = reading.words.anywhere()) {
        for (face.clear(); word.text != "-1"; word = reading.words.anywhere()) {
            const auto index = index_of(reading, word, "vertex", positions->size());
            if (!index) return index.error();
            face.push_back(*index);
        }
        if (const Failure failure = too_few_corners(reading, word, face.size())) return *failure;
        append_flat_face(face, *positions, solid.mesh);
    }
    return solid;
}

// ---- second format: vertices, normais, textura, faces ----

struct Lists {
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> uvs;
};

// The word that names a part of the file, and the number of its elements.
FileResult<std::size_t> read_heading(Reading& reading, const Word& word, std::string_view heading,
                                     std::size_t least_bytes) {
    const std::string_view known[] = {heading};
    if (word.text.empty())
        return error_at(reading.file, word, fmt::format("the file ends where '{}' is needed", heading));
    if (word.text != heading)
        return error_at(reading.file, word,
                        fmt::format("{} where '{}' is needed{}", in_quotes(word.text), heading,
                                    suggestion(word.text, known)));
    const Word count = reading.words.anywhere();
    if (count.text.empty())
        return error_at(reading.file, count,
                        fmt::format("the file ends where the number of '{}' is needed", heading));
    return read_count(reading, count, heading, least_bytes);
}

FileResult<Lists> read_lists(Reading& reading, const Word& first) {
    Lists lists;
    const auto vertices = read_heading(reading, first, "vertices", 6);
    if (!vertices) return vertices.error();
    auto positions = read_vectors<3>(reading, *vertices);
    if (!positions) return positions.error();
    const auto normal_count = read_heading(reading, reading.words.anywhere(), "normais", 6);
    if (!normal_count) return normal_count.error();
    auto normals = read_vectors<3>(reading, *normal_count);
    if (!normals) return normals.error();
    const auto uv_count = read_heading(reading, reading.words.anywhere(), "textura", 4);  // "0 0 "
    if (!uv_count) return uv_count.error();
    auto uvs = read_vectors<2>(reading, *uv_count);
    if (!uvs) return uvs.error();
    return Lists{*std::move(positions), *std::move(normals), *std::move(uvs)};
}

// Corners until -1.
FileResult<std::vector<Corner>> read_face(Reading& reading, const Lists& lists, Word word) {
    std::vector<Corner> face;
    for (; word.text != "-1"; word = reading.words.anywhere()) {
        const auto position = index_of(reading, word, "vertex", lists.positions.size());
        if (!position) return position.error();
        const auto normal = index_of(reading, reading.words.anywhere(), "normal", lists.normals.size());
        if (!normal) return normal.error();
        const auto uv = index_of(reading, reading.words.anywhere(), "texture", lists.uvs.size());
        if (!uv) return uv.error();
        face.push_back({*position, *normal, *uv});
    }
    if (const Failure failure = too_few_corners(reading, word, face.size())) return *failure;
    return face;
}

std::string in_words(const Vec3& v) { return fmt::format("({:g} {:g} {:g})", v.x, v.y, v.z); }

// A warning when a corner's normal does not lie on the side from which the corners run counter-clockwise.
// Within 1e-6 of perpendicular counts as not on that side; zero vectors have no side.
std::string contradiction(const Reading& reading, const Lists& lists, std::span<const Corner> face,
                          const Word& place) {
    const glm::dvec3 area = area_vector(face.size(), [&](std::size_t i) {
        return glm::dvec3(lists.positions[static_cast<std::size_t>(face[i].position)]);
    });
    const glm::dvec3 outward(unit(area));
    for (const Corner& corner : face) {
        const Vec3 given = lists.normals[static_cast<std::size_t>(corner.normal)];
        const glm::dvec3 direction(unit(glm::dvec3(given)));
        if (outward == glm::dvec3(0) || direction == glm::dvec3(0) || glm::dot(outward, direction) > 1e-6)
            continue;
        return error_at(reading.file, place,
                        fmt::format("normal {} {} contradicts its face: the order of the corners says {}",
                                    corner.normal, in_words(given), in_words(Vec3(outward))))
            .text();
    }
    return "";
}

void make_vertices(const Lists& lists, const std::vector<Corner>& corners, pipeline::Mesh& mesh) {
    mesh.vertices.reserve(corners.size());
    for (const Corner& corner : corners)
        mesh.vertices.push_back({{lists.positions[static_cast<std::size_t>(corner.position)]},
                                 {lists.normals[static_cast<std::size_t>(corner.normal)]},
                                 lists.uvs[static_cast<std::size_t>(corner.uv)]});
}

FileResult<SolidMesh> read_second_format(Reading& reading, const Word& first) {
    const auto lists = read_lists(reading, first);
    if (!lists) return lists.error();
    const auto face_count =
        read_heading(reading, reading.words.anywhere(), "faces", 21);  // "0 0 0 0 0 0 0 0 0 -1 "
    if (!face_count) return face_count.error();
    SolidMesh solid{{}, true, true, {}};
    Corners corners;
    for (std::size_t i = 0; i < *face_count; ++i) {
        const Word start = reading.words.anywhere();
        const auto face = read_face(reading, *lists, start);
        if (!face) return face.error();
        if (std::string warning = contradiction(reading, *lists, *face, start); !warning.empty())
            solid.warnings.push_back(std::move(warning));
        std::vector<std::uint32_t> polygon;
        for (const Corner& corner : *face) polygon.push_back(corners.number(corner));
        append_fan(polygon, solid.mesh.indices);
    }
    if (const Word extra = reading.words.anywhere(); !extra.text.empty())
        return error_at(reading.file, extra,
                        fmt::format("{} after the last of {} faces", in_quotes(extra.text), *face_count));
    make_vertices(*lists, corners.list(), solid.mesh);
    return solid;
}

// ---- writing ----

// Numbers different vectors 0, 1, 2... in the order in which they come, and writes them down. Compared by
// bits, so that -0 stays -0.
template <int Dimensions>
class Rows {
  public:
    std::size_t number(const glm::vec<Dimensions, Scalar>& vector) {
        std::array<std::uint32_t, Dimensions> key;
        for (int i = 0; i < Dimensions; ++i)
            key[static_cast<std::size_t>(i)] = std::bit_cast<std::uint32_t>(static_cast<float>(vector[i]));
        const auto [entry, is_new] = numbers_.try_emplace(key, numbers_.size());
        if (is_new) append(vector);
        return entry->second;
    }
    std::string text(std::string_view heading) const {
        return fmt::format("{} {}\n{}", heading, numbers_.size(), rows_);
    }

  private:
    // The shortest decimal number that reads back to the same float32.
    void append(const glm::vec<Dimensions, Scalar>& vector) {
        for (int i = 0; i < Dimensions; ++i) {
            char digits[32];
            const auto end = std::to_chars(digits, digits + sizeof digits, static_cast<float>(vector[i])).ptr;
            rows_.append(digits, end).append(i + 1 < Dimensions ? " " : "\n");
        }
    }

    std::map<std::array<std::uint32_t, Dimensions>, std::size_t> numbers_;
    std::string rows_;
};

bool is_finite(const pipeline::Vertex& vertex) {
    const Vec3 &p = vertex.position.v, &n = vertex.normal.v;
    for (const Scalar number : {p.x, p.y, p.z, n.x, n.y, n.z, vertex.uv.x, vertex.uv.y})
        if (!std::isfinite(static_cast<float>(number))) return false;
    return true;
}

}  // namespace

FileResult<SolidMesh> read_solid(const std::string& path) {
    const auto text = read_text(path);
    return text ? parse_solid(*text, path) : text.error();
}

FileResult<SolidMesh> parse_solid(std::string_view text, const std::string& path) {
    Reading reading{path, Words(text)};
    const Word first = reading.words.anywhere();
    if (first.text.empty()) return error_in(path, "the file holds no words");
    const bool is_number = std::string_view("+-.0123456789").find(first.text[0]) != std::string_view::npos;
    auto solid = is_number ? read_first_format(reading, first) : read_second_format(reading, first);
    if (solid && solid->mesh.indices.empty()) return error_in(path, "no faces: a solid needs at least one");
    return solid;
}

Failure write_solid(const std::string& path, const pipeline::Mesh& mesh) {
    Rows<3> positions, normals;
    Rows<2> uvs;
    std::string faces;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const pipeline::Vertex& vertex = mesh.vertices[mesh.indices[i]];
        if (!is_finite(vertex))
            return error_in(path, "cannot be written: the mesh holds a number that is not finite");
        faces += fmt::format("{} {} {} ", positions.number(vertex.position.v),
                             normals.number(vertex.normal.v), uvs.number(vertex.uv));
        if (i % 3 == 2) faces += "-1\n";
    }
    return write_file(path, positions.text("vertices") + normals.text("normais") + uvs.text("textura") +
                                fmt::format("faces {}\n", mesh.triangles()) + faces);
}

}  // namespace relevo::io
