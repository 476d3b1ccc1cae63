// The plain form of the warp: the same pictures by another program, in double, as short and as slow as one
// likes, so that each known mistake can be made in it. Without a mistake it agrees with the library.
#pragma once
#include <vector>

#include "relief/quantize.hpp"
#include "tests/golden/relief/subject.hpp"

namespace relevo::golden {

// By any resampler but the mesh; all channels.
relief::Prewarped plain_prewarp(const relief::ReliefTexture& texture, const relief::Warp& warp,
                                const relief::Window& window, const relief::PrewarpSettings& settings,
                                const ReliefRules& rules);

// The picture between the passes of the forms in two passes.
struct PlainSample {
    bool there = false;
    double color[3], normal[3], depth, source[2], v, weight;
    relief::Kind kind;
};
raster::Image<PlainSample> plain_rows(const relief::ReliefTexture& texture, const relief::Warp& warp,
                                      const relief::Window& window, const relief::PrewarpSettings& settings,
                                      const ReliefRules& rules);

// The number of each texel in the order of painting.
raster::Image<int> plain_ranks(const relief::Warp& warp, int width, int height, relief::Painting painting,
                               const ReliefRules& rules);

relief::QuantizedDepth<std::uint8_t> plain_codes(const relief::ReliefTexture& texture,
                                                 const ReliefRules& rules);

}  // namespace relevo::golden
