// The number that the pipeline computes with, and the constants on which every stage agrees.
#pragma once
#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <cfloat>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace relevo::pipeline {

// float gives the pictures; the `double` preset builds the whole library in double, as an oracle of the float
// one.
#ifdef RELEVO_DOUBLE
using Scalar = double;
#else
using Scalar = float;
#endif

static_assert(FLT_EVAL_METHOD == 0,
              "every operation must round to its own type: x87 arithmetic cannot build Relevo");
#ifdef __FAST_MATH__
#error "Relevo promises the same bytes everywhere: build it without -ffast-math"
#endif

using Vec2 = glm::vec<2, Scalar>;
using Vec3 = glm::vec<3, Scalar>;
using Vec4 = glm::vec<4, Scalar>;

// Window coordinates are snapped to 1/256 pixel (Direct3D 11.3 functional specification, 3.4.1).
inline constexpr int subpixel_bits = 8;
inline constexpr int subpixels = 1 << subpixel_bits;

// Triangles are clipped at |x|, |y| <= guard_band * w; the pixel box cuts the rest.
inline constexpr int guard_band = 7;

// With guard band 7 and 8192 pixels a snapped coordinate stays within 2^23 subpixels and an edge value below
// 2^49: exact in int64 and in double alike.
inline constexpr int max_picture_size = 8192;
static_assert((guard_band + 1) / 2 * max_picture_size * subpixels <= 1 << 23);

}  // namespace relevo::pipeline
