// Typed coordinates: a value knows the space in which it is written, a map knows both of its ends.
//
//   object --world_from_object--> world --eye_from_world--> eye --clip_from_eye--> clip --divide--> ndc -->
//   window
//
// Object, world and eye space are right-handed; the eye looks down -z with +y up. The clip volume is
// -w <= x, y <= w and 0 <= z <= w. In the window x runs right, y runs down, pixel (i, j) is [i,i+1) x
// [j,j+1).
//
// Only the lawful operations exist: Point - Point = Vec, Point + Vec = Point, Map<C, B> * Map<B, A> = Map<C,
// A>. The doors out are `.v` and `.m`; a cast is written Point<World>{p.v} and can be seen in review.
#pragma once
#include <cmath>

#include "pipeline/scalar.hpp"

namespace relevo::pipeline {

struct Object {};
struct World {};
struct Eye {};
struct Clip {};
struct Ndc {};
struct Window {};

template <class Space>
struct Vec {  // a displacement: no translation moves it
    Vec3 v;
};
template <class Space>
struct Point {
    Vec3 v;
};
template <class Space>
struct HPoint {  // a homogeneous point, before the division by w
    Vec4 v;
};
template <class Space>
struct Normal {  // a covector: moved by the inverse transpose, any length
    Vec3 v;
};

template <class S>
constexpr Vec<S> operator-(Point<S> a, Point<S> b) {
    return {a.v - b.v};
}
template <class S>
constexpr Point<S> operator+(Point<S> p, Vec<S> d) {
    return {p.v + d.v};
}
template <class S>
constexpr Vec<S> operator+(Vec<S> a, Vec<S> b) {
    return {a.v + b.v};
}
template <class S>
constexpr Vec<S> operator*(Scalar k, Vec<S> a) {
    return {k * a.v};
}

// Maps are kept and composed in double. Column vectors: m * v.
template <class To, class From>
struct Affine {  // the last row is 0 0 0 1
    glm::dmat4 m{1.0};
};
template <class To, class From>
struct Projective {
    glm::dmat4 m{1.0};
};

template <class C, class B, class A>
Affine<C, A> operator*(const Affine<C, B>& c_from_b, const Affine<B, A>& b_from_a) {
    return {c_from_b.m * b_from_a.m};
}
template <class C, class B, class A>
Projective<C, A> operator*(const Projective<C, B>& c_from_b, const Affine<B, A>& b_from_a) {
    return {c_from_b.m * b_from_a.m};
}

// A map rounded once to Scalar, ready to move vertices. The order of the sums is part of the promise of equal
// bytes:
//   row r of a point:  ((m0 x + m1 y) + m2 z) + m3      of a displacement or normal:  (m0 x + m1 y) + m2 z
template <class To, class From>
struct RoundedAffine {
    Scalar row[3][4];
};
template <class To, class From>
struct RoundedProjective {
    Scalar row[4][4];
};

template <class To, class From>
RoundedAffine<To, From> rounded(const Affine<To, From>& map) {
    RoundedAffine<To, From> out;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c) out.row[r][c] = static_cast<Scalar>(map.m[c][r]);
    return out;
}
template <class To, class From>
RoundedProjective<To, From> rounded(const Projective<To, From>& map) {
    RoundedProjective<To, From> out;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) out.row[r][c] = static_cast<Scalar>(map.m[c][r]);
    return out;
}

// V: a Vec3, or one for each lane.
template <class V = Vec3>
constexpr auto row_times_point(const Scalar (&m)[4], const V& p) {
    return ((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3];
}
template <class V = Vec3>
constexpr auto row_times_direction(const Scalar (&m)[4], const V& d) {
    return (m[0] * d.x + m[1] * d.y) + m[2] * d.z;
}

template <class B, class A>
constexpr Point<B> operator*(const RoundedAffine<B, A>& map, Point<A> p) {
    return {{row_times_point(map.row[0], p.v), row_times_point(map.row[1], p.v),
             row_times_point(map.row[2], p.v)}};
}
template <class B, class A>
constexpr Vec<B> operator*(const RoundedAffine<B, A>& map, Vec<A> d) {
    return {{row_times_direction(map.row[0], d.v), row_times_direction(map.row[1], d.v),
             row_times_direction(map.row[2], d.v)}};
}
template <class B, class A>
constexpr HPoint<B> operator*(const RoundedProjective<B, A>& map, Point<A> p) {
    return {{row_times_point(map.row[0], p.v), row_times_point(map.row[1], p.v),
             row_times_point(map.row[2], p.v), row_times_point(map.row[3], p.v)}};
}

// How normals move under an affine map: a map of its own, so that a normal cannot meet the forward matrix.
template <class To, class From>
struct NormalMap {
    Scalar row[3][4];  // the last column is zero
};
template <class B, class A>
constexpr Normal<B> operator*(const NormalMap<B, A>& map, Normal<A> n) {
    return {{row_times_direction(map.row[0], n.v), row_times_direction(map.row[1], n.v),
             row_times_direction(map.row[2], n.v)}};
}

}  // namespace relevo::pipeline
