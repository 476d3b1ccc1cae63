#include "tests/golden/subject.hpp"

#include <array>
#include <map>
#include <utility>

#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"

namespace relevo::golden {
namespace {

using pipeline::Degrees;
using pipeline::Mesh;
using pipeline::Scalar;
using pipeline::Vec3;
using pipeline::Vertex;
using World = pipeline::Affine<pipeline::World, pipeline::Object>;

Scalar real(double v) { return static_cast<Scalar>(v); }

Vertex vertex(double x, double y, double z, double u = 0, double v = 0) {
    return {{{real(x), real(y), real(z)}}, {{0, 0, 1}}, {real(u), real(v)}};
}

raster::Model& add(Subject& subject, Mesh mesh, const World& world = {}) {
    subject.meshes.push_back(std::move(mesh));
    raster::Model model;
    model.mesh = &subject.meshes.back();
    model.world_from_object = world;
    subject.scene.models.push_back(model);
    return subject.scene.models.back();
}

World placed(glm::dvec3 at, glm::dvec3 axis, double degrees, glm::dvec3 size) {
    return {pipeline::translation_matrix(at) * *pipeline::rotation_matrix(axis, Degrees{degrees}) *
            pipeline::scaling_matrix(size)};
}

// One world unit is one pixel, (0, 0) the upper left corner of the picture, z from 0 (far) to 1 (near).
Subject in_pixels(int width, int height) {
    Subject s;
    s.width = width, s.height = height;
    glm::dmat4 m{1.0};
    m[0][0] = 2.0 / width, m[3][0] = -1;
    m[1][1] = -2.0 / height, m[3][1] = 1;
    s.scene.camera.clip_from_eye = {m};
    s.scene.camera.parallel = true;
    s.settings.shading = raster::Shading::Unlit;
    s.settings.cull = pipeline::Cull::None;
    return s;
}

Subject in_perspective(int width, int height, glm::dvec3 eye, glm::dvec3 target, double near, double far) {
    Subject s;
    s.width = width, s.height = height;
    s.scene.camera.eye_from_world = *pipeline::look_at(eye, target, {0, 1, 0});
    s.scene.camera.clip_from_eye =
        *pipeline::perspective({50}, double(width) / height, near, far, pipeline::DepthRange::Reversed);
    s.settings.shading = raster::Shading::Unlit;
    s.settings.output = raster::Output::Raw;
    return s;
}

// --------------------------------------------------------------------------------------------------- meshes
Mesh triangles(std::vector<Vertex> corners) {
    Mesh mesh{std::move(corners), {}};
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) mesh.indices.push_back(i);
    return mesh;
}

Mesh cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(vertex(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    mesh.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2,
                    1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3};
    return mesh;
}

// A sphere from an octahedron whose edges are halved twice: 128 faces, no angle computed.
Mesh ball() {
    Mesh mesh;
    const auto corner = [&](const Vec3& p) {
        const Vec3 n = pipeline::normalize(p);
        mesh.vertices.push_back({{n}, {n}, {(n.x + 1) / 2, (n.y + 1) / 2}});
        return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    };
    const Vec3 axes[6] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const Vec3& axis : axes) corner(axis);
    mesh.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5};
    for (int halving = 0; halving < 2; ++halving) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), 0);
            if (is_new) found->second = corner(mesh.vertices[a].position.v + mesh.vertices[b].position.v);
            return found->second;
        };
        std::vector<std::uint32_t> finer;
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            const std::uint32_t a = mesh.indices[t], b = mesh.indices[t + 1], c = mesh.indices[t + 2];
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const std::uint32_t i : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) finer.push_back(i);
        }
        mesh.indices = std::move(finer);
    }
    return mesh;
}

Mesh quad(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
    return {{a, b, c, d}, {0, 1, 2, 0, 2, 3}};
}

// A letter F, red above green, on a grey that grows brighter to the right: no symmetry at all.
const raster::Texture* letter(Subject& subject, raster::Encoding encoding) {
    constexpr const char* rows[8] = {"........", ".#####..", ".#......", ".####...",
                                     ".#......", ".#......", ".#......", "........"};
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const int grey = 40 + 24 * x;
            const std::array<int, 3> rgb =
                rows[y][x] == '#' ? std::array{250 - 20 * y, 30 + 25 * y, 20} : std::array{grey, grey, 90};
            for (const int c : rgb) bytes.push_back(static_cast<std::uint8_t>(c));
        }
    subject.textures.push_back(raster::make_texture(8, 8, 3, bytes, encoding));
    return &subject.textures.back();
}

