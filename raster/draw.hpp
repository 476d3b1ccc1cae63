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

#include "pipeline/cull.hpp"
#include "pipeline/probe.hpp"
#include "pipeline/viewport.hpp"
#include "raster/clip_triangle.hpp"
#include "raster/events.hpp"
#include "raster/interpolate.hpp"
#include "raster/model_setup.hpp"
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
        : mesh_(*scene.models[model_number].mesh),
          model_number_(model_number),
          primitive_(first_primitive),
          settings_(settings),
          viewport_{frame.depth.width(), frame.depth.height()},
          frame_(frame),
          probe_(probe),
          setup_(make_setup(scene.camera, scene.models[model_number], lights, settings)) {}

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
    void transform_vertices() {
        const std::size_t count = mesh_.vertices.size();
        codes_.resize(count);
        window_.resize(count);
        for (int side = 0; side < 2; ++side)
            varying_[side].resize(size == 0 || (side == 1 && !setup_.both_sides) ? 0 : count);
        for (std::size_t i = 0; i < count; ++i) {
            const pipeline::Vertex& v = mesh_.vertices[i];
            const HPoint<Clip> clip = setup_.clip_from_object * v.position;
            codes_[i] = pipeline::clip_codes(clip);
            if (codes_[i] == 0) window_[i] = pipeline::to_window(clip, viewport_);
            for (int side = 0; side < 2; ++side)
                if (!varying_[side].empty()) varying_[side][i] = varying_of<Program>(setup_, v, side == 1);
            note<VertexTransformed>(probe_, model_number_, static_cast<std::uint32_t>(i), v.position,
                                    setup_.eye_from_object * v.position, clip, codes_[i]);
        }
    }

    // ------------------------------------------------------------------------------------------- triangles
    void reject(Rejection reason) { note<TriangleRejected>(probe_, primitive_, model_number_, reason); }

    Corner corner(std::uint32_t i) const {
        return {
            window_[i],
            {varying_[0].data() + (size ? i : 0), varying_[1].data() + (setup_.both_sides && size ? i : 0)}};
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
            const HPoint<Clip> p = setup_.clip_from_object * mesh_.vertices[i[k]].position;
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
        const auto polygon = clip_triangle(polygon_of(i), crossed, viewport_, probe_);
        if (polygon.result == Clipped::Outside) return reject(Rejection::Outside);
        if (polygon.result == Clipped::NonFinite) return reject(Rejection::NonFinite);
        note<TriangleClipped>(probe_, primitive_, model_number_, crossed,
                              std::span(polygon.clip.data(), polygon.size));
        std::array<Varying, 2 * polygon.capacity> carried;
        for (std::size_t k = 0; k < polygon.size; ++k)
            for (std::size_t j = 0; j < size; ++j)
                for (std::size_t side = 0; side < 2; ++side)
                    carried[2 * k + side][j] = polygon.varying[k][side * size + j];
        const auto made = [&](std::size_t k) {
            return Corner{polygon.window[k], {&carried[2 * k], &carried[2 * k + 1]}};
        };
        for_each_fan_triangle(polygon, [&](std::size_t a, std::size_t b, std::size_t c) {
            draw_in_window(i, made(a), made(b), made(c));
        });
    }

    // ------------------------------------------------------------------------------------------- window
    void draw_in_window(const std::uint32_t* i, const Corner& a, const Corner& b, const Corner& c) {
        const std::int64_t area = area2(a.window, b.window, c.window);
        if (area == 0) return reject(Rejection::ZeroArea);
        const Facing facing = pipeline::facing(area, setup_.mirrored);
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
        const int side = facing == Facing::Back && setup_.both_sides;
        VaryingPlane<size> plane{};
        if constexpr (size > 0) plane = make_plane(*c0.varying[side], *c1.varying[side], *c2.varying[side]);
        typename Program::Face face{};
        if constexpr (Program::needs_face) face = face_of(i, facing);
        draw_spans(make_triangle(c0.window, c1.window, c2.window), box, plane, face);
    }

    Reflection face_of(const std::uint32_t* i, Facing facing) const {
        const auto eye = [&](int k) { return (setup_.eye_from_object * mesh_.vertices[i[k]].position).v; };
        return reflect_face(setup_.surface, {eye(0), eye(1), eye(2)}, facing, setup_.mirrored);
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
        const LinearRgb color = Program::pixel(setup_.surface, face, varying.data());
        frame_.color.row(y)[x] = to_rgba8(color, settings_.output);
        if (!frame_.linear.empty()) frame_.linear.row(y)[x] = color;
        note<FragmentShaded>(probe_, primitive_, x, y, z,
                             static_cast<Scalar>(b.s / static_cast<double>(t.area)), 1 - b.b1 - b.b2, b.b1,
                             b.b2, std::span<const Scalar>(varying), color);
    }

    const pipeline::Mesh& mesh_;
    std::uint32_t model_number_, primitive_;
    const Settings& settings_;
    pipeline::Viewport viewport_;
    Frame& frame_;
    Probe& probe_;
    ModelSetup setup_;
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
    const std::vector<pipeline::EyeLight> lights = lights_in_eye_space(scene);

    std::uint32_t first_primitive = 0;
    for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
        with_program(settings.shading, scene.models[m].texture != nullptr, [&]<class Program>(Program) {
            ModelPass<Program, std::remove_reference_t<Probe>>(scene, m, lights, settings, frame,
                                                               first_primitive, probe)
                .run();
        });
        first_primitive += static_cast<std::uint32_t>(scene.models[m].mesh->triangles());
    }
}

// The unwatched machine is compiled once, in draw.cpp.
extern template void draw<const NoProbe>(const Scene&, const Settings&, Frame&, const NoProbe&&);

}  // namespace relevo::raster
