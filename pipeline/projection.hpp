// Projections from eye space to clip space (textbook 3.2), with the depth range 0 <= z <= w.
//
// The eye looks down -z, so distances n (near) and f (far) mean z = -n and z = -f. Reversed depth puts the
// near plane at z = w (depth 1) and the far plane at z = 0; forward depth the other way around. Reversed
// float depth resolves the same relative distance everywhere (Lapidous and Jiao 1999), and an infinite far
// plane costs nothing.
#pragma once
#include "pipeline/elementary.hpp"
#include "pipeline/result.hpp"
#include "pipeline/space.hpp"

namespace relevo::pipeline {

enum class DepthRange { Reversed, Forward };

// fov_y: the vertical angle of view, more than 0 and less than 180 degrees. aspect: width / height, more than
// 0. 0 < near < far; far may be infinite. Anything else is an error that names the parameter.
Result<Projective<Clip, Eye>> perspective(Degrees fov_y, double aspect, double near, double far,
                                          DepthRange range);

// The window [left, right] x [bottom, top] on the near plane, seen from the eye; it need not be centred.
Result<Projective<Clip, Eye>> frustum(double left, double right, double bottom, double top, double near,
                                      double far, DepthRange range);

// The box [left, right] x [bottom, top] x [near, far]; near < far, both finite, near may be negative.
Result<Projective<Clip, Eye>> orthographic(double left, double right, double bottom, double top, double near,
                                           double far, DepthRange range);

}  // namespace relevo::pipeline