// --------------------------------------------------------------------------------------------- the subjects
Subject clip_planes() {
    Subject s = in_perspective(96, 64, {0.3, 0.2, 0.1}, {0.1, 0.35, -5}, 0.5, 8);
    s.settings.cull = pipeline::Cull::None;
    add(s,
        triangles({
            vertex(-1.1, 0.3, -2.7),    vertex(0.9, -0.4, -3.1),  vertex(0.2, 0.7, 0.4),     // near
            vertex(-0.3, -0.2, 0.7),    vertex(0.6, -0.3, 0.9),   vertex(0.1, 0.4, -4.3),    // near
            vertex(-1.3, 0.1, -5.2),    vertex(1.7, 0.2, -6.1),   vertex(0.3, 1.9, -9.7),    // far
            vertex(0.2, -0.7, 1.3),     vertex(1.1, 0.1, -12.9),  vertex(-0.9, 0.3, -4.4),   // both
            vertex(-71.3, 0.3, -3.3),   vertex(0.4, 0.1, -2.9),   vertex(0.3, 0.9, -3.7),    // side
            vertex(53.1, 61.7, -2.1),   vertex(-0.4, -0.3, -3.9), vertex(0.7, -83.3, 3.7),   // several
            vertex(0.1, 0.2, 1.1),      vertex(0.4, 0.9, 2.3),    vertex(-0.2, 0.3, 0.9),    // behind
            vertex(-0.4, 0.1, -3.3),    vertex(0.5, 0.2, -3.1),   vertex(0.1, 0.8, -4.9),    // inside
            vertex(-9.3, -0.7, -11.9),  vertex(9.7, -0.6, -12.3), vertex(0.3, -0.9, 17.1),   // round the eye
            vertex(331.7, -0.9, -13.3), vertex(0.3, -0.9, 17.1),  vertex(9.7, -0.6, -12.3),  // its neighbour
            vertex(4e20, 0.3, -3.3),    vertex(-0.4, -0.3, -3.9), vertex(0.7, 0.9, -3.1),    // far out
        }));
    return s;
}

// Corners half way between two subpixels (ties), at both signs of the area, and beyond the picture.
Subject window_ties() {
    Subject s = in_pixels(64, 64);
    const double half = 1.0 / 512;
    add(s, triangles({
               vertex(3 + half, 4, 0.25), vertex(3, 9 + 3 * half, 0.5), vertex(11 + 5 * half, 5, 0.75),
               vertex(20 + half, 4 + half, 0), vertex(30, 5 - half, 0.5), vertex(21 - half, 12, 1),
               vertex(-180, -70, 0.125), vertex(-11 - half, 40, 0.5), vertex(40, 220 + half, 0.5),
               vertex(40.3, 8.7, 0.5), vertex(40.30001, 8.7, 0.5), vertex(40.3, 8.70001, 0.5),  // nothing
           }));
    return s;
}

Subject window_cube() {
    Subject s = in_perspective(64, 48, {2.1, 1.7, 4.3}, {0.1, 0, 0}, 0.5, 20);
    add(s, cube(), placed({-0.6, 0.1, 0}, {1, 2, 3}, 25, {0.8, 0.9, 1}));
    add(s, cube(), placed({1.3, -0.4, 0.3}, {0, 1, 1}, 40, {-0.5, 0.4, 0.6}));  // mirrored
    return s;
}

// Edges through pixel centres, shared by the triangles of a fan and of a strip, and a sliver across them.
Subject coverage_fan() {
    Subject s = in_pixels(64, 48);
    Mesh fan;
    fan.vertices.push_back(vertex(22.5, 20.5, 0.5));
    const double rim[][2] = {{40.5, 20.5}, {36.5, 6.5}, {22.5, 2.5},  {10.25, 8.25},
                             {4.5, 20.5},  {8.5, 34.5}, {22.5, 38.5}, {30.75, 36.5}};
    for (const auto& p : rim) fan.vertices.push_back(vertex(p[0], p[1], 0.5));
    for (std::uint32_t k = 0; k < 8; ++k) fan.indices.insert(fan.indices.end(), {0, k + 1, (k + 1) % 8 + 1});
    add(s, fan);
    add(s, {{vertex(44.5, 4.5, 0.5), vertex(52.5, 4.5, 0.5), vertex(60.5, 9.5, 0.5), vertex(44.5, 16.5, 0.5),
             vertex(54.5, 18.5, 0.5), vertex(60.5, 30.5, 0.5), vertex(46.5, 31.5, 0.5)},
            {0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 3, 4, 6, 4, 5, 6}});
    add(s, triangles({vertex(6.3, 45.1, 0.5), vertex(61.7, 39.2, 0.5), vertex(7.9, 45.6, 0.5)}));
    return s;
}

Subject coverage_cube() {
    Subject s = window_cube();
    s.settings.cull = pipeline::Cull::Back;
    return s;
}

// Two quads through each other (one seen from behind), a triangle in the plane of one, a wall far behind.
Subject depth_crossing() {
    Subject s = in_perspective(96, 64, {0.4, 0.9, 4}, {0.1, 0.1, 0}, 0.5, 30);
    s.settings.cull = pipeline::Cull::None;
    add(s, quad(vertex(-1.7, -0.8, 0.9), vertex(1.4, -0.9, -0.8), vertex(1.5, 0.9, -0.9),
                vertex(-1.6, 1.1, 0.8)));
    add(s, quad(vertex(-1.5, 0.7, -0.9), vertex(1.2, 1.1, 1.1), vertex(1.3, -0.7, 0.9),
                vertex(-1.4, -0.9, -1.1)));
    add(s, triangles({vertex(-1.7, -0.8, 0.9), vertex(1.4, -0.9, -0.8), vertex(0.2, 1.3, 0.1)}));
    add(s, quad(vertex(-3, -0.4, -4), vertex(3, -0.5, -4), vertex(3.1, 1.9, -9), vertex(-2.9, 2, -9)));
    return s;
}

