// Several pictures beside each other on a page, each under its title.
#pragma once
#include "samples/show/sheet.hpp"

namespace relevo::show {

// How a picture is drawn: each pixel `factor` pixels large, or only every `divisor`-th one where it is too
// large for that.
struct Scale {
    int divisor, factor;
    int drawn(int pixels) const { return (pixels + divisor - 1) / divisor * factor; }
    // Where a place of the picture, in its pixels, stands in the rectangle it was pasted to.
    Spot spot(const Rect& rect, double x, double y) const {
        return {rect.x + x * factor / divisor, rect.y + y * factor / divisor};
    }
};

// Rows and columns of panes for pictures of one size; a smaller one is drawn larger, as far as its pane goes.
struct Panes {
    int columns, rows, divisor, factor, width, height;
    int cell_width() const;
    int area_width() const;
    int area_height() const;
    Scale scale_of(int picture_width, int picture_height) const;
};
// At most `widest` pixels wide when that is possible without leaving any pixel out.
Panes panes_of(int picture_width, int picture_height, int columns, int rows, int widest = diagram_width);

// A sentence for the panel when not all pixels are shown.
void say_what_is_shown(const Panes& panes, PanelBlock& block);

Page lay_out(const Heading& heading, const std::vector<PanelBlock>& panel, const Panes& panes);

// The picture under its title; where it stands.
Rect paste_pane(Page& page, const Panes& panes, int number, const std::string& title, const Picture& picture);

}  // namespace relevo::show
