// A triangle that crosses near, far or the guard band, as corners in the window: clipped in clip space,
// divided, snapped.
//
// The polygon is drawn as triangles round its topmost corner: the same ones whichever corner of the mesh's
// triangle is first.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "pipeline/clip_polygon.hpp"
#include "pipeline/viewport.hpp"

namespace relevo::raster {

using pipeline::SnappedCorner;

enum class Clipped { Visible, Outside, NonFinite };

template <std::size_t N>
struct ClippedTriangle {
    static constexpr std::size_t capacity = pipeline::ClipPolygon<N>::capacity;
    Clipped result = Clipped::Outside;
    std::size_t size = 0;  // 3..capacity when visible
    std::size_t top = 0;   // its topmost corner
    std::array<pipeline::HPoint<pipeline::Clip>, capacity> clip;
    std::array<SnappedCorner, capacity> window;
    std::array<std::array<pipeline::Scalar, N>, capacity> varying;
};

// `crossed` is the union of the corners' clip codes, none of them non-finite or the origin.
template <std::size_t N, class Probe = const pipeline::NoProbe>
ClippedTriangle<N> clip_triangle(const pipeline::ClipPolygon<N>& triangle, pipeline::ClipCodes crossed,
                                 const pipeline::Viewport& viewport, Probe&& probe = {}) {
    ClippedTriangle<N> out;
    const auto polygon = pipeline::clip_polygon(triangle, pipeline::guard_planes, crossed, probe);
    if (polygon.size < 3) return out;
    out.size = static_cast<std::size_t>(polygon.size);
    for (std::size_t k = 0; k < out.size; ++k) {
        out.clip[k] = pipeline::rounded_position(polygon.corners[k], pipeline::guard_planes);
        if (!(out.clip[k].v.w > 0) || !std::isfinite(1 / out.clip[k].v.w)) {
            out.result = Clipped::NonFinite;
            return out;
        }
        for (std::size_t j = 0; j < N; ++j)
            out.varying[k][j] = static_cast<pipeline::Scalar>(polygon.corners[k].varying[j]);
        out.window[k] = pipeline::to_window(out.clip[k], viewport);
    }
    const auto above = [](const SnappedCorner& p, const SnappedCorner& q) {
        return p.y != q.y ? p.y < q.y : p.x != q.x ? p.x < q.x : p.z != q.z ? p.z < q.z : p.rw < q.rw;
    };
    const auto end = out.window.begin() + std::ptrdiff_t(out.size);
    out.top = std::size_t(std::min_element(out.window.begin(), end, above) - out.window.begin());
    out.result = Clipped::Visible;
    return out;
}

// Calls visit(a, b, c) with the corners' numbers of each triangle of the fan.
template <std::size_t N, class Visit>
void for_each_fan_triangle(const ClippedTriangle<N>& polygon, Visit&& visit) {
    for (std::size_t k = 1; k + 1 < polygon.size; ++k)
        visit(polygon.top, (polygon.top + k) % polygon.size, (polygon.top + k + 1) % polygon.size);
}

}  // namespace relevo::raster
