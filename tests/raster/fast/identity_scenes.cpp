#include "tests/raster/fast/identity_scenes.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>

#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"
#include "samples/scene/scene.hpp"
#include "samples/scene/shapes/torus.hpp"
#include "tests/bench/workload.hpp"
#include "tests/support/hard.hpp"

namespace relevo::tests::identity {

using namespace pipeline;
using raster::DepthFormat;
using raster::Shading;

// ---------------------------------------------------------------------------------------- what can be asked
Features features(const std::vector<int>& choice) {
    return {static_cast<Shading>(choice[0]),
            static_cast<Texturing>(choice[1]),
            static_cast<raster::Output>(choice[2]),
            static_cast<Cull>(choice[3]),
            choice[4] != 0,
            choice[5] != 0,
            static_cast<DepthFormat>(choice[6]),
            choice[7] == 2 ? 3 : choice[7],
            choice[8] != 0};
}

std::string text(const Features& f) {
    constexpr const char *shadings[] = {"unlit", "flat", "gouraud", "phong"},
                         *texturings[] = {"no texture", "nearest", "bilinear"},
                         *culls[] = {"none", "back", "front"};
    return std::string(shadings[int(f.shading)]) + ", " + texturings[int(f.texturing)] + ", " +
           (f.output == raster::Output::Srgb ? "srgb" : "raw") + ", cull " + culls[int(f.cull)] +
           (f.two_sided ? ", two-sided" : "") + (f.mirrored ? ", mirrored" : "") +
           (f.depth == DepthFormat::Float32Forward ? ", forward depth" : "") + ", " +
           std::to_string(f.lights) + " lights" + (f.orthographic ? ", orthographic" : "");
}

raster::Settings settings(const Features& f) {
    raster::Settings out;
    out.shading = f.shading, out.depth = f.depth, out.cull = f.cull, out.output = f.output;
    out.texture_filter =
        f.texturing == Texturing::Nearest ? raster::Filter::Nearest : raster::Filter::Bilinear;
    return out;
}

std::vector<std::vector<int>> product(const std::vector<int>& choices) {
    std::vector<std::vector<int>> rows;
    std::vector<int> row(choices.size(), 0);
    for (;;) {
        rows.push_back(row);
        std::size_t k = row.size();
        while (k > 0 && ++row[k - 1] == choices[k - 1]) row[--k] = 0;
        if (k == 0) return rows;
    }
}

// Row after row, each begun with a pair that has not met yet; every further member takes the choice that
// makes the most new pairs.
std::vector<std::vector<int>> pairs(const std::vector<int>& choices) {
    const std::size_t members = choices.size();
    std::vector<std::size_t> first(members, 0);  // number of a member's first choice among all choices
    std::partial_sum(choices.begin(), choices.end() - 1, first.begin() + 1);
    const std::size_t all = first.back() + std::size_t(choices.back());
    std::vector<char> met(all * all, 0);
    const auto is_new = [&](std::size_t a, int x, std::size_t b, int y) {
        return !met[(first[a] + std::size_t(x)) * all + first[b] + std::size_t(y)];
    };
    std::vector<std::vector<int>> rows;
    for (std::size_t a = 0; a < members; ++a)
        for (std::size_t b = a + 1; b < members; ++b)
            for (int x = 0; x < choices[a]; ++x)
                for (int y = 0; y < choices[b]; ++y) {
                    if (!is_new(a, x, b, y)) continue;
                    std::vector<int> row(members, -1);
                    row[a] = x, row[b] = y;
                    for (std::size_t c = 0; c < members; ++c) {
                        if (row[c] >= 0) continue;
                        int most = -1;
                        for (int k = 0; k < choices[c]; ++k) {
                            const int z = (k + int(rows.size())) % choices[c];
                            int made = 0;
                            for (std::size_t d = 0; d < members; ++d)
                                made += row[d] >= 0 && is_new(c, z, d, row[d]);
                            if (made > most) most = made, row[c] = z;
                        }
                    }
                    for (std::size_t c = 0; c < members; ++c)
                        for (std::size_t d = 0; d < members; ++d)
                            met[(first[c] + std::size_t(row[c])) * all + first[d] + std::size_t(row[d])] = 1;
                    rows.push_back(row);
                }
    return rows;
}

// ---------------------------------------------------------------------------------------------- of what
void Subject::add(Mesh mesh, const Affine<World, Object>& place) {
    meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
    scene.models.push_back({meshes.back().get(), place, {}, nullptr, false});
}

namespace {

// Sizes with and without a power of two, one texel, one row or column, the longest.
const raster::Texture& texture(std::size_t number) {
    static const auto textures = [] {
        std::array<raster::Texture, 6> out;
        constexpr Size sizes[] = {{16, 8}, {7, 5}, {1, 1}, {300, 1}, {1, 16384}, {123, 77}};
        hard::Random random(4);
        for (std::size_t i = 0; i < out.size(); ++i) {
            std::vector<std::uint8_t> rgb(std::size_t(sizes[i].width * sizes[i].height * 3));
            for (std::uint8_t& c : rgb) c = static_cast<std::uint8_t>(random.integer(0, 255));
            out[i] = raster::make_texture(sizes[i].width, sizes[i].height, 3, rgb,
                                          i % 2 ? raster::Encoding::Raw : raster::Encoding::Srgb);
        }
        return out;
    }();
    return textures[number % textures.size()];
}

Projective<Clip, Eye> projection(const Subject& subject, const Features& f, Size size) {
    const DepthRange range =
        f.depth == DepthFormat::Float32Reversed ? DepthRange::Reversed : DepthRange::Forward;
    const double aspect = static_cast<double>(size.width) / size.height, h = subject.half_height;
    if (f.orthographic)
        return *orthographic(-h * aspect, h * aspect, -h, h, subject.near, subject.near + 20, range);
    return *perspective({65}, aspect, subject.near, std::numeric_limits<double>::infinity(), range);
}

}  // namespace

raster::Scene dressed(const Subject& subject, const Features& f, Size size) {
    constexpr Scalar shininess[] = {32, Scalar(7.5), 1, 0, 128, 200};
    raster::Scene scene = subject.scene;
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        raster::Model& model = scene.models[i];
        if (f.mirrored) model.world_from_object.m = model.world_from_object.m * scaling_matrix({-1, 1, 1});
        model.texture = f.texturing == Texturing::None
                            ? nullptr
                            : &texture(i + std::size_t(f.lights) + 2 * std::size_t(f.cull));
        model.two_sided = f.two_sided;
        model.material.shininess = shininess[(i + std::size_t(f.lights)) % std::size(shininess)];
        model.material.color = {Scalar(0.3) + Scalar(0.1) * Scalar(i % 7), Scalar(0.6), Scalar(0.9)};
    }
    const Light lights[] = {{Light::Kind::Point, {{1, 3, 2}}, {{0, 0, -1}}, {1, 1, Scalar(0.8)}},
                            {Light::Kind::Directional, {{0, 0, 0}}, {{-1, -1, -1}}, {Scalar(0.3), 0, 1}},
                            {Light::Kind::Point, {{-2, -1, Scalar(0.5)}}, {{0, 0, -1}}, {0, 1, 0}}};
    scene.lights.assign(lights, lights + f.lights);
    scene.camera.clip_from_eye = projection(subject, f, size);
    scene.camera.parallel = f.orthographic;
    return scene;
}

