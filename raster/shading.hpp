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
#include <algorithm>
#include <array>

#include "pipeline/cull.hpp"
#include "pipeline/light.hpp"
#include "raster/texture.hpp"

namespace relevo::raster {

using pipeline::Facing;
using pipeline::Lighting;
using pipeline::Reflection;
using pipeline::Vec3;

// What is the same all over a model.
struct Surface {
    Lighting lighting;
    LinearRgb color;
    const Texture* texture;  // of the textured programs
    Filter filter;
    bool two_sided;
};

// A vertex in eye space, its normal of unit length (or zero) and already turned to the side that is shaded.
struct ShadedVertex {
    Vec3 position, normal;
    Vec2 uv;
};

template <bool Textured>
inline LinearRgb base_color(const Surface& surface, const Scalar* uv) {
    if constexpr (Textured)
        return sample(*surface.texture, surface.filter, {uv[0], uv[1]});
    else
        return surface.color;
}

struct NoFace {};

template <bool Textured>
struct Unlit {
    static constexpr bool textured = Textured, needs_eye = false, needs_face = false;
    static constexpr std::size_t size = Textured ? 2 : 0;
    using Face = NoFace;

    static std::array<Scalar, size> corner(const Surface&, const ShadedVertex& v) {
        if constexpr (Textured)
            return {v.uv.x, v.uv.y};
        else
            return {};
    }
    static LinearRgb pixel(const Surface& surface, const Face&, const Scalar* varying) {
        return base_color<Textured>(surface, varying);
    }
};

template <bool Textured>
struct Flat : Unlit<Textured> {
    static constexpr bool needs_face = true;
    using Face = Reflection;

    static LinearRgb pixel(const Surface& surface, const Face& face, const Scalar* varying) {
        return reflected(base_color<Textured>(surface, varying), face);
    }
};

template <bool Textured>
struct Gouraud {
    static constexpr bool textured = Textured, needs_eye = true, needs_face = false;
    static constexpr std::size_t size = Textured ? 8 : 3;
    using Face = NoFace;

    static std::array<Scalar, size> corner(const Surface& surface, const ShadedVertex& v) {
        const auto [amount, gloss] = reflect(surface.lighting, v.position, v.normal);
        if constexpr (Textured) {
            return {amount.r, amount.g, amount.b, gloss.r, gloss.g, gloss.b, v.uv.x, v.uv.y};
        } else {
            const LinearRgb c = reflected(surface.color, {amount, gloss});
            return {c.r, c.g, c.b};
        }
    }
    static LinearRgb pixel(const Surface& surface, const Face&, const Scalar* a) {
        if constexpr (Textured)
            return reflected(base_color<true>(surface, a + 6), {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}});
        else
            return {a[0], a[1], a[2]};
    }
};

template <bool Textured>
struct Phong {
    static constexpr bool textured = Textured, needs_eye = true, needs_face = false;
    static constexpr std::size_t size = Textured ? 8 : 6;
    using Face = NoFace;

    static std::array<Scalar, size> corner(const Surface&, const ShadedVertex& v) {
        std::array<Scalar, size> a{v.position.x, v.position.y, v.position.z,
                                   v.normal.x,   v.normal.y,   v.normal.z};
        if constexpr (Textured) a[6] = v.uv.x, a[7] = v.uv.y;
        return a;
    }
    static LinearRgb pixel(const Surface& surface, const Face&, const Scalar* a) {
        const Vec3 normal = pipeline::normalize({a[3], a[4], a[5]});
        return reflected(base_color<Textured>(surface, a + 6),
                         reflect(surface.lighting, {a[0], a[1], a[2]}, normal));
    }
};

// Flat shading's light, at the centroid of a face given by its corners in eye space, counter-clockwise seen
// from outside. A back face seen from behind is lit by the reversed normal when the surface is two-sided. The
// corner with the smallest coordinates comes first, so that the caller's first corner does not change a bit.
inline Reflection reflect_face(const Surface& surface, std::array<Vec3, 3> p, Facing facing, bool mirrored) {
    const auto before = [](const Vec3& a, const Vec3& b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    };
    const int first = before(p[1], p[0]) ? (before(p[2], p[1]) ? 2 : 1) : (before(p[2], p[0]) ? 2 : 0);
    std::rotate(p.begin(), p.begin() + first, p.end());
    const Vec3 normal = pipeline::normalize(pipeline::cross(p[1] - p[0], p[2] - p[0]));
    const bool reversed = (surface.two_sided && facing == Facing::Back) != mirrored;
    const Vec3 centroid = (p[0] + (p[1] + p[2])) * Scalar(1.0 / 3);
    return reflect(surface.lighting, centroid, reversed ? -normal : normal);
}

}  // namespace relevo::raster
