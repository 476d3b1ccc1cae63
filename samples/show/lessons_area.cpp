// Lessons of areas: a triangle between its edges or by edge functions, a rectangle, a polygon by active
// edges.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "raster/polygon_active_edges.hpp"
#include "raster/rectangle.hpp"
#include "raster/triangle_edge.hpp"
#include "raster/triangle_scan.hpp"
#include "samples/show/lesson_marks.hpp"
#include "samples/show/lessons.hpp"
#include "samples/show/numbers.hpp"

namespace relevo::show {
namespace {

using Kind = Mark::Kind;
using raster::FillRule;
using raster::InsideRule;
using raster::PixelBox;
using raster::ScanEdge;
using raster::Shape;
using raster::ShapeKind;
using raster::SnappedPoint;

constexpr std::size_t most_frames = 48;
constexpr int most_columns = 64, most_rows = 48;  // of pixels in a lesson
constexpr std::size_t most_labels = 16;           // edges with a name in the picture
constexpr Rgba8 lit = sky, lit_now = yellow;

// ---------------------------------------------------------------------------------------------- words

Spot spot_of(const SnappedPoint& p) { return {(p.x - 128) / 256.0, (p.y - 128) / 256.0}; }

// Places in the words of the scene file.
struct Words {
    const scene::LessonAxes& axes;
    std::string x(double px) const { return decimals(axes.x_of(px)); }
    std::string y(double py) const { return decimals(axes.y_of(py)); }
    std::string place(Spot p) const { return fmt::format("({}, {})", x(p.x), y(p.y)); }
    std::string pixels(int x0, int x1) const {  // x0 <= x < x1
        if (x0 >= x1) return "no pixel";
        if (x0 + 1 == x1) return "pixel " + x(x0);
        return fmt::format("pixels {} to {}", x(x0), x(x1 - 1));
    }
};

std::string rule_in_words(FillRule rule) {
    return rule == FillRule::TopLeft ? "Centres on left edges and on a level top edge belong to the shape; "
                                       "those on right edges and on "
                                       "a level bottom edge belong to the neighbour there."
                                     : "Centres on left edges and on a level bottom edge belong to the "
                                       "shape; those on right edges and "
                                       "on a level top edge belong to the neighbour there.";
}

Mark cell(int x, int y, Rgba8 color, int level = 255) {
    return show::cell(show::spot_of(raster::Pixel{x, y}), color, level);
}
Spot middle_of(Spot a, Spot b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

// ------------------------------------------------------------------------------- a shape and its pixels

struct Subject {
    const scene::LoadedScene& loaded;
    std::size_t number;  // of the shape
    const Shape& shape;
    FillRule rule;
    Words words;
    std::vector<SnappedPoint> ring;  // the outline, closed by itself
    PixelBox view;
    std::string left_out;  // what the view does not show
};

bool is_area(const Shape& shape) {
    const bool rectangle = shape.kind == ShapeKind::Rectangle && shape.points.size() == 2;
    const bool triangle = shape.kind == ShapeKind::Triangle && shape.points.size() == 3;
    const auto near = [](const glm::vec2& p) {
        return std::abs(p.x) <= raster::largest_place && std::abs(p.y) <= raster::largest_place;
    };
    return (rectangle || triangle || (shape.kind == ShapeKind::Polygon && shape.points.size() >= 3)) &&
           shape.antialiasing == raster::Antialiasing::None &&
           std::all_of(shape.points.begin(), shape.points.end(), near);
}

std::vector<SnappedPoint> ring_of(const Shape& shape) {
    std::vector<SnappedPoint> ring;
    for (const glm::vec2& p : shape.points) ring.push_back(raster::snapped(p.x, p.y));
    if (shape.kind == ShapeKind::Rectangle)
        ring = {ring[0], {ring[1].x, ring[0].y}, ring[1], {ring[0].x, ring[1].y}};
    return ring;
}

// The pixels round the outline that lie in the picture, and not too many of them.
std::optional<Subject> subject_of(const scene::LoadedScene& loaded, std::size_t number) {
    const Shape& shape = loaded.shapes.shapes[number];
    if (!is_area(shape)) return {};
    Subject s{loaded, number, shape, loaded.shapes.fill_rule, {loaded.axes}, ring_of(shape), {}, {}};
    PixelBox all{1 << 30, 1 << 30, -(1 << 30), -(1 << 30)};
    for (const SnappedPoint& p : s.ring) {
        all.x0 = std::min(all.x0, (p.x - 128) >> 8), all.x1 = std::max(all.x1, (p.x + 127) >> 8);
        all.y0 = std::min(all.y0, (p.y - 128) >> 8), all.y1 = std::max(all.y1, (p.y + 127) >> 8);
    }
    const PixelBox seen{std::max(all.x0 - 1, 0), std::max(all.y0 - 1, 0),
                        std::min(all.x1 + 1, loaded.width - 1), std::min(all.y1 + 1, loaded.height - 1)};
    if (seen.empty()) return {};
    s.view = {seen.x0, seen.y0, std::min(seen.x1, seen.x0 + most_columns - 1),
              std::min(seen.y1, seen.y0 + most_rows - 1)};
    if (s.view.x1 < seen.x1 || s.view.y1 < seen.y1)
        s.left_out = fmt::format(" Only its first {} columns and {} rows are shown here.",
                                 s.view.x1 - s.view.x0 + 1, s.view.y1 - s.view.y0 + 1);
    if (loaded.shapes.clip.on)
        s.left_out += " The shape is drawn whole here; its own lesson shows how it is cut.";
    return s;
}

Lesson lesson_of(const Subject& s, std::string name, std::string title, std::string sentence,
                 std::string source) {
    Lesson lesson;
    lesson.name = std::move(name);
    lesson.title = std::move(title);
    lesson.sentence = std::move(sentence);
    lesson.source = std::move(source);
    lesson.view = s.view;
    if (s.ring.size() <= 5000) {
        Mark outline = mark(Kind::Outline, ink, {});
        for (const SnappedPoint& p : s.ring) outline.points.push_back(spot_of(p));
        lesson.ground.push_back(std::move(outline));
    }
    lesson.legend = {{Kind::Cell, lit, "lit pixel"}, {Kind::Cell, lit_now, "lit in this step"}};
    return lesson;
}

// Frames in the order of the rows. When there are too many, the unimportant ones are thinned evenly; the next
// frame that is shown lights their pixels, too.
class Rows {
  public:
    void add(LessonFrame frame, bool important = false) {
        steps_.push_back({std::move(frame), important});
        plain_ += !important;
    }
    bool empty() const { return steps_.empty(); }
    LessonFrame& last() { return steps_.back().frame; }

    void move_to(std::vector<LessonFrame>& out, std::size_t room) {
        const std::size_t important = steps_.size() - plain_,
                          kept = std::min(plain_, room > important ? room - important : 1);
        std::size_t seen = 0, left_out = 0;
        std::vector<Mark> waiting;
        for (Step& step : steps_) {
            if (!step.important) {
                ++seen;  // every plain frame at which kept * seen / plain steps on, so the last one, too
                if (kept * seen / plain_ == kept * (seen - 1) / plain_) {
                    std::ranges::move(step.frame.stays, std::back_inserter(waiting));
                    ++left_out;
                    continue;
                }
                if (left_out > 0)
                    step.frame.caption +=
                        fmt::format(" ({} before this one, treated alike, {} left out here.)",
                                    counted(std::int64_t(left_out), "row"), left_out == 1 ? "is" : "are");
                step.frame.stays.insert(step.frame.stays.begin(), waiting.begin(), waiting.end());
                waiting.clear();
                left_out = 0;
            }
            out.push_back(std::move(step.frame));
        }
    }

  private:
    struct Step {
        LessonFrame frame;
        bool important;
    };
    std::vector<Step> steps_;
    std::size_t plain_ = 0;
};

void light(LessonFrame& frame, int y, int x0, int x1) {
    for (int x = x0; x < x1; ++x) {
        frame.stays.push_back(cell(x, y, lit));
        frame.now.push_back(cell(x, y, lit_now));
    }
}

LessonFrame last_frame(const Subject& s, std::int64_t pixels) {
    LessonFrame frame;
    frame.title = "done";
    frame.equation = counted(pixels, "pixel") + " lit";
    frame.caption = rule_in_words(s.rule) + s.left_out;
    return frame;
}

// Whether the shape covers a pixel.
bool owns(const Subject& s, const Shape& shape, int x, int y) {
    bool covered = false;
    const std::vector<SnappedPoint> ring = ring_of(shape);
    raster::polygon_active_edges(std::span(&ring, 1), shape.inside, s.rule, {x, y, x, y},
                                 [&](int, int, int) { covered = true; });
    return covered;
}

// Figure 5.9: pixels that hold a corner of this shape and of others, and which shape lights them.
std::vector<LessonFrame> shared_corners(const Subject& s) {
    constexpr std::size_t most_shared = 3, most_points = 2000;
    const std::vector<Shape>& shapes = s.loaded.shapes.shapes;
    std::vector<LessonFrame> frames;
    std::size_t points = 0;
    for (const Shape& shape : shapes) points += shape.points.size();
    if (points > most_points) return frames;
    std::set<std::pair<int, int>> told;
    for (const SnappedPoint& corner : s.ring) {
        const int x = corner.x >> 8, y = corner.y >> 8;
        if (frames.size() == most_shared || !s.view.holds(x, y) || !told.insert({x, y}).second) continue;
        std::vector<std::size_t> sharers, owners;
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (!is_area(shapes[i])) continue;
            const std::vector<SnappedPoint> ring = ring_of(shapes[i]);
            if (std::find(ring.begin(), ring.end(), corner) == ring.end()) continue;
            sharers.push_back(i);
            if (owns(s, shapes[i], x, y)) owners.push_back(i);
        }
        if (sharers.size() < 2 || owners.empty()) continue;
        LessonFrame frame;
        std::string who;
        for (const std::size_t i : owners) who += fmt::format("{}shape {}", who.empty() ? "" : ", ", i + 1);
        frame.title = "shared corner " + s.words.place(spot_of(corner));
        frame.equation = fmt::format("{} shapes, pixel {}: lit by {}", sharers.size(),
                                     s.words.place({double(x), double(y)}), who);
        frame.caption =
            owners.size() == 1
                ? "Several shapes meet in this pixel (fig. 5.9). All follow the same rule for "
                  "centres on edges, so "
                  "exactly one of them lights it: no pixel is drawn twice, none is forgotten."
                : "Several shapes meet here (fig. 5.9). They overlap, so more than one lights the pixel.";
        for (const std::size_t i : sharers) {
            const std::vector<SnappedPoint> ring = ring_of(shapes[i]);
            Mark outline = mark(Kind::Outline, accent(i), {});
            Spot center{0, 0};
            for (const SnappedPoint& p : ring) {
                outline.points.push_back(spot_of(p));
                center.x += spot_of(p).x / double(ring.size()),
                    center.y += spot_of(p).y / double(ring.size());
            }
            frame.now.push_back(std::move(outline));
            if (s.view.holds(std::llround(center.x), std::llround(center.y)))
                frame.now.push_back(label(center, accent(i), fmt::format("shape {}", i + 1)));
        }
        frame.now.push_back(cell(x, y, accent(owners.back())));
        frame.now.push_back(mark(Kind::Frame, ink, {{double(x), double(y)}}));
        frames.push_back(std::move(frame));
    }
    return frames;
}

// First frames, rows, the last one, shared corners: at most `most_frames` together.
void finish(const Subject& s, Lesson& lesson, Rows& rows, std::int64_t pixels) {
    std::vector<LessonFrame> shared = shared_corners(s);
    rows.move_to(lesson.frames, most_frames - lesson.frames.size() - shared.size() - 1);
    lesson.frames.push_back(last_frame(s, pixels));
    std::ranges::move(shared, std::back_inserter(lesson.frames));
}

// ------------------------------------------------------------------------------- triangle, row by row

constexpr std::array<Rgba8, 3> edge_colors{blue, vermilion, green};
constexpr std::array<const char*, 3> edge_names{"long edge", "edge 2", "edge 3"};

// Listens to triangle_scan.
struct ScanTeller {
    const Subject& s;
    Lesson& lesson;
    Rows rows;
    SnappedPoint from[3], to[3];
    std::int64_t factor[3] = {1, 1, 1};  // common to the numbers of an edge
    std::int64_t pixels = 0;

