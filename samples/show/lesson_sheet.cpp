#include "samples/show/lesson_sheet.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>

#include "samples/show/sheet.hpp"

namespace relevo::show {
namespace {

using Kind = Mark::Kind;
using Lines = std::vector<std::string>;

constexpr int small = 2, large = 3;  // sizes of letters, pixels a dot
constexpr int letter_width = small * letter_cell, small_row = 26, large_row = 34;
constexpr int page_bar = 76, gap = 14, padding = 14;
constexpr int largest_cell = 64, good_cell = 36, least_cell_of_lines = 5;
constexpr int most_lesson_height = 860;

// ---- words ----

// Lines of at most so many letters, broken at spaces, at line ends, and within longer words.
Lines broken(const std::string& words_of_lesson, int columns) {
    Lines out;
    std::string line;
    int used = 0;
    const auto end_line = [&] { out.push_back(std::exchange(line, "")), used = 0; };
    std::size_t at = 0;
    while (at < words_of_lesson.size()) {
        const std::size_t end = std::min(words_of_lesson.find_first_of(" \n", at), words_of_lesson.size());
        std::string_view word = std::string_view(words_of_lesson).substr(at, end - at);
        const int space = used > 0 ? 1 : 0;
        if (used > 0 && used + 1 + letters(word) > columns)
            end_line();
        else if (space == 1 && !word.empty())
            line += ' ', ++used;
        for (; letters(word) > columns - used && columns > used;) {
            std::size_t cut = 0;
            for (int i = 0; i < columns - used; ++i)  // a whole letter: its first byte and what belongs to it
                for (++cut; cut < word.size() && (static_cast<unsigned char>(word[cut]) & 0xc0u) == 0x80u;)
                    ++cut;
            line += word.substr(0, cut);
            word.remove_prefix(cut);
            end_line();
        }
        line += word;
        used += letters(word);
        if (end < words_of_lesson.size() && words_of_lesson[end] == '\n') end_line();
        at = end + 1;
    }
    if (!line.empty()) end_line();
    return out;
}

int columns_in(int width, int size) { return std::max(1, (width + size) / (letter_cell * size)); }

void draw_lines(Canvas canvas, int x, int y, const Lines& lines, Rgba8 color, int size, int row) {
    for (const std::string& line : lines) text(canvas, x, y, line, color, size), y += row;
}

// The most lines that any frame's words need.
template <class Words>
int most_lines(const Lesson& lesson, int columns, Words words_of) {
    std::size_t most = 0;
    for (const LessonFrame& frame : lesson.frames)
        most = std::max(most, broken(words_of(frame), columns).size());
    return static_cast<int>(most);
}

// ---- marks ----

// Everything that is drawn as a line gets a light border, so that it is seen on any pixel.
Stroke border_of(Stroke stroke) { return {with_opacity(paper, 170), stroke.width + 3, 0}; }

void draw_path(Canvas canvas, std::span<const Spot> corners, Stroke stroke, bool closed) {
    path(canvas, corners, border_of(stroke), closed);
    path(canvas, corners, stroke, closed);
}

// The ellipse x = a (1 - t^2) / (1 + t^2), y = b 2t / (1 + t^2): a quarter for t in 0..1, mirrored. Rational,
// so the same on every machine.
std::vector<Spot> ellipse_corners(Spot center, double a, double b) {
    constexpr int steps = 32;
    std::vector<Spot> out;
    for (int quarter = 0; quarter < 4; ++quarter)
        for (int i = 0; i < steps; ++i) {
            const double t = static_cast<double>(i) / steps, c = (1 - t * t) / (1 + t * t),
                         s = 2 * t / (1 + t * t);
            const std::array<Spot, 4> turned{Spot{c, s}, Spot{-s, c}, Spot{-c, -s}, Spot{s, -c}};
            const Spot at = turned[static_cast<std::size_t>(quarter)];
            out.push_back({center.x + a * at.x, center.y + b * at.y});
        }
    return out;
}

std::size_t least_points(Kind kind) {
    switch (kind) {
        case Kind::Segment:
        case Kind::Dashes:
        case Kind::Arrow:
        case Kind::Path:
        case Kind::Outline:
        case Kind::Box:
            return 2;
        case Kind::Area:
            return 3;
        default:
            return 1;
    }
}

// The pixel whose square holds the place; none for what is far away or not finite.
bool pixel_at(Spot place, int& x, int& y) {
    if (!(std::abs(place.x) < 1e6 && std::abs(place.y) < 1e6)) return false;
    x = static_cast<int>(std::floor(place.x + 0.5)), y = static_cast<int>(std::floor(place.y + 0.5));
    return true;
}

double dot_radius(const LessonGrid& grid) {
    return grid.cell < 10 ? 2.5 : std::clamp(grid.cell / 7.0, 4.0, 7.0);
}

// All but words. The canvas's clip rectangle is the grid.
void draw_mark(Canvas canvas, const LessonGrid& grid, const Mark& mark) {
    if (mark.points.size() < least_points(mark.kind)) return;
    std::vector<Spot> at;
    for (const Spot& p : mark.points) at.push_back(grid.spot(p.x, p.y));
    const double width = grid.cell >= 24 ? 3 : grid.cell >= 10 ? 2 : 1.5;
    const double radius = dot_radius(grid);
    const Stroke stroke{mark.color, width};
    int x = 0, y = 0;
    switch (mark.kind) {
        case Kind::Cell:
            if (pixel_at(mark.points[0], x, y))
                fill(canvas, grid.square(x, y), mixed(paper, mark.color, std::clamp(mark.level, 0, 255)));
            break;
        case Kind::Frame:
            if (pixel_at(mark.points[0], x, y)) {
                const Rect square = grid.square(x, y);
                const int thick = std::clamp(grid.cell / 9, 1, 4);
                frame(canvas, {square.x, square.y, square.width + 1, square.height + 1}, mark.color, thick);
            }
            break;
        case Kind::Dot:
            disc(canvas, at[0], radius + std::min(2.0, radius / 2), paper);
            disc(canvas, at[0], radius, mark.color);
            break;
        case Kind::Cross:
            for (const Stroke& s : {border_of(stroke), stroke})
                for (const double side : {-1.0, 1.0})
                    line(canvas, {at[0].x - radius, at[0].y - side * radius},
                         {at[0].x + radius, at[0].y + side * radius}, s);
            break;
        case Kind::Segment:
            draw_path(canvas, std::span(at).first(2), stroke, false);
            break;
        case Kind::Dashes:
            line(canvas, at[0], at[1], {border_of(stroke).color, border_of(stroke).width, 7});
            line(canvas, at[0], at[1], {mark.color, width, 7});
            break;
        case Kind::Arrow:
            line(canvas, at[0], at[1], border_of(stroke));
            arrow(canvas, at[0], at[1], stroke);
            break;
        case Kind::Path:
            draw_path(canvas, at, stroke, false);
            break;
        case Kind::Outline:
            draw_path(canvas, at, stroke, true);
            break;
        case Kind::Area:
            polygon(canvas, at, with_opacity(mark.color, 70));
            break;
        case Kind::Curve:
            if (std::abs(mark.radius_x) < 1e6 && std::abs(mark.radius_y) < 1e6)
                draw_path(canvas,
                          ellipse_corners(at[0], mark.radius_x * grid.cell, mark.radius_y * grid.cell),
                          stroke, true);
            break;
        case Kind::Box: {
            const std::array<Spot, 4> corners{at[0], Spot{at[1].x, at[0].y}, at[1], Spot{at[0].x, at[1].y}};
            draw_path(canvas, corners, stroke, true);
            break;
        }
        case Kind::Text:
            break;
    }
}

bool overlap(const Rect& a, const Rect& b) {
    const Rect both = common(a, b);
    return both.width > 0 && both.height > 0;
}

// Words go to the first side of their point where they hide no other words: right, left, above, below.
void draw_words(Canvas canvas, const LessonGrid& grid, const Mark& mark, std::vector<Rect>& taken) {
    if (mark.points.empty()) return;
    const Spot at = grid.spot(mark.points[0].x, mark.points[0].y);
    if (!(std::abs(at.x) < 1e6 && std::abs(at.y) < 1e6)) return;
    const double away = dot_radius(grid) + 7;
    const std::string shown = shortened(mark.text, columns_in(grid.area.width - 10, small));
    const int width = text_width(shown, small);
    const auto whole = [](double v) { return static_cast<int>(std::floor(v)); };
    const auto box_at = [&](double x, double y) {  // left end and middle; kept on the grid
        const int low_x = grid.area.x + 5, high_x = std::max(low_x, grid.area.right() - width - 5);
        const int low_y = grid.area.y + 5, high_y = std::max(low_y, grid.area.bottom() - 22);
        return Rect{std::clamp(whole(x), low_x, high_x) - 3,
                    std::clamp(whole(y) - letter_height, low_y, high_y) - 3, width + 6, 22};
    };
    const std::array<Rect, 4> places{box_at(at.x + away, at.y), box_at(at.x - away - width, at.y),
                                     box_at(at.x - width / 2.0, at.y - away - 8),
                                     box_at(at.x - width / 2.0, at.y + away + 8)};
    const Rect point{whole(at.x) - 4, whole(at.y) - 4, 8, 8};
    Rect best = places[0];
    for (const Rect& place : places)
        if (!overlap(place, point) && std::none_of(taken.begin(), taken.end(), [&](const Rect& other) {
                return overlap(place, other);
            })) {
            best = place;
            break;
        }
    taken.push_back(best);
    fill(canvas, best, with_opacity(paper, 215));
    text(canvas, best.x + 3, best.y + 3, shown, mark.color, small);
}

// ---- the grid ----

struct EdgeRoom {
    int left, top, right, bottom;
};

std::string edge_number(double value) {
    return fmt::format("{}", static_cast<long long>(std::floor(value + 0.5)));
}

int most_letters_of_rows(const raster::PixelBox& view, const scene::LessonAxes& axes) {
    return std::max(letters(edge_number(axes.y_of(view.y0))), letters(edge_number(axes.y_of(view.y1))));
}

int most_letters_of_columns(const raster::PixelBox& view, const scene::LessonAxes& axes) {
    return std::max(letters(edge_number(axes.x_of(view.x0))), letters(edge_number(axes.x_of(view.x1))));
}

// Numbers of columns stand where y starts: above when it points down, below when it points up.
EdgeRoom edge_room(const raster::PixelBox& view, const scene::LessonAxes& axes) {
    const int rows = most_letters_of_rows(view, axes) * letter_width + 12;
    const int left = std::max(rows, 3 * letter_width);
    return {left, axes.y_up ? 10 : 28, 22, axes.y_up ? 28 : 10};
}

// 1, 2, 5, 10, 20, ...: the first one at which numbers of `room` canvas pixels stand apart.
int number_step(int room, int cell) {
    constexpr std::array<int, 3> steps{1, 2, 5};
    for (int power = 1; power <= 10000; power *= 10)
        for (const int step : steps)
            if (step * power * cell >= room) return step * power;
    return 100000;
}

void draw_edge_numbers(Canvas canvas, const LessonGrid& grid, const scene::LessonAxes& axes) {
    const raster::PixelBox& view = grid.view;
    const int across = number_step(most_letters_of_columns(view, axes) * letter_width + 8, grid.cell);
    const int y = axes.y_up ? grid.area.bottom() + 9 : grid.area.y - 22;
    for (int x = view.x0; x <= view.x1; ++x) {
        const std::string number = edge_number(axes.x_of(x));
        if (std::stoll(number) % across != 0) continue;
        const int middle = static_cast<int>(grid.spot(x, 0).x);
        text(canvas, middle - text_width(number, small) / 2, y, number, muted, small);
    }
    text(canvas, grid.area.right() + 7, y, "x", ink, small);
    const int down = number_step(18, grid.cell);
    for (int row = view.y0; row <= view.y1; ++row) {
        const std::string number = edge_number(axes.y_of(row));
        if (std::stoll(number) % down != 0) continue;
        const int middle = static_cast<int>(grid.spot(0, row).y);
        text(canvas, grid.area.x - 8 - text_width(number, small), middle - 6, number, muted, small);
    }
    text(canvas, grid.area.x - 8 - text_width("y ", small), y, axes.y_up ? "y\u2191" : "y\u2193", ink, small);
}

using Layer = std::vector<const Mark*>;

// The marks of a frame, the lowest first.
Layer marks_of(const Lesson& lesson, std::size_t frame_number) {
    Layer out;
    const auto add = [&](const std::vector<Mark>& marks) {
        for (const Mark& mark : marks) out.push_back(&mark);
    };
    add(lesson.ground);
    for (std::size_t i = 0; i <= frame_number; ++i) add(lesson.frames[i].stays);
    add(lesson.frames[frame_number].now);
    return out;
}

// Pixels lie beneath the lines between them, these beneath helper lines (the dashes of the ground), then
// shapes, points and words: no pixel hides the true shape, no helper line the window.
int layer_of(Kind kind, bool of_ground) {
    switch (kind) {
        case Kind::Cell:
            return 0;
        case Kind::Area:
            return 1;
        case Kind::Dashes:
            return of_ground ? 2 : 3;
        case Kind::Frame:
            return 4;
        case Kind::Dot:
        case Kind::Cross:
            return 5;
        case Kind::Text:
            return 6;
        default:
            return 3;
    }
}

void draw_grid(Canvas canvas, const LessonGrid& grid, const Lesson& lesson, const scene::LessonAxes& axes,
               std::size_t frame_number) {
    const Layer marks = marks_of(lesson, frame_number);
    const Canvas inner = within(canvas, grid.area);
    fill(inner, grid.area, paper);
    const auto draw_layer = [&](int layer) {
        for (std::size_t i = 0; i < marks.size(); ++i)
            if (layer_of(marks[i]->kind, i < lesson.ground.size()) == layer)
                draw_mark(inner, grid, *marks[i]);
    };
    draw_layer(0);
    draw_layer(1);
    if (lesson.grid && grid.cell >= least_cell_of_lines)
        pixel_grid(canvas, {grid.area.x, grid.area.y, grid.area.width, grid.area.height}, grid.cell,
                   mixed(paper, muted, 95));
    for (const int layer : {2, 3, 4, 5}) draw_layer(layer);
    std::vector<Rect> taken;
    for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark)  // the newest words have the first choice
        if ((*mark)->kind == Kind::Text) draw_words(inner, grid, **mark, taken);
    frame(canvas, {grid.area.x - 1, grid.area.y - 1, grid.area.width + 3, grid.area.height + 3}, muted);
    draw_edge_numbers(canvas, grid, axes);
}

// ---- the legend ----

constexpr int sample_width = 34;

Mark sample_mark(const LegendEntry& entry) {
    Mark mark{entry.kind, entry.color, {}, 0.75, 0.28, 255, {}};
    switch (entry.kind) {
        case Kind::Segment:
        case Kind::Dashes:
        case Kind::Arrow:
        case Kind::Path:
            mark.points = {{-0.8, 0}, {0.8, 0}};
            break;
        case Kind::Outline:
        case Kind::Area:
            mark.points = {{-0.75, 0.35}, {0, -0.35}, {0.75, 0.35}};
            break;
        case Kind::Box:
            mark.points = {{-0.75, -0.3}, {0.75, 0.3}};
            break;
        default:
            mark.points = {{0, 0}};
    }
    return mark;
}

void draw_sample(Canvas canvas, int x, int y, const LegendEntry& entry) {
    constexpr int cell = 19;  // (0, 0) is in the middle of the sample
    const LessonGrid grid{{x + (sample_width - cell) / 2, y - 2, cell, cell}, cell, {0, 0, 0, 0}};
    const Canvas inner = within(canvas, {x, y - 4, sample_width, cell + 6});
    if (entry.kind == Kind::Text)
        text(inner, x + (sample_width - 2 * letter_width) / 2, y, "ab", entry.color, small);
    else
        draw_mark(inner, grid, sample_mark(entry));
    if (entry.kind == Kind::Cell) frame(inner, grid.square(0, 0), with_opacity(ink, 90));
}

// Draws the legend (or only measures it) in columns of this width; returns its height.
int place_legend(Canvas canvas, const Lesson& lesson, Rect room, int columns, bool draw) {
    const int width = room.width / columns,
              room_for_words = columns_in(width - sample_width - 8 - gap, small);
    std::vector<int> heights(static_cast<std::size_t>(columns), 0);
    const std::size_t rows = (lesson.legend.size() + std::size_t(columns) - 1) / std::size_t(columns);
    for (std::size_t i = 0; i < lesson.legend.size(); ++i) {
        const std::size_t column = i / rows;
        const Lines lines = broken(lesson.legend[i].words, room_for_words);
        const int x = room.x + static_cast<int>(column) * width, y = room.y + heights[column];
        if (draw) {
            draw_sample(canvas, x, y, lesson.legend[i]);
            draw_lines(canvas, x + sample_width + 8, y, lines, ink, small, small_row - 4);
        }
        heights[column] += (small_row - 4) * std::max<int>(1, static_cast<int>(lines.size())) + 6;
    }
    return *std::max_element(heights.begin(), heights.end());
}

// ---- the table of states ----

struct Table {
    std::vector<int> columns;  // letters
    int rows = 0;              // that a page shows
    bool cut = false;          // not all words have room
    int width() const {
        int sum = 0;
        for (const int column : columns) sum += (column + 2) * letter_width;
        return sum;
    }
    int height() const { return columns.empty() ? 0 : (rows + 1) * small_row + 6; }
};

// Columns as wide as their widest cell; the widest ones give way until all fit.
Table table_of(const Lesson& lesson, int most_width, int most_rows) {
    Table table;
    for (const std::string& column : lesson.columns) table.columns.push_back(std::max(1, letters(column)));
    int rows = 0;
    for (const LessonFrame& frame : lesson.frames) {
        if (!frame.row.empty()) ++rows;
        for (std::size_t i = 0; i < std::min(frame.row.size(), table.columns.size()); ++i)
            table.columns[i] = std::max(table.columns[i], letters(frame.row[i]));
    }
    if (rows == 0) return {};
    table.rows = std::min(rows, most_rows);
    table.cut = table.width() > most_width;
    while (table.width() > most_width) {
        int& widest = *std::max_element(table.columns.begin(), table.columns.end());
        if (widest <= 4) break;
        --widest;
    }
    while (table.width() > most_width && table.columns.size() > 1) table.columns.pop_back();
    return table;
}

// The last rows up to this frame. The frame's own row is set off by colour, an arrow and a bar.
void draw_table(Canvas canvas, const Lesson& lesson, const Table& table, std::size_t frame_number, int x,
                int y) {
    if (table.columns.empty()) return;
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i <= frame_number; ++i)
        if (!lesson.frames[i].row.empty()) rows.push_back(i);
    if (rows.size() > static_cast<std::size_t>(table.rows)) rows.erase(rows.begin(), rows.end() - table.rows);
    const auto draw_row = [&](const std::vector<std::string>& cells, Rgba8 color) {
        int left = x + letter_width;
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            if (i < cells.size())
                text(canvas, left, y + 6, shortened(cells[i], table.columns[i]), color, small);
            left += (table.columns[i] + 2) * letter_width;
        }
        y += small_row;
    };
    draw_row(lesson.columns, navy);
    fill(canvas, {x, y - 1, table.width(), 2}, navy);
    y += 3;
    for (const std::size_t i : rows) {
        const bool current = i == frame_number;
        if (current) {
            fill(canvas, {x, y, table.width(), small_row}, yellow);
            fill(canvas, {x, y, 5, small_row}, ink);
        }
        draw_row(lesson.frames[i].row, current ? ink : muted);
    }
}

