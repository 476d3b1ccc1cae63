// What the machine derives once from a model, its camera and the settings: maps, surface, which sides are
// lit.
#pragma once
#include <span>
#include <vector>

#include "pipeline/light.hpp"
#include "pipeline/transform.hpp"
#include "raster/scene.hpp"
#include "raster/shading.hpp"

namespace relevo::raster {

using pipeline::row_times_direction;
using pipeline::row_times_point;
using pipeline::Vec2Of;
using pipeline::Vec3Of;

struct ModelSetup {
    Surface surface;
    bool both_sides;  // back faces are drawn and lit by their own normals
    bool mirrored;    // the way to the eye turns windings around
    pipeline::RoundedAffine<pipeline::Eye, pipeline::Object> eye_from_object;
    pipeline::RoundedProjective<pipeline::Clip, pipeline::Object> clip_from_object;
    pipeline::NormalMap<pipeline::Eye, pipeline::Object> normal_map;
};

inline ModelSetup make_setup(const Camera& camera, const Model& model,
                             std::span<const pipeline::EyeLight> lights, const Settings& settings) {
    const auto eye_from_object = camera.eye_from_world * model.world_from_object;
    const pipeline::Material& material = model.material;
    return {{{lights, material.ambient, material.diffuse, material.specular,
              pipeline::exponent(material.shininess), camera.parallel, pipeline::are_grey(lights)},
             material.color,
             model.texture,
             settings.texture_filter,
             model.two_sided},
            model.two_sided && settings.cull != pipeline::Cull::Back,
            pipeline::is_mirrored(eye_from_object.m),
            pipeline::rounded(eye_from_object),
            pipeline::rounded(camera.clip_from_eye * eye_from_object),
            pipeline::normal_map(eye_from_object)};
}

inline std::vector<pipeline::EyeLight> lights_in_eye_space(const Scene& scene) {
    const auto eye_from_world = pipeline::rounded(scene.camera.eye_from_world);
    std::vector<pipeline::EyeLight> lights;
    for (const pipeline::Light& light : scene.lights)
        lights.push_back(pipeline::to_eye(light, eye_from_world));
    return lights;
}

// Rows of a map times the point or direction of each lane.
template <class Real, class Rows>
Vec3Of<Real> moved_point(const Rows& row, const Vec3Of<Real>& p) {
    return {row_times_point(row[0], p), row_times_point(row[1], p), row_times_point(row[2], p)};
}
template <class Real, class Rows>
Vec3Of<Real> moved_direction(const Rows& row, const Vec3Of<Real>& d) {
    return {row_times_direction(row[0], d), row_times_direction(row[1], d), row_times_direction(row[2], d)};
}

// The numbers that a vertex, given in object space, carries to the faces that show their front or their back.
template <class Program, class Real>
std::array<Real, Program::size> varying_of(const ModelSetup& setup, const Vec3Of<Real>& position,
                                           const Vec3Of<Real>& normal, const Vec2Of<Real>& uv, bool back) {
    ShadedVertexOf<Real> shaded{{0, 0, 0}, {0, 0, 0}, uv};
    if constexpr (Program::needs_eye) {
        shaded.position = moved_point<Real>(setup.eye_from_object.row, position);
        shaded.normal = pipeline::normalize<Real>(moved_direction<Real>(setup.normal_map.row, normal));
        if (back) shaded.normal = -shaded.normal;
    }
    return Program::template corner<Real>(setup.surface, shaded);
}
template <class Program>
std::array<Scalar, Program::size> varying_of(const ModelSetup& setup, const pipeline::Vertex& v, bool back) {
    return varying_of<Program, Scalar>(setup, v.position.v, v.normal.v, v.uv, back);
}

// Calls visit(Program{}) with the program of a shading, textured or not.
template <class Visit>
void with_program(Shading shading, bool textured, Visit&& visit) {
    const auto pick = [&]<template <bool> class Program>() {
        textured ? visit(Program<true>{}) : visit(Program<false>{});
    };
    switch (shading) {
        case Shading::Unlit:
            return pick.template operator()<Unlit>();
        case Shading::Flat:
            return pick.template operator()<Flat>();
        case Shading::Gouraud:
            return pick.template operator()<Gouraud>();
        case Shading::Phong:
            return pick.template operator()<Phong>();
    }
}

}  // namespace relevo::raster
