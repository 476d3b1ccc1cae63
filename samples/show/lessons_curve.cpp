// Lessons of circles and ellipses: the walk of the midpoint along an octant or a quarter, the parts that a
// window cuts, the rows of a filled one, and exact areas.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "raster/circle_second_order.hpp"
#include "raster/curve_coverage.hpp"
#include "raster/disc.hpp"
#include "raster/ellipse_second_order.hpp"
#include "raster/ellipse_textbook.hpp"
#include "samples/show/lesson_marks.hpp"
#include "samples/show/lessons.hpp"
#include "samples/show/numbers.hpp"

namespace relevo::show {
namespace {

using Kind = Mark::Kind;
using raster::CirclePart;
using raster::EllipseChoice;
using raster::Pixel;
using raster::PixelBox;
using raster::ScanAlgorithm;
using raster::Shape;
using raster::ShapeKind;

constexpr std::size_t most_frames = 48;
constexpr int most_columns = 64, most_rows = 48;  // of pixels in a lesson
constexpr Rgba8 lit = sky, lit_now = yellow, east_color = orange, south_east_color = purple,
                south_color = green, point_color = vermilion;
constexpr Rgba8 accepted_lit{110, 200, 160, 255};
constexpr int mirrored_level = 90, discarded_level = 130, computed_level = 255;

// ---------------------------------------------------------------------------------------------- words

const char* word_of(EllipseChoice choice) {
    constexpr std::array<const char*, 3> words{"E", "SE", "S"};
    return words[static_cast<std::size_t>(choice)];
}

// "- 6" or "+ 6"
std::string signed_term(std::int64_t value) {
    return value < 0 ? fmt::format("- {}", -value) : fmt::format("+ {}", value);
}

// "d = -3 < 0 -> E"
std::string decision(std::int64_t d, const char* choice) {
    return fmt::format("d = {} {} -> {}", d, d < 0 ? "< 0" : ">= 0", choice);
}

// ---------------------------------------------------------------------------------------------- marks

// ------------------------------------------------------------------------------------- what is told

// The shape as draw_shapes.hpp takes it (in whole pixels, when it is not smooth), and the pixels that are
// looked at.
struct Subject {
    const Shape& shape;
    const scene::LessonAxes& axes;
    Pixel center;
    int a, b;
    Spot true_center;  // of the curve that is approximated, and its radii
    double true_a, true_b;
    PixelBox view;
    std::string left_out;  // what the view does not show

    // Lessons look at the part from the top to the right: x and y from the centre, y upwards.
    Spot spot(double x, double y) const { return {center.x + x, center.y - y}; }
    std::string place(Spot p) const {
        return fmt::format("({}, {})", decimals(axes.x_of(p.x)), decimals(axes.y_of(p.y)));
    }
    bool round() const { return a == b; }
    std::string name(const char* of_circle, const char* of_ellipse) const {
        return round() ? of_circle : of_ellipse;
    }
    std::string size() const {
        return round() ? fmt::format("R = {}", a) : fmt::format("a = {}, b = {}", a, b);
    }
};

bool is_smooth(const Shape& shape) { return shape.antialiasing != raster::Antialiasing::None; }

std::optional<Subject> subject_of(const scene::LoadedScene& loaded, std::size_t number) {
    const Shape& shape = loaded.shapes.shapes[number];
    const auto near = [](double c) { return std::abs(c) <= raster::largest_place; };
    if (shape.kind != ShapeKind::Circle && shape.kind != ShapeKind::Ellipse) return {};
    if (shape.points.empty() || !(shape.width > 0 && near(shape.width))) return {};
    if (!near(shape.points[0].x) || !near(shape.points[0].y)) return {};
    if (!(shape.radius_x >= 0 && near(shape.radius_x) && shape.radius_y >= 0 && near(shape.radius_y)))
        return {};
    const auto whole = [](double c) { return static_cast<int>(std::floor(c + 0.5)); };
    const Pixel center{whole(shape.points[0].x), whole(shape.points[0].y)};
    Subject s{shape, loaded.axes, center, whole(shape.radius_x), whole(shape.radius_y),
              {},    0,           0,      {0, 0, 0, 0},          {}};
    s.true_center = spot_of(center), s.true_a = s.a, s.true_b = s.b;
    if (is_smooth(shape)) {
        s.true_center = {shape.points[0].x, shape.points[0].y};
        s.true_a = shape.radius_x, s.true_b = shape.radius_y;
    }
    const double edge = is_smooth(shape) ? 1 + (shape.filled ? 0 : shape.width / 2.0) : 1;
    const auto low = [](double c) { return std::max(static_cast<int>(std::floor(c)), 0); };
    const auto high = [](double c, int most) { return std::min(static_cast<int>(std::ceil(c)), most - 1); };
    s.view = {low(s.true_center.x - s.true_a - edge), low(s.true_center.y - s.true_b - edge),
              high(s.true_center.x + s.true_a + edge, loaded.width),
              high(s.true_center.y + s.true_b + edge, loaded.height)};
    if (s.view.empty()) return {};
    const int columns = s.view.x1 - s.view.x0 + 1, rows = s.view.y1 - s.view.y0 + 1;
    if (columns > most_columns || rows > most_rows) {  // what lies to the right of the top and below it
        s.view.x0 = std::clamp(center.x - 3, s.view.x0, std::max(s.view.x0, s.view.x1 - most_columns + 1));
        s.view.x1 = std::min(s.view.x1, s.view.x0 + most_columns - 1);
        s.view.y1 = std::min(s.view.y1, s.view.y0 + most_rows - 1);
        s.left_out = fmt::format(" Of its {} columns and {} rows, {} and {} are shown here.", columns, rows,
                                 s.view.x1 - s.view.x0 + 1, s.view.y1 - s.view.y0 + 1);
    }
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
        Mark curve = mark(Kind::Curve, ink, {subject.true_center});
        curve.radius_x = subject.true_a, curve.radius_y = subject.true_b;
        lesson_.ground.push_back(std::move(curve));
        lesson_.legend.push_back({Kind::Curve, ink, subject.name("the true circle", "the true ellipse")});
    }
    Lesson& lesson() { return lesson_; }
    void explain(Kind kind, Rgba8 color, std::string words) {
        lesson_.legend.push_back({kind, color, std::move(words)});
    }

