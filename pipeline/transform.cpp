#include "pipeline/transform.hpp"

#include <algorithm>
#include <cmath>

namespace relevo::pipeline {
namespace {

bool is_finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double dot3(glm::dvec3 a, glm::dvec3 b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

glm::dvec3 cross3(glm::dvec3 a, glm::dvec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double largest_of(glm::dvec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// A unit vector; the scaling by a power of two keeps the squares in range. `v` is finite and not zero.
glm::dvec3 unit(glm::dvec3 v) {
    const int e = std::ilogb(largest_of(v));
    const glm::dvec3 s{std::ldexp(v.x, -e), std::ldexp(v.y, -e), std::ldexp(v.z, -e)};
    return s / std::sqrt(dot3(s, s));
}

double determinant_of(const glm::dmat3& m) { return dot3(m[0], cross3(m[1], m[2])); }

glm::dmat3 linear_part(const glm::dmat4& map) {
    return {glm::dvec3(map[0]), glm::dvec3(map[1]), glm::dvec3(map[2])};
}

// The matrix times a power of two that brings its largest entry to [1, 2); zero stays zero.
glm::dmat3 scaled(glm::dmat3 m) {
    const double largest = std::max({largest_of(m[0]), largest_of(m[1]), largest_of(m[2])});
    if (!(largest > 0) || !std::isfinite(largest)) return m;
    const int e = std::ilogb(largest);
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) m[c][r] = std::ldexp(m[c][r], -e);
    return m;
}

}  // namespace

glm::dmat4 translation_matrix(glm::dvec3 by) {
    glm::dmat4 m{1.0};
    m[3] = glm::dvec4(by, 1.0);
    return m;
}

glm::dmat4 scaling_matrix(glm::dvec3 by) {
    glm::dmat4 m{1.0};
    for (int i = 0; i < 3; ++i) m[i][i] = by[i];
    return m;
}

// Rodrigues: R = cos I + (1 - cos) a a^T + sin [a]x
Result<glm::dmat4> rotation_matrix(glm::dvec3 axis, Degrees angle) {
    if (!is_finite(axis) || largest_of(axis) == 0) return Error{"the axis of a rotation must not be zero"};
    if (!std::isfinite(angle.value))
        return Error{"the angle of a rotation must be a finite number of degrees"};
    const glm::dvec3 a = unit(axis);
    const double s = sin(angle), c = cos(angle);
    const double cross_matrix[3][3] = {{0, -a.z, a.y}, {a.z, 0, -a.x}, {-a.y, a.x, 0}};
    glm::dmat4 m{1.0};
    for (int row = 0; row < 3; ++row)
        for (int col = 0; col < 3; ++col)
            m[col][row] = (row == col ? c : 0.0) + (1 - c) * (a[row] * a[col]) + s * cross_matrix[row][col];
    return m;
}

Result<Affine<Eye, World>> look_at(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up) {
    if (!is_finite(eye) || !is_finite(target) || !is_finite(up))
        return Error{"eye, target and up must be finite"};
    const glm::dvec3 sight = target - eye;
    if (!is_finite(sight) || largest_of(sight) == 0)
        return Error{"eye and target are the same point; the camera needs a direction to look in"};
    if (largest_of(up) == 0)
        return Error{"up is zero; it must be a direction that is not along the line of sight"};
    const glm::dvec3 forward = unit(sight);
    const glm::dvec3 sideways = cross3(forward, unit(up));
    if (dot3(sideways, sideways) < 1e-24)
        return Error{"up is parallel to the line of sight from eye to target; choose another up"};
    const glm::dvec3 right = unit(sideways), upwards = cross3(right, forward);
    const glm::dvec3 rows[3] = {right, upwards, -forward};
    glm::dmat4 m{1.0};
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) m[c][r] = rows[r][c];
        m[3][r] = -dot3(rows[r], eye);
    }
    return Affine<Eye, World>{m};
}

glm::dmat3 normal_matrix(const glm::dmat4& map) {
    const glm::dmat3 m = scaled(linear_part(map));
    const glm::dmat3 cofactors = scaled({cross3(m[1], m[2]), cross3(m[2], m[0]), cross3(m[0], m[1])});
    return is_mirrored(map) ? -cofactors : cofactors;
}

bool is_mirrored(const glm::dmat4& map) { return determinant_of(scaled(linear_part(map))) < 0; }

}  // namespace relevo::pipeline
