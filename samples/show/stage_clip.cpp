// The pictures of clip space, of clipping, and of normalized device coordinates.
#include <fmt/format.h>

#include <glm/common.hpp>

#include "samples/show/census.hpp"
#include "samples/show/numbers.hpp"
#include "samples/show/stage.hpp"

namespace relevo::show {
namespace {

using Kind = PanelRow::Kind;
constexpr Rgba8 inside_color = blue, crossing_color = orange, outside_color = vermilion;

std::int64_t total(const Census& census, Fate fate) { return census.total[static_cast<std::size_t>(fate)]; }

std::vector<Count> census_counts(const Census& census) {
    std::vector<Count> counts{{"inside", total(census, Fate::Inside)},
                              {"crossing", total(census, Fate::Crossing)},
                              {"outside", total(census, Fate::Outside)},
                              {"not_finite", total(census, Fate::NotFinite)}};
    constexpr std::array<const char*, 6> names{"near", "far", "left", "right", "bottom", "top"};
    for (std::size_t k = 0; k < 6; ++k) {
        counts.push_back({fmt::format("crossing_{}", names[k]), census.planes[k].triangles[1]});
        counts.push_back({fmt::format("outside_{}", names[k]), census.planes[k].triangles[2]});
    }
    return counts;
}

// ---- clip ----

PanelBlock plane_table(const Census& census) {
    PanelBlock table{"Triangles at each plane",
                     {quiet(fmt::format("{:<11}{:>7}{:>7}{:>7}", "", "in", "cross", "out"))}};
    table.rows.back().kind = Kind::Pair;
    for (const PlaneCensus& plane : census.planes)
        table.rows.push_back(pair(fmt::format("{:<11}{:>7}{:>7}{:>7}", plane.name, plane.triangles[0],
                                              plane.triangles[1], plane.triangles[2]),
                                  ""));
    return table;
}

// Where the four clip coordinates stand in a flat drawing: across is x or y; up is w, or z when w is
// always 1.
struct ClipView {
    int across;
    bool parallel;
    glm::dvec3 place(const glm::dvec4& p) const { return {p[across], parallel ? p.z : p.w, 0}; }
};

Box clip_box(const Capture& capture, ClipView flat) {
    Box box;
    for (std::size_t m = 0; m < capture.scene().models.size(); ++m)
        for (const SeenVertex& v : capture.vertices(m)) box.add(flat.place(v.clip));
    if (flat.parallel) box.add({-1.2, 0, 0}), box.add({1.2, 1, 0});
    if (!flat.parallel) box.add({0, 0, 0});
    // The V of the view volume as far up as the corners and the far plane reach; what lies far beside it is
    // cut off.
    const double top = std::min(std::max(box.high.y, 1e-9), 1.2 * capture.loaded->camera.far);
    if (flat.parallel) return box;
    box.low = glm::max(box.low, glm::dvec3(-1.6 * top, -0.3 * top, 0));
    box.high = glm::min(box.high, glm::dvec3(1.6 * top, 1.25 * top, 0));
    box.add({-top, top, 0}), box.add({top, top, 0});
    return box;
}

void draw_volume(Canvas canvas, Rect area, const View& view, const Capture& capture, ClipView flat) {
    const std::string name = flat.across == 0 ? "x" : "y";
    const double reach = 4.0 * (area.width + area.height) / view.scale;
    const double near = capture.loaded->camera.near, far = std::min(capture.loaded->camera.far, reach);
    const double low = flat.parallel ? 0 : near, high = flat.parallel ? 1 : far;
    const auto at = [&](double side, double up) {
        return view.spot({flat.parallel ? side : side * up, up, 0});
    };
    const std::array<Spot, 4> volume{at(-1, low), at(-1, high), at(1, high), at(1, low)};
    polygon(canvas, volume, with_opacity(green, 26));
    for (const double side : {-1.0, 1.0})
        line(canvas, at(side, flat.parallel ? -reach : 0), at(side, flat.parallel ? reach : high),
             {green, 2});
    line(canvas, at(-1, low), at(1, low), {green, 3});
    if (flat.parallel || capture.loaded->camera.far < reach)
        line(canvas, at(-1, high), at(1, high), {green, 3});
    const double upper = view.center.y + (area.height / 2.0 - 74) / view.scale;
    const double text_at = flat.parallel ? upper : std::min(upper, 0.8 * high);
    const std::string w = flat.parallel ? "1" : "w";
    label(canvas, {at(-1, text_at).x - 10, at(-1, text_at).y}, name + " = -" + w, green, Align::Right);
    label(canvas, {at(1, text_at).x + 10, at(1, text_at).y}, name + " = " + w, green);
    const std::string near_name = flat.parallel ? (capture.reversed_depth() ? "far, z = 0" : "near, z = 0")
                                                : "near plane, w = " + number(near);
    if (flat.parallel)
        label(canvas, {at(0, low).x, at(0, low).y + 20}, near_name, green, Align::Middle);
    else
        label(canvas, {at(1, low).x + 34, at(1, low).y - 12}, near_name, green);
    if (flat.parallel || capture.loaded->camera.far < reach) {
        if (flat.parallel)
            label(canvas, {at(0, high).x, at(0, high).y - 16},
                  capture.reversed_depth() ? "near, z = 1" : "far, z = 1", green, Align::Middle);
        else
            label(canvas, {at(1, high).x + 12, at(1, high).y}, "far plane, w = " + number(high), green);
    }
}

// The edges of the triangles of one fate, a list a model.
std::vector<std::vector<Segment>> clip_wires(const Capture& capture, const Census& census, ClipView flat,
                                             Fate fate) {
    std::vector<std::vector<Segment>> wires(census.fates.size());
    for (std::size_t m = 0; m < census.fates.size(); ++m) {
        const std::vector<std::uint32_t>& i = capture.model(m).mesh->indices;
        const std::vector<SeenVertex>& v = capture.vertices(m);
        for (std::size_t t = 0; t < census.fates[m].size(); ++t)
            for (std::size_t k = 0; census.fates[m][t] == fate && k < 3; ++k)
                wires[m].push_back(
                    {flat.place(v[i[3 * t + k]].clip), flat.place(v[i[3 * t + (k + 1) % 3]].clip)});
        wires[m] = unique_segments(std::move(wires[m]));
    }
    return wires;
}

void draw_clip_view(Canvas canvas, Rect area, const Capture& capture, const Census& census, ClipView flat) {
    const View view = fitted(front_view(), clip_box(capture, flat), area, 50);
    const char* const across = flat.across == 0 ? "x" : "y";
    draw_flat_axes(canvas, view, area, 0, 1, {across, flat.parallel ? "z" : "w", ""});
    draw_volume(canvas, area, view, capture, flat);
    const auto draw_fate = [&](Fate fate, Rgba8 color, double dash, double factor) {
        for (const std::vector<Segment>& wire : clip_wires(capture, census, flat, fate)) {
            Stroke stroke = wire_stroke(view, wire, area, color);
            stroke.dash = dash, stroke.width *= factor;
            draw_wire(canvas, view, wire, stroke);
        }
    };
    draw_fate(Fate::Outside, outside_color, 5, 1);
    draw_fate(Fate::Inside, inside_color, 0, 1);
    draw_fate(Fate::Crossing, crossing_color, 0, 1.6);
    label(canvas, {area.x + 12.0, area.y + 18.0},
          fmt::format("{} and {}", across, flat.parallel ? "z (w is 1)" : "w"), ink);
}

}  // namespace

StagePage draw_clip(const Capture& capture, const Heading& heading) {
    const Census census = take_census(capture);
    PanelBlock fates{
        "Triangles",
        {sample(Kind::Line, inside_color, "inside all planes", grouped(total(census, Fate::Inside))),
         sample(Kind::Line, crossing_color, "crossing a plane", grouped(total(census, Fate::Crossing))),
         sample(Kind::Dashes, outside_color, "outside of one plane", grouped(total(census, Fate::Outside))),
         sample(Kind::Square, mixed(paper, green, 40), "the view volume")}};
    if (total(census, Fate::NotFinite) > 0)
        fates.rows.push_back(pair("not finite, dropped", grouped(total(census, Fate::NotFinite))));
    const PanelBlock note{"",
                          {quiet("The drawing cuts triangles only at near and far and at a guard band of 7 "
                                 "w; the picture's edge cuts the rest.")}};
    Page page =
        diagram_page(heading, {fates, plane_table(census),
                               matrix_block("Clip from eye", capture.scene().camera.clip_from_eye.m), note});
    const Canvas canvas = canvas_of(page.picture);
    for (int i = 0; i < 2; ++i) {
        const Rect area = cell(page.area, 0, 1, i, 2, 0);
        frame(canvas, area, rule);
        draw_clip_view(within(canvas, inset(area, 2)), inset(area, 2), capture, census,
                       {i, capture.scene().camera.parallel});
    }
    std::vector<Count> counts = census_counts(census);
    counts.insert(counts.begin(), {"triangles", capture.triangles()});
    return {std::move(page.picture), std::move(counts), {}, 1};
}

// ---- clipped ----
namespace {

// The edges of the polygons that were cut or not, a list a model.
std::vector<std::vector<Segment>> piece_wires(const std::vector<ClippedPiece>& pieces, bool cut) {
    std::vector<std::vector<Segment>> wires;
    for (const ClippedPiece& piece : pieces) {
        if (wires.size() <= piece.model) wires.resize(piece.model + 1);
        for (std::size_t i = 0; piece.cut == cut && i < piece.ndc.size(); ++i)
            wires[piece.model].push_back({piece.ndc[i], piece.ndc[(i + 1) % piece.ndc.size()]});
    }
    for (std::vector<Segment>& wire : wires) wire = unique_segments(std::move(wire));
    return wires;
}

void draw_pieces(Canvas canvas, const View& view, Rect area, const std::vector<ClippedPiece>& pieces) {
    for (const bool cut : {false, true})
        for (const std::vector<Segment>& wire : piece_wires(pieces, cut))
            draw_wire(canvas, view, wire, wire_stroke(view, wire, area, cut ? crossing_color : inside_color));
}

// The edges of the triangles before clipping, as far as they can be divided by w.
std::vector<Segment> uncut_wire(const Capture& capture, const Census& census) {
    std::vector<Segment> wire;
    for (std::size_t m = 0; m < census.fates.size(); ++m)
        for (std::size_t t = 0; t < census.fates[m].size(); ++t) {
            if (census.fates[m][t] == Fate::Inside || census.fates[m][t] == Fate::NotFinite) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::vector<std::uint32_t>& i = capture.model(m).mesh->indices;
                const glm::dvec4& a = capture.vertices(m)[i[3 * t + k]].clip;
                const glm::dvec4& b = capture.vertices(m)[i[3 * t + (k + 1) % 3]].clip;
                if (a.w > 0 && b.w > 0) wire.push_back({glm::dvec3(a) / a.w, glm::dvec3(b) / b.w});
            }
        }
    return unique_segments(std::move(wire));
}

struct ClippedTotals {
    std::int64_t kept = 0, cut = 0, made = 0, most_corners = 0;
};
ClippedTotals totals_of(const std::vector<ClippedPiece>& pieces) {
    ClippedTotals t;
    for (const ClippedPiece& piece : pieces) {
        ++(piece.cut ? t.cut : t.kept);
        t.made += std::count(piece.made.begin(), piece.made.end(), true);
        t.most_corners = std::max(t.most_corners, std::int64_t(piece.ndc.size()));
    }
    return t;
}

void draw_new_corners(Canvas canvas, const View& view, const std::vector<ClippedPiece>& pieces,
                      std::int64_t made) {
    const double radius = made > 2000 ? 2 : made > 200 ? 3.5 : 5;
    for (const ClippedPiece& piece : pieces)
        for (std::size_t i = 0; i < piece.ndc.size(); ++i)
            if (piece.made[i]) disc(canvas, view.spot(piece.ndc[i]), radius, ink);
}

}  // namespace

