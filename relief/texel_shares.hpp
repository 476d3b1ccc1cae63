// Between the texels: which of them a place of a picture is made of, and in what shares.
//
// Bilinear shares are right inside a surface and wrong at its borders: a mean of a near and a far depth is a
// point that does not exist. So only those of the four texels count that are covered and whose depth lies
// within `jump` of the nearest one's, and their shares are made 1 again. A place is empty when the covered
// ones among the four have less than half of the weight.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "pipeline/scalar.hpp"
#include "raster/image.hpp"

namespace relevo::relief {

using pipeline::Scalar;
using raster::Image;

enum class Reading { Nearest, Bilinear };

// Texel i is (x + i % 2, y + i / 2). Its share is 0 where it does not count; a texel with a share lies in the
// picture.
struct TexelShares {
    int x, y;
    std::array<double, 4> share;
};

// covered(x, y) and depth(x, y) are asked for texels of the picture, depth for covered ones.
template <class Covered, class Depth>
std::optional<TexelShares> texel_shares(int width, int height, double u, double v, Reading reading,
                                        double jump, Covered&& covered, Depth&& depth) {
    const auto holds = [&](int x, int y) { return x >= 0 && y >= 0 && x < width && y < height; };
    if (!(u >= 0 && v >= 0 && u < width && v < height)) return {};
    if (reading == Reading::Nearest) {
        const int x = static_cast<int>(u), y = static_cast<int>(v);
        if (!covered(x, y)) return {};
        return TexelShares{x, y, {1, 0, 0, 0}};
    }
    const int x = static_cast<int>(std::floor(u - 0.5)), y = static_cast<int>(std::floor(v - 0.5));
    const double s = u - 0.5 - x, t = v - 0.5 - y;
    TexelShares result{x, y, {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t}};
    double sum = 0;
    int heaviest = -1;
    for (int i = 0; i < 4; ++i) {
        double& share = result.share[std::size_t(i)];
        if (!holds(x + i % 2, y + i / 2) || !covered(x + i % 2, y + i / 2)) share = 0;
        sum += share;
        if (share > 0 && (heaviest < 0 || share > result.share[std::size_t(heaviest)])) heaviest = i;
    }
    if (!(sum >= 0.5)) return {};
    const double nearest = depth(x + heaviest % 2, y + heaviest / 2);
    sum = 0;
    for (int i = 0; i < 4; ++i) {
        double& share = result.share[std::size_t(i)];
        if (share > 0 && std::fabs(depth(x + i % 2, y + i / 2) - nearest) > jump) share = 0;
        sum += share;
    }
    for (double& share : result.share) share /= sum;
    return result;
}

// What the picture has there; `zero` is the sum's beginning.
template <class Sum, class Value>
Sum weighted_sum(const TexelShares& shares, Sum zero, Value&& value) {
    Sum sum = zero;
    for (int i = 0; i < 4; ++i)
        if (const double share = shares.share[std::size_t(i)]; share > 0)
            sum = sum + value(shares.x + i % 2, shares.y + i / 2, share);
    return sum;
}

}  // namespace relevo::relief
