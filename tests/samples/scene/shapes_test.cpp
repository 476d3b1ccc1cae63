// The generated shapes: closed, outside out, with unit normals and the volumes of their formulas.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "samples/scene/shapes/cube.hpp"
#include "samples/scene/shapes/dice.hpp"
#include "samples/scene/shapes/plane.hpp"
#include "samples/scene/shapes/sphere.hpp"
#include "samples/scene/shapes/teapot.hpp"
#include "samples/scene/shapes/terrain.hpp"
#include "samples/scene/shapes/torus.hpp"

namespace relevo::scene {
namespace {

using Position = std::tuple<float, float, float>;
using Edge = std::pair<Position, Position>;

glm::dvec3 cross(glm::dvec3 a, glm::dvec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(glm::dvec3 a, glm::dvec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

const Vertex& corner(const Mesh& mesh, std::size_t triangle, std::size_t k) {
    return mesh.vertices[mesh.indices[3 * triangle + k]];
}
glm::dvec3 place(const Mesh& mesh, std::size_t triangle, std::size_t k) {
    return glm::dvec3(corner(mesh, triangle, k).position.v);
}

struct Census {
    double volume = 0;
    std::size_t open_edges = 0;      // not used in the opposite direction by another triangle
    std::size_t repeated_edges = 0;  // used twice in the same direction
    std::size_t wrong_side = 0;      // corners whose normal looks to the inside of their triangle
    double worst_length = 0;         // of a normal, as | length - 1 |
};

// Vertices in the same place count as one.
Census census(const Mesh& mesh) {
    Census out;
    std::map<Edge, int> edges;
    for (std::size_t t = 0; t < mesh.triangles(); ++t) {
        const glm::dvec3 a = place(mesh, t, 0), b = place(mesh, t, 1), c = place(mesh, t, 2);
        const glm::dvec3 normal = cross(b - a, c - a);
        out.volume += dot(a, cross(b, c)) / 6;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto key = [&](std::size_t i) {
                const auto& p = corner(mesh, t, i % 3).position.v;
                return Position(p.x + 0.0f, p.y + 0.0f, p.z + 0.0f);  // -0 is 0
            };
            ++edges[{key(k), key(k + 1)}];
            if (dot(glm::dvec3(corner(mesh, t, k).normal.v), normal) <= 0) ++out.wrong_side;
        }
    }
    for (const auto& [edge, count] : edges) {
        if (count > 1) ++out.repeated_edges;
        if (!edges.contains({edge.second, edge.first})) ++out.open_edges;
    }
    for (const Vertex& v : mesh.vertices) {
        const glm::dvec3 n(v.normal.v);
        const double error = std::abs(std::sqrt(dot(n, n)) - 1);
        out.worst_length = error <= out.worst_length ? out.worst_length : error;  // not-a-number stays
    }
    return out;
}

void expect_surface(const Mesh& mesh, std::size_t open_edges) {
    const Census found = census(mesh);
    EXPECT_EQ(found.open_edges, open_edges);
    EXPECT_EQ(found.repeated_edges, 0u);
    EXPECT_EQ(found.wrong_side, 0u);
    EXPECT_LE(found.worst_length, 1e-6);
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
}

void expect_uv_within(const Mesh& mesh, float u, float v) {
    for (const Vertex& vertex : mesh.vertices) {
        ASSERT_TRUE(vertex.uv.x >= 0 && vertex.uv.x <= u) << vertex.uv.x;
        ASSERT_TRUE(vertex.uv.y >= 0 && vertex.uv.y <= v) << vertex.uv.y;
    }
}

TEST(Cube, IsAClosedBoxOfVolumeOne) {
    const Mesh mesh = cube();
    EXPECT_EQ(mesh.vertices.size(), 24u);
    EXPECT_EQ(mesh.triangles(), 12u);
    expect_surface(mesh, 0);
    expect_uv_within(mesh, 1, 1);
    EXPECT_DOUBLE_EQ(census(mesh).volume, 1);
}

TEST(Dice, EveryFaceLooksAtItsOwnCell) {
    const Mesh mesh = dice();
    expect_surface(mesh, 0);
    std::set<std::pair<int, int>> cells;
    for (std::size_t face = 0; face < 6; ++face) {
        glm::dvec2 middle{0, 0};
        for (std::size_t k = 0; k < 4; ++k) middle += glm::dvec2(mesh.vertices[4 * face + k].uv) / 4.0;
        cells.insert({int(middle.x * 4), int(middle.y * 3)});
    }
    EXPECT_EQ(cells, (std::set<std::pair<int, int>>{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {2, 1}, {3, 1}}));
}

TEST(Dice,
     NeighboursInThePictureAreNeighboursOnTheDice) {  // folded as in the textbook: the strip goes round it
    const Mesh mesh = dice();
    for (std::size_t face = 0; face + 1 < 4; ++face) {
        const Vertex &lower_right = mesh.vertices[4 * face + 1],
                     &next_lower_left = mesh.vertices[4 * face + 4];
        EXPECT_EQ(lower_right.position.v, next_lower_left.position.v);
        EXPECT_EQ(lower_right.uv, next_lower_left.uv);
    }
    EXPECT_EQ(mesh.vertices[3].position.v,
              mesh.vertices[4 * 4].position.v);  // +z's upper left, +y's lower left
    EXPECT_EQ(mesh.vertices[3].uv, mesh.vertices[4 * 4].uv);
    EXPECT_EQ(mesh.vertices[0].position.v,
              mesh.vertices[4 * 5 + 3].position.v);  // +z's lower left, -y's upper left
    EXPECT_EQ(mesh.vertices[0].uv, mesh.vertices[4 * 5 + 3].uv);
}

TEST(Sphere, IsClosedAndHasTheVolumeOfTheFormula) {
    for (const auto& [around, upwards] : {std::pair(3, 2), {4, 3}, {7, 5}, {64, 32}, {201, 100}}) {
        const Mesh mesh = *sphere(around, upwards);
        expect_surface(mesh, 0);
        expect_uv_within(mesh, 1, 1);
        EXPECT_EQ(mesh.triangles(), std::size_t(2 * around * (upwards - 1)));
    }
    EXPECT_NEAR(census(*sphere(200, 100)).volume, 4 * pipeline::pi / 3, 4e-3);
}

TEST(Torus, IsClosedAndHasTheVolumeOfTheFormula) {
    for (const auto& [ring, round] : {std::pair(3, 3), {8, 5}, {64, 32}, {99, 51}}) {
        const Mesh mesh = *torus(ring, round, 0.45);
        const Census found = census(mesh);
        EXPECT_EQ(found.open_edges, 0u);
        EXPECT_EQ(found.repeated_edges, 0u);
        EXPECT_LE(found.worst_length, 1e-6);
        expect_uv_within(mesh, 6, 3);
    }
    expect_surface(*torus(64, 32, 0.45), 0);
    EXPECT_NEAR(census(*torus(200, 100, 0.45)).volume, 2 * pipeline::pi * pipeline::pi * 0.45 * 0.45, 6e-3);
}

TEST(Torus, IsTheSurfaceOfTheBenchmarks) {  // 100k triangles, its ring in the plane z = 0
    const Mesh mesh = *torus(316, 158, 0.45);
    EXPECT_EQ(mesh.triangles(), 2u * 316 * 158);
    EXPECT_EQ(mesh.vertices[0].position.v, pipeline::Vec3(1.45f, 0, 0));
    EXPECT_EQ(mesh.vertices[316].position.v, mesh.vertices[0].position.v);
    EXPECT_EQ(mesh.vertices[316].uv, pipeline::Vec2(6, 0));
    EXPECT_EQ(mesh.vertices[79].position.v, pipeline::Vec3(0, 1.45f, 0));  // a quarter of the way, to the bit
}

TEST(Plane, LooksUpwards) {
    const Mesh mesh = *plane(3, 4, 2);
    expect_surface(mesh, 2 * (3 + 4));
    expect_uv_within(mesh, 2, 2);
    EXPECT_EQ(mesh.vertices.front().position.v, pipeline::Vec3(-0.5, 0, 0.5));
    EXPECT_EQ(mesh.vertices.back().position.v, pipeline::Vec3(0.5, 0, -0.5));
}

TEST(Terrain, StaysWithinItsHeightAndLooksUpwards) {
    for (const std::uint32_t seed : {0u, 1u, 7u, 1'000'000u}) {
        const Mesh mesh = *terrain(40, 30, 0.25, seed);
        expect_surface(mesh, 2 * (40 + 30));
        expect_uv_within(mesh, 1, 1);
        float low = 1, high = 0;
        for (const Vertex& v : mesh.vertices)
            low = std::min(low, v.position.v.y), high = std::max(high, v.position.v.y);
        EXPECT_GE(low, 0);
        EXPECT_LE(high, 0.25);
        EXPECT_GT(high - low, 0.02) << "flat";
    }
}

TEST(Terrain, IsAnotherOneForAnotherSeedAndTheSameForTheSame) {
    EXPECT_EQ(terrain_height(0.1, 0.2, 3), terrain_height(0.1, 0.2, 3));
    EXPECT_NE(terrain_height(0.1, 0.2, 3), terrain_height(0.1, 0.2, 4));
}

TEST(Terrain, NoiseIsContinuousAcrossLatticeLines) {
    for (const double x : {-2.0, 0.0, 5.0})
        EXPECT_NEAR(value_noise(x - 1e-9, 0.3, 1), value_noise(x + 1e-9, 0.3, 1), 1e-7);
}

TEST(Teapot, HasNewells32Patches) {
    int patches = 0;
    for (const ControlNet& net :
         {revolve(teapot_body), revolve(teapot_lid), mirror(teapot_handle), mirror(teapot_spout)}) {
        EXPECT_EQ(net.points.size(), std::size_t((3 * net.along + 1) * (3 * net.round + 1)));
        patches += net.along * net.round;
    }
    EXPECT_EQ(patches, 32);
}

TEST(Teapot, StandsOnTheGroundWithItsSpoutTowardsX) {
    glm::dvec3 low{9, 9, 9}, high{-9, -9, -9};
    const Mesh mesh = *teapot(10);
    for (const Vertex& v : mesh.vertices)
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], double(v.position.v[k]));
            high[k] = std::max(high[k], double(v.position.v[k]));
        }
    EXPECT_EQ(low.y, 0);
    EXPECT_NEAR(high.y, 3.15, 1e-6);
    EXPECT_NEAR(low.x, -3, 0.02);
    EXPECT_NEAR(high.x, 3.4345, 0.01);
    EXPECT_NEAR(high.z, 2, 0.01);
    EXPECT_EQ(low.z, -high.z);
}