// A triangle, the same again with other texture coordinates (equal depths: the first one stays), and a floor
// under it, drawn last.
Subject floor() {
    Subject s = in_perspective(96, 64, {0.3, 1.1, 3}, {0.2, 0.1, 0}, 0.2, 100);
    const raster::Texture* texture = letter(s, raster::Encoding::Raw);
    Mesh sail = triangles({vertex(-1.1, 0.1, 0.3, 0.1, 0.2), vertex(0.4, 0.05, 0.9, 1.1, 0.1),
                           vertex(-0.5, 1.3, -0.4, 0.3, 1.2)});
    add(s, sail);
    for (Vertex& v : sail.vertices) v.uv.x += real(0.3);
    add(s, sail);
    add(s, quad(vertex(-1.5, 0, 1.9, -0.4, -0.3), vertex(1.7, 0, 1.8, 2.3, -0.2),
                vertex(3.3, 0, -9, 2.9, 5.3), vertex(-3.1, 0, -8, -0.6, 4.9)));
    for (raster::Model& model : s.scene.models) model.texture = texture;
    return s;
}
Subject small_floor() {
    Subject s = floor();
    s.width = 48, s.height = 32;
    return s;
}
Subject floor_nearest() {
    Subject s = floor();
    s.settings.texture_filter = raster::Filter::Nearest;
    return s;
}

// An egg, stretched and turned, in the light of a warm lamp and a blue sky.
Subject egg(raster::Shading shading) {
    Subject s = in_perspective(96, 80, {0.5, 0.8, 3.4}, {0.05, 0, 0}, 0.5, 20);
    s.settings.shading = shading;
    raster::Model& model = add(s, ball(), placed({0, 0.05, 0}, {1, 0.3, 2}, 35, {0.6, 1.2, 0.8}));
    model.material = {real(0.08), real(0.7), real(0.5), 24, {real(0.9), real(0.6), real(0.3)}};
    pipeline::Light lamp, sky;
    lamp.position = {{real(2), real(1.5), real(2.5)}}, lamp.color = {1, real(0.9), real(0.7)};
    sky.kind = pipeline::Light::Kind::Directional;
    sky.direction = {{real(0.5), real(-1), real(0.3)}}, sky.color = {real(0.1), real(0.15), real(0.4)};
    s.scene.lights = {lamp, sky};
    return s;
}
Subject egg_flat() { return egg(raster::Shading::Flat); }
Subject egg_gouraud() { return egg(raster::Shading::Gouraud); }
Subject egg_phong() { return egg(raster::Shading::Phong); }

// Everything at once: a textured floor that runs under the eye (clipped at near), a textured egg, an open
// leaf seen from behind, no far plane, sRGB out.
Subject room() {
    Subject s = egg(raster::Shading::Phong);
    s.scene.camera.clip_from_eye = *pipeline::perspective(
        {60}, 96.0 / 80, 0.1, std::numeric_limits<double>::infinity(), pipeline::DepthRange::Reversed);
    s.settings.output = raster::Output::Srgb;
    s.settings.cull = pipeline::Cull::None;
    const raster::Texture* texture = letter(s, raster::Encoding::Srgb);
    s.scene.models[0].texture = texture;
    Mesh ground = quad(vertex(-4, -0.9, 5, -1, -1), vertex(4, -0.9, 5, 3, -1), vertex(6, -0.9, -7, 3.5, 5),
                       vertex(-6, -0.9, -7, -1.5, 5));
    for (Vertex& v : ground.vertices) v.normal = {{0, 1, 0}};
    add(s, ground).texture = texture;
    raster::Model& leaf =
        add(s, triangles({vertex(-1.6, -0.8, 0.4), vertex(-0.7, 1.3, -0.4), vertex(-1.0, -0.6, 1.1)}));
    leaf.material.color = {real(0.2), real(0.8), real(0.3)}, leaf.two_sided = true;
    return s;
}

constexpr Case cases[] = {
    {"clipped/planes", Stage::Clipped, clip_planes},
    {"window/ties", Stage::Window, window_ties},
    {"window/cubes", Stage::Window, window_cube},
    {"coverage/fan", Stage::Coverage, coverage_fan},
    {"coverage/cubes", Stage::Coverage, coverage_cube},
    {"depth/crossing", Stage::Depth, depth_crossing},
    {"attributes/floor", Stage::Attributes, small_floor},
    {"texture/nearest", Stage::Color, floor_nearest},
    {"texture/bilinear", Stage::Color, floor},
    {"flat/egg", Stage::Color, egg_flat},
    {"gouraud/egg", Stage::Color, egg_gouraud},
    {"phong/egg", Stage::Color, egg_phong},
    {"final/room", Stage::Final, room},
};

}  // namespace

std::span<const Case> all_cases() { return cases; }

}  // namespace relevo::golden
