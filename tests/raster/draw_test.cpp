#include "raster/draw.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "pipeline/projection.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/exact_rational.hpp"
#include "tests/support/hard.hpp"

namespace relevo::raster {
namespace {

namespace hard = tests::hard;
using pipeline::Cull;
using pipeline::Degrees;
using pipeline::Vec3;
using tests::Drawing;
using tests::drawing_of;
using tests::same_drawing;
using tests::Watch;
using tests::watch_pixels;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr auto nan_of = std::numeric_limits<Scalar>::quiet_NaN();
constexpr auto inf_of = std::numeric_limits<Scalar>::infinity();

Drawing letters(const Watch& watch) {  // 'a' where the first primitive is seen, 'b' the second...
    return drawing_of(watch.seen, [](int n) { return n == 0 ? '.' : static_cast<char>('a' + n - 1); });
}

// ---------------------------------------------------------------------------------------- coverage, drawn
TEST(Draw, AnEdgeThroughCentresBelongsToOneSide) {
    // the long side passes the centres of (1,4) (2,3) (3,2) (4,1) and is a right edge: they stay out
    const Watch watch = watch_pixels(8, 8, {{{{1, 1, 1}, {5, 1, 1}, {1, 5, 1}}}});
    EXPECT_TRUE(same_drawing(drawing_of(watch.covered), {"........",  //
                                                         ".###....",  //
                                                         ".##.....",  //
                                                         ".#......",  //
                                                         "........",  //
                                                         "........",  //
                                                         "........",  //
                                                         "........"}));
}

TEST(Draw, TwoHalvesOfASquareShareNoCentre) {
    const Watch watch = watch_pixels(8, 8,
                                     {{{{1.5f, 1.5f, 1}, {5.5f, 1.5f, 1}, {1.5f, 5.5f, 1}}},
                                      {{{5.5f, 1.5f, 1}, {5.5f, 5.5f, 1}, {1.5f, 5.5f, 1}}}});
    EXPECT_TRUE(same_drawing(letters(watch), {"........",  //
                                              ".aaaa...",  //
                                              ".aaab...",  //
                                              ".aabb...",  //
                                              ".abbb...",  //
                                              "........",  //
                                              "........",  //
                                              "........"}))
        << "top and left borders lie on centres and are in, bottom and right ones are out";
    for (const int n : watch.covered.pixels()) EXPECT_LE(n, 1);
}

TEST(Draw, ACornerOnACentreAndAThinNeedle) {
    // the corner at the centre of (1,1) is the end of a right edge: only centres inside are in
    const Watch corner = watch_pixels(4, 4, {{{{1.5f, 1.5f, 1}, {3.5f, 2.0f, 1}, {2.0f, 3.5f, 1}}}});
    EXPECT_TRUE(same_drawing(drawing_of(corner.covered), {"....",  //
                                                          "....",  //
                                                          "..#.",  //
                                                          "...."}));
    // 1/256 pixel wide, with all centres of a column between its sides
    const Watch needle = watch_pixels(4, 4, {{{{1.5f, 0, 1}, {1.5f, 4, 1}, {1.5f + 1 / 256.0f, 2, 1}}}});
    EXPECT_TRUE(same_drawing(drawing_of(needle.covered), {".#..",  //
                                                          ".#..",  //
                                                          ".#..",  //
                                                          ".#.."}));
}

TEST(Draw, ThePictureCutsWhatPassesItsBorders) {
    const Watch watch = watch_pixels(4, 4, {{{{-9, 1, 1}, {13, 1, 1}, {2, 13, 1}}}});
    EXPECT_TRUE(same_drawing(drawing_of(watch.covered), {"....",  //
                                                         "####",  //
                                                         "####",  //
                                                         "####"}));
    const Watch one = watch_pixels(1, 1, {{{{-3, -3, 1}, {3, -3, 1}, {0, 3, 1}}}});
    EXPECT_TRUE(same_drawing(drawing_of(one.covered), {"#"}));
}

// Every family of the screen, the huge ones too, against coverage in clip space.
TEST(Draw, EveryScreenFamilyIsRightAgainstClipSpace) {
    for (const auto& family : hard::screen_families())
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const hard::ScreenTriangle s = hard::make(family, seed, 32, 32);
            std::array<Vec3, 3> corner;
            for (std::size_t i = 0; i < 3; ++i)
                corner[i] = {static_cast<Scalar>(s[i].x), static_cast<Scalar>(s[i].y), Scalar(0.5)};
            const pipeline::Mesh mesh = tests::mesh_of({corner});
            Scene scene;
            scene.models.push_back({&mesh, {}, {}, nullptr, false});
            scene.camera = tests::pixel_camera(32, 32);
            Frame frame = tests::frame_of(32, 32);
            Watch got(32, 32);
            hard::ClipTriangle clip;
            got.on_vertex = [&](const VertexTransformed& e) {
                for (int k = 0; k < 4; ++k) clip[e.vertex][std::size_t(k)] = static_cast<double>(e.clip.v[k]);
            };
            tests::draw_watched(scene, tests::unlit(), frame, got);
            if (family.name == "not_a_number" || family.name == "infinite") {
                EXPECT_EQ(got.count(Rejection::NonFinite), 1) << hard::name(family.name, seed);
                continue;
            }
            const tests::exact::ClipTriangle right(clip, 32, 32);
            if (right.edge_on()) continue;
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 32; ++x) {
                    const auto answer = right.at(x, y);
                    if (answer.distance > 1.0 / 256) {
                        ASSERT_EQ(got.covered.at(x, y), answer.covered ? 1 : 0)
                            << hard::name(family.name, seed) << " pixel " << x << "," << y;
                    }
                }
        }
}