    // The pixel gets light for good, and is bright in this frame.
    void light(LessonFrame& frame, Pixel p, int level = computed_level, Rgba8 color = lit) {
        if (!subject_.view.holds(p.x, p.y)) return;
        if (lit_.insert({p.y, p.x}).second) frame.stays.push_back(cell(spot_of(p), color, level));
    }
    // The pixel (x, y) from the centre, and its mirror images: four, or eight on a circle.
    void light_all(LessonFrame& frame, int x, int y) {
        const auto [cx, cy] = subject_.center;
        light(frame, {cx + x, cy - y});
        for (const auto& [px, py] : {std::pair{x, y}, std::pair{y, x}}) {
            if (!subject_.round() && px != x) continue;
            for (const int sx : {1, -1})
                for (const int sy : {1, -1}) light(frame, {cx + sx * px, cy - sy * py}, mirrored_level);
        }
        if (subject_.view.holds(cx + x, cy - y))
            frame.now.insert(frame.now.begin(), cell(spot_of({cx + x, cy - y}), lit_now));
    }

    // Moments of which nothing can be seen are told in a number only.
    void add(LessonFrame frame) {
        if (is_out_of_view(frame)) {
            ++out_of_view_;
            return;
        }
        if (lesson_.frames.size() + 2 < most_frames) return lesson_.frames.push_back(std::move(frame));
        if (last_) {
            std::move(last_->stays.begin(), last_->stays.end(), std::back_inserter(rest_));
            ++left_out_;
        }
        last_ = std::move(frame);
    }

    Lesson told() {
        if (out_of_view_ > 0)
            lesson_.sentence +=
                fmt::format(" {} outside of what is shown {} left out.", counted(out_of_view_, "moment"),
                            out_of_view_ == 1 ? "is" : "are");
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
        return std::move(lesson_);
    }

  private:
    bool is_out_of_view(const LessonFrame& frame) const {
        const auto visible = [&](const Mark& m) {
            return std::ranges::any_of(m.points, [&](Spot p) {
                return p.x > subject_.view.x0 - 1 && p.x < subject_.view.x1 + 1 &&
                       p.y > subject_.view.y0 - 1 && p.y < subject_.view.y1 + 1;
            });
        };
        return frame.stays.empty() && !frame.now.empty() && std::ranges::none_of(frame.now, visible);
    }

