// What a relief texture says is solid, for searches along rays. A texel is a little pillar: solid from its
// depth on, down to where it ends.
//
// Without an end ("everything behind the surface is solid") the pillars reach to infinity. That is right for
// a height field on a full plane, and wrong for an object seen from aside: it is extruded. Two cures: a
// thickness for all pillars, or a second relief texture of the object's back, seen from the opposite side
// (Policarpo and Oliveira 2006).
//
// Pillars have sides, and stand half a texel out where the surface is steep. Read bilinearly, the surface
// runs smoothly from texel to texel instead, cut at jumps of depth.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "relief/relief_ray.hpp"
#include "relief/texel_shares.hpp"

namespace relevo::relief {

// z of relief_ray.hpp. A point (u, v, z) is solid when front <= z <= back there; empty texels and all outside
// the square are not.
struct ReliefSolid {
    Image<Scalar> front, back;  // front: infinite in empty texels; back: infinite where there is no end
    double low = 0, high = 0;   // all fronts and finite backs lie within; low > high: nothing is solid
    Reading reading = Reading::Nearest;
    double jump = 0.1;  // of bilinear reading: a greater difference of z is a border

    std::optional<TexelShares> shares(double u, double v) const {
        return texel_shares(
            front.width(), front.height(), u, v, reading, jump,
            [&](int x, int y) { return std::isfinite(front.row(y)[x]); },
            [&](int x, int y) { return double{front.row(y)[x]}; });
    }
    bool contains(double u, double v, double z) const {
        const auto found = shares(u, v);
        if (!found) return false;
        const auto mixed = [&](const Image<Scalar>& image) {
            return weighted_sum(*found, 0.0,
                                [&](int x, int y, double share) { return share * double{image.row(y)[x]}; });
        };
        return z >= mixed(front) && z <= mixed(back);
    }
};

// Everything behind the surface is solid. A depth that is not finite is empty.
inline ReliefSolid extruded_solid(const ReliefTexture& texture) {
    constexpr Scalar infinity = std::numeric_limits<Scalar>::infinity();
    const int width = texture.camera.width, height = texture.camera.height;
    ReliefSolid solid{{width, height, infinity}, {width, height, infinity}};
    solid.low = std::numeric_limits<double>::infinity(), solid.high = -solid.low;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!texture.coverage.at(x, y)) continue;
            const auto z =
                static_cast<Scalar>(inward_depth(texture.camera.projection, texture.depth.at(x, y)));
            if (!std::isfinite(z)) continue;
            solid.front.at(x, y) = z;
            solid.low = std::min(solid.low, double{z}), solid.high = std::max(solid.high, double{z});
        }
    // so that rounding does not lose a plate that lies deepest
    if (solid.low <= solid.high) solid.high += 1e-9 * std::fabs(solid.high);
    return solid;
}

// Every pillar is `thickness` long, in world units along the line of sight of an orthographic source, along
// f of a perspective one.
inline ReliefSolid solid_of_thickness(const ReliefTexture& texture, double thickness) {
    ReliefSolid solid = extruded_solid(texture);
    const ReliefCamera& camera = texture.camera;
    const bool parallel = camera.projection == Projection::Orthographic;
    const double height = glm::dot(camera.corner - camera.eye, forward(camera));  // of a perspective source
    for (std::size_t i = 0; i < solid.front.pixels().size(); ++i) {
        const double z = solid.front.pixels()[i];
        if (!std::isfinite(z)) continue;
        const double end = parallel ? z + thickness : 1 - 1 / (1 / (1 - z) + thickness / height);
        solid.back.pixels()[i] = static_cast<Scalar>(end);
        solid.high = std::max(solid.high, double{solid.back.pixels()[i]});
    }
    return solid;
}

// The camera that sees an orthographic source's object from behind, texel (x, y) as (width - 1 - x, y): its
// plane lies `range` behind the source's.
inline ReliefCamera opposite_camera(const ReliefCamera& camera, double range) {
    assert(camera.projection == Projection::Orthographic);
    ReliefCamera opposite = camera;
    opposite.corner += double(camera.width) * camera.a + range * forward(camera);
    opposite.a = -camera.a;
    return opposite;
}

// From the front to the back that opposite_camera sees. A texel whose back is empty, or before its front,
// ends where it begins.
//
// That is right at the outline of a body. But an open surface has no back: the opposite camera sees the same
// sheet, or nothing. So where no texel around ends more than a texel behind its front, `sheet` is how thick
// it is, world units.
inline ReliefSolid solid_between(const ReliefTexture& front, const ReliefTexture& back, double sheet = 0) {
    ReliefSolid solid = extruded_solid(front);
    const double range = glm::dot(back.camera.corner - front.camera.corner, forward(front.camera)),
                 texel = std::sqrt(std::max(glm::dot(front.camera.a, front.camera.a),
                                            glm::dot(front.camera.b, front.camera.b)));
    const int width = front.camera.width, height = front.camera.height;
    Image<std::uint8_t> has_back(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Scalar begin = solid.front.at(x, y);
            const bool seen = back.coverage.at(width - 1 - x, y) != 0;
            const auto end = static_cast<Scalar>(range - double{back.depth.at(width - 1 - x, y)});
            solid.back.at(x, y) = seen ? std::max(begin, end) : begin;
            has_back.at(x, y) = seen && std::isfinite(begin) && double{end} - double{begin} > texel;
        }
    const auto is_sheet = [&](int x, int y) {
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i)
                if (has_back.at(i, j)) return false;
        return true;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Scalar begin = solid.front.at(x, y);
            if (!std::isfinite(begin)) continue;
            Scalar& end = solid.back.at(x, y);
            if (sheet > 0 && is_sheet(x, y)) end = std::max(end, static_cast<Scalar>(double{begin} + sheet));
            solid.high = std::max(solid.high, double{end});
        }
    return solid;
}

// Where a search found the surface.
struct ReliefHit {
    int x, y;        // the texel
    double u, v, z;  // the point
};

// The part of a ray that can meet the solid: z in [first, last], inside the square and between the nearest
// and the deepest front. Empty (first > last) for none.
struct SearchRange {
    double first, last;
};
inline SearchRange search_range(const ReliefSolid& solid, const ReliefRay& ray) {
    SearchRange range{solid.low, solid.high};
    const double size[2] = {double(solid.front.width()), double(solid.front.height())};
    for (int k = 0; k < 2; ++k) {
        const double at_zero = (0 - ray.entry[k]) / ray.slope[k],
                     at_size = (size[k] - ray.entry[k]) / ray.slope[k];
        if (ray.slope[k] == 0) {
            if (!(ray.entry[k] >= 0 && ray.entry[k] < size[k])) return {1, 0};
            continue;
        }
        range.first = std::max(range.first, std::min(at_zero, at_size));
        range.last = std::min(range.last, std::max(at_zero, at_size));
    }
    return range;
}

// What a search looks at, for probes.
struct SolidLookedUp {
    glm::dvec2 place;
    double z;
    bool inside;
};

}  // namespace relevo::relief
