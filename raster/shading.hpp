// Flat, Gouraud and Phong shading: where the light equation is evaluated (textbook 7.4; Gouraud 1971, Phong
// 1975).
//
// Each is a program of three parts. `corner` runs once a vertex and says which numbers the triangle
// interpolates, `face` once a visible triangle, `pixel` once a drawn pixel:
//
//             corner                          face                       pixel
//   Unlit     [uv]                            -                          base
//   Flat      [uv]                            light at the centroid      base * amount + gloss
//   Gouraud   light at the vertex [, uv]      -                          base * amount + gloss
//   Phong     position, normal [, uv]         -                          light at the pixel
//
// All of it happens in eye space. With a texture, base is the texel, else the material's colour.
#pragma once
#include <array>
#include <type_traits>

#include "pipeline/cull.hpp"
#include "pipeline/light.hpp"
#include "raster/texture.hpp"

namespace relevo::raster {

using pipeline::Facing;
using pipeline::Lighting;
using pipeline::Mask;
using pipeline::Reflection;
using pipeline::ReflectionOf;
using pipeline::Vec3;
using pipeline::Vec3Of;

// What is the same all over a model.
struct Surface {
    Lighting lighting;
    LinearRgb color;
    const Texture* texture;  // of the textured programs
    Filter filter;
    bool two_sided;
};

// A vertex in eye space, its normal of unit length (or zero) and already turned to the side that is shaded.
template <class Real>
struct ShadedVertexOf {
    Vec3Of<Real> position, normal;
    Vec2Of<Real> uv;
};
using ShadedVertex = ShadedVertexOf<Scalar>;

template <bool Textured, class Real>
RgbOf<Real> base_color(const Surface& surface, const Real* uv) {
    if constexpr (Textured)
        return sample<Real>(*surface.texture, surface.filter, {uv[0], uv[1]});
    else
        return surface.color;
}

// The numbers that a pixel gets, its lanes named by the caller: pixel<Real>().
template <class Real>
using Carried = const std::type_identity_t<Real>*;

struct NoFace {};

template <bool Textured>
struct Unlit {
    static constexpr bool textured = Textured, needs_eye = false, needs_face = false, lights_pixels = false;
    static constexpr std::size_t size = Textured ? 2 : 0;
    using Face = NoFace;

    template <class Real>
    static std::array<Real, size> corner(const Surface&, const ShadedVertexOf<Real>& v) {
        if constexpr (Textured)
            return {v.uv.x, v.uv.y};
        else
            return {};
    }
    template <class Real = Scalar>
    static RgbOf<Real> pixel(const Surface& surface, const Face&, Carried<Real> varying) {
        return base_color<Textured, Real>(surface, varying);
    }
};

template <bool Textured>
struct Flat : Unlit<Textured> {
    static constexpr bool needs_face = true;
    using Face = Reflection;

    template <class Real = Scalar>
    static RgbOf<Real> pixel(const Surface& surface, const ReflectionOf<Real>& face, Carried<Real> varying) {
        return reflected(base_color<Textured, Real>(surface, varying), face);
    }
};

template <bool Textured>
struct Gouraud {
    static constexpr bool textured = Textured, needs_eye = true, needs_face = false, lights_pixels = false;
    static constexpr std::size_t size = Textured ? 8 : 3;
    using Face = NoFace;

    template <class Real>
    static std::array<Real, size> corner(const Surface& surface, const ShadedVertexOf<Real>& v) {
        const auto [amount, gloss] = pipeline::reflect<Real>(surface.lighting, v.position, v.normal);
        if constexpr (Textured) {
            return {amount.r, amount.g, amount.b, gloss.r, gloss.g, gloss.b, v.uv.x, v.uv.y};
        } else {
            const RgbOf<Real> c = pipeline::reflected<Real>(surface.color, {amount, gloss});
            return {c.r, c.g, c.b};
        }
    }
    template <class Real = Scalar>
    static RgbOf<Real> pixel(const Surface& surface, const Face&, Carried<Real> a) {
        if constexpr (Textured)
            return reflected(base_color<true, Real>(surface, a + 6),
                             {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}});
        else
            return {a[0], a[1], a[2]};
    }
};

template <bool Textured>
struct Phong {
    static constexpr bool textured = Textured, needs_eye = true, needs_face = false, lights_pixels = true;
    static constexpr std::size_t size = Textured ? 8 : 6;
    using Face = NoFace;

    template <class Real>
    static std::array<Real, size> corner(const Surface&, const ShadedVertexOf<Real>& v) {
        std::array<Real, size> a{v.position.x, v.position.y, v.position.z,
                                 v.normal.x,   v.normal.y,   v.normal.z};
        if constexpr (Textured) a[6] = v.uv.x, a[7] = v.uv.y;
        return a;
    }
    template <class Real = Scalar>
    static RgbOf<Real> pixel(const Surface& surface, const Face&, Carried<Real> a) {
        const auto point = [a] { return Vec3Of<Real>{a[0], a[1], a[2]}; };
        return pixel<Real>(surface, a + 6, point, directions<Real>(surface, a));
    }
    // The two steps of it: what needs roots and divisions, and the rest.
    template <class Real>
    [[gnu::always_inline]] static pipeline::DirectionsOf<Real> directions(const Surface& surface,
                                                                          Carried<Real> a) {
        const Vec3Of<Real> normal = pipeline::normalize<Real>({a[3], a[4], a[5]});
        return pipeline::directions<Real>(surface.lighting, {a[0], a[1], a[2]}, normal);
    }
    template <class Real, class Point>
    [[gnu::always_inline]] static RgbOf<Real> pixel(const Surface& surface, Carried<Real> uv, Point&& point,
                                                    const pipeline::DirectionsOf<Real>& to) {
        return reflected(base_color<Textured, Real>(surface, uv),
                         pipeline::reflect<Real>(surface.lighting, point, to));
    }
};

// Flat shading's light, at the centroid of a face given by its corners in eye space, counter-clockwise seen
// from outside. Where `back` and the surface is two-sided, the reversed normal is lit. The corner with the
// smallest coordinates comes first, so that the caller's first corner does not change a bit.
template <class Real>
ReflectionOf<Real> reflect_face(const Surface& surface, const std::array<Vec3Of<Real>, 3>& p,
                                const Mask<Real>& back, bool mirrored) {
    using Vector = Vec3Of<Real>;
    using pipeline::select;
    const auto before = [](const Vector& a, const Vector& b) {
        return a.x < b.x || (a.x == b.x && (a.y < b.y || (a.y == b.y && a.z < b.z)));
    };
    const Mask<Real> one = before(p[1], p[0]);  // comes before corner 0
    const Mask<Real> two = before(p[2], select(one, p[1], p[0]));
    const Vector a = select(two, p[2], select(one, p[1], p[0]));
    const Vector b = select(two, p[0], select(one, p[2], p[1]));
    const Vector c = select(two, p[1], select(one, p[0], p[2]));
    const Vector out = pipeline::normalize<Real>(pipeline::cross<Real>(b - a, c - a));
    const Vector normal = surface.two_sided ? select(back, -out, out) : out;
    const Vector centroid = (a + (b + c)) * Scalar(1.0 / 3);
    return pipeline::reflect<Real>(surface.lighting, centroid, mirrored ? -normal : normal);
}
inline Reflection reflect_face(const Surface& surface, const std::array<Vec3, 3>& p, Facing facing,
                               bool mirrored) {
    return reflect_face<Scalar>(surface, p, facing == Facing::Back, mirrored);
}

}  // namespace relevo::raster
