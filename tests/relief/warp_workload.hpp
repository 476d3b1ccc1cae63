// What the benchmark of the pre-warp and its count of instructions warp: the test objects and a plane
// with a step, 256 x 256 texels with colour, normal and depth, seen 25 degrees from the side from
// distance 3.2.
#pragma once
#include <string>

#include "relief/prewarp.hpp"
#include "relief/ray_cast.hpp"
#include "relief/surface_plane_step.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/relief/image_experiment.hpp"

namespace relevo::tests {

struct WarpWork {
    std::string name;
    relief::PreparedRelief source;
    relief::Warp warp;
    relief::Window window;
    int texels;  // with a surface
};

template <relief::RayCastable Surface>
WarpWork warp_work(const std::string& name, const Surface& surface, const relief::ReliefCamera& camera,
                   const relief::ReliefCamera& viewer) {
    const relief::ReliefTexture texture = ray_cast(surface, camera);
    const relief::Warp warp = *make_warp(camera, relief::viewer_at(viewer.eye));
    int texels = 0;
    for (const auto covered : texture.coverage.pixels()) texels += covered;
    return {name, prepare(texture), warp, *target_window(camera, warp, depth_range(texture)), texels};
}

inline std::vector<WarpWork> warp_works(int size = 256) {
    const relief::ReliefCamera source = experiment_source(size), viewer = experiment_viewer(25),
                               above = *relief::orthographic_camera({{0, 0, -1}, {0, 1, 0}, size, size},
                                                                    {0, 0, 1}, 2);
    relief::ReliefCamera opposite = viewer;
    opposite.eye.z = -viewer.eye.z;
    std::vector<WarpWork> works;
    works.push_back(warp_work("sphere", scene::sphere_object, source, viewer));
    works.push_back(warp_work("bumpy", scene::bumpy_object, source, viewer));
    works.push_back(warp_work("complex", scene::complex_object, source, viewer));
    works.push_back(warp_work("plane with a step", relief::PlaneStep{0.5}, above, opposite));
    return works;
}

struct NamedResampler {
    const char* name;
    relief::Resampler resampler;
};
inline constexpr NamedResampler warp_resamplers[] = {{"interleaved", relief::Resampler::Interleaved},
                                                     {"one-dimensional", relief::Resampler::OneDimensional},
                                                     {"asymmetric", relief::Resampler::Asymmetric},
                                                     {"compensated", relief::Resampler::Compensated}};

}  // namespace relevo::tests
