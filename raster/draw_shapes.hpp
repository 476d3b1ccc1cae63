// The machine of the two-dimensional lessons: every algorithm called in its place. Read it as a table of
// contents.
//
//   for each shape:   lines and curves of whole pixels | smooth lines | smooth curves | areas
//                     clip | scan | smooth | composite
//
// Clipping by the window, sides included:
//   pixels (thin lines, curves, Wu, Gupta-Sproull)  those of the uncut shape whose centre lies in the window
//   areas, and smooth lines, which are areas, too   the outline is cut, then drawn
// The clippers of segments do not change a pixel of this: a cut line must light the pixels of the uncut one,
// so the line algorithms take the window itself. They have their lessons (samples/show).
#pragma once
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "pipeline/clip_shape_greiner_hormann.hpp"
#include "pipeline/clip_shape_pipeline.hpp"
#include "pipeline/clip_shape_sutherland_hodgman.hpp"
#include "pipeline/probe.hpp"
#include "pipeline/split_bridges.hpp"
#include "raster/area_coverage.hpp"
#include "raster/circle_midpoint.hpp"
#include "raster/circle_second_order.hpp"
#include "raster/composite.hpp"
#include "raster/curve_coverage.hpp"
#include "raster/disc.hpp"
#include "raster/ellipse_midpoint.hpp"
#include "raster/ellipse_second_order.hpp"
#include "raster/ellipse_textbook.hpp"
#include "raster/image.hpp"
#include "raster/line_dda.hpp"
#include "raster/line_explicit.hpp"
#include "raster/line_gupta_sproull.hpp"
#include "raster/line_midpoint.hpp"
#include "raster/line_outline.hpp"
#include "raster/line_weight.hpp"
#include "raster/line_wu.hpp"
#include "raster/multisample.hpp"
#include "raster/polygon_active_edges.hpp"
#include "raster/rectangle.hpp"
#include "raster/shape.hpp"
#include "raster/shape_events.hpp"
#include "raster/supersample.hpp"
#include "raster/triangle_edge.hpp"
#include "raster/triangle_scan.hpp"
#include "raster/weighted_coverage.hpp"

namespace relevo::raster {

using pipeline::NoProbe;
using pipeline::note;

using Ring = std::vector<glm::dvec2>;
using SnappedRing = std::vector<SnappedPoint>;

// The pixels whose centre lies in a polygon or on its border: 1, else 0. Non-zero rule; corners to 1/256
// pixel. None when a corner is not finite or beyond largest_place, or when there is no area.
Image<std::uint8_t> window_mask(std::span<const glm::vec2> polygon, int width, int height);

template <class Probe>
class ShapePass {
  public:
    ShapePass(const ShapeScene& scene, Image<LinearRgb>& picture, Probe& probe)
        : scene_(scene),
          picture_(picture),
          probe_(probe),
          box_{0, 0, picture.width() - 1, picture.height() - 1},
          pixel_box_(box_) {
        if (!scene.clip.on) return;
        window_ = sides_of(scene.clip);
        if (scene.clip.polygon.empty())
            pixel_box_ = pixels_of_window();
        else
            mask_ = window_mask(scene.clip.polygon, picture.width(), picture.height());
    }

    void run() {
        std::fill(picture_.pixels().begin(), picture_.pixels().end(), scene_.background);
        for (number_ = 0; number_ < scene_.shapes.size(); ++number_) {
            const Shape& shape = scene_.shapes[number_];
            if (!shared_.empty() && (!shares_samples(shape) || shape.samples != samples_)) resolve();
            if (!is_drawable(shape)) {
                note<ShapeRefused>(probe_, number_);
                continue;
            }
            note<ShapeStarted>(probe_, number_);
            shares_samples(shape) ? share(shape) : draw(shape);
        }
        resolve();
    }

  private:
    // ---------------------------------------------------------------- what is drawn how
    void draw(const Shape& shape) {
        if (is_curve(shape))
            curve(shape);
        else if (is_line(shape) && lights_pixels(shape))
            pixel_lines(shape);
        else if (shape.antialiasing == Antialiasing::None)
            area(shape);
        else
            smooth_area(shape);
    }