// --------------------------------------------------------------------------------------------- depth
TEST(Draw, NearerWinsInAnyOrderAndTheFirstWinsATie) {
    const std::array<Vec3, 3> far{{{0, 0, 0.25f}, {8, 0, 0.25f}, {0, 8, 0.25f}}},
        near{{{0, 0, 0.5f}, {4, 0, 0.5f}, {0, 4, 0.5f}}},
        also_far{{{0, 0, 0.25f}, {8, 0, 0.25f}, {8, 8, 0.25f}}};
    const auto near_is = [](const Watch& w, int number) {
        return drawing_of(w.seen, [&](int n) { return n == number ? 'n' : '.'; });
    };
    EXPECT_TRUE(same_drawing(near_is(watch_pixels(4, 4, {far, near}), 2), {"nnn.", "nn..", "n...", "...."}));
    EXPECT_TRUE(same_drawing(near_is(watch_pixels(4, 4, {near, far}), 1), {"nnn.", "nn..", "n...", "...."}));
    EXPECT_TRUE(same_drawing(letters(watch_pixels(4, 4, {far, also_far})), {"aaaa", "aaaa", "aaaa", "aaaa"}));
    EXPECT_TRUE(same_drawing(letters(watch_pixels(4, 4, {also_far, far})), {"aaaa", "baaa", "bbaa", "bbba"}));
}

TEST(Draw, ForwardDepthTurnsTheTestAround) {
    Settings forward = tests::unlit();
    forward.depth = DepthFormat::Float32Forward;
    const std::array<Vec3, 3> small_z{{{0, 0, 0.25f}, {16, 0, 0.25f}, {0, 16, 0.25f}}},
        large_z{{{0, 0, 0.5f}, {16, 0, 0.5f}, {0, 16, 0.5f}}};
    for (const auto& order : {std::vector{small_z, large_z}, std::vector{large_z, small_z}}) {
        const bool small_first = order[0] == small_z;
        const Drawing a(4, "aaaa"), b(4, "bbbb");
        EXPECT_TRUE(same_drawing(letters(watch_pixels(4, 4, order, forward)), small_first ? a : b));
        EXPECT_TRUE(same_drawing(letters(watch_pixels(4, 4, order)), small_first ? b : a));
    }
}

TEST(Draw, WhatLiesExactlyAtTheClearedDepthIsNotDrawn) {
    const Watch watch = watch_pixels(4, 4, {{{{0, 0, 0}, {16, 0, 0}, {0, 16, 0}}}});
    for (const int n : watch.covered.pixels()) EXPECT_EQ(n, 1);
    for (const int n : watch.seen.pixels()) EXPECT_EQ(n, 0);
}

