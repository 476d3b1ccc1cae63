// The whole machine in double, beside the float one in the same program: pipeline/ and raster/ compiled once
// more with RELEVO_DOUBLE and another name for their namespace. What goes in and out is plain numbers.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace double_machine {

using Matrix = std::array<double, 16>;  // column by column
using Three = std::array<double, 3>;

struct Texture {
    int width = 0, height = 0;
    std::vector<std::array<std::uint16_t, 4>> texels;
    bool raw = false;  // steps of 1/255, else 1/65535
};
struct Model {
    Matrix world_from_object{};
    std::vector<std::array<double, 8>> vertices;  // position, normal, u, v
    std::vector<std::uint32_t> indices;
    double ambient = 0, diffuse = 0, specular = 0, shininess = 0;
    Three color{};
    int texture = -1;
    bool two_sided = false;
};
struct Light {
    bool directional = false;
    Three position{}, direction{}, color{};
};
struct Scene {
    int width = 0, height = 0;
    Matrix eye_from_world{}, clip_from_eye{};
    bool parallel = false;
    Three background{};
    std::vector<Texture> textures;
    std::vector<Model> models;
    std::vector<Light> lights;
    int shading = 0, filter = 0, depth = 0, cull = 0, output = 0;  // the numbers of raster/scene.hpp's enums
};
struct Pictures {
    std::vector<std::array<std::uint8_t, 4>> color;
    std::vector<double> depth;
};

Pictures draw(const Scene& scene);

}  // namespace double_machine
