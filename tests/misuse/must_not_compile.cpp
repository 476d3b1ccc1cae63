// One source, compiled many times: as it is, it compiles; with MISUSE=n, the n-th misuse takes the place of
// the line beside it, and it must not. A misuse that compiles one day is a failed test.
#include <tuple>

#include "pipeline/transform.hpp"
#include "pipeline/viewport.hpp"
#include "raster/draw.hpp"

#ifndef MISUSE
#define MISUSE 0
#endif

namespace relevo {

using namespace pipeline;

struct Listens {
    int pixels = 0;
    void on(const raster::FragmentCovered&) { ++pixels; }
};
struct Deaf {
    void onn(const raster::FragmentCovered&) {}
};

void misuse(const Affine<World, Object>& world_from_object, const Affine<Eye, World>& eye_from_world,
            const Projective<Clip, Eye>& clip_from_eye, Point<Object> object, Point<World> world,
            Normal<Object> normal) {
#if MISUSE == 1  // points are places: they have differences, not sums
    const auto sum = world + world;
#else
    const auto sum = world + (world - world);
#endif

#if MISUSE == 2  // two spaces in one sum
    const auto difference = world - object;
#else
    const auto difference = world - rounded(world_from_object) * object;
#endif

#if MISUSE == 3  // composed in the wrong order
    const auto eye_from_object = world_from_object * eye_from_world;
#else
    const auto eye_from_object = eye_from_world * world_from_object;
#endif

#if MISUSE == 4  // the same map twice
    const auto twice = rounded(world_from_object) * (rounded(world_from_object) * object);
#else
    const auto twice = rounded(eye_from_world) * (rounded(world_from_object) * object);
#endif

#if MISUSE == 5  // a normal is not moved by the map of points
    const Normal<World> moved = rounded(world_from_object) * normal;
#else
    const Normal<World> moved = normal_map(world_from_object) * normal;
#endif

#if MISUSE == 6  // a point is not moved by the map of normals
    const auto place = normal_map(world_from_object) * object;
#else
    const auto place = rounded(world_from_object) * object;
#endif

#if MISUSE == 7  // only clip coordinates are divided
    const auto divided = perspective_divide(rounded(eye_from_object) * object);
#else
    const auto divided = perspective_divide(rounded(clip_from_eye * eye_from_object) * object);
#endif

#if MISUSE == 8  // ... and once
    const auto window = to_window(divided.ndc, Viewport{4, 4});
#else
    const auto window = to_window(rounded(clip_from_eye * eye_from_object) * object, Viewport{4, 4});
#endif

#if MISUSE == 9  // an unrounded map moves no vertex: where it is rounded is part of the promise
    const auto unrounded = world_from_object * object;
#else
    const auto unrounded = rounded(world_from_object) * object;
#endif

#if MISUSE == 10  // a result is not its value: it may be an error
    const Affine<Eye, World> camera = look_at({0, 0, 1}, {0, 0, 0}, {0, 1, 0});
#else
    const Affine<Eye, World> camera = *look_at({0, 0, 1}, {0, 0, 0}, {0, 1, 0});
#endif

#if MISUSE == 11  // degrees and radians are not one
    const double sine = pipeline::sin(3.14159);
#else
    const double sine = pipeline::sin(Degrees{180});
#endif
    static_cast<void>(std::tie(sum, difference, twice, moved, place, window, unrounded, camera, sine));
}

void deaf_probe(const raster::Scene& scene, raster::Frame& frame) {
#if MISUSE == 12  // a misspelt on() would hear nothing
    Deaf probe;
#else
    Listens probe;
#endif
    raster::draw(scene, {}, frame, probe);
}

}  // namespace relevo
