// What the fast path may cost: the work that scripts/budgets counts under valgrind, AVX2 stages, one thread.
//
// A row is a difference, so that only one thing is left: instructions of the pictures drawn `more`, minus
// those of the pictures drawn `less`, for each of `items`.
//   budgets             draws everything; each dump is named "row +" or "row -"
//   budgets --items     the rows: name, a tab, items
#include <valgrind/callgrind.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "raster/fast/draw_fast.hpp"
#include "tests/bench/workload.hpp"

namespace relevo {
namespace {

using bench::Mode;
using pipeline::Mesh;
using raster::fast::InstructionSet;

// Eight by eight tiles. The eye is at the origin and sees 90 degrees.
constexpr int side = 512;

pipeline::Vertex at(double x, double y, double distance) {
    const double right = 2 * x / side - 1, up = 1 - 2 * y / side;
    return {{pipeline::Vec3(glm::dvec3(right * distance, up * distance, -distance))},
            {{0, 0, 1}},
            {pipeline::Scalar(x / side), pipeline::Scalar(y / side)}};
}

void add_triangle(Mesh& mesh, const pipeline::Vertex& a, const pipeline::Vertex& b,
                  const pipeline::Vertex& c) {
    for (const pipeline::Vertex& v : {a, b, c}) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back(v);
    }
}

void add_layer(Mesh& mesh, double distance) {
    add_triangle(mesh, at(0, 0, distance), at(0, side, distance), at(side, side, distance));
    add_triangle(mesh, at(0, 0, distance), at(side, side, distance), at(side, 0, distance));
}
Mesh layers(const std::vector<double>& distances) {
    Mesh mesh;
    for (const double distance : distances) add_layer(mesh, distance);
    return mesh;
}

// Vertices alone; one mesh more than another has no other difference.
Mesh points(int vertices) {
    Mesh mesh;
    for (int k = 0; k < vertices; ++k) mesh.vertices.push_back(at(k % side, k / side, 2));
    return mesh;
}

// `steps` times `count` right-angled triangles (or their mirror images), side by side where they are seen,
// `size` pixels a leg. The vertices are those of two steps, whatever `steps` is. With a layer at distance 2
// or without: where they stand before it, they would save the colours of its pixels, and hide what they cost.
struct Field {
    double size, distance;
    double x = 0, y = 0;  // of the first one's right angle
    bool back = false;
    bool layer = false;
    int count = 32768;
};
Mesh field(int steps, const Field& f) {
    Mesh mesh = f.layer ? layers({2}) : Mesh{};
    const int pitch = static_cast<int>(f.size) + 1, across = side / pitch, down = side / pitch;
    for (int k = 0; k < 2 * f.count; ++k) {
        const double x = f.x + pitch * (k % across), y = f.y + pitch * (k / across % down);
        const auto a = at(x, y, f.distance), b = at(x, y + f.size, f.distance),
                   c = at(x + f.size, y, f.distance);
        add_triangle(mesh, a, f.back ? c : b, f.back ? b : c);
    }
    const std::size_t kept = static_cast<std::size_t>(steps) * 3 * static_cast<std::size_t>(f.count);
    mesh.indices.resize((f.layer ? 6 : 0) + kept);
    return mesh;
}

struct Picture {
    Mesh mesh;
    Mode mode;
};
struct Row {
    std::string name;
    int items;
    std::vector<Picture> more, less;
};

std::vector<Row> rows() {
    std::vector<Row> all;
    const auto is = [](Mode mode) { return std::string(", ") + bench::name(mode); };
    for (const Mode mode : {Mode::Unlit, Mode::Gouraud, Mode::Phong})
        all.push_back({"vertex" + is(mode), 32768, {{points(65536), mode}}, {{points(32768), mode}}});

    const auto triangles = [&](const std::string& name, const Field& f, Mode mode) {
        all.push_back({name, f.count, {{field(2, f), mode}}, {{field(1, f), mode}}});
    };
    triangles("triangle, back face", {.size = 3, .distance = 1, .back = true}, Mode::Unlit);
    triangles("triangle beside the picture", {.size = 0.9, .distance = 1, .x = side + 9.0}, Mode::Unlit);
    triangles("triangle beyond the far plane", {.size = 0.9, .distance = 200}, Mode::Unlit);
    triangles("triangle between pixel centres", {.size = 0.4, .distance = 1}, Mode::Unlit);
    const double first = 0.3;  // from the right angle to the only centre: (0.2, 0.2)
    triangles("triangle of 1 pixel, hidden",
              {.size = 0.9, .distance = 3, .x = first, .y = first, .layer = true}, Mode::Unlit);
    for (const Mode mode : {Mode::Unlit, Mode::Flat, Mode::Gouraud, Mode::Phong, Mode::Textured})
        triangles("triangle of 1 pixel" + is(mode), {.size = 0.9, .distance = 1, .x = first, .y = first},
                  mode);
    for (const Mode mode : {Mode::Unlit, Mode::Phong})
        triangles("triangle of 10 pixels" + is(mode),
                  {.size = 3.9, .distance = 1, .x = first, .y = first, .count = 8192}, mode);

    const int pixels = side * side;
    all.push_back({"depth-tested pixel, hidden",
                   pixels,
                   {{layers({2, 3}), Mode::Unlit}},
                   {{layers({2}), Mode::Unlit}}});
    all.push_back({"depth-tested pixel, nearer",
                   pixels,
                   {{layers({2, 1}), Mode::Unlit}},
                   {{layers({2}), Mode::Unlit}}});
    // (layer - nothing) - (second layer, hidden): what is left is colour
    for (const Mode mode : {Mode::Unlit, Mode::Flat, Mode::Gouraud, Mode::Phong, Mode::Textured})
        all.push_back({"shaded pixel" + is(mode),
                       pixels,
                       {{layers({2}), mode}, {layers({2}), mode}},
                       {{layers({}), mode}, {layers({2, 3}), mode}}});
    return all;
}

// One picture, counted the second time: the workspace has all its memory then.
void count_picture(const std::string& name, const Picture& picture) {
    static const raster::Texture texture = raster::make_texture(bench::texture_size, bench::texture_size, 3,
                                                                bench::checkerboard(), raster::Encoding::Raw);
    raster::Scene scene;
    scene.models.push_back(
        {&picture.mesh, {}, bench::material(), picture.mode == Mode::Textured ? &texture : nullptr, false});
    scene.lights.push_back({pipeline::Light::Kind::Point, {{0, 0, 1}}, {{0, 0, -1}}, {1, 1, 1}});
    scene.camera.clip_from_eye = *pipeline::perspective({90}, 1, 0.1, 100, pipeline::DepthRange::Reversed);
    raster::Settings settings;
    settings.output = raster::Output::Raw;
    settings.shading = bench::shading(picture.mode);
    raster::Frame frame{
        raster::Image<raster::Rgba8>(side, side), raster::Image<pipeline::Scalar>(side, side), {}};
    raster::fast::Workspace workspace;
    const raster::fast::Options options{.instruction_set = InstructionSet::Avx2};
    raster::fast::draw(scene, settings, frame, workspace, options);
    CALLGRIND_ZERO_STATS;
    raster::fast::draw(scene, settings, frame, workspace, options);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
}

}  // namespace
}  // namespace relevo

int main(int argc, char** argv) {
    using namespace relevo;
    const bool names_only = argc == 2 && std::strcmp(argv[1], "--items") == 0;
    const auto sets = raster::fast::instruction_sets();
    if (std::find(sets.begin(), sets.end(), InstructionSet::Avx2) == sets.end())
        return std::fprintf(stderr, "this processor, or this build, has no AVX2\n"), 2;
    for (const Row& row : rows()) {
        if (names_only) {
            std::printf("%s\t%d\n", row.name.c_str(), row.items);
            continue;
        }
        for (const Picture& picture : row.more) count_picture(row.name + " +", picture);
        for (const Picture& picture : row.less) count_picture(row.name + " -", picture);
    }
    return 0;
}
