// From two views to those between them: which pixels belong together, who says so, and how they wander.
#include "relief/optical_flow.hpp"
#include "relief/view_morph.hpp"
#include "samples/show/relief_stages.hpp"
#include "samples/show/tones.hpp"

namespace relevo::show {
namespace {

using relief::Correspondence;
using relief::ReliefCamera;
using relief::Scalar;
using relief::ViewImage;

// Where the pixels of a view go, as directions.
Picture field_of(const Correspondence& to, double longest) {
    Picture out(to.known.width(), to.known.height());
    for (int y = 0; y < out.height(); ++y)
        for (int x = 0; x < out.width(); ++x) {
            const relief::Vec2 by = to.place.at(x, y) - relief::Vec2(x, y) - relief::Vec2(0.5f);
            out.at(x, y) = to.known.at(x, y) ? direction_color(double{by.x}, double{by.y}, longest)
                                             : empty_pixel(x, y, out.width());
        }
    return out;
}
double longest_way(const Correspondence& to) {
    double longest = 0;
    for (int y = 0; y < to.known.height(); ++y)
        for (int x = 0; x < to.known.width(); ++x)
            if (to.known.at(x, y))
                longest = std::max(longest, double{glm::length(to.place.at(x, y) - relief::Vec2(x, y) -
                                                               relief::Vec2(0.5f))});
    return longest;
}

constexpr double most_off = 4;  // pixels
Picture off_picture(const relief::FlowError& error) {
    Picture out(error.off.width(), error.off.height());
    for (int y = 0; y < out.height(); ++y)
        for (int x = 0; x < out.width(); ++x) {
            const double off = double{error.off.at(x, y)};
            out.at(x, y) = off < 0 ? empty_pixel(x, y, out.width())
                                   : mixed(paper, vermilion, int{level(off / most_off)});
        }
    return out;
}

// The same picture from the same eye, on a plane before everything that is to be seen.
ReliefCamera before_the_object(ReliefCamera camera) {
    constexpr double share = 0.5;
    camera.corner = camera.eye + share * (camera.corner - camera.eye);
    camera.a *= share, camera.b *= share;
    return camera;
}

}  // namespace

StagePage draw_relief_morph(const ReliefView& view, const Heading& heading) {
    relief::RepresentationSettings settings = view.relief.settings;
    settings.lit = relief::Lit::Captured;  // shades are a pattern, too
    const auto object = view.in_another_way(relief::Representation::Morph, settings);
    if (!object) {
        Page page = diagram_page(heading, {{"Views", {pair("shown", "none")}}});
        say(canvas_of(page.picture), page.area,
            "There are no views to morph: " + object.error().message + ".");
        return {std::move(page.picture), {{"shown", std::int64_t{0}}}, {}, 1};
    }
    const auto& views = object->textures;
    const ReliefCamera &camera0 = views[0].camera, &camera1 = views[1].camera;
    const ViewImage view0 = as_seen(views[0]), view1 = as_seen(views[1]);
    const double jump = double{object->jump_depth()};
    const Correspondence &to1 = *object->to1, &to0 = *object->to0;
    const Correspondence flow1 = optical_flow(view0, view1), flow0 = optical_flow(view1, view0);
    const relief::FlowError off = flow_error(view0, view1, to1, flow1, object->jump_depth());

    constexpr double half = 0.5;
    const ViewImage truth =
        as_seen(*object->capture(before_the_object(view_between(camera0, camera1, half))));
    const ViewImage plain = morph(view0, view1, to1, to0, half, jump),
                    between = *view_morph(camera0, view0, camera1, view1, to1, to0, half, jump),
                    by_flow = *view_morph(camera0, view0, camera1, view1, flow1, flow0, half, jump);

    const double plain_psnr = error_set(plain, truth).psnr, between_psnr = error_set(between, truth).psnr,
                 flow_psnr = error_set(by_flow, truth).psnr;
    const PanelBlock views_block{"Views",
                                 {pair("apart", decimals(2 * settings.aside.value) + "°"),
                                  quiet("The place asked for is half way from one eye to the other.")}};
    const PanelBlock quality{
        "PSNR half way",
        {pair("plain morphing", decimals(plain_psnr, 2) + " dB"),
         pair("view morphing", decimals(between_psnr, 2) + " dB"),
         pair("  by optical flow", decimals(flow_psnr, 2) + " dB"),
         quiet("Plain morphing moves pixels in straight lines: edges bend on the way. View morphing first "
               "lays both pictures onto one plane, where straight lines are right.")}};
    const PanelBlock found{
        "Optical flow",
        {pair("knows", share(off.known, off.visible)), pair("within a pixel", share(off.near, off.known)),
         pair("off, mean", decimals(off.mean, 2) + " px"),
         quiet("The object knows where each of its points is in the other view. Flow looks for it in the "
               "pictures alone, and loses what moves far."),
         ramp(paper, vermilion, "right", "4 px off")}};
    const raster::Output output = view.loaded->settings.output;
    const auto colors = [&](const ViewImage& image) {
        return color_picture(image.color, image.coverage, output);
    };
    const double longest = longest_way(to1);
    PanePage page = pane_page(heading, {views_block, quality, found, legend_of_directions()}, 3,
                              {{"first view", colors(view0)},
                               {"second view", colors(view1)},
                               {"half way: the truth", colors(truth)},
                               {"plain morphing", colors(plain)},
                               {"view morphing", colors(between)},
                               {"view morphing by flow", colors(by_flow)},
                               {"where pixels go", field_of(to1, longest)},
                               {"where flow says", field_of(flow1, longest)},
                               {"how far flow is off", off_picture(off)}});
    page.stage.counts = {{"plain_psnr", plain_psnr},
                         {"view_morph_psnr", between_psnr},
                         {"view_morph_by_flow_psnr", flow_psnr},
                         {"visible_in_both", std::int64_t{off.visible}},
                         {"flow_knows", std::int64_t{off.known}},
                         {"flow_within_a_pixel", std::int64_t{off.near}},
                         {"flow_mean_off", off.mean}};
    return std::move(page.stage);
}

}  // namespace relevo::show
