// The light equation: ambient, diffuse and specular light at one point of a surface (Phong 1975;
// textbook 7.3).
//
//   amount = ambient + sum over the lights of  light * diffuse * max(n.l, 0)
//   gloss  =           sum over the lights of  light * specular * max(r.v, 0)^shininess     where n.l > 0
//   colour = base * amount + gloss
// with unit vectors n (normal), l (towards the light), v (towards the viewer) and r = 2 (n.l) n - l.
// Called a corner it is Gouraud's shading, called a pixel Phong's: the same function in another place.
#pragma once
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
};

// The light equation at a point of eye space with its unit normal, the lights summed in their order.
// A zero normal, or a light or viewer at the very point, leaves its terms out. Never not-a-number for finite
// input.
template <class Real>
[[gnu::always_inline]] inline ReflectionOf<Real> reflect(const Lighting& lighting, const Vec3Of<Real>& point,
                                                         const Vec3Of<Real>& n) {
    using Vector = Vec3Of<Real>;
    const Vector v = lighting.parallel_view ? Vector{0, 0, 1} : normalize<Real>(-point);
    ReflectionOf<Real> sum{{lighting.ambient, lighting.ambient, lighting.ambient}, {0, 0, 0}};
    for (const EyeLight& light : lighting.lights) {
        const Vector l =
            light.directional ? Vector(light.place) : normalize<Real>(Vector(light.place) - point);
        const Real nl = dot<Real>(n, l);
        const Mask<Real> lit = nl > 0;
        if (!any(lit)) continue;
        const RgbOf<Real> color = light.color;
        const Vector r = (nl + nl) * n - l;
        const Real shine = power(dot<Real>(r, v), lighting.shininess);
        sum.amount = select(lit, sum.amount + (lighting.diffuse * nl) * color, sum.amount);
        sum.gloss = select(lit, sum.gloss + (lighting.specular * shine) * color, sum.gloss);
    }
    return sum;
}

// The same for plain numbers.
inline Reflection reflect(const Lighting& lighting, const Vec3& point, const Vec3& n) {
    return reflect<Scalar>(lighting, point, n);
}

}  // namespace relevo::pipeline
