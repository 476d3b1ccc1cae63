// The pictures made of pixels: coverage, depth, attributes, and the shadings.
#include <fmt/format.h>

#include <map>

#include "samples/show/numbers.hpp"
#include "samples/show/panes.hpp"
#include "samples/show/stage.hpp"
#include "samples/show/tones.hpp"

namespace relevo::show {
namespace {

using Kind = PanelRow::Kind;
using raster::Scalar;

// A page round a rendered picture, each pixel as big as there is room, with a grid from 8 on.
StagePage picture_page(const Heading& heading, const std::vector<PanelBlock>& panel, const Picture& picture) {
    const int factor = std::max(1, std::min(diagram_width / picture.width(), 720 / picture.height()));
    const int width = picture.width() * factor, height = picture.height() * factor;
    Page page = lay_out(heading, panel, width, height);
    const Rect rect{page.area.x + (page.area.width - width) / 2, page.area.y, width, height};
    const Canvas canvas = canvas_of(page.picture);
    paste(canvas, picture, rect.x, rect.y, factor);
    if (factor >= 8) pixel_grid(canvas, rect, factor, with_opacity(haze, 110));
    frame(canvas, {rect.x - 1, rect.y - 1, rect.width + 2, rect.height + 2}, muted);
    return {std::move(page.picture), {}, rect, factor};
}

// Each pixel's colour by `paint(SeenPixel, x, y)`, stripes where there is nothing.
template <class Paint>
Picture painted(const Capture& capture, Paint&& paint) {
    const raster::Image<SeenPixel>& seen = capture.seen.pixels.pixels;
    Picture out(seen.width(), seen.height());
    for (int y = 0; y < seen.height(); ++y)
        for (int x = 0; x < seen.width(); ++x)
            out.at(x, y) =
                seen.at(x, y).empty() ? empty_pixel(x, y, seen.width()) : paint(seen.at(x, y), x, y);
    return out;
}

std::int64_t visible_pixels(const Capture& capture) {
    const auto& pixels = capture.seen.pixels.pixels.pixels();
    return std::count_if(pixels.begin(), pixels.end(), [](const SeenPixel& p) { return !p.empty(); });
}

}  // namespace

// ---- coverage ----

StagePage draw_coverage(const Capture& capture, const Heading& heading) {
    std::map<std::uint32_t, std::int64_t> area_of;  // pixels by triangle
    for (const SeenPixel& p : capture.seen.pixels.pixels.pixels())
        if (!p.empty()) ++area_of[p.primitive];
    std::vector<std::pair<std::int64_t, std::uint32_t>> largest;
    for (const auto& [primitive, area] : area_of) largest.push_back({-area, primitive});
    std::sort(largest.begin(), largest.end());
    const PixelProbe& seen = capture.seen.pixels;
    const std::int64_t all = std::int64_t(seen.pixels.width()) * seen.pixels.height(),
                       visible = visible_pixels(capture);
    const PanelBlock pixels{"Pixels",
                            {pair("in the picture", grouped(all)), pair("covered", share(visible, all)),
                             pair("empty", grouped(all - visible))}};
    const PanelBlock fragments{
        "Fragments",
        {pair("covered centres", grouped(seen.covered)),
         pair("a covered pixel has", number(visible == 0 ? 0 : double(seen.covered) / double(visible))),
         quiet("A fragment is one pixel of one triangle. Where triangles lie behind each other, a pixel has "
               "several.")}};
    PanelBlock triangles{"Triangles seen: " + grouped(std::int64_t(area_of.size())), {}};
    for (std::size_t i = 0; i < std::min<std::size_t>(largest.size(), 6); ++i)
        triangles.rows.push_back(sample(Kind::Square, color_of_number(largest[i].second),
                                        "number " + std::to_string(largest[i].second),
                                        grouped(-largest[i].first) + " px"));
    triangles.rows.push_back(sample(Kind::Square, night, "no triangle (stripes)"));
    const PanelBlock how{
        "",
        {quiet("On an edge that two triangles share, the top-left rule gives the pixel to exactly one.")}};
    StagePage stage = picture_page(
        heading, {pixels, fragments, triangles, how},
        painted(capture, [](const SeenPixel& p, int, int) { return color_of_number(p.primitive); }));
    if (visible == 0) say(canvas_of(stage.picture), stage.pixels, "no pixel is covered");
    stage.counts = {{"pixels", all},
                    {"covered_pixels", visible},
                    {"fragments", seen.covered},
                    {"triangles_seen", std::int64_t(area_of.size())}};
    return stage;
}

// ---- depth ----

StagePage draw_depth(const Capture& capture, const Heading& heading) {
    const raster::Image<SeenPixel>& seen = capture.seen.pixels.pixels;
    Range z;
    for (int y = 0; y < seen.height(); ++y)
        for (int x = 0; x < seen.width(); ++x)
            if (!seen.at(x, y).empty()) z.add(static_cast<double>(capture.depth.at(x, y)));
    const bool reversed = capture.reversed_depth();
    const double nearest = reversed ? z.high : z.low, farthest = reversed ? z.low : z.high;
    const PixelProbe& probe = capture.seen.pixels;
    const auto light = [&](double v) {
        return reversed ? z.share_of(v) : (z.high > z.low ? 1 - z.share_of(v) : 1);
    };
    const PanelBlock format{
        "Depth buffer",
        {pair("format", reversed ? "float32, reversed" : "float32, forward"),
         pair("near plane", reversed ? "1" : "0"), pair("far plane, empty", reversed ? "0" : "1")}};
    PanelBlock legend{"Legend", {}};
    if (!z.empty) {
        legend.rows = {pair("nearest pixel (light)", number(nearest)),
                       pair("farthest pixel (dark)", number(farthest)),
                       ramp(grey(0), grey(1), number(farthest), number(nearest))};
    }
    legend.rows.push_back(sample(Kind::Square, night, "empty (stripes)"));
    const PanelBlock test{
        "Depth test",
        {pair("tested", grouped(probe.covered)), pair("drawn", grouped(probe.passed)),
         pair("hidden, thrown away", grouped(probe.covered - probe.passed)),
         quiet(reversed ? "The larger number is nearer and wins." : "The smaller number is nearer and wins."),
         quiet("Of equal ones the triangle drawn first stays.")}};
    StagePage stage =
        picture_page(heading, {format, legend, test}, painted(capture, [&](const SeenPixel&, int x, int y) {
                         return grey(light(static_cast<double>(capture.depth.at(x, y))));
                     }));
    if (z.empty)
        say(canvas_of(stage.picture), stage.pixels,
            "no pixel is covered: the depth buffer is as it was cleared");
    stage.counts = {{"tested", probe.covered}, {"passed", probe.passed}};
    if (!z.empty)
        stage.counts.push_back({"nearest", nearest}), stage.counts.push_back({"farthest", farthest});
    return stage;
}

// ---- several pictures of the pixels on one page ----
namespace {

// Two pictures of the whole frame, above each other unless they are larger beside each other.
Panes panes_of(const Capture& capture, int columns, int rows) {
    return show::panes_of(capture.loaded->width, capture.loaded->height, columns, rows);
}
Panes two_panes_of(const Capture& capture) {
    const Panes above = panes_of(capture, 1, 2), beside = panes_of(capture, 2, 1);
    return beside.width > above.width ? beside : above;
}

}  // namespace

// ---- visibility ----
namespace {

// The pixels of a triangle that are seen.
struct SeenTriangle {
    std::int64_t pixels = 0, sum_x = 0, sum_y = 0;
};

// The triangle's number in the middle of its pixels, if there is room for it.
void write_number(const Canvas& canvas, const Rect& rect, const Panes& panes,
                  const raster::Image<std::uint32_t>& visible, std::uint32_t triangle,
                  const SeenTriangle& seen) {
    constexpr int margin = 4, height = 2 * letter_height;
    const std::string number = std::to_string(triangle);
    const int width = text_width(number);
    const auto on_page = [&](std::int64_t sum) {  // of the mean pixel's centre
        return static_cast<int>((2 * sum + seen.pixels) * panes.factor / (2 * seen.pixels * panes.divisor));
    };
    const int left = on_page(seen.sum_x) - width / 2, top = on_page(seen.sum_y) - height / 2;
    const auto pixel = [&](int at) { return at * panes.divisor / panes.factor; };
    for (int y = top - margin; y <= top + height + margin; ++y)
        for (int x = left - margin; x <= left + width + margin; ++x)
            if (x < 0 || y < 0 || !visible.holds(pixel(x), pixel(y)) ||
                visible.at(pixel(x), pixel(y)) != triangle)
                return;
    const Rgba8 c = color_of_number(triangle);
    text(canvas, rect.x + left, rect.y + top, number, 2 * c.r + 5 * c.g + c.b > 8 * 120 ? night : paper);
}

constexpr std::array<Rgba8, 5> times_colors{{{214, 222, 230}, yellow, orange, vermilion, purple}};
std::size_t times_index(const SeenPixel& p) {
    return std::min(static_cast<std::size_t>(p.times_shaded), times_colors.size()) - 1;
}

}  // namespace

StagePage draw_visibility(const Capture& capture, const Heading& heading) {
    const raster::Image<std::uint32_t>& visible = capture.visible;
    const PixelProbe& probe = capture.seen.pixels;
    std::map<std::uint32_t, SeenTriangle> triangles;
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x)
            if (visible.at(x, y) != SeenPixel::nothing) {
                SeenTriangle& seen = triangles[visible.at(x, y)];
                ++seen.pixels, seen.sum_x += x, seen.sum_y += y;
            }
    std::int64_t pixels = 0;
    auto most = triangles.begin(), fewest = triangles.begin();
    for (auto it = triangles.begin(); it != triangles.end(); ++it) {
        pixels += it->second.pixels;
        if (it->second.pixels > most->second.pixels) most = it;
        if (it->second.pixels < fewest->second.pixels) fewest = it;
    }
    const double overdraw = pixels == 0 ? 0 : double(probe.passed) / double(pixels);

