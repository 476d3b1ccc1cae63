#include "raster/shading.hpp"

#include <gtest/gtest.h>

#include "tests/support/hard.hpp"

namespace relevo::raster {
namespace {

namespace hard = tests::hard;
using pipeline::EyeLight;

struct Stage {
    std::vector<EyeLight> lights{{false, {1, 2, 3}, {1, 1, 1}}, {true, {0, 0, 1}, {0.25f, 0.5f, 1}}};
    Surface surface(bool two_sided) const {
        return {{lights, Scalar(0.1), Scalar(0.6), Scalar(0.3), pipeline::exponent(20), false},
                {Scalar(0.9), Scalar(0.5), Scalar(0.2)},
                nullptr,
                Filter::Nearest,
                two_sided};
    }
};

bool same_bits(const Reflection& a, const Reflection& b) {
    return a.amount == b.amount && a.gloss == b.gloss;
}

TEST(Shading, AFaceIsLitTheSameFromAnyCornerAndFromBothSides) {
    const Stage stage;
    hard::Random r(1);
    for (int i = 0; i < 2000; ++i) {
        const auto p = [&] {
            return Vec3{static_cast<Scalar>(r.between(-2, 2)), static_cast<Scalar>(r.between(-2, 2)),
                        static_cast<Scalar>(r.between(-5, -1))};
        };
        const std::array<Vec3, 3> t{p(), p(), p()};
        const Surface two = stage.surface(true), one = stage.surface(false);
        for (const Facing facing : {Facing::Front, Facing::Back})
            for (const bool mirrored : {false, true}) {
                const Reflection first = reflect_face(one, t, facing, mirrored);
                ASSERT_TRUE(same_bits(first, reflect_face(one, {t[1], t[2], t[0]}, facing, mirrored)));
                ASSERT_TRUE(same_bits(first, reflect_face(one, {t[2], t[0], t[1]}, facing, mirrored)));
                ASSERT_TRUE(same_bits(first, reflect_face(one, {t[0], t[2], t[1]}, facing, !mirrored)))
                    << "a mirror turns the winding around, not the light";
            }
        ASSERT_TRUE(same_bits(reflect_face(two, t, Facing::Front, false),
                              reflect_face(two, {t[0], t[2], t[1]}, Facing::Back, false)))
            << "two-sided: the side that is seen is lit, however the corners wind";
        ASSERT_TRUE(
            same_bits(reflect_face(one, t, Facing::Front, false), reflect_face(one, t, Facing::Back, false)))
            << "one-sided: the outward side, from wherever it is seen";
    }
}

TEST(Shading, AFaceWithoutAreaHasAmbientLightOnly) {
    const Stage stage;
    const Surface surface = stage.surface(false);
    for (const std::array<Vec3, 3>& t : {std::array<Vec3, 3>{Vec3{1, 1, -2}, {1, 1, -2}, {1, 1, -2}},
                                         std::array<Vec3, 3>{Vec3{0, 0, -2}, {1, 0, -2}, {2, 0, -2}}}) {
        const Reflection r = reflect_face(surface, t, Facing::Front, false);
        EXPECT_EQ(r.amount, (LinearRgb{Scalar(0.1), Scalar(0.1), Scalar(0.1)}));
        EXPECT_EQ(r.gloss, (LinearRgb{0, 0, 0}));
    }
}

TEST(Shading, TheThreeShadingsAgreeWhereTheSurfaceIsFlatAndTheLightIsFar) {
    Stage stage;
    stage.lights = {{true, pipeline::normalize({1, 2, 3}), {1, 1, 1}}};
    Surface surface = stage.surface(false);
    surface.lighting.parallel_view = true;
    const Vec3 normal{0, 0, 1};
    const ShadedVertex v{{0, 0, -3}, normal, {0, 0}};
    const auto gouraud = Gouraud<false>::corner(surface, v);
    const auto phong = Phong<false>::corner(surface, v);
    const LinearRgb a = Gouraud<false>::pixel(surface, {}, gouraud.data()),
                    b = Phong<false>::pixel(surface, {}, phong.data());
    const LinearRgb c = Flat<false>::pixel(
        surface, reflect_face(surface, {Vec3{-1, -1, -3}, {1, -1, -3}, {0, 1, -3}}, Facing::Front, false),
        nullptr);
    EXPECT_EQ(a, b);
    EXPECT_EQ(a, c);
    EXPECT_GT(a.r, Scalar(0.1));
}

TEST(Shading, ATextureTakesThePlaceOfTheColour) {
    const Stage stage;
    const std::vector<std::uint8_t> texel = {51, 102, 204};
    const Texture texture = make_texture(1, 1, 3, texel, Encoding::Raw);
    Surface surface = stage.surface(false);
    const ShadedVertex v{{0, 0, -3}, {0, 0, 1}, {Scalar(0.5), Scalar(0.5)}};
    const LinearRgb plain_unlit = Unlit<false>::pixel(surface, {}, nullptr);
    EXPECT_EQ(plain_unlit, surface.color);
    surface.texture = &texture;
    surface.color = sample_nearest(texture, {0, 0});
    const auto unlit = Unlit<true>::corner(surface, v);
    EXPECT_EQ(Unlit<true>::pixel(surface, {}, unlit.data()), surface.color);
    const auto phong = Phong<false>::corner(surface, v);
    const auto phong_textured = Phong<true>::corner(surface, v);
    EXPECT_EQ(Phong<true>::pixel(surface, {}, phong_textured.data()),
              Phong<false>::pixel(surface, {}, phong.data()));
    const auto gouraud = Gouraud<false>::corner(surface, v);
    const auto gouraud_textured = Gouraud<true>::corner(surface, v);
    EXPECT_EQ(Gouraud<true>::pixel(surface, {}, gouraud_textured.data()),
              Gouraud<false>::pixel(surface, {}, gouraud.data()));
}

}  // namespace
}  // namespace relevo::raster
