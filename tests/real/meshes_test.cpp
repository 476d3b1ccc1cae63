// Meshes that others made: the Stanford bunny (69,666 faces, neither normals nor texture coordinates) and
// the spider of the Assimp project (many parts, textures).
#include <cmath>

#include "samples/scene/statistics.hpp"
#include "tests/real/drawn.hpp"

namespace relevo::real {
namespace {

using pipeline::Scalar;

scene::LoadedScene scene_of(const std::string& mesh, std::pair<int, int> size) {
    const std::string text = "[[object]]\nmesh = \"" + mesh + "\"\n";
    return loaded(scene::parse_scene(text, "real.toml", {{}, size}));
}
scene::LoadedScene bunny(int width, int height) {
    return scene_of("/usr/share/glmark2/models/bunny.obj", {width, height});
}
scene::LoadedScene spider(int width, int height) {
    return scene_of("/usr/share/assimp/models/OBJ/spider.obj", {width, height});
}

// Where each triangle ends: rejected once, or drawn over a box of pixels. (Nothing here is clipped.)
void expect_all_triangles_told(const scene::Statistics& s) {
    scene::Statistics::Count rejected = 0;
    for (const auto count : s.rejected) rejected += count;
    const auto culled_or_none =
        s.rejected_for(raster::Rejection::Culled) + s.rejected_for(raster::Rejection::NoPixel);
    EXPECT_EQ(s.clipped, 0u);
    EXPECT_EQ(s.rejected_for(raster::Rejection::NonFinite), 0u);
    EXPECT_EQ(s.pieces - culled_or_none + rejected, s.triangles);
    EXPECT_LE(s.drawn, s.pieces - culled_or_none);
    EXPECT_EQ(s.covered, s.depth_passed + s.depth_failed);
    EXPECT_EQ(s.shaded, s.depth_passed);
}

int drawn_pixels(const scene::LoadedScene& scene, const raster::Frame& frame) {
    const Scalar cleared = raster::cleared_depth(scene.settings.depth);
    return int(std::count_if(frame.depth.pixels().begin(), frame.depth.pixels().end(),
                             [&](Scalar z) { return z != cleared; }));
}

// The four shadings cover the same pixels at the same depths; the counters account for every triangle.
void draw_in_all_shadings(scene::LoadedScene scene) {
    ASSERT_FALSE(scene.scene.models.empty());
    raster::Frame first = frame_of(scene), frame = frame_of(scene);
    scene.settings.shading = raster::Shading::Unlit;
    raster::draw(scene.scene, scene.settings, first);
    for (const raster::Shading shading : all_shadings) {
        scene.settings.shading = shading;
        scene::Statistics statistics = scene::statistics_of(scene.scene);
        raster::draw(scene.scene, scene.settings, frame, statistics);
        EXPECT_TRUE(same_bits(first.depth, frame.depth));
        if (shading != raster::Shading::Unlit && scene.width > 1) {
            EXPECT_FALSE(same_bits(first.color, frame.color));
        }
        expect_all_triangles_told(statistics);
    }
}

TEST(Bunny, HasItsFacesAndAveragedNormals) {
    const scene::LoadedScene scene = bunny(64, 64);
    ASSERT_EQ(scene.scene.models.size(), 1u);
    const pipeline::Mesh& mesh = *scene.scene.models[0].mesh;
    EXPECT_EQ(mesh.triangles(), 69666u);
    EXPECT_FALSE(scene.descriptions[0].had_normals);
    EXPECT_FALSE(scene.descriptions[0].has_uv);
    for (const pipeline::Vertex& v : mesh.vertices)
        ASSERT_NEAR(pipeline::dot(v.normal.v, v.normal.v), 1, 1e-5);
}

TEST(Bunny, OnePixel) { draw_in_all_shadings(bunny(1, 1)); }
TEST(Bunny, SevenByFivePixels) { draw_in_all_shadings(bunny(7, 5)); }
TEST(Bunny, AsUsual) { draw_in_all_shadings(bunny(640, 480)); }

TEST(Bunny, TheLargestPictureCoversTheSameShare) {
    const scene::LoadedScene small = bunny(512, 512), large = bunny(8192, 8192);
    raster::Frame small_frame = frame_of(small), large_frame = frame_of(large);
    raster::draw(small.scene, small.settings, small_frame);
    raster::draw(large.scene, large.settings, large_frame);
    const double share = drawn_pixels(small, small_frame) / (512.0 * 512),
                 large_share = drawn_pixels(large, large_frame) / (8192.0 * 8192);
    EXPECT_GT(share, 0.2);
    EXPECT_NEAR(large_share, share, 0.002);
    // The centre of a small pixel is a corner of the large picture's pixels: depths beside it agree.
    int compared = 0, near = 0;
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
            const Scalar z = small_frame.depth.at(x, y),
                         beside = large_frame.depth.at(16 * x + 8, 16 * y + 8);
            if (z == 0 || beside == 0) continue;
            ++compared, near += std::abs(z - beside) < Scalar(0.002) * z;
        }
    EXPECT_GT(compared, 40000);
    EXPECT_GT(near, compared * 99 / 100);
}

TEST(Spider, EveryPartInEveryShading) {
    const scene::LoadedScene scene = spider(320, 240);
    EXPECT_GT(scene.scene.models.size(), 5u);
    EXPECT_FALSE(scene.textures.empty());
    raster::Frame frame = frame_of(scene);
    raster::draw(scene.scene, scene.settings, frame);
    EXPECT_GT(drawn_pixels(scene, frame), 3000);
    draw_in_all_shadings(spider(320, 240));
    draw_in_all_shadings(spider(7, 5));
}

}  // namespace
}  // namespace relevo::real
