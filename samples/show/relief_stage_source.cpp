// The relief texture itself, and where its texels must go.
#include <fmt/format.h>

#include "relief/occlusion_order.hpp"
#include "relief/quantize.hpp"
#include "samples/show/numbers.hpp"
#include "samples/show/relief_stages.hpp"
#include "samples/show/tones.hpp"

namespace relevo::show {
namespace {

using Kind = PanelRow::Kind;
using relief::Image;

bool is_orthographic(const ReliefView& view) {
    return view.texture().camera.projection == relief::Projection::Orthographic;
}
// Where nothing is covered.
Picture stripes(int width, int height) {
    Picture out(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) out.at(x, y) = empty_pixel(x, y, width);
    return out;
}
std::string size_of(int width, int height) { return fmt::format("{} × {}", width, height); }

// Dark blue to yellow, evenly lighter: 0 to 1.
Rgba8 rank_color(double share) {
    constexpr Rgba8 steps[] = {{32, 18, 77}, {48, 71, 122}, {38, 130, 142}, {86, 190, 98}, {245, 230, 80}};
    const double place = 4 * std::clamp(share, 0.0, 1.0);
    const auto i = std::min(static_cast<std::size_t>(place), std::size_t{3});
    return mixed(steps[i], steps[i + 1], static_cast<int>(255 * (place - static_cast<double>(i)) + 0.5));
}

std::int64_t covered_texels(const Image<std::uint8_t>& coverage) {
    return std::count_if(coverage.pixels().begin(), coverage.pixels().end(), [](auto c) { return c != 0; });
}

// The cross hairs of the epipole, in texels, over the picture of the source.
void mark_epipole(const Canvas& canvas, const Scale& scale, const Rect& rect, double u, double v) {
    const Canvas inside = within(canvas, rect);
    const Spot at = scale.spot(rect, u, v);
    const Stroke lines{with_opacity(paper, 200), 1.5, 6};
    line(inside, {at.x, double(rect.y)}, {at.x, double(rect.bottom())}, lines);
    line(inside, {double(rect.x), at.y}, {double(rect.right()), at.y}, lines);
    ring(inside, at, 7, {vermilion, 3});
    const bool seen = at.x > rect.x && at.x < rect.right() && at.y > rect.y && at.y < rect.bottom();
    if (seen) return;
    const Spot middle{rect.x + rect.width / 2.0, rect.y + rect.height / 2.0};
    const double dx = at.x - middle.x, dy = at.y - middle.y, length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0) || !std::isfinite(length)) return;
    const double reach = 0.38 * std::min(rect.width, rect.height);
    arrow(inside, middle, {middle.x + reach * dx / length, middle.y + reach * dy / length}, {vermilion, 3});
}

}  // namespace

