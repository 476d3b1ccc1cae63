// The pre-warp: passes, resamplers, order, map, and the plane that the warped picture is drawn on.
#include <fmt/format.h>

#include "relief/offset_map.hpp"
#include "relief/resample_asymmetric.hpp"
#include "relief/warp_3d.hpp"
#include "samples/scene/choices.hpp"
#include "samples/show/numbers.hpp"
#include "samples/show/relief_stages.hpp"
#include "samples/show/tones.hpp"

namespace relevo::show {
namespace {

using Row = PanelRow::Kind;
using relief::Image;
using relief::Prewarped;
using relief::Resampler;

struct Named {
    Resampler resampler;
    std::string name;
};
const Named resamplers[] = {{Resampler::OneDimensional, "one-dimensional"},
                            {Resampler::Asymmetric, "asymmetric"},
                            {Resampler::Compensated, "compensated"},
                            {Resampler::Interleaved, "interleaved"}};

Picture colors_of(const ReliefView& view, const Prewarped& picture) {
    return color_picture(picture.color, picture.coverage, view.loaded->settings.output);
}

std::int64_t covered_pixels(const Prewarped& picture) {
    const auto& pixels = picture.coverage.pixels();
    return std::count_if(pixels.begin(), pixels.end(), [](auto c) { return c != 0; });
}
std::int64_t all_pixels(const Prewarped& picture) {
    return std::int64_t(picture.window.width) * picture.window.height;
}

PanelBlock window_block(const ReliefView& view) {
    const relief::Window& w = view.window;
    return {"Target window",
            {pair("first texel", fmt::format("{}, {}", w.x0, w.y0)),
             pair("size", fmt::format("{} × {}", w.width, w.height)),
             quiet("Warped texels leave the source's square; the window holds them all.")}};
}

constexpr Rgba8 kind_color(relief::Kind kind) {
    switch (kind) {
        case relief::Kind::Empty:
            return night;
        case relief::Kind::Sampled:
            return haze;
        case relief::Kind::Filled:
            return sky;
        case relief::Kind::FilledAcross:
            return vermilion;
    }
    return night;
}

// A number of paintings: grey once, warmer the more.
constexpr Rgba8 writes_colors[] = {night, {214, 222, 230}, yellow, orange, vermilion, purple};

// What the horizontal pass leaves, as pictures of colour and depth.
struct RowKeeper {
    Image<relief::LinearRgb>& color;
    Image<relief::Scalar>& depth;
    Image<std::uint8_t>& coverage;
    void on(const relief::RowResampled<true>& row) {
        for (int x = 0; x < color.width(); ++x) {
            const auto sample = row.at(x);
            if (sample.kind == relief::Kind::Empty) continue;
            const relief::Four& c = sample.carried.part[0];
            color.at(x, row.row) = {c[0], c[1], c[2]}, depth.at(x, row.row) = c[3];
            coverage.at(x, row.row) = 1;
        }
    }
};

}  // namespace

StagePage draw_relief_rows(const ReliefView& view, const Heading& heading) {
    Prewarped picture = view.warped(view.settings_with(Resampler::Asymmetric));
    const int width = view.window.width, height = view.texture().camera.height;
    Image<relief::LinearRgb> color(width, height);
    Image<relief::Scalar> depth(width, height);
    Image<std::uint8_t> coverage(width, height);
    const relief::PrewarpSettings settings = view.settings_with(Resampler::Asymmetric);
    relief::PrewarpMemory::Parts memory;
    resample_picture<true>(relief::AsymmetricMethod{},
                           prepare(view.texture(), settings.jump, settings.jump_depth), view.warp, settings,
                           picture, memory, RowKeeper{color, depth, coverage});
    const relief::ReliefTexture& source = view.texture();
    const raster::Output output = view.loaded->settings.output;
    const PanelBlock passes{
        "Two passes",
        {words("1  along the rows"),
         quiet(
             "Each row of the source becomes a row of samples at whole pixels; between two texels that were "
             "drawn apart samples are interpolated."),
         words("2  along the columns"),
         quiet("Each column does the same with what the rows gave, so that two-dimensional resampling is "
               "one-dimensional twice.")}};
    PanePage page = pane_page(heading, {passes, window_block(view)}, 2,
                              {{"source", color_picture(source.color, source.coverage, output)},
                               {"after the rows", color_picture(color, coverage, output)},
                               {"their depth", depth_picture(depth, coverage)},
                               {"after the columns", colors_of(view, picture)}});
    page.stage.counts = {
        {"samples_of_the_rows",
         std::int64_t(std::count(coverage.pixels().begin(), coverage.pixels().end(), std::uint8_t{1}))},
        {"pixels", covered_pixels(picture)}};
    return std::move(page.stage);
}

StagePage draw_relief_columns(const ReliefView& view, const Heading& heading) {
    std::vector<Pane> panes;
    PanelBlock pixels{"Pixels drawn", {}};
    std::vector<Count> counts;
    const auto add = [&](Resampler resampler, const std::string& name) {
        const Prewarped picture = view.warped(view.settings_with(resampler));
        panes.push_back({name, colors_of(view, picture)});
        pixels.rows.push_back(pair(name, share(covered_pixels(picture), all_pixels(picture))));
        std::string count = name + "_pixels";
        std::replace(count.begin(), count.end(), '-', '_');
        counts.push_back({count, covered_pixels(picture)});
    };
    for (const Named& each : resamplers) add(each.resampler, each.name);
    add(Resampler::Mesh, "mesh");
    add(Resampler::Splat, "splat");
    const PanelBlock how{"Resamplers",
                         {words("one-dimensional"),
                          quiet("the displacement between two texels runs evenly; where a skin "
                                "bridges a step, straight edges bend"),
                          words("asymmetric"), quiet("a sample of a row knows the row that it goes to"),
                          words("compensated"), quiet("its displacement is chosen so that it gets there"),
                          words("interleaved"), quiet("it goes there at once: one pass"),
                          words("mesh, splat"), quiet("triangles with a z-buffer; one pixel a texel")}};
    PanePage page = pane_page(heading, {pixels, how}, 3, panes);
    page.stage.counts = std::move(counts);
    return std::move(page.stage);
}

StagePage draw_relief_against_mesh(const ReliefView& view, const Heading& heading) {
    const relief::ViewImage mesh = as_view(view.warped(view.settings_with(Resampler::Mesh)));
    std::vector<Pane> panes;
    std::vector<PanelBlock> blocks;
    StagePage counted;
    for (const Named& each : resamplers) {
        const relief::ViewImage picture = as_view(view.warped(view.settings_with(each.resampler)));
        panes.push_back({each.name, difference_picture(picture, mesh)});
        const relief::ErrorSet error = error_set(picture, mesh);
        blocks.push_back({each.name,
                          {pair("PSNR", decimals(error.psnr, 2) + " dB"),
                           pair("missing, extra", decimals(error.missing_percent, 2) + ", " +
                                                      decimals(error.extra_percent, 2) + " %"),
                           pair("depth, mean", number(error.mean_depth_error))}});
        std::string name = each.name;
        std::replace(name.begin(), name.end(), '-', '_');
        add_counts(counted, name, error);
    }
    blocks.push_back(
        {"Legend",
         {ramp(night, paper, "equal", "0.25 apart"), sample(Row::Square, orange, "only the resampler draws"),
          sample(Row::Square, sky, "only the mesh draws")}});
    PanePage page = pane_page(heading, blocks, 2, panes);
    page.stage.counts = std::move(counted.counts);
    return std::move(page.stage);
}

StagePage draw_relief_kinds(const ReliefView& view, const Heading& heading) {
    const Prewarped& picture = view.picture;
    const int width = picture.window.width, height = picture.window.height;
    Picture kinds(width, height), writes(width, height);
    std::array<std::int64_t, 4> of_kind{};
    std::int64_t painted = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const relief::Kind kind = picture.kind.at(x, y);
            const std::size_t times = picture.writes.at(x, y);
            ++of_kind[static_cast<std::size_t>(kind)], painted += static_cast<std::int64_t>(times);
            kinds.at(x, y) = picture.coverage.at(x, y) ? kind_color(kind) : empty_pixel(x, y, width);
            writes.at(x, y) = times == 0 ? empty_pixel(x, y, width)
                                         : writes_colors[std::min(times, std::size(writes_colors) - 1)];
        }
    const std::int64_t drawn = covered_pixels(picture);
    const auto row = [&](relief::Kind kind, const std::string& name) {
        return sample(Row::Square, kind_color(kind), name,
                      grouped(of_kind[static_cast<std::size_t>(kind)]) + " px");
    };
    const PanelBlock from{
        "Where pixels come from",
        {row(relief::Kind::Sampled, "a texel is there"), row(relief::Kind::Filled, "between neighbours"),
         row(relief::Kind::FilledAcross, "skin over a jump"),
         sample(Row::Square, night, "nothing (stripes)")}};
    PanelBlock often{"Painted", {}};
    constexpr const char* names[] = {"", "once", "twice", "3 times", "4 times", "5 times or more"};
    for (std::size_t i = 1; i < std::size(writes_colors); ++i)
        often.rows.push_back(sample(Row::Square, writes_colors[i], names[i]));
    often.rows.push_back(
        pair("a pixel, mean", drawn ? decimals(double(painted) / double(drawn), 2) + " times" : "none"));
    PanePage page = pane_page(
        heading, {from, often, window_block(view)}, 2,
        {{std::string(scene::name_of(view.object->settings.prewarp.resampler, scene::resamplers)), kinds},
         {"times painted", writes}});
    page.stage.counts = {{"sampled", of_kind[1]},
                         {"filled", of_kind[2]},
                         {"filled_across", of_kind[3]},
                         {"paintings", painted}};
    return std::move(page.stage);
}

