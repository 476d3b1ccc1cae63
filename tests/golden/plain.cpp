#include "tests/golden/plain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "pipeline/clip_polygon.hpp"
#include "pipeline/transform.hpp"
#include "raster/depth.hpp"

namespace relevo::golden {
namespace {

using pipeline::Clip;
using pipeline::HPoint;
using pipeline::Scalar;
using pipeline::SnappedCorner;
using Clipping = Rules::Clipping;

template <class... Values>
std::string line(const char* format, Values... values) {
    char text[400];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

// --------------------------------------------------------------------------------------------------- window
double snapped(double subpixels, Rules::Snapping snapping) {
    switch (snapping) {
        case Rules::Snapping::Nearest:
            return std::rint(subpixels);
        case Rules::Snapping::Down:
            return std::floor(subpixels);
        case Rules::Snapping::HalfUp:
            return std::floor(subpixels + 0.5);
        case Rules::Snapping::Sixteenths:
            return 16 * std::rint(subpixels / 16);
        case Rules::Snapping::WholePixels:
            return 256 * std::floor(subpixels / 256);
    }
    return 0;
}

SnappedCorner to_window(const HPoint<Clip>& p, const Subject& s, Rules::Snapping snapping) {
    const double i = 1.0 / double(p.v.w);
    const double x = double(p.v.x) * i * (128.0 * s.width) + 128.0 * s.width;
    const double y = 128.0 * s.height - double(p.v.y) * i * (128.0 * s.height);
    return {int(snapped(x, snapping)), int(snapped(y, snapping)), p.v.z / p.v.w, 1 / p.v.w};
}

std::int64_t cross(const SnappedCorner& a, const SnappedCorner& b, const SnappedCorner& c) {
    return std::int64_t(b.x - a.x) * (c.y - a.y) - std::int64_t(b.y - a.y) * (c.x - a.x);
}

// The three clip positions of every triangle, in order.
template <class Visit>
void for_each_triangle(const Subject& s, Visit visit) {
    std::uint32_t primitive = 0, model_number = 0;
    for (const raster::Model& model : s.scene.models) {
        const auto eye_from_object = s.scene.camera.eye_from_world * model.world_from_object;
        const auto clip_from_object = pipeline::rounded(s.scene.camera.clip_from_eye * eye_from_object);
        for (std::size_t t = 0; t < model.mesh->indices.size(); t += 3, ++primitive) {
            const pipeline::Vertex* v[3];
            HPoint<Clip> p[3];
            for (std::size_t k = 0; k < 3; ++k) {
                v[k] = &model.mesh->vertices[model.mesh->indices[t + k]];
                p[k] = clip_from_object * v[k]->position;
            }
            visit(primitive, model_number, v, p, pipeline::is_mirrored(eye_from_object.m));
        }
        ++model_number;
    }
}

// --------------------------------------------------------------------------------------------------- pixels
// A pixel that lies on the edge from a to b belongs to the triangle (inside is where cross > 0).
bool owns(const SnappedCorner& a, const SnappedCorner& b, Rules::Fill fill) {
    const int dx = b.x - a.x, dy = b.y - a.y;
    switch (fill) {
        case Rules::Fill::TopLeft:
            return dy < 0 || (dy == 0 && dx > 0);
        case Rules::Fill::BottomRight:
            return !(dy < 0 || (dy == 0 && dx > 0));
        case Rules::Fill::Open:
            return false;
        case Rules::Fill::Closed:
            return true;
    }
    return false;
}

struct Ordered {  // corner 0 topmost, then leftmost; the others so that the area is positive
    SnappedCorner c[3];
    const pipeline::Vertex* v[3];
    std::int64_t area;
};
Ordered ordered(const PlainTriangle& t) {
    int first = 0;
    for (int k = 1; k < 3; ++k)
        if (std::pair(t.corner[k].y, t.corner[k].x) < std::pair(t.corner[first].y, t.corner[first].x))
            first = k;
    const int step = t.area2 > 0 ? 1 : 2;
    Ordered o{{}, {}, std::abs(t.area2)};
    for (int k = 0; k < 3; ++k)
        o.c[k] = t.corner[(first + k * step) % 3], o.v[k] = t.vertex[(first + k * step) % 3];
    return o;
}

bool wins(const Subject& s, const Rules& rules, Scalar z, const PlainPixel& there) {
    const bool reversed = s.settings.depth == raster::DepthFormat::Float32Reversed;
    const Scalar stored = there.drawn ? there.z : raster::cleared_depth(s.settings.depth);
    if (rules.depth == Rules::Depth::Ignored) return true;
    if (rules.depth == Rules::Depth::LaterWinsTies && z == stored && there.drawn) return true;
    return reversed ? z > stored : z < stored;
}

void visit_pixel(const Subject& s, const PlainTriangle& t, const Ordered& o, const SnappedCorner& centre,
                 const Rules& rules, PlainPixel& pixel) {
    std::int64_t e[3];
    for (int k = 0; k < 3; ++k) {
        const SnappedCorner &a = o.c[(k + 1) % 3], &b = o.c[(k + 2) % 3];
        e[k] = cross(a, b, centre);
        if (e[k] < 0 || (e[k] == 0 && !owns(a, b, rules.fill))) return;
    }
    pixel.last = t.primitive + 1, ++pixel.count;

    const double area = double(o.area);
    double q[3], z_slope[3];
    for (int k = 0; k < 3; ++k) {
        q[k] = double(e[k]) * (rules.weights == Rules::Weights::Affine ? 1.0 : double(o.c[k].rw));
        z_slope[k] = (double(o.c[k].z) - double(o.c[0].z)) * (1 / area);
    }
    const double sum = q[0] + (q[1] + q[2]), r = 1 / sum;
    double z_weight[3] = {double(e[0]), double(e[1]), double(e[2])};
    if (rules.weights == Rules::Weights::DepthCorrected)
        for (int k = 0; k < 3; ++k) z_weight[k] = q[k] * r * area;
    const auto z =
        static_cast<Scalar>(double(o.c[0].z) + (z_weight[1] * z_slope[1] + z_weight[2] * z_slope[2]));
    if (!wins(s, rules, z, pixel)) return;

    auto b1 = static_cast<Scalar>(q[1] * r), b2 = static_cast<Scalar>(q[2] * r);
    if (rules.weights == Rules::Weights::Permuted) std::swap(b1, b2);
    pixel.drawn = true, pixel.z = z, pixel.inv_w = static_cast<Scalar>(sum / area), pixel.model = t.model;
    pixel.b[0] = 1 - b1 - b2, pixel.b[1] = b1, pixel.b[2] = b2;
    const auto mixed = [&](Scalar a0, Scalar a1, Scalar a2) {
        return a0 + (b1 * (a1 - a0) + b2 * (a2 - a0));
    };
    pixel.uv[0] = mixed(o.v[0]->uv.x, o.v[1]->uv.x, o.v[2]->uv.x);
    pixel.uv[1] = mixed(o.v[0]->uv.y, o.v[1]->uv.y, o.v[2]->uv.y);
}

// ------------------------------------------------------------------------------------------------- clipping
template <class Real>
struct Corner {
    Real p[4];
    unsigned pinned = 0;
};

template <class Real>
struct Clipper {
    std::array<pipeline::ClipPlane, 6> planes;
    Clipping mistake;

    Real inside(std::size_t k, const Corner<Real>& c) const {
        return Real(planes[k].factor) * c.p[3] - Real(planes[k].sign) * c.p[planes[k].axis];
    }

    void pin(std::size_t k, Real (&p)[4]) const {
        p[planes[k].axis] = planes[k].factor == 0 ? Real(0) : Real(planes[k].sign * planes[k].factor) * p[3];
    }

    Corner<Real> crossing(std::size_t k, const Corner<Real>& a, const Corner<Real>& b) const {
        const bool swap = mistake != Clipping::FromFirstCorner && inside(k, a) < 0;
        const Corner<Real>&from = swap ? b : a, &to = swap ? a : b;
        const Real d0 = inside(k, from), d1 = inside(k, to);
        Corner<Real> made{{}, (a.pinned & b.pinned) | 1u << k};
        for (int i = 0; i < 4; ++i)
            made.p[i] = mistake == Clipping::FromFirstCorner
                            ? from.p[i] + d0 / (d0 - d1) * (to.p[i] - from.p[i])
                            : (d0 * to.p[i] - d1 * from.p[i]) / (d0 - d1);
        for (std::size_t j = 0; j < planes.size() && mistake != Clipping::NotPinned; ++j)
            if (made.pinned >> j & 1) pin(j, made.p);
        return made;
    }

    std::vector<Corner<Real>> cut(const std::vector<Corner<Real>>& polygon, std::size_t k) const {
        std::vector<Corner<Real>> out;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Corner<Real>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            if (inside(k, a) >= 0) out.push_back(a);
            if ((inside(k, a) >= 0) != (inside(k, b) >= 0)) out.push_back(crossing(k, a, b));
        }
        return out;
    }

    std::vector<HPoint<Clip>> run(const HPoint<Clip> (&p)[3], unsigned visit) const {
        std::vector<Corner<Real>> polygon;
        for (const auto& c : p) polygon.push_back({{Real(c.v.x), Real(c.v.y), Real(c.v.z), Real(c.v.w)}, 0});
        for (std::size_t k = 0; k < planes.size(); ++k)
            if (visit >> k & 1) polygon = cut(polygon, k);
        std::vector<HPoint<Clip>> out;
        for (Corner<Real>& c : polygon) {
            Scalar rounded[4];
            for (int i = 0; i < 4; ++i) rounded[i] = static_cast<Scalar>(c.p[i]);
            for (std::size_t k = 0; k < planes.size() && mistake != Clipping::NotPinned; ++k)
                if (c.pinned >> k & 1)
                    rounded[planes[k].axis] =
                        planes[k].factor == 0
                            ? Scalar(0)
                            : static_cast<Scalar>(planes[k].sign * planes[k].factor) * rounded[3];
            out.push_back({{rounded[0], rounded[1], rounded[2], rounded[3]}});
        }
        return out;
    }
};

}  // namespace

std::string clipped_line(std::uint32_t primitive, std::span<const HPoint<Clip>> polygon) {
    if (polygon.size() < 3) return line("triangle %u: nothing is left\n", primitive);
    std::string out = line("triangle %u: %zu corners are left\n", primitive, polygon.size());
    for (const auto& p : polygon)
        out +=
            line("    x %a  y %a  z %a  w %a\n", double(p.v.x), double(p.v.y), double(p.v.z), double(p.v.w));
    return out;
}

std::string window_line(std::uint32_t primitive, const SnappedCorner (&corners)[3], std::int64_t area2,
                        pipeline::Facing facing, bool culled) {
    std::string out = line("triangle %u: area %lld, %s face%s\n", primitive, static_cast<long long>(area2),
                           facing == pipeline::Facing::Front ? "front" : "back", culled ? ", culled" : "");
    for (const auto& c : corners)
        out += line("    x %d/256  y %d/256  z %a  1/w %a\n", c.x, c.y, double(c.z), double(c.rw));
    return out;
}

std::vector<PlainTriangle> plain_triangles(const Subject& s, const Rules& rules) {
    std::vector<PlainTriangle> out;
    for_each_triangle(s, [&](std::uint32_t primitive, std::uint32_t model,
                             const pipeline::Vertex* const(&v)[3], const HPoint<Clip>(&p)[3], bool mirrored) {
        for (const auto& c : p)
            if (pipeline::clip_codes(c) != 0) return;
        PlainTriangle t{primitive, model, {v[0], v[1], v[2]}, {}, 0, {}, false};
        for (int k = 0; k < 3; ++k) t.corner[k] = to_window(p[k], s, rules.snapping);
        t.area2 = cross(t.corner[0], t.corner[1], t.corner[2]);
        if (t.area2 == 0) return;
        const bool front = (t.area2 < 0) != mirrored;
        t.facing = front ? pipeline::Facing::Front : pipeline::Facing::Back;
        t.culled = (s.settings.cull == pipeline::Cull::Back && !front) ||
                   (s.settings.cull == pipeline::Cull::Front && front);
        out.push_back(t);
    });
    return out;
}

raster::Image<PlainPixel> plain_pixels(const Subject& s, const Rules& rules) {
    raster::Image<PlainPixel> pixels(s.width, s.height);
    for (const PlainTriangle& t : plain_triangles(s, rules)) {
        if (t.culled) continue;
        const Ordered o = ordered(t);
        for (int y = 0; y < s.height; ++y)
            for (int x = 0; x < s.width; ++x)
                visit_pixel(s, t, o, {256 * x + rules.sample, 256 * y + rules.sample, 0, 0}, rules,
                            pixels.at(x, y));
    }
    return pixels;
}

std::string plain_clipped(const Subject& s, const Rules& rules) {
    std::string out;
    const int side = rules.clipping == Clipping::NoGuardBand ? 1 : pipeline::guard_band;
    const auto planes = pipeline::clip_planes(side);
    for_each_triangle(s, [&](std::uint32_t primitive, std::uint32_t, const pipeline::Vertex* const(&)[3],
                             const HPoint<Clip>(&p)[3], bool) {
        unsigned any = 0, all = ~0u;
        for (const auto& c : p) {
            const unsigned code = pipeline::clip_codes(c, static_cast<Scalar>(side));
            any |= code, all &= code;
        }
        if (any == 0) return;
        if (rules.clipping == Clipping::NoNear) any &= ~unsigned(pipeline::code_z_high);
        if (rules.clipping == Clipping::NoFar) any &= ~unsigned(pipeline::code_z_low);
        std::vector<HPoint<Clip>> polygon;
        if (all == 0 && rules.clipping == Clipping::InFloat)
            polygon = Clipper<float>{planes, rules.clipping}.run(p, any);
        else if (all == 0)
            polygon = Clipper<double>{planes, rules.clipping}.run(p, any);
        out += clipped_line(primitive, polygon);
    });
    return out;
}

}  // namespace relevo::golden
