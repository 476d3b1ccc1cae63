// Where to put a camera and a lamp when the scene does not say.
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "raster/scene.hpp"

namespace relevo::scene {

// The box, along the axes of the world, round all vertices up to 1e30; a point at the origin when there are
// none.
struct Bounds {
    glm::dvec3 low{0, 0, 0}, high{0, 0, 0};
    glm::dvec3 center() const { return low + (high - low) * 0.5; }
};
Bounds bounds_of(const std::vector<raster::Model>& models);

// From the target towards an eye that looks from the front, the right and above. Any length.
inline constexpr glm::dvec3 pleasant_direction{0.55, 0.5, 1.0};

// How the eye's axes lie in the world; unit vectors.
struct Axes {
    glm::dvec3 right, up, backward;
};
Axes axes_of(const pipeline::Affine<pipeline::Eye, pipeline::World>& eye_from_world);

// How far behind `target`, along `axes.backward`, a perspective eye sees every vertex, with a margin of a
// tenth. tan_x and tan_y are the tangents of half the angles of view. 1 when all vertices lie in the target.
double perspective_distance(const std::vector<raster::Model>& models, glm::dvec3 target, const Axes& axes,
                            double tan_x, double tan_y);

// The extent of all vertices along the eye's axes, seen from `from`: half the size across (x, y), and in z
// the greatest distance in front.
glm::dvec3 extent(const std::vector<raster::Model>& models, glm::dvec3 from, const Axes& axes);

}  // namespace relevo::scene
