// A scene file or a scene's text, drawn.
#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "raster/draw.hpp"
#include "samples/scene/scene.hpp"

namespace relevo::real {

inline scene::LoadedScene loaded(io::FileResult<scene::LoadedScene> result) {
    if (!result) ADD_FAILURE() << result.error().text();
    return result ? std::move(*result) : scene::LoadedScene{};
}

inline raster::Frame frame_of(const scene::LoadedScene& scene) {
    return {raster::Image<raster::Rgba8>(scene.width, scene.height),
            raster::Image<pipeline::Scalar>(scene.width, scene.height),
            {}};
}

template <class Pixel>
bool same_bits(const raster::Image<Pixel>& a, const raster::Image<Pixel>& b) {
    return a.width() == b.width() && a.height() == b.height() &&
           std::memcmp(a.row(0), b.row(0), a.pixels().size() * sizeof(Pixel)) == 0;
}

inline constexpr raster::Shading all_shadings[] = {raster::Shading::Unlit, raster::Shading::Flat,
                                                   raster::Shading::Gouraud, raster::Shading::Phong};

}  // namespace relevo::real
