// A sprite: the source's picture on its plane as it is, flat (Clua 2004, 3.2). Right from where it was taken,
// wrong elsewhere: what every warp is compared with.
#pragma once
#include "relief/map_plane.hpp"

namespace relevo::relief {

// The picture of a warp that moves nothing.
inline Prewarped unwarped(const ReliefTexture& texture) {
    Prewarped picture;
    picture.window = source_window(texture.camera);
    picture.color = texture.color, picture.normal = texture.normal, picture.coverage = texture.coverage;
    picture.depth = Image<Scalar>(texture.camera.width, texture.camera.height, 0);
    return picture;
}

// `viewer` is a perspective camera in front of the plane; else an error, that of make_warp.
inline Result<ViewImage> draw_sprite(const ReliefTexture& texture, const ReliefCamera& viewer,
                                     Reading reading = Reading::Bilinear) {
    const auto warp = make_warp(texture.camera, viewer_at(viewer.eye));
    if (!warp) return warp.error();
    return map_plane(unwarped(texture), texture.camera, *warp, viewer, reading);
}

}  // namespace relevo::relief
