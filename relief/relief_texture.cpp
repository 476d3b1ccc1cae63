#include "relief/relief_texture.hpp"

#include <cmath>
#include <string>

namespace relevo::relief {
namespace {

using pipeline::Error;

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
double length(const glm::dvec3& v) { return std::sqrt(glm::dot(v, v)); }

template <class Pixel>
bool has_size_of(const ReliefCamera& camera, const Image<Pixel>& image) {
    return image.width() == camera.width && image.height() == camera.height;
}

const char* wrong_depth(Projection projection, Scalar depth) {
    if (!std::isfinite(depth)) return "its depth is not a finite number";
    if (projection == Projection::Orthographic)
        return depth >= 0 ? nullptr : "its displacement is negative: the surface lies behind the plane";
    return depth > 0 && depth <= 1 ? nullptr : "its disparity is outside 0 < q <= 1";
}

struct Axes {
    glm::dvec3 right, down, forward;
};
Result<Axes> axes(const SourceView& view) {
    const glm::dvec3 across = glm::cross(view.toward, view.up);
    if (!is_finite(across) || !(length(across) > 1e-9 * length(view.toward) * length(view.up)))
        return Error{"the direction of sight and up must be finite, not zero and not parallel"};
    const glm::dvec3 f = view.toward / length(view.toward), right = across / length(across);
    return Axes{right, glm::cross(f, right), f};
}

Result<ReliefCamera> checked(const ReliefCamera& camera) {
    if (const auto error = refusal(camera)) return *error;
    return camera;
}

// The plane of a view, its middle at `center`.
ReliefCamera around(const SourceView& view, const Axes& axes, const glm::dvec3& center, double extent) {
    const double step = extent / view.height;
    ReliefCamera camera;
    camera.a = step * axes.right, camera.b = step * axes.down;
    camera.width = view.width, camera.height = view.height;
    camera.corner = center - (0.5 * view.width * camera.a + 0.5 * view.height * camera.b);
    return camera;
}

}  // namespace

std::optional<Error> refusal(const ReliefCamera& camera) {
    constexpr int most = pipeline::max_picture_size;
    if (camera.width < 1 || camera.height < 1 || camera.width > most || camera.height > most)
        return Error{"a relief texture has 1 to " + std::to_string(most) + " texels a side, not " +
                     std::to_string(camera.width) + " x " + std::to_string(camera.height)};
    if (!is_finite(camera.corner) || !is_finite(camera.a) || !is_finite(camera.b) || !is_finite(camera.eye))
        return Error{"the camera of a relief texture must be made of finite numbers"};
    const double area = length(glm::cross(camera.a, camera.b));
    if (!(area > 1e-9 * length(camera.a) * length(camera.b)) || !std::isfinite(area))
        return Error{"the axes of a relief texture must be neither zero nor parallel"};
    if (camera.projection == Projection::Perspective &&
        !(glm::dot(camera.corner - camera.eye, forward(camera)) > 0))
        return Error{"the eye of a perspective source must lie in front of its plane"};
    return {};
}

std::optional<Error> refusal(const ReliefTexture& texture) {
    const ReliefCamera& camera = texture.camera;
    if (const auto error = refusal(camera)) return error;
    if (!has_size_of(camera, texture.color) || !has_size_of(camera, texture.normal) ||
        !has_size_of(camera, texture.depth) || !has_size_of(camera, texture.coverage))
        return Error{"every channel of a relief texture must have the size of its camera"};
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            if (texture.coverage.at(x, y) == 0) continue;
            if (const char* wrong = wrong_depth(camera.projection, texture.depth.at(x, y)))
                return Error{"texel (" + std::to_string(x) + ", " + std::to_string(y) + "): " + wrong};
        }
    return {};
}

Result<ReliefCamera> orthographic_camera(const SourceView& view, glm::dvec3 center, double extent) {
    if (!(extent > 0) || !std::isfinite(extent)) return Error{"the extent of a source must be more than 0"};
    const auto directions = axes(view);
    if (!directions) return directions.error();
    return checked(around(view, *directions, center, extent));
}

Result<ReliefCamera> perspective_camera(const SourceView& view, glm::dvec3 eye, double distance,
                                        pipeline::Degrees fov_y) {
    if (!(fov_y.value > 0 && fov_y.value < 180))
        return Error{"the angle of view of a source must be more than 0 and less than 180 degrees"};
    if (!(distance > 0) || !std::isfinite(distance))
        return Error{"the plane of a perspective source must lie in front of its eye"};
    const auto directions = axes(view);
    if (!directions) return directions.error();
    const double extent = 2 * distance * pipeline::tan({fov_y.value / 2});
    ReliefCamera camera = around(view, *directions, eye + distance * directions->forward, extent);
    camera.projection = Projection::Perspective, camera.eye = eye;
    return checked(camera);
}

}  // namespace relevo::relief