    // rest / run without the common factor
    std::string rest(int edge, const ScanEdge& at) const {
        return fmt::format("{}/{}", at.rest / factor[edge], at.run / factor[edge]);
    }
    std::string left_of(int edge, const ScanEdge& at) const {  // "3 - 1/4", "3"
        return s.words.x(at.x) + (at.rest == 0 ? "" : " - " + rest(edge, at));
    }
    std::string told(int edge, const ScanEdge& at) const {  // "3 - 1/4 = 2.75", "3"
        return left_of(edge, at) + (at.rest == 0 ? "" : " = " + s.words.x(at.place()));
    }
    Spot place(const ScanEdge& at, int y) const { return {at.place(), double(y)}; }

    void on(const raster::TriangleClassified& e) {
        const SnappedPoint starts[3] = {e.top, e.top, e.middle}, ends[3] = {e.bottom, e.middle, e.bottom};
        LessonFrame frame;
        frame.title = "which edge is which";
        for (int i = 0; i < 3; ++i) {
            from[i] = starts[i], to[i] = ends[i];
            const Spot a = spot_of(from[i]), b = spot_of(to[i]);
            frame.equation += fmt::format("{}{}: {} rows", i == 0 ? "" : ", ", edge_names[std::size_t(i)],
                                          decimals(b.y - a.y));
            frame.stays.push_back(mark(Kind::Segment, edge_colors[std::size_t(i)], {a, b}));
            frame.now.push_back(
                label(middle_of(a, b), edge_colors[std::size_t(i)], edge_names[std::size_t(i)]));
        }
        frame.caption = fmt::format(
            "The long edge spans all rows, from {} to {}; the others meet at {}. A row lies between the long "
            "edge, "
            "on the {}, and edge 2, further down edge 3.{}",
            s.words.place(spot_of(e.top)), s.words.place(spot_of(e.bottom)), s.words.place(spot_of(e.middle)),
            e.long_is_left ? "left" : "right", s.left_out);
        lesson.frames.push_back(std::move(frame));
    }

