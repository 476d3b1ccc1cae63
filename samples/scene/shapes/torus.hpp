// The torus round the z axis: a tube of radius r whose middle is the circle of radius 1 in the plane z = 0.
// The texture goes 6 times round the ring and 3 times round the tube.
#pragma once
#include "samples/scene/shapes/grid.hpp"

namespace relevo::scene {

// ((1 + r cos b) cos a, (1 + r cos b) sin a, r sin b) with a = 360 u and b = 360 v degrees.
// `ring`, `round` segments: 3 or more; `tube` = r, more than 0 and less than 1.
inline Mesh torus_mesh(int ring, int round, double tube) {
    return grid_mesh(ring, round, [=](int i, int j) {
        const pipeline::Degrees a = turn(i, ring), b = turn(j, round);
        const glm::dvec3 n{cos(b) * cos(a), cos(b) * sin(a), sin(b)};
        const double across = 1 + tube * cos(b);
        return make_vertex({across * cos(a), across * sin(a), tube * sin(b)}, n,
                           {6.0 * i / ring, 3.0 * j / round});
    });
}

// That, if the segments are at most max_segments and all the rest is as it must be.
inline pipeline::Result<Mesh> torus(int ring, int round, double tube) {
    if (ring < 3 || ring > max_segments || round < 3 || round > max_segments) return segments_error(3);
    if (!(tube > 0 && tube < 1)) return pipeline::Error{"tube must be more than 0 and less than 1"};
    return torus_mesh(ring, round, tube);
}

}  // namespace relevo::scene