    // ------------------------------------------------------------------------ thin lines
    // A corner of a polyline belongs to two lines, and is painted once. Lines that smooth themselves end in
    // the middle of its pixel, so their coverages add up; of others the larger counts.
    void pixel_lines(const Shape& shape) {
        if (shape.kind == ShapeKind::Line)
            return pixel_line(shape, shape.points[0], shape.points[1], pixel_painter(shape));
        const bool whole =
            shape.algorithm != ScanAlgorithm::Wu && shape.algorithm != ScanAlgorithm::GuptaSproull;
        std::vector<CoveredPixel> pixels;
        std::size_t merge_at = 1 << 20;  // so that memory stays within the pixels of the picture
        for (std::size_t i = 0; i + 1 < shape.points.size(); ++i) {
            pixel_line(shape, shape.points[i], shape.points[i + 1], [&](int y, int x0, int x1, int coverage) {
                for (int x = x0; x < x1; ++x) pixels.push_back({y, x, coverage});
            });
            if (pixels.size() < merge_at) continue;
            merge(pixels, whole);
            merge_at = std::max(merge_at, 2 * pixels.size());
        }
        merge(pixels, whole);
        const auto paint_pixel = pixel_painter(shape);
        for (const CoveredPixel& p : pixels) paint_pixel(p.y, p.x, p.x + 1, p.coverage);
    }

    struct CoveredPixel {
        int y, x, coverage;
        friend auto operator<=>(const CoveredPixel&, const CoveredPixel&) = default;
    };
    // Each pixel once.
    static void merge(std::vector<CoveredPixel>& pixels, bool whole) {
        std::sort(pixels.begin(), pixels.end());
        std::size_t kept = 0;
        for (const CoveredPixel& p : pixels) {
            if (kept == 0 || pixels[kept - 1].y != p.y || pixels[kept - 1].x != p.x) {
                pixels[kept++] = p;
                continue;
            }
            int& coverage = pixels[kept - 1].coverage;
            coverage =
                whole ? std::max(coverage, p.coverage) : std::min(coverage + p.coverage, full_coverage);
        }
        pixels.resize(kept);
    }

    template <class Cover>
    void pixel_line(const Shape& shape, glm::dvec2 from, glm::dvec2 to, Cover&& cover) {
        const Pixel a = nearest_pixel(from), b = nearest_pixel(to);
        const int coverage = shape.even_weight ? line_weight(a, b) : full_coverage;
        const auto plot = [&](int x, int y) { cover(y, x, x + 1, coverage); };
        switch (shape.algorithm) {
            case ScanAlgorithm::Wu:
                return line_wu(from, to, pixel_box_, cover, probe_);
            case ScanAlgorithm::GuptaSproull:
                return line_gupta_sproull(from, to, shape.width, pixel_box_, cover, probe_);
            case ScanAlgorithm::Dda:
                return line_dda(a, b, pixel_box_, plot, probe_);
            case ScanAlgorithm::Explicit:
                return line_explicit(a, b, pixel_box_, plot, probe_);
            default:
                return line_midpoint(a, b, pixel_box_, plot, probe_);
        }
    }

    // --------------------------------------------------------------- circles and ellipses
    void curve(const Shape& shape) {
        if (shape.antialiasing == Antialiasing::None) return pixel_curve(shape);
        const glm::dvec2 center = shape.points[0];
        const double a = shape.radius_x, b = shape.radius_y;
        if (shape.filled)
            disc_coverage(center, a, b, pixel_box_, pixel_painter(shape), probe_);
        else
            ring_coverage(center, a, b, shape.width, pixel_box_, pixel_painter(shape), probe_);
    }

    void pixel_curve(const Shape& shape) {
        const Pixel center = nearest_pixel(shape.points[0]);
        const auto a = static_cast<int>(shape.radius_x + 0.5f), b = static_cast<int>(shape.radius_y + 0.5f);
        const auto span = [paint = pixel_painter(shape)](int y, int x0, int x1) {
            paint(y, x0, x1, full_coverage);
        };
        const auto plot = [&](int x, int y) { span(y, x, x + 1); };
        const bool circle = shape.kind == ShapeKind::Circle;
        if (shape.filled)
            disc(center, a, b, pixel_box_, span, probe_);
        else if (circle && shape.algorithm == ScanAlgorithm::SecondOrder)
            circle_second_order(center, a, pixel_box_, plot, probe_);
        else if (circle)
            circle_midpoint(center, a, pixel_box_, plot, probe_);
        else if (shape.algorithm == ScanAlgorithm::SecondOrder)
            ellipse_second_order(center, a, b, pixel_box_, plot, probe_);
        else if (shape.algorithm == ScanAlgorithm::Textbook)
            ellipse_textbook(center, a, b, pixel_box_, plot, probe_);
        else
            ellipse_midpoint(center, a, b, pixel_box_, plot, probe_);
    }

