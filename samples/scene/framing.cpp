#include "samples/scene/framing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace relevo::scene {
namespace {

// Float arithmetic with larger coordinates soon overflows; false for what is not a number, too.
bool is_in_range(glm::dvec3 p) {
    constexpr double largest = 1e30;
    return std::abs(p.x) <= largest && std::abs(p.y) <= largest && std::abs(p.z) <= largest;
}

template <class Visit>
void for_each_vertex(const std::vector<raster::Model>& models, Visit visit) {
    for (const raster::Model& model : models)
        for (const pipeline::Vertex& vertex : model.mesh->vertices) {
            const glm::dvec3 p = model.world_from_object.m * glm::dvec4(glm::dvec3(vertex.position.v), 1.0);
            if (is_in_range(p)) visit(p);
        }
}

}  // namespace

Bounds bounds_of(const std::vector<raster::Model>& models) {
    Bounds bounds;
    bool first = true;
    for_each_vertex(models, [&](glm::dvec3 p) {
        bounds = first ? Bounds{p, p} : Bounds{glm::min(bounds.low, p), glm::max(bounds.high, p)};
        first = false;
    });
    return bounds;
}

Axes axes_of(const pipeline::Affine<pipeline::Eye, pipeline::World>& eye_from_world) {
    const glm::dmat4& m = eye_from_world.m;
    return {{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {m[0][2], m[1][2], m[2][2]}};
}

// A vertex at (x, y, z) from the target is seen from distance d when |x| <= tan_x (d - z) and |y| <= tan_y (d
// - z).
double perspective_distance(const std::vector<raster::Model>& models, glm::dvec3 target, const Axes& axes,
                            double tan_x, double tan_y) {
    double distance = 0;
    for_each_vertex(models, [&](glm::dvec3 p) {
        const glm::dvec3 offset = p - target;
        const double sideways = std::max(std::abs(glm::dot(offset, axes.right)) / tan_x,
                                         std::abs(glm::dot(offset, axes.up)) / tan_y);
        distance = std::max(distance, glm::dot(offset, axes.backward) + sideways);
    });
    return distance > 0 ? 1.1 * distance : 1;
}

glm::dvec3 extent(const std::vector<raster::Model>& models, glm::dvec3 from, const Axes& axes) {
    glm::dvec3 out{0, 0, 0};
    for_each_vertex(models, [&](glm::dvec3 p) {
        const glm::dvec3 offset = p - from;
        out = glm::max(out, {std::abs(glm::dot(offset, axes.right)), std::abs(glm::dot(offset, axes.up)),
                             -glm::dot(offset, axes.backward)});
    });
    return out;
}

}  // namespace relevo::scene