    void on(const raster::TriangleEdgeStarted& e) {
        const int i = static_cast<int>(e.edge);
        factor[i] = std::gcd(e.at.run, std::gcd(e.at.rest, e.at.rest_step));
        const std::int64_t run = e.at.run / factor[i], step = e.at.rest_step / factor[i];
        const Spot a = spot_of(from[i]), b = spot_of(to[i]);
        const std::string whole = fmt::format("x {}= {}", e.at.x_step < 0 ? "-" : "+", std::abs(e.at.x_step));
        std::string slope = fmt::format("{}", e.at.x_step);
        if (step != 0) slope = (e.at.x_step == 0 ? "" : slope + " + ") + fmt::format("{}/{}", step, run);
        LessonFrame frame;
        frame.title = fmt::format("{} begins", edge_names[std::size_t(i)]);
        frame.equation = step == 0
                             ? fmt::format("x = {}; a row: {}", left_of(i, e.at), whole)
                             : fmt::format("x = {}; a row: {}, rest -= {}; rest < 0: x += 1, rest += {}",
                                           left_of(i, e.at), whole, step, run);
        frame.caption = fmt::format(
            "It moves by {} columns in {} rows: {} a row. In row y = {} the first centre at or right of it "
            "is "
            "x = {}, {}. Whole numbers only, as for a line.",
            decimals(b.x - a.x), decimals(b.y - a.y), slope, s.words.y(e.y), s.words.x(e.at.x),
            e.at.rest == 0 ? "exactly on it" : "the rest " + rest(i, e.at) + " of a pixel right of it");
        frame.now = {mark(Kind::Segment, edge_colors[std::size_t(i)], {a, b}),
                     mark(Kind::Dot, edge_colors[std::size_t(i)], {place(e.at, e.y)}),
                     mark(Kind::Frame, edge_colors[std::size_t(i)], {{double(e.at.x), double(e.y)}})};
        rows.add(std::move(frame), true);
    }

