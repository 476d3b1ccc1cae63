#include "pipeline/light.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/hard.hpp"

namespace relevo::pipeline {
namespace {

namespace hard = tests::hard;

Lighting lighting(std::span<const EyeLight> lights, Scalar shininess = 8) {
    return {lights, Scalar(0.1), Scalar(0.7), Scalar(0.4), exponent(shininess), false};
}

TEST(Light, TheEquationByHand) {
    // n = l = v: everything is 1
    const EyeLight head_on{true, {0, 0, 1}, {1, Scalar(0.5), 0}};
    const Reflection r = reflect(lighting({&head_on, 1}), {0, 0, -2}, {0, 0, 1});
    EXPECT_EQ(r.amount,
              (LinearRgb{Scalar(0.1) + Scalar(0.7), Scalar(0.1) + Scalar(0.7) * Scalar(0.5), Scalar(0.1)}));
    EXPECT_EQ(r.gloss, (LinearRgb{Scalar(0.4), Scalar(0.4) * Scalar(0.5), 0}));
    EXPECT_EQ(reflected({Scalar(0.5), 1, 1}, r).r, Scalar(0.5) * r.amount.r + r.gloss.r);
    // 60 degrees from the normal, seen from the mirror direction
    const EyeLight aside{true, {static_cast<Scalar>(std::sqrt(0.75)), 0, Scalar(0.5)}, {1, 1, 1}};
    const Reflection s =
        reflect(lighting({&aside, 1}), {static_cast<Scalar>(std::sqrt(0.75)), 0, Scalar(-0.5)}, {0, 0, 1});
    EXPECT_NEAR(static_cast<double>(s.amount.r), 0.1 + 0.7 * 0.5, 1e-6);
    EXPECT_NEAR(static_cast<double>(s.gloss.r), 0.4, 1e-5);
}

TEST(Light, NothingComesFromBehindTheSurface) {
    hard::Random r(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 below = normalize({static_cast<Scalar>(r.between(-1, 1)),
                                      static_cast<Scalar>(r.between(-1, 1)), static_cast<Scalar>(-r.unit())});
        const EyeLight light{true, below, {1, 1, 1}};
        const Reflection got =
            reflect(lighting({&light, 1}, static_cast<Scalar>(r.integer(0, 3))), {0, 0, -1}, {0, 0, 1});
        EXPECT_EQ(got.amount, (LinearRgb{Scalar(0.1), Scalar(0.1), Scalar(0.1)}));
        EXPECT_EQ(got.gloss, (LinearRgb{0, 0, 0}));
    }
}

TEST(Light, LightsAddUpInTheirOrder) {
    const EyeLight lights[] = {
        {true, {0, 0, 1}, {1, 0, 0}}, {false, {1, 1, 0}, {0, 1, 0}}, {false, {-1, 0, 1}, {0, 0, 1}}};
    const Vec3 point{0, 0, -3}, normal{0, 0, 1};
    Reflection sum = reflect(lighting({}), point, normal);
    EXPECT_EQ(sum.amount, (LinearRgb{Scalar(0.1), Scalar(0.1), Scalar(0.1)}));
    const Reflection all = reflect(lighting(lights), point, normal);
    const LinearRgb channel[3] = {reflect(lighting({&lights[0], 1}), point, normal).amount,
                                  reflect(lighting({&lights[1], 1}), point, normal).amount,
                                  reflect(lighting({&lights[2], 1}), point, normal).amount};
    EXPECT_EQ(all.amount, (LinearRgb{channel[0].r, channel[1].g, channel[2].b}));
}

TEST(Light, OneChannelStandsForAllThreeWhereLightsAreGrey) {
    hard::Random r(3);
    const auto between = [&](double low, double high) { return static_cast<Scalar>(r.between(low, high)); };
    const auto vector = [&] { return Vec3(between(-1, 1), between(-1, 1), between(-1, 1)); };
    for (int i = 0; i < 1000; ++i) {
        EyeLight lights[3];
        for (EyeLight& light : lights) {
            const Scalar level = between(0, 2);
            light = {r.coin(), normalize(vector()), {level, level, level}};
        }
        Lighting l = lighting(std::span(lights).first(static_cast<std::size_t>(r.integer(0, 3))));
        const Vec3 point = vector() + Vec3(0, 0, -3), normal = normalize(vector());
        const Reflection apart = reflect(l, point, normal);
        l.grey = are_grey(l.lights);
        const Reflection together = reflect(l, point, normal);
        EXPECT_TRUE(l.grey);
        EXPECT_EQ(apart.amount, together.amount);
        EXPECT_EQ(apart.gloss, together.gloss);
        EXPECT_EQ(together.amount.r, together.amount.b);
    }
    for (const LinearRgb& color : {LinearRgb{1, 1, Scalar(0.5)}, LinearRgb{1, Scalar(0.5), Scalar(0.5)}}) {
        const EyeLight lights[] = {{true, {0, 0, 1}, {1, 1, 1}}, {true, {0, 0, 1}, color}};
        EXPECT_FALSE(are_grey(lights));
    }
}

TEST(Light, AHighlightDoesNotDependOnWhereTheSceneIsTurned) {
    hard::Random r(2);
    for (int i = 0; i < 1000; ++i) {
        const auto v = [&] {
            return Vec3{static_cast<Scalar>(r.between(-2, 2)), static_cast<Scalar>(r.between(-2, 2)),
                        static_cast<Scalar>(r.between(-2, 2))};
        };
        const Vec3 point = v(), normal = normalize(v());
        const EyeLight light{false, v(), {1, 1, 1}};
        const auto turned = [](Vec3 a) { return Vec3{a.y, a.z, a.x}; };  // 120 degrees round (1,1,1)
        const EyeLight turned_light{false, turned(light.place), {1, 1, 1}};
        const Reflection a = reflect(lighting({&light, 1}), point, normal),
                         b = reflect(lighting({&turned_light, 1}), turned(point), turned(normal));
        ASSERT_NEAR(static_cast<double>(a.amount.r), static_cast<double>(b.amount.r), 1e-5);
        ASSERT_NEAR(static_cast<double>(a.gloss.r), static_cast<double>(b.gloss.r), 1e-4);
    }
}

TEST(Light, DegenerateInputLeavesItsTermsOut) {
    const EyeLight at_point{false, {1, 2, 3}, {1, 1, 1}};
    const LinearRgb ambient{Scalar(0.1), Scalar(0.1), Scalar(0.1)}, none{0, 0, 0};
    const Reflection on_light = reflect(lighting({&at_point, 1}), {1, 2, 3}, {0, 0, 1});
    EXPECT_EQ(on_light.amount, ambient);
    EXPECT_EQ(on_light.gloss, none);
    const Reflection no_normal = reflect(lighting({&at_point, 1}), {0, 0, 0}, {0, 0, 0});
    EXPECT_EQ(no_normal.amount, ambient);
    const Reflection at_the_eye = reflect(lighting({&at_point, 1}), {0, 0, 0}, {0, 0, 1});
    EXPECT_GT(at_the_eye.amount.r, ambient.r);
    EXPECT_EQ(at_the_eye.gloss, none);
}

TEST(Light, NeverNotANumberForFiniteInput) {
    hard::Random r(3);
    for (int i = 0; i < 200'000; ++i) {
        const auto any = [&] { return static_cast<Scalar>(r.any_finite_float()); };
        const auto v = [&] { return Vec3{any(), any(), any()}; };
        const EyeLight lights[2] = {{false, v(), {Scalar(r.unit()), Scalar(r.unit()), 1}},
                                    {true, normalize(v()), {1, 1, 1}}};
        const Scalar n = std::abs(any());
        Lighting l = lighting(lights, n);
        l.parallel_view = r.coin();
        const Reflection got = reflect(l, v(), normalize(v()));
        const LinearRgb c = reflected({Scalar(0.5), 1, 0}, got);
        ASSERT_TRUE(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b)) << i;
        ASSERT_LE(std::max({c.r, c.g, c.b}), Scalar(0.1 + 2 * (0.7 + 0.4) + 1e-3))
            << "no light out of nothing";
        ASSERT_GE(std::min({c.r, c.g, c.b}), 0);
    }
}

TEST(Light, LightsMoveToEyeSpace) {
    RoundedAffine<Eye, World> eye_from_world{{{1, 0, 0, -5}, {0, 1, 0, 0}, {0, 0, 1, 2}}};
    Light light;
    light.position = {{1, 2, 3}};
    EXPECT_EQ(to_eye(light, eye_from_world).place, Vec3(-4, 2, 5));
    light.kind = Light::Kind::Directional;
    light.direction = {{0, 0, -9}};
    EXPECT_EQ(to_eye(light, eye_from_world).place, Vec3(0, 0, 1))
        << "towards the light, of length 1, not translated";
    EXPECT_TRUE(to_eye(light, eye_from_world).directional);
}

}  // namespace
}  // namespace relevo::pipeline