StagePage draw_relief_source(const ReliefView& view, const Heading& heading) {
    const relief::ReliefTexture& texture = view.texture();
    const relief::ReliefCamera& camera = texture.camera;
    const relief::DepthRange depth = depth_range(texture);
    const std::int64_t covered = covered_texels(texture.coverage),
                       all = std::int64_t(camera.width) * camera.height;
    Picture coverage(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) coverage.at(x, y) = texture.coverage.at(x, y) ? paper : night;
    const relief::RepresentationSettings& settings = view.relief.settings;
    const PanelBlock source{"Source camera",
                            {pair("projection", is_orthographic(view) ? "orthographic" : "perspective"),
                             pair("from azimuth", decimals(settings.azimuth.value) + "°"),
                             pair("elevation", decimals(settings.elevation.value) + "°"),
                             pair("plane's corner", ""), words("  " + triple(camera.corner)),
                             pair("a texel", number(std::sqrt(glm::dot(camera.a, camera.a))))}};
    const PanelBlock texels{
        "Texels",
        {pair("size", size_of(camera.width, camera.height)), pair("covered", share(covered, all)),
         pair(is_orthographic(view) ? "displacement" : "disparity",
              depth.empty ? "none" : range(double{depth.low}, double{depth.high})),
         quiet(is_orthographic(view)
                   ? "The displacement is how far the surface lies behind the plane, in world units."
                   : "The disparity is 1 on the plane and falls towards 0 with the distance from the eye."),
         quiet("Light is left out: it comes when the relief is drawn.")}};
    PanelBlock normals{
        "Normals",
        {sample(Kind::Square, {255, 128, 128}, "to +x"), sample(Kind::Square, {128, 255, 128}, "to +y"),
         sample(Kind::Square, {128, 128, 255}, "to +z")}};
    const raster::Output output = view.loaded->settings.output;
    PanePage page = pane_page(heading, {source, texels, normals}, 2,
                              {{"colour", color_picture(texture.color, texture.coverage, output)},
                               {"normal", normal_picture(texture.normal, texture.coverage)},
                               {is_orthographic(view) ? "displacement" : "disparity",
                                depth_picture(texture.depth, texture.coverage)},
                               {"coverage", coverage}});
    page.stage.counts = {{"texels", all}, {"covered", covered}};
    if (!depth.empty) {
        page.stage.counts.push_back({"nearest", double{depth.low}});
        page.stage.counts.push_back({"deepest", double{depth.high}});
    }
    return std::move(page.stage);
}

StagePage draw_relief_quantized(const ReliefView& view, const Heading& heading) {
    const relief::ReliefTexture& texture = view.texture();
    const auto eight = relief::quantize<std::uint8_t>(texture);
    const auto sixteen = relief::quantize<std::uint16_t>(texture);
    const int width = texture.camera.width, height = texture.camera.height;
    Picture codes = stripes(width, height), error = stripes(width, height);
    double worst8 = 0, worst16 = 0;
    const double half = step(eight) / 2;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!texture.coverage.at(x, y)) continue;
            const std::uint8_t code = eight.code.at(x, y);
            codes.at(x, y) = {code, code, code};
            const double depth = double{texture.depth.at(x, y)}, off = double{value(eight, code)} - depth;
            worst8 = std::max(worst8, std::fabs(off));
            worst16 = std::max(worst16, std::fabs(double{value(sixteen, sixteen.code.at(x, y))} - depth));
            const int part = static_cast<int>(255 * std::min(half > 0 ? std::fabs(off) / half : 0, 1.0));
            error.at(x, y) = mixed(paper, off < 0 ? blue : vermilion, part);
        }
    PanelBlock numbers{"Error of the depth",
                       {pair("8 bits, a step", number(step(eight))), pair("  largest error", number(worst8)),
                        pair("  bound", number(half)), pair("16 bits, a step", number(step(sixteen))),
                        pair("  largest error", number(worst16)), pair("  bound", number(step(sixteen) / 2)),
                        quiet("The bound is half a step, and the rounding of float beside it.")}};
    PanelBlock legend{"Legend",
                      {ramp(night, paper, "code 0", "code 254"), ramp(blue, paper, "too near", "right"),
                       ramp(paper, vermilion, "right", "too deep"),
                       sample(Kind::Square, night, "empty: code 255 (stripes)")}};
    PanePage page = pane_page(heading, {numbers, legend}, 2, {{"8-bit codes", codes}, {"error", error}});
    page.stage.counts = {{"step_8_bit", step(eight)},
                         {"largest_error_8_bit", worst8},
                         {"step_16_bit", step(sixteen)},
                         {"largest_error_16_bit", worst16}};
    return std::move(page.stage);
}