    // ----------------------------------------------------------------------------- areas
    void area(const Shape& shape) {
        const auto span = [paint = painter(shape)](int y, int x0, int x1) {
            paint(y, x0, x1, full_coverage);
        };
        const std::vector<Ring> rings = clipped_outline(shape);
        const bool whole = !scene_.clip.on;  // else a triangle or rectangle may have another form now
        std::vector<SnappedRing> snapped_rings(rings.size());
        for (std::size_t i = 0; i < rings.size(); ++i)
            for (const glm::dvec2& p : rings[i]) snapped_rings[i].push_back(snapped(p.x, p.y));
        if (whole && shape.kind == ShapeKind::Rectangle && shape.algorithm == ScanAlgorithm::Scanline)
            return rectangle(snapped_rings[0][0], snapped_rings[0][2], scene_.fill_rule, box_, span, probe_);
        if (whole && shape.kind == ShapeKind::Triangle && shape.algorithm != ScanAlgorithm::ActiveEdges) {
            const SnappedPoint corners[3] = {snapped_rings[0][0], snapped_rings[0][1], snapped_rings[0][2]};
            return shape.algorithm == ScanAlgorithm::EdgeFunction
                       ? edge_functions(corners, span)
                       : triangle_scan(corners, scene_.fill_rule, box_, span, probe_);
        }
        polygon_active_edges(snapped_rings, shape.inside, scene_.fill_rule, box_, span, probe_);
    }

    // The edge functions know the top-left rule; the book's is the same in a picture turned upside down.
    template <class SpanSink>
    void edge_functions(const SnappedPoint (&corners)[3], SpanSink&& span) {
        const bool turned = scene_.fill_rule == FillRule::Book;
        const int width = picture_.width(), height = picture_.height();
        pipeline::SnappedCorner c[3];
        for (int i = 0; i < 3; ++i)
            c[i] = {corners[i].x, turned ? 256 * height - corners[i].y : corners[i].y, 0, 0};
        const std::int64_t twice_area = area2(c[0], c[1], c[2]);
        if (twice_area == 0) return;
        const CornerOrder order = canonical_order(c[0], c[1], c[2], twice_area > 0);
        const Triangle triangle = make_triangle(c[order.index[0]], c[order.index[1]], c[order.index[2]]);
        const PixelBox seen = pixel_box(c, width, height);
        if (seen.empty()) return;
        for_each_span(triangle, seen, [&](int y, const Span& s, const EdgeValues&) {
            span(turned ? height - 1 - y : y, s.x0, s.x1);
        });
    }

    void smooth_area(const Shape& shape) {
        const std::vector<Ring> clipped = clipped_outline(shape);
        const std::span<const Ring> rings(clipped);
        switch (shape.antialiasing) {
            case Antialiasing::Weighted:
                return weighted_coverage(rings, shape.inside, box_, painter(shape), probe_);
            case Antialiasing::Supersample:
                return supersample(shape.samples, rings, shape.inside, box_, painter(shape), probe_);
            default:
                return area_coverage(rings, shape.inside, box_, painter(shape), probe_);
        }
    }

    // --------------------------------------------------------- shapes that share samples
    // Neighbours in the list with as many samples are drawn together.
    static bool shares_samples(const Shape& s) {
        return s.antialiasing == Antialiasing::Multisample && !is_curve(s) &&
               !(is_line(s) && lights_pixels(s));
    }
    void share(const Shape& shape) {
        samples_ = shape.samples;
        shared_.push_back({clipped_outline(shape), number_});
        if constexpr (pipeline::Wants<Probe, SpanPainted>)
            supersample(shape.samples, std::span<const Ring>(shared_.back().rings), shape.inside, box_,
                        [&](int y, int x0, int x1, int coverage) {
                            note<SpanPainted>(probe_, number_, y, x0, x1, coverage);
                        });
    }
    void resolve() {
        std::vector<SampledShape> sampled;
        for (const Shared& one : shared_) {
            const Shape& shape = scene_.shapes[one.shape];
            sampled.push_back({one.rings, shape.inside, shape.color, shape.opacity});
        }
        if (!sampled.empty()) multisample(samples_, sampled, box_, picture_, probe_);
        shared_.clear();
    }

