#include "relief/draw_relief.hpp"

#include "raster/clip_triangle.hpp"
#include "raster/interpolate.hpp"
#include "relief/scene_light.hpp"

namespace relevo::relief {
namespace {

using pipeline::Clip;
using pipeline::HPoint;
using raster::SnappedCorner;

class ReliefPass {
  public:
    ReliefPass(const ReliefModel& model, const raster::Scene& scene, const raster::Settings& settings,
               raster::Frame& frame)
        : model_(model),
          picture_(*model.picture),
          settings_(settings),
          frame_(frame),
          viewport_{frame.depth.width(), frame.depth.height()},
          light_(scene, model.material),
          clip_from_eye_(scene.camera.clip_from_eye),
          clip_from_world_(pipeline::rounded(scene.camera.clip_from_eye * scene.camera.eye_from_world)),
          forward_(forward(model.source)) {
        const glm::dvec4& t = model.viewer.place;
        height_ = glm::dot(t.w * model.source.corner - glm::dvec3(t), forward_);
    }

    void run() {
        const double u0 = picture_.window.x0, v0 = picture_.window.y0, u1 = u0 + picture_.window.width,
                     v1 = v0 + picture_.window.height;
        draw_triangle({{{u0, v0}, {u0, v1}, {u1, v1}}});
        draw_triangle({{{u0, v0}, {u1, v1}, {u1, v0}}});
    }

  private:
    // Corners are places on the source's plane, in texels; they are what is interpolated, too.
    void draw_triangle(const std::array<glm::dvec2, 3>& corners) {
        pipeline::ClipPolygon<2> polygon;
        pipeline::ClipCodes any = 0;
        for (const glm::dvec2& uv : corners) {
            const glm::dvec3 p = plane_point(model_.source, uv.x, uv.y);
            HPoint<Clip> clip = clip_from_world_ * pipeline::Point<pipeline::World>{Vec3(p)};
            // The plane may lie before the near plane or behind the far one: what it shows is what counts.
            clip.v.z = clip.v.w / 2;
            any |= pipeline::clip_codes(clip);
            polygon.push({glm::dvec4(clip.v), {uv.x, uv.y}, 0});
        }
        if (any & (pipeline::code_non_finite | pipeline::code_origin)) return;
        const auto visible = raster::clip_triangle(polygon, any, viewport_);
        if (visible.result != raster::Clipped::Visible) return;
        raster::for_each_fan_triangle(visible, [&](std::size_t a, std::size_t b, std::size_t c) {
            draw_in_window({visible.window[a], visible.window[b], visible.window[c]},
                           {visible.varying[a], visible.varying[b], visible.varying[c]});
        });
    }

    void draw_in_window(const std::array<SnappedCorner, 3>& at,
                        const std::array<std::array<Scalar, 2>, 3>& uv) {
        const std::int64_t area = raster::area2(at[0], at[1], at[2]);
        if (area == 0) return;
        const SnappedCorner corners[3] = {at[0], at[1], at[2]};
        const raster::PixelBox box = raster::pixel_box(corners, viewport_.width, viewport_.height);
        if (box.empty()) return;
        const raster::CornerOrder order = raster::canonical_order(at[0], at[1], at[2], area > 0);
        const auto i = [&](int k) { return static_cast<std::size_t>(order.index[k]); };
        const raster::Triangle triangle = raster::make_triangle(at[i(0)], at[i(1)], at[i(2)]);
        const auto plane = raster::make_plane(uv[i(0)], uv[i(1)], uv[i(2)]);
        const raster::Interpolator interpolator = raster::make_interpolator(triangle);
        raster::for_each_span(triangle, box, [&](int y, raster::Span span, raster::EdgeValues) {
            for (int x = span.x0; x < span.x1; ++x) {
                const auto weights =
                    raster::perspective_weights(interpolator, raster::edge_values(triangle, x, y));
                const auto place = raster::interpolate(plane, weights);
                draw_pixel(x, y, double{place[0]}, double{place[1]});
            }
        });
    }

    void draw_pixel(int x, int y, double u, double v) {
        const Window& window = picture_.window;
        const auto shares = texel_shares(
            window.width, window.height, u - window.x0, v - window.y0, model_.reading,
            double{model_.jump_depth}, [&](int i, int j) { return picture_.coverage.at(i, j) != 0; },
            [&](int i, int j) { return double{picture_.depth.at(i, j)}; });
        if (!shares) return;
        const glm::dvec3 eye = eye_point(u, v, weighted_sum(*shares, 0.0, [&](int i, int j, double share) {
                                             return share * double{picture_.depth.at(i, j)};
                                         }));
        const glm::dvec4 clip = clip_from_eye_.m * glm::dvec4(eye, 1);
        const Scalar z = static_cast<Scalar>(clip.z / clip.w);
        Scalar& stored = frame_.depth.at(x, y);
        if (!(clip.w > 0 && clip.z >= 0 && clip.z <= clip.w) || !raster::nearer(settings_.depth, z, stored))
            return;
        stored = z;
        const LinearRgb color = shaded(*shares, Vec3(eye));
        frame_.color.at(x, y) = raster::to_rgba8(color, settings_.output);
        if (!frame_.linear.empty()) frame_.linear.at(x, y) = color;
    }

    // What the pixel that looks at (u, v) really shows, in eye space.
    glm::dvec3 eye_point(double u, double v, double depth) const {
        const glm::dvec4& t = model_.viewer.place;
        const glm::dvec3 on_plane = plane_point(model_.source, u, v);
        const glm::dvec3 world = on_plane + (depth / height_) * (t.w * on_plane - glm::dvec3(t));
        return light_.to_eye(world);
    }

    LinearRgb shaded(const TexelShares& shares, const Vec3& eye) const {
        const LinearRgb base = weighted_sum(shares, LinearRgb{}, [&](int i, int j, double share) {
            return static_cast<Scalar>(share) * picture_.color.at(i, j);
        });
        if (settings_.shading == raster::Shading::Unlit) return base;
        const Vec3 normal = weighted_sum(shares, Vec3(0), [&](int i, int j, double share) {
            return static_cast<Scalar>(share) * picture_.normal.at(i, j);
        });
        return light_.lit(base, eye, normal);
    }

    const ReliefModel& model_;
    const Prewarped& picture_;
    const raster::Settings& settings_;
    raster::Frame& frame_;
    pipeline::Viewport viewport_;
    SceneLight light_;
    pipeline::Projective<Clip, pipeline::Eye> clip_from_eye_;
    pipeline::RoundedProjective<Clip, pipeline::World> clip_from_world_;
    glm::dvec3 forward_;
    double height_;  // of the viewer over the plane, times the weight of its place
};

}  // namespace

void draw_relief(const ReliefModel& model, const raster::Scene& scene, const raster::Settings& settings,
                 raster::Frame& frame) {
    ReliefPass(model, scene, settings, frame).run();
}

}  // namespace relevo::relief