StagePage draw_relief_disorder(const ReliefView& view, const Heading& heading) {
    relief::PrewarpSettings settings = view.settings_with(Resampler::Splat);
    const Prewarped right = view.warped(settings);
    settings.painting = relief::Painting::Reversed;
    const Prewarped wrong = view.warped(settings);
    settings.depth_test = true;
    const Prewarped nearest = view.warped(settings);
    const glm::dvec3& texel = view.texture().camera.a;
    const auto two_texels = static_cast<relief::Scalar>(2 * std::sqrt(glm::dot(texel, texel)));
    const auto differ = [&](const Prewarped& picture, Picture* mark) {
        std::int64_t count = 0;
        for (int y = 0; y < picture.window.height; ++y)
            for (int x = 0; x < picture.window.width; ++x) {
                const bool off = picture.coverage.at(x, y) != 0 &&
                                 picture.depth.at(x, y) > nearest.depth.at(x, y) + two_texels;
                count += off;
                if (mark && off) mark->at(x, y) = vermilion;
            }
        return count;
    };
    Picture marked(wrong.window.width, wrong.window.height);
    for (int y = 0; y < marked.height(); ++y)
        for (int x = 0; x < marked.width(); ++x)
            marked.at(x, y) =
                wrong.coverage.at(x, y) ? Rgba8{214, 222, 230} : empty_pixel(x, y, marked.width());
    const std::int64_t all = covered_pixels(nearest), wrong_count = differ(wrong, &marked),
                       right_count = differ(right, nullptr);
    const PanelBlock numbers{
        "Pixels that show what is hidden",
        {pair("right order", share(right_count, all)), pair("wrong order", share(wrong_count, all)),
         pair("with a z-buffer", "none"),
         quiet("Each texel paints one pixel, so that nothing but the order counts. Neighbours that round to "
               "one pixel hide each other in any order: a pixel is wrong when it shows what lies more than "
               "two texels deeper than the nearest."),
         sample(Row::Square, vermilion, "wrong in the wrong order")}};
    PanePage page = pane_page(heading, {numbers}, 2,
                              {{"right order", colors_of(view, right)},
                               {"wrong order", colors_of(view, wrong)},
                               {"with a z-buffer", colors_of(view, nearest)},
                               {"what is wrong", marked}});
    page.stage.counts = {{"pixels", all},
                         {"wrong_in_the_right_order", right_count},
                         {"wrong_in_the_wrong_order", wrong_count}};
    return std::move(page.stage);
}

