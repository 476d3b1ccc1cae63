#include "samples/scene/generators.hpp"

#include <fmt/format.h>

#include "samples/scene/shapes/cube.hpp"
#include "samples/scene/shapes/dice.hpp"
#include "samples/scene/shapes/plane.hpp"
#include "samples/scene/shapes/sphere.hpp"
#include "samples/scene/shapes/teapot.hpp"
#include "samples/scene/shapes/terrain.hpp"
#include "samples/scene/shapes/torus.hpp"

namespace relevo::scene {
namespace {

using pipeline::Result;

constexpr std::string_view segments_only[] = {"segments"};
constexpr std::string_view torus_parameters[] = {"segments", "tube"};
constexpr std::string_view plane_parameters[] = {"segments", "repeat"};
constexpr std::string_view terrain_parameters[] = {"segments", "height", "seed"};

constexpr Generator all_generators[] = {
    {"cube", {}, "edge 1 round the origin, the whole texture on each face"},
    {"dice", {}, "the same cube, the texture an unfolded cube of 4 x 3 cells (textbook fig. 10.1)"},
    {"sphere", segments_only, "radius 1; segments = [round the y axis, from pole to pole], default [64, 32]"},
    {"torus", torus_parameters,
     "ring of radius 1 round the z axis; segments = [ring, tube], default [64, 32]; tube = radius, default "
     "0.45"},
    {"plane", plane_parameters,
     "square of edge 1, y = 0; segments = [x, z], default [1, 1]; repeat = textures a side, default 1"},
    {"teapot", segments_only, "Newell's, standing on y = 0; segments = per side of a patch, default 10"},
    {"terrain", terrain_parameters,
     "hills over the square of edge 1; segments = [x, z], default [128, 128]; height, default 0.3; seed, "
     "default 1"},
};

struct Segments {
    int first, second;
};

// segments = [a, b], each from the given low to max_segments.
Segments read_segments(const Fields& object, Segments fallback, int low) {
    const Value* value = object.find("segments");
    if (!value) return fallback;
    const auto* list = std::get_if<std::vector<Value>>(&value->data);
    int found[2] = {0, 0};
    bool good = list && list->size() == 2;
    for (std::size_t i = 0; good && i < 2; ++i) {
        const auto* whole = std::get_if<std::int64_t>(&(*list)[i].data);
        good = whole && low <= *whole && *whole <= max_segments;
        if (good) found[i] = static_cast<int>(*whole);
    }
    if (good) return {found[0], found[1]};
    object.diagnosis().say(
        value->place,
        fmt::format("{} is not right, accepted: two whole numbers from {} to {}, "
                    "as in [{}, {}]",
                    object.full("segments"), low, max_segments, fallback.first, fallback.second));
    return fallback;
}

Result<Mesh> make_shape(std::string_view name, const Fields& object) {
    if (name == "cube") return cube();
    if (name == "dice") return dice();
    if (name == "teapot") return teapot(object.whole("segments", 10, 2, max_teapot_segments));
    if (name == "sphere") {
        const Segments n = read_segments(object, {64, 32}, 3);
        return sphere(n.first, n.second);
    }
    if (name == "torus") {
        const Segments n = read_segments(object, {64, 32}, 3);
        constexpr Range inside{0, 1, true, true, "more than 0 and less than 1"};
        return torus(n.first, n.second, object.number("tube", 0.45, inside));
    }
    if (name == "plane") {
        const Segments n = read_segments(object, {1, 1}, 1);
        return plane(n.first, n.second, object.number("repeat", 1, positive));
    }
    const Segments n = read_segments(object, {128, 128}, 1);
    const auto seed = static_cast<std::uint32_t>(object.whole("seed", 1, 0, 1'000'000));
    return terrain(n.first, n.second, object.number("height", 0.3, zero_or_more), seed);
}

}  // namespace

std::span<const Generator> generators() { return all_generators; }

const Generator* find_generator(std::string_view name) {
    for (const Generator& generator : all_generators)
        if (generator.name == name) return &generator;
    return nullptr;
}

pipeline::Mesh generate(const Generator& generator, const Fields& object) {
    Result<Mesh> shape = make_shape(generator.name, object);
    if (shape) return *std::move(shape);
    object.diagnosis().say(object.place("mesh"), object.full("mesh") + ": " + shape.error().message);
    return {};
}

}  // namespace relevo::scene