StagePage draw_clipped(const Capture& capture, const Heading& heading) {
    const Census census = take_census(capture);
    const std::vector<ClippedPiece> pieces = clip_to_view_volume(capture, census);
    const ClippedTotals totals = totals_of(pieces);
    const std::int64_t gone = capture.triangles() - totals.kept - totals.cut;
    const std::int64_t cut_away = total(census, Fate::Crossing) - totals.cut;
    const PanelBlock before{
        "Triangles before",
        {pair("all", grouped(capture.triangles())), pair("inside, kept as they are", grouped(totals.kept)),
         pair("cut by a plane", grouped(totals.cut)), pair("gone", grouped(gone)),
         quiet("Gone: beyond one plane, or crossing several and empty after the cuts (" + grouped(cut_away) +
               ").")}};
    const PanelBlock after{
        "Polygons after",
        {pair("all", grouped(std::int64_t(pieces.size()))), pair("new corners", grouped(totals.made)),
         pair("corners of the largest", grouped(totals.most_corners))}};
    const PanelBlock legend{
        "Legend",
        {sample(Kind::Line, inside_color, "kept as it is"), sample(Kind::Line, crossing_color, "cut"),
         sample(Kind::Dashes, haze, "what was cut away"), sample(Kind::Dot, ink, "new corner on a plane"),
         sample(Kind::Line, green, "x, y = ±1: picture's edge")}};
    const PanelBlock note{
        "How",
        {quiet("Polygon after polygon, plane after plane (Sutherland and Hodgman 1974), before the division "
               "by w. A new corner is weighted by both distances to the plane.")}};
    Page page = diagram_page(heading, {before, after, legend, note});
    const Rect area = inset(page.area, 2);
    const Canvas canvas = within(canvas_of(page.picture), area);
    Box box;
    box.add({-1, -1, 0}), box.add({1, 1, 0});
    const View view = fitted(front_view(), box, area, 90);
    draw_flat_axes(canvas, view, area, 0, 1, {"x / w", "y / w", ""});
    const std::vector<Segment> gone_wire = uncut_wire(capture, census);
    Stroke gone_stroke = wire_stroke(view, gone_wire, area, haze);
    gone_stroke.dash = 6;
    draw_wire(canvas, view, gone_wire, gone_stroke);
    const std::array<Spot, 4> volume{view.spot({-1, -1, 0}), view.spot({1, -1, 0}), view.spot({1, 1, 0}),
                                     view.spot({-1, 1, 0})};
    polygon(canvas, volume, with_opacity(paper, 150));
    const bool few = pieces.size() < 3000;
    for (const ClippedPiece& piece : pieces) {
        std::vector<Spot> spots;
        for (const glm::dvec3 p : piece.ndc) spots.push_back(view.spot(p));
        if (few)
            polygon(canvas, spots,
                    with_opacity(piece.cut ? crossing_color : inside_color, piece.cut ? 46 : 20));
    }
    draw_pieces(canvas, view, area, pieces);
    path(canvas, volume, {green, 3}, true);
    draw_new_corners(canvas, view, pieces, totals.made);
    if (pieces.empty()) say(canvas, area, "nothing is left: all triangles are outside of the view volume");
    return {std::move(page.picture),
            {{"triangles", capture.triangles()},
             {"kept", totals.kept},
             {"cut", totals.cut},
             {"gone", gone},
             {"polygons", std::int64_t(pieces.size())},
             {"new_corners", totals.made}},
            {},
            1};
}