// ---- the page ----

// How the parts share a page: table and legend at the right, the table below, or both below.
struct Plan {
    enum class Kind { AllRight, TableBelow, AllBelow } kind = Kind::AllRight;
    int width = lesson_width, height = lesson_height;
    int equation_lines = 0, caption_lines = 0;
    int panel_width = 0, panel_height = 0, below_height = 0, legend_columns = 1;
    Table table;
    int cell = 0;
    int body_top = 0;

    int body_height() const {
        return height - body_top - (below_height > 0 ? below_height + gap : 0) - page_margin;
    }
};

struct GridSize {
    int columns, rows;
};
GridSize size_of(const raster::PixelBox& view) { return {view.x1 - view.x0 + 1, view.y1 - view.y0 + 1}; }

Plan plan_of(const Lesson& lesson, const scene::LessonAxes& axes, Plan::Kind kind) {
    constexpr int least_panel = 22 * letter_width, most_panel = 32 * letter_width,
                  inner = lesson_width - 2 * page_margin;
    Plan plan;
    plan.kind = kind;
    const bool right = kind == Plan::Kind::AllRight;
    plan.table = table_of(lesson, right ? most_panel : inner - 2 * padding, right ? 6 : 4);
    plan.equation_lines = most_lines(lesson, columns_in(inner - 2 * padding, large),
                                     [](const LessonFrame& f) { return f.equation; });
    plan.caption_lines =
        most_lines(lesson, columns_in(inner, small), [](const LessonFrame& f) { return f.caption; });
    plan.body_top = page_bar + gap;
    if (plan.equation_lines > 0) plan.body_top += plan.equation_lines * large_row + 2 * padding - 8 + gap;
    if (plan.caption_lines > 0) plan.body_top += plan.caption_lines * small_row + gap - 4;
    plan.legend_columns = kind == Plan::Kind::AllBelow ? 3 : 1;
    if (kind == Plan::Kind::AllBelow) {
        const int legend =
            lesson.legend.empty() ? 0 : place_legend({}, lesson, {0, 0, inner - 2 * padding, 0}, 3, false);
        plan.below_height = legend + plan.table.height() + (legend > 0 && plan.table.height() > 0 ? gap : 0);
    } else {
        const int width = right ? std::max(least_panel, plan.table.width()) : least_panel;
        const int legend = lesson.legend.empty() ? 0 : place_legend({}, lesson, {0, 0, width, 0}, 1, false);
        plan.panel_height = legend + (right ? plan.table.height() + (legend > 0 ? gap : 0) : 0);
        plan.panel_width = plan.panel_height > 0 ? width + 2 * padding : 0;
        plan.below_height = right ? 0 : plan.table.height();
    }
    if (plan.below_height > 0) plan.below_height += 2 * padding;
    if (plan.panel_height > 0) plan.panel_height += 2 * padding;

    const EdgeRoom edges = edge_room(lesson.view, axes);
    const GridSize size = size_of(lesson.view);
    const int beside = plan.panel_width > 0 ? plan.panel_width + page_margin : 0;
    const int room_x = inner - beside - edges.left - edges.right;
    // Where words leave too little room for the pixels, the page gets longer.
    const int wanted = std::clamp(room_x / size.columns, 1, good_cell);
    plan.height = std::clamp(size.rows * wanted + edges.top + edges.bottom + plan.height - plan.body_height(),
                             lesson_height, most_lesson_height);
    const int room_y = std::max(plan.body_height(), plan.panel_height) - edges.top - edges.bottom;
    plan.cell = std::clamp(std::min(room_x / size.columns, room_y / size.rows), 1, largest_cell);
    plan.width =
        std::max(plan.width, size.columns * plan.cell + edges.left + edges.right + beside + 2 * page_margin);
    const int body = std::max(size.rows * plan.cell + edges.top + edges.bottom, plan.panel_height);
    plan.height += std::max(0, body - plan.body_height());
    return plan;
}

