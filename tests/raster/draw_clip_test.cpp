// The whole machine against coverage computed in clip space, before any division or clipping.
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "raster/draw.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/exact_rational.hpp"
#include "tests/support/hard.hpp"

namespace relevo::raster {
namespace {

namespace exact = tests::exact;
namespace hard = tests::hard;

tests::Watch draw_one(const hard::ClipTriangle& t, int width, int height) {
    const pipeline::Mesh mesh = tests::unit_corners();
    Scene scene;
    scene.models.push_back({&mesh, {}, {}, nullptr, false});
    scene.camera = tests::camera_to(t);
    scene.background = {0, 0, 0};
    Frame frame = tests::frame_of(width, height);
    tests::Watch watch(width, height);
    tests::draw_watched(scene, tests::unlit(), frame, watch);
    return watch;
}

struct Size {
    int width, height;
};
constexpr Size sizes[] = {{24, 24}, {31, 17}, {64, 8}};

TEST(DrawClip, EveryFiniteFamilyIsRightAgainstClipSpace) {
    const int seeds = hard::cases(60);
    std::int64_t all_covered = 0;
    for (const auto& family : hard::clip_families()) {
        if (!family.finite) continue;
        std::int64_t covered = 0, near_an_edge = 0, wrong_near_an_edge = 0;
        for (int i = 0; i < seeds; ++i) {
            const auto seed = static_cast<std::uint64_t>(i);
            const Size size = sizes[std::size_t(i) % std::size(sizes)];
            const hard::ClipTriangle t = hard::make(family, seed);
            const exact::ClipTriangle right(t, size.width, size.height);
            const tests::Watch watch = draw_one(t, size.width, size.height);
            if (right.edge_on()) continue;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    const auto answer = right.at(x, y);
                    const int got = watch.covered.at(x, y);
                    covered += answer.covered;
                    if (answer.distance <= 1.0 / 256) {
                        ++near_an_edge, wrong_near_an_edge += got != (answer.covered ? 1 : 0);
                        continue;
                    }
                    ASSERT_EQ(got, answer.covered ? 1 : 0)
                        << hard::name(family.name, seed) << " pixel " << x << "," << y << ", "
                        << answer.distance << " pixels from an edge";
                }
        }
        EXPECT_LE(wrong_near_an_edge, near_an_edge);
        all_covered += covered;
    }
    EXPECT_GT(all_covered, 1000 * seeds);
}

TEST(DrawClip, NonFiniteCornersAreDroppedAndCounted) {
    for (const auto& family : hard::clip_families()) {
        if (family.finite) continue;
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            const tests::Watch watch = draw_one(hard::make(family, seed), 16, 16);
            EXPECT_EQ(watch.count(Rejection::NonFinite), 1) << hard::name(family.name, seed);
            EXPECT_EQ(watch.snapped, 0);
            EXPECT_TRUE(tests::same_drawing(tests::drawing_of(watch.covered),
                                            tests::Drawing(16, std::string(16, '.'))));
        }
    }
}

TEST(DrawClip, EveryTriangleIsDrawnOrDroppedForOneReason) {
    for (const auto& family : hard::clip_families())
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            const tests::Watch watch = draw_one(hard::make(family, seed), 16, 16);
            const int dropped = std::accumulate(std::begin(watch.rejected), std::end(watch.rejected), 0);
            EXPECT_EQ(watch.transformed, 3);
            if (watch.clipped == 0) {
                EXPECT_EQ(dropped + watch.snapped - watch.count(Rejection::NoPixel), 1)
                    << hard::name(family.name, seed);
            } else {
                EXPECT_GE(dropped + watch.snapped, 1) << hard::name(family.name, seed);
            }
        }
}

// ------------------------------------------------------- what must not change a bit of colour or depth
struct Picture {
    Image<Rgba8>::Pixels color;
    Image<Scalar>::Pixels depth;
    friend bool operator==(const Picture& a, const Picture& b) {
        return a.color == b.color && a.depth.size() == b.depth.size() &&
               std::memcmp(a.depth.data(), b.depth.data(), a.depth.size() * sizeof(Scalar)) == 0;
    }
};

