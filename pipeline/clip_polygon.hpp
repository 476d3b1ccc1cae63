// Polygon clipping in homogeneous coordinates, one plane after the other (Sutherland and Hodgman 1974; in
// clip space, before the division: Blinn and Newell 1978; textbook 4.4).
//
// in:  a convex polygon of finite clip coordinates, any winding, any sign of w
// out: the same winding, no corner beyond a plane, empty when nothing is left
//
// Four choices keep it exact (each one has a test with the input that breaks its absence):
//   * double, so that no product overflows;
//   * the weighted form (d_in V_out - d_out V_in) / (d_in - d_out): there is no t to round to 0 or 1, and
//     swapping the ends turns both signs around, so triangles that share an edge get the same new corner;
//   * the coordinate that a plane fixes is written exactly onto the plane;
//   * planes that no corner lies beyond are not visited.
#pragma once
#include <array>
#include <cassert>
#include <span>

#include "pipeline/clip_codes.hpp"
#include "pipeline/probe.hpp"
#include "pipeline/space.hpp"

namespace relevo::pipeline {

// The half-space sign * coordinate[axis] <= factor * w.
struct ClipPlane {
    int axis, sign, factor;
    friend constexpr bool operator==(const ClipPlane&, const ClipPlane&) = default;
};

constexpr double distance_inside(const ClipPlane& plane, const glm::dvec4& p) {
    return plane.factor * p.w - plane.sign * p[plane.axis];
}

// In the order of the clip codes' bits.
constexpr std::array<ClipPlane, 6> clip_planes(int side) {
    return {{{2, 1, 1}, {2, -1, 0}, {0, -1, side}, {0, 1, side}, {1, -1, side}, {1, 1, side}}};
}
inline constexpr std::array<ClipPlane, 6> guard_planes = clip_planes(guard_band);
inline constexpr std::array<ClipPlane, 6> view_volume_planes =
    clip_planes(1);  // the six faces of the view volume

// A corner on its way through the planes, with the numbers that it carries (what they are is the caller's
// business).
template <std::size_t N>
struct ClipCorner {
    glm::dvec4 position;
    std::array<double, N> varying;
    unsigned pinned = 0;  // bit k: made by plane k of the list, lies exactly on it
};

// A plane adds one corner to a convex polygon; the spare room is for polygons that rounding has bent.
template <std::size_t N>
struct ClipPolygon {
    static constexpr int capacity = 32;
    std::array<ClipCorner<N>, capacity> corners;
    int size = 0;

    void push(const ClipCorner<N>& corner) {
        assert(size < capacity);
        if (size < capacity) corners[std::size_t(size++)] = corner;
    }
    std::span<const ClipCorner<N>> span() const { return {corners.data(), std::size_t(size)}; }
};

struct EdgeCrossed {  // an edge of the polygon crosses a plane; `made` is the new corner
    ClipPlane plane;
    glm::dvec4 inside, outside, made;
};
struct PolygonClipped {  // one plane is done
    ClipPlane plane;
    int corners_before, corners_after;
};

constexpr void pin(glm::dvec4& p, const ClipPlane& plane) {
    p[plane.axis] = plane.factor == 0 ? 0.0 : plane.sign * (plane.factor * p.w);
}

template <std::size_t N>
ClipCorner<N> crossing(const ClipPlane& plane, unsigned plane_bit, const ClipCorner<N>& inside,
                       const ClipCorner<N>& outside, std::span<const ClipPlane> planes) {
    const double d_in = distance_inside(plane, inside.position),
                 d_out = distance_inside(plane, outside.position);
    const double whole = d_in - d_out;
    const auto mix = [&](double in, double out) { return (d_in * out - d_out * in) / whole; };
    ClipCorner<N> made;
    for (int k = 0; k < 4; ++k) made.position[k] = mix(inside.position[k], outside.position[k]);
    for (std::size_t k = 0; k < N; ++k) made.varying[k] = mix(inside.varying[k], outside.varying[k]);
    made.pinned = (inside.pinned & outside.pinned) | plane_bit;
    for (std::size_t k = 0; k < planes.size(); ++k)
        if (made.pinned >> k & 1) pin(made.position, planes[k]);
    return made;
}

// One pass: the part of the polygon inside planes[which].
template <std::size_t N, class Probe>
ClipPolygon<N> clip_against(const ClipPolygon<N>& in, std::span<const ClipPlane> planes, std::size_t which,
                            Probe& probe) {
    const ClipPlane& plane = planes[which];
    ClipPolygon<N> out;
    for (int i = 0; i < in.size; ++i) {
        const ClipCorner<N>& a = in.corners[std::size_t(i)];
        const ClipCorner<N>& b = in.corners[std::size_t(i + 1 == in.size ? 0 : i + 1)];
        const double a_distance = distance_inside(plane, a.position),
                     b_distance = distance_inside(plane, b.position);
        if (a_distance >= 0) out.push(a);
        const bool crosses = a_distance > 0 ? b_distance < 0 : a_distance < 0 && b_distance > 0;
        if (!crosses) continue;  // a corner on the plane is its own crossing
        const ClipCorner<N>& inside = a_distance > 0 ? a : b;
        const ClipCorner<N>& outside = a_distance > 0 ? b : a;
        const ClipCorner<N> made = crossing(plane, 1u << which, inside, outside, planes);
        note<EdgeCrossed>(probe, plane, inside.position, outside.position, made.position);
        out.push(made);
    }
    note<PolygonClipped>(probe, plane, in.size, out.size);
    return out;
}

// The part of the polygon inside the planes whose bit is set in `visit` (bit k = planes[k], at most 32
// planes).
template <std::size_t N, class Probe = const NoProbe>
ClipPolygon<N> clip_polygon(ClipPolygon<N> polygon, std::span<const ClipPlane> planes, unsigned visit,
                            Probe&& probe = {}) {
    for (std::size_t k = 0; k < planes.size() && polygon.size > 0; ++k)
        if (visit >> k & 1) polygon = clip_against(polygon, planes, k, probe);
    return polygon;
}

// The corner rounded once to Scalar; on the planes that made it, it still lies exactly.
template <std::size_t N>
HPoint<Clip> rounded_position(const ClipCorner<N>& corner, std::span<const ClipPlane> planes) {
    HPoint<Clip> p{{static_cast<Scalar>(corner.position.x), static_cast<Scalar>(corner.position.y),
                    static_cast<Scalar>(corner.position.z), static_cast<Scalar>(corner.position.w)}};
    for (std::size_t k = 0; k < planes.size(); ++k)
        if (corner.pinned >> k & 1)
            p.v[planes[k].axis] = planes[k].factor == 0
                                      ? Scalar(0)
                                      : static_cast<Scalar>(planes[k].sign * planes[k].factor) * p.v.w;
    return p;
}

}  // namespace relevo::pipeline
