// Source cameras and viewers of every kind, for the laws of the warp.
#pragma once
#include "relief/warp.hpp"
#include "tests/support/hard.hpp"

namespace relevo::relief::random {

using tests::hard::Random;

inline glm::dvec3 place(Random& r, double reach = 2) {
    return {r.between(-reach, reach), r.between(-reach, reach), r.between(-reach, reach)};
}
inline double length(const glm::dvec3& v) { return std::sqrt(glm::dot(v, v)); }

inline ReliefCamera source(Random& r, Projection projection) {
    const SourceView view{place(r), place(r), static_cast<int>(r.integer(2, 300)),
                          static_cast<int>(r.integer(2, 300))};
    const auto camera = projection == Projection::Orthographic
                            ? orthographic_camera(view, place(r), r.between(0.1, 4))
                            : perspective_camera(view, place(r), r.between(0.2, 4), {r.between(5, 120)});
    return camera ? *camera : source(r, projection);
}

// In front of the plane, `h` from it, up to `aside` to its sides.
inline glm::dvec3 viewer_place(Random& r, const ReliefCamera& camera, double h, double aside) {
    const double u = r.between(0, camera.width), v = r.between(0, camera.height);
    const glm::dvec3 sideways = r.between(-aside, aside) * (camera.a / length(camera.a)) +
                                r.between(-aside, aside) * (camera.b / length(camera.b));
    return plane_point(camera, u, v) + sideways - h * forward(camera);
}

inline Displacement displacement(Random& r) { return {static_cast<Scalar>(r.between(0, 4))}; }
inline Disparity disparity(Random& r) { return {static_cast<Scalar>(r.between(0.05, 1))}; }

}  // namespace relevo::relief::random
