#include "relief/warp.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace relevo::relief {
namespace {

using glm::cross, glm::dot, glm::dvec3;
using pipeline::Error;

// c and D of the header, both times w: a viewer at infinity has them, too.
struct Sight {
    dvec3 f, c;
    double w, distance;  // c.f, that is h w
};
Result<Sight> sight(const ReliefCamera& camera, const Viewer& viewer) {
    if (auto error = refusal(camera)) return *std::move(error);
    const auto& t = viewer.place;
    if (!std::isfinite(t.x + t.y + t.z + t.w) || t.w < 0) return Error{"the viewer's place must be finite"};
    const dvec3 f = forward(camera), c = t.w * camera.corner - dvec3(t);
    const double distance = dot(c, f);
    if (!(distance > 0))
        return Error{
            "the viewer must lie in front of the relief's plane, not on it or behind: choose another "
            "face, or draw the geometry"};
    return Sight{f, c, t.w, distance};
}

constexpr double infinity = std::numeric_limits<double>::infinity();
double height(const Sight& s) { return s.w > 0 ? s.distance / s.w : infinity; }

}  // namespace

double height_of_source(const ReliefCamera& camera) {
    return camera.projection == Projection::Perspective ? dot(camera.corner - camera.eye, forward(camera))
                                                        : infinity;
}

Result<Warp> make_warp(const ReliefCamera& camera, const Viewer& viewer) {
    const auto found = sight(camera, viewer);
    if (!found) return found.error();
    const dvec3 &f = found->f, &c = found->c;
    const double w = found->w;
    const dvec3 &a = camera.a, &b = camera.b, ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
    const auto warp = [&](const dvec3& across, double k3) {
        return Warp{camera.projection, dot(across, bc) / dot(a, bc), dot(across, ca) / dot(b, ca), k3,
                    height(*found),    height_of_source(camera)};
    };
    if (camera.projection == Projection::Orthographic) return warp(f, w * dot(f, ab) / dot(c, ab));
    const dvec3 d = w * camera.eye - dvec3(viewer.place);
    // c has no part in d.(b x c): at infinity, where w d is all c, what is left of d is S - C
    return warp(w > 0 ? d / w : camera.eye - camera.corner, dot(d, ab) / dot(c, ab));
}

Result<Warp> make_warp_along_axes(const ReliefCamera& camera, const Viewer& viewer) {
    const auto found = sight(camera, viewer);
    if (!found) return found.error();
    const auto& [f, c, w, distance] = *found;
    const dvec3 &a = camera.a, &b = camera.b;
    if (std::abs(dot(a, b)) > 1e-9 * std::sqrt(dot(a, a) * dot(b, b)))
        return Error{"the axes of the relief texture are skewed: this form of the warp needs a.b = 0"};
    const double source_h = height_of_source(camera);
    if (camera.projection == Projection::Orthographic)
        return Warp{camera.projection,
                    -dot(c, a) / dot(a, a) / distance,
                    -dot(c, b) / dot(b, b) / distance,
                    w / distance,
                    height(*found),
                    source_h};
    // D = S - T = (S - C) + c, so k3 = 1 - H / h, and k1 a + k2 b = (S - C) + (H / h) c
    const dvec3 across = (camera.eye - camera.corner) + (source_h / distance) * c;
    return Warp{camera.projection,
                dot(across, a) / dot(a, a),
                dot(across, b) / dot(b, b),
                1 - source_h * w / distance,
                height(*found),
                source_h};
}

}  // namespace relevo::relief