    void on(const raster::TriangleRow& e) {
        const int left = static_cast<int>(e.left), right = static_cast<int>(e.right);
        LessonFrame frame;
        frame.title = fmt::format("row y = {}", s.words.y(e.y));
        frame.equation = fmt::format("left {}, right {}: {}", told(left, e.left_at), told(right, e.right_at),
                                     s.words.pixels(e.x0, e.x1));
        frame.caption =
            e.left_at.x >= e.right_at.x
                ? fmt::format(
                      "Both edges have the same next centre, x = {}: no pixel's centre lies between them.",
                      s.words.x(e.left_at.x))
                : fmt::format(
                      "From the first centre at or right of the {}, x = {}, up to the first at or right of "
                      "{}, "
                      "x = {}, which is the neighbour's.",
                      edge_names[std::size_t(left)], s.words.x(e.left_at.x),
                      right == 0 ? "the long edge" : edge_names[std::size_t(right)], s.words.x(e.right_at.x));
        frame.now = {mark(Kind::Dashes, muted, {place(e.left_at, e.y), place(e.right_at, e.y)}),
                     mark(Kind::Dot, edge_colors[std::size_t(left)], {place(e.left_at, e.y)}),
                     mark(Kind::Dot, edge_colors[std::size_t(right)], {place(e.right_at, e.y)})};
        light(frame, e.y, e.x0, e.x1);
        pixels += std::max(e.x1 - e.x0, 0);
        frame.row = {s.words.y(e.y), left_of(left, e.left_at), left_of(right, e.right_at),
                     fmt::format("{}", std::max(e.x1 - e.x0, 0))};
        rows.add(std::move(frame));
    }
};

Lesson triangle_scan_lesson(const Subject& s) {
    Lesson lesson =
        lesson_of(s, "triangle-scanline", "Triangle, row by row",
                  "Each row lies between the long edge and one of the two others; their places move "
                  "from row to row in whole numbers.",
                  "textbook section 5.4, algorithm 5.2, fig. 5.10");
    for (Mark& outline : lesson.ground) outline.color = haze;  // the edges get colours of their own
    lesson.columns = {"y", "left", "right", "lit"};
    for (std::size_t i = 0; i < 3; ++i)
        lesson.legend.push_back({Kind::Segment, edge_colors[i], edge_names[i]});
    lesson.legend.push_back({Kind::Dot, blue, "edge meets the row"});
    ScanTeller teller{s, lesson, {}, {}, {}};
    raster::triangle_scan(
        {s.ring[0], s.ring[1], s.ring[2]}, s.rule, s.view, [](int, int, int) {}, teller);
    if (lesson.frames.empty())
        lesson.frames.push_back(
            {"no area", "area = 0", "The corners lie on one line: there is nothing to fill.", {}, {}, {}});
    finish(s, lesson, teller.rows, teller.pixels);
    return lesson;
}

// ------------------------------------------------------------------------- triangle by edge functions

// The edge functions know the top-left rule; the book's is the same in a mirror that lies on the floor.
struct EdgeForm {
    bool mirrored;
    raster::Triangle t;

