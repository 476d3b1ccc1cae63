// The asymmetric resampler: the horizontal pass carries along the row to which each sample will go
// (Oliveira, Bishop and McAllister 2000; Clua 2004, 8.2.1).
//
//     v_i(t) = (1 - t) v_i(A) + t v_i(B)
//
// Exact for what is planar between A and B, at the price of one more number a sample.
#pragma once
#include "relief/resample_picture.hpp"

namespace relevo::relief {

struct AsymmetricMethod {
    static constexpr bool carries_row = true, keeps_all = false;
    template <bool maps>
    static void adjust(RowSample<maps>&, const Carried<maps>&, const Carried<maps>&, Scalar,
                       const DepthWarp&) {}
};

}  // namespace relevo::relief