// The plan whose pixels are the largest part of their page.
Plan best_plan(const Lesson& lesson, const scene::LessonAxes& axes) {
    Plan best = plan_of(lesson, axes, Plan::Kind::AllRight);
    if (best.table.cut) best.cell = 0;
    for (const Plan::Kind kind : {Plan::Kind::TableBelow, Plan::Kind::AllBelow}) {
        const Plan other = plan_of(lesson, axes, kind);
        const std::int64_t gain = std::int64_t{other.cell} * best.width * best.height -
                                  std::int64_t{best.cell} * other.width * other.height;
        if (gain > 0) best = other;
    }
    return best;
}

void draw_bar(Canvas canvas, const Lesson& lesson, std::size_t frame_number, int width) {
    const LessonFrame& now = lesson.frames[frame_number];
    const std::string place = fmt::format("frame {} of {}", frame_number + 1, lesson.frames.size());
    fill(canvas, {0, 0, width, page_bar}, navy);
    const int place_x = width - page_margin - text_width(place, small);
    text(canvas, page_margin, 12, shortened(lesson.title, columns_in(place_x - 2 * page_margin, large)),
         paper, large);
    text(canvas, place_x, 16, place, yellow, small);
    text(canvas, page_margin, 43, shortened(now.title, columns_in(width - 2 * page_margin, small)), yellow,
         small);
    const int count = static_cast<int>(lesson.frames.size()), at = static_cast<int>(frame_number);
    fill(canvas, {0, page_bar - 6, width, 6}, mixed(navy, paper, 60));
    fill(canvas, {0, page_bar - 6, static_cast<int>(std::int64_t(width) * (at + 1) / count), 6}, yellow);
}

}  // namespace