    // -------------------------------------------------------------------------- outlines
    // The corners of an area; of a line its rectangle, of a polyline all of them together.
    static std::vector<Ring> outline(const Shape& shape) {
        const std::vector<glm::vec2>& p = shape.points;
        if (shape.kind == ShapeKind::Rectangle) return {{p[0], {p[1].x, p[0].y}, p[1], {p[0].x, p[1].y}}};
        if (!is_line(shape)) return {Ring(p.begin(), p.end())};
        std::vector<Ring> rings;
        for (std::size_t i = 0; i + 1 < p.size(); ++i) {
            const auto corners = line_outline(p[i], p[i + 1], shape.width);
            rings.emplace_back(corners.begin(), corners.end());
        }
        return rings;
    }

    // An outline that the window leaves alone stays as it is, to the bit.
    std::vector<Ring> clipped_outline(const Shape& shape) {
        std::vector<Ring> rings = outline(shape);
        if (!scene_.clip.on) return rings;
        std::vector<Ring> left;
        for (const Ring& ring : rings) {
            const std::vector<glm::vec2> before(ring.begin(), ring.end());
            const auto pieces = clipped_ring(before);
            if (pieces.size() == 1 && pieces[0] == before)
                left.push_back(ring);
            else
                for (const auto& piece : pieces) left.emplace_back(piece.begin(), piece.end());
        }
        if (left != rings) note<ShapeClipped>(probe_, number_, corners(rings), corners(left));
        return left;
    }

    using FloatRing = std::vector<glm::vec2>;
    std::vector<FloatRing> clipped_ring(const FloatRing& ring) {
        if (scene_.clip.polygons == PolygonClipper::GreinerHormann) return clipped_by_walking(ring);
        if (window_.empty()) return {};
        const bool in_passes = scene_.clip.polygons == PolygonClipper::SutherlandHodgman;
        const pipeline::ClippedRing clipped =
            in_passes ? pipeline::clip_ring_sutherland_hodgman(ring, window_, probe_)
                      : pipeline::clip_ring_pipeline(ring, window_, probe_);
        if (clipped.points.empty()) return {};
        if (scene_.clip.split) return pipeline::split_bridges(clipped, probe_);
        return {clipped.points};
    }

    std::vector<FloatRing> clipped_by_walking(const FloatRing& ring) {
        const ShapeClip& clip = scene_.clip;
        if (clip.polygon.empty())
            return pipeline::clip_shape_greiner_hormann(ring, pipeline::ClipBox{clip.low, clip.high},
                                                        pipeline::ClipKeep::Inside, probe_);
        return pipeline::clip_shape_greiner_hormann(ring, clip.polygon, pipeline::ClipKeep::Inside, probe_);
    }

    // None for what is no window: nothing is left of any shape then.
    static std::vector<pipeline::ClipLine> sides_of(const ShapeClip& clip) {
        std::vector<pipeline::ClipLine> sides;
        const pipeline::ClipBox box{clip.low, clip.high};
        if (!clip.polygon.empty()) {
            if (const auto convex = pipeline::convex_window(clip.polygon)) sides = *convex;
        } else if (pipeline::is_window(box)) {
            for (const Side side : clip.order) sides.push_back(pipeline::line_of(box, side));
        }
        return sides;
    }
    PixelBox pixels_of_window() const {
        if (window_.empty()) return {0, 0, -1, -1};
        const auto place = [](float c) { return static_cast<int>(std::clamp(c, -1e6f, 1e6f)); };
        const ShapeClip& clip = scene_.clip;
        return {std::max(box_.x0, place(std::ceil(clip.low.x))),
                std::max(box_.y0, place(std::ceil(clip.low.y))),
                std::min(box_.x1, place(std::floor(clip.high.x))),
                std::min(box_.y1, place(std::floor(clip.high.y)))};
    }
    static std::size_t corners(const std::vector<Ring>& rings) {
        std::size_t sum = 0;
        for (const Ring& ring : rings) sum += ring.size();
        return sum;
    }

