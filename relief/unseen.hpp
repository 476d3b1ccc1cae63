// What a set of views never shows (Clua 2004, 4.1, figs. 4.1 and 4.2): the triangles that are in no pixel of
// any of them. A box of six faces misses what lies deep in a bowl or behind a rim.
//
// A view sees a triangle when the triangle is the nearest one at the centre of some texel; so small triangles
// need small texels.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "raster/scene.hpp"
#include "relief/relief_texture.hpp"

namespace relevo::relief {

// One entry a triangle, over all models in their order: 1 when a camera sees it. Cameras are not refused:
// they are those of relief textures that exist. `cull` as the scene is drawn with.
std::vector<std::uint8_t> seen_triangles(const raster::Scene& scene, std::span<const ReliefCamera> cameras,
                                         pipeline::Cull cull = pipeline::Cull::Back);

}  // namespace relevo::relief
