// Lessons of lines: which pixels an aliased line lights and why, and how Wu's and Gupta and Sproull's lines
// share the light.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "raster/line_dda.hpp"
#include "raster/line_explicit.hpp"
#include "raster/line_gupta_sproull.hpp"
#include "raster/line_midpoint.hpp"
#include "raster/line_outline.hpp"
#include "raster/line_weight.hpp"
#include "raster/line_wu.hpp"
#include "samples/show/lesson_marks.hpp"
#include "samples/show/lessons.hpp"
#include "samples/show/numbers.hpp"

namespace relevo::show {
namespace {

using Kind = Mark::Kind;
using raster::full_coverage;
using raster::LineWalk;
using raster::Pixel;
using raster::PixelBox;
using raster::ScanAlgorithm;
using raster::Shape;
using raster::ShapeKind;

constexpr std::size_t most_frames = 48;
constexpr int most_columns = 48, most_rows = 36;  // of pixels in a lesson
constexpr Rgba8 lit = sky, lit_now = yellow, straight_color = orange, diagonal_color = purple,
                point_color = vermilion;

// ---------------------------------------------------------------------------------------------- words

// Places in the words of the scene file.
struct Words {
    const scene::LessonAxes& axes;
    std::string x(double px) const { return decimals(axes.x_of(px)); }
    std::string y(double py) const { return decimals(axes.y_of(py)); }
    std::string place(double px, double py) const { return fmt::format("({}, {})", x(px), y(py)); }
    std::string place(Pixel p) const { return place(p.x, p.y); }
    // The coordinate along a walk, or across it.
    std::string along(bool steep, double c) const { return steep ? y(c) : x(c); }
    std::string across(bool steep, double c) const { return steep ? x(c) : y(c); }
};

std::string signed_term(std::int64_t value) {  // "+ 6", "- 8"
    return value < 0 ? fmt::format("- {}", -value) : fmt::format("+ {}", value);
}

// ---------------------------------------------------------------------------------------------- marks

using show::spot_of;
Spot spot_of(raster::GridPoint p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

// ------------------------------------------------------------------------------------- what is told

// The lines of a shape and the pixels that are looked at.
struct Subject {
    const Shape& shape;
    Words words;
    std::vector<glm::dvec2> points;
    PixelBox view;
    std::string left_out;  // what the view does not show
    bool several() const { return points.size() > 2; }
};

Pixel nearest_pixel(glm::dvec2 p) {
    return {static_cast<std::int32_t>(std::floor(p.x + 0.5)),
            static_cast<std::int32_t>(std::floor(p.y + 0.5))};
}

bool is_told(const Shape& shape) {
    const bool weighs =
        shape.algorithm == ScanAlgorithm::Wu || shape.algorithm == ScanAlgorithm::GuptaSproull;
    const bool thin = shape.antialiasing == raster::Antialiasing::None && shape.width == 1;
    const auto near = [](double c) { return std::abs(c) <= raster::largest_place; };
    return (shape.kind == ShapeKind::Line || shape.kind == ShapeKind::Polyline) && shape.points.size() >= 2 &&
           (weighs || thin) && shape.width > 0 && near(shape.width) &&
           std::all_of(shape.points.begin(), shape.points.end(),
                       [&](const glm::vec2& p) { return near(p.x) && near(p.y); });
}

// The pixels around the shape that lie in the picture, and not too many of them: those around the pixel where
// it begins.
std::optional<Subject> subject_of(const scene::LoadedScene& loaded, std::size_t number) {
    const Shape& shape = loaded.shapes.shapes[number];
    if (!is_told(shape)) return {};
    Subject s{shape, {loaded.axes}, {shape.points.begin(), shape.points.end()}, {}, {}};
    if (shape.kind == ShapeKind::Line) s.points.resize(2);
    const bool wide = shape.algorithm == ScanAlgorithm::GuptaSproull;
    const int margin = wide ? static_cast<int>(std::ceil(shape.width / 2 + 1)) : 1;
    PixelBox all{1 << 30, 1 << 30, -(1 << 30), -(1 << 30)};
    for (const glm::dvec2& p : s.points) {
        const Pixel q = nearest_pixel(p);
        all = {std::min(all.x0, q.x), std::min(all.y0, q.y), std::max(all.x1, q.x), std::max(all.y1, q.y)};
    }
    const PixelBox seen{std::max(all.x0 - margin, 0), std::max(all.y0 - margin, 0),
                        std::min(all.x1 + margin, loaded.width - 1),
                        std::min(all.y1 + margin, loaded.height - 1)};
    if (seen.empty()) return {};
    s.view = seen;
    const int columns = seen.x1 - seen.x0 + 1, rows = seen.y1 - seen.y0 + 1;
    if (columns > most_columns || rows > most_rows) {
        std::optional<Pixel> begin;
        for (std::size_t i = 0; i + 1 < s.points.size() && !begin; ++i)
            raster::line_midpoint(nearest_pixel(s.points[i]), nearest_pixel(s.points[i + 1]), seen,
                                  [&](int x, int y) {
                                      begin = begin ? begin : Pixel{x, y};
                                  });
        const Pixel at = begin.value_or(Pixel{seen.x0, seen.y0});
        const auto window = [](int from, int to, int middle, int most) {
            const int low = std::clamp(middle - most / 2, from, std::max(from, to - most + 1));
            return std::pair{low, std::min(to, low + most - 1)};
        };
        std::tie(s.view.x0, s.view.x1) = window(seen.x0, seen.x1, at.x, most_columns);
        std::tie(s.view.y0, s.view.y1) = window(seen.y0, seen.y1, at.y, most_rows);
        s.left_out = fmt::format(" Of its {} columns and {} rows, {} and {} are shown here.", columns, rows,
                                 s.view.x1 - s.view.x0 + 1, s.view.y1 - s.view.y0 + 1);
    }
    if (loaded.shapes.clip.on) s.left_out += " The window of the scene is not looked at here.";
    return s;
}

// A lesson that grows: pixels are lit once, and what is too much for one lesson goes into one last frame.
class Story {
  public:
    Story(const Subject& subject, std::string name, std::string title, std::string sentence,
          std::string source)
        : subject_(subject) {
        lesson_.name = std::move(name), lesson_.title = std::move(title);
        lesson_.sentence = std::move(sentence) + subject.left_out, lesson_.source = std::move(source);
        lesson_.view = subject.view;
        for (std::size_t i = 0; i + 1 < subject.points.size() && i < 2000; ++i) {
            const glm::dvec2 &a = subject.points[i], &b = subject.points[i + 1];
            lesson_.ground.push_back(mark(Kind::Segment, ink, {{a.x, a.y}, {b.x, b.y}}));
        }
        lesson_.legend.push_back({Kind::Segment, ink, "the true line"});
    }
    Lesson& lesson() { return lesson_; }

    // The pixel gets light for good, and is bright in this frame.
    void light(LessonFrame& frame, Pixel p, int coverage = full_coverage) {
        if (!subject_.view.holds(p.x, p.y)) return;
        if (lit_.insert({p.y, p.x}).second) frame.stays.push_back(cell(spot_of(p), lit, level_of(coverage)));
        frame.now.insert(frame.now.begin(), cell(spot_of(p), lit_now, level_of(coverage)));
    }

    void add(LessonFrame frame) {
        if (lesson_.frames.size() + 2 < most_frames) return lesson_.frames.push_back(std::move(frame));
        if (last_) {
            std::move(last_->stays.begin(), last_->stays.end(), std::back_inserter(rest_));
            ++left_out_;
        }
        last_ = std::move(frame);
    }

    std::vector<Lesson> told() {
        if (left_out_ > 0)
            lesson_.frames.push_back(
                {fmt::format("{} more", counted(left_out_, "moment")),
                 "",
                 "They follow the same rule and are left out here; their pixels are lit.",
                 std::move(rest_),
                 {},
                 {}});
        if (last_) lesson_.frames.push_back(std::move(*last_));
        if (lesson_.frames.empty())
            lesson_.frames.push_back({"nothing", "", "No pixel is lit here.", {}, {}, {}});
        return {std::move(lesson_)};
    }

  private:
    const Subject& subject_;
    Lesson lesson_;
    std::set<std::pair<int, int>> lit_;
    std::optional<LessonFrame> last_;
    std::vector<Mark> rest_;
    std::int64_t left_out_ = 0;
};

// "line 2: " before titles of a polyline.
std::string prefix(const Subject& s, std::size_t line) {
    return s.several() ? fmt::format("line {}: ", line + 1) : "";
}

// The events of one kind, in order.
template <class Started, class Step>
struct Listener {
    std::optional<Started> started;
    std::vector<Step> steps;
    void on(const Started& e) { started = e; }
    void on(const Step& e) { steps.push_back(e); }
};

// -------------------------------------------------------------------------------- the midpoint line

// Where the two candidates lie on the page.
const char* straight_way(const LineWalk& walk) { return walk.steep ? "S" : "E"; }
const char* diagonal_way(const LineWalk& walk) {
    if (walk.steep) return walk.side > 0 ? "SE" : "SW";
    return walk.side > 0 ? "SE" : "NE";
}

struct Spans {  // the names of the longer and the shorter span
    const char *major, *minor, *along;
};
Spans names_of(const LineWalk& walk) { return walk.steep ? Spans{"dy", "dx", "y"} : Spans{"dx", "dy", "x"}; }

LessonFrame midpoint_start(const Subject& s, const raster::LineStarted& e, std::int64_t first_step,
                           Pixel first) {
    const auto [major, minor, along] = names_of(e.walk);
    LessonFrame frame;
    frame.title = "start at " + s.words.place(first);
    frame.equation =
        fmt::format("d = 2{} - {} = 2*{} - {} = {}", minor, major, e.walk.minor, e.walk.major, e.d);
    if (first_step == 0)
        frame.caption = fmt::format(
            "The walk starts at the end that comes first along {}, whichever end is "
            "named first: A to B is B to A. ",
            along);
    else
        frame.caption = fmt::format(
            "The line starts outside; it comes in at step {} with the d that it has "
            "there. ",
            first_step);
    frame.caption +=
        fmt::format("{} = {}, {} = {}: going {} adds 2{} = {} to d, going {} adds 2({} - {}) = {}.", major,
                    e.walk.major, minor, e.walk.minor, straight_way(e.walk), minor, e.straight,
                    diagonal_way(e.walk), minor, major, e.diagonal);
    return frame;
}

// "2dy - dx = -1" at the start; "-1 + 6 = 5" after a step; the bare number where the line comes in.
std::string midpoint_sum(const raster::LineStarted& e, const raster::LineStep* before,
                         const raster::LineStep& step) {
    const auto [major, minor, along] = names_of(e.walk);
    if (step.step == 0) return fmt::format("2{} - {} = {}", minor, major, step.d);
    if (before == nullptr) return fmt::format("{}", step.d);
    return fmt::format("{} {} = {}", before->d, signed_term(before->diagonal ? e.diagonal : e.straight),
                       step.d);
}

LessonFrame midpoint_step(const Subject& s, const raster::LineStarted& e, const raster::LineStep* before,
                          const raster::LineStep& step) {
    const auto [major, minor, along] = names_of(e.walk);
    const char *straight = straight_way(e.walk), *diagonal = diagonal_way(e.walk);
    const char* choice = step.diagonal ? diagonal : straight;
    LessonFrame frame;
    frame.title = fmt::format("step {} from {}", step.step + 1, s.words.place(step.pixel));
    const char* sign = step.d < 0 ? "< 0" : step.d > 0 ? "> 0" : ": a tie";
    frame.equation = fmt::format(
        "d = {}{}{} -> {}, d += {}", midpoint_sum(e, before, step), step.d == 0 ? "" : " ", sign, choice,
        step.diagonal ? fmt::format("2({} - {})", minor, major) : fmt::format("2{}", minor));
    const Spot middle{static_cast<double>(step.twice_midpoint.x) / 2,
                      static_cast<double>(step.twice_midpoint.y) / 2};
    if (step.d == 0)
        frame.caption = fmt::format(
            "The line passes through the midpoint M {}: both candidates are equally near, and "
            "the rule says straight on.",
            s.words.place(middle.x, middle.y));
    else
        frame.caption =
            fmt::format("The line passes the midpoint M {} on the side of {}, so that pixel is nearer.",
                        s.words.place(middle.x, middle.y), choice);
    const Spot there = spot_of(step.straight_pixel), aside = spot_of(step.diagonal_pixel);
    frame.now = {cell(step.diagonal ? there : aside, step.diagonal ? straight_color : diagonal_color, 60),
                 mark(Kind::Frame, straight_color, {there}), mark(Kind::Frame, diagonal_color, {aside}),
                 mark(Kind::Dot, point_color, {middle}), label(middle, point_color, "M")};
    frame.row = {fmt::format("{}", step.step + 1), s.words.x(step.pixel.x), s.words.y(step.pixel.y),
                 fmt::format("{}", step.d), choice};
    return frame;
}

std::vector<Lesson> midpoint_lesson(const Subject& s) {
    Story story(
        s, "line-midpoint", "Midpoint line",
        "From pixel to pixel the line goes straight on or diagonally: the sign of d, a whole number that "
        "is carried by additions, says on which side of the midpoint between the two the line passes.",
        "Bresenham 1965; textbook section 5.1, algorithm 5.1");
    Lesson& lesson = story.lesson();
    lesson.columns = {"step", "x", "y", "d", "choice"};
    const LineWalk first = raster::line_walk(nearest_pixel(s.points[0]), nearest_pixel(s.points[1]));
    const auto candidate = [&](const char* way, const char* general) {
        return s.several() ? fmt::format("candidate {}", general) : fmt::format("candidate {}", way);
    };
    std::ranges::copy(
        std::vector<LegendEntry>{{Kind::Cell, lit, "lit"},
                                 {Kind::Cell, lit_now, "lit now"},
                                 {Kind::Frame, straight_color, candidate(straight_way(first), "straight on")},
                                 {Kind::Frame, diagonal_color, candidate(diagonal_way(first), "diagonal")},
                                 {Kind::Dot, point_color, "midpoint M between them"}},
        std::back_inserter(lesson.legend));
    for (std::size_t line = 0; line + 1 < s.points.size(); ++line) {
        Listener<raster::LineStarted, raster::LineStep> heard;
        std::vector<Pixel> pixels;
        raster::line_midpoint(
            nearest_pixel(s.points[line]), nearest_pixel(s.points[line + 1]), s.view,
            [&](int x, int y) {
                pixels.push_back({x, y});
            },
            heard);
        if (pixels.empty()) continue;
        const LineWalk& walk = heard.started->walk;
        const std::int64_t first_step =
            walk.steep ? std::int64_t{pixels[0].y} - walk.from.y : std::int64_t{pixels[0].x} - walk.from.x;
        LessonFrame start = midpoint_start(s, *heard.started, first_step, pixels[0]);
        start.title = prefix(s, line) + start.title;
        story.light(start, pixels[0]);
        story.add(std::move(start));
        for (std::size_t i = 0; i < heard.steps.size(); ++i) {
            LessonFrame frame =
                midpoint_step(s, *heard.started, i > 0 ? &heard.steps[i - 1] : nullptr, heard.steps[i]);
            frame.title = prefix(s, line) + frame.title;
            story.light(frame, pixels[i + 1]);
            story.add(std::move(frame));
        }
        const auto [major, minor, along] = names_of(walk);
        LessonFrame end;
        const bool complete = first_step + static_cast<std::int64_t>(pixels.size()) == walk.major + 1;
        end.title = prefix(s, line) + (complete ? "the end" : "the view ends");
        end.equation = fmt::format("{} = {}", along,
                                   s.words.along(walk.steep, walk.steep ? pixels.back().y : pixels.back().x));
        end.caption =
            complete ? fmt::format("The other end is reached: {} + 1 = {} pixels for a way of {}.", major,
                                   walk.major + 1,
                                   decimals(raster::vector_length(double(walk.major), double(walk.minor))))
                     : "The line goes on outside of what is shown; there it costs nothing.";
        end.row = {fmt::format("{}", first_step + static_cast<std::int64_t>(pixels.size())),
                   s.words.x(pixels.back().x), s.words.y(pixels.back().y), "", complete ? "end" : "..."};
        story.add(std::move(end));
    }
    return story.told();
}

// ------------------------------------------------------------------------------------------- the foils

std::vector<Lesson> dda_lesson(const Subject& s) {
    Story story(
        s, "line-dda", "DDA line",
        "One addition of the slope a step, in floating point, then rounding. Every sum is rounded, too, and "
        "the errors add up; compare the midpoint line, which has none.",
        "Digital differential analyser; Foley, van Dam, Feiner, Hughes 1990, section 3.2.1");
    Lesson& lesson = story.lesson();
    lesson.columns = {"step", "x", "y", "lit", "off by"};
    lesson.legend.push_back({Kind::Cell, lit, "lit"});
    lesson.legend.push_back({Kind::Cell, lit_now, "lit now"});
    lesson.legend.push_back({Kind::Dot, point_color, "the sum, before rounding"});
    for (std::size_t line = 0; line + 1 < s.points.size(); ++line) {
        Listener<raster::DdaStarted, raster::DdaStep> heard;
        raster::line_dda(
            nearest_pixel(s.points[line]), nearest_pixel(s.points[line + 1]), s.view, [](int, int) {}, heard);
        if (heard.steps.empty()) continue;
        const LineWalk& walk = heard.started->walk;
        const auto [major, minor, along] = names_of(walk);
        const std::string across = walk.steep ? "x" : "y";
        const bool mirrored =
            s.words.axes.y_up;  // a step along, or across, goes the other way in the scene's words
        const double slope = mirrored ? -heard.started->slope : heard.started->slope;
        for (const raster::DdaStep& e : heard.steps) {
            const Spot sum =
                walk.steep ? Spot{e.across, double(e.pixel.y)} : Spot{double(e.pixel.x), e.across};
            const std::string value =
                decimals(walk.steep ? s.words.axes.x_of(sum.x) : s.words.axes.y_of(sum.y), 6);
            const std::string rounded = s.words.across(walk.steep, walk.steep ? e.pixel.x : e.pixel.y);
            LessonFrame frame;
            frame.title = fmt::format("{}{} = {}", prefix(s, line), along,
                                      s.words.along(walk.steep, walk.steep ? e.pixel.y : e.pixel.x));
            if (&e == &heard.steps.front()) {
                frame.equation = fmt::format("slope = {}{} / {} = {}", slope < 0 ? "-" : "", walk.minor,
                                             walk.major, decimals(slope, 7));
                frame.caption = fmt::format(
                    "{} and {} are {} and {}; the quotient is rounded to 24 bits. The walk "
                    "starts with {} = {}.",
                    minor, major, walk.minor, walk.major, across, value);
            } else {
                frame.equation = fmt::format("{0} = {0} + slope = {1} -> {2}", across, value, rounded);
                frame.caption = fmt::format("The sum {} = {} is nearest to {}: pixel {} is lit.", across,
                                            value, rounded, s.words.place(e.pixel));
            }
            const double start = walk.steep ? walk.from.x : walk.from.y;
            const double exact = walk.major == 0 ? start
                                                 : start + walk.side * double(e.step) * double(walk.minor) /
                                                               double(walk.major);
            frame.row = {fmt::format("{}", e.step), walk.steep ? value : s.words.x(e.pixel.x),
                         walk.steep ? s.words.y(e.pixel.y) : value, s.words.place(e.pixel),
                         number(std::abs(double(e.across) - exact))};
            story.light(frame, e.pixel);
            frame.now.push_back(mark(Kind::Dot, point_color, {sum}));
            story.add(std::move(frame));
        }
    }
    return story.told();
}

struct ExplicitListener : Listener<raster::ExplicitStarted, raster::ExplicitColumn> {
    using Listener::on;
    std::optional<raster::SlopeUndefined> undefined;
    void on(const raster::SlopeUndefined& e) { undefined = e; }
};

std::vector<Lesson> explicit_lesson(const Subject& s) {
    Story story(
        s, "line-explicit", "Explicit line",
        "The equation y = a x + B, once a column. It shows why lines are not drawn so: steep lines get gaps, "
        "vertical ones divide by zero.",
        "textbook section 5.1, y = a x + B");
    Lesson& lesson = story.lesson();
    lesson.columns = {"x", "y", "row", "missed"};
    std::ranges::copy(std::vector<LegendEntry>{{Kind::Cell, lit, "lit"},
                                               {Kind::Cell, lit_now, "lit now"},
                                               {Kind::Dot, point_color, "a x + B, before rounding"},
                                               {Kind::Cross, vermilion, "missed: a gap"}},
                      std::back_inserter(lesson.legend));
    const scene::LessonAxes& axes = s.words.axes;
    for (std::size_t line = 0; line + 1 < s.points.size(); ++line) {
        ExplicitListener heard;
        raster::line_explicit(
            nearest_pixel(s.points[line]), nearest_pixel(s.points[line + 1]), s.view, [](int, int) {}, heard);
        if (heard.undefined) {
            LessonFrame frame;
            frame.title = prefix(s, line) + "a vertical line";
            frame.equation = fmt::format("a = dy / dx = {} / 0: undefined", heard.undefined->dy);
            frame.caption =
                "All points have the same x, so no function of x passes through them. The explicit "
                "form has no answer: nothing is drawn.";
            raster::line_midpoint(
                nearest_pixel(s.points[line]), nearest_pixel(s.points[line + 1]), s.view, [&](int x, int y) {
                    frame.now.push_back(mark(Kind::Cross, vermilion, {{double(x), double(y)}}));
                });
            story.add(std::move(frame));
            continue;
        }
        // In the words of the scene: pixel column -left is x = 0, and y may point up.
        const double a = axes.y_up ? -heard.started->a : heard.started->a;
        const double b = axes.y_of(double(heard.started->a) * axes.pixel_x(0) + heard.started->b);
        const raster::ExplicitColumn* before = nullptr;
        for (const raster::ExplicitColumn& e : heard.steps) {
            const std::string y = decimals(axes.y_of(e.y), 4), row = s.words.y(e.pixel.y);
            const int missed = before == nullptr ? 0 : std::max(std::abs(e.pixel.y - before->pixel.y) - 1, 0);
            LessonFrame frame;
            frame.title = fmt::format("{}x = {}", prefix(s, line), s.words.x(e.x));
            frame.equation = fmt::format("y = a x + B = {} * {} {} {} = {} -> {}", decimals(a, 4),
                                         s.words.x(e.x), b < 0 ? "-" : "+", decimals(std::abs(b), 4), y, row);
            frame.caption =
                missed == 0
                    ? fmt::format("A multiplication and an addition for this column: row {} is nearest.", row)
                    : fmt::format("The slope is {}: from one column to the next the line leaves out {}.",
                                  decimals(a, 4), counted(missed, "row"));
            frame.row = {s.words.x(e.x), y, row, missed == 0 ? "" : fmt::format("{}", missed)};
            story.light(frame, e.pixel);
            for (int k = 1; k <= missed; ++k) {
                const int down = e.pixel.y > before->pixel.y ? 1 : -1, at = before->pixel.y + k * down;
                const double x = std::floor((at - double(heard.started->b)) / heard.started->a + 0.5);
                frame.now.push_back(mark(Kind::Cross, vermilion, {{x, double(at)}}));
            }
            frame.now.push_back(mark(Kind::Dot, point_color, {{double(e.x), e.y}}));
            before = &e;
            story.add(std::move(frame));
        }
    }
    return story.told();
}

// ------------------------------------------------------------------------------------ lines that weigh

std::string share(int coverage) { return decimals(coverage / double(full_coverage)); }

std::vector<Lesson> wu_lesson(const Subject& s) {
    Story story(
        s, "line-wu", "Wu's antialiased line",
        "Two pixels a step share the light: the nearer the line, the brighter. Together they have all of it.",
        "Wu 1991, An efficient antialiasing technique");
    Lesson& lesson = story.lesson();
    lesson.columns = {"x", "y", "first", "second", "together"};
    std::ranges::copy(
        std::vector<LegendEntry>{{Kind::Cell, lit, "has light"},
                                 {Kind::Cell, lit_now, "gets light now"},
                                 {Kind::Frame, straight_color, "first of the pair (upper, left)"},
                                 {Kind::Frame, diagonal_color, "second (lower, right)"},
                                 {Kind::Dot, point_color, "the line passes here"}},
        std::back_inserter(lesson.legend));
    for (std::size_t line = 0; line + 1 < s.points.size(); ++line) {
        Listener<raster::WuStarted, raster::WuPair> heard;
        raster::line_wu(
            s.points[line], s.points[line + 1], s.view, [](int, int, int, int) {}, heard);
        for (const raster::WuPair& e : heard.steps) {
            const bool steep = heard.started->track.steep;
            const auto [near, far] = steep ? std::pair{"left", "right"} : std::pair{"upper", "lower"};
            const Spot at = steep ? Spot{e.position, double(e.column)} : Spot{double(e.column), e.position};
            const auto pixel = [&](int i) {
                const auto row = static_cast<std::int32_t>(e.row + i),
                           column = static_cast<std::int32_t>(e.column);
                return steep ? Pixel{row, column} : Pixel{column, row};
            };
            const bool whole = e.extent == full_coverage;
            const double f = e.position - static_cast<double>(e.row);
            LessonFrame frame;
            frame.title = fmt::format("{}{} = {}", prefix(s, line), steep ? "y" : "x",
                                      s.words.along(steep, double(e.column)));
            frame.equation =
                whole ? fmt::format("f = {0} -> {1} 1 - f = {2}, {3} f = {4}", decimals(f), near,
                                    share(e.light[0]), far, share(e.light[1]))
                      : fmt::format("f = {0}, {5} of the width -> {1} {2}, {3} {4}", decimals(f), near,
                                    share(e.light[0]), far, share(e.light[1]), share(e.extent));
            frame.caption =
                whole ? fmt::format(
                            "The line passes at {} = {}, f below the {} pixel: the two share the light by "
                            "their distance.",
                            steep ? "x" : "y", s.words.across(steep, e.position), near)
                      : fmt::format(
                            "The line ends in this {}: it passes {} of its width, and only that part of "
                            "the light is shared.",
                            steep ? "row" : "column", share(e.extent));
            if (steep && whole)
                frame.caption = fmt::format(
                    "The line passes at x = {}, f to the right of the left pixel: the two share the "
                    "light by their distance.",
                    s.words.x(e.position));
            frame.row = {s.words.x(at.x), s.words.y(at.y), share(e.light[0]), share(e.light[1]),
                         share(e.extent)};
            for (int i = 0; i < 2; ++i)
                if (e.light[i] > 0) story.light(frame, pixel(i), e.light[i]);
            frame.now.push_back(mark(Kind::Frame, straight_color, {spot_of(pixel(0))}));
            frame.now.push_back(mark(Kind::Frame, diagonal_color, {spot_of(pixel(1))}));
            frame.now.push_back(mark(Kind::Dot, point_color, {at}));
            story.add(std::move(frame));
        }
    }
    return story.told();
}

struct GuptaSproullListener {
    struct Column {
        raster::GuptaSproullColumn column;
        std::vector<raster::GuptaSproullPixel> pixels;
    };
    std::optional<raster::GuptaSproullStarted> started;
    std::vector<Column> columns;
    void on(const raster::GuptaSproullStarted& e) { started = e; }
    void on(const raster::GuptaSproullColumn& e) { columns.push_back({e, {}}); }
    void on(const raster::GuptaSproullPixel& e) { columns.back().pixels.push_back(e); }
};

std::vector<Lesson> gupta_sproull_lesson(const Subject& s) {
    Story story(s, "line-gupta-sproull", "Gupta and Sproull's antialiased line",
                "Each pixel looks at the line through a cone of radius 1 around its centre. What it sees "
                "depends on its "
                "distance t from the line alone, and stands in a table.",
                "Gupta and Sproull 1981, Filtering edges for gray-scale displays; textbook section 8.2");
    Lesson& lesson = story.lesson();
    lesson.columns = {"x", "y", "t", "table", "all weights"};
    std::ranges::copy(std::vector<LegendEntry>{{Kind::Outline, green, "the line with its width"},
                                               {Kind::Cell, lit, "has light"},
                                               {Kind::Cell, lit_now, "gets light now"},
                                               {Kind::Frame, straight_color, "the nearest pixel"},
                                               {Kind::Curve, diagonal_color, "its cone: radius 1"},
                                               {Kind::Segment, point_color, "its distance t"}},
                      std::back_inserter(lesson.legend));
    for (std::size_t line = 0; line + 1 < s.points.size(); ++line) {
        const glm::dvec2 a = s.points[line], b = s.points[line + 1];
        const auto corners = raster::line_outline(a, b, s.shape.width);
        std::vector<Spot> outline;
        for (const glm::dvec2& c : corners) outline.push_back({c.x, c.y});
        if (line < 2000) lesson.ground.push_back(mark(Kind::Outline, green, outline));
        GuptaSproullListener heard;
        raster::line_gupta_sproull(
            a, b, s.shape.width, s.view, [](int, int, int, int) {}, heard);
        const double width = s.shape.width;
        for (const auto& [e, pixels] : heard.columns) {
            if (pixels.empty()) continue;
            const bool steep = heard.started->track.steep;
            const Spot nearest =
                steep ? Spot{double(e.row), double(e.column)} : Spot{double(e.column), double(e.row)};
            const auto found =
                std::find_if(pixels.begin(), pixels.end(), [&](const raster::GuptaSproullPixel& p) {
                    return double(p.pixel.x) == nearest.x && double(p.pixel.y) == nearest.y;
                });
            const raster::GuptaSproullPixel& middle = found == pixels.end() ? pixels.front() : *found;
            const Spot center = spot_of(middle.pixel);
            const double t = middle.distance;
            LessonFrame frame;
            frame.title = fmt::format("{}{} = {}", prefix(s, line), steep ? "y" : "x",
                                      s.words.along(steep, double(e.column)));
            frame.equation = fmt::format("t = {}: H({}) - H({}) = {}", decimals(std::abs(t)),
                                         decimals(std::abs(t) + width / 2), decimals(std::abs(t) - width / 2),
                                         decimals(middle.strip));
            if (middle.end < 1)
                frame.equation += fmt::format(", * {} = {}", decimals(middle.end), share(middle.coverage));
            std::string weights;
            for (const raster::GuptaSproullPixel& p : pixels)
                weights += (weights.empty() ? "" : " ") + share(p.coverage);
            frame.caption = fmt::format(
                "{} is {} from the middle of the line: of a line {} wide its cone sees {}.{} "
                "Light of this {}: {}.",
                s.words.place(middle.pixel), decimals(std::abs(t)), decimals(width), decimals(middle.strip),
                middle.end < 1 ? " The line's end leaves a part of that." : "", steep ? "row" : "column",
                weights);
            frame.row = {s.words.x(center.x), s.words.y(center.y), decimals(std::abs(t)),
                         decimals(middle.strip), weights};
            for (const raster::GuptaSproullPixel& p : pixels) story.light(frame, p.pixel, p.coverage);
            // From the pixel straight to the line: against its direction's normal.
            const double cosine = heard.started->cosine, sine = heard.started->sine;
            const Spot foot = steep ? Spot{center.x - t * cosine, center.y + t * sine}
                                    : Spot{center.x + t * sine, center.y - t * cosine};
            frame.now.push_back(mark(Kind::Frame, straight_color, {center}));
            frame.now.push_back({Kind::Curve, diagonal_color, {center}, 1, 1, 255, {}});
            frame.now.push_back(mark(Kind::Segment, point_color, {center, foot}));
            story.add(std::move(frame));
        }
    }
    return story.told();
}

// ----------------------------------------------------------------------------------------- even weight

std::vector<Lesson> even_weight_lesson(const Subject& s) {
    Story story(
        s, "line-even-weight", "Lines of even weight",
        "An aliased line has one pixel a step, however long the step is: at 45 degrees the same pixels have "
        "to "
        "do for a way 1.41 times as long, and the line looks thinner. Dimming all others makes them alike.",
        "Foley, van Dam, Feiner, Hughes 1990, section 3.2.3");
    Lesson& lesson = story.lesson();
    lesson.columns = {"line", "steps", "length", "steps/length", "weight"};
    lesson.legend.push_back({Kind::Cell, lit_now, "lit in full"});
    lesson.legend.push_back({Kind::Cell, lit, "dimmed"});
    for (std::size_t line = 0; line + 1 < s.points.size(); ++line) {
        const Pixel a = nearest_pixel(s.points[line]), b = nearest_pixel(s.points[line + 1]);
        const LineWalk walk = raster::line_walk(a, b);
        if (walk.major == 0) continue;
        const double length = raster::vector_length(double(walk.major), double(walk.minor));
        const int weight = raster::line_weight(a, b);
        const auto [major, minor, along] = names_of(walk);
        LessonFrame full, dimmed;
        raster::line_midpoint(a, b, s.view, [&](int x, int y) {
            full.now.push_back(cell({double(x), double(y)}, lit_now));
            story.light(dimmed, {x, y}, weight);
        });
        dimmed.now.clear();
        full.title = prefix(s, line) + "how many pixels a length";
        full.equation = fmt::format("{} / length = {} / {} = {}", major, walk.major, decimals(length),
                                    decimals(double(walk.major) / length));
        full.caption = fmt::format(
            "{} steps go a way of {}: {} pixels a length. A line along an axis has 1, a diagonal "
            "only 0.707.",
            walk.major, decimals(length), decimals(double(walk.major) / length));
        dimmed.title = prefix(s, line) + "the weight";
        dimmed.equation = fmt::format("w = length / (1.414 {}) = {} / {} = {}", major, decimals(length),
                                      decimals(std::sqrt(2.0) * double(walk.major)), share(weight));
        dimmed.caption =
            fmt::format("Dimmed to {}, the line has the same light a length as a diagonal: {} * {} = 0.707.",
                        share(weight), share(weight), decimals(double(walk.major) / length));
        dimmed.row = {fmt::format("{}", line + 1), fmt::format("{}", walk.major), decimals(length),
                      decimals(double(walk.major) / length), share(weight)};
        story.add(std::move(full));
        story.add(std::move(dimmed));
    }
    return story.told();
}

}  // namespace

std::vector<Lesson> line_lessons(const scene::LoadedScene& loaded, std::size_t shape) {
    const std::optional<Subject> subject = subject_of(loaded, shape);
    if (!subject) return {};
    const Subject& s = *subject;
    switch (s.shape.algorithm) {
        case ScanAlgorithm::Wu:
            return wu_lesson(s);
        case ScanAlgorithm::GuptaSproull:
            return gupta_sproull_lesson(s);
        default:
            break;
    }
    std::vector<Lesson> lessons = s.shape.algorithm == ScanAlgorithm::Dda        ? dda_lesson(s)
                                  : s.shape.algorithm == ScanAlgorithm::Explicit ? explicit_lesson(s)
                                                                                 : midpoint_lesson(s);
    if (s.shape.even_weight) std::ranges::move(even_weight_lesson(s), std::back_inserter(lessons));
    return lessons;
}

}  // namespace relevo::show