    int row(int y) const { return mirrored ? -1 - y : y; }
    raster::EdgeValues at(int x, int y) const { return raster::edge_values(t, x, row(y)); }
    Spot corner(int k) const {
        const raster::SnappedCorner& c = t.corner[k];
        return spot_of({c.x, mirrored ? -c.y : c.y});
    }
};

std::optional<EdgeForm> edge_form(const Subject& s) {
    const bool mirrored = s.rule == FillRule::Book;
    raster::SnappedCorner c[3];
    for (std::size_t k = 0; k < 3; ++k) c[k] = {s.ring[k].x, mirrored ? -s.ring[k].y : s.ring[k].y, 0, 1};
    const std::int64_t area = raster::area2(c[0], c[1], c[2]);
    if (area == 0) return {};
    const auto order = raster::canonical_order(c[0], c[1], c[2], area > 0);
    return EdgeForm{mirrored, raster::make_triangle(c[order.index[0]], c[order.index[1]], c[order.index[2]])};
}

// Square pixels: edge values count in 1/65536 of them.
std::string square_pixels(std::int64_t value) { return decimals(static_cast<double>(value) / 65536); }

// "3x - 2y + 5"
std::string plane(std::int64_t a, std::int64_t b, std::int64_t c) {
    std::string text;
    const auto term = [&](std::int64_t value, const char* name) {
        if (value == 0) return;
        text += text.empty() ? (value < 0 ? "-" : "") : (value < 0 ? " - " : " + ");
        const std::string size = square_pixels(std::abs(value));
        text += (size == "1" && *name ? "" : size) + name;
    };
    term(a, "x"), term(b, "y"), term(c, "");
    return text.empty() ? "0" : text;
}

Lesson edge_function_lesson(const Subject& s) {
    Lesson lesson = lesson_of(s, "triangle-edge-function", "Triangle by edge functions",
                              "A pixel is lit when its centre lies on the inner side of all three edges.",
                              "Pineda 1988; compare textbook section 5.4");
    for (Mark& outline : lesson.ground) outline.color = haze;
    lesson.columns = {"x", "y", "E0", "E1", "E2"};
    for (std::size_t k = 0; k < 3; ++k)
        lesson.legend.push_back({Kind::Segment, edge_colors[k], fmt::format("E{} = 0", k)});
    lesson.legend.push_back({Kind::Frame, ink, "pixel of the equation"});
    lesson.legend.push_back({Kind::Cross, ink, "next one outside"});
    Rows rows;
    std::int64_t pixels = 0;
    const auto form = edge_form(s);
    if (!form) {
        lesson.frames.push_back(
            {"no area", "area = 0", "The corners lie on one line: there is nothing to fill.", {}, {}, {}});
        finish(s, lesson, rows, 0);
        return lesson;
    }
    const raster::Triangle& t = form->t;
    const auto value = [&](const raster::EdgeValues& e, int k) {
        return k == 0 ? e.e0 : k == 1 ? e.e1 : e.e2;
    };
    const auto closed = [&](int k) { return t.bias[k] == 0; };

    const scene::LessonAxes& axes = s.loaded.axes;
    const int x0 = static_cast<int>(axes.pixel_x(0)), y0 = static_cast<int>(axes.pixel_y(0)),
              y1 = static_cast<int>(axes.pixel_y(1));
    for (int k = 0; k < 3; ++k) {
        const Rgba8 color = edge_colors[std::size_t(k)];
        const Spot a = form->corner((k + 1) % 3), b = form->corner((k + 2) % 3);
        const std::int64_t origin = value(form->at(x0, y0), k);
        LessonFrame frame;
        frame.title = fmt::format("edge {}: E{}", k, k);
        frame.equation = fmt::format(
            "E{} = {} {} 0", k,
            plane(value(form->at(x0 + 1, y0), k) - origin, value(form->at(x0, y1), k) - origin, origin),
            closed(k) ? "≥" : ">");
        frame.caption = fmt::format(
            "E{} is 0 on the line from {} to {} and grows to the inside. {}", k, s.words.place(a),
            s.words.place(b),
            closed(k) ? (s.rule == FillRule::TopLeft
                             ? "It is a left or top edge: centres on it belong to the triangle."
                             : "It is a left or bottom edge: centres on it belong to the triangle.")
                      : "Centres on this edge belong to the neighbour, so 0 is not enough.");
        for (int y = s.view.y0; y <= s.view.y1; ++y)
            for (int x = s.view.x0; x <= s.view.x1; ++x)
                if (value(form->at(x, y), k) - t.bias[k] >= 0) frame.now.push_back(cell(x, y, color, 60));
        frame.stays.push_back(mark(closed(k) ? Kind::Segment : Kind::Dashes, color, {a, b}));
        frame.now.push_back(label(middle_of(a, b), color, fmt::format("E{} = 0", k)));
        lesson.frames.push_back(std::move(frame));
    }
    lesson.frames.front().caption +=
        fmt::format(" Everywhere E0 + E1 + E2 = {}, twice the area.{}", square_pixels(t.area), s.left_out);

    const auto told = [&](int x, int y) {
        const raster::EdgeValues e = form->at(x, y);
        return fmt::format("E0 = {}, E1 = {}, E2 = {}", square_pixels(e.e0), square_pixels(e.e1),
                           square_pixels(e.e2));
    };
    // why a pixel outside is outside, and which tie let one in
    const auto reason = [&](int x, int y) {
        const raster::EdgeValues e = form->at(x, y);
        for (int k = 0; k < 3; ++k)
            if (value(e, k) < 0) return fmt::format("E{} = {} < 0", k, square_pixels(value(e, k)));
        for (int k = 0; k < 3; ++k)
            if (value(e, k) < t.bias[k]) return fmt::format("E{} = 0 on an edge of the neighbour", k);
        for (int k = 0; k < 3; ++k)
            if (value(e, k) == 0) return fmt::format("E{} = 0 on an edge that belongs to the triangle", k);
        return std::string("all three are positive");
    };
    for (int y = s.view.y0; y <= s.view.y1; ++y) {
        const PixelBox row{s.view.x0, form->row(y), s.view.x1, form->row(y)};
        const raster::Span span = raster::covered_span(t, form->at(s.view.x0, y), row);
        if (span.x0 >= span.x1) continue;
        const bool after = span.x1 <= s.view.x1;
        const int out = after ? span.x1 : span.x0 - 1;
        LessonFrame frame;
        frame.title = fmt::format("row y = {}", s.words.y(y));
        frame.equation =
            fmt::format("at {}: {} -> lit", s.words.place({double(span.x0), double(y)}), told(span.x0, y));
        frame.caption = fmt::format("First lit centre: {}.", reason(span.x0, y));
        light(frame, y, span.x0, span.x1);
        if (out >= s.view.x0) {
            frame.caption +=
                fmt::format(" {} {}: {}, outside.", after ? "After the last one, at" : "Before it, at",
                            s.words.place({double(out), double(y)}), reason(out, y));
            frame.now.push_back(mark(Kind::Cross, ink, {{double(out), double(y)}}));
        }
        frame.now.push_back(mark(Kind::Frame, ink, {{double(span.x0), double(y)}}));
        const raster::EdgeValues e = form->at(span.x0, y);
        frame.row = {s.words.x(span.x0), s.words.y(y), square_pixels(e.e0), square_pixels(e.e1),
                     square_pixels(e.e2)};
        pixels += span.x1 - span.x0;
        rows.add(std::move(frame));
    }
    finish(s, lesson, rows, pixels);
    return lesson;
}

// -------------------------------------------------------------------------------------------- rectangle

struct RectangleTeller {
    const Subject& s;
    Lesson& lesson;

