#include "samples/show/sheet.hpp"

#include <fmt/format.h>

#include "samples/show/numbers.hpp"

namespace relevo::show {
namespace {

constexpr int letter_width = 2 * letter_cell, row_height = 25, block_gap = 14, block_title = 32;
constexpr int panel_padding = 16, panel_width = panel_columns * letter_width + 2 * panel_padding;
constexpr int bar_height = 72, sample_columns = 3, least_width = 1000;

// The rows as they are drawn: wrapped text becomes several rows.
std::vector<PanelRow> laid_rows(const PanelBlock& block) {
    std::vector<PanelRow> out;
    for (const PanelRow& row : block.rows) {
        if (row.kind != PanelRow::Kind::Text && row.kind != PanelRow::Kind::Quiet) {
            out.push_back(row);
            continue;
        }
        for (std::string& part : wrapped(row.left, panel_columns)) {
            out.push_back(row);
            out.back().left = std::move(part);
        }
    }
    return out;
}

int block_height(const PanelBlock& block) {
    return (block.title.empty() ? 0 : block_title) + row_height * static_cast<int>(laid_rows(block).size());
}

void draw_sample(Canvas canvas, int x, int y, const PanelRow& row) {
    const double middle = y + 7;
    const int width = 2 * letter_width;
    switch (row.kind) {
        case PanelRow::Kind::Square:
            fill(canvas, {x, y - 1, width, 16}, row.color);
            frame(canvas, {x, y - 1, width, 16}, with_opacity(ink, 90));
            break;
        case PanelRow::Kind::Line:
            line(canvas, {x + 1.0, middle}, {x + width - 1.0, middle}, {row.color, 3});
            break;
        case PanelRow::Kind::Dashes:
            line(canvas, {x + 1.0, middle}, {x + width - 1.0, middle}, {row.color, 3, 5});
            break;
        case PanelRow::Kind::Dot:
            disc(canvas, {x + width / 2.0, middle}, 6, row.color);
            break;
        case PanelRow::Kind::Ring:
            ring(canvas, {x + width / 2.0, middle}, 6, {row.color, 2});
            break;
        default:
            break;
    }
}

void draw_ramp(Canvas canvas, int x, int y, const PanelRow& row) {
    const int width = 10 * letter_width, from = x + 11 * letter_width;
    for (int i = 0; i < width; ++i)
        fill(canvas, {from + i, y - 1, 1, 16}, mixed(row.color, row.other, i * 255 / (width - 1)));
    frame(canvas, {from, y - 1, width, 16}, with_opacity(ink, 90));
    const std::string low = shortened(row.left, 10), high = shortened(row.right, 10);
    text(canvas, from - letter_width - text_width(low), y, low, ink);
    text(canvas, from + width + letter_width, y, high, ink);
}

void draw_row(Canvas canvas, int x, int y, const PanelRow& row) {
    using Kind = PanelRow::Kind;
    if (row.kind == Kind::Ramp) return draw_ramp(canvas, x, y, row);
    const bool plain = row.kind == Kind::Text || row.kind == Kind::Quiet || row.kind == Kind::Pair;
    const int indent = plain ? 0 : sample_columns;
    const std::string right = shortened(row.right, panel_columns - indent);
    const int room = panel_columns - indent - (right.empty() ? 0 : letters(right) + 1);
    draw_sample(canvas, x, y, row);
    text(canvas, x + indent * letter_width, y, shortened(row.left, std::max(room, 0)),
         row.kind == Kind::Quiet ? muted : ink);
    text(canvas, x + panel_columns * letter_width - text_width(right), y, right, ink);
}

void draw_block(Canvas canvas, int x, int y, const PanelBlock& block) {
    if (!block.title.empty()) {
        text(canvas, x, y, shortened(block.title, panel_columns), navy);
        fill(canvas, {x, y + 20, panel_columns * letter_width, 2}, navy);
        y += block_title;
    }
    for (const PanelRow& row : laid_rows(block)) {
        draw_row(canvas, x, y, row);
        y += row_height;
    }
}

void draw_bar(Canvas canvas, const Heading& heading, int width) {
    fill(canvas, {0, 0, width, bar_height}, navy);
    text(canvas, page_margin, 22, fmt::format("{:02}", heading.number), yellow, 4);
    const int step = 15, strip = heading.of * step - 5, strip_x = width - page_margin - strip;
    const int name_x = page_margin + 3 * 24;
    text(canvas, name_x, 22, shortened(heading.name, (strip_x - name_x - 20) / 24), paper, 4);
    for (int i = 0; i < heading.of; ++i) {
        const Rgba8 color =
            i + 1 == heading.number ? yellow : mixed(navy, paper, i + 1 < heading.number ? 150 : 60);
        fill(canvas, {strip_x + i * step, 16, 10, 10}, color);
    }
    const int name_end = name_x + text_width(heading.name, 4) + 40;
    const std::string subject =
        shortened(heading.subject, std::max(0, width - page_margin - name_end) / letter_width);
    text(canvas, width - page_margin - text_width(subject), 42, subject, mixed(navy, paper, 200));
}

// Blocks under each other in columns; returns the height that they need.
int place_blocks(Canvas canvas, const std::vector<PanelBlock>& panel, int x, int y, int columns, bool draw) {
    std::vector<int> heights(static_cast<std::size_t>(std::max(columns, 1)), 0);
    for (const PanelBlock& block : panel) {
        const auto shortest = std::min_element(heights.begin(), heights.end());
        const int column = static_cast<int>(shortest - heights.begin());
        if (draw) draw_block(canvas, x + column * (panel_width + block_gap), y + *shortest, block);
        *shortest += block_height(block) + block_gap;
    }
    return std::max(*std::max_element(heights.begin(), heights.end()) - block_gap, 0);
}

}  // namespace

PanelRow words(std::string text) { return {PanelRow::Kind::Text, std::move(text), ""}; }
PanelRow quiet(std::string text) { return {PanelRow::Kind::Quiet, std::move(text), ""}; }
PanelRow pair(std::string name, std::string value) {
    return {PanelRow::Kind::Pair, std::move(name), std::move(value)};
}
PanelRow sample(PanelRow::Kind kind, Rgba8 color, std::string name, std::string value) {
    return {kind, std::move(name), std::move(value), color};
}
PanelRow ramp(Rgba8 from, Rgba8 to, std::string low, std::string high) {
    return {PanelRow::Kind::Ramp, std::move(low), std::move(high), from, to};
}

std::vector<PanelRow> matrix_rows(const double (&rows)[4][4]) {
    double largest = 0;
    for (const auto& row : rows)
        for (const double value : row) largest = std::max(largest, std::abs(value));
    std::vector<PanelRow> out;
    for (const auto& row : rows) {
        std::string line_of_numbers;
        for (const double value : row) {
            std::string cell =
                number(std::abs(value) < 1e-13 * largest ? 0 : value);  // rounding noise is no number
            if (letters(cell) > 7) cell = fmt::format("{:.1e}", value);
            line_of_numbers +=
                std::string(static_cast<std::size_t>(std::max(0, 8 - letters(cell))), ' ') + cell;
        }
        out.push_back(pair(line_of_numbers, ""));
    }
    return out;
}

std::vector<std::string> wrapped(const std::string& text, int columns) {
    std::vector<std::string> lines{""};
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = shortened(text.substr(at, end - at), columns);
        const bool fits = letters(lines.back()) + 1 + letters(word) <= columns;
        if (lines.back().empty())
            lines.back() = word;
        else if (fits)
            lines.back() += " " + word;
        else
            lines.push_back(word);
        at = end + 1;
    }
    return lines;
}