    const Subject& subject_;
    Lesson lesson_;
    std::set<std::pair<int, int>> lit_;
    std::optional<LessonFrame> last_;
    std::vector<Mark> rest_;
    std::int64_t left_out_ = 0, out_of_view_ = 0;
};

void explain_walk(const Subject& s, Story& story) {
    story.explain(Kind::Cell, lit_now, "computed now");
    story.explain(Kind::Cell, lit, "computed");
    story.explain(Kind::Cell, mixed(paper, lit, mirrored_level), "its mirror images");
    story.explain(Kind::Frame, east_color, "candidate E");
    story.explain(Kind::Frame, south_east_color, "candidate SE");
    if (!s.round()) story.explain(Kind::Frame, south_color, "candidate S");
    story.explain(Kind::Dot, point_color, "midpoint M between them");
    if (s.round()) {
        const double end = s.a + 0.5;
        story.lesson().ground.push_back(mark(Kind::Dashes, muted, {s.spot(0, 0), s.spot(0, end)}));
        story.lesson().ground.push_back(
            mark(Kind::Dashes, muted, {s.spot(0, 0), s.spot(0.75 * end, 0.75 * end)}));
        story.explain(Kind::Dashes, muted, "the octant that is computed");
    }
}

// The two candidates of a step and the midpoint between them.
void show_choice(const Subject& s, LessonFrame& frame, int region, int x, int y, EllipseChoice choice) {
    const auto candidate = [&](EllipseChoice which, int cx, int cy) {
        constexpr std::array<Rgba8, 3> colors{east_color, south_east_color, south_color};
        const Rgba8 color = colors[static_cast<std::size_t>(which)];
        if (which != choice) frame.now.push_back(cell(s.spot(cx, cy), color, 60));
        frame.now.push_back(mark(Kind::Frame, color, {s.spot(cx, cy)}));
    };
    if (region == 1)
        candidate(EllipseChoice::E, x + 1, y);
    else
        candidate(EllipseChoice::S, x, y - 1);
    candidate(EllipseChoice::SE, x + 1, y - 1);
    const Spot middle = region == 1 ? s.spot(x + 1, y - 0.5) : s.spot(x + 0.5, y - 1);
    frame.now.push_back(mark(Kind::Dot, point_color, {middle}));
    frame.now.push_back(label(middle, point_color, "M"));
}

// Where M lies, and what follows.
std::string midpoint_words(const Subject& s, double x, double y, std::int64_t d, EllipseChoice choice) {
    const std::string in_picture = s.place(s.spot(x, y)),
                      from_center = fmt::format("({}, {})", decimals(x), decimals(y));
    return fmt::format("M {}{} lies {} the {}: {} is nearer.", in_picture,
                       in_picture == from_center ? "" : ", from the centre " + from_center + ",",
                       d < 0 ? "inside" : "outside or on", s.name("circle", "ellipse"), word_of(choice));
}

const char* from_the_center = "x and y count from the centre, y upwards.";

// ------------------------------------------------------------------------------------------- circles

LessonFrame circle_start(const Subject& s, Story& story) {
    LessonFrame frame;
    frame.title = "start at the top";
    frame.equation = fmt::format("d = 1 - R = 1 - {} = {}", s.a, 1 - s.a);
    frame.caption = fmt::format(
        "Only the octant from the top to the diagonal is computed: its pixels are mirrored to the other "
        "seven. {} The centre is {}.",
        from_the_center, s.place(spot_of(s.center)));
    story.light_all(frame, 0, s.a);
    return frame;
}

// After the choice: the new pixel, or the end of the octant.
void circle_choice(const Subject& s, Story& story, LessonFrame& frame, int x, int y, int d, bool east) {
    const EllipseChoice choice = east ? EllipseChoice::E : EllipseChoice::SE;
    const int next_y = east ? y : y - 1;
    frame.caption = midpoint_words(s, x + 1, y - 0.5, d, choice);
    show_choice(s, frame, 1, x, y, choice);
    if (x + 1 <= next_y)
        story.light_all(frame, x + 1, next_y);
    else
        frame.caption += " It lies beyond the diagonal, where x > y: the octant is done.";
}

Lesson radius_zero(Story story, const Subject& s) {
    LessonFrame frame;
    frame.title = "radius 0";
    frame.caption = "A circle of radius 0 is one pixel.";
    story.light(frame, s.center);
    story.add(std::move(frame));
    return story.told();
}

Lesson circle_midpoint_lesson(const Subject& s) {
    Story story(s, "circle-midpoint", "Midpoint circle",
                "From pixel to pixel the circle goes to E or to SE: the sign of d, a whole number that is "
                "carried by additions, says whether the midpoint between the two lies inside.",
                "Bresenham 1977; textbook section 5.2, figures 5.4 and 5.5");
    explain_walk(s, story);
    if (s.a == 0) return radius_zero(std::move(story), s);
    story.lesson().columns = {"step", "x", "y", "d", "choice", "d += "};
    struct Probe {
        std::vector<raster::CircleStep> steps;
        void on(const raster::CircleStep& e) { steps.push_back(e); }
    } heard;
    raster::circle_midpoint(
        {0, 0}, s.a, {-s.a, -s.a, s.a, s.a}, [](int, int) {}, heard);
    story.add(circle_start(s, story));
    for (std::size_t i = 0; i < heard.steps.size(); ++i) {
        const auto& [x, y, d, east] = heard.steps[i];
        const int change = east ? 2 * x + 3 : 2 * x - 2 * y + 5;
        LessonFrame frame;
        frame.title = fmt::format("step {} from x = {}, y = {}", i + 1, x, y);
        frame.equation = fmt::format("{}, d += {} = {}", decision(d, east ? "E" : "SE"),
                                     east ? "2x + 3" : "2x - 2y + 5", change);
        circle_choice(s, story, frame, x, y, d, east);
        frame.row = {fmt::to_string(i + 1), fmt::to_string(x), fmt::to_string(y),
                     fmt::to_string(d),     east ? "E" : "SE", fmt::to_string(change)};
        story.add(std::move(frame));
    }
    return story.told();
}

Lesson circle_second_order_lesson(const Subject& s) {
    Story story(s, "circle-second-order", "Circle by second differences",
                "The increments of d grow evenly from pixel to pixel, so they are carried by additions, too: "
                "no multiplication is left.",
                "Textbook section 5.2, second-order differences");
    explain_walk(s, story);
    if (s.a == 0) return radius_zero(std::move(story), s);
    story.lesson().columns = {"step", "x", "y", "d", "delta E", "delta SE", "choice"};
    struct Probe {
        std::vector<raster::CircleSecondOrderStep> steps;
        void on(const raster::CircleSecondOrderStep& e) { steps.push_back(e); }
    } heard;
    raster::circle_second_order(
        {0, 0}, s.a, {-s.a, -s.a, s.a, s.a}, [](int, int) {}, heard);
    LessonFrame start = circle_start(s, story);
    start.equation += fmt::format(", delta E = 3, delta SE = 5 - 2R = {}", 5 - 2 * s.a);
    story.add(std::move(start));
    for (std::size_t i = 0; i < heard.steps.size(); ++i) {
        const auto& [x, y, d, to_east, to_south_east, east] = heard.steps[i];
        LessonFrame frame;
        frame.title = fmt::format("step {} from x = {}, y = {}", i + 1, x, y);
        frame.equation =
            fmt::format("{}, d += {}, delta E += 2, delta SE += {}", decision(d, east ? "E" : "SE"),
                        east ? to_east : to_south_east, east ? 2 : 4);
        circle_choice(s, story, frame, x, y, d, east);
        frame.caption +=
            fmt::format(" Then d = {}, delta E = {}, delta SE = {}.", d + (east ? to_east : to_south_east),
                        to_east + 2, to_south_east + (east ? 2 : 4));
        frame.row = {fmt::to_string(i + 1), fmt::to_string(x),       fmt::to_string(y),
                     fmt::to_string(d),     fmt::to_string(to_east), fmt::to_string(to_south_east),
                     east ? "E" : "SE"};
        story.add(std::move(frame));
    }
    return story.told();
}

// ------------------------------------------------------------------------------------------ ellipses

// How far the curve falls from column x to the next.
double fall(const Subject& s, int x) {
    const auto height = [&](double at) {
        return s.b * std::sqrt(std::max(0.0, 1 - at * at / (double(s.a) * s.a)));
    };
    return height(x) - height(x + 1);
}

LessonFrame ellipse_start(const Subject& s, Story& story) {
    const std::int64_t a2 = std::int64_t{s.a} * s.a, b2 = std::int64_t{s.b} * s.b;
    LessonFrame frame;
    frame.title = "start at the top";
    frame.equation =
        fmt::format("d = b² - a² b + a²/4 = {} - {} + {} = {}", b2, a2 * s.b, a2 / 4, b2 - a2 * s.b + a2 / 4);
    frame.caption = fmt::format(
        "A quarter of the ellipse is computed and mirrored to the other three: first region 1, where it is "
        "flat, then region 2, where it is steep.{} {} The centre is {}.",
        a2 % 4 ? " The fraction of a²/4 never matters and is dropped." : "", from_the_center,
        s.place(spot_of(s.center)));
    story.light_all(frame, 0, s.b);
    return frame;
}

// What is added to d, in letters and in numbers.
std::pair<std::string, std::int64_t> increment(const Subject& s, int region, int x, int y,
                                               EllipseChoice choice) {
    const std::int64_t a2 = std::int64_t{s.a} * s.a, b2 = std::int64_t{s.b} * s.b;
    if (region == 1) {
        if (choice == EllipseChoice::E) return {"b²(2x + 3)", b2 * (2 * x + 3)};
        return {"b²(2x + 3) + a²(2 - 2y)", b2 * (2 * x + 3) + a2 * (2 - 2 * y)};
    }
    if (choice == EllipseChoice::S) return {"a²(3 - 2y)", a2 * (3 - 2 * y)};
    return {"b²(2x + 2) + a²(3 - 2y)", b2 * (2 * x + 2) + a2 * (3 - 2 * y)};
}

// A frame of the walk up to its caption; the pixel chosen is lit.
LessonFrame ellipse_step(const Subject& s, Story& story, int region, int x, int y, std::int64_t d,
                         EllipseChoice choice) {
    LessonFrame frame;
    frame.title = fmt::format("region {} from x = {}, y = {}", region, x, y);
    const auto [letters, value] = increment(s, region, x, y, choice);
    frame.equation = fmt::format("{}, d += {} = {}", decision(d, word_of(choice)), letters, value);
    const bool first = region == 1;
    frame.caption = midpoint_words(s, first ? x + 1 : x + 0.5, first ? y - 0.5 : y - 1, d, choice);
    show_choice(s, frame, region, x, y, choice);
    story.light_all(frame, choice == EllipseChoice::S ? x : x + 1, choice == EllipseChoice::E ? y : y - 1);
    frame.row = {fmt::to_string(region), fmt::to_string(x), fmt::to_string(y), fmt::to_string(d),
                 word_of(choice)};
    return frame;
}

LessonFrame ellipse_turn(const Subject& s, const raster::EllipseTurned& e, bool printed) {
    const double a2 = double(s.a) * s.a, b2 = double(s.b) * s.b;
    const double down = a2 * (e.y - 0.5), across = b2 * (e.x + 1);
    LessonFrame frame;
    frame.title = fmt::format("region 2 after x = {}, y = {}", e.x, e.y);
    frame.equation = fmt::format("d = b²(x² + x) + b²/4 + a²(y - 1)² - a² b² = {}", e.d);
    const std::string gradient = fmt::format("a²(y - 1/2) = {} {} b²(x + 1) = {}", decimals(down),
                                             down > across ? ">" : "<=", decimals(across));
    if (printed)
        frame.caption = fmt::format(
            "The gradient at the midpoint no longer points down more than across: {}. From here on one pixel "
            "a row: SE or S.",
            gradient);
    else
        frame.caption = fmt::format(
            "From this column to the next the ellipse falls by {} pixels, more than one: from here on one "
            "pixel a row, SE or S. (The textbook compares the gradient at the midpoint: {}.)",
            e.x < s.a ? decimals(fall(s, e.x)) : "more than any number of", gradient);
    frame.now = {mark(Kind::Dot, point_color, {s.spot(e.x + 0.5, e.y - 1)}),
                 label(s.spot(e.x + 0.5, e.y - 1), point_color, "M")};
    return frame;
}

// The row y = 0 from behind x to (a, 0).
void add_tip(const Subject& s, Story& story, int x) {
    if (x >= s.a) return;
    LessonFrame frame;
    frame.title = "the tip";
    frame.equation = fmt::format("y = 0: x = {} to a = {}", x + 1, s.a);
    frame.caption = fmt::format(
        "Region 1 has come down to y = 0 at x = {}, before the tip. There is nothing left to decide: the "
        "row goes on to ({}, 0). The printed algorithm stops here and leaves the tip open.",
        x, s.a);
    for (int next = x + 1; next <= s.a; ++next) story.light_all(frame, next, 0);
    story.add(std::move(frame));
}

// An ellipse without height or width is a line.
Lesson ellipse_line(Story story, const Subject& s) {
    LessonFrame frame;
    frame.title = "a line";
    frame.caption = fmt::format("With {} the ellipse is a line of pixels.", s.size());
    raster::ellipse_midpoint(s.center, s.a, s.b, s.view, [&](int x, int y) { story.light(frame, {x, y}); });
    story.add(std::move(frame));
    return story.told();
}

Lesson ellipse_midpoint_lesson(const Subject& s) {
    Story story(s, "ellipse-midpoint", "Midpoint ellipse",
                "Where the ellipse is flat it has one pixel a column, E or SE; where it is steep one pixel a "
                "row, SE or S. The sign of d says on which side of the midpoint it passes.",
                "Textbook section 5.3, figure 5.7");
    if (s.a == 0 || s.b == 0) return ellipse_line(std::move(story), s);
    explain_walk(s, story);
    story.lesson().columns = {"region", "x", "y", "d", "choice"};
    struct Probe {
        const Subject& s;
        Story& story;
        int x = 0, y = s.b;
        void on(const raster::EllipseStep& e) {
            LessonFrame frame = ellipse_step(s, story, e.region, e.x, e.y, e.d, e.choice);
            if (e.region == 1)
                frame.caption +=
                    fmt::format(" It falls by {} to the next column, by at most one pixel: region 1.",
                                decimals(fall(s, e.x)));
            story.add(std::move(frame));
            x = e.choice == EllipseChoice::S ? e.x : e.x + 1;
            y = e.choice == EllipseChoice::E ? e.y : e.y - 1;
        }
        void on(const raster::EllipseTurned& e) { story.add(ellipse_turn(s, e, false)); }
    } probe{s, story};
    story.add(ellipse_start(s, story));
    raster::ellipse_midpoint(
        {0, 0}, s.a, s.b, {-s.a, -s.b, s.a, s.b}, [](int, int) {}, probe);
    add_tip(s, story, probe.x);
    return story.told();
}

Lesson ellipse_second_order_lesson(const Subject& s) {
    Story story(s, "ellipse-second-order", "Ellipse by second differences",
                "What is added to d has a part that grows with x and a part that grows with y, both evenly: "
                "so both are carried by additions.",
                "Textbook section 5.3, second-order differences");
    if (s.a == 0 || s.b == 0) return ellipse_line(std::move(story), s);
    explain_walk(s, story);
    story.lesson().columns = {"region", "x", "y", "d", "choice", "x part", "y part"};
    struct Probe {
        const Subject& s;
        Story& story;
        int x = 0;
        void on(const raster::EllipseSecondOrderStep& e) {
            LessonFrame frame = ellipse_step(s, story, e.region, e.x, e.y, e.d, e.choice);
            const bool with_x = e.choice != EllipseChoice::S, with_y = e.choice != EllipseChoice::E;
            std::string parts = fmt::format("x part = {}", e.along_x);
            if (!with_x) parts = fmt::format("y part = {}", e.along_y);
            if (with_x && with_y)
                parts = fmt::format("x part + y part = {} {} = {}", e.along_x, signed_term(e.along_y),
                                    e.along_x + e.along_y);
            frame.equation = fmt::format("{}, d += {}", decision(e.d, word_of(e.choice)), parts);
            frame.caption += fmt::format(
                " Then{}{}{}.", with_x ? fmt::format(" the x part grows by 2b² = {}", 2LL * s.b * s.b) : "",
                with_x && with_y ? "," : "",
                with_y ? fmt::format(" the y part {}by 2a² = {}", with_x ? "" : "grows ", 2LL * s.a * s.a)
                       : "");
            frame.row.push_back(fmt::to_string(e.along_x));
            frame.row.push_back(fmt::to_string(e.along_y));
            story.add(std::move(frame));
            x = e.choice == EllipseChoice::S ? e.x : e.x + 1;
        }
        void on(const raster::EllipseTurned& e) { story.add(ellipse_turn(s, e, false)); }
    } probe{s, story};
    story.add(ellipse_start(s, story));
    raster::ellipse_second_order(
        {0, 0}, s.a, s.b, {-s.a, -s.b, s.a, s.b}, [](int, int) {}, probe);
    add_tip(s, story, probe.x);
    return story.told();
}

std::set<std::pair<int, int>> pixels_of_quarter(const Subject& s, bool printed) {
    std::set<std::pair<int, int>> pixels;
    const auto plot = [&](int x, int y) { pixels.insert({x, y}); };
    const PixelBox quarter{0, 0, s.a, s.b};
    if (printed)
        raster::ellipse_textbook({0, 0}, s.a, s.b, quarter, plot);
    else
        raster::ellipse_midpoint({0, 0}, s.a, s.b, quarter, plot);
    return pixels;
}

Lesson ellipse_textbook_lesson(const Subject& s) {
    Story story(s, "ellipse-textbook", "Midpoint ellipse as printed",
                "The printed algorithm changes its region by the gradient at the midpoint. It stops as soon "
                "as y is 0: the tips of flat ellipses are lost.",
                "Textbook section 5.3, with the increment of region 2 corrected");
    explain_walk(s, story);
    story.lesson().columns = {"region", "x", "y", "d", "choice", "a²(y - 1/2)", "b²(x + 1)"};
    struct Probe {
        const Subject& s;
        Story& story;
        raster::EllipseGradient gradient{};
        int x = 0;
        void on(const raster::EllipseGradient& e) { gradient = e; }
        void on(const raster::EllipseStep& e) {
            LessonFrame frame = ellipse_step(s, story, e.region, e.x, e.y, e.d, e.choice);
            if (e.region == 1) {
                const std::string down = decimals(double(gradient.a2y) / 2),
                                  across = decimals(double(gradient.b2x) / 2);
                frame.caption += fmt::format(" Region 1: a²(y - 1/2) = {} > b²(x + 1) = {}.", down, across);
                frame.row.push_back(down), frame.row.push_back(across);
            }
            story.add(std::move(frame));
        }
        void on(const raster::EllipseTurned& e) {
            if (e.y > 0) story.add(ellipse_turn(s, e, true));
        }
        void on(const raster::EllipseStopped& e) { x = e.x; }
    } probe{s, story};
    story.add(ellipse_start(s, story));
    raster::ellipse_textbook(
        {0, 0}, s.a, s.b, {-s.a, -s.b, s.a, s.b}, [](int, int) {}, probe);

    const auto printed = pixels_of_quarter(s, true), right = pixels_of_quarter(s, false);
    LessonFrame frame;
    std::int64_t missing = 0;
    for (const auto& [x, y] : right) {
        if (printed.contains({x, y})) continue;
        ++missing;
        for (const int sx : {1, -1})
            for (const int sy : {1, -1})
                frame.now.push_back(mark(Kind::Cross, point_color, {s.spot(sx * x, sy * y)}));
    }
    frame.title = "the end";
    frame.equation =
        fmt::format("y = 0 at x = {}{}", probe.x, probe.x < s.a ? fmt::format(", but a = {}", s.a) : "");
    if (missing == 0)
        frame.caption = "Here the printed algorithm lights the right pixels.";
    else if (probe.x < s.a)
        frame.caption = fmt::format(
            "The loops end at y = 0, but the ellipse goes on to x = {}: {} of each quarter (crosses). The "
            "algorithm \"midpoint\" goes on along the row.",
            s.a, missing == 1 ? "1 pixel is missing" : fmt::format("{} pixels are missing", missing));
    else
        frame.caption = fmt::format("In each quarter {} should be lit (crosses): the nearest to the ellipse.",
                                    counted(missing, "other pixel"));
    if (missing > 0) story.explain(Kind::Cross, point_color, "should be lit");
    story.add(std::move(frame));
    return story.told();
}

// ------------------------------------------------------------------------------------------ clipping

Rgba8 color_of(CirclePart::Fate fate) {
    constexpr std::array<Rgba8, 3> colors{green, vermilion, orange};
    return colors[static_cast<std::size_t>(fate)];
}

std::string part_name(const CirclePart& part, bool round) {
    if (part.part == CirclePart::Whole) return round ? "whole circle" : "whole ellipse";
    const std::string quadrant =
        fmt::format("{} {}", part.sign_y > 0 ? "lower" : "upper", part.sign_x > 0 ? "right" : "left");
    if (part.part == CirclePart::Quadrant) return quadrant + " quadrant";
    const char* down = part.sign_y > 0 ? "bottom" : "top";
    const char* across = part.sign_x > 0 ? "right" : "left";
    return fmt::format("{}, {} octant", quadrant, part.swapped ? across : down);
}

Lesson clip_lesson(const Subject& s, const scene::LoadedScene& loaded) {
    Story story(s, s.name("circle-clip", "ellipse-clip"), s.name("Clipping a circle", "Clipping an ellipse"),
                s.round()
                    ? "The window is held against the box of the circle, then of its quadrants, then of "
                      "their octants. Only an octant that the border cuts is looked at closer."
                    : "The window is held against the box of the ellipse, then of its quadrants: octants "
                      "of an ellipse are not alike. A quadrant that the border cuts is looked at closer.",
                "Textbook section 4.2");
    const auto& clip = loaded.shapes.clip;
    const auto cut = [](double c, double low, double high) {
        return static_cast<int>(std::clamp(c, low, high));
    };
    const PixelBox window{cut(std::ceil(clip.low.x), 0, loaded.width),
                          cut(std::ceil(clip.low.y), 0, loaded.height),
                          cut(std::floor(clip.high.x), -1, loaded.width - 1),
                          cut(std::floor(clip.high.y), -1, loaded.height - 1)};
    story.lesson().columns = {"part", "answer", "pixels"};
    story.explain(Kind::Box, color_of(CirclePart::Accepted), "accepted: all inside");
    story.explain(Kind::Box, color_of(CirclePart::Rejected), "rejected: all outside");
    story.explain(Kind::Box, color_of(CirclePart::Cut), "cut: looked at closer");
    story.explain(Kind::Cell, lit_now, "lit now");
    story.explain(Kind::Cell, accepted_lit, "lit without a test");
    story.explain(Kind::Cell, lit, "lit where the walk comes in");
    story.explain(Kind::Cell, mixed(paper, haze, discarded_level), "not drawn");
    story.explain(Kind::Outline, navy, "the window");
    const double x0 = clip.low.x, y0 = clip.low.y, x1 = clip.high.x, y1 = clip.high.y;
    story.lesson().ground.push_back(mark(Kind::Outline, navy, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}));

