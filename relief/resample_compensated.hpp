// The resampler with displacement compensation: between two texels of a row the displacement is chosen
// so that the vertical pass, which knows nothing else, finds the right row by itself (Oliveira, Bishop
// and McAllister 2000; Clua 2004, 8-1).
//
//     d(t) = ((1 - t) d_A w_A + t d_B w_B) / ((1 - t) w_A + t w_B)        w = h / (h + d)
//
// That is (8-1) without the row in it, so it does not become 0 / 0 on the row of the epipole as the
// printed form does; and it is nothing else but perspective-correct interpolation, which all that is
// carried undergoes (carried.hpp).
#pragma once
#include "relief/resample_picture.hpp"

namespace relevo::relief {

struct CompensatedMethod {
    static constexpr bool carries_row = false, keeps_all = false;
    template <bool maps>
    static void adjust(RowSample<maps>&, const Carried<maps>&, const Carried<maps>&, Scalar,
                       const DepthWarp&) {}
};

// The forms of the literature, for comparison. A and B are neighbours in the source's row v, of depth
// d_a and d_b; t is their share in the warped row. Orthographic source.
inline double compensated_depth(double d_a, double w_a, double d_b, double w_b, double t) {
    return ((1 - t) * d_a * w_a + t * d_b * w_b) / ((1 - t) * w_a + t * w_b);
}
// (8-1), shortened: 0 / 0 where v is the epipole's row.
inline double compensated_depth_by_row(const Warp& warp, double v, double v_a, double v_b, double t) {
    const double v_t = (1 - t) * v_a + t * v_b;
    return (v - v_t) / (warp.k3 * v_t - warp.k2);
}

}  // namespace relevo::relief
