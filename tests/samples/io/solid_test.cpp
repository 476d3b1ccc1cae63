#include "samples/io/solid.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/samples/io/size_limit.hpp"
#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::io {
namespace {

using pipeline::Vec2;
using pipeline::Vec3;
using Indices = std::vector<std::uint32_t>;

const std::string source = RELEVO_SOURCE_DIR;
const std::string first_triangle = "3\n0 0 0\n1 0 0\n0 1 0\n";
const std::string second_lists =
    "vertices 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\nnormais 1\n0 0 1\ntextura 2\n0 0\n1 1\n";

std::string error_of(std::string_view text) {
    const auto solid = parse_solid(text, "x.solid");
    return solid ? "no error" : solid.error().text();
}

SolidMesh solid_of(std::string_view text) {
    const auto solid = parse_solid(text, "x.solid");
    EXPECT_TRUE(solid) << solid.error().text();
    return solid ? *solid : SolidMesh();
}

// All six sides of the unit cube, each seen from outside.
void expect_unit_cube(const pipeline::Mesh& mesh) {
    ASSERT_EQ(mesh.triangles(), 12u);
    ASSERT_EQ(mesh.vertices.size(), 24u);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
        const Vec3 a = corner(0).position.v, b = corner(1).position.v, c = corner(2).position.v;
        const Vec3 normal = glm::cross(b - a, c - a), middle = (a + c) / pipeline::Scalar(2);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(corner(k).normal.v, normal) << "triangle " << i / 3;
        EXPECT_GT(glm::dot(normal, middle - Vec3(0.5)), 0) << "triangle " << i / 3;
    }
}

TEST(Solid, TheBooksCube) {
    const auto solid = read_solid(source + "/samples/models/cube.solid");
    ASSERT_TRUE(solid) << solid.error().text();
    expect_unit_cube(solid->mesh);
    EXPECT_FALSE(solid->had_normals);
    EXPECT_FALSE(solid->had_uv);
    EXPECT_TRUE(solid->warnings.empty());
}

TEST(Solid, TheBooksDiceWithItsNormalsCorrected) {
    const auto solid = read_solid(source + "/samples/models/dice.solid");
    ASSERT_TRUE(solid) << solid.error().text();
    expect_unit_cube(solid->mesh);
    EXPECT_TRUE(solid->had_normals);
    EXPECT_TRUE(solid->had_uv);
    EXPECT_TRUE(solid->warnings.empty());
    EXPECT_EQ(solid->mesh.vertices[2].uv, Vec2(0.25, 1));
}

TEST(Solid, TheDiceAsPrintedContradictsItselfOnFourFaces) {
    const std::string path = source + "/tests/samples/io/data/dice_as_printed.solid";
    const auto solid = read_solid(path);
    ASSERT_TRUE(solid) << solid.error().text();
    const std::string says = " contradicts its face: the order of the corners says ";
    EXPECT_EQ(solid->warnings,
              (std::vector<std::string>{path + ":34:1: normal 5 (-1 0 0)" + says + "(0 0 -1)",
                                        path + ":35:1: normal 0 (0 0 1)" + says + "(1 0 0)",
                                        path + ":37:1: normal 4 (1 0 0)" + says + "(0 0 1)",
                                        path + ":38:1: normal 1 (0 0 -1)" + says + "(-1 0 0)"}));
}

TEST(Solid, FacesOfTheFirstFormatShareNoCorners) {
    const SolidMesh solid = solid_of("4 0 0 0 1 0 0 1 1 0 0 1 0  0 1 2 3 -1  0 3 2 -1");
    EXPECT_EQ(solid.mesh.indices, (Indices{0, 1, 2, 0, 2, 3, 4, 5, 6}));
    EXPECT_EQ(solid.mesh.vertices[0].normal.v, Vec3(0, 0, 1));
    EXPECT_EQ(solid.mesh.vertices[4].normal.v, Vec3(0, 0, -1));
}

