// The work that Relevo and its peers are measured on: what to draw, from where, under which light.
//
//   torus_1k, torus_100k, torus_1m   a torus (radius 1, tube 0.45) that turns by 0.05 rad a frame
//   fill                             8 quads that each cover the picture, farthest first, so every layer is
//   drawn
// Camera 3 from the origin, 60 degrees, near 0.1, far 100; one white point light up right behind it; raw
// output.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/projection.hpp"
#include "raster/scene.hpp"

namespace relevo::bench {

struct Workload {
    std::string name;
    pipeline::Mesh mesh;
    bool turns;
};

// How a surface is coloured. OpenGL's peer of Unlit and of Flat is one colour: it has no light for a face.
enum class Mode { Unlit, Flat, Gouraud, Phong, Textured };
inline constexpr const char* mode_names[] = {"unlit", "flat", "Gouraud", "Phong", "Phong + bilinear"};
inline const char* name(Mode mode) { return mode_names[static_cast<int>(mode)]; }
raster::Shading shading(Mode mode);

Workload torus_workload(const std::string& name, int ring, int round);
Workload fill_workload();

// A checkerboard of 1024 x 1024 with a gradient in its dark fields: RGB, bottom row first, as OpenGL takes
// it.
inline constexpr int texture_size = 1024;
std::vector<std::uint8_t> checkerboard();

inline constexpr pipeline::LinearRgb background{pipeline::Scalar(0.1), pipeline::Scalar(0.1),
                                                pipeline::Scalar(0.12)};
pipeline::Material material();
pipeline::Light light();
raster::Camera camera(int width, int height, pipeline::DepthRange range);
pipeline::Affine<pipeline::World, pipeline::Object> placement(const Workload& workload, int frame);

}  // namespace relevo::bench
