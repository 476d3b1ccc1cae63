// The stages of `relevo steps` for an object that is shown by a relief texture: from its source picture to
// the screen, and how far it is from the truth (Clua 2004, chapters 3, 6 and 8).
#pragma once
#include <span>

#include "samples/show/panes.hpp"
#include "samples/show/relief_view.hpp"
#include "samples/show/stage.hpp"

namespace relevo::show {

struct ReliefStageInfo {
    std::string_view name, sentence;
    StagePage (*draw)(const ReliefView&, const Heading&);
};
std::span<const ReliefStageInfo> relief_stages();

// The picture of a stage; where view.problem says that there is nothing to show, a page that says so.
StagePage draw_stage(const ReliefView& view, const ReliefStageInfo& stage, const Heading& heading);

// What a stage shows: pictures under their titles, in rows of so many.
struct Pane {
    std::string title;
    Picture picture;
};
struct PanePage {
    StagePage stage;
    std::vector<Rect> rects;    // where the pictures stand
    std::vector<Scale> scales;  // and how large they are
};
PanePage pane_page(const Heading& heading, std::vector<PanelBlock> panel, int columns,
                   const std::vector<Pane>& pictures);

// One function a stage, in the order of relief_stages().
StagePage draw_relief_source(const ReliefView& view, const Heading& heading);
StagePage draw_relief_quantized(const ReliefView& view, const Heading& heading);
StagePage draw_relief_order(const ReliefView& view, const Heading& heading);
StagePage draw_relief_field(const ReliefView& view, const Heading& heading);
StagePage draw_relief_rows(const ReliefView& view, const Heading& heading);
StagePage draw_relief_columns(const ReliefView& view, const Heading& heading);
StagePage draw_relief_against_mesh(const ReliefView& view, const Heading& heading);
StagePage draw_relief_kinds(const ReliefView& view, const Heading& heading);
StagePage draw_relief_disorder(const ReliefView& view, const Heading& heading);
StagePage draw_relief_map(const ReliefView& view, const Heading& heading);
StagePage draw_relief_carrier(const ReliefView& view, const Heading& heading);
StagePage draw_relief_final(const ReliefView& view, const Heading& heading);
StagePage draw_relief_truth(const ReliefView& view, const Heading& heading);
StagePage draw_relief_error(const ReliefView& view, const Heading& heading);
StagePage draw_relief_depth(const ReliefView& view, const Heading& heading);
StagePage draw_relief_inverse(const ReliefView& view, const Heading& heading);
StagePage draw_relief_solid(const ReliefView& view, const Heading& heading);
StagePage draw_relief_shadow(const ReliefView& view, const Heading& heading);
StagePage draw_relief_faces(const ReliefView& view, const Heading& heading);
StagePage draw_relief_morph(const ReliefView& view, const Heading& heading);

// The error set under a title, and as counts for steps.json, whose names begin with `name`.
PanelBlock error_block(const std::string& title, const relief::ErrorSet& error);
void add_counts(StagePage& stage, const std::string& name, const relief::ErrorSet& error);

}  // namespace relevo::show
