#include "samples/show/stage.hpp"

#include "samples/show/numbers.hpp"

namespace relevo::show {

Page diagram_page(const Heading& heading, const std::vector<PanelBlock>& panel) {
    Page page = lay_out(heading, panel, diagram_width, diagram_height);
    frame(canvas_of(page.picture), page.area, rule);
    return page;
}

PanelBlock matrix_block(const std::string& title, const glm::dmat4& m) {
    double rows[4][4];
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) rows[r][c] = m[c][r];
    return {title, matrix_rows(rows)};
}

std::string triple(glm::dvec3 p) { return number(p.x) + ", " + number(p.y) + ", " + number(p.z); }

std::string range(double low, double high) {
    const double noise = 1e-7 * std::max(std::abs(low), std::abs(high));
    return number(std::abs(low) < noise ? 0 : low) + " to " + number(std::abs(high) < noise ? 0 : high);
}

void say(Canvas canvas, Rect area, const std::string& sentence, bool low) {
    const std::vector<std::string> lines =
        wrapped(sentence, std::max(8, (area.width - 24) / (2 * letter_cell)));
    const int height = 26 * static_cast<int>(lines.size());
    if (height > area.height) return;  // the panel says it too
    int y = low ? area.bottom() - height - 8 : area.y + (area.height - height) / 2;
    for (const std::string& part : lines) {
        const int width = text_width(part), x = area.x + (area.width - width) / 2;
        fill(within(canvas, area), {x - 10, y - 7, width + 20, 27}, with_opacity(paper, 225));
        text(within(canvas, area), x, y, part, muted);
        y += 26;
    }
}

Rect cell(Rect area, int column, int columns, int row, int rows, int gap) {
    const int width = (area.width - gap * (columns - 1)) / columns,
              height = (area.height - gap * (rows - 1)) / rows;
    return {area.x + column * (width + gap), area.y + row * (height + gap), width, height};
}

}  // namespace relevo::show