    PanelBlock buffer{"Visibility buffer",
                      {pair("triangles in the scene", grouped(capture.triangles())),
                       pair("triangles seen", grouped(std::int64_t(triangles.size())))}};
    const auto row = [&](const std::string& word, const auto& it) {
        buffer.rows.push_back(sample(Kind::Square, color_of_number(it->first),
                                     fmt::format("{}: number {}", word, it->first),
                                     grouped(it->second.pixels) + " px"));
    };
    if (pixels > 0) row("most", most), row("fewest", fewest);
    buffer.rows.push_back(sample(Kind::Square, night, "no triangle (stripes)"));
    const PanelBlock shading{
        "Pixels shaded",
        {pair("textbook path", grouped(probe.passed)), pair("fast path", grouped(pixels)),
         pair("overdraw", pixels == 0 ? "none" : number(overdraw) + " ×"),
         quiet("The textbook path shades whatever passes the depth test, even if a nearer triangle comes "
               "later. The fast path tests all depths first and shades what is left: the same bytes.")}};
    std::array<std::int64_t, times_colors.size()> times{};
    for (const SeenPixel& p : probe.pixels.pixels())
        if (!p.empty()) ++times[times_index(p)];
    PanelBlock often{"Times shaded (textbook path)", {}};
    constexpr std::array<const char*, times_colors.size()> words{"once", "twice", "3 times", "4 times",
                                                                 "5 times or more"};
    for (std::size_t i = 0; i < times.size(); ++i)
        if (times[i] > 0)
            often.rows.push_back(sample(Kind::Square, times_colors[i], words[i], grouped(times[i]) + " px"));
    if (often.rows.empty()) often.rows.push_back(quiet("No pixel is covered."));
    const Panes panes = two_panes_of(capture);
    say_what_is_shown(panes, often);

