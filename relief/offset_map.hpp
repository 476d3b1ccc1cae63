// Channels by the map of sources: where each pixel of a warped picture comes from is all that a warp has
// to compute; colour, normals, a reflection or anything else that is known for the texels is then
// fetched (Fujita and Kanai, "Hardware-assisted relief texture mapping", Eurographics 2002).
//
// At the centre of a texel, where splats always look, this is the texel itself, to the bit. Between
// texels it mixes the four around the place, where a resampler mixes the ends of two stretches: nearly
// the same.
#pragma once
#include "relief/prewarp.hpp"
#include "relief/texel_shares.hpp"

namespace relevo::relief {

// The channel (of the source's size) as the warped picture shows it; `picture` was made with
// settings.maps. Where nothing is seen: Value{}. Value is LinearRgb, Vec3, or what else can be added and
// multiplied by a Scalar.
template <class Value>
Image<Value> fetch_by_map(const Prewarped& picture, const ReliefTexture& source, const Image<Value>& channel,
                          Reading reading = Reading::Bilinear, Scalar jump_depth = Scalar(0.1)) {
    assert(channel.width() == source.camera.width && channel.height() == source.camera.height);
    assert(picture.source.width() == picture.window.width);
    Image<Value> fetched(picture.window.width, picture.window.height);
    for (int y = 0; y < fetched.height(); ++y)
        for (int x = 0; x < fetched.width(); ++x) {
            if (!picture.coverage.at(x, y)) continue;
            const Vec2 from = picture.source.at(x, y);
            const auto shares = texel_shares(
                channel.width(), channel.height(), double{from.x}, double{from.y}, reading,
                double{jump_depth}, [&](int i, int j) { return source.coverage.at(i, j) != 0; },
                [&](int i, int j) { return double{source.depth.at(i, j)}; });
            if (!shares) continue;
            fetched.at(x, y) = weighted_sum(*shares, Value{}, [&](int i, int j, double share) {
                return static_cast<Scalar>(share) * channel.at(i, j);
            });
        }
    return fetched;
}

}  // namespace relevo::relief