// ------------------------------------------------------------------------------- what is dropped, and why
TEST(Draw, DroppedTrianglesAreCountedByReason) {
    const std::array<Vec3, 3> good{{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}};
    Settings settings = tests::unlit();
    settings.cull = Cull::Back;
    const Watch watch =
        watch_pixels(4, 4,
                     {good,                                                    // clockwise: a back face
                      {{{0, 0, 1}, {0, 4, 1}, {4, 0, 1}}},                     // drawn
                      {{{nan_of, 0, 1}, {4, 0, 1}, {0, 4, 1}}},                //
                      {{{0, 0, 1}, {4, inf_of, 1}, {0, 4, 1}}},                //
                      {{{0, 0, 1}, {4, 0, 1}, {0, 4, -inf_of}}},               //
                      {{{0, 0, 1}, {2, 2, 1}, {4, 4, 1}}},                     // a line
                      {{{1, 1, 1}, {1 + 1e-4f, 1, 1}, {1, 1 + 1e-4f, 1}}},     // a point after snapping
                      {{{0, 0, -1}, {4, 0, -1}, {0, 4, -0.5f}}},               // beyond far
                      {{{0, 0, 2}, {4, 0, 2}, {0, 4, 3}}},                     // before near
                      {{{100, 0, 1}, {200, 0, 1}, {100, 9, 1}}},               // right of the guard band
                      {{{1.6f, 1.6f, 1}, {1.6f, 1.9f, 1}, {1.9f, 1.6f, 1}}}},  // between centres
                     settings);
    EXPECT_EQ(watch.count(Rejection::Culled), 1);
    EXPECT_EQ(watch.count(Rejection::NonFinite), 3);
    EXPECT_EQ(watch.count(Rejection::ZeroArea), 2);
    EXPECT_EQ(watch.count(Rejection::Outside), 3);
    EXPECT_EQ(watch.count(Rejection::NoPixel), 1);
    EXPECT_TRUE(same_drawing(letters(watch), {"bbb.", "bb..", "b...", "...."}));
}

TEST(Draw, ANonFiniteVertexDropsOnlyTheTrianglesThatUseIt) {
    pipeline::Mesh mesh;
    for (const Vec3 p : {Vec3{0, 0, 1}, Vec3{4, 0, 1}, Vec3{4, 4, 1}, Vec3{0, 4, 1}, Vec3{nan_of, 2, 1}})
        mesh.vertices.push_back({{p}, {{0, 0, 1}}, {0, 0}});
    mesh.indices = {0, 1, 2, 2, 3, 4, 0, 2, 3};
    Scene scene;
    scene.models.push_back({&mesh, {}, {}, nullptr, false});
    scene.camera = tests::pixel_camera(4, 4);
    Frame frame = tests::frame_of(4, 4);
    Watch watch(4, 4);
    tests::draw_watched(scene, tests::unlit(), frame, watch);
    EXPECT_EQ(watch.transformed, 5) << "each shared vertex once";
    EXPECT_EQ(watch.count(Rejection::NonFinite), 1);
    EXPECT_TRUE(same_drawing(letters(watch), {"aaaa", "caaa", "ccaa", "ccca"}));
}

TEST(Draw, NonFiniteNormalsAndTextureCoordinatesGiveAPicture) {
    pipeline::Mesh mesh = tests::mesh_of({{{{0, 0, 1}, {8, 0, 1}, {0, 8, 1}}}});
    mesh.vertices[0].normal = {{nan_of, inf_of, 0}};
    mesh.vertices[1].uv = {nan_of, inf_of};
    const std::vector<std::uint8_t> texels(3 * 4 * 4, 200);
    const Texture texture = make_texture(4, 4, 3, texels, Encoding::Raw);
    for (const Shading shading : {Shading::Unlit, Shading::Flat, Shading::Gouraud, Shading::Phong}) {
        Scene scene;
        scene.models.push_back({&mesh, {}, {}, &texture, false});
        scene.lights.push_back({});
        scene.camera = tests::pixel_camera(4, 4);
        Settings settings = tests::unlit();
        settings.shading = shading;
        Frame frame = tests::frame_of(4, 4, true);
        draw(scene, settings, frame);
        for (const auto& c : frame.linear.pixels())
            EXPECT_TRUE(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b));
    }
}