    void on(const raster::RectangleBounded& e) {
        const Spot a = spot_of(e.upper_left), b = spot_of(e.lower_right);
        const bool own_top = s.rule == FillRule::TopLeft;
        LessonFrame sides;
        sides.title = "closed and open sides";
        // as the axes count: with y upwards the top is the larger y
        const bool up = s.loaded.axes.y_up;
        const double low = up ? b.y : a.y, high = up ? a.y : b.y;
        const bool low_closed = up ? !own_top : own_top;
        sides.equation =
            fmt::format("{} ≤ x < {},  {} {} y {} {}", s.words.x(a.x), s.words.x(b.x), s.words.y(low),
                        low_closed ? "≤" : "<", low_closed ? "<" : "≤", s.words.y(high));
        sides.caption = fmt::format(
            "Half-open in both directions: centres on the left and {} side belong to the rectangle, those on "
            "the "
            "right and {} side to its neighbours.{}",
            own_top ? "upper" : "lower", own_top ? "lower" : "upper", s.left_out);
        sides.stays = {
            mark(Kind::Segment, blue, {a, {a.x, b.y}}), mark(Kind::Dashes, vermilion, {{b.x, a.y}, b}),
            mark(own_top ? Kind::Segment : Kind::Dashes, own_top ? blue : vermilion, {a, {b.x, a.y}}),
            mark(own_top ? Kind::Dashes : Kind::Segment, own_top ? vermilion : blue, {{a.x, b.y}, b})};
        lesson.frames.push_back(std::move(sides));

        LessonFrame bounds;
        bounds.title = "first and last pixels";
        if (e.pixels.empty()) {
            bounds.equation = "no centre inside";
            bounds.caption = "No centre lies between the sides: nothing is lit.";
        } else {
            bounds.equation =
                fmt::format("x = {} to {},  y = {} to {}", s.words.x(e.pixels.x0), s.words.x(e.pixels.x1),
                            s.words.y(e.pixels.y0), s.words.y(e.pixels.y1));
            bounds.caption = fmt::format(
                "The first centre at or right of the left side is x = {}; the last one left of the right "
                "side is "
                "x = {}. So it is with the rows.",
                s.words.x(e.pixels.x0), s.words.x(e.pixels.x1));
            bounds.now = {mark(Kind::Frame, blue, {{double(e.pixels.x0), double(e.pixels.y0)}}),
                          mark(Kind::Frame, blue, {{double(e.pixels.x1), double(e.pixels.y1)}})};
        }
        lesson.frames.push_back(std::move(bounds));
    }
};

Lesson rectangle_lesson(const Subject& s) {
    Lesson lesson =
        lesson_of(s, "rectangle", "Rectangle",
                  "Each side belongs either to the rectangle or to its neighbour, so that rectangles "
                  "side by side share no pixel and leave none out.",
                  "textbook section 5.4, fig. 5.8");
    lesson.columns = {"y", "first x", "last x"};
    lesson.ground.clear();
    lesson.legend.push_back({Kind::Segment, blue, "closed side"});
    lesson.legend.push_back({Kind::Dashes, vermilion, "open side"});
    RectangleTeller teller{s, lesson};
    Rows rows;
    std::int64_t pixels = 0;
    raster::rectangle(
        s.ring[0], s.ring[2], s.rule, s.view,
        [&](int y, int x0, int x1) {
            LessonFrame frame;
            frame.title = fmt::format("row y = {}", s.words.y(y));
            frame.equation = fmt::format("y = {}: {}", s.words.y(y), s.words.pixels(x0, x1));
            frame.caption = "Every row has the same pixels.";
            light(frame, y, x0, x1);
            frame.row = {s.words.y(y), s.words.x(x0), s.words.x(x1 - 1)};
            pixels += x1 - x0;
            rows.add(std::move(frame));
        },
        teller);
    finish(s, lesson, rows, pixels);
    return lesson;
}

// ---------------------------------------------------------------------------------------------- polygon

constexpr Rgba8 down_color = blue, up_color = vermilion;

std::string listed(const std::vector<std::string>& words, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < std::min(words.size(), most); ++i) text += (i ? ", " : "") + words[i];
    return words.size() > most ? text + ", …" : text;
}

// Listens to polygon_active_edges.
struct PolygonTeller {
    const Subject& s;
    Lesson& lesson;
    Rows rows;
    std::map<int, raster::TableEdge> edges;  // by number
    std::vector<std::string> entered, left;  // since the last row
    std::int64_t pixels_of_row = 0, pixels = 0;

