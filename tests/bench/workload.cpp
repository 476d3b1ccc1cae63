#include "tests/bench/workload.hpp"

#include "pipeline/transform.hpp"
#include "samples/scene/shapes/torus.hpp"

namespace relevo::bench {

using namespace pipeline;

raster::Shading shading(Mode mode) {
    using raster::Shading;
    constexpr Shading all[] = {Shading::Unlit, Shading::Flat, Shading::Gouraud, Shading::Phong,
                               Shading::Phong};
    return all[static_cast<int>(mode)];
}

Workload torus_workload(const std::string& name, int ring, int round) {
    return {name, scene::torus_mesh(ring, round, 0.45), true};
}

Workload fill_workload() {
    constexpr float half_width = 4.2f, half_height = 2.4f;  // just covers 16:9
    Workload workload{"fill", {}, false};
    for (std::uint32_t layer = 0; layer < 8; ++layer) {
        for (std::uint32_t k = 0; k < 4; ++k) {
            const float right = k == 1 || k == 2 ? 1 : -1, up = k >= 2 ? 1 : -1;
            workload.mesh.vertices.push_back(
                {{{right * half_width, up * half_height, -0.5f + 0.1f * float(layer)}},
                 {{0.3f * right, 0.3f * up, 1}},
                 {2 + 2 * right, 1.5f + 1.5f * up}});
        }
        for (const std::uint32_t k : {0, 1, 2, 0, 2, 3}) workload.mesh.indices.push_back(4 * layer + k);
    }
    return workload;
}

std::vector<std::uint8_t> checkerboard() {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(std::size_t{3} * texture_size * texture_size);
    for (int y = 0; y < texture_size; ++y) {
        for (int x = 0; x < texture_size; ++x) {
            const bool light_field = ((x / 64) + (y / 64)) % 2;
            rgb.push_back(static_cast<std::uint8_t>(light_field ? 230 : 60 + x / 16));
            rgb.push_back(static_cast<std::uint8_t>(light_field ? 200 : 60 + y / 16));
            rgb.push_back(light_field ? 120 : 140);
        }
    }
    return rgb;
}

Material material() {
    return {Scalar(0.1), Scalar(0.7), Scalar(0.4), 32, {Scalar(0.8), Scalar(0.5), Scalar(0.3)}};
}

Light light() { return {Light::Kind::Point, {{2, 2, 5}}, {{0, 0, -1}}, {1, 1, 1}}; }

raster::Camera camera(int width, int height, DepthRange range) {
    return {*look_at({0, 0, 3}, {0, 0, 0}, {0, 1, 0}),
            *perspective({60}, static_cast<double>(width) / height, 0.1, 100, range), false};
}

Affine<World, Object> placement(const Workload& workload, int frame) {
    if (!workload.turns) return {};
    const double angle = (0.6 + 0.05 * frame) * 180 / pi;
    return {rotate<World>({0, 1, 0}, {angle})->m * rotate<World>({1, 0, 0}, {0.7 * angle})->m};
}

}  // namespace relevo::bench
