// A mesh of triangles with shared corners: what the readers and generators make and the machine draws.
#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/space.hpp"

namespace relevo::pipeline {

struct Vertex {
    Point<Object> position;
    Normal<Object> normal;  // any length; zero where there is none
    Vec2 uv{0, 0};          // (0, 0) is the lower-left corner of the texture
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t>
        indices;  // three a triangle, counter-clockwise seen from outside, all < vertices.size()

    std::size_t triangles() const { return indices.size() / 3; }
};

}  // namespace relevo::pipeline
