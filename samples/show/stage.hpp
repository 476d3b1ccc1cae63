// What a stage of `relevo steps` gives: a page and the numbers for steps.json.
#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "samples/show/capture.hpp"
#include "samples/show/sheet.hpp"

namespace relevo::show {

struct Count {
    std::string name;
    std::variant<std::int64_t, double> value;
};

struct StagePage {
    Picture picture;
    std::vector<Count> counts;
    Rect pixels;     // where the rendered pixels stand, if the stage shows any
    int factor = 1;  // how big each of them is
};

// One function a stage. The heading's name, number and sentence are the stage's.
StagePage draw_object(const Capture& capture, const Heading& heading);
StagePage draw_world(const Capture& capture, const Heading& heading);
StagePage draw_eye(const Capture& capture, const Heading& heading);
StagePage draw_clip(const Capture& capture, const Heading& heading);
StagePage draw_clipped(const Capture& capture, const Heading& heading);
StagePage draw_ndc(const Capture& capture, const Heading& heading);
StagePage draw_window(const Capture& capture, const Heading& heading);
StagePage draw_culled(const Capture& capture, const Heading& heading);
StagePage draw_coverage(const Capture& capture, const Heading& heading);
StagePage draw_depth(const Capture& capture, const Heading& heading);
StagePage draw_visibility(const Capture& capture, const Heading& heading);
StagePage draw_attributes(const Capture& capture, const Heading& heading);
StagePage draw_flat(const Capture& capture, const Heading& heading);
StagePage draw_gouraud(const Capture& capture, const Heading& heading);
StagePage draw_phong(const Capture& capture, const Heading& heading);
StagePage draw_texture(const Capture& capture, const Heading& heading);
StagePage draw_final(const Capture& capture, const Heading& heading);

// ---- shared by several stages ----

// A diagram's page: its area is at least diagram_width x diagram_height.
Page diagram_page(const Heading& heading, const std::vector<PanelBlock>& panel);
// The rows of a map's matrix under a title.
PanelBlock matrix_block(const std::string& title, const glm::dmat4& m);
// "0.5, 1, -3"
std::string triple(glm::dvec3 p);
// "-1 to 2.5"
std::string range(double low, double high);
// A sentence in the middle of the area (or at its lower end), for a stage that has nothing to show in this
// scene.
void say(Canvas canvas, Rect area, const std::string& sentence, bool low = false);
// An area cut into rows and columns with gaps.
Rect cell(Rect area, int column, int columns, int row, int rows, int gap = 12);

}  // namespace relevo::show
