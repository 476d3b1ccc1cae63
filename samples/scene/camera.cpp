#include "samples/scene/camera.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"
#include "samples/scene/framing.hpp"

namespace relevo::scene {
namespace {

using Kind = CameraDescription::Kind;
using View = pipeline::Affine<pipeline::Eye, pipeline::World>;
using Projection = pipeline::Projective<pipeline::Clip, pipeline::Eye>;
using Models = std::vector<raster::Model>;

constexpr std::string_view known_keys[] = {"projection", "eye",   "target", "up",  "fov_y", "height",
                                           "left",       "right", "bottom", "top", "near",  "far"};

constexpr Range angle_of_view{0, 180, true, true, "more than 0 and less than 180 degrees"};
constexpr Range beyond_near{0, std::numeric_limits<double>::infinity(), true, false,
                            "more than near, or inf"};

// A key that the projection does not read would be silently without effect.
void refuse_keys_of_others(const Fields& fields, Kind kind) {
    const auto belongs = [&](std::string_view key, Kind owner, std::string_view owner_name) {
        if (kind != owner && fields.has(key))
            fields.diagnosis().say(fields.place(key), fmt::format("{} is for projection = \"{}\" only",
                                                                  fields.full(key), owner_name));
    };
    belongs("fov_y", Kind::Perspective, "perspective");
    belongs("height", Kind::Orthographic, "orthographic");
    for (const std::string_view side : {"left", "right", "bottom", "top"})
        belongs(side, Kind::Frustum, "frustum");
}

double half_angle_tangent(double degrees) { return pipeline::tan(pipeline::Degrees{degrees / 2}); }

// Axes of an eye that looks from the pleasant direction; unusable when `up` is parallel to it: then the
// caller says so.
Axes pleasant_axes(const CameraDescription& d) {
    const auto view = pipeline::look_at(d.target + pleasant_direction, d.target, d.up);
    return view ? axes_of(*view) : Axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

double framing_distance(const CameraDescription& d, double aspect, const Models& models) {
    const Axes axes = pleasant_axes(d);
    if (d.kind == Kind::Perspective) {
        const double tan_y = half_angle_tangent(d.fov_y);
        return perspective_distance(models, d.target, axes, tan_y * aspect, tan_y);
    }
    if (d.kind == Kind::Frustum && d.right > d.left && d.top > d.bottom && d.near > 0)
        return perspective_distance(models, d.target, axes, (d.right - d.left) / (2 * d.near),
                                    (d.top - d.bottom) / (2 * d.near));
    const glm::dvec3 size = extent(models, d.target, axes);
    const double radius = glm::length(glm::dvec3(size.x, size.y, size.z));
    return radius > 0 ? 2 * radius : 1;
}

void read_window(const Fields& fields, CameraDescription& d) {
    if (d.kind != Kind::Frustum) return;
    for (const std::string_view key : {"left", "right", "bottom", "top", "near"})
        if (!fields.has(key)) fields.refuse(key, "a frustum needs left, right, bottom, top and near");
    d.left = fields.number("left", -1);
    d.right = fields.number("right", 1);
    d.bottom = fields.number("bottom", -1);
    d.top = fields.number("top", 1);
    if (fields.diagnosis().fine() && !(d.left < d.right))
        fields.refuse("left", fmt::format("less than camera.right, which is {}", describe(d.right)));
    if (fields.diagnosis().fine() && !(d.bottom < d.top))
        fields.refuse("bottom", fmt::format("less than camera.top, which is {}", describe(d.top)));
}

void read_eye(const Fields& fields, CameraDescription& d, double aspect, const Models& models) {
    d.up = fields.triple("up", {0, 1, 0});
    d.target = fields.triple("target", bounds_of(models).center());
    d.framed = !fields.has("eye");
    const glm::dvec3 direction = glm::normalize(pleasant_direction);
    const glm::dvec3 framed =
        d.framed ? d.target + direction * framing_distance(d, aspect, models) : glm::dvec3(0, 0, 0);
    d.eye = fields.triple("eye", framed);
}

View read_view(const Fields& fields, const CameraDescription& d) {
    const auto view = pipeline::look_at(d.eye, d.target, d.up);
    if (view) return *view;
    const bool same_point = d.eye == d.target;
    std::string_view key = "up";
    if (same_point || !fields.has("up"))
        key = fields.has("eye") ? "eye" : fields.has("target") ? "target" : "up";
    fields.diagnosis().say(fields.place(key), "camera: " + view.error().message);
    return {};
}

// The sizes that follow from where the eye is: the height of an orthographic view and the two planes.
void read_planes(const Fields& fields, const View& view, CameraDescription& d, double aspect,
                 const Models& models) {
    const bool parallel = d.kind == Kind::Orthographic;
    const glm::dvec3 seen = parallel ? extent(models, d.eye, axes_of(view)) : glm::dvec3(0, 0, 0);
    const double framed_height = 2.2 * std::max(seen.y, seen.x / aspect);
    d.height = fields.number("height", framed_height > 0 ? framed_height : 2, positive);
    const double default_near = parallel ? 0 : glm::length(d.target - d.eye) / 100;
    d.near = fields.number("near", default_near, parallel ? any_number : positive);
    const double behind_all = std::max(1.01 * seen.z, d.near + 1);
    d.far = parallel ? fields.number("far", behind_all)
                     : fields.number("far", std::numeric_limits<double>::infinity(), beyond_near);
    if (!fields.diagnosis().fine() || d.near < d.far) return;
    if (fields.has("near"))
        fields.refuse("near", fmt::format("less than camera.far, which is {}", describe(d.far)));
    fields.refuse("far", fmt::format("more than camera.near, which is {}", describe(d.near)));
}

Projection make_projection(const Fields& fields, const CameraDescription& d, double aspect,
                           pipeline::DepthRange range) {
    const auto made = [&] {
        if (d.kind == Kind::Perspective)
            return pipeline::perspective(pipeline::Degrees{d.fov_y}, aspect, d.near, d.far, range);
        if (d.kind == Kind::Frustum)
            return pipeline::frustum(d.left, d.right, d.bottom, d.top, d.near, d.far, range);
        const double y = d.height / 2, x = y * aspect;
        return pipeline::orthographic(-x, x, -y, y, d.near, d.far, range);
    }();
    if (made) return *made;
    fields.diagnosis().say(fields.place(""), "camera: " + made.error().message);
    return {};
}

}  // namespace

SceneCamera read_camera(const Value& table, double aspect, raster::DepthFormat depth, const Models& models,
                        Diagnosis& diagnosis) {
    const Fields fields(table, "camera", known_keys, diagnosis);
    SceneCamera out;
    CameraDescription& d = out.description;
    d.kind = fields.choice("projection", Kind::Perspective, projections);
    refuse_keys_of_others(fields, d.kind);
    d.fov_y = fields.number("fov_y", 40, angle_of_view);
    d.near = fields.number("near", 0.1);
    read_window(fields, d);
    read_eye(fields, d, aspect, models);
    out.camera.eye_from_world = read_view(fields, d);
    read_planes(fields, out.camera.eye_from_world, d, aspect, models);
    if (!diagnosis.fine()) return out;
    const bool reversed = depth == raster::DepthFormat::Float32Reversed;
    out.camera.clip_from_eye = make_projection(
        fields, d, aspect, reversed ? pipeline::DepthRange::Reversed : pipeline::DepthRange::Forward);
    out.camera.parallel = d.kind == Kind::Orthographic;
    return out;
}

glm::dvec3 lamp_position(const SceneCamera& camera) {
    const CameraDescription& d = camera.description;
    const Axes axes = axes_of(camera.camera.eye_from_world);
    return d.eye + glm::length(d.target - d.eye) * (0.5 * axes.right + 0.7 * axes.up + 0.2 * axes.backward);
}

}  // namespace relevo::scene
