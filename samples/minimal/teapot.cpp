// The library in a few lines: one teapot, one light, one PNG file.
#include "samples/scene/shapes/teapot.hpp"
#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"
#include "raster/draw.hpp"
#include "samples/io/png.hpp"

using namespace relevo;

int main(int argc, char** argv) {
    const pipeline::Mesh mesh = *scene::teapot(12);

    raster::Model teapot;
    teapot.mesh = &mesh;
    teapot.world_from_object = {pipeline::rotate<pipeline::World>({0, 1, 0}, pipeline::Degrees{30})->m};
    teapot.material.color = {0.2f, 0.45f, 0.6f};

    raster::Scene scene;
    scene.models = {teapot};
    scene.lights = {{.position = {{4, 8, 6}}}};
    scene.camera.eye_from_world = *pipeline::look_at({0, 4, 9}, {0, 1.4, 0}, {0, 1, 0});
    scene.camera.clip_from_eye =
        *pipeline::perspective(pipeline::Degrees{40}, 4.0 / 3, 0.1, 100, pipeline::DepthRange::Reversed);

    raster::Frame frame{
        raster::Image<raster::Rgba8>(640, 480), raster::Image<pipeline::Scalar>(640, 480), {}};
    raster::draw(scene, {}, frame);
    const auto failure = io::write_png(argc > 1 ? argv[1] : "teapot.png", frame.color);
    return failure ? 2 : 0;
}