    raster::ellipse_midpoint(s.center, s.a, s.b, s.view, [&](int x, int y) {
        if (!window.holds(x, y))
            story.lesson().ground.push_back(cell(spot_of({x, y}), haze, discarded_level));
    });

    struct Recorder {
        std::vector<std::pair<CirclePart, std::vector<Pixel>>> parts;
        void on(const CirclePart& e) { parts.push_back({e, {}}); }
    } heard;
    const auto plot = [&](int x, int y) { heard.parts.back().second.push_back({x, y}); };
    raster::ellipse_midpoint(s.center, s.a, s.b, window, plot, heard);

    for (const auto& [part, pixels] : heard.parts) {
        const char* answer = part.fate == CirclePart::Accepted   ? "accepted"
                             : part.fate == CirclePart::Rejected ? "rejected"
                                                                 : "cut";
        const Rgba8 color = color_of(part.fate);
        LessonFrame frame;
        frame.title = part_name(part, s.round());
        frame.equation = fmt::format("{} to {}: {}", s.place({double(part.low_x), double(part.low_y)}),
                                     s.place({double(part.high_x), double(part.high_y)}), answer);
        const bool last =
            part.part == CirclePart::Octant || (part.part == CirclePart::Quadrant && !s.round());
        if (part.fate == CirclePart::Accepted)
            frame.caption = pixels.empty() && !last
                                ? "Its box lies inside the window: its octants are drawn without a test."
                                : "Its box lies inside the window: it is drawn without a test a pixel.";
        else if (part.fate == CirclePart::Rejected)
            frame.caption = "Its box does not touch the window: nothing is drawn, nothing is computed.";
        else if (!last)
            frame.caption = "The border of the window crosses its box: its parts are tested next.";
        else if (pixels.empty())
            frame.caption = "The border crosses its box, but no pixel of the curve is inside.";
        else
            frame.caption = fmt::format(
                "The border crosses its box. Where the curve comes in is found by bisection: {} from there "
                "on, with "
                "the d that the walk would have had.",
                counted(std::int64_t(pixels.size()), "pixel"));
        Mark box = mark(Kind::Box, color,
                        {{double(part.low_x) - 0.5, double(part.low_y) - 0.5},
                         {double(part.high_x) + 0.5, double(part.high_y) + 0.5}});
        frame.now.push_back(box);
        for (const Pixel& p : pixels) {
            story.light(frame, p, computed_level, part.fate == CirclePart::Accepted ? accepted_lit : lit);
            frame.now.insert(frame.now.begin(), cell(spot_of(p), lit_now));
        }
        frame.row = {frame.title, answer, fmt::to_string(pixels.size())};
        story.add(std::move(frame));
    }
    return story.told();
}

