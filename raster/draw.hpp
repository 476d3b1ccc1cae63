// The machine: the whole pipeline, every stage called in its order. Read it as a table of contents.
//
//   transform the vertices | assemble triangles | clip | divide, to the window, snap | cull |
//   scan | interpolate depth | depth test | correct the perspective, interpolate | shade | write
#pragma once
#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/clip_polygon.hpp"
#include "pipeline/cull.hpp"
#include "pipeline/light.hpp"
#include "pipeline/probe.hpp"
#include "pipeline/transform.hpp"
#include "pipeline/viewport.hpp"
#include "raster/events.hpp"
#include "raster/interpolate.hpp"
#include "raster/scene.hpp"
#include "raster/shading.hpp"
#include "raster/triangle_edge.hpp"

namespace relevo::raster {

using pipeline::Clip;
using pipeline::ClipCodes;
using pipeline::Eye;
using pipeline::HPoint;
using pipeline::NoProbe;
using pipeline::note;

template <class Probe>
concept DrawProbe = pipeline::ProbeOf<Probe, VertexTransformed, TriangleRejected, TriangleClipped,
                                      TriangleSnapped, FragmentCovered, DepthTested, FragmentShaded>;

// One model on its way through the machine, with one shading program.
template <class Program, class Probe>
class ModelPass {
  public:
    ModelPass(const Scene& scene, std::uint32_t model_number, std::span<const pipeline::EyeLight> lights,
              const Settings& settings, Frame& frame, std::uint32_t first_primitive, Probe& probe)
        : model_(scene.models[model_number]),
          mesh_(*model_.mesh),
          model_number_(model_number),
          primitive_(first_primitive),
          settings_(settings),
          viewport_{frame.depth.width(), frame.depth.height()},
          frame_(frame),
          probe_(probe),
          surface_{{lights, model_.material.ambient, model_.material.diffuse, model_.material.specular,
                    pipeline::exponent(model_.material.shininess), scene.camera.parallel},
                   model_.material.color,
                   model_.texture,
                   settings.texture_filter,
                   model_.two_sided},
          both_sides_(model_.two_sided && settings.cull != pipeline::Cull::Back) {
        const auto eye_from_object = scene.camera.eye_from_world * model_.world_from_object;
        eye_from_object_ = pipeline::rounded(eye_from_object);
        clip_from_object_ = pipeline::rounded(scene.camera.clip_from_eye * eye_from_object);
        normal_map_ = pipeline::normal_map(eye_from_object);
        mirrored_ = pipeline::is_mirrored(eye_from_object.m);
    }

    void run() {
        transform_vertices();
        for (std::size_t t = 0; t < mesh_.triangles(); ++t, ++primitive_)
            draw_triangle(&mesh_.indices[3 * t]);
    }

  private:
    static constexpr std::size_t size = Program::size;
    using Varying = std::array<Scalar, size>;
    struct Corner {
        SnappedCorner window;
        const Varying*
            varying[2];  // what it carries to a front face and, when both sides are lit, to a back face
    };

    // ------------------------------------------------------------------------------------------- vertices
    Varying varying_of(const pipeline::Vertex& v, bool back) const {
        ShadedVertex shaded{{0, 0, 0}, {0, 0, 0}, v.uv};
        if constexpr (Program::needs_eye) {
            shaded.position = (eye_from_object_ * v.position).v;
            shaded.normal = pipeline::normalize((normal_map_ * v.normal).v);
            if (back) shaded.normal = -shaded.normal;
        }
        return Program::corner(surface_, shaded);
    }