// ---- ndc ----
namespace {

// The oblique view with near in front and depth stretched by `stretch`.
View ndc_view(bool reversed, double stretch) {
    View view = oblique_view();
    const double z = reversed ? stretch : -stretch;
    view.right.z *= z, view.up.z *= z, view.toward.z *= z;
    return view;
}

std::vector<PanelBlock> ndc_panel(const Box& used, bool reversed, bool two) {
    PanelBlock ranges{"Used part of the box", {quiet("none")}};
    if (!used.empty)
        ranges.rows = {pair("x", range(used.low.x, used.high.x)), pair("y", range(used.low.y, used.high.y)),
                       pair("z", range(used.low.z, used.high.z)),
                       pair("nearest z", number(reversed ? used.high.z : used.low.z)),
                       pair("farthest z", number(reversed ? used.low.z : used.high.z))};
    PanelBlock depth{
        "Depth",
        {pair("near plane", reversed ? "z = 1" : "z = 0"), pair("far plane", reversed ? "z = 0" : "z = 1"),
         quiet(reversed ? "Reversed: float numbers are finest near 0, where perspective crowds the distance."
                        : "Forward: perspective crowds the distance near 1.")}};
    if (two)
        depth.rows.push_back(quiet("The lower box shows the same, its depth stretched to the part in use."));
    return {{"Division",
             {words("x/w, y/w, z/w"),
              quiet("What is farther has a larger w and becomes smaller: this is the perspective.")}},
            ranges,
            depth,
            {"Legend",
             {sample(Kind::Line, inside_color, "triangle"),
              sample(Kind::Line, crossing_color, "polygon left by clipping"),
              sample(Kind::Line, haze, "edges of the box")}}};
}

void draw_ndc_box(Canvas canvas, Rect area, const View& unfitted, const Box& box,
                  const std::vector<ClippedPiece>& pieces, const std::string& title) {
    const View view = fitted(unfitted, box, area, 48);
    draw_axes(canvas, view, box, area.height > 500 ? 72 : 46);
    draw_pieces(canvas, view, area, pieces);
    label(canvas, {area.x + 12.0, area.y + 18.0}, title, ink);
}

}  // namespace

