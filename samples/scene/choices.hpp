// The words that [pipeline] and other keys of a scene accept, what they mean, and a sentence for each: the
// reader of scenes and `relevo list` use the same tables.
#pragma once
#include <string_view>

#include "raster/scene.hpp"
#include "samples/scene/scene.hpp"

namespace relevo::scene {

template <class Meaning>
struct Choice {
    std::string_view name;
    Meaning meaning;
    std::string_view sentence;
};

inline constexpr Choice<raster::Shading> shadings[] = {
    {"unlit", raster::Shading::Unlit, "the surface's own colour, no light"},
    {"flat", raster::Shading::Flat, "one light equation a face"},
    {"gouraud", raster::Shading::Gouraud,
     "one light equation a corner, the colours interpolated (Gouraud 1971)"},
    {"phong", raster::Shading::Phong, "one light equation a pixel, the normals interpolated (Phong 1975)"},
};

inline constexpr Choice<raster::Filter> texture_filters[] = {
    {"nearest", raster::Filter::Nearest, "the texel that holds the point"},
    {"bilinear", raster::Filter::Bilinear, "the four nearest texels, weighted in steps of 1/256"},
};

inline constexpr Choice<raster::DepthFormat> depth_formats[] = {
    {"float32-reversed", raster::DepthFormat::Float32Reversed,
     "near 1, far 0: the same relative precision at every distance"},
    {"float32-forward", raster::DepthFormat::Float32Forward,
     "near 0, far 1: nearly all precision is spent close to the eye"},
};

inline constexpr Choice<pipeline::Cull> culls[] = {
    {"back", pipeline::Cull::Back, "faces that turn their back are not drawn"},
    {"front", pipeline::Cull::Front, "only backs are drawn: a look inside"},
    {"none", pipeline::Cull::None, "every face is drawn"},
};

inline constexpr Choice<raster::Output> outputs[] = {
    {"srgb", raster::Output::Srgb, "8 bits by the sRGB curve: looks right on a screen"},
    {"raw", raster::Output::Raw, "8 bits straight from linear light, as the textbook's pictures are"},
};

inline constexpr Choice<CameraDescription::Kind> projections[] = {
    {"perspective", CameraDescription::Kind::Perspective, "a vertical angle of view, fov_y"},
    {"orthographic", CameraDescription::Kind::Orthographic,
     "parallel lines of sight, height = world units seen"},
    {"frustum", CameraDescription::Kind::Frustum, "the window left, right, bottom, top on the near plane"},
};

inline constexpr Choice<pipeline::Light::Kind> light_types[] = {
    {"point", pipeline::Light::Kind::Point, "shines from one position in all directions"},
    {"directional", pipeline::Light::Kind::Directional, "shines in one direction, as the sun does"},
};

}  // namespace relevo::scene