    Page page = lay_out(heading, {buffer, shading, often}, panes);
    const Canvas canvas = canvas_of(page.picture);
    const Rect numbers = paste_pane(
        page, panes, 0, "triangle numbers",
        painted(capture, [&](const SeenPixel&, int x, int y) { return color_of_number(visible.at(x, y)); }));
    for (const auto& [triangle, seen] : triangles)
        write_number(within(canvas, numbers), numbers, panes, visible, triangle, seen);
    const Rect heat = paste_pane(
        page, panes, 1, "times shaded",
        painted(capture, [&](const SeenPixel& p, int, int) { return times_colors[times_index(p)]; }));
    if (pixels == 0) say(canvas, numbers, "no pixel is covered"), say(canvas, heat, "no pixel is covered");
    std::vector<Count> counts{{"triangles_seen", std::int64_t(triangles.size())},
                              {"visible_pixels", pixels},
                              {"textbook_shaded", probe.passed}};
    if (pixels > 0) {
        counts.push_back({"most_pixels", most->second.pixels});
        counts.push_back({"fewest_pixels", fewest->second.pixels});
        counts.push_back({"overdraw", overdraw});
    }
    return {std::move(page.picture), std::move(counts), {}, 1};
}

// ---- attributes ----
namespace {

Rgba8 weight_color(const SeenPixel& p) {
    return {level(double(p.weights[0])), level(double(p.weights[1])), level(double(p.weights[2]))};
}

Rgba8 normal_color(const SeenPixel& p) {
    const double x = double(p.normal[0]), y = double(p.normal[1]), z = double(p.normal[2]),
                 length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0) || !std::isfinite(length)) return {128, 128, 128};
    return {level(0.5 + 0.5 * x / length), level(0.5 + 0.5 * y / length), level(0.5 + 0.5 * z / length)};
}