StagePage draw_ndc(const Capture& capture, const Heading& heading) {
    const std::vector<ClippedPiece> pieces = clip_to_view_volume(capture, take_census(capture));
    const bool reversed = capture.reversed_depth();
    Box used, whole;
    for (const ClippedPiece& piece : pieces)
        for (const glm::dvec3 p : piece.ndc) used.add(p);
    whole.add({-1, -1, 0}), whole.add({1, 1, 1});
    // Where depth is crowded, a second drawing stretches it.
    Box crowded = whole;
    crowded.low.z = used.low.z, crowded.high.z = used.high.z;
    const bool two = crowded.size().z > 1e-9 && crowded.size().z < 0.5;

    Page page = diagram_page(heading, ndc_panel(used, reversed, two));
    const Canvas canvas = canvas_of(page.picture);
    const Rect upper = cell(page.area, 0, 1, 0, two ? 2 : 1, 0), lower = cell(page.area, 0, 1, 1, 2, 0);
    frame(canvas, upper, rule);
    draw_ndc_box(within(canvas, inset(upper, 2)), inset(upper, 2), ndc_view(reversed, 1), whole, pieces,
                 "the whole box");
    if (two) {
        frame(canvas, lower, rule);
        draw_ndc_box(within(canvas, inset(lower, 2)), inset(lower, 2),
                     ndc_view(reversed, 1 / crowded.size().z), crowded, pieces,
                     "depth stretched: z from " + range(crowded.low.z, crowded.high.z));
    }
    if (pieces.empty()) say(canvas, upper, "nothing is left after clipping");
    std::vector<Count> counts{{"polygons", std::int64_t(pieces.size())}};
    if (!used.empty) counts.push_back({"z_low", used.low.z}), counts.push_back({"z_high", used.high.z});
    return {std::move(page.picture), std::move(counts), {}, 1};
}

}  // namespace relevo::show