// ------------------------------------------------------------------------------------------- filled

Lesson disc_lesson(const Subject& s) {
    Story story(
        s, s.name("disc-spans", "ellipse-spans"), s.name("A disc in rows", "A filled ellipse in rows"),
        s.round() ? "The outline is walked for one octant. Each of its columns, and each row that it leaves, "
                    "gives the half width of a row and of its mirror image: each row is filled once."
                  : "The outline is walked for one quarter. Each row that it leaves gives the half width of "
                    "that row and of its mirror image: each row is filled once.",
        "Textbook sections 5.2 to 5.4");
    story.lesson().columns = {"row", "first x", "last x", "pixels"};
    story.explain(Kind::Cell, lit_now, "filled now");
    story.explain(Kind::Cell, lit, "filled");
    raster::disc({0, 0}, s.a, s.b, {-s.a, -s.b, s.a, s.b}, [&](int y, int x0, int x1) {
        LessonFrame frame;
        const int half = x1 - 1;
        const int row = s.center.y + y;
        frame.title = fmt::format("row y = {}", decimals(s.axes.y_of(row)));
        frame.equation =
            fmt::format("half width {}: x = {} to {}", half, decimals(s.axes.x_of(s.center.x + x0)),
                        decimals(s.axes.x_of(s.center.x + half)));
        const int distance = std::abs(y);
        frame.caption = fmt::format("{} the outline reaches {} to either side: {} are filled.",
                                    distance == 0 ? "Through the centre"
                                                  : fmt::format("{} {} the centre", counted(distance, "row"),
                                                                y < 0 ? "above" : "below"),
                                    counted(half, "pixel"), counted(x1 - x0, "pixel"));
        for (int x = x0; x < x1; ++x) {
            const Pixel p{s.center.x + x, row};
            if (!s.view.holds(p.x, p.y)) continue;
            story.light(frame, p);
            frame.now.push_back(cell(spot_of(p), lit_now));
        }
        if (frame.now.empty()) return;
        frame.row = {decimals(s.axes.y_of(row)), decimals(s.axes.x_of(s.center.x + x0)),
                     decimals(s.axes.x_of(s.center.x + half)), fmt::to_string(x1 - x0)};
        story.add(std::move(frame));
    });
    return story.told();
}