// Body and lid are open at their upper and lower rim, handle and spout at both ends; the tubes of each part
// are closed.
TEST(Teapot, IsClosedButForItsRims) {
    for (const int n : {2, 3, 10}) {
        const std::pair<ControlNet, int> parts[] = {{revolve(teapot_body), 4 * n},
                                                    {revolve(teapot_lid), 4 * n},
                                                    {mirror(teapot_handle), 4 * n},
                                                    {mirror(teapot_spout), 4 * n}};
        for (const auto& [net, open] : parts) {
            const Census found = census(tessellate(net, n));
            EXPECT_EQ(found.open_edges, std::size_t(open));
            EXPECT_EQ(found.repeated_edges, 0u);
            EXPECT_LE(found.worst_length, 1e-6);
            EXPECT_GT(found.volume, 0);
        }
    }
    const Census whole = census(*teapot(10));
    EXPECT_EQ(whole.wrong_side, 0u);
    EXPECT_EQ(whole.repeated_edges, 0u);
}

TEST(Teapot, NormalsAtTheTipAndTheBottomLookAlongTheAxis) {
    const SurfacePoint tip = evaluate(revolve(teapot_lid), 0, 2, 0, 0.3);
    EXPECT_NEAR(tip.position.z, 3.15, 1e-15);
    EXPECT_NEAR(tip.normal.z, 1, 1e-12);
    const SurfacePoint bottom = evaluate(revolve(teapot_body), 3, 1, 1, 0.7);
    EXPECT_EQ(bottom.position, glm::dvec3(0, 0, 0));
    EXPECT_NEAR(bottom.normal.z, -1, 1e-12);
}