    void on(const raster::EdgeTableBuilt& e) {
        LessonFrame frame;
        frame.title = "edge table";
        std::vector<std::string> lists;
        for (std::size_t i = 0; i < e.edges.size();) {
            std::string list = fmt::format("y = {}: {}", s.words.y(e.edges[i].first), e.edges[i].number);
            const int row = e.edges[i].first;
            for (++i; i < e.edges.size() && e.edges[i].first == row; ++i)
                list += fmt::format(" {}", e.edges[i].number);
            lists.push_back(std::move(list));
        }
        frame.equation = listed(lists, 5);
        const std::size_t others = s.ring.size() - e.edges.size();
        frame.caption = fmt::format(
            "{}, sorted by the first row of centres that they cross.{} Blue edges run down and count +1, red "
            "ones "
            "run up and count -1.{}",
            counted(std::int64_t(e.edges.size()), "edge"),
            others == 0
                ? ""
                : fmt::format(" The other {} {} none here.", others, others == 1 ? "crosses" : "cross"),
            s.left_out);
        for (const raster::TableEdge& edge : e.edges) {
            const Rgba8 color = edge.winding > 0 ? down_color : up_color;
            const Spot upper = spot_of(edge.upper), lower = spot_of(edge.lower);
            if (e.edges.size() <= most_labels) {
                const bool down = edge.winding > 0;
                frame.now.push_back(mark(Kind::Arrow, color, {down ? upper : lower, down ? lower : upper}));
                frame.now.push_back(label(middle_of(upper, lower), color, fmt::format("{}", edge.number)));
            }
            edges.emplace(edge.number, edge);
        }
        lesson.frames.push_back(std::move(frame));
    }
    void on(const raster::EdgeEnters& e) { entered.push_back(fmt::format("{}", e.edge.number)); }
    void on(const raster::EdgeLeaves& e) { left.push_back(fmt::format("{}", e.edge.number)); }