// ------------------------------------------------------------------------------------------- smooth

// A row of the exact areas: what its strips say, and the pixels that they cover.
struct CoveredRow {
    int y = 0;
    std::vector<raster::CurveRow> strips;
    std::vector<std::pair<int, int>> edge;  // x and coverage
    std::int64_t whole = 0;                 // pixels covered all
};

Lesson coverage_lesson(const Subject& s) {
    const bool filled = s.shape.filled;
    const auto text = [&](const char* of_disc, const char* of_ring) { return filled ? of_disc : of_ring; };
    Story story(
        s, text("disc-coverage", "ring-coverage"), text("A smooth disc", "A smooth outline"),
        filled ? "Every pixel gets the part of its square that the shape covers. Row by row: S(u) is the "
                 "area up to the vertical at u, a pixel gets what S grows by across it."
               : "The outline is the area between two curves, half its width outside and inside of the "
                 "true one. Every pixel gets the part of its square that lies between them.",
        "Unweighted area sampling: textbook section 8.1, Catmull 1978");
    Lesson& lesson = story.lesson();
    lesson.columns = {"row", "half width", "area", "edge pixels", "whole pixels"};
    story.explain(Kind::Cell, lit, "covered, as dark as the part is large");
    story.explain(Kind::Frame, point_color, "pixel with an edge, in this row");
    if (!filled) story.explain(Kind::Curve, muted, "half the width outside and inside");
    if (!filled)
        for (const double side : {0.5, -0.5}) {
            Mark curve = mark(Kind::Curve, muted, {s.true_center});
            curve.radius_x = s.true_a + side * s.shape.width,
            curve.radius_y = s.true_b + side * s.shape.width;
            if (curve.radius_x > 0 && curve.radius_y > 0) lesson.ground.push_back(std::move(curve));
        }

    struct Recorder {
        std::vector<CoveredRow> rows;
        void on(const raster::CurveRow& e) {
            if (!e.inner) rows.push_back({e.y, {}, {}, 0});
            rows.back().strips.push_back(e);
        }
        void operator()(int, int x0, int x1, int coverage) {
            if (coverage == raster::full_coverage) {
                rows.back().whole += x1 - x0;
                for (int x = x0; x < x1; ++x) full.push_back({x, rows.back().y});
            } else {
                rows.back().edge.push_back({x0, coverage});
            }
        }
        std::vector<Pixel> full;
    } heard;
    const auto cover = [&](int y, int x0, int x1, int coverage) { heard(y, x0, x1, coverage); };
    const glm::dvec2 center{s.true_center.x, s.true_center.y};
    if (filled)
        raster::disc_coverage(center, s.true_a, s.true_b, s.view, cover, heard);
    else
        raster::ring_coverage(center, s.true_a, s.true_b, s.shape.width, s.view, cover, heard);

    double sum = 0;
    std::size_t next_full = 0;
    for (CoveredRow& row : heard.rows) {
        LessonFrame frame;
        const std::string y = decimals(s.axes.y_of(row.y));
        double area = 0;
        for (const raster::CurveRow& strip : row.strips) area += (strip.inner ? -2 : 2) * strip.area;
        std::ranges::sort(row.edge);
        for (; next_full < heard.full.size() && heard.full[next_full].y == row.y; ++next_full)
            story.light(frame, heard.full[next_full]);
        std::int64_t covered = row.whole * raster::full_coverage;
        for (const auto& [x, coverage] : row.edge) {
            covered += coverage;
            story.light(frame, {x, row.y}, level_of(coverage));
            frame.now.push_back(mark(Kind::Frame, point_color, {spot_of({x, row.y})}));
        }
        sum += double(covered) / raster::full_coverage;
        const raster::CurveRow& outer = row.strips[0];
        frame.title = fmt::format("row y = {}", y);
        frame.equation = fmt::format("area of the row = {}", decimals(area));
        frame.caption = fmt::format(
            "{} an edge, {} covered all.",
            row.edge.size() == 1 ? "1 pixel holds" : fmt::format("{} pixels hold", row.edge.size()),
            row.whole == 1 ? "1 is" : fmt::format("{} are", row.whole));
        if (!row.edge.empty())
            frame.caption += fmt::format(" Of the first, at x = {}, the part {} is covered.",
                                         decimals(s.axes.x_of(row.edge[0].first)),
                                         decimals(double(row.edge[0].second) / raster::full_coverage));
        frame.row = {y, fmt::format("{} to {}", decimals(outer.narrowest), decimals(outer.widest)),
                     decimals(area), fmt::to_string(row.edge.size()), fmt::to_string(row.whole)};
        story.add(std::move(frame));
    }
    LessonFrame end;
    end.title = "all rows";
    end.equation = fmt::format("sum of all pixels = {}", decimals(sum));
    const double pi = 3.141592653589793, half = s.shape.width / 2.0;
    if (filled)
        end.caption =
            fmt::format("The area of the whole shape is pi a b = {}.", decimals(pi * s.true_a * s.true_b));
    else if (s.true_a > half && s.true_b > half)
        end.caption = fmt::format("The area between the two curves is pi w (a + b) = {}, w the width.",
                                  decimals(2 * pi * half * (s.true_a + s.true_b)));
    else
        end.caption = "The outline is wider than the shape: it leaves no hole.";
    story.add(std::move(end));
    return story.told();
}

