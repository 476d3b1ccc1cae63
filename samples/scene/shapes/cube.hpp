// The cube of edge 1 round the origin. Every face has four vertices of its own, with its normal, and shows
// the whole texture upright as seen from outside (the top with -z up, the bottom with +z up).
//
// Source: textbook, section 2.4 (there with a corner in the origin, and without normals).
#pragma once
#include "samples/scene/shapes/grid.hpp"

namespace relevo::scene {

struct CubeFace {
    glm::dvec3 normal, right, up;  // as seen from outside; right x up = normal
};
inline constexpr CubeFace cube_faces[6] = {
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},   {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
    {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},  {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
};

// uv_of(face, corner) with corner in [0, 1]^2 from the lower-left one of face 0..5.
template <class UvOf>
Mesh cube_mesh(UvOf uv_of) {
    Mesh mesh;
    for (int f = 0; f < 6; ++f) {
        const CubeFace& face = cube_faces[f];
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const glm::dvec2 corner :
             {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)}) {
            const glm::dvec3 across = (corner.x - 0.5) * face.right + (corner.y - 0.5) * face.up;
            mesh.vertices.push_back(make_vertex(0.5 * face.normal + across, face.normal, uv_of(f, corner)));
        }
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + corner);
    }
    return mesh;
}

inline Mesh cube() {
    return cube_mesh([](int, glm::dvec2 corner) { return corner; });
}

}  // namespace relevo::scene
