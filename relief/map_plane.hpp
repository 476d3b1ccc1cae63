// The warped picture where it belongs: on the source's plane, looked at from the place for which it was
// warped.
//
// Every pixel of the screen looks at one place of the plane (a homography). Its colour and depth come
// from the warped picture there; the point that is really seen lies (h + d) / h times as far away as the
// plane, which is what other objects must be compared with. This is the textbook's form, one pixel at a
// time; through the pipeline the same picture is a textured polygon.
#pragma once
#include "relief/prewarp.hpp"
#include "relief/texel_shares.hpp"
#include "relief/view_image.hpp"
#include "relief/warp_3d.hpp"

namespace relevo::relief {

// A place between the pixels of the warped picture is read by texel_shares.hpp, its jump in world units
// along f. `screen` is a perspective camera whose eye is the viewer of `warp`; its pixels that see
// nothing are not covered. Depth is along its axis, in world units.
ViewImage map_plane(const Prewarped& picture, const ReliefCamera& source, const Warp& warp,
                    const ReliefCamera& screen, Reading reading = Reading::Bilinear,
                    Scalar jump_depth = Scalar(0.1));

}  // namespace relevo::relief