Lesson outline_lesson(const Subject& s) {
    const ScanAlgorithm algorithm = s.shape.algorithm;
    if (!s.round() && algorithm == ScanAlgorithm::Textbook) return ellipse_textbook_lesson(s);
    if (algorithm == ScanAlgorithm::SecondOrder)
        return s.round() ? circle_second_order_lesson(s) : ellipse_second_order_lesson(s);
    return s.round() ? circle_midpoint_lesson(s) : ellipse_midpoint_lesson(s);
}

}  // namespace

std::vector<Lesson> curve_lessons(const scene::LoadedScene& loaded, std::size_t shape) {
    const std::optional<Subject> subject = subject_of(loaded, shape);
    if (!subject) return {};
    const raster::ShapeClip& clip = loaded.shapes.clip;
    const bool filled = subject->shape.filled, smooth = is_smooth(subject->shape);
    std::vector<Lesson> lessons;
    if (clip.on && clip.polygon.empty() && !filled && !smooth)
        lessons.push_back(clip_lesson(*subject, loaded));
    lessons.push_back(smooth   ? coverage_lesson(*subject)
                      : filled ? disc_lesson(*subject)
                               : outline_lesson(*subject));
    if (clip.on) lessons.back().sentence += " The window of the scene is not looked at here.";
    return lessons;
}

}  // namespace relevo::show
