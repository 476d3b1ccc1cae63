#include "tests/golden/stages.hpp"

#include <algorithm>
#include <cmath>

#include "raster/draw.hpp"

namespace relevo::golden {
namespace {

using pipeline::Scalar;
using raster::Image;
using raster::Rgba8;

// Hears everything that the goldens keep.
struct Recorder {
    std::string clipped, window;
    Image<PlainPixel> pixels;

    void on(const raster::TriangleClipped& e) { clipped += clipped_line(e.primitive, e.polygon); }
    void on(const raster::TriangleRejected& e) {
        if (e.reason == raster::Rejection::Outside) clipped += clipped_line(e.primitive, {});
    }
    void on(const raster::TriangleSnapped& e) {
        window += window_line(e.primitive, e.corners, e.area2, e.facing, e.culled);
    }
    void on(const raster::FragmentCovered& e) {
        pixels.at(e.x, e.y).last = e.primitive + 1, ++pixels.at(e.x, e.y).count;
    }
    void on(const raster::FragmentShaded& e) {
        PlainPixel& p = pixels.at(e.x, e.y);
        p.drawn = true, p.z = e.z, p.inv_w = e.inv_w;
        p.b[0] = e.b0, p.b[1] = e.b1, p.b[2] = e.b2;
        if (e.varying.size() >= 2) std::copy_n(e.varying.end() - 2, 2, p.uv);
    }
};

raster::Frame frame_of(const Subject& s) {
    return {Image<Rgba8>(s.width, s.height), Image<Scalar>(s.width, s.height), {}};
}

std::uint8_t byte(double share) { return static_cast<std::uint8_t>(std::clamp(share, 0.0, 1.0) * 255 + 0.5); }

// ------------------------------------------------------------------------------------- pictures of the data
Product coverage(const Image<PlainPixel>& pixels) {
    Product out;
    out.picture = Image<Rgba8>(pixels.width(), pixels.height());
    for (std::size_t i = 0; i < pixels.pixels().size(); ++i)
        out.picture.pixels()[i] = coverage_color(pixels.pixels()[i].last, pixels.pixels()[i].count);
    return out;
}

// The nearest white, the farthest dark, what is empty blue.
Product depth(const Image<Scalar>& z, Scalar cleared) {
    Product out;
    out.picture = Image<Rgba8>(z.width(), z.height()), out.numbers = Image<float>(z.width(), z.height());
    double low = 1, high = 0;
    for (const Scalar v : z.pixels())
        if (v != cleared) low = std::min(low, double(v)), high = std::max(high, double(v));
    for (std::size_t i = 0; i < z.pixels().size(); ++i) {
        const Scalar v = z.pixels()[i];
        const std::uint8_t grey = byte(0.2 + 0.8 * (double(v) - low) / (high - low));
        out.numbers.pixels()[i] = static_cast<float>(v);
        out.picture.pixels()[i] = v == cleared ? Rgba8{20, 30, 80} : Rgba8{grey, grey, grey};
    }
    return out;
}
Product depth(const Image<PlainPixel>& pixels, Scalar cleared) {
    Image<Scalar> z(pixels.width(), pixels.height());
    for (std::size_t i = 0; i < pixels.pixels().size(); ++i)
        z.pixels()[i] = pixels.pixels()[i].drawn ? pixels.pixels()[i].z : cleared;
    return depth(z, cleared);
}

// Six numbers a pixel, side by side: b0, b1, b2, 1/w, u, v. The picture has the weights as red, green and
// blue, and below them u, v and 1/w.
Product attributes(const Image<PlainPixel>& pixels) {
    const int width = pixels.width(), height = pixels.height();
    Product out;
    out.picture = Image<Rgba8>(width, 2 * height), out.numbers = Image<float>(6 * width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const PlainPixel& p = pixels.at(x, y);
            const Scalar six[6] = {p.b[0], p.b[1], p.b[2], p.inv_w, p.uv[0], p.uv[1]};
            for (int k = 0; k < 6; ++k) out.numbers.at(6 * x + k, y) = static_cast<float>(six[k]);
            out.picture.at(x, y) = {byte(double(p.b[0])), byte(double(p.b[1])), byte(double(p.b[2]))};
            const auto fraction = [](Scalar v) { return byte(double(v - std::floor(v))); };
            out.picture.at(x, y + height) = {fraction(p.uv[0]), fraction(p.uv[1]), byte(double(p.inv_w))};
        }
    return out;
}

Product color(const Subject& s, const Image<PlainPixel>& pixels) {
    Product out;
    out.picture = Image<Rgba8>(s.width, s.height, raster::to_rgba8(s.scene.background, s.settings.output));
    for (std::size_t i = 0; i < pixels.pixels().size(); ++i) {
        const PlainPixel& p = pixels.pixels()[i];
        if (!p.drawn) continue;
        const raster::Model& model = s.scene.models[p.model];
        const auto light = model.texture
                               ? raster::sample(*model.texture, s.settings.texture_filter, {p.uv[0], p.uv[1]})
                               : model.material.color;
        out.picture.pixels()[i] = raster::to_rgba8(light, s.settings.output);
    }
    return out;
}

}  // namespace

Product product_of(Stage stage, const Subject& s) {
    raster::Frame frame = frame_of(s);
    Recorder recorder{"", "", Image<PlainPixel>(s.width, s.height)};
    raster::draw(s.scene, s.settings, frame, recorder);
    switch (stage) {
        case Stage::Clipped:
            return {recorder.clipped, {}, {}};
        case Stage::Window:
            return {recorder.window, {}, {}};
        case Stage::Coverage:
            return coverage(recorder.pixels);
        case Stage::Depth:
            return depth(frame.depth, raster::cleared_depth(s.settings.depth));
        case Stage::Attributes:
            return attributes(recorder.pixels);
        case Stage::Color:
            return {"", frame.color, {}};
        case Stage::Final:
            return {"", frame.color, depth(frame.depth, raster::cleared_depth(s.settings.depth)).numbers};
    }
    return {};
}

bool has_plain_form(Stage stage, const Subject& s) {
    return stage != Stage::Final && s.settings.shading == raster::Shading::Unlit;
}

Product plain_product_of(Stage stage, const Subject& s, const Rules& rules) {
    if (stage == Stage::Clipped) return {plain_clipped(s, rules), {}, {}};
    if (stage == Stage::Window) {
        Product out;
        for (const PlainTriangle& t : plain_triangles(s, rules))
            out.text += window_line(t.primitive, t.corner, t.area2, t.facing, t.culled);
        return out;
    }
    const Image<PlainPixel> pixels = plain_pixels(s, rules);
    if (stage == Stage::Coverage) return coverage(pixels);
    if (stage == Stage::Depth) return depth(pixels, raster::cleared_depth(s.settings.depth));
    if (stage == Stage::Attributes) return attributes(pixels);
    return color(s, pixels);
}

Product truncated_product_of(const Subject& s) {
    raster::Frame frame = frame_of(s);
    frame.linear = Image<pipeline::LinearRgb>(s.width, s.height);
    raster::draw(s.scene, s.settings, frame);
    const auto cut = [](Scalar c) {
        return static_cast<std::uint8_t>(std::clamp(c, Scalar(0), Scalar(1)) * 255);
    };
    Product out{"", Image<Rgba8>(s.width, s.height), {}};
    for (std::size_t i = 0; i < frame.linear.pixels().size(); ++i) {
        const auto& c = frame.linear.pixels()[i];
        out.picture.pixels()[i] = {cut(c.r), cut(c.g), cut(c.b)};
    }
    return out;
}

}  // namespace relevo::golden
