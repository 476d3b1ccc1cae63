// Bad data: what is infinite, not a number, denormal, huge, or has w near 0. The fast path drops what the
// textbook path drops, counts it the same, and draws the rest.
#include <gtest/gtest.h>

#include "tests/raster/fast/identity_scenes.hpp"
#include "tests/raster/fast/identity_window.hpp"

namespace relevo::tests::identity {
namespace {

using pipeline::Scalar;

// One number of a mesh or matrix: mostly small, now and then of any kind.
struct Numbers {
    hard::Random random;
    int odd_in;  // one in so many is odd
    bool finite;

    Scalar operator()(double reach = 2) {
        constexpr Scalar inf = std::numeric_limits<Scalar>::infinity(),
                         nan = std::numeric_limits<Scalar>::quiet_NaN();
        constexpr Scalar odd[] = {0,
                                  -Scalar(0),
                                  Scalar(1e-45),
                                  Scalar(-1e-40),
                                  Scalar(1e-38),
                                  Scalar(1e-20),
                                  Scalar(1e19),
                                  Scalar(-1e20),
                                  Scalar(3e38),
                                  Scalar(-3e38),
                                  1,
                                  7,
                                  -7,
                                  inf,
                                  -inf,
                                  nan};
        if (random.integer(0, odd_in) > 0) return Scalar(random.between(-reach, reach));
        if (random.coin()) return random.any_finite_float();
        return odd[random.integer(0, std::int64_t(std::size(odd)) - (finite ? 4 : 1))];
    }
};

void fuzz(std::uint64_t seed) {
    hard::Random random(seed);
    Numbers position{hard::Random(seed + 1), int(random.integer(3, 200)), random.coin()},
        carried{hard::Random(seed + 2), int(random.integer(3, 200)), random.coin()};
    const Size size{int(random.integer(1, 70)), int(random.integer(1, 50))};
    Subject subject{"fuzz", {}, {}};
    const std::int64_t models = random.integer(1, 3);
    for (std::int64_t m = 0; m < models; ++m) {
        pipeline::Mesh mesh;
        const std::int64_t vertices = random.integer(3, 40), triangles = random.integer(0, 60);
        for (std::int64_t i = 0; i < vertices; ++i) {
            pipeline::Vertex v;
            for (int k = 0; k < 3; ++k) v.position.v[k] = position(), v.normal.v[k] = carried();
            v.uv = {carried(), carried()};
            mesh.vertices.push_back(v);
        }
        for (std::int64_t i = 0; i < 3 * triangles; ++i)
            mesh.indices.push_back(static_cast<std::uint32_t>(random.integer(0, vertices - 1)));
        subject.add(std::move(mesh));
    }
    std::vector<int> choice;
    for (const int choices : feature_choices) choice.push_back(int(random.integer(0, choices - 1)));
    const Features f = features(choice);
    raster::Scene scene = dressed(subject, f, size);
    switch (random.integer(0, 2)) {
        case 0:  // the camera among the triangles
            break;
        case 1:  // any matrix: w of both signs and near 0
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 4; ++r) scene.camera.clip_from_eye.m[c][r] = double(position());
            break;
        default:  // depths near the planes, w = 1
            scene.camera.clip_from_eye.m = glm::dmat4(1);
            scene.camera.clip_from_eye.m[3][2] = random.unit();
    }
    for (std::int64_t more = random.integer(-9, 9); more > 0; --more)
        scene.lights.push_back(
            {random.coin() ? pipeline::Light::Kind::Point : pipeline::Light::Kind::Directional,
             {{position(9), position(9), 1}},
             {{carried(), carried(), -1}},
             {carried(), carried(), 1}});
    if (random.integer(0, 3) == 0)
        for (pipeline::Light& light : scene.lights)
            light.position.v = {carried(9), carried(9), carried(9)}, light.color.g = carried(1);
    ASSERT_EQ(
        first_difference(scene, settings(f), size, few_ways(std::size_t(seed)), nullptr, Linear::AnyNan), "")
        << "seed " << seed << ", " << text(f);
}

TEST(Fuzz, BadNumbersAreDroppedAlike) {
    const int seeds = hard::cases(1000);
    for (int seed = 0; seed < seeds && !HasFailure(); ++seed) fuzz(std::uint64_t(seed));
}

// Each family of tests/support/hard.hpp: one triangle with any corners in clip space.
TEST(Fuzz, EveryFamilyOfClipSpace) {
    const Size size{24, 24};
    std::size_t number = 0;
    for (const auto& family : hard::clip_families())
        for (int seed = 0; seed < hard::cases(40); ++seed) {
            const hard::ClipTriangle t = hard::make(family, std::uint64_t(seed));
            Subject subject{"clip space", {}, {}};
            pipeline::Mesh mesh = unit_corners();
            for (std::size_t k = 0; k < 3; ++k) mesh.vertices[k].uv = {Scalar(k) / 3, Scalar(k * k)};
            subject.add(std::move(mesh));
            Features f;
            f.shading = static_cast<raster::Shading>(number % 4);
            f.texturing = static_cast<Texturing>(number % 3);
            raster::Scene scene = dressed(subject, f, size);
            scene.camera = camera_to(t);
            ASSERT_EQ(first_difference(scene, settings(f), size, few_ways(number++)), "")
                << hard::name(family.name, std::uint64_t(seed)) << ", " << text(f);
        }
}

// The same for the window: many hard triangles in one mesh.
TEST(Fuzz, EveryFamilyOfTheScreen) {
    const Size size{131, 97};
    for (const auto& family : hard::screen_families())
        for (int seed = 0; seed < hard::cases(6); ++seed) {
            WindowScene scene(size, View::Parallel, std::uint64_t(seed));
            for (std::uint64_t i = 0; i < 50; ++i) {
                const hard::ScreenTriangle t =
                    hard::make(family, 50 * std::uint64_t(seed) + i, size.width, size.height);
                Corners corners;
                for (std::size_t k = 0; k < 3; ++k)
                    corners[k] = {256 * t[k].x, 256 * t[k].y, Scalar(scene.random().unit()), 1};
                scene.add(corners);
            }
            ASSERT_EQ(first_difference(scene.scene(), textured_phong(), size, few_ways(std::size_t(seed))),
                      "")
                << family.name << ", " << seed;
        }
}

}  // namespace
}  // namespace relevo::tests::identity
