#include "samples/io/obj.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::io {
namespace {

using pipeline::Vec2;
using pipeline::Vec3;
using Indices = std::vector<std::uint32_t>;

const std::string square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";

std::vector<ObjPart> parts_of(std::string_view text) {
    const auto parts = parse_obj(text, "x.obj");
    EXPECT_TRUE(parts) << parts.error().text();
    return parts ? *parts : std::vector<ObjPart>();
}

pipeline::Mesh mesh_of(std::string_view text) {
    const auto parts = parts_of(text);
    EXPECT_EQ(parts.size(), 1u);
    return parts.size() == 1 ? parts[0].mesh : pipeline::Mesh();
}

std::string error_of(std::string_view text) {
    const auto parts = parse_obj(text, "x.obj");
    return parts ? "no error" : parts.error().text();
}

TEST(Obj, ATriangle) {
    const pipeline::Mesh mesh = mesh_of("v 1 2 3\nv -4.5 5e-1 +6\nv 7 8 9\nf 1 2 3\n");
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.vertices[1].position.v, Vec3(-4.5, 0.5, 6));
    EXPECT_EQ(mesh.vertices[1].uv, Vec2(0, 0));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2}));
}

TEST(Obj, PolygonsAreFansFromTheFirstCorner) {
    const pipeline::Mesh mesh = mesh_of(square + "v -1 1 0\nf 2 3 4 5 1\n");
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 2, 3, 0, 3, 4}));
    EXPECT_EQ(mesh.vertices[0].position.v, Vec3(2, 0, 0));  // numbered by first use
}

TEST(Obj, AllFourKindsOfCorners) {
    const std::string lists = square + "vt 0.25 0.5 9\nvt 1 1\nvn 0 0 3\n";
    const pipeline::Vertex full = mesh_of(lists + "f 1/1/1 2/2/1 3/2/1").vertices[0];
    EXPECT_EQ(full.uv, Vec2(0.25, 0.5));
    EXPECT_EQ(full.normal.v, Vec3(0, 0, 3));  // as written, of any length
    const pipeline::Vertex no_normal = mesh_of(lists + "f 1/1 3/2 2/2").vertices[0];
    EXPECT_EQ(no_normal.uv, Vec2(0.25, 0.5));
    EXPECT_EQ(no_normal.normal.v, Vec3(0, 0, -1));
    const pipeline::Vertex no_uv = mesh_of(lists + "f 1//1 2//1 3//1").vertices[0];
    EXPECT_EQ(no_uv.uv, Vec2(0, 0));
    EXPECT_EQ(no_uv.normal.v, Vec3(0, 0, 3));
}

TEST(Obj, SaysWhatThePartHad) {
    const std::string lists = square + "vt 0 0\nvn 0 0 1\n";
    const auto had = [&](const std::string& faces) {
        const ObjPart part = parts_of(lists + faces)[0];
        return std::pair(part.had_normals, part.had_uv);
    };
    EXPECT_EQ(had("f 1/1/1 2/1/1 3/1/1"), std::pair(true, true));
    EXPECT_EQ(had("f 1//1 2//1 3//1"), std::pair(true, false));
    EXPECT_EQ(had("f 1/1 2/1 3/1"), std::pair(false, true));
    EXPECT_EQ(had("f 1 2 3"), std::pair(false, false));
    EXPECT_EQ(had("f 1/1/1 2/1/1 3/1/1\nf 1 2 3"), std::pair(false, false));
}

TEST(Obj, NegativeIndicesCountBackFromTheirLine) {
    const pipeline::Mesh mesh = mesh_of(square + "f -4 -3 -2\nv 9 9 9\nf -1 -2 -3\n");
    EXPECT_EQ(mesh.vertices[0].position.v, Vec3(0, 0, 0));
    EXPECT_EQ(mesh.vertices[mesh.indices[3]].position.v, Vec3(9, 9, 9));
    EXPECT_EQ(mesh.vertices[mesh.indices[4]].position.v, Vec3(0, 2, 0));
}

TEST(Obj, FacesMayComeBeforeTheirVertices) {
    EXPECT_EQ(mesh_of("f 1 2 3\n" + square).vertices[2].position.v, Vec3(2, 2, 0));
}