    void on(const raster::RowCrossed& e) {
        LessonFrame frame;
        frame.title = fmt::format("row y = {}: {}", s.words.y(e.y),
                                  counted(std::int64_t(e.edges.size()), "active edge"));
        const bool odd = s.shape.inside == InsideRule::EvenOdd;
        std::vector<std::string> crossings, numbers, windings{"0"};
        int winding = 0;
        for (std::size_t i = 0; i < e.edges.size(); ++i) {
            const raster::ActiveEdge& edge = e.edges[i];
            const Rgba8 color = edge.winding > 0 ? down_color : up_color;
            winding += edge.winding;
            crossings.push_back(fmt::format("{} ({:+})", s.words.x(edge.at.place()), edge.winding));
            numbers.push_back(fmt::format("{}", edge.number));
            windings.push_back(fmt::format("{}", winding));
            const raster::TableEdge& line = edges.at(edge.number);
            if (e.edges.size() <= most_labels) {
                frame.now.push_back(mark(Kind::Segment, color, {spot_of(line.upper), spot_of(line.lower)}));
                if (i + 1 < e.edges.size() && e.edges[i + 1].at.place() - edge.at.place() >= 2.5)
                    frame.now.push_back(
                        label({(edge.at.place() + e.edges[i + 1].at.place()) / 2, double(e.y)}, ink,
                              fmt::format("{}", winding)));
            }
            frame.now.push_back(mark(Kind::Dot, color, {{edge.at.place(), double(e.y)}}));
        }
        frame.equation = "x = " + listed(crossings, 6);
        if (!entered.empty())
            frame.caption += fmt::format("{} {}. ", entered.size() == 1 ? "Enters: edge" : "Enter: edges",
                                         listed(entered, 8));
        if (!left.empty())
            frame.caption +=
                fmt::format("{} {}. ", left.size() == 1 ? "Leaves: edge" : "Leave: edges", listed(left, 8));
        frame.caption += fmt::format("From left to right the winding number is {}: inside where it is {}.",
                                     listed(windings, 12), odd ? "odd" : "not 0");
        frame.row = {s.words.y(e.y), listed(numbers, 5), "0"};
        pixels_of_row = 0;
        entered.clear(), left.clear();
        rows.add(std::move(frame));
    }

    void on(const raster::PolygonSpan& e) {
        light(rows.last(), e.y, e.x0, e.x1);
        pixels += e.x1 - e.x0;
        pixels_of_row += e.x1 - e.x0;
        rows.last().row.back() = fmt::format("{}", pixels_of_row);
    }
};

Lesson polygon_lesson(const Subject& s) {
    Lesson lesson = lesson_of(s, "polygon-active-edges", "Polygon by active edges",
                              "From row to row a list keeps the edges that cross it, in order from left to "
                              "right: between them lies what "
                              "is inside.",
                              "Wylie, Romney, Evans and Erdahl 1967; textbook section 5.4");
    lesson.columns = {"y", "active edges", "lit"};
    lesson.legend.push_back({Kind::Segment, down_color, "edge down: +1"});
    lesson.legend.push_back({Kind::Segment, up_color, "edge up: -1"});
    lesson.legend.push_back({Kind::Text, ink, "winding number"});
    PolygonTeller teller{s, lesson, {}, {}, {}, {}};
    raster::polygon_active_edges(
        std::span(&s.ring, 1), s.shape.inside, s.rule, s.view, [](int, int, int) {}, teller);
    finish(s, lesson, teller.rows, teller.pixels);
    return lesson;
}

}  // namespace

std::vector<Lesson> area_lessons(const scene::LoadedScene& loaded, std::size_t shape) {
    const auto s = subject_of(loaded, shape);
    if (!s) return {};
    using enum raster::ScanAlgorithm;
    if (s->shape.kind == ShapeKind::Polygon || s->shape.algorithm == ActiveEdges) return {polygon_lesson(*s)};
    if (s->shape.kind == ShapeKind::Rectangle) return {rectangle_lesson(*s)};
    if (s->shape.algorithm == EdgeFunction) return {edge_function_lesson(*s)};
    return {triangle_scan_lesson(*s)};
}

}  // namespace relevo::show
