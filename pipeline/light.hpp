// The light equation: ambient, diffuse and specular light at one point of a surface (Phong 1975;
// textbook 7.3).
//
//   amount = ambient + sum over the lights of  light * diffuse * max(n.l, 0)
//   gloss  =           sum over the lights of  light * specular * max(r.v, 0)^shininess     where n.l > 0
//   colour = base * amount + gloss
// with unit vectors n (normal), l (towards the light), v (towards the viewer) and r = 2 (n.l) n - l.
// Called a corner it is Gouraud's shading, called a pixel Phong's: the same function in another place.
#pragma once
#include <array>
#include <span>

#include "pipeline/color.hpp"
#include "pipeline/elementary.hpp"
#include "pipeline/normalize.hpp"
#include "pipeline/space.hpp"

namespace relevo::pipeline {

struct Material {
    Scalar ambient = Scalar(0.1), diffuse = Scalar(0.7), specular = Scalar(0.4);  // each 0..1
    Scalar shininess = 32;                                                        // exponent, >= 0
    LinearRgb color{Scalar(0.8), Scalar(0.8), Scalar(0.8)};  // base colour where there is no texture
};

struct Light {
    enum class Kind { Point, Directional } kind = Kind::Point;
    Point<World> position{{0, 0, 0}};  // of a point light
    Vec<World> direction{{0, 0, -1}};  // in which the light of a directional one travels, any length but zero
    LinearRgb color{1, 1, 1};
};

// A light brought to eye space, once a picture.
struct EyeLight {
    bool directional;
    Vec3 place;  // the position of a point light; the unit vector TOWARDS a directional one
    LinearRgb color;
};
inline EyeLight to_eye(const Light& light, const RoundedAffine<Eye, World>& eye_from_world) {
    if (light.kind == Light::Kind::Point) return {false, (eye_from_world * light.position).v, light.color};
    return {true, normalize<Scalar>(-(eye_from_world * light.direction).v), light.color};
}

// What a surface does with the light that falls on it.
template <class Real>
struct ReflectionOf {
    RgbOf<Real> amount;  // multiplies the base colour
    RgbOf<Real> gloss;   // is added
};
using Reflection = ReflectionOf<Scalar>;
template <class Real>
constexpr RgbOf<Real> reflected(const RgbOf<Real>& base, const ReflectionOf<Real>& by) {
    return base * by.amount + by.gloss;
}

// Everything of the light equation that is the same all over a model.
struct Lighting {
    std::span<const EyeLight> lights;
    Scalar ambient, diffuse, specular;
    Exponent shininess;
    bool parallel_view;  // the viewer lies towards +z; else at the origin of the eye
    bool grey = false;   // are_grey(lights); false is right for any lights, and slower
};

// Whether each light's channels are the same. Then those of the sums are, too (but for the sign of a zero),
// and one is computed for all three.
inline bool are_grey(std::span<const EyeLight> lights) {
    for (const EyeLight& light : lights)
        if (light.color.r != light.color.g || light.color.g != light.color.b) return false;
    return true;
}

// The unit vectors at a point, for the first light: what the light equation needs roots and divisions for.
// They are apart because a loop over many points is faster when these come first.
template <class Real>
struct DirectionsOf {
    Vec3Of<Real> normal, viewer, light;
};
template <class Real>
[[gnu::always_inline]] inline Vec3Of<Real> towards_light(const EyeLight& light, const Vec3Of<Real>& point) {
    if (light.directional) return light.place;
    return normalize<Real>(Vec3Of<Real>(light.place) - point);
}
template <class Real>
[[gnu::always_inline]] inline DirectionsOf<Real> directions(const Lighting& lighting,
                                                            const Vec3Of<Real>& point,
                                                            const Vec3Of<Real>& n) {
    DirectionsOf<Real> to{n, Vec3(0, 0, 1), Vec3(0, 0, 0)};
    if (!lighting.parallel_view) to.viewer = normalize<Real>(-point);
    if (!lighting.lights.empty()) to.light = towards_light<Real>(lighting.lights[0], point);
    return to;
}

// In RgbOf<Real>, or in Real where all lights are grey. point(): called for the lights after the first one.
template <class Color, class Real, class Point>
[[gnu::always_inline]] inline std::array<Color, 2> amount_and_gloss(const Lighting& lighting, Point&& point,
                                                                    const DirectionsOf<Real>& to) {
    const auto channels = [](const LinearRgb& c) -> Color {
        if constexpr (std::is_same_v<Color, Real>)
            return c.r;
        else
            return c;
    };
    const auto& [n, v, first] = to;
    Color amount = channels({lighting.ambient, lighting.ambient, lighting.ambient}), gloss = channels({});
    for (const EyeLight& light : lighting.lights) {
        const Vec3Of<Real> l = &light == lighting.lights.data() ? first : towards_light<Real>(light, point());
        const Real nl = dot<Real>(n, l);
        const Mask<Real> lit = nl > 0;
        if (!any(lit)) continue;
        const Color color = channels(light.color);
        const Vec3Of<Real> r = (nl + nl) * n - l;
        const Real shine = power(dot<Real>(r, v), lighting.shininess);
        amount = select(lit, amount + (lighting.diffuse * nl) * color, amount);
        gloss = select(lit, gloss + (lighting.specular * shine) * color, gloss);
    }
    return {amount, gloss};
}

// The light equation at a point of eye space with its unit normal, the lights summed in their order.
// A zero normal, or a light or viewer at the very point, leaves its terms out. Never not-a-number for finite
// input.
template <class Real, class Point>
[[gnu::always_inline]] inline ReflectionOf<Real> reflect(const Lighting& lighting, Point&& point,
                                                         const DirectionsOf<Real>& to) {
    if (lighting.grey) {
        const auto [amount, gloss] = amount_and_gloss<Real, Real>(lighting, point, to);
        return {{amount, amount, amount}, {gloss, gloss, gloss}};
    }
    const auto [amount, gloss] = amount_and_gloss<RgbOf<Real>, Real>(lighting, point, to);
    return {amount, gloss};
}
template <class Real>
[[gnu::always_inline]] inline ReflectionOf<Real> reflect(const Lighting& lighting, const Vec3Of<Real>& point,
                                                         const Vec3Of<Real>& n) {
    return reflect<Real>(
        lighting, [&] { return point; }, directions<Real>(lighting, point, n));
}

// The same for plain numbers.
inline Reflection reflect(const Lighting& lighting, const Vec3& point, const Vec3& n) {
    return reflect<Scalar>(lighting, point, n);
}

}  // namespace relevo::pipeline
