// Scenes with everything in them: models and objects by pictures, frame by frame.
#include "samples/scene/draw_scene.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "raster/draw.hpp"

namespace relevo::scene {
namespace {

LoadedScene parsed(const std::string& text) {
    auto scene = parse_scene(text, "scene.toml");
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? std::move(*scene) : LoadedScene{};
}
struct Result {
    raster::Frame frame;
    std::vector<std::string> notes;
};
Result drawn(const LoadedScene& scene, int number = 0, int threads = 1) {
    Result out{make_frame(scene), {}};
    raster::fast::Workspace workspace;
    const auto pictures = take_pictures(scene, threads);
    EXPECT_TRUE(pictures) << pictures.error().text();
    for (const relief::Represented& object : pictures->objects)
        EXPECT_EQ(object.settings.prewarp.threads, threads);
    const auto done = draw_scene(scene, *pictures, number, out.frame, workspace);
    EXPECT_TRUE(done) << done.error().text();
    if (done) out.notes = done->notes;
    return out;
}
template <class Pixel>
bool same(const raster::Image<Pixel>& a, const raster::Image<Pixel>& b) {
    return a.pixels().size() == b.pixels().size() &&
           std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size() * sizeof(Pixel)) == 0;
}

const std::string head =
    "[image]\nwidth = 80\nheight = 60\n[camera]\neye = [0.5, 0.7, 3]\ntarget = [0, 0, 0]\n";

TEST(DrawScene, AModelAloneIsWhatTheMachineDraws) {
    const LoadedScene scene = parsed(head + "[[object]]\nmesh = \"torus\"\n");
    raster::Frame machine = make_frame(scene);
    raster::draw(scene.scene, scene.settings, machine);
    const Result ours = drawn(scene);
    EXPECT_TRUE(same(machine.color, ours.frame.color));
    EXPECT_TRUE(same(machine.depth, ours.frame.depth));
    EXPECT_TRUE(ours.notes.empty());
}

// A ball behind a square is hidden by it, whatever it is made of, and hides it from before.
TEST(DrawScene, ModelsAndReliefsHideEachOther) {
    for (const std::string way : {"geometry", "relief", "relief-box", "relief-inverse", "ldi"}) {
        const std::string wall =
            "[[object]]\nmesh = \"plane\"\ntransform = [ { scale = 9 }, { rotate = { axis = [1, 0, 0], "
            "degrees = 90 } }, "
            "{ translate = [0, 0, ZZ] } ]\nmaterial = { color = [1, 0, 0], ambient = 1, diffuse = 0, "
            "specular = 0 }\n";
        const auto with_wall = [&](const std::string& z) {
            std::string text = wall;
            text.replace(text.find("ZZ"), 2, z);
            return drawn(
                parsed(head + "[[object]]\nsurface = \"sphere\"\nrepresentation = \"" + way + "\"\n" + text));
        };
        const raster::Rgba8 red{255, 0, 0, 255};
        const Result before = with_wall("1.5"), behind = with_wall("-1.5");
        EXPECT_EQ(before.frame.color.at(40, 30), red) << way;
        EXPECT_NE(behind.frame.color.at(40, 30), red) << way;
        EXPECT_EQ(behind.frame.color.at(2, 2), red) << way;
    }
}

TEST(DrawScene, ReliefsSeenFromBehindAreDrawnAsGeometryAndNoted) {
    const std::string orbit = "[animation]\nradius = 3\ntarget = [0, 0, 0]\nframes = 2\n";
    const LoadedScene surface =
        parsed(head + orbit + "[[object]]\nsurface = \"bumpy\"\nrepresentation = \"relief\"\n");
    EXPECT_TRUE(drawn(surface, 0).notes.empty());
    const Result behind = drawn(surface, 1);
    ASSERT_EQ(behind.notes.size(), 1u);
    EXPECT_EQ(behind.notes[0],
              "scene.toml:13:18: bumpy: drawn as geometry: the viewer must lie in front of the relief's "
              "plane, not on "
              "it or behind: choose another face, or draw the geometry");
    const Result truth = drawn(parsed(head + orbit + "[[object]]\nsurface = \"bumpy\"\n"), 1);
    EXPECT_TRUE(same(behind.frame.color, truth.frame.color));

    const LoadedScene mesh =
        parsed(head + orbit + "[[object]]\nmesh = \"torus\"\nrepresentation = \"sprite\"\n");
    const Result mesh_behind = drawn(mesh, 1);
    ASSERT_EQ(mesh_behind.notes.size(), 1u);
    const Result mesh_truth = drawn(parsed(head + orbit + "[[object]]\nmesh = \"torus\"\n"), 1);
    EXPECT_TRUE(same(mesh_behind.frame.color, mesh_truth.frame.color));
}

// The plane is at z = 1, a texel 1/128 wide; from 2 texels the object would be drawn as 2 texels, or not at
// all.
TEST(DrawScene, ReliefsSeenFromJustBeforeTheirPlaneAreDrawnAsGeometryAndNoted) {
    const auto seen_from = [](const std::string& z, const std::string& way) {
        return drawn(parsed("[image]\nwidth = 80\nheight = 60\n[camera]\neye = [0.4, 0.3, " + z +
                            "]\ntarget = [0, 0, 0]\nnear = 0.001\n[[object]]\nsurface = \"bumpy\"\n" + way));
    };
    for (const std::string way : {"relief", "sprite-depth"}) {
        const std::string picture = "representation = \"" + way + "\"\n[object.relief]\nradius = 1\n";
        EXPECT_TRUE(seen_from("1.04", picture).notes.empty());
        for (const std::string z : {"1.02", "1.000001"}) {
            const Result near = seen_from(z, picture);
            ASSERT_EQ(near.notes.size(), 1u) << z;
            EXPECT_EQ(
                near.notes[0],
                "scene.toml:10:18: bumpy: drawn as geometry: the viewer is too near to the relief's plane: "
                "the warped picture is a few texels wide");
            EXPECT_TRUE(same(near.frame.color, seen_from(z, "").frame.color)) << z;
        }
        EXPECT_TRUE(seen_from("1.02", "representation = \"sprite\"\n").notes.empty());
        EXPECT_TRUE(seen_from("1.02", "representation = \"relief-inverse\"\n").notes.empty());
    }
}

TEST(DrawScene, AParallelViewDrawsReliefs) {
    const LoadedScene scene = parsed(
        "[image]\nwidth = 80\nheight = 60\n[camera]\nprojection = \"orthographic\"\nheight = 3\neye = [0.6, "
        "0.4, 3]\n"
        "[[object]]\nsurface = \"sphere\"\nrepresentation = \"relief\"\n");
    const Result relief = drawn(scene);
    EXPECT_TRUE(relief.notes.empty());
    std::int64_t covered = 0;
    for (const auto z : relief.frame.depth.pixels()) covered += z != 0;
    EXPECT_NEAR(double(covered), pipeline::pi * 20 * 20, 40);  // a disc of radius 1 of 1.5 half the height
}

std::int64_t covered_pixels(const raster::Frame& frame) {
    std::int64_t covered = 0;
    for (const auto z : frame.depth.pixels()) covered += z != 0;
    return covered;
}

// The plane of a relief may lie before the near plane, or behind the far one: the object counts.
TEST(DrawScene, ThePlaneOfAReliefIsNotClipped) {
    const std::string camera =
        "[image]\nwidth = 80\nheight = 60\n[camera]\neye = [0.8, 0.5, 5]\ntarget = [0, 0, 0]\nnear = 3.5\n"
        "[[object]]\nsurface = \"sphere\"\n";
    const Result truth = drawn(parsed(camera));
    const Result relief =
        drawn(parsed(camera + "representation = \"relief\"\n[object.relief]\nradius = 2\n"));
    EXPECT_NEAR(double(covered_pixels(relief.frame)), double(covered_pixels(truth.frame)), 20);
}

TEST(DrawScene, AMorphIsForViewersBetweenItsViews) {
    const std::string object = "[[object]]\nmesh = \"torus\"\nrepresentation = \"morph\"\n";
    const LoadedScene turn =
        parsed(head + "[animation]\nradius = 3\ntarget = [0, 0, 0]\nframes = 4\n" + object);
    EXPECT_TRUE(drawn(turn, 0).notes.empty());
    for (const int frame : {1, 2, 3}) {
        const Result aside = drawn(turn, frame);
        ASSERT_EQ(aside.notes.size(), 1u);
        EXPECT_NE(aside.notes[0].find("does not stand between the two views"), std::string::npos);
        EXPECT_GT(covered_pixels(aside.frame), 100);
    }
    // from the pole all azimuths are one
    const LoadedScene pole = parsed(head + object + "[object.relief]\nelevation = 90\n");
    const auto pictures = take_pictures(pole);
    ASSERT_FALSE(pictures);
    EXPECT_EQ(pictures.error().text(),
              "scene.toml:9:18: torus: the two views have the same eye: a view morph needs two places");
}

TEST(DrawScene, ThreadsOfThePrewarpChangeNoByte) {
    const LoadedScene scene = parsed(
        head +
        "[[object]]\nsurface = \"complex\"\nrepresentation = \"relief\"\n[object.relief]\ntexels = 400\n");
    const Result one = drawn(scene), three = drawn(scene, 0, 3);
    EXPECT_GT(covered_pixels(one.frame), 100);
    EXPECT_TRUE(same(one.frame.color, three.frame.color));
    EXPECT_TRUE(same(one.frame.depth, three.frame.depth));
}

TEST(DrawScene, PicturesThatShowNothingAreNoted) {
    const LoadedScene edge_on = parsed(head + "[[object]]\nmesh = \"plane\"\nrepresentation = \"sprite\"\n");
    const auto pictures = take_pictures(edge_on);
    ASSERT_TRUE(pictures);
    ASSERT_EQ(pictures->notes.size(), 1u);
    EXPECT_EQ(pictures->notes[0],
              "scene.toml:9:18: plane: its pictures are empty: from this azimuth and elevation no "
              "texel meets it");
}

TEST(DrawScene, WhatHasNoExtentIsRefusedWithItsPlace) {
    LoadedScene scene = parsed(head + "[[object]]\nmesh = \"torus\"\nrepresentation = \"ldi\"\n");
    EXPECT_TRUE(take_pictures(scene));
    scene.reliefs[0].models->models.clear();
    const auto pictures = take_pictures(scene);
    ASSERT_FALSE(pictures);
    EXPECT_EQ(pictures.error().text(), "scene.toml:9:18: torus: the object has no extent");
}

}  // namespace
}  // namespace relevo::scene
