// The pre-warp of a whole relief texture: settings and result. The work is in the headers of the resamplers.
#pragma once
#include <vector>

#include "relief/occlusion_order.hpp"
#include "relief/window.hpp"

namespace relevo::relief {

using pipeline::Vec2;

// How the warped texels, which no longer lie on a grid, become a picture (Clua 2004, 8.2).
enum class Resampler {
    Splat,           // each texel paints the one pixel it falls into: holes, no cost (splat.hpp)
    OneDimensional,  // rows, then columns; the displacement is interpolated linearly
    Asymmetric,      // rows, then columns; the row that a sample goes to is carried along
    Compensated,     // rows, then columns; the displacement is chosen so that its row is right
    Interleaved,     // each sample of a row goes on to its column at once: one pass
    Mesh,            // triangles between the texels, with a z-buffer: the reference
};

// What happens between two neighbours of very different depth: a skin is stretched from one to the other, or
// the surface is cut there.
enum class Jump { Skin, Cut };

struct PrewarpSettings {
    Resampler resampler = Resampler::Interleaved;
    Jump jump = Jump::Skin;
    Scalar jump_depth = Scalar(0.1);  // world units along f; a greater difference of depth is a jump
    Painting painting = Painting::Right;
    bool depth_test = false;  // compare depths instead of trusting the order
    bool maps = false;        // fill the last three pictures of the result, too
    int threads = 1;          // of the forms in two passes; never changes a byte
};

enum class Kind : std::uint8_t {
    Empty,
    Sampled,       // a warped texel lies within half a texel, along both axes
    Filled,        // interpolated between neighbours that were drawn apart
    FilledAcross,  // the same across a jump of depth: a skin
};

// The warped picture on the source's plane. Where coverage is 0 the other channels mean nothing; so they may
// hold what a former warp left there.
struct Prewarped {
    Window window;  // pixel (0, 0) is texel (window.x0, window.y0) of the plane
    Image<LinearRgb> color;
    Image<Vec3> normal;   // interpolated: of any length
    Image<Scalar> depth;  // displacement behind the plane along f, world units, for either kind of source
    Image<std::uint8_t> coverage;
    // only with settings.maps
    Image<Vec2> source;  // (u, v) of the source that is seen here, in texels
    Image<Kind> kind;
    Image<std::uint16_t> writes;  // how often the pixel was painted (at most 65535)
};

// An interpolating resampler never holds more than this of a texel: all of it multiplied by the weight
// h / (h + d), which makes each number linear in the warped picture (perspective-correct interpolation).
template <bool maps>
struct Carried {
    static constexpr int size = maps ? 12 : 8;
    enum Slot { red, green, blue, depth, normal_x, normal_y, normal_z, weight, source_u, source_v };
    alignas(4 * sizeof(Scalar)) Scalar slot[size];
};

template <bool maps>
Carried<maps> lerp(const Carried<maps>& a, const Carried<maps>& b, Scalar t) {
    Carried<maps> c;
    for (int k = 0; k < Carried<maps>::size; ++k) c.slot[k] = a.slot[k] + t * (b.slot[k] - a.slot[k]);
    return c;
}

// The constants of a warp as the loops use them: rounded once, and for a depth d behind the plane in world
// units, of either source:
//
//     weight = 1 / (1 + d / h)     1 / (1 + k3 q) = weight + (weight d) / H     q / (1 + k3 q) = s (weight d)
//
// with H the height of the source's eye, 1 / H = 0 and s = 1 for an orthographic source, else s = -1 / H. So
// the place in the warped picture is a sum of products of what is carried: linear, and without a division.
struct DepthWarp {
    Scalar inverse_h, inverse_source_h, k1s, k2s;
    explicit DepthWarp(const Warp& warp)
        : inverse_h(static_cast<Scalar>(1 / warp.h)),
          inverse_source_h(static_cast<Scalar>(1 / warp.source_h)) {
        const double s = warp.projection == Projection::Orthographic ? 1 : -1 / warp.source_h;
        k1s = static_cast<Scalar>(s * warp.k1), k2s = static_cast<Scalar>(s * warp.k2);
    }
};

// How much smaller the texel is drawn that carries c: 1 / (1 + k3 q).
template <bool maps>
Scalar texel_scale(const Carried<maps>& c, const DepthWarp& warp) {
    return c.slot[c.weight] + c.slot[c.depth] * warp.inverse_source_h;
}
// The place u_i or v_i to which c goes from place u or v of the source; in texels of the plane.
template <bool maps>
Scalar warped_u_of(const Carried<maps>& c, Scalar u, const DepthWarp& warp) {
    return u * texel_scale(c, warp) + c.slot[c.depth] * warp.k1s;
}
template <bool maps>
Scalar warped_v_of(const Carried<maps>& c, Scalar v, const DepthWarp& warp) {
    return v * texel_scale(c, warp) + c.slot[c.depth] * warp.k2s;
}
// The same colour and normal at another depth.
template <bool maps>
Carried<maps> at_depth(Carried<maps> c, Scalar depth, const DepthWarp& warp) {
    const Scalar weight = 1 / (1 + depth * warp.inverse_h), change = weight / c.slot[c.weight];
    for (Scalar& number : c.slot) number *= change;
    c.slot[c.depth] = depth * weight, c.slot[c.weight] = weight;
    return c;
}

// The warped picture. `window` is at most max_picture_size a side; texels that go beyond it are cut off. The
// second form fills `result` and takes no new memory when it has the size already, for one picture after
// another.
Prewarped prewarp(const ReliefTexture& texture, const Warp& warp, const Window& window,
                  const PrewarpSettings& settings = {});
void prewarp(const ReliefTexture& texture, const Warp& warp, const Window& window,
             const PrewarpSettings& settings, Prewarped& result);

}  // namespace relevo::relief