    void transform_vertices() {
        const std::size_t count = mesh_.vertices.size();
        codes_.resize(count);
        window_.resize(count);
        for (int side = 0; side < 2; ++side)
            varying_[side].resize(size == 0 || (side == 1 && !both_sides_) ? 0 : count);
        for (std::size_t i = 0; i < count; ++i) {
            const pipeline::Vertex& v = mesh_.vertices[i];
            const HPoint<Clip> clip = clip_from_object_ * v.position;
            codes_[i] = pipeline::clip_codes(clip);
            if (codes_[i] == 0) window_[i] = pipeline::to_window(clip, viewport_);
            for (int side = 0; side < 2; ++side)
                if (!varying_[side].empty()) varying_[side][i] = varying_of(v, side == 1);
            note<VertexTransformed>(probe_, model_number_, static_cast<std::uint32_t>(i), v.position,
                                    eye_from_object_ * v.position, clip, codes_[i]);
        }
    }

    // ------------------------------------------------------------------------------------------- triangles
    void reject(Rejection reason) { note<TriangleRejected>(probe_, primitive_, model_number_, reason); }

    Corner corner(std::uint32_t i) const {
        return {window_[i],
                {varying_[0].data() + (size ? i : 0), varying_[1].data() + (both_sides_ && size ? i : 0)}};
    }

    void draw_triangle(const std::uint32_t* i) {
        const ClipCodes any = codes_[i[0]] | codes_[i[1]] | codes_[i[2]];
        if (any == 0) return draw_in_window(i, corner(i[0]), corner(i[1]), corner(i[2]));
        const ClipCodes all = codes_[i[0]] & codes_[i[1]] & codes_[i[2]];
        if (any & pipeline::code_non_finite) return reject(Rejection::NonFinite);
        if (any & pipeline::code_origin) return reject(Rejection::ZeroArea);
        if (all != 0) return reject(Rejection::Outside);
        clip_and_draw(i, any);
    }

    // ------------------------------------------------------------------------------------------- clipping
    pipeline::ClipPolygon<2 * size> polygon_of(const std::uint32_t* i) const {
        pipeline::ClipPolygon<2 * size> polygon;
        for (int k = 0; k < 3; ++k) {
            const HPoint<Clip> p = clip_from_object_ * mesh_.vertices[i[k]].position;
            pipeline::ClipCorner<2 * size> c{glm::dvec4(p.v), {}, 0};
            for (int side = 0; side < 2; ++side)
                if (!varying_[side].empty())
                    std::copy_n(varying_[side][i[k]].begin(), size,
                                c.varying.begin() + std::ptrdiff_t(size) * side);
            polygon.push(c);
        }
        return polygon;
    }

    void clip_and_draw(const std::uint32_t* i, ClipCodes crossed) {
        const auto polygon = pipeline::clip_polygon(polygon_of(i), pipeline::guard_planes, crossed, probe_);
        if (polygon.size < 3) return reject(Rejection::Outside);
        constexpr std::size_t room = pipeline::ClipPolygon<2 * size>::capacity;
        const std::size_t n = static_cast<std::size_t>(polygon.size);
        std::array<HPoint<Clip>, room> clip;
        std::array<Corner, room> corners;
        std::array<Varying, 2 * room> carried;
        for (std::size_t k = 0; k < n; ++k) {
            clip[k] = pipeline::rounded_position(polygon.corners[k], pipeline::guard_planes);
            if (!(clip[k].v.w > 0) || !std::isfinite(1 / clip[k].v.w)) return reject(Rejection::NonFinite);
            for (std::size_t j = 0; j < 2 * size; ++j)
                carried[2 * k + j / std::max<std::size_t>(size, 1)][j % std::max<std::size_t>(size, 1)] =
                    static_cast<Scalar>(polygon.corners[k].varying[j]);
            corners[k] = {pipeline::to_window(clip[k], viewport_), {&carried[2 * k], &carried[2 * k + 1]}};
        }
        note<TriangleClipped>(probe_, primitive_, model_number_, crossed, std::span(clip.data(), n));
        draw_fan(i, std::span<const Corner>(corners.data(), n));
    }

