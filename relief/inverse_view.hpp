// A picture by inverse mapping: for every pixel of the viewer's screen its ray is searched in the relief
// texture (Clua 2004, 6.5). The forward pre-warp asks where a texel goes; this asks what a pixel sees, so
// there are no holes to fill, and no order to keep.
#pragma once
#include <utility>

#include "relief/relief_solid.hpp"

namespace relevo::relief {

// The colour of the texels that the hit is made of: the hit's own texel where the solid's shares are empty.
inline LinearRgb color_at(const ReliefTexture& texture, const ReliefSolid& solid, const ReliefHit& hit) {
    const auto shares = solid.shares(hit.u, hit.v);
    if (!shares || solid.reading == Reading::Nearest) return texture.color.at(hit.x, hit.y);
    return weighted_sum(*shares, LinearRgb{}, [&](int x, int y, double share) {
        return static_cast<Scalar>(share) * texture.color.at(x, y);
    });
}

// `find(ray)` gives the hit of a ray, if any: a search of the headers inverse_*.hpp on `solid`, which was
// made of `texture`. Colour is read as the solid is. Errors are those of make_warp: the viewer must lie in
// front of the source's plane.
template <class Find>
Result<ViewImage> inverse_view(const ReliefTexture& texture, const ReliefSolid& solid,
                               const ReliefCamera& viewer, Find&& find) {
    const auto rays = relief_rays(texture.camera, viewer);
    if (!rays) return rays.error();
    ViewImage image(viewer.width, viewer.height);
    for (int y = 0; y < viewer.height; ++y)
        for (int x = 0; x < viewer.width; ++x) {
            const auto ray = rays->through(x + 0.5, y + 0.5);
            if (!ray) continue;
            const std::optional<ReliefHit> hit = find(*ray);
            if (!hit) continue;
            image.color.at(x, y) = color_at(texture, solid, *hit);
            image.depth.at(x, y) =
                static_cast<Scalar>(view_depth(viewer, inward_point(texture.camera, hit->u, hit->v, hit->z)));
            image.coverage.at(x, y) = 1;
        }
    return image;
}

}  // namespace relevo::relief
