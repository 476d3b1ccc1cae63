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
              pipeline::exponent(material.shininess), camera.parallel},
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

// The numbers that a vertex carries to the faces that show their front or their back.
template <class Program>
std::array<Scalar, Program::size> varying_of(const ModelSetup& setup, const pipeline::Vertex& v, bool back) {
    ShadedVertex shaded{{0, 0, 0}, {0, 0, 0}, v.uv};
    if constexpr (Program::needs_eye) {
        shaded.position = (setup.eye_from_object * v.position).v;
        shaded.normal = pipeline::normalize((setup.normal_map * v.normal).v);
        if (back) shaded.normal = -shaded.normal;
    }
    return Program::corner(setup.surface, shaded);
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