// u in red, v in green, over a board of eight fields a unit.
Rgba8 uv_color(const SeenPixel& p) {
    if (!p.textured) return {112, 118, 126};
    const double u = double(p.uv[0]) - std::floor(double(p.uv[0])),
                 v = double(p.uv[1]) - std::floor(double(p.uv[1]));
    const bool dark = (static_cast<int>(u * 8) + static_cast<int>(v * 8)) % 2 != 0;
    const double k = dark ? 0.72 : 1;
    return {level(k * (0.15 + 0.85 * u)), level(k * (0.15 + 0.85 * v)), level(k * 0.4)};
}

struct AttributeRanges {
    std::array<Range, 3> weight, normal;
    Range u, v, inv_w;
    std::int64_t textured = 0;
};
AttributeRanges attribute_ranges(const Capture& capture) {
    AttributeRanges r;
    for (const SeenPixel& p : capture.seen.pixels.pixels.pixels()) {
        if (p.empty()) continue;
        for (std::size_t k = 0; k < 3; ++k)
            r.weight[k].add(double(p.weights[k])), r.normal[k].add(double(p.normal[k]));
        r.inv_w.add(double(p.inv_w));
        if (p.textured) r.u.add(double(p.uv[0])), r.v.add(double(p.uv[1])), ++r.textured;
    }
    return r;
}

}  // namespace

