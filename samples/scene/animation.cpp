#include "samples/scene/animation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/elementary.hpp"
#include "pipeline/transform.hpp"

namespace relevo::scene {
namespace {

constexpr std::string_view known_keys[] = {"type", "target", "radius", "elevation",
                                           "from", "to",     "frames", "eyes"};
constexpr Range steepness{-90, 90, true, true, "more than -90 and less than 90 degrees"};
constexpr Range turns{-36000, 36000, false, false, "-36000 to 36000 degrees"};

// A key that the type does not read would be silently without effect.
void refuse_keys_of_others(const Fields& fields, Animation::Kind kind) {
    const auto belongs = [&](std::string_view key, Animation::Kind owner, std::string_view owner_name) {
        if (kind != owner && fields.has(key))
            fields.diagnosis().say(fields.place(key),
                                   fmt::format("{} is for type = \"{}\" only", fields.full(key), owner_name));
    };
    for (const std::string_view key : {"radius", "elevation", "from", "to"})
        belongs(key, Animation::Kind::Orbit, "orbit");
    belongs("eyes", Animation::Kind::Path, "path");
}

std::vector<glm::dvec3> read_eyes(const Fields& fields) {
    constexpr std::string_view accepted = "a list of two or more places [x, y, z]";
    std::vector<glm::dvec3> eyes;
    const Value* value = fields.find("eyes");
    const auto* list = value ? std::get_if<std::vector<Value>>(&value->data) : nullptr;
    if (!list || list->size() < 2) return fields.refuse("eyes", accepted), eyes;
    constexpr Range ranges[] = {any_number, any_number, any_number};
    for (std::size_t i = 0; i < list->size(); ++i) {
        const std::vector<double> n = fields.numbers((*list)[i], fmt::format("eyes[{}]", i), ranges);
        eyes.push_back({n[0], n[1], n[2]});
    }
    return eyes;
}

}  // namespace

Animation read_animation(const Value& table, SceneCamera& camera, Diagnosis& diagnosis) {
    const Fields fields(table, "animation", known_keys, diagnosis);
    CameraDescription& seen = camera.description;
    Animation out;
    out.kind = fields.choice("type", out.kind, animation_types);
    refuse_keys_of_others(fields, out.kind);
    out.target = fields.triple("target", seen.target);
    out.frames = fields.whole("frames", out.frames, 1, max_frames);
    if (out.kind == Animation::Kind::Orbit) {
        out.radius = fields.number("radius", glm::length(seen.eye - out.target), positive);
        out.elevation = fields.number("elevation", 0, steepness);
        out.from = fields.number("from", 0, turns);
        out.to = fields.number("to", out.from + 360, turns);
    } else {
        out.eyes = read_eyes(fields);
    }
    if (!diagnosis.fine()) return out;
    for (int frame = out.frames - 1; frame >= 0; --frame) {
        const auto view = pipeline::look_at(eye_at(out, frame), out.target, seen.up);
        if (!view) {
            diagnosis.say(fields.place(""),
                          fmt::format("animation: frame {}: {}", frame, view.error().message));
            return out;
        }
        camera.camera.eye_from_world = *view;
    }
    seen.eye = eye_at(out, 0), seen.target = out.target;
    return out;
}

glm::dvec3 eye_at(const Animation& animation, int frame) {
    using pipeline::Degrees;
    const int last = animation.frames - 1;
    if (animation.kind == Animation::Kind::Path) {
        const double place =
            last == 0 ? 0 : double(frame) / last * static_cast<double>(animation.eyes.size() - 1);
        const auto i = std::min(static_cast<std::size_t>(place), animation.eyes.size() - 2);
        return glm::mix(animation.eyes[i], animation.eyes[i + 1], place - static_cast<double>(i));
    }
    const double span = animation.to - animation.from;
    const bool whole = span != 0 && std::fmod(span, 360) == 0;
    const double share = whole ? double(frame) / animation.frames : last == 0 ? 0 : double(frame) / last;
    const Degrees azimuth{animation.from + share * span}, elevation{animation.elevation};
    return animation.target + animation.radius * glm::dvec3(sin(azimuth) * cos(elevation), sin(elevation),
                                                            cos(azimuth) * cos(elevation));
}

raster::Camera camera_at(const LoadedScene& scene, int frame) {
    raster::Camera camera = scene.scene.camera;
    if (scene.animation)
        camera.eye_from_world =
            *pipeline::look_at(eye_at(*scene.animation, frame), scene.animation->target, scene.camera.up);
    return camera;
}

}  // namespace relevo::scene
