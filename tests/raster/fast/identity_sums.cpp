// Draws two small scenes by the textbook path and by each instruction set, and prints a line with the sum of
// all bytes of each: what a build that fuses multiplications and additions must not be able to keep.
#include <cstdio>
#include <string_view>

#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"
#include "raster/draw.hpp"
#include "raster/fast/draw_fast.hpp"
#include "samples/scene/shapes/torus.hpp"

namespace {

using namespace relevo;

// FNV-1a (Fowler, Noll and Vo 1991).
std::uint64_t sum(std::string_view bytes, std::uint64_t so_far) {
    for (const char c : bytes) so_far = (so_far ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    return so_far;
}
template <class Pixel>
std::string_view bytes(const raster::Image<Pixel>& image) {
    return {reinterpret_cast<const char*>(image.pixels().data()), image.pixels().size() * sizeof(Pixel)};
}
void print(const char* name, const raster::Frame& frame) {
    const std::uint64_t all =
        sum(bytes(frame.linear), sum(bytes(frame.color), sum(bytes(frame.depth), 0xCBF29CE484222325u)));
    std::printf("%s %016llx\n", name, static_cast<unsigned long long>(all));
}

}  // namespace

int main() {
    constexpr int width = 320, height = 200;
    const pipeline::Mesh torus = *scene::torus(60, 40, 0.45);
    raster::Scene scene;
    for (const double x : {-0.4, 0.5})
        scene.models.push_back({&torus,
                                {pipeline::translation_matrix({x, 0.1, 0}) *
                                 *pipeline::rotation_matrix({1, 1, 0}, {40 + 100 * x})},
                                {},
                                nullptr,
                                false});
    scene.lights = {{}, {pipeline::Light::Kind::Point, {{2, 2, 5}}, {{0, 0, -1}}, {1, 1, 1}}};
    scene.camera.eye_from_world = *pipeline::look_at({0.1, 0.2, 3}, {0, 0, 0}, {0, 1, 0});
    scene.camera.clip_from_eye =
        *pipeline::perspective({50}, double(width) / height, 0.1, 100, pipeline::DepthRange::Reversed);
    const raster::Settings settings;
    raster::Frame frame{raster::Image<raster::Rgba8>(width, height),
                        raster::Image<pipeline::Scalar>(width, height),
                        raster::Image<pipeline::LinearRgb>(width, height)};
    raster::draw(scene, settings, frame);
    print("textbook", frame);
    raster::fast::Workspace workspace;
    for (const raster::fast::InstructionSet set : raster::fast::instruction_sets()) {
        raster::fast::draw(scene, settings, frame, workspace, {set});
        print(std::string(name(set)).c_str(), frame);
    }
}
