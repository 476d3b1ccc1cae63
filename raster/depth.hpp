// The depth test: nearer wins; at equal depth the smaller primitive number wins (the first one drawn).
#pragma once
#include "pipeline/scalar.hpp"

namespace relevo::raster {

using pipeline::Scalar;

enum class DepthFormat {
    Float32Reversed,  // near 1, far 0: float's precision and the perspective's compensate each other (the
                      // default)
    Float32Forward,   // near 0, far 1
};

// What an empty pixel holds; a fragment exactly there is never drawn.
constexpr Scalar cleared_depth(DepthFormat format) { return format == DepthFormat::Float32Reversed ? 0 : 1; }

// False for equal depths and for not-a-number.
constexpr bool nearer(DepthFormat format, Scalar z, Scalar stored) {
    return format == DepthFormat::Float32Reversed ? z > stored : z < stored;
}

}  // namespace relevo::raster
