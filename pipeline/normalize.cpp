#include "pipeline/normalize.hpp"

#include <algorithm>
#include <cmath>

namespace relevo::pipeline {

Vec3 normalize_extreme(Vec3 v) {
    if (!(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z))) return {0, 0, 0};
    const Scalar largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0) return {0, 0, 0};
    const int e = std::ilogb(largest);
    const Vec3 s{std::ldexp(v.x, -e), std::ldexp(v.y, -e), std::ldexp(v.z, -e)};
    return s * (1 / std::sqrt(dot<Scalar>(s, s)));
}

}  // namespace relevo::pipeline
