// A relief texture in a few lines: the teapot is drawn once; then the picture alone is warped for five
// viewers.
#include "pipeline/transform.hpp"
#include "relief/capture_raster.hpp"
#include "relief/map_plane.hpp"
#include "samples/io/png.hpp"
#include "samples/scene/shapes/teapot.hpp"

using namespace relevo;

int main(int argc, char** argv) {
    const pipeline::Mesh mesh = *scene::teapot(12);
    raster::Scene scene;
    scene.models = {{&mesh, {}, {.color = {0.2f, 0.45f, 0.6f}}, nullptr, false}};
    scene.lights = {{.position = {{4, 8, 6}}}};

    // the source: seen from the front, 7 units wide, its plane 3 units before the teapot's middle
    const int size = 256;
    const auto source = *relief::orthographic_camera({{0, 0, -1}, {0, 1, 0}, size, size}, {0, 1.5, 3}, 7);
    const auto texture = *relief::capture_raster(scene, source, {.shading = raster::Shading::Phong});

    raster::Image<raster::Rgba8> strip(5 * size, size);
    for (int k = 0; k < 5; ++k) {
        const pipeline::Degrees aside{20.0 * (k - 2)};
        const glm::dvec3 toward(-pipeline::sin(aside), -0.2, -pipeline::cos(aside));
        const glm::dvec3 eye = glm::dvec3(0, 1.5, 0) - 11.0 * toward;
        const auto screen = *relief::perspective_camera({toward, {0, 1, 0}, size, size}, eye, 1, {36});

        const auto warp = *relief::make_warp(source, relief::viewer_at(eye));
        const auto window = *relief::target_window(source, warp, relief::depth_range(texture));
        const auto picture = relief::prewarp(texture, warp, window);
        const auto seen = relief::map_plane(picture, source, warp, screen);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                strip.row(y)[k * size + x] = raster::to_rgba8(
                    seen.coverage.at(x, y) ? seen.color.at(x, y) : scene.background, raster::Output::Srgb);
    }
    return io::write_png(argc > 1 ? argv[1] : "relief.png", strip) ? 2 : 0;
}