TEST(Obj, EqualCornersAreOneVertex) {
    const std::string lists = square + "vt 0 0\nvt 1 1\nvn 0 0 1\n";
    EXPECT_EQ(mesh_of(square + "f 1 2 3\nf 1 3 4").vertices.size(), 4u);
    EXPECT_EQ(mesh_of(lists + "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1").vertices.size(), 4u);
    EXPECT_EQ(mesh_of(lists + "f 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/1/1 4/1/1").vertices.size(), 5u);
}

TEST(Obj, MissingNormalsAreAveragedByArea) {
    // An edge between a floor of area 4 and a wall of area 2: the shared corners lean towards the floor.
    const pipeline::Mesh mesh = mesh_of(square + "v 0 0 1\nv 0 2 1\nf 1 2 3 4\nf 1 4 6 5\n");
    const Vec3 shared = mesh.vertices[0].normal.v;
    EXPECT_FLOAT_EQ(static_cast<float>(shared.x), static_cast<float>(1 / std::sqrt(5.0)));
    EXPECT_EQ(shared.y, 0);
    EXPECT_FLOAT_EQ(static_cast<float>(shared.z), static_cast<float>(2 / std::sqrt(5.0)));
    EXPECT_EQ(mesh.vertices[1].normal.v, Vec3(0, 0, 1));
    EXPECT_EQ(mesh.vertices[4].normal.v, Vec3(1, 0, 0));
}

TEST(Obj, NormalsAreAveragedAcrossTextureSeamsAndParts) {
    const std::string lists = square + "v 0 0 2\nv 0 2 2\nvt 0 0\nvt 1 1\n";
    const auto parts = parts_of(lists + "o floor\nf 1/1 2/1 3/1 4/1\no wall\nf 1/2 4/2 6/2 5/2\n");
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].mesh.vertices[0].normal.v, parts[1].mesh.vertices[0].normal.v);
}

TEST(Obj, FacesWithoutAreaAreLegal) {
    const pipeline::Mesh mesh = mesh_of("v 1 1 1\nv 2 2 2\nf 1 1 1\nf 1 2 1\n");
    EXPECT_EQ(mesh.triangles(), 2u);
    EXPECT_EQ(mesh.vertices[0].normal.v, Vec3(0, 0, 0));
}

TEST(Obj, TheLargestNumbersGiveFiniteNormals) {
    const pipeline::Mesh mesh = mesh_of("v 3e38 0 0\nv -3e38 3e38 0\nv 0 -3e38 1e-45\nf 1 2 3\n");
    EXPECT_EQ(mesh.vertices[0].normal.v, Vec3(0, 0, 1));
}

TEST(Obj, ContinuedLinesCommentsAndCarriageReturns) {
    const pipeline::Mesh mesh =
        mesh_of("# a \\\r\nv 0 0 0 # origin\r\nv 1 \\\r\n 0 0\r\nv 0 1 0\r\n\r\nf 1 \\\n2 3");
    EXPECT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.triangles(), 1u);
}

TEST(Obj, WhatDrawsNoFacesIsSkipped) {
    EXPECT_EQ(
        mesh_of(square + "s 1\nl 1 2 3\np 1\nvp 0.3 0.2\ncstype bezier\ncurv 0 1 1 2\nf 1 2 3\nend\ns off\n")
            .triangles(),
        1u);
}

TEST(Obj, VerticesMayHaveWeightsOrColours) {
    EXPECT_EQ(mesh_of("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nf 1 2 3").vertices[1].position.v,
              Vec3(1, 0, 0));
    EXPECT_EQ(error_of("v 0 0 0 red\n"), "x.obj:1:9: 'red' is no finite float32 number");
}

TEST(Obj, OnePartAnObjectAndMaterialInTheOrderOfTheirFaces) {
    const TemporaryFolder folder;
    folder.write("two.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\nmap_Kd blue.png\n");
    const auto parts =
        read_obj(folder.write("x.obj", square + "mtllib two.mtl\no a\ng\nusemtl blue\nf 1 2 3\n"
                                                "usemtl red\nf 1 2 3\no empty\no b\ng left\nf 1 2 3 4\n"
                                                "o a\nusemtl blue\nf 2 3 4\n"));
    ASSERT_TRUE(parts) << parts.error().text();
    ASSERT_EQ(parts->size(), 3u);
    EXPECT_EQ((*parts)[0].name, "a");
    EXPECT_EQ((*parts)[0].material->name, "blue");
    EXPECT_EQ(folder.without_path((*parts)[0].material->texture_path), "blue.png");
    EXPECT_EQ((*parts)[0].mesh.triangles(), 2u);  // both times that `a` was blue
    EXPECT_EQ((*parts)[1].name, "a");
    EXPECT_EQ((*parts)[1].material->name, "red");
    EXPECT_EQ((*parts)[1].mesh.triangles(), 1u);
    EXPECT_EQ((*parts)[2].name, "b left");
    EXPECT_EQ((*parts)[2].material->name, "red");
    EXPECT_EQ((*parts)[2].mesh.triangles(), 2u);
}

