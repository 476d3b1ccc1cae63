#include "samples/show/relief_view.hpp"

#include "relief/screen.hpp"
#include "samples/show/tones.hpp"

namespace relevo::show {
namespace {

using relief::Image;
using relief::Representation;

// A box has no direction of its own: that of its face in front of the viewer.
void look_as_the_viewer_does(const glm::dvec3& toward, relief::RepresentationSettings& settings) {
    const glm::dvec3 size = glm::abs(toward);
    if (size.y > size.x && size.y > size.z)
        settings.elevation = {toward.y > 0 ? 90.0 : -90.0};
    else if (size.x > size.z)
        settings.azimuth = {toward.x > 0 ? 90.0 : -90.0};
    else
        settings.azimuth = {toward.z > 0 ? 0.0 : 180.0};
}

// The textures, the warp and its window; false: `problem` says why not.
bool take_texture(ReliefView& out) {
    const auto failed = [&](const pipeline::Error& error) { return out.problem = error.message, false; };
    relief::RepresentationSettings settings = out.object->settings;
    settings.lit = relief::Lit::Drawn;
    if (out.object->representation == Representation::ReliefBox)
        look_as_the_viewer_does(out.screen.eye - bounding_ball(out.object->shape()).centre, settings);
    auto made = out.in_another_way(Representation::Relief, settings);
    if (!made) return failed(made.error());
    out.relief = *std::move(made);
    const auto warp = make_warp(out.texture().camera, relief::viewer_at(out.screen.eye));
    if (!warp) return failed(warp.error());
    out.warp = *warp;
    const auto window = target_window(out.texture().camera, out.warp, depth_range(out.texture()));
    if (!window) return failed(window.error());
    out.window = *window;
    return true;
}

// Each pixel by paint(x, y), stripes where there is nothing.
template <class Paint>
Picture painted_where(const Image<std::uint8_t>& coverage, Paint&& paint) {
    Picture out(coverage.width(), coverage.height());
    for (int y = 0; y < out.height(); ++y)
        for (int x = 0; x < out.width(); ++x)
            out.at(x, y) = coverage.at(x, y) ? paint(x, y) : empty_pixel(x, y, out.width());
    return out;
}

}  // namespace

relief::PrewarpSettings ReliefView::settings_with(relief::Resampler resampler) const {
    relief::PrewarpSettings settings = object->settings.prewarp;
    settings.jump_depth = relief.jump_depth();
    settings.resampler = resampler;
    settings.maps = true;
    return settings;
}

relief::Prewarped ReliefView::warped(const relief::PrewarpSettings& settings) const {
    return prewarp(texture(), warp, window, settings);
}

relief::Result<relief::Represented> ReliefView::in_another_way(
    Representation representation, const relief::RepresentationSettings& settings) const {
    return represent(representation, settings, shape_capture(*loaded, *object));
}

relief::Result<relief::ViewImage> ReliefView::view(const relief::Represented& other) const {
    return view_of(other, screen, loaded->scene, loaded->settings);
}

ReliefView relief_view(const scene::LoadedScene& loaded) {
    ReliefView out;
    out.loaded = &loaded, out.object = &loaded.reliefs.front();
    const auto screen =
        relief::screen_camera(loaded.scene.camera, loaded.settings.depth, loaded.width, loaded.height);
    if (!screen) return out.problem = "These pictures need a viewer: " + screen.error().message + ".", out;
    out.screen = *screen;
    if (!take_texture(out)) return out.problem = "No relief can be warped here: " + out.problem + ".", out;
    out.picture = out.warped(out.settings_with(out.object->settings.prewarp.resampler));
    out.seen = *out.view(out.relief);
    const int samples = out.object->surface ? 1 : 4;
    out.truth =
        *true_view(shape_capture(loaded, *out.object), out.screen, loaded.scene, loaded.settings, samples);
    return out;
}

Picture color_picture(const Image<relief::LinearRgb>& color, const Image<std::uint8_t>& coverage,
                      raster::Output output) {
    return painted_where(coverage, [&](int x, int y) { return raster::to_rgba8(color.at(x, y), output); });
}

Picture normal_picture(const Image<relief::Vec3>& normal, const Image<std::uint8_t>& coverage) {
    return painted_where(coverage, [&](int x, int y) {
        const relief::Vec3 n = pipeline::normalize(normal.at(x, y));
        const auto channel = [](relief::Scalar c) { return level(0.5 + 0.5 * double{c}); };
        return Rgba8{channel(n.x), channel(n.y), channel(n.z)};
    });
}

Picture depth_picture(const Image<relief::Scalar>& depth, const Image<std::uint8_t>& coverage) {
    Range range;
    for (std::size_t i = 0; i < depth.pixels().size(); ++i)
        if (coverage.pixels()[i]) range.add(double{depth.pixels()[i]});
    return painted_where(coverage, [&](int x, int y) {
        return grey(range.high > range.low ? 1 - range.share_of(double{depth.at(x, y)}) : 1);
    });
}

Picture difference_picture(const relief::ViewImage& a, const relief::ViewImage& b) {
    Picture out(a.width(), a.height());
    for (int y = 0; y < out.height(); ++y)
        for (int x = 0; x < out.width(); ++x) {
            const bool in_a = a.coverage.at(x, y) != 0, in_b = b.coverage.at(x, y) != 0;
            if (in_a != in_b) {
                out.at(x, y) = in_a ? orange : sky;
            } else if (!in_a) {
                out.at(x, y) = empty_pixel(x, y, out.width());
            } else {
                const relief::LinearRgb p = a.color.at(x, y), q = b.color.at(x, y);
                const auto apart = [](relief::Scalar c, relief::Scalar d) {
                    return level(4 * std::fabs(double{c} - double{d}));
                };
                out.at(x, y) = {apart(p.r, q.r), apart(p.g, q.g), apart(p.b, q.b)};
            }
        }
    return out;
}

relief::ViewImage as_view(const relief::Prewarped& picture) {
    relief::ViewImage view;
    view.color = picture.color, view.depth = picture.depth, view.coverage = picture.coverage;
    return view;
}

}  // namespace relevo::show
