// Displacements in few bits (Clua 2004, 8.2): whole numbers 0..last in equal steps from the nearest to
// the deepest texel, one number more for "empty".
//
//     Q(i) = low + (high - low) i / last     8 bits: 0..254, 255 is empty     16 bits: 0..65534, 65535
//
// |Q(i) - d| <= (high - low) / (2 last), and in the warped picture
//     |du_i| <= |e_u - u| h / (h + d)^2 (high - low) / (2 last)
// where e_u is the epipole: what the error costs in texels, for the d that is least in [low, high].
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "relief/window.hpp"

namespace relevo::relief {

template <class Code>  // std::uint8_t or std::uint16_t
struct QuantizedDepth {
    static_assert(std::is_same_v<Code, std::uint8_t> || std::is_same_v<Code, std::uint16_t>);
    static constexpr Code empty = std::numeric_limits<Code>::max();
    static constexpr int last = empty - 1;
    DepthRange range;
    Image<Code> code;
};

template <class Code>
double step(const QuantizedDepth<Code>& q) {
    return (double{q.range.high} - double{q.range.low}) / QuantizedDepth<Code>::last;
}
template <class Code>
Scalar value(const QuantizedDepth<Code>& q, int code) {
    const double share = static_cast<double>(code) / QuantizedDepth<Code>::last;
    return static_cast<Scalar>(double{q.range.low} + (double{q.range.high} - double{q.range.low}) * share);
}

// A relief texture's depth, rounded to the nearest step. All of one depth: every code is 0.
template <class Code>
QuantizedDepth<Code> quantize(const ReliefTexture& texture) {
    using Quantized = QuantizedDepth<Code>;
    Quantized q{depth_range(texture), {texture.camera.width, texture.camera.height, Quantized::empty}};
    const double extent = double{q.range.high} - double{q.range.low},
                 codes = extent > 0 ? Quantized::last / extent : 0;
    for (std::size_t i = 0; i < q.code.pixels().size(); ++i)
        if (texture.coverage.pixels()[i] != 0)
            q.code.pixels()[i] = static_cast<Code>(
                std::floor((double{texture.depth.pixels()[i]} - double{q.range.low}) * codes + 0.5));
    return q;
}

// The same texture with the depth that the codes stand for.
template <class Code>
ReliefTexture with_depth(ReliefTexture texture, const QuantizedDepth<Code>& q) {
    for (std::size_t i = 0; i < q.code.pixels().size(); ++i)
        if (texture.coverage.pixels()[i] != 0) texture.depth.pixels()[i] = value(q, q.code.pixels()[i]);
    return texture;
}

// The bound of the header: how far, along one axis, half a step of depth can move what stands at u, `e`
// being the epipole on that axis. Orthographic source; d: the smallest displacement considered.
inline double displacement_error_bound(double e, double u, double h, double d, double half_step) {
    return std::abs(e - u) * h / ((h + d) * (h + d)) * half_step;
}

}  // namespace relevo::relief
