// The sphere of radius 1 round the origin, as a globe: poles on the y axis, the texture wrapped once round it
// (u = 0 and 1 on the meridian of +x) and from pole to pole.
#pragma once
#include "samples/scene/shapes/grid.hpp"

namespace relevo::scene {

// (cos a cos b, sin b, -sin a cos b) with a = 360 u degrees and b = 180 v - 90 degrees.
// `around` 3 or more, `upwards` 2 or more segments, at most max_segments.
inline pipeline::Result<Mesh> sphere(int around, int upwards) {
    if (around < 3 || around > max_segments) return segments_error(3);
    if (upwards < 2 || upwards > max_segments) return segments_error(2);
    return grid_mesh(around, upwards, [=](int i, int j) {
        const pipeline::Degrees a = turn(i, around), b{180.0 * j / upwards - 90.0};
        const glm::dvec3 p{cos(a) * cos(b), sin(b), -sin(a) * cos(b)};
        return make_vertex(p, p, {double(i) / around, double(j) / upwards});
    });
}

}  // namespace relevo::scene