TEST(Solid, EqualCornersOfTheSecondFormatAreOneVertex) {
    const SolidMesh solid = solid_of(second_lists + "faces 2\n0 0 0 1 0 0 2 0 0 -1\n0 0 0 2 0 0 3 0 1 -1\n");
    EXPECT_EQ(solid.mesh.vertices.size(), 4u);
    EXPECT_EQ(solid.mesh.indices, (Indices{0, 1, 2, 0, 2, 3}));
}

TEST(Solid, FacesWithoutAreaAreLegal) {
    EXPECT_EQ(solid_of(first_triangle + "0 0 1 -1").mesh.vertices[0].normal.v, Vec3(0, 0, 0));
    EXPECT_TRUE(solid_of(second_lists + "faces 1 0 0 0 0 0 0 1 0 0 -1").warnings.empty());
}

TEST(Solid, ANormalWithinTheFaceIsAContradiction) {
    const std::string lists = "vertices 3 0 0 0 1 0 0 0 1 0 normais 2 0 1 0 0 0 1 textura 1 0 0\n";
    const SolidMesh solid = solid_of(lists + "faces 1\n 0 1 0 1 1 0 2 0 0 -1");
    ASSERT_EQ(solid.warnings.size(), 1u);
    EXPECT_NE(solid.warnings[0].find(":3:2: normal 0 (0 1 0) contradicts"), std::string::npos)
        << solid.warnings[0];
}

