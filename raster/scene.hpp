// What the machine draws, and how: the vocabulary of raster/draw.hpp. No algorithm here.
#pragma once
#include <optional>
#include <vector>

#include "pipeline/color.hpp"
#include "pipeline/cull.hpp"
#include "pipeline/light.hpp"
#include "pipeline/mesh.hpp"
#include "pipeline/space.hpp"
#include "raster/depth.hpp"
#include "raster/image.hpp"
#include "raster/output.hpp"
#include "raster/texture.hpp"

namespace relevo::raster {

namespace fast {
enum class InstructionSet;  // raster/fast/draw_fast.hpp
}

// A mesh placed in the world. The mesh and the texture are borrowed: they must outlive the model.
struct Model {
    const pipeline::Mesh* mesh = nullptr;
    pipeline::Affine<pipeline::World, pipeline::Object> world_from_object;
    pipeline::Material material;
    const Texture* texture = nullptr;  // multiplies the ambient and diffuse light in place of material.color
    bool two_sided = false;            // back faces are lit by the reversed normal; else by the outward one
};

struct Camera {
    pipeline::Affine<pipeline::Eye, pipeline::World> eye_from_world;
    pipeline::Projective<pipeline::Clip, pipeline::Eye> clip_from_eye;
    bool parallel =
        false;  // all lines of sight are parallel (orthographic): the viewer lies towards +z of the eye
};

struct Scene {
    std::vector<Model> models;
    std::vector<pipeline::Light> lights;
    Camera camera;
    pipeline::LinearRgb background{Scalar(0.1), Scalar(0.1), Scalar(0.12)};
};

enum class Shading {
    Unlit,    // the surface's own colour: no light
    Flat,     // one light equation a face
    Gouraud,  // one a corner, the colours interpolated
    Phong,    // one a pixel, the normals interpolated
};

// The way through the machine (raster/path.hpp); it never changes a pixel.
enum class Path { Auto, Fast, Textbook };

struct Settings {
    Shading shading = Shading::Phong;
    Filter texture_filter = Filter::Bilinear;
    DepthFormat depth = DepthFormat::Float32Reversed;
    pipeline::Cull cull = pipeline::Cull::Back;
    Output output = Output::Srgb;
    Path path = Path::Auto;
    std::optional<fast::InstructionSet> instruction_set = {};  // of the fast path; none: the widest
};

// The pictures that draw() fills. `linear` is filled only when it has a size: the float picture exists when
// asked for.
struct Frame {
    Image<Rgba8> color;
    Image<Scalar> depth;
    Image<pipeline::LinearRgb> linear;
};

}  // namespace relevo::raster