// -------------------------------------------------------------------------------- cameras among triangles
Watch through_the_lens(const std::vector<std::array<Vec3, 3>>& triangles, int size = 8, double far = inf) {
    const pipeline::Mesh mesh = tests::mesh_of(triangles);
    Scene scene;
    scene.models.push_back({&mesh, {}, {}, nullptr, false});
    scene.camera.clip_from_eye = *pipeline::perspective({90}, 1, 0.125, far, pipeline::DepthRange::Reversed);
    Frame frame = tests::frame_of(size, size);
    Watch watch(size, size);
    tests::draw_watched(scene, tests::unlit(), frame, watch);
    return watch;
}

TEST(Draw, AFloorFromBehindTheCameraToTheHorizon) {
    const Drawing lower_half = {"........", "........", "........", "........",
                                "########", "########", "########", "########"};
    for (const Scalar height : {Scalar(-1000), Scalar(-1), Scalar(-0.2)}) {
        const Watch watch =
            through_the_lens({{{{-1e6f, height, -1e6f}, {0, height, 1e6f}, {1e6f, height, -1e6f}}}});
        EXPECT_EQ(watch.clipped, 1);
        EXPECT_TRUE(same_drawing(drawing_of(watch.covered), lower_half)) << "eye at height " << -height;
    }
    // near = 1/8 hides what is nearer: the bottom rows look at points before the near plane
    const Watch close = through_the_lens({{{{-9, -0.1f, 0}, {9, -0.1f, 0}, {0, -0.1f, -9e4f}}}});
    EXPECT_TRUE(same_drawing(Drawing{drawing_of(close.covered)[7]}, {"........"}));
}

TEST(Draw, TheCameraInsideATriangleSeesNothingOfIt) {
    const Watch watch = through_the_lens({{{{-3, 0, -3}, {3, 0, -3}, {0, 0, 5}}}});
    EXPECT_EQ(std::count(watch.covered.pixels().begin(), watch.covered.pixels().end(), 0), 64);
}

TEST(Draw, ATriangleAroundTheCameraFillsThePicture) {
    const Watch watch = through_the_lens({{{{-50, -50, 10}, {50, -50, 10}, {0, 80, -40}}}});
    for (const int n : watch.covered.pixels()) EXPECT_LE(n, 1);
    const Watch wall = through_the_lens({{{{-1e7f, -1e7f, -2}, {1e7f, -1e7f, -2}, {0, 2e7f, -2}}}});
    for (const int n : wall.covered.pixels()) EXPECT_EQ(n, 1);
}

TEST(Draw, TheFarPlaneCuts) {
    const std::vector<std::array<Vec3, 3>> floor = {{{{-1e6f, -1, -1e6f}, {0, -1, 1e6f}, {1e6f, -1, -1e6f}}}};
    // far = 4: at most 4 away; the row of centre v sees the floor at 1/v, so v = 1/8 (8 away) stays empty
    EXPECT_TRUE(same_drawing(
        drawing_of(through_the_lens(floor, 8, 4).covered),
        {"........", "........", "........", "........", "........", "########", "########", "########"}));
}

TEST(Draw, InterpolatedEyePositionsProjectBackToTheirPixels) {
    hard::Random r(3);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        const auto p = [&] {
            const double z = r.between(0.5, 6);
            return Vec3{static_cast<Scalar>(z * r.between(-1.2, 1.2)),
                        static_cast<Scalar>(z * r.between(-1.2, 1.2)), static_cast<Scalar>(-z)};
        };
        const pipeline::Mesh mesh = tests::mesh_of({{p(), p(), p()}});
        Scene scene;
        scene.models.push_back({&mesh, {}, {}, nullptr, false});
        scene.camera.clip_from_eye =
            *pipeline::perspective({90}, 1, 0.125, inf, pipeline::DepthRange::Reversed);
        Settings settings = tests::unlit();
        settings.shading = Shading::Phong;
        Frame frame = tests::frame_of(64, 64);
        Watch watch(64, 64);
        watch.on_shaded = [&](const FragmentShaded& e) {
            const glm::dvec4 eye(e.varying[0], e.varying[1], e.varying[2], 1),
                clip = scene.camera.clip_from_eye.m * eye;
            const double x = (clip.x / clip.w + 1) * 32, y = (1 - clip.y / clip.w) * 32;
            worst = std::max({worst, std::abs(x - e.x - 0.5), std::abs(y - e.y - 0.5)});
            EXPECT_NEAR(static_cast<double>(e.inv_w) * clip.w, 1, 1e-4);
            EXPECT_NEAR(static_cast<double>(e.b0 + e.b1 + e.b2), 1, 1e-6);
        };
        tests::draw_watched(scene, settings, frame, watch);
    }
    EXPECT_LT(worst, 1.0 / 256) << "snapping moves the corners by up to 1/512 pixel";
    EXPECT_GT(worst, 0);
}