TEST(Obj, WithoutAMaterialFileNamesOnlyTellPartsApart) {
    const auto parts = parts_of(square + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_FALSE(parts[0].material);
}

TEST(Obj, MaterialsThatAreMissing) {
    const TemporaryFolder folder;
    folder.write("two.mtl", "newmtl red\nnewmtl blue\n");
    folder.write("bad.mtl", "newmtl red\nKd red\n");
    const auto error = [&](std::string_view text) {
        const auto parts = read_obj(folder.write("x.obj", square + std::string(text)));
        return parts ? "no error" : folder.without_path(parts.error().text());
    };
    EXPECT_EQ(error("mtllib two.mtl\nusemtl bleu\nf 1 2 3"),
              "x.obj:6:8: there is no material 'bleu' in the material file, did you mean 'blue'?");
    EXPECT_EQ(error("usemtl green\nf 1 2 3\nmtllib two.mtl"),
              "x.obj:5:8: there is no material 'green' in the material file");
    EXPECT_EQ(error("mtllib no.mtl\nf 1 2 3"), "x.obj:5:8: the material file no.mtl: there is no such file");
    EXPECT_EQ(error("mtllib bad.mtl\nf 1 2 3"),
              "bad.mtl:2:4: 'red' is no colour channel, a number from 0 to 1 is accepted");
    EXPECT_EQ(error("mtllib\nf 1 2 3"), "x.obj:5:7: a file name is missing after mtllib");
    EXPECT_EQ(error("usemtl\nf 1 2 3"), "x.obj:5:7: a name is missing after usemtl");
}

TEST(ObjErrors, FilesThatAreNoMeshes) {
    const TemporaryFolder folder;
    const auto error_of_file = [&](std::string_view bytes) {
        const auto read = read_obj(folder.write("x.obj", bytes));
        return read ? "no error" : folder.without_path(read.error().text());
    };
    EXPECT_EQ(folder.without_path(read_obj(folder.path("no.obj")).error().text()),
              "no.obj: there is no such file");
    EXPECT_EQ(folder.without_path(read_obj(folder.path(".")).error().text()),
              ".: is a directory, a file is needed");
    EXPECT_EQ(error_of_file(""), "x.obj: the file is empty");
    EXPECT_EQ(error_of_file("\n\n# nothing\n"), "x.obj: no faces: a mesh needs at least one line 'f v v v'");
    EXPECT_EQ(error_of_file(square), "x.obj: no faces: a mesh needs at least one line 'f v v v'");
    EXPECT_EQ(error_of_file(std::string_view("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)),
              "x.obj:3:1: a zero byte: this is a binary file, a text file is needed");
    EXPECT_EQ(error_of_file("\x7f"
                            "ELF\x02\n"),
              "x.obj:1:1: '?ELF?' is no statement of OBJ");
}

TEST(ObjErrors, OneGigabyte) {
    const TemporaryFolder folder;
    std::filesystem::resize_file(folder.write("x.obj", square), 1u << 30);
    EXPECT_EQ(folder.without_path(read_obj(folder.path("x.obj")).error().text()),
              "x.obj: is 1073741824 bytes large, at most 536870912 bytes are accepted");
}

TEST(ObjErrors, NumbersThatAreNone) {
    for (const std::string word :
         {"nan", "inf", "-inf", "1e39", "-1e39", "0x10", "abc", "1.5.2", "1,5", "--1", "1f"})
        EXPECT_EQ(error_of("v 0 0 0\nv 1 " + word + " 2\n"),
                  "x.obj:2:5: '" + word + "' is no finite float32 number");
    EXPECT_EQ(error_of("vn 0 0 nan\n"), "x.obj:1:8: 'nan' is no finite float32 number");
    EXPECT_EQ(error_of("vt 1e39 0\n"), "x.obj:1:4: '1e39' is no finite float32 number");
}

TEST(ObjErrors, CoordinatesThatAreMissing) {
    EXPECT_EQ(error_of("v 0 0 0\nv 1 2\n"),
              "x.obj:2:6: a coordinate is missing: v needs 3 numbers, here are 2");
    EXPECT_EQ(error_of("v\n"), "x.obj:1:2: a coordinate is missing: v needs 3 numbers, here are 0");
    EXPECT_EQ(error_of("v 1 2 # 3\n"), "x.obj:1:7: a coordinate is missing: v needs 3 numbers, here are 2");
    EXPECT_EQ(error_of("vn 1 2"), "x.obj:1:7: a coordinate is missing: vn needs 3 numbers, here are 2");
    EXPECT_EQ(error_of("vt 1 \n"), "x.obj:1:6: a coordinate is missing: vt needs 2 numbers, here are 1");
}

TEST(ObjErrors, IndicesOutsideTheirLists) {
    EXPECT_EQ(error_of(square + "f 1 2 5"),
              "x.obj:5:7: vertex index 5 is outside its list: the file has 4 vertices (v)");
    EXPECT_EQ(error_of(square + "f 1 1000000000000 3"),
              "x.obj:5:5: vertex index 1000000000000 is outside its list: the file has 4 vertices (v)");
    EXPECT_EQ(error_of(square + "f 1 -5 3"),
              "x.obj:5:5: vertex index -5 is outside its list: 4 vertices (v) come before this line");
    EXPECT_EQ(error_of(square + "f 1 -9223372036854775808 3"),
              "x.obj:5:5: vertex index -9223372036854775808 is outside its list: 4 vertices (v) come before "
              "this line");
    EXPECT_EQ(error_of(square + "f 0 1 2"),
              "x.obj:5:3: vertex index 0: indices count from 1, or back from -1");
    EXPECT_EQ(
        error_of(square + "f 1/1 2 3"),
        "x.obj:5:5: texture coordinate index 1 is outside its list: the file has 0 texture coordinates (vt)");
    EXPECT_EQ(error_of(square + "vn 0 0 1\nf 1//1 2//2 3//1"),
              "x.obj:6:11: normal index 2 is outside its list: the file has 1 normals (vn)");
    EXPECT_EQ(error_of(square + "vt 0 0\nf 1/1/0 2/1/0 3/1/0"),
              "x.obj:6:7: normal index 0: indices count from 1, or back from -1");
}

TEST(ObjErrors, CornersThatAreNone) {
    const std::string accepted = " is no corner, accepted are v, v/t, v//n and v/t/n";
    EXPECT_EQ(error_of(square + "f 1 b 3"), "x.obj:5:5: 'b'" + accepted);
    EXPECT_EQ(error_of(square + "f 1 2.0 3"), "x.obj:5:5: '2.0'" + accepted);
    EXPECT_EQ(error_of(square + "vt 0 0\nf 1/1 2/x 3/1"), "x.obj:6:9: '2/x'" + accepted);
    EXPECT_EQ(error_of(square + "f 1/ 2 3"), "x.obj:5:5: '1/'" + accepted);
    EXPECT_EQ(error_of(square + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2 3"), "x.obj:7:7: '1/1/1/1'" + accepted);
    EXPECT_EQ(error_of(square + "f 99999999999999999999 2 3"),
              "x.obj:5:3: '99999999999999999999'" + accepted);
}

TEST(ObjErrors, FacesWithTooFewCorners) {
    EXPECT_EQ(error_of(square + "f 1 2\n"), "x.obj:5:6: a face needs at least 3 corners, here are 2");
    EXPECT_EQ(error_of(square + "f"), "x.obj:5:2: a face needs at least 3 corners, here are 0");
}

TEST(ObjErrors, WordsThatAreNoStatements) {
    EXPECT_EQ(error_of("vertex 1 2 3"), "x.obj:1:1: 'vertex' is no statement of OBJ");
    EXPECT_EQ(error_of(square + "usemlt wood\n"),
              "x.obj:5:1: 'usemlt' is no statement of OBJ, did you mean 'usemtl'?");
    EXPECT_EQ(error_of("V 1 2 3"), "x.obj:1:1: 'V' is no statement of OBJ");
}

TEST(ObjErrors, TruncatedFiles) {
    const std::string whole = "v 0.5 0.25 0.125\nv 1.5 0.25 0.125\nv 0.5 1.25 0.125\nf 1 2 3";
    ASSERT_EQ(error_of(whole), "no error");
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_NE(error_of(whole.substr(0, size)), "no error") << whole.substr(0, size);
}

}  // namespace
}  // namespace relevo::io