StagePage draw_relief_map(const ReliefView& view, const Heading& heading) {
    const Prewarped& picture = view.picture;
    const relief::ReliefTexture& source = view.texture();
    const int width = picture.window.width, height = picture.window.height;
    Picture places(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const relief::Vec2 from = picture.source.at(x, y);
            places.at(x, y) = picture.coverage.at(x, y)
                                  ? Rgba8{level(double{from.x} / source.camera.width),
                                          level(double{from.y} / source.camera.height), 90}
                                  : empty_pixel(x, y, width);
        }
    const relief::Reading reading = view.object->settings.reading;
    const relief::Scalar jump = view.relief.jump_depth();
    relief::ViewImage fetched = as_view(picture), direct = fetched;
    fetched.color = fetch_by_map(picture, source, source.color, reading, jump);
    const auto normal = fetch_by_map(picture, source, source.normal, reading, jump);
    const relief::ErrorSet error = error_set(fetched, direct);
    const raster::Output output = view.loaded->settings.output;
    const PanelBlock how{
        "One map, many channels",
        {quiet("The warp finds for each pixel the place in the texture that it shows. Colour, normal, gloss "
               "or a reflection are fetched there, each with one reading."),
         ramp({0, 90, 90}, {255, 90, 90}, "u = 0", fmt::format("{}", source.camera.width)),
         ramp({90, 0, 90}, {90, 255, 90}, "v = 0", fmt::format("{}", source.camera.height))}};
    PanePage page = pane_page(heading, {how, error_block("Fetched against warped", error)}, 2,
                              {{"the map of sources", places},
                               {"colour by the map", color_picture(fetched.color, fetched.coverage, output)},
                               {"normal by the map", normal_picture(normal, fetched.coverage)},
                               {"against the warp", difference_picture(fetched, direct)}});
    add_counts(page.stage, "fetched", error);
    return std::move(page.stage);
}