// ------------------------------------------------------------------------------------- faces and their light
struct Lit {
    Cull cull = Cull::None;
    bool two_sided = false;
    bool mirrored = false;
    bool turned = false;  // the triangle shows its back
    Shading shading = Shading::Flat;

    LinearRgb centre() const {
        pipeline::Mesh mesh = tests::mesh_of({{{{-4, -4, 0}, {4, -4, 0}, {0, 8, 0}}}});
        if (turned) {
            std::swap(mesh.indices[1], mesh.indices[2]);
            for (auto& v : mesh.vertices) v.normal = {{0, 0, -1}};
        }
        Scene scene;
        scene.models.push_back({&mesh, {}, {}, nullptr, two_sided});
        scene.models[0].material = {Scalar(0.25), Scalar(0.5), 0, 1, {1, 1, 1}};
        if (mirrored) scene.models[0].world_from_object.m[0][0] = -1;
        pipeline::Light light;
        light.kind = pipeline::Light::Kind::Directional;
        scene.lights.push_back(light);
        scene.background = {0, 0, 0};
        scene.camera.clip_from_eye =
            *pipeline::orthographic(-1, 1, -1, 1, -1, 1, pipeline::DepthRange::Reversed);
        scene.camera.parallel = true;
        Settings settings = tests::unlit();
        settings.cull = cull, settings.shading = shading;
        Frame frame = tests::frame_of(2, 2, true);
        draw(scene, settings, frame);
        return frame.linear.at(1, 1);
    }
};

TEST(Draw, FrontFacesAreLitBackFacesWhenTwoSided) {
    const LinearRgb full{Scalar(0.75), Scalar(0.75), Scalar(0.75)},
        dark{Scalar(0.25), Scalar(0.25), Scalar(0.25)}, none{0, 0, 0};
    for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong})
        for (const bool mirrored : {false, true}) {
            Lit lit;
            lit.shading = shading, lit.mirrored = mirrored;
            EXPECT_EQ(lit.centre(), full) << "a front face, mirrored " << mirrored;
            lit.cull = Cull::Back;
            EXPECT_EQ(lit.centre(), full);
            lit.cull = Cull::Front;
            EXPECT_EQ(lit.centre(), none);
            lit.turned = true;
            EXPECT_EQ(lit.centre(), dark) << "a back face has the light behind it, mirrored " << mirrored;
            lit.two_sided = true;
            EXPECT_EQ(lit.centre(), full) << "and is lit from its own side when two-sided";
            lit.cull = Cull::None;
            EXPECT_EQ(lit.centre(), full);
            lit.cull = Cull::Back;
            EXPECT_EQ(lit.centre(), none);
            lit.turned = false, lit.cull = Cull::None;
            EXPECT_EQ(lit.centre(), full) << "two sides do not change a front face";
        }
}