LessonPage draw_lesson_frame(const Lesson& lesson, const scene::LessonAxes& axes, std::size_t frame_number) {
    assert(frame_number < lesson.frames.size() && !lesson.view.empty());
    const LessonFrame& now = lesson.frames[frame_number];
    const Plan plan = best_plan(lesson, axes);
    LessonPage page{Picture(plan.width, plan.height, paper), {}};
    const Canvas canvas = canvas_of(page.picture);
    draw_bar(canvas, lesson, frame_number, plan.width);
    const int inner = plan.width - 2 * page_margin, text_room = lesson_width - 2 * page_margin;

    int y = page_bar + gap;
    if (plan.equation_lines > 0) {
        const int height = plan.equation_lines * large_row + 2 * padding - 8;
        fill(canvas, {page_margin, y, inner, height}, mist);
        fill(canvas, {page_margin, y, 6, height}, blue);
        const Lines lines = broken(now.equation, columns_in(text_room - 2 * padding, large));
        const int spare = (plan.equation_lines - static_cast<int>(lines.size())) * large_row;
        draw_lines(canvas, page_margin + padding + 4, y + padding + spare / 2, lines, ink, large, large_row);
        y += height + gap;
    }
    draw_lines(canvas, page_margin, y, broken(now.caption, columns_in(text_room, small)), ink, small,
               small_row);

    const EdgeRoom edges = edge_room(lesson.view, axes);
    const GridSize size = size_of(lesson.view);
    const int width = size.columns * plan.cell, height = size.rows * plan.cell;
    const int beside = plan.panel_width > 0 ? plan.panel_width + page_margin : 0;
    const int spare_x = inner - beside - edges.left - edges.right - width,
              spare_y = plan.body_height() - edges.top - edges.bottom - height;
    page.grid = {{page_margin + edges.left + spare_x / 2,
                  plan.body_top + edges.top + std::max(spare_y, 0) / 2, width, height},
                 plan.cell,
                 lesson.view};
    draw_grid(canvas, page.grid, lesson, axes, frame_number);

    if (plan.panel_width > 0) {
        const Rect box{plan.width - page_margin - plan.panel_width, plan.body_top, plan.panel_width,
                       plan.body_height()};
        fill(canvas, box, mist);
        const Rect room{box.x + padding, box.y + padding, box.width - 2 * padding, box.height};
        const int legend = lesson.legend.empty() ? 0 : place_legend(canvas, lesson, room, 1, true);
        if (plan.kind == Plan::Kind::AllRight)
            draw_table(canvas, lesson, plan.table, frame_number, room.x,
                       room.y + legend + (legend > 0 ? gap : 0));
    }
    if (plan.below_height > 0) {
        const Rect box{page_margin, plan.height - page_margin - plan.below_height, inner, plan.below_height};
        fill(canvas, box, mist);
        const Rect room{box.x + padding, box.y + padding, text_room - 2 * padding, box.height};
        int legend = 0;
        if (plan.kind == Plan::Kind::AllBelow && !lesson.legend.empty())
            legend = place_legend(canvas, lesson, room, plan.legend_columns, true) + gap;
        draw_table(canvas, lesson, plan.table, frame_number, room.x, room.y + legend);
    }
    return page;
}

