// One triangle whose coordinates are already those of the view volume, and a probe that counts its pixels.
#include <cstdio>

#include "raster/draw.hpp"
#include "samples/io/png.hpp"

using namespace relevo;

struct PixelCounter {
    int covered = 0;
    void on(const raster::FragmentCovered&) { ++covered; }
};

int main(int argc, char** argv) {
    pipeline::Mesh mesh;
    mesh.vertices = {
        {{{-0.8f, -0.6f, 0.5f}}, {}, {}}, {{{0.8f, -0.6f, 0.5f}}, {}, {}}, {{{0, 0.8f, 0.5f}}, {}, {}}};
    mesh.indices = {0, 1, 2};

    raster::Scene scene;  // its camera leaves coordinates as they are
    scene.models.resize(1);
    scene.models[0].mesh = &mesh;
    scene.models[0].material.color = {0.9f, 0.5f, 0.1f};

    raster::Frame frame{
        raster::Image<raster::Rgba8>(320, 240), raster::Image<pipeline::Scalar>(320, 240), {}};
    PixelCounter counter;
    raster::draw(scene, {.shading = raster::Shading::Unlit}, frame, counter);
    std::printf("%d pixels\n", counter.covered);
    const auto failure = io::write_png(argc > 1 ? argv[1] : "triangle.png", frame.color);
    return failure ? 2 : 0;
}