Page lay_out(const Heading& heading, const std::vector<PanelBlock>& panel, int area_width, int area_height) {
    // A very wide picture has its panel below, in columns; any other one at its right.
    const bool below = area_width > 1000 && area_width > 2 * area_height;
    const int width =
        std::max(least_width, area_width + 2 * page_margin + (below ? 0 : panel_width + page_margin));
    const std::vector<std::string> lines =
        wrapped(heading.sentence, (width - 2 * page_margin) / letter_width);
    const int top = bar_height + 24 + 26 * static_cast<int>(lines.size()) + 4;
    const int columns =
        below ? std::max(1, (width - 2 * page_margin + block_gap) / (panel_width + block_gap)) : 1;
    const int panel_height = place_blocks({}, panel, 0, 0, columns, false) + 2 * panel_padding;
    const int height =
        top + page_margin +
        (below ? area_height + page_margin + panel_height : std::max(area_height, panel_height));
    Page page{Picture(width, height, paper), {page_margin, top, area_width, area_height}};
    if (!below)
        page.area.width = width - panel_width - 3 * page_margin,
        page.area.height = height - top - page_margin;
    const Canvas canvas = canvas_of(page.picture);
    draw_bar(canvas, heading, width);
    for (std::size_t i = 0; i < lines.size(); ++i)
        text(canvas, page_margin, bar_height + 16 + 26 * static_cast<int>(i), lines[i], ink);
    const Rect box =
        below ? Rect{page_margin, page.area.bottom() + page_margin, width - 2 * page_margin, panel_height}
              : Rect{page.area.right() + page_margin, top, panel_width, page.area.height};
    fill(canvas, box, mist);
    place_blocks(within(canvas, box), panel, box.x + panel_padding, box.y + panel_padding, columns, true);
    return page;
}

void label(Canvas canvas, Spot at, const std::string& text_of_label, Rgba8 color, Align align) {
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || canvas.clip.width <= 0) return;
    const Rect clip = canvas.clip;
    const std::string shown = shortened(text_of_label, std::max(0, clip.width - 4) / letter_width);
    const int width = text_width(shown), shift = align == Align::Left     ? 0
                                                 : align == Align::Middle ? width / 2
                                                                          : width;
    const auto bounded = [](double v, int low, int high) {
        return static_cast<int>(std::floor(std::clamp(v, double(low), double(std::max(low, high)))));
    };
    const int x = bounded(at.x - shift, clip.x + 2, clip.right() - width - 2);
    const int y = bounded(at.y - letter_height, clip.y + 2, clip.bottom() - 20);
    fill(canvas, {x - 3, y - 3, width + 6, 20}, with_opacity(paper, 200));
    text(canvas, x, y, shown, color);
}

}  // namespace relevo::show
