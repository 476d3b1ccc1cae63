#include "pipeline/projection.hpp"

#include <cmath>

namespace relevo::pipeline {
namespace {

struct DepthRow {
    double a, b;  // z_clip = a z_eye + b
};

// z_clip = a z + b with w = -z, so that z/w is 1 and 0 (reversed) or 0 and 1 (forward) at the two planes.
DepthRow perspective_depth(double n, double f, DepthRange range) {
    if (range == DepthRange::Reversed)
        return std::isinf(f) ? DepthRow{0, n} : DepthRow{n / (f - n), n / (1 - n / f)};
    return std::isinf(f) ? DepthRow{-1, -n} : DepthRow{-1 / (1 - n / f), -n / (1 - n / f)};
}

bool finite(double a, double b) { return std::isfinite(a) && std::isfinite(b); }

Result<glm::dmat4> checked(const glm::dmat4& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(static_cast<Scalar>(m[c][r])))
                return Error{"these numbers give a projection matrix beyond the range of the arithmetic"};
    return m;
}

Result<Projective<Clip, Eye>> projective(const glm::dmat4& m) {
    const auto good = checked(m);
    if (!good) return good.error();
    return Projective<Clip, Eye>{*good};
}

const char* wrong_planes(double near, double far) {
    // also after rounding: a near of 0 would give every point depth 0
    if (!std::isfinite(near) || !(static_cast<Scalar>(near) > 0))
        return "near must be more than 0 (and finite)";
    if (std::isnan(far) || !(far > near)) return "far must be more than near (inf is accepted)";
    return nullptr;
}

}  // namespace

Result<Projective<Clip, Eye>> perspective(Degrees fov_y, double aspect, double near, double far,
                                          DepthRange range) {
    if (!(fov_y.value > 0 && fov_y.value < 180))
        return Error{"fov_y must be more than 0 and less than 180 degrees"};
    if (!(aspect > 0) || !std::isfinite(aspect))
        return Error{"the aspect ratio must be more than 0 (and finite)"};
    if (const char* wrong = wrong_planes(near, far)) return Error{wrong};
    const double half_height = tan(Degrees{fov_y.value / 2});
    const DepthRow depth = perspective_depth(near, far, range);
    glm::dmat4 m{0.0};
    m[0][0] = 1 / (half_height * aspect);
    m[1][1] = 1 / half_height;
    m[2][2] = depth.a;
    m[3][2] = depth.b;
    m[2][3] = -1;
    return projective(m);
}

Result<Projective<Clip, Eye>> frustum(double left, double right, double bottom, double top, double near,
                                      double far, DepthRange range) {
    if (const char* wrong = wrong_planes(near, far)) return Error{wrong};
    if (!finite(left, right) || !(left < right)) return Error{"left must be less than right"};
    if (!finite(bottom, top) || !(bottom < top)) return Error{"bottom must be less than top"};
    const DepthRow depth = perspective_depth(near, far, range);
    glm::dmat4 m{0.0};
    m[0][0] = 2 * near / (right - left);
    m[1][1] = 2 * near / (top - bottom);
    m[2][0] = (right + left) / (right - left);
    m[2][1] = (top + bottom) / (top - bottom);
    m[2][2] = depth.a;
    m[3][2] = depth.b;
    m[2][3] = -1;
    return projective(m);
}

Result<Projective<Clip, Eye>> orthographic(double left, double right, double bottom, double top, double near,
                                           double far, DepthRange range) {
    if (!finite(left, right) || !(left < right)) return Error{"left must be less than right"};
    if (!finite(bottom, top) || !(bottom < top)) return Error{"bottom must be less than top"};
    if (!finite(near, far) || !(near < far)) return Error{"far must be more than near, and both finite"};
    const bool reversed = range == DepthRange::Reversed;
    glm::dmat4 m{1.0};
    m[0][0] = 2 / (right - left);
    m[1][1] = 2 / (top - bottom);
    m[2][2] = (reversed ? 1 : -1) / (far - near);
    m[3][0] = -(right + left) / (right - left);
    m[3][1] = -(top + bottom) / (top - bottom);
    m[3][2] = (reversed ? far : -near) / (far - near);
    return projective(m);
}

}  // namespace relevo::pipeline
