#include "samples/show/relief_stages.hpp"

#include <fmt/format.h>

#include "samples/show/numbers.hpp"

namespace relevo::show {
namespace {

constexpr ReliefStageInfo all_stages[] = {
    {"relief-source",
     "The relief texture: a picture of the object whose texels know their depth behind the picture's plane.",
     draw_relief_source},
    {"relief-bits", "The depth in 8 bits: 255 equal steps, and how far each texel is off.",
     draw_relief_quantized},
    {"relief-order",
     "The order in which texels are painted, dark to light: the nearer one of two that meet comes last.",
     draw_relief_order},
    {"relief-field", "How far each texel must move on the plane, so that the flat picture looks deep.",
     draw_relief_field},
    {"relief-rows", "The first pass moves texels along their rows and fills the gaps between them.",
     draw_relief_rows},
    {"relief-columns", "The second pass moves them along the columns: four ways, and two to compare with.",
     draw_relief_columns},
    {"relief-mesh",
     "What each resampler does differently from a mesh of triangles with a z-buffer, four times as bright.",
     draw_relief_against_mesh},
    {"relief-kinds", "Where the warped pixels come from, and how often each of them was painted.",
     draw_relief_kinds},
    {"relief-disorder", "The same texels painted in the wrong order: what lies behind shows through.",
     draw_relief_disorder},
    {"relief-map",
     "The map of sources: where in the texture each pixel comes from. Any channel can be fetched by it.",
     draw_relief_map},
    {"relief-carrier", "The warped picture is a texture on the source's plane, which stands in the scene.",
     draw_relief_carrier},
    {"final", "The finished picture, exactly as `relevo render` writes it.", draw_relief_final},
    {"relief-truth", "The object itself, seen by the same viewer.", draw_relief_truth},
    {"relief-error", "How far the warped picture is from the truth.", draw_relief_error},
    {"relief-depth",
     "The depth that the relief leaves in the depth buffer decides what it hides, and what hides it.",
     draw_relief_depth},
    {"relief-inverse",
     "The other way round: each pixel searches its line of sight in the texture, in more and more slices.",
     draw_relief_inverse},
    {"relief-solid", "How far an object goes on behind its surface: without an end it is drawn out.",
     draw_relief_solid},
    {"relief-shadow", "The shadow that the object casts on itself: a second search goes towards the light.",
     draw_relief_shadow},
    {"relief-faces", "Six relief textures round the object: one viewer sees parts of several.",
     draw_relief_faces},
    {"relief-morph",
     "Two views of the object, and the view between them: pixels wander from one to the other.",
     draw_relief_morph},
};

}  // namespace

std::span<const ReliefStageInfo> relief_stages() { return all_stages; }

StagePage draw_stage(const ReliefView& view, const ReliefStageInfo& stage, const Heading& heading) {
    const bool needs_no_warp = stage.draw == draw_relief_final;
    if (view.problem.empty() || needs_no_warp) return stage.draw(view, heading);
    Page page = diagram_page(heading, {{"Object", {pair("name", shortened(view.object->name, 20))}}});
    say(canvas_of(page.picture), page.area, view.problem);
    return {std::move(page.picture), {{"shown", std::int64_t{0}}}, {}, 1};
}

PanePage pane_page(const Heading& heading, std::vector<PanelBlock> panel, int columns,
                   const std::vector<Pane>& pictures) {
    int width = 1, height = 1;
    for (const Pane& pane : pictures) {
        width = std::max(width, pane.picture.width());
        height = std::max(height, pane.picture.height());
    }
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    constexpr int widest_row = 1200;
    const Panes panes = panes_of(width, height, columns, rows, rows == 1 ? widest_row : diagram_width);
    if (!panel.empty()) say_what_is_shown(panes, panel.back());
    Page page = lay_out(heading, panel, panes);
    std::vector<Rect> rects;
    std::vector<Scale> scales;
    for (const Pane& pane : pictures) {
        rects.push_back(paste_pane(page, panes, static_cast<int>(rects.size()), pane.title, pane.picture));
        scales.push_back(panes.scale_of(pane.picture.width(), pane.picture.height()));
    }
    return {{std::move(page.picture), {}, {}, 1}, std::move(rects), std::move(scales)};
}

PanelBlock error_block(const std::string& title, const relief::ErrorSet& error) {
    return {
        title,
        {pair("missing", decimals(error.missing_percent) + " %"),
         pair("extra", decimals(error.extra_percent) + " %"), pair("PSNR", decimals(error.psnr, 2) + " dB"),
         pair("depth, mean error", number(error.mean_depth_error)),
         pair("bad pixels", decimals(error.bad_percent) + " %")}};
}

void add_counts(StagePage& stage, const std::string& name, const relief::ErrorSet& error) {
    stage.counts.push_back({name + "_missing_percent", error.missing_percent});
    stage.counts.push_back({name + "_extra_percent", error.extra_percent});
    stage.counts.push_back({name + "_psnr", error.psnr});
    stage.counts.push_back({name + "_mean_depth_error", error.mean_depth_error});
    stage.counts.push_back({name + "_bad_percent", error.bad_percent});
}

}  // namespace relevo::show