TEST(Draw, AMirroredModelIsTheMirroredPicture) {
    const auto picture = [](double x) {
        const pipeline::Mesh mesh =
            tests::mesh_of({{{{-3.1f, -3.2f, 0}, {2.3f, -2.1f, 0}, {-2.4f, 3.3f, 0}}}});
        Scene scene;
        scene.models.push_back(
            {&mesh,
             pipeline::scale<pipeline::World>({x, 1, 1}).m[0][0] < 0
                 ? pipeline::Affine<pipeline::World, pipeline::Object>{pipeline::scaling_matrix({-1, 1, 1})}
                 : pipeline::Affine<pipeline::World, pipeline::Object>{},
             {},
             nullptr,
             false});
        scene.camera.clip_from_eye =
            *pipeline::orthographic(-4, 4, -4, 4, -1, 1, pipeline::DepthRange::Reversed);
        Settings settings = tests::unlit();
        settings.cull = Cull::Back;
        Frame frame = tests::frame_of(8, 8);
        Watch watch(8, 8);
        tests::draw_watched(scene, settings, frame, watch);
        return drawing_of(watch.covered);
    };
    Drawing mirrored = picture(-1), plain = picture(1);
    for (auto& row : plain) std::reverse(row.begin(), row.end());
    EXPECT_TRUE(same_drawing(mirrored, plain));
}

// ------------------------------------------------------------------------------------------------- probes
// A scene with something of everything: clipped floor, ball-like fan, back faces, textures, two lights.
struct Everything {
    pipeline::Mesh floor, fan;
    Texture texture;
    Scene scene;

    Everything() {
        floor = tests::mesh_of({{{{-1e4f, -1, -1e4f}, {0, -1, 50}, {1e4f, -1, -1e4f}}}});
        for (auto& v : floor.vertices)
            v.normal = {{0, 1, 0}}, v.uv = {v.position.v.x / 3, v.position.v.z / 3};
        hard::Random r(9);
        fan.vertices.push_back({{{0, 0, 1}}, {{0, 0, 1}}, {0.5f, 0.5f}});
        for (int i = 0; i < 24; ++i) {
            const Degrees angle{15.0 * i};
            const Vec3 p{static_cast<Scalar>(pipeline::cos(angle)), static_cast<Scalar>(pipeline::sin(angle)),
                         static_cast<Scalar>(r.between(-0.5, 0.5))};
            fan.vertices.push_back({{p}, {{p.x, p.y, Scalar(0.5)}}, {p.x, p.y}});
            for (const int k : {0, 1 + i, 1 + (i + 1) % 24})
                fan.indices.push_back(static_cast<std::uint32_t>(k));
        }
        std::vector<std::uint8_t> rgb;
        for (int i = 0; i < 7 * 5 * 3; ++i) rgb.push_back(static_cast<std::uint8_t>(r.integer(0, 255)));
        texture = make_texture(7, 5, 3, rgb, Encoding::Srgb);
        scene.models.push_back({&floor, {}, {}, &texture, false});
        for (int i = 0; i < 5; ++i) {
            Model m{&fan, {}, {}, i % 2 ? &texture : nullptr, i % 3 == 0};
            m.world_from_object = pipeline::Affine<pipeline::World, pipeline::Object>{
                pipeline::translation_matrix({r.between(-2, 2), r.between(-1, 1), r.between(-6, -0.5)}) *
                *pipeline::rotation_matrix({1, 2, 3}, {r.between(0, 360)}) *
                pipeline::scaling_matrix({i == 2 ? -1.0 : 1.0, 1, 0.7})};
            scene.models.push_back(m);
        }
        scene.lights = {
            {pipeline::Light::Kind::Point, {{1, 3, 1}}, {{0, 0, -1}}, {1, 1, 0.8f}},
            {pipeline::Light::Kind::Directional, {{0, 0, 0}}, {{-1, -1, -1}}, {0.3f, 0.3f, 0.5f}}};
        scene.camera.clip_from_eye =
            *pipeline::perspective({70}, 61.0 / 47, 0.1, inf, pipeline::DepthRange::Reversed);
    }
};

// Hears every event and uses what it hears.
struct HearsAll {
    double sum = 0;
    int events = 0;
    void on(const VertexTransformed& e) {
        sum += static_cast<double>(e.clip.v.w) + static_cast<double>(e.eye.v.x), ++events;
    }
    void on(const TriangleRejected& e) { sum += static_cast<int>(e.reason), ++events; }
    void on(const TriangleClipped& e) { sum += static_cast<double>(e.polygon[0].v.x), ++events; }
    void on(const TriangleSnapped& e) {
        sum += e.corners[0].x + static_cast<double>(e.corners[2].z), ++events;
    }
    void on(const FragmentCovered& e) { sum += e.x, ++events; }
    void on(const DepthTested& e) { sum += static_cast<double>(e.z - e.stored), ++events; }
    void on(const FragmentShaded& e) {
        sum += static_cast<double>(e.z * e.inv_w + e.b0 * e.b1 + e.b2) + static_cast<double>(e.color.r),
            ++events;
        for (const Scalar v : e.varying) sum += static_cast<double>(v);
    }
    void on(const pipeline::EdgeCrossed& e) { sum += e.made.x, ++events; }
    void on(const pipeline::PolygonClipped& e) { sum += e.corners_after, ++events; }
};

