// The warped picture in a scene: a textured polygon on the source's plane, through the stages of our own
// pipeline (transform, clip, divide, cover, interpolate), lit by its own normals, and with the depth of
// what it shows in the place of the polygon's (Schaufler, "Nailboards", 1997; Clua 2004, 3.4 and 8.8).
//
//     X = P + d (P - T) / h       from the point P of the polygon, T the viewer, d what was warped along
//
// so it meets other objects where the object itself would. Call it after raster::draw(): it draws over
// what is there, nearer wins. The viewer of the warp is the scene's eye (of a parallel view: its
// direction); another viewer gets a wrong picture, but no fault.
#pragma once
#include "raster/scene.hpp"
#include "relief/prewarp.hpp"
#include "relief/texel_shares.hpp"

namespace relevo::relief {

struct ReliefModel {
    const Prewarped* picture;  // borrowed
    ReliefCamera source;
    Viewer viewer;
    pipeline::Material material;  // its colour is the picture's; Shading::Unlit shows that alone
    Reading reading = Reading::Bilinear;
    Scalar jump_depth = Scalar(0.1);  // not mixed across
};

void draw_relief(const ReliefModel& model, const raster::Scene& scene, const raster::Settings& settings,
                 raster::Frame& frame);

}  // namespace relevo::relief