StagePage draw_attributes(const Capture& capture, const Heading& heading) {
    const AttributeRanges r = attribute_ranges(capture);
    const bool parallel = capture.scene().camera.parallel;
    const PanelBlock weights{"Weights of the corners",
                             {sample(Kind::Square, {255, 0, 0}, "corner 0", r.weight[0].text()),
                              sample(Kind::Square, {0, 255, 0}, "corner 1", r.weight[1].text()),
                              sample(Kind::Square, {0, 0, 255}, "corner 2", r.weight[2].text())}};
    const PanelBlock normals{"Normals in eye space",
                             {sample(Kind::Square, {255, 128, 128}, "x: right", r.normal[0].text()),
                              sample(Kind::Square, {128, 255, 128}, "y: up", r.normal[1].text()),
                              sample(Kind::Square, {128, 128, 255}, "z: nearer", r.normal[2].text())}};
    PanelBlock uv{"Texture coordinates", {}};
    if (r.textured > 0)
        uv.rows = {sample(Kind::Square, {255, 38, 102}, "u", r.u.text()),
                   sample(Kind::Square, {38, 255, 102}, "v", r.v.text()), quiet("8 × 8 fields a texture.")};
    else
        uv.rows = {quiet("None are carried: no texture is seen in this scene.")};
    PanelBlock inv_w{
        "1 / w",
        {ramp(grey(0), grey(1), number(r.inv_w.low), number(r.inv_w.high)),
         quiet(parallel ? "1 everywhere: the projection is parallel."
                        : "Linear in the window; dividing by it makes the others right in perspective.")}};

    const Panes panes = panes_of(capture, 2, 2);
    say_what_is_shown(panes, inv_w);
    Page page = lay_out(heading, {weights, normals, uv, inv_w}, panes);
    const std::array<std::string, 4> titles{"weights", "normals", "u, v", "1/w"};
    const std::array<Picture, 4> pictures{
        painted(capture, [](const SeenPixel& p, int, int) { return weight_color(p); }),
        painted(capture, [](const SeenPixel& p, int, int) { return normal_color(p); }),
        painted(capture, [](const SeenPixel& p, int, int) { return uv_color(p); }),
        painted(capture,
                [&](const SeenPixel& p, int, int) { return grey(r.inv_w.share_of(double(p.inv_w))); })};
    for (int i = 0; i < 4; ++i) {
        const Rect rect = paste_pane(page, panes, i, titles[std::size_t(i)], pictures[std::size_t(i)]);
        if (r.inv_w.empty)
            say(canvas_of(page.picture), rect, "no pixel is covered");
        else if (i == 2 && r.textured == 0)
            say(canvas_of(page.picture), rect, "no texture in this scene", true);
    }
    std::vector<Count> counts{{"covered_pixels", visible_pixels(capture)}, {"textured_pixels", r.textured}};
    if (!r.inv_w.empty)
        counts.push_back({"inv_w_low", r.inv_w.low}), counts.push_back({"inv_w_high", r.inv_w.high});
    return {std::move(page.picture), std::move(counts), {}, 1};
}

// ---- shadings ----
namespace {

PanelBlock work_block(const Capture& capture, raster::Shading chosen) {
    const GeometryProbe& geometry = capture.seen.geometry;
    std::int64_t faces = 0;
    for (const SeenFace& face : geometry.faces) faces += !face.culled;
    faces -= geometry.rejected[static_cast<std::size_t>(raster::Rejection::NoPixel)];
    const auto row = [&](raster::Shading shading, const std::string& name, std::int64_t count) {
        return pair((shading == chosen ? "→ " : "  ") + name, grouped(count));
    };
    return {"Light calculations",
            {row(raster::Shading::Flat, "flat: a face", faces),
             row(raster::Shading::Gouraud, "Gouraud: a vertex", capture.vertices()),
             row(raster::Shading::Phong, "Phong: a drawn pixel", capture.seen.pixels.passed)}};
}

PanelBlock material_block(const Capture& capture) {
    PanelBlock block{"Material", {}};
    if (capture.scene().models.empty()) return block;
    const pipeline::Material& m = capture.model(0).material;
    block.title = shortened("Material: " + model_name(*capture.loaded, 0, 40), panel_columns);
    block.rows = {pair("ambient", number(double(m.ambient))), pair("diffuse", number(double(m.diffuse))),
                  pair("specular", number(double(m.specular))),
                  pair("shininess", number(double(m.shininess))),
                  pair("lights", std::to_string(capture.scene().lights.size()))};
    return block;
}

StagePage draw_shading(const Capture& capture, const Heading& heading, raster::Shading shading,
                       std::vector<PanelBlock> panel) {
    if (visible_pixels(capture) == 0)
        panel.push_back({"", {words("No pixel is covered: only the background is seen.")}});
    StagePage stage = picture_page(heading, panel, drawn_picture(*capture.loaded, shading));
    stage.counts = {{"drawn_fragments", capture.seen.pixels.passed},
                    {"covered_pixels", visible_pixels(capture)}};
    return stage;
}

std::string shading_name(raster::Shading shading) {
    switch (shading) {
        case raster::Shading::Unlit:
            return "unlit";
        case raster::Shading::Flat:
            return "flat";
        case raster::Shading::Gouraud:
            return "Gouraud";
        case raster::Shading::Phong:
            return "Phong";
    }
    return "";
}

}  // namespace

