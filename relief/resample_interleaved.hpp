// The interleaved resampler: one pass over the source (Clua 2004, 8.2.3; Oliveira, "Relief texture
// mapping", dissertation, UNC 2000).
//
// Each sample of a row goes to its column at once, and all of them are drawn: a row that folds loses no
// surface, where the forms in two passes keep one sample a column. (Skins and half texels that fold back are
// behind what they hang from: no form draws them.)
#pragma once
#include "relief/resample_asymmetric.hpp"

namespace relevo::relief {

struct InterleavedMethod : AsymmetricMethod {
    static constexpr bool keeps_all = true;
};

}  // namespace relevo::relief
