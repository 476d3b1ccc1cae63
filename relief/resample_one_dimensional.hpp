// The one-dimensional resampler: the horizontal pass interpolates the displacement linearly, the
// vertical pass takes it for the truth (Oliveira, Bishop and McAllister 2000; Clua 2004, 8.2).
//
//     d(t) = (1 - t) d_A + t d_B
//
// The warp is not linear in d, so the sample lands in a wrong row: 0.002 to 0.04 texel between
// neighbours of a smooth surface, up to 25 texels where a skin is stretched across a step of depth:
// straight edges bend. All other numbers are interpolated as by the other methods.
#pragma once
#include "relief/resample_picture.hpp"

namespace relevo::relief {

struct OneDimensionalMethod {
    static constexpr bool carries_row = false, keeps_all = false;
    template <bool maps>
    static void adjust(RowSample<maps>& sample, const Carried<maps>& a, const Carried<maps>& b, Scalar t,
                       const DepthWarp& warp) {
        sample.carried.set_depth(a.depth() + t * (b.depth() - a.depth()));
        sample.weight = weight_at(sample.carried.depth(), warp);
    }
};

}  // namespace relevo::relief