TEST(Teapot, NormalsOfNeighbouringPatchesAgree) {  // the surface has no crease where two rows of patches meet
    const ControlNet nets[] = {revolve(teapot_body), revolve(teapot_lid), mirror(teapot_handle),
                               mirror(teapot_spout)};
    for (const ControlNet& net : nets)
        for (int row = 0; row + 1 < net.along; ++row)
            for (const double t : {0.1, 0.5, 0.8}) {
                const SurfacePoint above = evaluate(net, row, 0, 1, t),
                                   below = evaluate(net, row + 1, 0, 0, t);
                EXPECT_EQ(above.position, below.position);
                EXPECT_GT(dot(above.normal, below.normal), 0.9995) << row;
            }
}

TEST(Shapes, RefuseDegenerateParameters) {
    EXPECT_EQ(sphere(2, 2).error().message, "segments must be 3 to 2048");
    EXPECT_EQ(sphere(3, 1).error().message, "segments must be 2 to 2048");
    EXPECT_FALSE(sphere(3, max_segments + 1));
    EXPECT_FALSE(torus(2, 3, 0.5));
    EXPECT_FALSE(torus(3, -1, 0.5));
    EXPECT_EQ(torus(3, 3, 0).error().message, "tube must be more than 0 and less than 1");
    EXPECT_FALSE(torus(3, 3, 1));
    EXPECT_FALSE(torus(3, 3, std::nan("")));
    EXPECT_FALSE(plane(0, 1, 1));
    EXPECT_FALSE(plane(1, 1, 0));
    EXPECT_FALSE(terrain(0, 1, 1, 1));
    EXPECT_FALSE(terrain(1, 1, -1, 1));
    EXPECT_EQ(teapot(1).error().message, "segments must be 2 to 64");
    EXPECT_FALSE(teapot(65));
}

}  // namespace
}  // namespace relevo::scene