template <class T>
bool same_bytes(const Image<T>& a, const Image<T>& b) {
    return a.pixels().size() == b.pixels().size() &&
           std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size() * sizeof(T)) == 0;
}

TEST(Draw, WatchingDoesNotChangeAByte) {
    const Everything everything;
    for (const Shading shading : {Shading::Unlit, Shading::Flat, Shading::Gouraud, Shading::Phong})
        for (const Filter filter : {Filter::Nearest, Filter::Bilinear})
            for (const Cull cull : {Cull::None, Cull::Back, Cull::Front}) {
                const Settings settings{shading, filter, DepthFormat::Float32Reversed, cull, Output::Srgb};
                Frame plain = tests::frame_of(61, 47, true), watched = tests::frame_of(61, 47, true),
                      partly = tests::frame_of(61, 47, true);
                draw(everything.scene, settings, plain);
                HearsAll all;
                draw(everything.scene, settings, watched, all);
                Watch some(61, 47);
                tests::draw_watched(everything.scene, settings, partly, some);
                EXPECT_GT(all.events, 1000);
                EXPECT_TRUE(std::isfinite(all.sum));
                EXPECT_GT(some.clipped, 0);
                for (const Frame* other : {&watched, &partly}) {
                    EXPECT_TRUE(same_bytes(plain.color, other->color));
                    EXPECT_TRUE(same_bytes(plain.depth, other->depth));
                    EXPECT_TRUE(same_bytes(plain.linear, other->linear));
                }
            }
}

TEST(Draw, TheFloatPictureIsFilledOnlyWhenAskedFor) {
    const Everything everything;
    Frame with = tests::frame_of(61, 47, true), without = tests::frame_of(61, 47);
    draw(everything.scene, {}, with);
    draw(everything.scene, {}, without);
    EXPECT_TRUE(without.linear.empty());
    EXPECT_TRUE(same_bytes(with.color, without.color));
    for (std::size_t i = 0; i < with.color.pixels().size(); ++i)
        EXPECT_EQ(with.color.pixels()[i], to_rgba8(with.linear.pixels()[i], Output::Srgb));
    const Frame before = with;
    draw(everything.scene, {}, with);
    EXPECT_TRUE(same_bytes(with.color, before.color)) << "draw() clears what it was given";
}

TEST(Draw, PrimitivesAreNumberedOverAllModels) {
    const Everything everything;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> seen;  // model, primitive
    Watch watch(61, 47);
    watch.on_snapped = [&](const TriangleSnapped& e) { seen.emplace_back(e.model, e.primitive); };
    watch.on_rejected = [&](const TriangleRejected& e) { seen.emplace_back(e.model, e.primitive); };
    Frame frame = tests::frame_of(61, 47);
    tests::draw_watched(everything.scene, {}, frame, watch);
    std::vector<char> met(1 + 5 * 24, 0);
    for (const auto& [model, primitive] : seen) {
        ASSERT_LT(primitive, met.size());
        met[primitive] = 1;
        EXPECT_EQ(model, primitive == 0 ? 0u : 1 + (primitive - 1) / 24);
    }
    EXPECT_EQ(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(met.size()));
}

struct Deaf {
    void onn(const FragmentCovered&) {}
};
struct HearsAnotherMachine {
    void on(const int&) {}
};
static_assert(!DrawProbe<Deaf> && !DrawProbe<HearsAnotherMachine>);
static_assert(DrawProbe<NoProbe> && DrawProbe<const NoProbe> && DrawProbe<HearsAll> && DrawProbe<Watch&>);

}  // namespace
}  // namespace relevo::raster
