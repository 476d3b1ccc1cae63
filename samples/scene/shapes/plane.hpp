// The square of edge 1 in the plane y = 0 round the origin, seen from above (+y).
#pragma once
#include "samples/scene/shapes/grid.hpp"

namespace relevo::scene {

// `across` segments along x and `away` along -z (1 to max_segments); the texture is repeated `repeat` times
// each way (more than 0).
inline pipeline::Result<Mesh> plane(int across, int away, double repeat) {
    if (across < 1 || across > max_segments || away < 1 || away > max_segments) return segments_error(1);
    if (!(repeat > 0)) return pipeline::Error{"repeat must be more than 0"};
    return grid_mesh(across, away, [=](int i, int j) {
        const glm::dvec2 uv{double(i) / across, double(j) / away};
        return make_vertex({uv.x - 0.5, 0, 0.5 - uv.y}, {0, 1, 0}, repeat * uv);
    });
}

}  // namespace relevo::scene
