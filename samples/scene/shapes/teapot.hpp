// The Utah teapot: 32 bicubic Bezier patches, standing on y = 0, the spout towards +x; 6.5 units long, 3.15
// high.
//
// Source: M. E. Newell, "The Utilization of Procedure Models in Digital Image Synthesis", PhD thesis,
// University of Utah, 1975 (28 patches), with the bottom of F. Crow, "The Origins of the Teapot", IEEE CG&A
// 7(1), 1987 (4 patches).
//
// Rim, body and bottom are one profile that turns round the axis in four quarters, the lid another; handle
// and spout are half tubes mirrored at the plane of symmetry. So each of the four parts is one net of control
// points, given here by its profile or its half; neighbouring patches share the points of their common edge.
// The parts meet by passing through each other: the surface is not closed where they do, nor at the gap under
// the lid.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "samples/scene/shapes/grid.hpp"

namespace relevo::scene {

// (3 along + 1) rows of (3 round + 1) control points, x and y across and z upwards as Newell has them; seen
// from outside, columns run to the right and rows upwards, or both the other way.
struct ControlNet {
    int along = 0, round = 0;  // patches
    std::vector<glm::dvec3> points;
    glm::dvec3 at(int row, int column) const {
        return points[static_cast<std::size_t>(row * (3 * round + 1) + column)];
    }
};

// One row of a profile: a circle of this radius at this height. `bow` is how far the inner control points of
// a quarter reach along the tangent: 0.56 of the radius for a circle, but for one slip of the original.
struct ProfilePoint {
    double radius, height, bow;
};

inline constexpr std::array<ProfilePoint, 13> teapot_body = {{
    {1.4, 2.4, 0.784},
    {1.3375, 2.53125, 0.749},
    {1.4375, 2.53125, 0.805},
    {1.5, 2.4, 0.84},  // rim
    {1.75, 1.875, 0.98},
    {2, 1.35, 1.12},
    {2, 0.9, 1.12},  // upper body
    {2, 0.45, 1.12},
    {1.5, 0.225, 0.84},
    {1.5, 0.15, 0.84},  // lower body
    {1.5, 0.075, 0.84},
    {1.425, 0, 0.798},
    {0, 0, 0},  // bottom
}};

inline constexpr std::array<ProfilePoint, 7> teapot_lid = {{
    {0, 3.15, 0},
    {0.8, 3.15, 0.45},
    {0, 2.85, 0},
    {0.2, 2.7, 0.112},  // knob
    {0.4, 2.55, 0.224},
    {1.3, 2.55, 0.728},
    {1.3, 2.4, 0.728},  // cover
}};

// One row of a half tube: inner x and z on the plane of symmetry, outer x and z, and half the width.
struct HalfTubeRow {
    double inner_x, inner_z, outer_x, outer_z, half_width;
};

inline constexpr std::array<HalfTubeRow, 7> teapot_handle = {{
    {-1.6, 2.025, -1.5, 2.25, 0.3},
    {-2.3, 2.025, -2.5, 2.25, 0.3},
    {-2.7, 2.025, -3, 2.25, 0.3},
    {-2.7, 1.8, -3, 1.8, 0.3},  // where the two patches meet
    {-2.7, 1.575, -3, 1.35, 0.3},
    {-2.5, 1.125, -2.65, 0.9375, 0.3},
    {-2, 0.9, -1.9, 0.6, 0.3},
}};

inline constexpr std::array<HalfTubeRow, 7> teapot_spout = {{
    {1.7, 1.425, 1.7, 0.6, 0.66},
    {2.6, 1.425, 3.1, 0.825, 0.66},
    {2.3, 2.1, 2.4, 2.025, 0.25},
    {2.7, 2.4, 3.3, 2.4, 0.25},  // where the two patches meet
    {2.8, 2.475, 3.525, 2.49375, 0.25},
    {2.9, 2.475, 3.45, 2.5125, 0.15},
    {2.8, 2.4, 3.2, 2.4, 0.15},
}};

// Four quarters: (r, 0), (r, b), (b, r), (0, r) and so on round the axis.
inline ControlNet revolve(std::span<const ProfilePoint> profile) {
    ControlNet net{static_cast<int>(profile.size() / 3), 4, {}};
    for (const auto& [r, z, b] : profile)
        for (const glm::dvec3 p : {glm::dvec3(r, 0, z),
                                   {r, b, z},
                                   {b, r, z},
                                   {0, r, z},
                                   {-b, r, z},
                                   {-r, b, z},
                                   {-r, 0, z},
                                   {-r, -b, z},
                                   {-b, -r, z},
                                   {0, -r, z},
                                   {b, -r, z},
                                   {r, -b, z},
                                   {r, 0, z}})
            net.points.push_back(p);
    return net;
}

// From the inner edge round one side to the outer edge and back on the other side.
inline ControlNet mirror(std::span<const HalfTubeRow> rows) {
    ControlNet net{static_cast<int>(rows.size() / 3), 2, {}};
    for (const auto& [xi, zi, xo, zo, w] : rows)
        for (const glm::dvec3 p : {glm::dvec3(xi, 0, zi),
                                   {xi, w, zi},
                                   {xo, w, zo},
                                   {xo, 0, zo},
                                   {xo, -w, zo},
                                   {xi, -w, zi},
                                   {xi, 0, zi}})
            net.points.push_back(p);
    return net;
}

// The four cubic Bernstein polynomials and their derivatives.
struct Bernstein {
    std::array<double, 4> value, slope;
};
inline Bernstein bernstein(double t) {
    const double s = 1 - t;
    return {{s * s * s, 3 * t * (s * s), 3 * (t * t) * s, t * t * t},
            {-3 * (s * s), 3 * (s * s) - 6 * (s * t), 6 * (s * t) - 3 * (t * t), 3 * (t * t)}};
}

struct SurfacePoint {
    glm::dvec3 position, normal;  // the normal has length 1 and points outwards: d/drow x d/dcolumn
};

// S(s, t) = sum B_i(s) B_j(t) P_ij. In a row that is drawn together to one point (the tip of the lid, the
// middle of the bottom) dS/dt is 0; its direction is then the limit from inside the patch, d2S/dsdt (from the
// far end: its negative).
inline SurfacePoint evaluate(const ControlNet& net, int patch_row, int patch_column, double s, double t) {
    const Bernstein bs = bernstein(s), bt = bernstein(t);
    glm::dvec3 position{0, 0, 0}, ds{0, 0, 0}, dt{0, 0, 0}, dsdt{0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const glm::dvec3 p = net.at(3 * patch_row + int(i), 3 * patch_column + int(j));
            position += bs.value[i] * bt.value[j] * p;
            ds += bs.slope[i] * bt.value[j] * p;
            dt += bs.value[i] * bt.slope[j] * p;
            dsdt += bs.slope[i] * bt.slope[j] * p;
        }
    const auto squared = [](glm::dvec3 v) { return (v.x * v.x + v.y * v.y) + v.z * v.z; };
    if (squared(dt) < 1e-20) dt = s < 0.5 ? dsdt : -dsdt;
    const glm::dvec3 n{ds.y * dt.z - ds.z * dt.y, ds.z * dt.x - ds.x * dt.z, ds.x * dt.y - ds.y * dt.x};
    return {position, n / std::sqrt(squared(n))};
}

// `n` segments a patch side. Newell's z becomes y, and his y becomes -z: a quarter turn.
inline Mesh tessellate(const ControlNet& net, int n) {
    const int columns = net.round * n, rows = net.along * n;
    return grid_mesh(columns, rows, [&](int i, int j) {
        const int down = rows - j;
        const int row = std::min(down / n, net.along - 1), column = std::min(i / n, net.round - 1);
        const auto p = evaluate(net, row, column, double(down - row * n) / n, double(i - column * n) / n);
        const auto upright = [](glm::dvec3 v) { return glm::dvec3(v.x, v.z, -v.y); };
        return make_vertex(upright(p.position), upright(p.normal), {double(i) / columns, double(j) / rows});
    });
}

inline constexpr int max_teapot_segments = 64;  // a patch side: 262 thousand triangles

// `segments` of each side of each patch: 2 to max_teapot_segments.
inline pipeline::Result<Mesh> teapot(int segments) {
    if (segments < 2 || segments > max_teapot_segments) return segments_error(2, max_teapot_segments);
    Mesh mesh;
    for (const ControlNet& net :
         {revolve(teapot_body), revolve(teapot_lid), mirror(teapot_handle), mirror(teapot_spout)}) {
        const Mesh part = tessellate(net, segments);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (const std::uint32_t index : part.indices) mesh.indices.push_back(first + index);
    }
    return mesh;
}

}  // namespace relevo::scene