struct Lit {
    pipeline::Mesh mesh = tests::unit_corners();
    Settings settings = tests::unlit();
    bool two_sided = false;

    explicit Lit(Shading shading) {
        settings.shading = shading;
        mesh.vertices[0].normal = {{1, 0.5f, 0.25f}}, mesh.vertices[0].uv = {0.1f, 0.2f};
        mesh.vertices[1].normal = {{-0.5f, 1, 0.25f}}, mesh.vertices[1].uv = {3.1f, 0.7f};
        mesh.vertices[2].normal = {{0.1f, -0.3f, 1}}, mesh.vertices[2].uv = {-0.4f, 2.2f};
        two_sided = shading == Shading::Flat;  // its normal turns with the winding
    }
    Picture draw_corners(const hard::ClipTriangle& t, const std::array<std::uint32_t, 3>& order) {
        static const std::vector<std::uint8_t> texels = [] {
            std::vector<std::uint8_t> rgb;
            for (int i = 0; i < 5 * 3 * 3; ++i) rgb.push_back(static_cast<std::uint8_t>(i * 37));
            return rgb;
        }();
        static const Texture texture = make_texture(5, 3, 3, texels, Encoding::Srgb);
        mesh.indices = {order[0], order[1], order[2]};
        Scene scene;
        scene.models.push_back({&mesh, {}, {}, &texture, two_sided});
        scene.lights = {
            {pipeline::Light::Kind::Point, {{1, 2, 5}}, {{0, 0, -1}}, {1, 1, 1}},
            {pipeline::Light::Kind::Directional, {{0, 0, 0}}, {{-1, -1, -0.5f}}, {0.5f, 0.25f, 1}}};
        scene.camera = tests::camera_to(t);
        Frame frame = tests::frame_of(24, 24);
        draw(scene, settings, frame);
        return {frame.color.pixels(), frame.depth.pixels()};
    }
};

constexpr Shading shadings[] = {Shading::Unlit, Shading::Flat, Shading::Gouraud, Shading::Phong};
constexpr std::array<std::uint32_t, 3> orders[] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                                   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

TEST(DrawClip, CornerOrderAndWindingDoNotChangeABit) {
    int drawn = 0;
    for (const Shading shading : shadings) {
        Lit lit(shading);
        for (const auto& family : hard::clip_families())
            for (std::uint64_t seed = 0; seed < 25; ++seed) {
                const hard::ClipTriangle t = hard::make(family, seed);
                const Picture first = lit.draw_corners(t, orders[0]);
                drawn += first.color != Image<Rgba8>::Pixels(first.color.size(), first.color[0]);
                for (const auto& order : orders)
                    ASSERT_TRUE(lit.draw_corners(t, order) == first)
                        << hard::name(family.name, seed) << ", shading " << static_cast<int>(shading)
                        << ", corners " << order[0] << order[1] << order[2];
            }
    }
    EXPECT_GT(drawn, 500);
}

TEST(DrawClip, APowerOfTwoOnAllFourCoordinatesDoesNotChangeABit) {
    Lit lit(Shading::Phong);
    for (const auto& family : hard::clip_families()) {
        if (!family.finite || family.name == "w_tiny" || family.name == "denormal_coordinates" ||
            family.name == "huge" || family.name == "largest_float" || family.name == "tiny")
            continue;  // already at the ends of the range: the scaled ones would leave it
        for (std::uint64_t seed = 0; seed < 25; ++seed) {
            const hard::ClipTriangle t = hard::make(family, seed);
            const Picture first = lit.draw_corners(t, orders[0]);
            for (const double k : {0x1p-20, 0.5, 0x1p30}) {
                hard::ClipTriangle scaled = t;
                for (auto& p : scaled)
                    for (auto& v : p) v *= k;
                ASSERT_TRUE(lit.draw_corners(scaled, orders[0]) == first)
                    << hard::name(family.name, seed) << " times " << k;
            }
        }
    }
}

}  // namespace
}  // namespace relevo::raster
