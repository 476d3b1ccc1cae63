// A surface over a rectangle of parameters as a mesh: what most generated shapes are made of.
#pragma once
#include <cstdint>
#include <string>

#include "pipeline/elementary.hpp"
#include "pipeline/mesh.hpp"
#include "pipeline/result.hpp"

namespace relevo::scene {

using pipeline::Mesh;
using pipeline::Vertex;

// Most segments a side of one surface: 8 million triangles, 140 MiB.
inline constexpr int max_segments = 2048;

inline pipeline::Result<Mesh> segments_error(int low, int high = max_segments) {
    return pipeline::Error{"segments must be " + std::to_string(low) + " to " + std::to_string(high)};
}

inline Vertex make_vertex(glm::dvec3 position, glm::dvec3 normal, glm::dvec2 uv) {
    return {{pipeline::Vec3(position)}, {pipeline::Vec3(normal)}, pipeline::Vec2(uv)};
}

// vertex_at(i, j) for i = 0..columns and j = 0..rows; seen from outside, i runs to the right and j upwards. A
// cell is cut into two triangles along its rising diagonal; a triangle with two corners in one place (at a
// pole) is left out.
template <class VertexAt>
Mesh grid_mesh(int columns, int rows, VertexAt vertex_at) {
    Mesh mesh;
    mesh.vertices.reserve(std::size_t(columns + 1) * std::size_t(rows + 1));
    mesh.indices.reserve(std::size_t(columns) * std::size_t(rows) * 6);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) mesh.vertices.push_back(vertex_at(i, j));
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto& v = mesh.vertices;
        const auto same = [&](std::uint32_t p, std::uint32_t q) {
            return v[p].position.v == v[q].position.v;
        };
        if (!same(a, b) && !same(b, c) && !same(c, a)) mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (columns + 1) + i), b = a + 1,
                       d = a + static_cast<std::uint32_t>(columns) + 1, c = d + 1;
            triangle(a, b, c);
            triangle(a, c, d);
        }
    return mesh;
}

// The angle of step i of n round a circle; the last step is the first one again, to the bit.
inline pipeline::Degrees turn(int i, int n) { return {360.0 * (i % n) / n}; }

}  // namespace relevo::scene
