// What is searched by slices in the tests, the table and the count of instructions: the test objects as
// relief textures of 256 x 256, read bilinearly, their depths 0 to 2 cut into slices, seen 25 degrees from
// the side.
#pragma once
#include "relief/inverse_slices.hpp"
#include "relief/inverse_view.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/relief/image_experiment.hpp"

namespace relevo::tests {

struct SliceWork {
    const char* name;
    relief::ReliefTexture texture;
    relief::ReliefSolid solid;
    relief::ReliefCamera viewer;
    std::vector<relief::ReliefRay> rays;  // one a pixel, where there is one
};

inline SliceWork slice_work(const char* name, const relief::ReliefTexture& texture,
                            const relief::ReliefCamera& viewer) {
    SliceWork work{name, texture, relief::extruded_solid(texture), viewer, {}};
    work.solid.low = 0, work.solid.high = 2, work.solid.reading = relief::Reading::Bilinear;
    const relief::ReliefRays rays = *relief::relief_rays(texture.camera, viewer);
    for (int y = 0; y < viewer.height; ++y)
        for (int x = 0; x < viewer.width; ++x)
            if (const auto ray = rays.through(x + 0.5, y + 0.5)) work.rays.push_back(*ray);
    return work;
}
inline std::vector<SliceWork> slice_works(int screen = 128) {
    const relief::ReliefCamera source = experiment_source(), viewer = experiment_viewer(25, screen);
    std::vector<SliceWork> works;
    works.push_back(slice_work("sphere", ray_cast(scene::sphere_object, source), viewer));
    works.push_back(slice_work("bumpy", ray_cast(scene::bumpy_object, source), viewer));
    works.push_back(slice_work("complex", ray_cast(scene::complex_object, source), viewer));
    return works;
}

inline relief::ViewImage picture_by_slices(const SliceWork& work, const relief::SliceSettings& settings) {
    return *inverse_view(work.texture, work.solid, work.viewer, [&](const relief::ReliefRay& ray) {
        return find_by_slices(work.solid, ray, settings);
    });
}

// How far a picture by slices is from one whose depths are exact: mean, in world units, where both see
// something.
inline double slice_error(const SliceWork& work, const relief::SliceSettings& settings) {
    return error_set(picture_by_slices(work, settings), picture_by_slices(work, {settings.slices, 30}))
        .mean_depth_error;
}

// Questions to the solid, over all rays: what a search costs, whatever the machine.
inline std::int64_t look_ups(const SliceWork& work, const relief::SliceSettings& settings) {
    struct Counter {
        std::int64_t count = 0;
        void on(const relief::SolidLookedUp&) { ++count; }
    } counter;
    for (const relief::ReliefRay& ray : work.rays) (void)find_by_slices(work.solid, ray, settings, counter);
    return counter.count;
}

}  // namespace relevo::tests