StagePage draw_relief_order(const ReliefView& view, const Heading& heading) {
    const relief::ReliefTexture& texture = view.texture();
    const int width = texture.camera.width, height = texture.camera.height;
    const relief::OcclusionOrder order = occlusion_order(view.warp);
    Picture ranks(width, height), texels = stripes(width, height);
    const double last = std::max(double(width) * height - 1, 1.0);
    std::int64_t rank = 0;
    for_each_in_order(order, width, height, [&](int x, int y) {
        ranks.at(x, y) = rank_color(double(rank) / last);
        if (texture.coverage.at(x, y)) texels.at(x, y) = ranks.at(x, y);
        ++rank;
    });
    const auto parts = [](double epipole, int count) {
        const int before = relief::texels_before(epipole, count);
        return before == 0 || before == count ? 1 : 2;
    };
    const int sheets = parts(order.u, width) * parts(order.v, height);
    PanelBlock epipole{
        "Epipole",
        {pair("u", number(order.u)), pair("v", number(order.v)),
         quiet("The foot of the viewer on the plane, in texels: the point that the warp does "
               "not move. The texels that meet in a pixel lie on a line through it."),
         pair("sheets", std::to_string(sheets)),
         words(order.toward ? "from the borders to the epipole" : "from the epipole to the borders")}};
    PanelBlock legend{
        "Legend",
        {ramp(rank_color(0), rank_color(1), "first", "last"), sample(Kind::Ring, vermilion, "the epipole"),
         sample(Kind::Dashes, haze, "borders of the sheets")}};
    PanePage page =
        pane_page(heading, {epipole, legend}, 2, {{"every texel's turn", ranks}, {"covered ones", texels}});
    for (std::size_t i = 0; i < page.rects.size(); ++i)
        mark_epipole(canvas_of(page.stage.picture), page.scales[i], page.rects[i], order.u, order.v);
    page.stage.counts = {{"epipole_u", order.u}, {"epipole_v", order.v}, {"sheets", std::int64_t(sheets)}};
    return std::move(page.stage);
}

StagePage draw_relief_field(const ReliefView& view, const Heading& heading) {
    const relief::ReliefTexture& texture = view.texture();
    const int width = texture.camera.width, height = texture.camera.height;
    const auto moved = [&](int x, int y) {
        const relief::WarpedPoint p = warp_texel(view.warp, texture, x, y);
        return glm::dvec2(p.u - (x + 0.5), p.v - (y + 0.5));
    };
    double longest = 0, sum = 0;
    std::int64_t count = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (texture.coverage.at(x, y)) {
                const glm::dvec2 by = moved(x, y);
                const double length = std::sqrt(glm::dot(by, by));
                longest = std::max(longest, length), sum += length, ++count;
            }
    Picture field = stripes(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (texture.coverage.at(x, y))
                field.at(x, y) = direction_color(moved(x, y).x, moved(x, y).y, longest);
    const double mean = count ? sum / double(count) : 0;
    PanelBlock numbers{"Way of the texels",
                       {pair("longest", number(longest) + " texels"), pair("mean", number(mean) + " texels"),
                        quiet("u' = (u + k1 d) / (1 + k3 d), and v' with k2."),
                        pair("k1", number(view.warp.k1)), pair("k2", number(view.warp.k2)),
                        pair("k3", number(view.warp.k3)), pair("viewer to plane", number(view.warp.h))}};
    const PanelBlock legend = legend_of_directions();
    PanePage page = pane_page(heading, {numbers, legend}, 1, {{"from texel to warped place", field}});
    const Rect rect = page.rects[0];
    const Scale scale = page.scales[0];
    const Canvas canvas = within(canvas_of(page.stage.picture), rect);
    const int pace = std::max(1, 32 * scale.divisor / scale.factor);
    for (int y = pace / 2; y < height; y += pace)
        for (int x = pace / 2; x < width; x += pace) {
            if (!texture.coverage.at(x, y)) continue;
            const glm::dvec2 by = moved(x, y);
            const Spot from = scale.spot(rect, x + 0.5, y + 0.5),
                       to = scale.spot(rect, x + 0.5 + by.x, y + 0.5 + by.y);
            disc(canvas, from, 2.5, paper);
            if (glm::dot(by, by) > 0.25) arrow(canvas, from, to, {paper, 1.5});
        }
    page.stage.counts = {{"longest", longest}, {"mean", mean}};
    return std::move(page.stage);
}

}  // namespace relevo::show
