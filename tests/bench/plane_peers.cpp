#include "tests/bench/plane_peers.hpp"

#include <agg_conv_stroke.h>
#include <agg_ellipse.h>
#include <agg_path_storage.h>
#include <agg_pixfmt_rgba.h>
#include <agg_rasterizer_outline_aa.h>
#include <agg_rasterizer_scanline_aa.h>
#include <agg_renderer_base.h>
#include <agg_renderer_outline_aa.h>
#include <agg_renderer_primitives.h>
#include <agg_renderer_scanline.h>
#include <agg_rendering_buffer.h>
#include <agg_scanline_bin.h>
#include <agg_scanline_u.h>
#include <cairo.h>

#include <numbers>

namespace relevo::bench {

struct Cairo::Surface {
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, plane_size, plane_size);
    cairo_t* context = cairo_create(surface);
    ~Surface() {
        cairo_destroy(context);
        cairo_surface_destroy(surface);
    }
};

Cairo::Cairo() : surface_(std::make_unique<Surface>()) {}
Cairo::~Cairo() = default;
std::string Cairo::version() { return cairo_version_string(); }

void Cairo::draw(Kind kind, CairoMode mode, std::span<const Primitive> all) {
    constexpr cairo_antialias_t modes[] = {CAIRO_ANTIALIAS_NONE, CAIRO_ANTIALIAS_FAST, CAIRO_ANTIALIAS_GOOD,
                                           CAIRO_ANTIALIAS_BEST};
    cairo_t* c = surface_->context;
    cairo_set_antialias(c, modes[static_cast<int>(mode)]);
    cairo_set_line_width(c, 1);
    cairo_set_source_rgb(c, 0, 0, 0);
    cairo_paint(c);
    for (const Primitive& p : all) {
        cairo_set_source_rgb(c, p.color.r / 255.0, p.color.g / 255.0, p.color.b / 255.0);
        if (kind == Kind::Lines || kind == Kind::Triangles) {
            cairo_move_to(c, p.x[0], p.y[0]);
            cairo_line_to(c, p.x[1], p.y[1]);
            if (kind == Kind::Triangles) cairo_line_to(c, p.x[2], p.y[2]), cairo_close_path(c);
        } else {
            cairo_new_sub_path(c);
            cairo_arc(c, p.x[0], p.y[0], p.radius, 0, 2 * std::numbers::pi);
        }
        if (kind == Kind::Lines || kind == Kind::Circles)
            cairo_stroke(c);
        else
            cairo_fill(c);
    }
    cairo_surface_flush(surface_->surface);
}

Picture Cairo::picture() const {
    Picture picture(plane_size, plane_size);
    const unsigned char* bytes = cairo_image_surface_get_data(surface_->surface);
    const int stride = cairo_image_surface_get_stride(surface_->surface);
    for (int y = 0; y < plane_size; ++y)
        for (int x = 0; x < plane_size; ++x) {
            const unsigned char* p = bytes + y * stride + 4 * x;  // blue, green, red
            picture.at(x, y) = {p[2], p[1], p[0], 255};
        }
    return picture;
}

struct Agg::Canvas {
    using Format = agg::pixfmt_rgba32;
    using Base = agg::renderer_base<Format>;

    Picture picture{plane_size, plane_size};
    agg::rendering_buffer buffer{reinterpret_cast<agg::int8u*>(picture.pixels().data()), plane_size,
                                 plane_size, 4 * plane_size};
    Format format{buffer};
    Base base{format};
    agg::rasterizer_scanline_aa<> rasterizer;
    agg::scanline_u8 smooth;
    agg::scanline_bin binary;
    agg::path_storage path;

    Canvas() { rasterizer.clip_box(0, 0, plane_size, plane_size); }

    void add_path(Kind kind, const Primitive& p) {
        rasterizer.reset();
        if (kind == Kind::Triangles) {
            rasterizer.move_to_d(p.x[0], p.y[0]);
            rasterizer.line_to_d(p.x[1], p.y[1]);
            rasterizer.line_to_d(p.x[2], p.y[2]);
        } else if (kind == Kind::Lines) {
            path.remove_all();
            path.move_to(p.x[0], p.y[0]);
            path.line_to(p.x[1], p.y[1]);
            agg::conv_stroke<agg::path_storage> stroke(path);
            stroke.width(1);
            rasterizer.add_path(stroke);
        } else {
            agg::ellipse circle(p.x[0], p.y[0], p.radius, p.radius);
            if (kind == Kind::Discs) return rasterizer.add_path(circle);
            agg::conv_stroke<agg::ellipse> stroke(circle);
            stroke.width(1);
            rasterizer.add_path(stroke);
        }
    }
};

Agg::Agg() : canvas_(std::make_unique<Canvas>()) {}
Agg::~Agg() = default;
Picture Agg::picture() const { return canvas_->picture; }

bool Agg::draws(Kind kind, AggMode mode) {
    if (mode == AggMode::Primitives) return kind != Kind::Triangles;
    return mode != AggMode::OutlineSmooth || kind == Kind::Lines;
}

void Agg::draw(Kind kind, AggMode mode, std::span<const Primitive> all) {
    using Base = Canvas::Base;
    Canvas& canvas = *canvas_;
    canvas.base.clear(agg::rgba8(0, 0, 0));
    const auto color = [](const Primitive& p) { return agg::rgba8(p.color.r, p.color.g, p.color.b); };
    if (mode == AggMode::Primitives) {
        agg::renderer_primitives<Base> renderer(canvas.base);
        for (const Primitive& p : all) {
            renderer.line_color(color(p));
            renderer.fill_color(color(p));
            const int x = static_cast<int>(p.x[0]), y = static_cast<int>(p.y[0]),
                      radius = static_cast<int>(p.radius);
            if (kind == Kind::Lines)
                renderer.line(renderer.coord(p.x[0]), renderer.coord(p.y[0]), renderer.coord(p.x[1]),
                              renderer.coord(p.y[1]));
            else if (kind == Kind::Circles)
                renderer.ellipse(x, y, radius, radius);
            else
                renderer.solid_ellipse(x, y, radius, radius);
        }
    } else if (mode == AggMode::OutlineSmooth) {
        using Outline = agg::renderer_outline_aa<Base>;
        agg::line_profile_aa profile;
        profile.width(1);
        Outline renderer(canvas.base, profile);
        agg::rasterizer_outline_aa<Outline> rasterizer(renderer);
        for (const Primitive& p : all) {
            renderer.color(color(p));
            rasterizer.move_to_d(p.x[0], p.y[0]);
            rasterizer.line_to_d(p.x[1], p.y[1]);
            rasterizer.render(false);
        }
    } else {
        agg::renderer_scanline_bin_solid<Base> binary(canvas.base);
        for (const Primitive& p : all) {
            canvas.add_path(kind, p);
            if (mode == AggMode::ScanlineSmooth) {
                agg::render_scanlines_aa_solid(canvas.rasterizer, canvas.smooth, canvas.base, color(p));
            } else {
                binary.color(color(p));
                agg::render_scanlines(canvas.rasterizer, canvas.binary, binary);
            }
        }
    }
}

}  // namespace relevo::bench
