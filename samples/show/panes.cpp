#include "samples/show/panes.hpp"

#include <fmt/format.h>

namespace relevo::show {
namespace {

constexpr int pane_title = 30, pane_gap = 16;

Picture reduced(const Picture& picture, int divisor) {
    Picture out((picture.width() + divisor - 1) / divisor, (picture.height() + divisor - 1) / divisor);
    for (int y = 0; y < out.height(); ++y)
        for (int x = 0; x < out.width(); ++x) out.at(x, y) = picture.at(x * divisor, y * divisor);
    return out;
}

}  // namespace

int Panes::cell_width() const { return std::max(width, 16 * 2 * letter_cell); }
int Panes::area_width() const { return columns * (cell_width() + pane_gap) - pane_gap; }
int Panes::area_height() const { return rows * (height + pane_title + pane_gap) - pane_gap; }

Scale Panes::scale_of(int picture_width, int picture_height) const {
    Scale scale{1, 1};
    const auto fits = [&] {
        return scale.drawn(picture_width) <= width && scale.drawn(picture_height) <= height;
    };
    while (!fits()) ++scale.divisor;
    while (fits()) ++scale.factor;
    --scale.factor;
    return scale;
}

Panes panes_of(int picture_width, int picture_height, int columns, int rows, int widest) {
    const int w = columns * picture_width, h = rows * picture_height;
    const int high = columns == 1 ? 1000 : 1300;
    const int divisor = std::max({1, (w + 1299) / 1300, (h + high - 1) / high});
    const int factor = divisor > 1 ? 1
                                   : std::max(1, std::min((widest + pane_gap - columns * pane_gap) / w,
                                                          (720 - rows * pane_title) / h));
    const Scale scale{divisor, factor};
    return {columns, rows, divisor, factor, scale.drawn(picture_width), scale.drawn(picture_height)};
}

void say_what_is_shown(const Panes& panes, PanelBlock& block) {
    const char* const ending = panes.divisor == 2 ? "nd" : panes.divisor == 3 ? "rd" : "th";
    if (panes.divisor > 1)
        block.rows.push_back(quiet(fmt::format("Every {}{} pixel is shown.", panes.divisor, ending)));
}

Page lay_out(const Heading& heading, const std::vector<PanelBlock>& panel, const Panes& panes) {
    return lay_out(heading, panel, panes.area_width(), panes.area_height());
}

Rect paste_pane(Page& page, const Panes& panes, int number, const std::string& title,
                const Picture& picture) {
    const Canvas canvas = canvas_of(page.picture);
    const int left = page.area.x + (page.area.width - panes.area_width()) / 2;
    const int x = left + number % panes.columns * (panes.cell_width() + pane_gap),
              y = page.area.y + number / panes.columns * (panes.height + pane_title + pane_gap);
    text(canvas, x, y + 4, title, navy);
    const Scale scale = panes.scale_of(picture.width(), picture.height());
    const Rect rect{x, y + pane_title, scale.drawn(picture.width()), scale.drawn(picture.height())};
    paste(canvas, scale.divisor > 1 ? reduced(picture, scale.divisor) : picture, rect.x, rect.y,
          scale.factor);
    if (scale.factor >= 8) pixel_grid(canvas, rect, scale.factor, with_opacity(haze, 110));
    frame(canvas, {rect.x - 1, rect.y - 1, rect.width + 2, rect.height + 2}, muted);
    return rect;
}

}  // namespace relevo::show
