// A second opinion on real files: tinyobjloader reads the same triangles. (It is no opinion on bad files: it
// turns `nan` and missing numbers into 0 and keeps indices that are out of range.)
#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include <cmath>
#include <filesystem>

#include "samples/io/obj.hpp"

namespace relevo::io {
namespace {

struct Soup {  // a corner after the other, three a triangle
    std::vector<pipeline::Vertex> corners;
    std::vector<std::string> materials;  // one a triangle
};

Soup soup_of(const std::vector<ObjPart>& parts) {
    Soup out;
    for (const ObjPart& part : parts) {
        for (const std::uint32_t index : part.mesh.indices) out.corners.push_back(part.mesh.vertices[index]);
        out.materials.insert(out.materials.end(), part.mesh.triangles(),
                             part.material ? part.material->name : "");
    }
    return out;
}

void append(const tinyobj::attrib_t& lists, const tinyobj::shape_t& shape,
            const std::vector<tinyobj::material_t>& materials, Soup& out) {
    for (const tinyobj::index_t& i : shape.mesh.indices) {
        const auto at = [](const std::vector<float>& list, int index, int count, int c) {
            return index < 0 ? 0.f : list[static_cast<std::size_t>(count * index + c)];
        };
        const auto vec3 = [&](const std::vector<float>& list, int index) {
            return pipeline::Vec3(at(list, index, 3, 0), at(list, index, 3, 1), at(list, index, 3, 2));
        };
        out.corners.push_back(
            {{vec3(lists.vertices, i.vertex_index)},
             {vec3(lists.normals, i.normal_index)},
             {at(lists.texcoords, i.texcoord_index, 2, 0), at(lists.texcoords, i.texcoord_index, 2, 1)}});
    }
    for (const int id : shape.mesh.material_ids)
        out.materials.push_back(id < 0 ? "" : materials[static_cast<std::size_t>(id)].name);
}

Soup soup_of_tinyobjloader(const std::string& path) {
    tinyobj::ObjReaderConfig config;
    config.triangulate = false;  // these files have triangles only
    tinyobj::ObjReader reader;
    EXPECT_TRUE(reader.ParseFromFile(path, config)) << reader.Error();
    Soup out;
    for (const tinyobj::shape_t& shape : reader.GetShapes()) {
        for (const auto corners : shape.mesh.num_face_vertices) EXPECT_EQ(int(corners), 3);
        append(reader.GetAttrib(), shape, reader.GetMaterials(), out);
    }
    return out;
}

// tinyobjloader does not round correctly: the last bits may differ.
void expect_near(float ours, float theirs, std::size_t corner) {
    EXPECT_LE(std::abs(ours - theirs), 3e-7f * std::abs(theirs)) << "corner " << corner;
}

void compare(const std::string& path, std::size_t triangles, bool with_normals) {
    ASSERT_TRUE(std::filesystem::exists(path))
        << path << " is missing: install glmark2-data and assimp-testmodels";
    const auto parts = read_obj(path);
    ASSERT_TRUE(parts) << parts.error().text();
    const Soup ours = soup_of(*parts), theirs = soup_of_tinyobjloader(path);
    ASSERT_EQ(ours.corners.size(), 3 * triangles);
    ASSERT_EQ(theirs.corners.size(), 3 * triangles);
    EXPECT_EQ(ours.materials, theirs.materials);
    for (std::size_t i = 0; i < 3 * triangles; ++i) {
        for (int c = 0; c < 3; ++c)
            expect_near(float(ours.corners[i].position.v[c]), float(theirs.corners[i].position.v[c]), i);
        for (int c = 0; c < 3 && with_normals; ++c)
            expect_near(float(ours.corners[i].normal.v[c]), float(theirs.corners[i].normal.v[c]), i);
        for (int c = 0; c < 2; ++c)
            expect_near(float(ours.corners[i].uv[c]), float(theirs.corners[i].uv[c]), i);
    }
}

TEST(ObjOracle, TheBunny) { compare("/usr/share/glmark2/models/bunny.obj", 69666, false); }
TEST(ObjOracle, TheSpider) { compare("/usr/share/assimp/models/OBJ/spider.obj", 1368, true); }

TEST(ObjOracle, TheBunnyHasNormalsThatPointOutwards) {
    const auto parts = read_obj("/usr/share/glmark2/models/bunny.obj");
    ASSERT_TRUE(parts) << parts.error().text();
    ASSERT_EQ(parts->size(), 1u);
    const pipeline::Mesh& mesh = (*parts)[0].mesh;
    EXPECT_FALSE((*parts)[0].had_normals);
    // The volume by the divergence theorem, once with the triangles' own normals, must be positive, and an
    // averaged normal must agree with its triangle nearly everywhere.
    std::size_t against = 0;
    double volume = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto vertex = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
        const glm::dvec3 a(vertex(0).position.v), b(vertex(1).position.v), c(vertex(2).position.v);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        volume += glm::dot(a, normal);
        for (std::size_t k = 0; k < 3; ++k)
            against += glm::dot(normal, glm::dvec3(vertex(k).normal.v)) <= 0 ? 1 : 0;
    }
    EXPECT_GT(volume, 0);
    EXPECT_LT(against, mesh.indices.size() / 1000);
    for (const pipeline::Vertex& vertex : mesh.vertices)
        EXPECT_NEAR(glm::length(glm::dvec3(vertex.normal.v)), 1, 1e-6);
}

}  // namespace
}  // namespace relevo::io