TEST(SolidErrors, FilesThatAreNoSolids) {
    const TemporaryFolder folder;
    const auto error_of_file = [&](std::string_view bytes) {
        const auto read = read_solid(folder.write("x.solid", bytes));
        return read ? "no error" : folder.without_path(read.error().text());
    };
    EXPECT_EQ(folder.without_path(read_solid(folder.path("no")).error().text()), "no: there is no such file");
    EXPECT_EQ(error_of_file(""), "x.solid: the file is empty");
    EXPECT_EQ(error_of_file(" \n# only a comment\n"), "x.solid: the file holds no words");
    EXPECT_EQ(error_of_file(first_triangle), "x.solid: no faces: a solid needs at least one");
    EXPECT_EQ(error_of_file(second_lists + "faces 0"), "x.solid: no faces: a solid needs at least one");
    EXPECT_EQ(error_of_file(std::string_view("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)),
              "x.solid:3:1: a zero byte: this is a binary file, a text file is needed");
    EXPECT_EQ(error_of_file("vertice 3"),
              "x.solid:1:1: 'vertice' where 'vertices' is needed, did you mean 'vertices'?");
    EXPECT_EQ(error_of_file("o cube"), "x.solid:1:1: 'o' where 'vertices' is needed");
}

TEST(SolidErrors, OneGigabyte) {
    const TemporaryFolder folder;
    std::filesystem::resize_file(folder.write("x.solid", first_triangle), 1u << 30);
    EXPECT_EQ(folder.without_path(read_solid(folder.path("x.solid")).error().text()),
              "x.solid: is 1073741824 bytes large, at most 536870912 bytes are accepted");
}

TEST(SolidErrors, CountsThatTheFileCannotHold) {
    EXPECT_EQ(error_of("1000000000\n0 0 0\n"),
              "x.solid:1:1: 1000000000 vertices cannot be in the remaining 7 bytes of the file");
    EXPECT_EQ(error_of("vertices 1000000000\n0 0 0\n"),
              "x.solid:1:10: 1000000000 vertices cannot be in the remaining 7 bytes of the file");
    EXPECT_EQ(error_of("vertices 0\nnormais 1000000000\n"),
              "x.solid:2:9: 1000000000 normais cannot be in the remaining 1 bytes of the file");
    EXPECT_EQ(error_of("vertices 0\nnormais 0\ntextura 9223372036854775807"),
              "x.solid:3:9: 9223372036854775807 textura cannot be in the remaining 0 bytes of the file");
    EXPECT_EQ(error_of(second_lists + "faces 1000000000\n0 0 0 1 0 0 2 0 0 -1"),
              "x.solid:11:7: 1000000000 faces cannot be in the remaining 21 bytes of the file");
    // The shortest face there is, without a blank at the end, fits.
    EXPECT_EQ(error_of(second_lists + "faces 1\n0 0 0 1 0 0 2 0 0 -1"), "no error");
    EXPECT_EQ(error_of("1 0 0 0"), "x.solid: no faces: a solid needs at least one");
}

TEST(SolidErrors, CountsThatAreNone) {
    EXPECT_EQ(error_of("-3"), "x.solid:1:1: '-3' is no number of vertices, an integer from 0 up is accepted");
    EXPECT_EQ(error_of("2.5"),
              "x.solid:1:1: '2.5' is no number of vertices, an integer from 0 up is accepted");
    EXPECT_EQ(error_of("vertices many"),
              "x.solid:1:10: 'many' is no number of vertices, an integer from 0 up is accepted");
    EXPECT_EQ(error_of("vertices"), "x.solid:1:9: the file ends where the number of 'vertices' is needed");
    EXPECT_EQ(
        error_of("99999999999999999999"),
        "x.solid:1:1: '99999999999999999999' is no number of vertices, an integer from 0 up is accepted");
}

TEST(SolidErrors, NumbersThatAreNone) {
    for (const std::string word : {"nan", "inf", "1e39", "0x10", "abc"})
        EXPECT_EQ(error_of("3\n0 0 0\n1 " + word + " 0\n0 1 0\n0 1 2 -1"),
                  "x.solid:3:3: '" + word + "' is no finite float32 number");
    EXPECT_EQ(error_of("2\n0 0 0\n1 0     "), "x.solid:3:9: the file ends where a coordinate is needed");
    EXPECT_EQ(error_of("vertices 2\n0 0 0\n1 0\nnormais 0\n"),
              "x.solid:4:1: 'normais' is no finite float32 number");
}

TEST(SolidErrors, FacesOfTheFirstFormat) {
    EXPECT_EQ(error_of(first_triangle + "0 1 3 -1"),
              "x.solid:5:5: vertex index 3 is outside its list, 0 to 2 are accepted");
    EXPECT_EQ(error_of(first_triangle + "0 1 -2 -1"),
              "x.solid:5:5: vertex index -2 is outside its list, 0 to 2 are accepted");
    EXPECT_EQ(error_of(first_triangle + "0 1 x -1"),
              "x.solid:5:5: 'x' is no vertex index, an integer is accepted");
    EXPECT_EQ(error_of(first_triangle + "0 1 -1"),
              "x.solid:5:5: a face needs at least 3 corners, here are 2");
    EXPECT_EQ(error_of(first_triangle + "-1"), "x.solid:5:1: a face needs at least 3 corners, here are 0");
    EXPECT_EQ(error_of(first_triangle + "0 1 2"),
              "x.solid:5:6: the file ends inside a face, where a vertex index is needed");
    EXPECT_EQ(error_of("0\n0 1 2 -1"), "x.solid:2:1: vertex index 0, but that list is empty");
}

TEST(SolidErrors, FacesOfTheSecondFormat) {
    const std::string faces = second_lists + "faces 1\n";
    EXPECT_EQ(error_of(faces + "0 0 0 1 0 0 4 0 0 -1"),
              "x.solid:12:13: vertex index 4 is outside its list, 0 to 3 are accepted");
    EXPECT_EQ(error_of(faces + "0 0 0 1 1 0 2 0 0 -1"),
              "x.solid:12:9: normal index 1 is outside its list, 0 to 0 are accepted");
    EXPECT_EQ(error_of(faces + "0 0 0 1 0 2 2 0 0 -1"),
              "x.solid:12:11: texture index 2 is outside its list, 0 to 1 are accepted");
    EXPECT_EQ(error_of(faces + "0 0 0 1 0 0 -1      "),
              "x.solid:12:13: a face needs at least 3 corners, here are 2");
    EXPECT_EQ(error_of(faces + "0 0 0 1 0 0 2 0 0   "),
              "x.solid:12:21: the file ends inside a face, where a vertex index is needed");
    EXPECT_EQ(error_of(faces + "0 0 0 1 0 0 2 0 0 -1 7"), "x.solid:12:22: '7' after the last of 1 faces");
    EXPECT_EQ(error_of("vertices 0 normals 0"),
              "x.solid:1:12: 'normals' where 'normais' is needed, did you mean 'normais'?");
    EXPECT_EQ(error_of(second_lists), "x.solid:11:1: the file ends where 'faces' is needed");
}

TEST(SolidErrors, TruncatedFiles) {
    const std::string cube = bytes_of(source + "/samples/models/cube.solid"),
                      dice = bytes_of(source + "/samples/models/dice.solid");
    ASSERT_EQ(error_of(dice), "no error");
    for (std::size_t size = 0; size + 1 < dice.size(); ++size)
        EXPECT_NE(error_of(dice.substr(0, size)), "no error");
    // The first format does not say how many faces there are: cut between two faces it is a smaller solid.
    for (std::size_t size = 0; size + 1 < cube.size(); ++size) {
        const std::string part = cube.substr(0, size);
        const bool ends_with_face = part.ends_with("-1") || part.ends_with("-1\n");
        EXPECT_EQ(error_of(part) == "no error", ends_with_face) << part;
    }
}

using Corners = std::vector<std::array<pipeline::Scalar, 8>>;

Corners corners_of(const pipeline::Mesh& mesh) {
    Corners out;
    for (const std::uint32_t index : mesh.indices) {
        const pipeline::Vertex& v = mesh.vertices[index];
        out.push_back({v.position.v.x, v.position.v.y, v.position.v.z, v.normal.v.x, v.normal.v.y,
                       v.normal.v.z, v.uv.x, v.uv.y});
    }
    return out;
}

TEST(WriteSolid, ReadsBackTheSame) {
    const TemporaryFolder folder;
    for (const std::string name : {"cube", "dice"}) {
        const auto solid = read_solid(source + "/samples/models/" + name + ".solid");
        ASSERT_FALSE(write_solid(folder.path("x.solid"), solid->mesh));
        const auto again = read_solid(folder.path("x.solid"));
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(corners_of(again->mesh), corners_of(solid->mesh));
        EXPECT_TRUE(again->warnings.empty());
        // Each position is written once.
        EXPECT_TRUE(bytes_of(folder.path("x.solid")).starts_with("vertices 8\n"));
    }
}

TEST(WriteSolid, KeepsEveryBitOfEveryFloat) {
    const TemporaryFolder folder;
    pipeline::Mesh mesh;
    std::uint32_t state = 7;
    const auto number = [&] {
        for (;;) {
            state = state * 1664525 + 1013904223;
            const float f = std::bit_cast<float>(state ^ (state >> 13));
            if (std::isfinite(f)) return pipeline::Scalar(f);
        }
    };
    for (std::uint32_t i = 0; i < 999; ++i) {
        mesh.vertices.push_back(
            {{{number(), number(), number()}}, {{number(), number(), number()}}, {number(), number()}});
        mesh.indices.push_back(i);
    }
    mesh.vertices[5].position.v = {-0.f, 0.f, std::numeric_limits<float>::denorm_min()};
    ASSERT_FALSE(write_solid(folder.path("x.solid"), mesh));
    const auto again = read_solid(folder.path("x.solid"));
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(corners_of(again->mesh), corners_of(mesh));
    EXPECT_TRUE(std::signbit(again->mesh.vertices[again->mesh.indices[5]].position.v.x));
}

TEST(WriteSolid, SaysWhatIsWrong) {
    const TemporaryFolder folder;
    pipeline::Mesh mesh{std::vector<pipeline::Vertex>(3), {0, 1, 2}};
    mesh.vertices[1].uv.x = std::numeric_limits<pipeline::Scalar>::quiet_NaN();
    EXPECT_EQ(folder.without_path(write_solid(folder.path("x.solid"), mesh)->text()),
              "x.solid: cannot be written: the mesh holds a number that is not finite");
    mesh.vertices[1].uv.x = 0;
    {
        const SizeLimit limit(10);
        EXPECT_EQ(folder.without_path(write_solid(folder.path("x.solid"), mesh)->text()),
                  "x.solid: cannot be written: File too large");
    }
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace relevo::io