    // -------------------------------------------------------------------------- painting
    auto painter(const Shape& shape) {
        return [this, &shape](int y, int x0, int x1, int coverage) { paint(shape, y, x0, x1, coverage); };
    }
    // Only pixels in the window; pixel_box_ has cut what an upright one leaves out.
    auto pixel_painter(const Shape& shape) {
        return [this, &shape](int y, int x0, int x1, int coverage) {
            if (mask_.empty()) return paint(shape, y, x0, x1, coverage);
            for (int x = x0; x < x1; ++x)
                if (mask_.at(x, y)) paint(shape, y, x, x + 1, coverage);
        };
    }
    void paint(const Shape& shape, int y, int x0, int x1, int coverage) {
        over(picture_.row(y), x0, x1, shape.color, shape.opacity, coverage);
        note<SpanPainted>(probe_, number_, y, x0, x1, coverage);
    }

    // --------------------------------------------------------------------- small answers
    static bool is_line(const Shape& s) { return s.kind == ShapeKind::Line || s.kind == ShapeKind::Polyline; }
    static bool is_curve(const Shape& s) {
        return s.kind == ShapeKind::Circle || s.kind == ShapeKind::Ellipse;
    }
    // Lines that choose or weight single pixels; all others are areas.
    static bool lights_pixels(const Shape& s) {
        return s.algorithm == ScanAlgorithm::Wu || s.algorithm == ScanAlgorithm::GuptaSproull ||
               (s.antialiasing == Antialiasing::None && s.width == 1);
    }
    static bool is_near(double c) { return std::abs(c) <= largest_place; }  // false for not-a-number, too
    static std::size_t least_points(ShapeKind kind) {
        const bool curve = kind == ShapeKind::Circle || kind == ShapeKind::Ellipse;
        return curve ? 1 : kind == ShapeKind::Triangle || kind == ShapeKind::Polygon ? 3 : 2;
    }
    // All places within reach, those of a wide line's corners, too.
    static bool is_drawable(const Shape& s) {
        const float half = is_line(s) && !lights_pixels(s) ? s.width / 2 : 0;
        return s.points.size() >= least_points(s.kind) && s.width > 0 && is_near(s.width) &&
               s.radius_x >= 0 && s.radius_y >= 0 && is_near(s.radius_x) && is_near(s.radius_y) &&
               std::all_of(s.points.begin(), s.points.end(), [&](const glm::vec2& p) {
                   return is_near(std::abs(p.x) + half) && is_near(std::abs(p.y) + half);
               });
    }
    static Pixel nearest_pixel(const glm::dvec2& p) {
        return {static_cast<std::int32_t>(std::floor(p.x + 0.5)),
                static_cast<std::int32_t>(std::floor(p.y + 0.5))};
    }
    const ShapeScene& scene_;
    Image<LinearRgb>& picture_;
    Probe& probe_;
    std::vector<pipeline::ClipLine> window_;  // its sides
    struct Shared {
        std::vector<Ring> rings;
        std::size_t shape;
    };
    std::vector<Shared> shared_;  // shapes that wait for their neighbours
    int samples_ = 0;             // of these
    PixelBox box_;                // the picture
    PixelBox pixel_box_;          // the pixels of it whose centre lies in an upright window
    Image<std::uint8_t> mask_;    // those in a polygon; empty without one
    std::size_t number_ = 0;      // of the shape that is drawn
};

// Draws the scene over its background into `picture`, which has the size of the picture to be made. All
// coordinates up to largest_place are fine; a shape with others is left out and noted. An algorithm that the
// kind of shape does not have is replaced by the kind's first. The same scene gives the same bytes, whatever
// the compiler, the target and the probe.
template <class Probe = const NoProbe>
void draw_shapes(const ShapeScene& scene, Image<LinearRgb>& picture, Probe&& probe = {}) {
    ShapePass<std::remove_reference_t<Probe>>(scene, picture, probe).run();
}

// The picture as 8-bit codes.
Image<Rgba8> encoded(const Image<LinearRgb>& picture, Output output);

// The unwatched machine is compiled once, in draw_shapes.cpp.
extern template void draw_shapes<const NoProbe>(const ShapeScene&, Image<LinearRgb>&, const NoProbe&&);

}  // namespace relevo::raster