StagePage draw_flat(const Capture& capture, const Heading& heading) {
    return draw_shading(capture, heading, raster::Shading::Flat,
                        {work_block(capture, raster::Shading::Flat),
                         material_block(capture),
                         {"Look for",
                          {quiet("Every facet has one colour, and its edges are seen: the eye finds even "
                                 "small steps of brightness (Mach bands).")}}});
}
StagePage draw_gouraud(const Capture& capture, const Heading& heading) {
    return draw_shading(capture, heading, raster::Shading::Gouraud,
                        {work_block(capture, raster::Shading::Gouraud),
                         material_block(capture),
                         {"Look for",
                          {quiet("Highlights in the middle of large triangles are missed, and small ones "
                                 "turn into stars: colours are only known at the corners.")}}});
}
StagePage draw_phong(const Capture& capture, const Heading& heading) {
    return draw_shading(
        capture, heading, raster::Shading::Phong,
        {work_block(capture, raster::Shading::Phong),
         material_block(capture),
         {"Look for",
          {quiet("Highlights are round and in their place; only the outline still shows the triangles.")}}});
}

StagePage draw_texture(const Capture& capture, const Heading& heading) {
    const std::vector<raster::Model>& models = capture.scene().models;
    PanelBlock textures{"Textures", {}};
    std::int64_t textured = 0;
    for (std::size_t m = 0; m < models.size(); ++m) {
        if (models[m].texture == nullptr) continue;
        if (++textured > 5) continue;
        const bool named = m < capture.loaded->descriptions.size();
        textures.rows.push_back(
            words(named ? shortened(capture.loaded->descriptions[m].texture, panel_columns) : "texture"));
        textures.rows.push_back(
            pair("  of " + model_name(*capture.loaded, m, 14),
                 fmt::format("{} × {}", models[m].texture->width, models[m].texture->height)));
    }
    if (textured > 5) textures.rows.push_back(quiet(fmt::format("and {} more", textured - 5)));
    if (textured == 0) textures.rows.push_back(quiet("None: every surface shows its material's colour."));
    const bool bilinear = capture.loaded->settings.texture_filter == raster::Filter::Bilinear;
    const PanelBlock filter{"Filter",
                            {pair("setting", bilinear ? "bilinear" : "nearest"),
                             quiet(bilinear ? "The four texels round the place are mixed by their distance."
                                            : "The texel at the place is taken as it is.")}};
    StagePage stage = draw_shading(capture, heading, raster::Shading::Unlit, {textures, filter});
    if (textured == 0 && visible_pixels(capture) > 0)
        say(canvas_of(stage.picture), stage.pixels, "no texture in this scene", true);
    stage.counts.push_back({"textured_models", textured});
    return stage;
}

StagePage draw_final(const Capture& capture, const Heading& heading) {
    const raster::Settings& s = capture.loaded->settings;
    const PixelProbe& seen = capture.seen.pixels;
    const PanelBlock settings{
        "Settings",
        {pair("shading", shading_name(s.shading)),
         pair("texture filter", s.texture_filter == raster::Filter::Bilinear ? "bilinear" : "nearest"),
         pair("depth", capture.reversed_depth() ? "float32, reversed" : "float32, forward"),
         pair("cull", s.cull == pipeline::Cull::Back    ? "back"
                      : s.cull == pipeline::Cull::Front ? "front"
                                                        : "none"),
         pair("output", s.output == raster::Output::Srgb ? "sRGB" : "raw")}};
    const PanelBlock way{"The way here",
                         {pair("triangles", grouped(capture.triangles())),
                          pair("in the window", grouped(std::int64_t(capture.seen.geometry.faces.size()))),
                          pair("fragments", grouped(seen.covered)), pair("drawn", grouped(seen.passed)),
                          pair("pixels", grouped(visible_pixels(capture)))}};
    return draw_shading(capture, heading, s.shading, {settings, way});
}

}  // namespace relevo::show