    // The polygon as triangles round its topmost corner: the same ones whichever corner of the mesh's
    // triangle is first.
    void draw_fan(const std::uint32_t* i, std::span<const Corner> polygon) {
        const auto above = [](const Corner& a, const Corner& b) {
            const SnappedCorner &p = a.window, &q = b.window;
            return p.y != q.y ? p.y < q.y : p.x != q.x ? p.x < q.x : p.z != q.z ? p.z < q.z : p.rw < q.rw;
        };
        const std::size_t n = polygon.size();
        const std::size_t top =
            std::size_t(std::min_element(polygon.begin(), polygon.end(), above) - polygon.begin());
        for (std::size_t k = 1; k + 1 < n; ++k)
            draw_in_window(i, polygon[top], polygon[(top + k) % n], polygon[(top + k + 1) % n]);
    }

    // ------------------------------------------------------------------------------------------- window
    void draw_in_window(const std::uint32_t* i, const Corner& a, const Corner& b, const Corner& c) {
        const std::int64_t area = area2(a.window, b.window, c.window);
        if (area == 0) return reject(Rejection::ZeroArea);
        const Facing facing = pipeline::facing(area, mirrored_);
        const bool culled = pipeline::is_culled(facing, settings_.cull);
        const SnappedCorner window[3] = {a.window, b.window, c.window};
        note<TriangleSnapped>(probe_, primitive_, model_number_, window, area, facing, culled);
        if (culled) return reject(Rejection::Culled);
        const PixelBox box = pixel_box(window, viewport_.width, viewport_.height);
        if (box.empty()) return reject(Rejection::NoPixel);
        const CornerOrder order = canonical_order(a.window, b.window, c.window, area > 0);
        const Corner* const corner[3] = {&a, &b, &c};
        const auto &c0 = *corner[order.index[0]], &c1 = *corner[order.index[1]],
                   &c2 = *corner[order.index[2]];
        const int side = facing == Facing::Back && both_sides_;
        VaryingPlane<size> plane{};
        if constexpr (size > 0) plane = make_plane(*c0.varying[side], *c1.varying[side], *c2.varying[side]);
        typename Program::Face face{};
        if constexpr (Program::needs_face) face = face_of(i, facing);
        draw_spans(make_triangle(c0.window, c1.window, c2.window), box, plane, face);
    }

    Reflection face_of(const std::uint32_t* i, Facing facing) const {
        const auto eye = [&](int k) { return (eye_from_object_ * mesh_.vertices[i[k]].position).v; };
        return reflect_face(surface_, {eye(0), eye(1), eye(2)}, facing, mirrored_);
    }

    // ------------------------------------------------------------------------------------------- pixels
    // Flattened: the whole of a pixel is one piece of code, its colours stay in registers (3x on a large
    // triangle).
    [[gnu::flatten]] void draw_spans(const Triangle& t, const PixelBox& box, const VaryingPlane<size>& plane,
                                     const typename Program::Face& face) {
        const Interpolator interpolator = make_interpolator(t);
        const std::int64_t step1 = 256 * t.dy2, step2 = -256 * t.dy1;
        for_each_span(t, box, [&](int y, Span span, EdgeValues e) {
            Scalar* const depth_row = frame_.depth.row(y);
            for (int x = span.x0; x < span.x1; ++x, e.e1 += step1, e.e2 += step2, e.e0 -= step1 + step2) {
                note<FragmentCovered>(probe_, primitive_, x, y);

                const Scalar z = depth(interpolator, e);
                const bool passed = nearer(settings_.depth, z, depth_row[x]);
                note<DepthTested>(probe_, primitive_, x, y, z, depth_row[x], passed);
                if (!passed) continue;
                depth_row[x] = z;
                shade(x, y, z, t, interpolator, e, plane, face);
            }
        });
    }