Subject everything() {
    Subject out{"everything", {}, {}};
    Mesh floor = mesh_of({{{{-1e4f, -1, -1e4f}, {0, -1, 50}, {1e4f, -1, -1e4f}}}});
    for (Vertex& v : floor.vertices) v.normal = {{0, 1, 0}}, v.uv = {v.position.v.x / 3, v.position.v.z / 3};
    out.add(std::move(floor));
    hard::Random random(9);
    Mesh fan;
    fan.vertices.push_back({{{0, 0, 1}}, {{0, 0, 1}}, {Scalar(0.5), Scalar(0.5)}});
    for (std::uint32_t i = 0; i < 24; ++i) {
        const Degrees angle{15.0 * i};
        const Vec3 p(glm::dvec3(cos(angle), sin(angle), random.between(-0.5, 0.5)));
        fan.vertices.push_back({{p}, {{p.x, p.y, Scalar(0.5)}}, {p.x, p.y}});
        for (const std::uint32_t k : {0u, 1 + i, 1 + (i + 1) % 24}) fan.indices.push_back(k);
    }
    for (int i = 0; i < 5; ++i)
        out.add(
            fan,
            {translation_matrix({random.between(-2, 2), random.between(-1, 1), random.between(-6, -0.5)}) *
             *rotation_matrix({1, 2, 3}, {random.between(0, 360)}) *
             scaling_matrix({i == 2 ? -1.0 : 1.0, 1, 0.7})});
    out.add(*scene::torus(12, 8, 0.6), {*rotation_matrix({1, 1, 0}, {50}) * scaling_matrix({1, 2, 1.5})});
    return out;
}

Subject torus(const std::string& name, int ring, int round) {
    const bench::Workload workload = bench::torus_workload(name, ring, round);
    Subject out{name, {}, {}};
    out.add(workload.mesh, bench::placement(workload, 0));
    out.scene.camera = bench::camera(4, 3, DepthRange::Reversed);
    return out;
}

Subject inside_torus(int ring, int round) {
    Subject out{"inside a torus", {}, {}};
    out.add(*scene::torus(ring, round, 0.45));
    out.scene.camera.eye_from_world = *look_at({1.1, 0, 0.1}, {0.9, 1, 0}, {0, 0, 1});
    out.near = 0.3, out.half_height = 0.1;
    return out;
}

Subject fill() {
    const bench::Workload workload = bench::fill_workload();
    Subject out{"fill", {}, {}};
    out.add(workload.mesh);
    out.scene.camera = bench::camera(4, 3, DepthRange::Reversed);
    return out;
}

Subject bunny() {
    auto loaded = scene::load_scene(std::string(RELEVO_SCENES) + "/bunny.toml");
    Subject out{"bunny", {}, loaded->scene};
    for (auto& mesh : loaded->meshes) out.meshes.push_back(std::move(mesh));
    out.near = 0.01, out.half_height = 1;
    return out;
}

Subject inside_bunny() {
    Subject out = bunny();
    out.name = "inside the bunny";
    // Nearer to the middle than its skin is.
    glm::dvec3 low(1e30), high(-1e30);
    for (const Vertex& v : out.meshes[0]->vertices) {
        const glm::dvec3 p(out.scene.models[0].world_from_object.m * glm::dvec4(glm::dvec3(v.position.v), 1));
        low = glm::min(low, p), high = glm::max(high, p);
    }
    const glm::dvec3 middle = (low + high) * 0.5;
    out.scene.camera.eye_from_world = *look_at(middle, middle + glm::dvec3(0.3, 0.2, 1), {0, 1, 0});
    out.near = 0.2 * (high.y - low.y), out.half_height = 0.1 * (high.y - low.y);
    return out;
}

// ------------------------------------------------------------------------------------------ sample scenes
std::vector<std::string> sample_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(RELEVO_SCENES))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace relevo::tests::identity
