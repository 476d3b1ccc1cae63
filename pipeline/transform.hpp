// Translation, scaling, rotation, the camera's view, and how normals move (textbook 3.1).
#pragma once
#include "pipeline/elementary.hpp"
#include "pipeline/result.hpp"
#include "pipeline/space.hpp"

namespace relevo::pipeline {

glm::dmat4 translation_matrix(glm::dvec3 by);
glm::dmat4 scaling_matrix(glm::dvec3 by);
// `axis` of any length but zero.
Result<glm::dmat4> rotation_matrix(glm::dvec3 axis, Degrees angle);

// Maps within one space (textbook 3.1.2): the point goes to p + by, to by * p, round the axis by the
// right-hand rule.
template <class S>
Affine<S, S> translate(glm::dvec3 by) {
    return {translation_matrix(by)};
}
template <class S>
Affine<S, S> scale(glm::dvec3 by) {
    return {scaling_matrix(by)};
}
// An error when the axis is zero or not finite.
template <class S>
Result<Affine<S, S>> rotate(glm::dvec3 axis, Degrees angle) {
    const auto matrix = rotation_matrix(axis, angle);
    if (!matrix) return matrix.error();
    return Affine<S, S>{*matrix};
}

// The view of an eye at `eye` that looks towards `target`, with `up` upwards in the picture. In eye space the
// eye is the origin, looks down -z, +y is up. An error when eye and target are the same point, when up is
// zero or parallel to the line of sight (closer than 1e-12 of its length), or when a number is not finite.
Result<Affine<Eye, World>> look_at(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up);

// How normals move under `map`: by its cofactor matrix, which is the inverse transpose times the determinant,
// so that no division can fail; scaled by a power of two against overflow, and by the determinant's sign so
// that normals of a mirrored object still point outwards. Lengths are not kept. A map that flattens gives the
// normal of its plane.
glm::dmat3 normal_matrix(const glm::dmat4& map);

// Whether the map turns windings around (negative determinant).
bool is_mirrored(const glm::dmat4& map);

template <class B, class A>
NormalMap<B, A> normal_map(const Affine<B, A>& b_from_a) {
    const glm::dmat3 m = normal_matrix(b_from_a.m);
    NormalMap<B, A> out{};
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) out.row[r][c] = static_cast<Scalar>(m[c][r]);
    return out;
}

}  // namespace relevo::pipeline