    void shade(int x, int y, Scalar z, const Triangle& t, const Interpolator& interpolator,
               const EdgeValues& e, const VaryingPlane<size>& plane, const typename Program::Face& face) {
        const PerspectiveWeights b = perspective_weights(interpolator, e);
        const Varying varying = interpolate(plane, b);
        const LinearRgb color = Program::pixel(surface_, face, varying.data());
        frame_.color.row(y)[x] = to_rgba8(color, settings_.output);
        if (!frame_.linear.empty()) frame_.linear.row(y)[x] = color;
        note<FragmentShaded>(probe_, primitive_, x, y, z,
                             static_cast<Scalar>(b.s / static_cast<double>(t.area)), 1 - b.b1 - b.b2, b.b1,
                             b.b2, std::span<const Scalar>(varying), color);
    }

    const Model& model_;
    const pipeline::Mesh& mesh_;
    std::uint32_t model_number_, primitive_;
    const Settings& settings_;
    pipeline::Viewport viewport_;
    Frame& frame_;
    Probe& probe_;
    Surface surface_;
    bool both_sides_;  // back faces are drawn and lit by their own normals
    bool mirrored_ = false;
    pipeline::RoundedAffine<Eye, pipeline::Object> eye_from_object_;
    pipeline::RoundedProjective<Clip, pipeline::Object> clip_from_object_;
    pipeline::NormalMap<Eye, pipeline::Object> normal_map_;
    std::vector<ClipCodes> codes_;
    std::vector<SnappedCorner> window_;  // of the vertices without a clip code
    std::vector<Varying> varying_[2];    // towards the front, towards the back
};

inline void clear(const Scene& scene, const Settings& settings, Frame& frame) {
    const Rgba8 background = to_rgba8(scene.background, settings.output);
    std::fill(frame.color.pixels().begin(), frame.color.pixels().end(), background);
    std::fill(frame.depth.pixels().begin(), frame.depth.pixels().end(), cleared_depth(settings.depth));
    std::fill(frame.linear.pixels().begin(), frame.linear.pixels().end(), scene.background);
}

// Draws the scene into `frame`, whose color and depth have the same size, 1..max_picture_size a side;
// frame.linear is empty or has that size too. Anything finite may stand in the meshes; what is not finite is
// dropped and noted. Texture pointers may be null (then the model's colour is used). The same scene gives the
// same bytes, whatever the compiler, the target and the probe.
template <DrawProbe Probe = const NoProbe>
void draw(const Scene& scene, const Settings& settings, Frame& frame, Probe&& probe = {}) {
    assert(frame.color.width() == frame.depth.width() && frame.color.height() == frame.depth.height());
    assert(0 < frame.depth.width() && frame.depth.width() <= pipeline::max_picture_size);
    assert(0 < frame.depth.height() && frame.depth.height() <= pipeline::max_picture_size);
    clear(scene, settings, frame);
    std::vector<pipeline::EyeLight> lights;
    const auto eye_from_world = pipeline::rounded(scene.camera.eye_from_world);
    for (const pipeline::Light& light : scene.lights)
        lights.push_back(pipeline::to_eye(light, eye_from_world));

    std::uint32_t first_primitive = 0;
    for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
        const auto pass = [&]<class Program>(Program) {
            ModelPass<Program, std::remove_reference_t<Probe>>(scene, m, lights, settings, frame,
                                                               first_primitive, probe)
                .run();
        };
        const bool textured = scene.models[m].texture != nullptr;
        switch (settings.shading) {
            case Shading::Unlit:
                textured ? pass(Unlit<true>{}) : pass(Unlit<false>{});
                break;
            case Shading::Flat:
                textured ? pass(Flat<true>{}) : pass(Flat<false>{});
                break;
            case Shading::Gouraud:
                textured ? pass(Gouraud<true>{}) : pass(Gouraud<false>{});
                break;
            case Shading::Phong:
                textured ? pass(Phong<true>{}) : pass(Phong<false>{});
                break;
        }
        first_primitive += static_cast<std::uint32_t>(scene.models[m].mesh->triangles());
    }
}

// The unwatched machine is compiled once, in draw.cpp.
extern template void draw<const NoProbe>(const Scene&, const Settings&, Frame&, const NoProbe&&);

}  // namespace relevo::raster