std::vector<std::size_t> frames_to_print(std::size_t frames) {
    std::vector<std::size_t> out;
    const std::size_t count = std::min(frames, printed_frames);
    for (std::size_t i = 0; i < count; ++i)
        out.push_back(count == frames ? i : (i * (frames - 1) + (count - 1) / 2) / (count - 1));
    return out;
}

// ---- the strip ----
namespace {

// Its parts are placed twice: `draw` false only measures. All return their height.

constexpr int title_size = 4, title_row = 44;
constexpr int badge_room = 90;  // of a frame's number, beside its title
constexpr int item_width = 600, item_gap = 28, items_across = 3, most_grid_height = 460;

int height_of(const Lines& lines, int row) { return static_cast<int>(lines.size()) * row; }

struct Strip {
    const Lesson& lesson;
    const scene::LessonAxes& axes;
    std::vector<std::size_t> frames;
    EdgeRoom edges;
    LessonGrid grid;   // of an item, at (0, 0)
    int column_width;  // of an item
    int across;
    int width;  // of the sheet

    int inner() const { return width - 2 * page_margin; }
    int grid_height() const { return grid.area.height + edges.top + edges.bottom; }
    int grid_width() const { return grid.area.width + edges.left + edges.right; }
};

Strip strip_of(const Lesson& lesson, const scene::LessonAxes& axes) {
    Strip strip{lesson, axes, frames_to_print(lesson.frames.size()), edge_room(lesson.view, axes), {}, 0,
                0,      0};
    const GridSize size = size_of(lesson.view);
    const int room_x = item_width - strip.edges.left - strip.edges.right,
              room_y = most_grid_height - strip.edges.top - strip.edges.bottom;
    const int cell = std::clamp(std::min(room_x / size.columns, room_y / size.rows), 1, largest_cell);
    strip.grid = {{0, 0, size.columns * cell, size.rows * cell}, cell, lesson.view};
    strip.column_width = std::max(item_width, strip.grid_width());
    strip.across = std::min<int>(items_across, static_cast<int>(strip.frames.size()));
    // A sheet of one frame is still wide enough for its heading.
    strip.width =
        std::max(lesson_width, strip.across * (strip.column_width + item_gap) - item_gap + 2 * page_margin);
    return strip;
}

int place_head(Canvas canvas, const Strip& strip, bool draw) {
    const Lesson& lesson = strip.lesson;
    struct Part {
        Lines lines;
        Rgba8 color;
        int size, row;
    };
    const auto part = [&](const std::string& words_of_part, Rgba8 color, int size, int row) {
        return Part{broken(words_of_part, columns_in(strip.inner(), size)), color, size, row};
    };
    int y = page_margin;
    for (const Part& p :
         {part(lesson.title, navy, title_size, title_row), part(lesson.sentence, ink, large, large_row),
          part(lesson.source, muted, small, small_row)}) {
        if (draw) draw_lines(canvas, page_margin, y, p.lines, p.color, p.size, p.row);
        y += height_of(p.lines, p.row);
    }
    y += gap;
    if (!lesson.legend.empty()) {
        const int columns = std::max(1, strip.inner() / 440);
        y += place_legend(canvas, lesson, {page_margin, y + gap, strip.inner(), 0}, columns, draw) + 2 * gap;
    }
    return y;
}

// A frame: number and title, pixels, equation, caption.
int place_item(Canvas canvas, const Strip& strip, std::size_t frame_number, int x, int y, int title_height,
               bool draw) {
    const LessonFrame& now = strip.lesson.frames[frame_number];
    const int columns = columns_in(strip.column_width, large);
    const Lines equation = broken(now.equation, columns), caption = broken(now.caption, columns);
    const int grid_y = y + title_height, equation_y = grid_y + strip.grid_height() + gap,
              caption_y = equation_y + height_of(equation, large_row) + (equation.empty() ? 0 : 6);
    if (draw) {
        const std::string number = fmt::format("{}", frame_number + 1);
        const int badge = text_width(number, large) + 16;
        fill(canvas, {x, y - 5, badge, large_row - 2}, navy);
        text(canvas, x + 8, y, number, paper, large);
        draw_lines(canvas, x + badge + 12, y,
                   broken(now.title, columns_in(strip.column_width - badge_room, large)), navy, large,
                   large_row);
        LessonGrid grid = strip.grid;
        grid.area.x = x + strip.edges.left + (strip.column_width - strip.grid_width()) / 2;
        grid.area.y = grid_y + strip.edges.top;
        draw_grid(canvas, grid, strip.lesson, strip.axes, frame_number);
        draw_lines(canvas, x, equation_y, equation, ink, large, large_row);
        draw_lines(canvas, x, caption_y, caption, muted, large, large_row);
    }
    return caption_y + height_of(caption, large_row) - y;
}

int place_items(Canvas canvas, const Strip& strip, int top, bool draw) {
    int y = top;
    const auto across = static_cast<std::size_t>(strip.across);
    for (std::size_t first = 0; first < strip.frames.size(); first += across) {
        const auto row =
            std::span(strip.frames).subspan(first, std::min(across, strip.frames.size() - first));
        int title_height = 0, height = 0;
        for (const std::size_t frame_number : row)
            title_height =
                std::max(title_height, height_of(broken(strip.lesson.frames[frame_number].title,
                                                        columns_in(strip.column_width - badge_room, large)),
                                                 large_row));
        if (draw) fill(canvas, {page_margin, y, strip.inner(), 2}, rule);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const int x = page_margin + static_cast<int>(i) * (strip.column_width + item_gap);
            height = std::max(height, place_item(canvas, strip, row[i], x, y + gap + 6, title_height, draw));
        }
        y += gap + 6 + height + item_gap;
    }
    return y - top;
}

}  // namespace

Picture draw_lesson_strip(const Lesson& lesson, const scene::LessonAxes& axes) {
    assert(!lesson.frames.empty() && !lesson.view.empty());
    const Strip strip = strip_of(lesson, axes);
    const int head = place_head({}, strip, false);
    Picture sheet(strip.width, head + place_items({}, strip, head, false), paper);
    place_head(canvas_of(sheet), strip, true);
    place_items(canvas_of(sheet), strip, head, true);
    return sheet;
}

}  // namespace relevo::show