StagePage draw_relief_carrier(const ReliefView& view, const Heading& heading) {
    const relief::ReliefCamera& source = view.texture().camera;
    const relief::Window& window = view.window;
    const raster::Output output = view.loaded->settings.output;
    const Picture screen = color_picture(view.seen.color, view.seen.coverage, output);
    PanelBlock legend{
        "Legend",
        {sample(Row::Line, orange, "the source's square"), sample(Row::Line, sky, "the target window"),
         quiet("Both lie on the source's plane. The machine draws the window as a textured "
               "polygon; the depth of each pixel is that of what it shows, not the plane's.")}};
    PanelBlock plane{
        "Plane",
        {pair("viewer to plane", number(view.warp.h)), pair("corner", ""),
         words("  " + triple(source.corner)), pair("facing", ""), words("  " + triple(-forward(source)))}};
    PanePage page = pane_page(heading, {plane, window_block(view), legend}, 2,
                              {{"warped", colors_of(view, view.picture)}, {"on its plane", screen}});
    const Canvas canvas = canvas_of(page.stage.picture);
    const auto rectangle = [&](int pane, auto&& place, double x0, double y0, double x1, double y1,
                               Rgba8 color) {
        const Rect rect = page.rects[static_cast<std::size_t>(pane)];
        const double corners[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
        Spot spots[4];
        for (int i = 0; i < 4; ++i) {
            const glm::dvec2 p = place(corners[i][0], corners[i][1]);
            spots[i] = page.scales[static_cast<std::size_t>(pane)].spot(rect, p.x, p.y);
        }
        path(within(canvas, rect), spots, {color, 2.5}, true);
    };
    const glm::dmat3 screen_from_plane = plane_homography(source, view.screen);
    const auto on_window = [&](double u, double v) { return glm::dvec2(u - window.x0, v - window.y0); };
    const auto on_screen = [&](double u, double v) {
        const glm::dvec3 p = screen_from_plane * glm::dvec3(u, v, 1);
        return p.z > 0 ? glm::dvec2(p.x / p.z, p.y / p.z) : glm::dvec2(std::nan(""), 0);
    };
    const double x1 = window.x0 + window.width, y1 = window.y0 + window.height;
    rectangle(0, on_window, 0, 0, source.width, source.height, orange);
    rectangle(1, on_screen, window.x0, window.y0, x1, y1, sky);
    rectangle(1, on_screen, 0, 0, source.width, source.height, orange);
    page.stage.counts = {{"window_width", std::int64_t(window.width)},
                         {"window_height", std::int64_t(window.height)},
                         {"viewer_to_plane", view.warp.h}};
    return std::move(page.stage);
}

}  // namespace relevo::show
