// Lessons of clipping: a segment at a window by four algorithms, a polygon by three.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "pipeline/clip_line_cohen_sutherland.hpp"
#include "pipeline/clip_line_cyrus_beck.hpp"
#include "pipeline/clip_line_liang_barsky.hpp"
#include "pipeline/clip_line_midpoint.hpp"
#include "pipeline/clip_shape_greiner_hormann.hpp"
#include "pipeline/clip_shape_pipeline.hpp"
#include "pipeline/clip_shape_sutherland_hodgman.hpp"
#include "pipeline/split_bridges.hpp"
#include "samples/show/lesson_marks.hpp"
#include "samples/show/lessons.hpp"
#include "samples/show/numbers.hpp"

namespace relevo::show {
namespace {

using namespace pipeline;  // the words of clip_plane.hpp
using Kind = Mark::Kind;
using Points = std::vector<glm::vec2>;

constexpr Rgba8 window_color = navy, uncut = haze, left_over = blue, visible = green, crossing = vermilion,
                wasted = orange, dropped = rose;
constexpr int widest_view = 256, margin = 2;  // pixels
constexpr std::size_t most_segments = 6;      // of a polyline

// The events of a run in their order.
template <class... Events>
struct Heard {
    std::vector<std::variant<Events...>> events;
    template <class Event>
    requires(std::same_as<Event, Events> || ...) void on(const Event& e) { events.push_back(e); }
};

// ------------------------------------------------------------------------------------------- marks

Spot spot(const glm::vec2& p) { return {p.x, p.y}; }
std::vector<Spot> spots(std::span<const glm::vec2> points) {
    std::vector<Spot> out;
    for (const glm::vec2& p : points) out.push_back(spot(p));
    return out;
}
Mark dot(Rgba8 color, const glm::vec2& p) { return mark(Kind::Dot, color, {spot(p)}); }
Mark segment(Rgba8 color, const glm::vec2& a, const glm::vec2& b) {
    return mark(Kind::Segment, color, {spot(a), spot(b)});
}
Mark outline(Rgba8 color, std::span<const glm::vec2> ring) { return mark(Kind::Outline, color, spots(ring)); }
Mark area(Rgba8 color, std::span<const glm::vec2> ring) { return mark(Kind::Area, color, spots(ring)); }
Spot between(const glm::vec2& a, const glm::vec2& b) {
    return {(double{a.x} + b.x) / 2, (double{a.y} + b.y) / 2};
}

// ------------------------------------------------------------------------------------------- words

std::string bits(Outcode code) { return fmt::format("{:04b}", code); }

const char* name_of(Side side) {
    return side == Side::Left ? "left" : side == Side::Right ? "right" : side == Side::Top ? "top" : "bottom";
}

// A number after a minus sign or a factor.
std::string term(double v) { return v < 0 ? "(" + number(v) + ")" : number(v); }
std::string minus(double a, double b) { return number(a) + " - " + term(b); }

std::string names(const std::vector<std::string>& list) { return fmt::format("{}", fmt::join(list, ", ")); }

const char* why(Refusal refusal) {
    switch (refusal) {
        case Refusal::NotFinite:
            return "a coordinate is not a finite number";
        case Refusal::EmptyBox:
            return "the window's lower limit is above its upper one";
        case Refusal::NoArea:
            return "the window has no area";
        default:
            return "the window is not convex";
    }
}

// Places in the words of the scene file.
struct Words {
    const scene::LessonAxes& axes;
    double x(double px) const { return axes.x_of(px); }
    double y(double py) const { return axes.y_of(py); }
    double along(int axis, double p) const { return axis == 0 ? x(p) : y(p); }
    std::string place(const glm::vec2& p) const {
        return fmt::format("({}, {})", number(x(p.x)), number(y(p.y)));
    }
};

// ------------------------------------------------------------------------- what all lessons have

struct Subject {
    const scene::LoadedScene& loaded;
    const raster::ShapeClip& clip;
    Words words;
    ClipBox box;
    Points window;                // its corners, also when it is a box
    std::vector<ClipLine> sides;  // in the order in which they are taken
    std::vector<std::string> side_names;
    bool upright;                    // a box
    std::optional<Refusal> refusal;  // why it is no window
};

Subject subject_of(const scene::LoadedScene& loaded) {
    const raster::ShapeClip& clip = loaded.shapes.clip;
    Subject s{loaded, clip, {loaded.axes}, {clip.low, clip.high}, clip.polygon, {}, {}, clip.polygon.empty(),
              {}};
    if (s.upright && !is_window(s.box)) s.refusal = refusal_of(s.box);
    if (s.upright) {
        s.window = {s.box.low, {s.box.high.x, s.box.low.y}, s.box.high, {s.box.low.x, s.box.high.y}};
        for (const Side side : clip.order) {
            s.sides.push_back(line_of(s.box, side));
            s.side_names.push_back(name_of(side));
        }
    } else if (const auto convex = convex_window(clip.polygon)) {
        s.sides = *convex;
        for (std::size_t i = 0; i < s.sides.size(); ++i)
            s.side_names.push_back(fmt::format("side {}", i + 1));
    } else {
        s.refusal = convex.error();
    }
    return s;
}

// The pixels around the shape and the window that lie in the picture.
raster::PixelBox view_of(const Subject& s, std::span<const glm::vec2> shape) {
    glm::dvec2 low(1e9), high(-1e9);
    for (const auto& points : {shape, std::span<const glm::vec2>(s.window)})
        for (const glm::vec2& p : points)
            low = glm::min(low, glm::dvec2(p)), high = glm::max(high, glm::dvec2(p));
    const auto first = [](double v) { return static_cast<int>(std::floor(std::max(v, 0.0))); };
    const auto last = [](double v, int size) { return static_cast<int>(std::ceil(std::min(v, size - 1.0))); };
    raster::PixelBox view{first(low.x - margin), first(low.y - margin), last(high.x + margin, s.loaded.width),
                          last(high.y + margin, s.loaded.height)};
    if (view.empty()) view = {0, 0, s.loaded.width - 1, s.loaded.height - 1};
    view.x1 = std::min(view.x1, view.x0 + widest_view - 1);
    view.y1 = std::min(view.y1, view.y0 + widest_view - 1);
    return view;
}

Lesson lesson_of(const Subject& s, std::span<const glm::vec2> shape, bool closed) {
    Lesson lesson;
    lesson.view = view_of(s, shape);
    lesson.ground = {closed ? outline(uncut, shape) : mark(Kind::Dashes, uncut, spots(shape)),
                     outline(window_color, s.window)};
    lesson.legend = {{closed ? Kind::Outline : Kind::Dashes, uncut, "before clipping"},
                     {Kind::Outline, window_color, "window"}};
    return lesson;
}

void refuse(Lesson& lesson, Refusal refusal) {
    lesson.frames.push_back({"refused", "", fmt::format("Nothing is drawn: {}.", why(refusal)), {}, {}, {}});
}

// The line of a side as far as it can be seen.
Mark side_line(Rgba8 color, const ClipLine& line, const raster::PixelBox& view) {
    const glm::dvec2 from(line.from), along = glm::dvec2(line.to) - from;
    const double length = std::sqrt(along.x * along.x + along.y * along.y);
    const double reach = 2.0 * (std::abs(from.x) + std::abs(from.y) + view.x1 + view.y1 + 2) / length;
    const glm::dvec2 a = from - reach * along, b = from + reach * along;
    return mark(Kind::Dashes, color, {{a.x, a.y}, {b.x, b.y}});
}

// ---------------------------------------------------------------------------------- Cohen-Sutherland

void add_regions(Lesson& lesson, const Subject& s) {
    for (const Side side : s.clip.order)
        lesson.ground.insert(lesson.ground.begin(), side_line(rule, line_of(s.box, side), lesson.view));
    const auto middles = [](double view0, double low, double high, double view1) {
        return std::array{std::pair{(view0 + low) / 2, low - view0}, std::pair{(low + high) / 2, high - low},
                          std::pair{(high + view1) / 2, view1 - high}};
    };
    const raster::PixelBox& v = lesson.view;
    for (const auto& [x, width] : middles(v.x0, s.box.low.x, s.box.high.x, v.x1))
        for (const auto& [y, height] : middles(v.y0, s.box.low.y, s.box.high.y, v.y1))
            if (width >= 1 && height >= 1)
                lesson.ground.push_back(label(
                    {x, y}, muted, bits(outcode(s.box, {static_cast<float>(x), static_cast<float>(y)}))));
}

// y = 5 + (14 - 6) (13 - 5) / (18 - 6) = 10.33, in the numbers of the scene.
std::string crossing_equation(const Subject& s, const Segment& whole, Side side, const glm::vec2& found) {
    const int fixed = is_upright(side) ? 0 : 1, moving = 1 - fixed;
    const auto at = [&](int axis, const glm::vec2& p) { return s.words.along(axis, p[axis]); };
    return fmt::format("{} = {} + ({}) ({}) / ({}) = {}", fixed == 0 ? "y" : "x", number(at(moving, whole.a)),
                       minus(at(fixed, found), at(fixed, whole.a)),
                       minus(at(moving, whole.b), at(moving, whole.a)),
                       minus(at(fixed, whole.b), at(fixed, whole.a)), number(at(moving, found)));
}

Lesson cohen_sutherland_lesson(const Subject& s, const Segment& whole) {
    const Points ends{whole.a, whole.b};
    Lesson lesson = lesson_of(s, ends, false);
    lesson.name = "clip-cohen-sutherland";
    lesson.title = "Cohen-Sutherland line clipping";
    lesson.sentence =
        "Four bits say where an end lies; often they alone decide. Else an end moves to a side, and again.";
    lesson.source = "Cohen and Sutherland 1968; textbook section 4.1.1, figures 4.2 and 4.3";
    lesson.columns = {"round", "from", "code", "to", "code", "decision"};
    add_regions(lesson, s);
    lesson.legend.push_back({Kind::Segment, left_over, "what is left"});
    lesson.legend.push_back({Kind::Dot, crossing, "crossing"});
    lesson.legend.push_back({Kind::Cross, wasted, "wasted: still outside"});
    lesson.legend.push_back({Kind::Cross, muted, "off the segment: never computed"});

    Heard<OutcodesCompared, SideCrossed, ClipRefused> heard;
    SideOrder order;
    std::ranges::copy(s.clip.order, order.begin());
    clip_line_cohen_sutherland(whole, s.box, order, heard);
    std::vector<std::string> order_names, unset;
    for (const Side side : order) order_names.push_back(name_of(side));

    lesson.frames.push_back(
        {"the nine regions",
         "code = above below right left",
         "The sides of the window divide the plane into nine regions. The first bit of a code is 1 above the "
         "window, the second below it, the third to the right and the fourth to the left of it.",
         {},
         {segment(left_over, whole.a, whole.b), dot(left_over, whole.a), dot(left_over, whole.b)},
         {}});
    int round = 0, crossings = 0, wasted_count = 0;
    Segment now = whole;
    for (const auto& event : heard.events) {
        LessonFrame frame;
        if (const auto* refused = std::get_if<ClipRefused>(&event)) {
            refuse(lesson, refused->reason);
            continue;
        }
        if (const auto* e = std::get_if<OutcodesCompared>(&event)) {
            ++round;
            now = e->now;
            const Outcode both = e->a & e->b, any = e->a | e->b;
            frame.title = fmt::format("round {}: compare the codes", round);
            const char* decision = e->accepted() ? "accept" : e->rejected() ? "reject" : "cut";
            if (e->accepted()) {
                frame.equation = fmt::format("{} | {} = {} -> accept", bits(e->a), bits(e->b), bits(any));
                frame.caption =
                    crossings == 0
                        ? "Both codes are 0: all of the segment lies in the window. Nothing had to be "
                          "computed."
                        : fmt::format(
                              "Both codes are 0: what is left lies in the window. {} computed, {} of "
                              "them wasted.",
                              counted(crossings, "crossing"), wasted_count);
            } else if (e->rejected()) {
                frame.equation = fmt::format("{} & {} = {} -> reject", bits(e->a), bits(e->b), bits(both));
                frame.caption =
                    fmt::format("Both ends lie beyond the same side: nothing is visible. {} computed{}.",
                                crossings == 0 ? "No crossing had to be" : counted(crossings, "crossing"),
                                crossings == 0 ? "" : ", all wasted");
            } else {
                frame.equation = fmt::format("{} & {} = {}, {} | {} = {} -> cut", bits(e->a), bits(e->b),
                                             bits(both), bits(e->a), bits(e->b), bits(any));
                frame.caption =
                    "No bit is set in both codes, but one is set in either: the codes do not decide yet.";
            }
            const Rgba8 color = e->accepted() ? visible : e->rejected() ? dropped : left_over;
            frame.now = {segment(color, e->now.a, e->now.b), dot(color, e->now.a), dot(color, e->now.b),
                         label(spot(e->now.a), color, bits(e->a)), label(spot(e->now.b), color, bits(e->b))};
            frame.row = {std::to_string(round),
                         s.words.place(e->now.a),
                         bits(e->a),
                         s.words.place(e->now.b),
                         bits(e->b),
                         decision};
        } else if (const auto* c = std::get_if<SideCrossed>(&event)) {
            ++crossings, wasted_count += c->wasted();
            frame.title = fmt::format("cut at the {}", name_of(c->side));
            frame.equation = crossing_equation(s, whole, c->side, c->to);
            frame.caption = fmt::format(
                "Sides are asked in the order {}. The first bit set in {} is that of the {}, so this end "
                "moves "
                "there. ",
                names(order_names), bits(c->before), name_of(c->side));
            frame.caption +=
                c->wasted() ? fmt::format("Its code is {} now: still outside, so this crossing was wasted.",
                                          bits(c->after))
                            : "It lies on the window now.";
            frame.now = {segment(dropped, c->from, c->to), dot(dropped, c->from),
                         segment(left_over, c->to, c->moves_a ? now.b : now.a)};
            frame.stays = {
                mark(c->wasted() ? Kind::Cross : Kind::Dot, c->wasted() ? wasted : crossing, {spot(c->to)})};
            // What fig. 4.3 warns of: a side without a bit is crossed by the line, but not by the segment.
            for (const Side side : order) {
                const int axis = is_upright(side) ? 0 : 1;
                if (c->before & outcode_of(side) || crossings > 1 || whole.a[axis] == whole.b[axis]) continue;
                if (outcode_of(side) & (outcode(s.box, whole.a) | outcode(s.box, whole.b))) continue;
                unset.push_back(name_of(side));
                const double t =
                    (double{s.box.at(side)} - whole.a[axis]) / (double{whole.b[axis]} - whole.a[axis]);
                const glm::dvec2 p = glm::dvec2(whole.a) + t * (glm::dvec2(whole.b) - glm::dvec2(whole.a));
                frame.now.push_back(mark(Kind::Cross, muted, {{p.x, p.y}}));
            }
            if (crossings == 1 && !unset.empty())
                frame.caption += fmt::format(
                    " A crossing with a side whose bit is 0 at both ends ({}) lies off the segment: it is "
                    "never "
                    "computed.",
                    names(unset));
        }
        lesson.frames.push_back(std::move(frame));
    }
    return lesson;
}

// ------------------------------------------------------------------------------ parametric clipping

const char* passage_name(Passage passage) {
    switch (passage) {
        case Passage::Entering:
            return "entering";
        case Passage::Leaving:
            return "leaving";
        case Passage::ParallelInside:
            return "parallel, inside";
        default:
            return "parallel, outside";
    }
}

// What Liang-Barsky and Cyrus-Beck say about one side.
struct ParameterStep {
    std::string side;
    ClipLine line;
    double numerator, denominator, t;
    Passage passage;
    double t_in, t_out;
    bool empty;
};

std::string passage_caption(const ParameterStep& e, double t_in, double t_out) {
    const std::string t = number(e.t);
    switch (e.passage) {
        case Passage::ParallelInside:
            return "The denominator is 0: the segment is parallel to this side, and inside of it. Nothing "
                   "changes.";
        case Passage::ParallelOutside:
            return "The denominator is 0: the segment is parallel to this side, and outside. Nothing is "
                   "visible.";
        case Passage::Entering:
            if (e.empty)
                return fmt::format(
                    "It would enter here at t = {}, but it has left at {}: nothing is visible.", t,
                    number(t_out));
            return e.t_in != t_in
                       ? fmt::format(
                             "The denominator is positive: the segment enters here, visible from t = {} on.",
                             t)
                       : fmt::format(
                             "The denominator is positive: entering, but not later than {}. Nothing changes.",
                             number(t_in));
        default:
            if (e.empty)
                return fmt::format("It leaves here at t = {}, before it enters at {}: nothing is visible.", t,
                                   number(t_in));
            return e.t_out != t_out
                       ? fmt::format(
                             "The denominator is negative: the segment leaves here, visible up to t = {}.", t)
                       : fmt::format(
                             "The denominator is negative: leaving, but not before {}. Nothing changes.",
                             number(t_out));
    }
}

class ParametricLesson {
  public:
    ParametricLesson(const Subject& s, const Segment& whole) : s_(s), whole_(whole) {
        const Points ends{whole.a, whole.b};
        lesson = lesson_of(s, ends, false);
        lesson.columns = {"side", "numerator", "denominator", "t", "passage", "t_in", "t_out"};
        lesson.legend.push_back({Kind::Segment, left_over, "from t_in to t_out"});
        lesson.legend.push_back({Kind::Dot, visible, "entering"});
        lesson.legend.push_back({Kind::Dot, crossing, "leaving"});
        const std::string p0 = s.words.place(whole.a), p1 = s.words.place(whole.b);
        lesson.frames.push_back(
            {"the segment",
             "P(t) = P0 + (P1 - P0) t,  0 <= t <= 1",
             fmt::format(
                 "From P0 = {} at t = 0 to P1 = {} at t = 1. Each side will say from when on, or up to when, "
                 "it is visible.",
                 p0, p1),
             {},
             {segment(left_over, whole.a, whole.b), label(spot(whole.a), ink, "P0"),
              label(spot(whole.b), ink, "P1")},
             {}});
    }

    // Where the words of a point hide neither a level side nor an arrow: farther from the window's middle.
    Spot beyond(Spot p) const {
        const raster::PixelBox& view = lesson.view;
        const double away = std::max((view.x1 - view.x0) / 28.0, (view.y1 - view.y0) / 18.0);
        const auto [low, high] = std::ranges::minmax(s_.window, {}, &glm::vec2::y);
        return {p.x, p.y + (p.y < between(low, high).y ? -away : away)};
    }

    void step(const ParameterStep& e, std::string equation, const std::string& more,
              std::vector<Mark> marks) {
        LessonFrame frame;
        frame.title = e.side + ": " + passage_name(e.passage);
        frame.equation = std::move(equation);
        frame.caption = passage_caption(e, t_in_, t_out_);
        if (!e.empty)
            frame.caption += fmt::format(" What remains: t from {} to {}.", number(e.t_in), number(e.t_out));
        frame.caption += more;
        frame.now = {side_line(purple, e.line, lesson.view)};
        std::ranges::move(marks, std::back_inserter(frame.now));
        if (!e.empty) frame.now.push_back(segment_between(left_over, e.t_in, e.t_out));
        if (sees(e.t)) {
            const bool entering = e.passage == Passage::Entering;
            const Rgba8 color = entering ? visible : crossing;
            frame.stays.push_back(mark(Kind::Dot, color, {at(e.t)}));
            const glm::vec2 along = e.line.to - e.line.from;
            const Spot place = std::abs(along.x) > std::abs(along.y) ? beyond(at(e.t)) : at(e.t);
            (e.t < 0 || e.t > 1 ? frame.now : frame.stays)
                .push_back(label(place, color, "t = " + number(e.t)));
        }
        frame.row = {e.side,
                     number(e.numerator),
                     number(e.denominator),
                     std::isnan(e.t) ? "-" : number(e.t),
                     passage_name(e.passage),
                     number(e.t_in),
                     number(e.t_out)};
        t_in_ = e.t_in, t_out_ = e.t_out;
        lesson.frames.push_back(std::move(frame));
    }

    void finish(const std::optional<Segment>& result) {
        LessonFrame frame;
        frame.title = "result";
        if (result) {
            frame.equation = fmt::format("P({}) = {},  P({}) = {}", number(t_in_), s_.words.place(result->a),
                                         number(t_out_), s_.words.place(result->b));
            frame.caption = fmt::format(
                "Visible from t = {} to t = {}: only now are points computed, and only these "
                "two.",
                number(t_in_), number(t_out_));
            frame.now = {segment(visible, result->a, result->b), dot(visible, result->a),
                         dot(t_out_ < 1 ? crossing : visible, result->b)};
        } else {
            frame.equation = "nothing is visible";
            frame.caption = "The segment is rejected without computing a single point.";
            frame.now = {segment(dropped, whole_.a, whole_.b)};
        }
        lesson.frames.push_back(std::move(frame));
    }

    Lesson lesson;

  private:
    Spot at(double t) const {
        return {whole_.a.x + t * (double{whole_.b.x} - whole_.a.x),
                whole_.a.y + t * (double{whole_.b.y} - whole_.a.y)};
    }
    bool sees(double t) const {  // not of a parallel side
        const Spot p = at(t);
        return p.x >= lesson.view.x0 && p.x <= lesson.view.x1 && p.y >= lesson.view.y0 &&
               p.y <= lesson.view.y1;
    }
    Mark segment_between(Rgba8 color, double t0, double t1) const {
        return mark(Kind::Segment, color, {at(t0), at(t1)});
    }
    const Subject& s_;
    Segment whole_;
    double t_in_ = 0, t_out_ = 1;
};

Lesson liang_barsky_lesson(const Subject& s, const Segment& whole) {
    ParametricLesson page(s, whole);
    page.lesson.name = "clip-liang-barsky";
    page.lesson.title = "Liang-Barsky line clipping";
    page.lesson.sentence =
        "Each side of an upright window says where the segment enters or leaves, as a number t from 0 to 1.";
    page.lesson.source = "Liang and Barsky 1984; textbook section 4.1.2, table 4.1";
    Heard<BoxParameterFound, ClipRefused> heard;
    const auto result = clip_line_liang_barsky(whole, s.box, heard);
    for (const auto& event : heard.events) {
        if (const auto* refused = std::get_if<ClipRefused>(&event)) {
            refuse(page.lesson, refused->reason);
            return std::move(page.lesson);
        }
        const auto& e = std::get<BoxParameterFound>(event);
        const int axis = is_upright(e.side) ? 0 : 1;
        const auto of = [&](const glm::vec2& p) { return s.words.along(axis, p[axis]); };
        const double w = s.words.along(axis, s.box.at(e.side)), from = of(whole.a), to = of(whole.b);
        // the side of small values asks (min - p0) / (p1 - p0), that of large ones (p0 - max) / (p0 - p1)
        const bool low = e.side == Side::Left || e.side == (s.words.axes.y_up ? Side::Bottom : Side::Top);
        const char c = axis == 0 ? 'x' : 'y';
        const std::string formula = low ? fmt::format("({0}min - {0}0) / ({0}1 - {0}0)", c)
                                        : fmt::format("({0}0 - {0}max) / ({0}0 - {0}1)", c);
        const std::string numbers = low ? fmt::format("({}) / ({})", minus(w, from), minus(to, from))
                                        : fmt::format("({}) / ({})", minus(from, w), minus(from, to));
        const std::string value = std::isnan(e.t) ? fmt::format("{} / 0", number(e.numerator)) : number(e.t);
        page.step({name_of(e.side), line_of(s.box, e.side), e.numerator, e.denominator, e.t, e.passage,
                   e.t_in, e.t_out, e.empty},
                  fmt::format("t = {} = {} = {}", formula, numbers, value), "", {});
    }
    page.finish(result);
    return std::move(page.lesson);
}

Lesson cyrus_beck_lesson(const Subject& s, const Segment& whole) {
    ParametricLesson page(s, whole);
    page.lesson.name = "clip-cyrus-beck";
    page.lesson.title = "Cyrus-Beck line clipping";
    page.lesson.sentence =
        "Each side of a convex window says where the segment enters or leaves: the sign of N . D "
        "tells which, N being the side's outward normal.";
    page.lesson.source = "Cyrus and Beck 1978; textbook section 4.1.2, algorithm 4.1, figures 4.4 and 4.5";
    page.lesson.legend.push_back({Kind::Arrow, purple, "normal N of the side"});
    page.lesson.legend.push_back({Kind::Dot, purple, "PL, on the side"});
    if (s.refusal) {
        refuse(page.lesson, *s.refusal);
        return std::move(page.lesson);
    }
    Heard<SideParameterFound, ClipRefused> heard;
    const auto result = clip_line_cyrus_beck(whole, std::span<const ClipLine>(s.sides), heard);
    const double up = s.words.axes.y_up ? -1 : 1;
    for (const auto& event : heard.events) {
        if (const auto* refused = std::get_if<ClipRefused>(&event)) {
            refuse(page.lesson, refused->reason);
            return std::move(page.lesson);
        }
        const auto& e = std::get<SideParameterFound>(event);
        // The ends of the side, the first being PL. A box's line has others, but N.(P0 - PL) is the same for
        // all points PL of a line.
        glm::vec2 from = e.line.from, to = e.line.to;
        for (std::size_t i = 0; s.upright && i < 4; ++i)
            if (side_of(e.line, s.window[i]) == 0 && side_of(e.line, s.window[(i + 1) % 4]) == 0)
                from = s.window[i], to = s.window[(i + 1) % 4];
        const Spot middle = between(from, to);
        const double length = std::sqrt(e.normal_x * e.normal_x + e.normal_y * e.normal_y);
        const double arrow = std::max(1.5, (page.lesson.view.x1 - page.lesson.view.x0) / 12.0);
        const Spot tip{middle.x + arrow * e.normal_x / length, middle.y + arrow * e.normal_y / length};
        const auto vector = [&](double x, double y) {
            return fmt::format("({}, {})", number(x), number(up * y));
        };
        const std::string value = std::isnan(e.t) ? "no t" : "t = " + number(e.t);
        page.step(
            {s.side_names[e.side], e.line, e.numerator, e.denominator, e.t, e.passage, e.t_in, e.t_out,
             e.empty},
            fmt::format("N.(P0 - PL) / (-N.D) = {} / {} -> {}", number(e.numerator), term(e.denominator),
                        value),
            fmt::format(" N = {}, PL = {}, P0 - PL = {}, D = {}.", vector(e.normal_x, e.normal_y),
                        s.words.place(from), vector(double{whole.a.x} - from.x, double{whole.a.y} - from.y),
                        vector(double{whole.b.x} - whole.a.x, double{whole.b.y} - whole.a.y)),
            {mark(Kind::Segment, purple, {spot(from), spot(to)}), mark(Kind::Arrow, purple, {middle, tip}),
             label(page.beyond(tip), purple, "N"), dot(purple, from),
             label(page.beyond(spot(from)), purple, "PL")});
    }
    page.finish(result);
    return std::move(page.lesson);
}

// ------------------------------------------------------------------------------ midpoint subdivision

Lesson midpoint_lesson(const Subject& s, const Segment& whole) {
    const Points ends{whole.a, whole.b};
    Lesson lesson = lesson_of(s, ends, false);
    lesson.name = "clip-midpoint";
    lesson.title = "Line clipping by midpoint subdivision";
    lesson.sentence =
        "Halve, throw away what is outside, halve again: additions and shifts do for a division.";
    lesson.source = "Sproull and Sutherland 1968; codes as in the textbook's figure 4.2";
    lesson.columns = {"halving", "search", "from", "middle", "to", "codes", "goes on with"};
    add_regions(lesson, s);
    lesson.legend.push_back({Kind::Segment, left_over, "searched"});
    lesson.legend.push_back({Kind::Segment, dropped, "dropped"});
    lesson.legend.push_back({Kind::Segment, visible, "visible"});
    Heard<SegmentHalved, ClipRefused> heard;
    const auto result = clip_line_midpoint(whole, s.box, heard);
    lesson.frames.push_back(
        {"the segment",
         fmt::format("codes {} and {}", bits(outcode(s.box, whole.a)), bits(outcode(s.box, whole.b))),
         "Find a visible point first, then the last visible ones to both sides of it.",
         {},
         {segment(left_over, whole.a, whole.b), dot(left_over, whole.a), dot(left_over, whole.b)},
         {}});
    const auto too_small = [](const SegmentHalved& e) {
        return std::abs(double{e.from.x} - e.to.x) + std::abs(double{e.from.y} - e.to.y) < 1.0 / 4;
    };
    int number_of = 0, unseen = 0;
    const auto summarize = [&] {
        if (unseen == 0) return;
        lesson.frames.push_back(
            {"and so on",
             fmt::format("{} more", counted(unseen, "halving")),
             "The rest is too small to be seen here: it ends when no float lies between the ends.",
             {},
             {},
             {}});
        unseen = 0;
    };
    MidpointSearch last = MidpointSearch::Visible;
    for (const auto& event : heard.events) {
        if (const auto* refused = std::get_if<ClipRefused>(&event)) {
            refuse(lesson, refused->reason);
            return lesson;
        }
        const auto& e = std::get<SegmentHalved>(event);
        if (e.search != last) summarize();
        last = e.search;
        ++number_of;
        if (too_small(e)) {
            ++unseen;
            continue;
        }
        const auto coordinate = [&](int axis) {
            return fmt::format("({} + {}) / 2 = {}", number(s.words.along(axis, e.from[axis])),
                               term(s.words.along(axis, e.to[axis])),
                               number(s.words.along(axis, e.middle[axis])));
        };
        const char* search = e.search == MidpointSearch::Visible        ? "a visible point"
                             : e.search == MidpointSearch::FirstVisible ? "the first visible point"
                                                                        : "the last visible point";
        LessonFrame frame;
        frame.title = fmt::format("halving {}: {}", number_of, search);
        frame.equation = fmt::format("x = {},  y = {}", coordinate(0), coordinate(1));
        if (e.middle_code == 0 && e.search == MidpointSearch::Visible)
            frame.caption = "The midpoint is visible. Now look for the ends on both sides of it.";
        else if (e.middle_code == 0)
            frame.caption = "The midpoint is visible, so the end lies in the other half.";
        else if (e.search == MidpointSearch::Visible) {
            const Outcode code = e.keeps_first ? e.to_code : e.from_code;
            frame.caption =
                fmt::format("The midpoint is outside: {} & {} = {}, so one half is invisible and is dropped.",
                            bits(e.middle_code), bits(code), bits(e.middle_code & code));
        } else
            frame.caption = "The midpoint is outside, so the end lies between it and the visible point.";
        const bool both = e.middle_code == 0 && e.search == MidpointSearch::Visible;
        const Rgba8 other = e.middle_code == 0 ? visible : dropped;
        frame.now = {segment(both || e.keeps_first ? left_over : other, e.from, e.middle),
                     segment(both || !e.keeps_first ? left_over : other, e.middle, e.to),
                     dot(e.middle_code == 0 ? visible : crossing, e.middle),
                     label(spot(e.middle), ink, bits(e.middle_code))};
        if (!both && e.middle_code == 0)  // both ends of the other half are visible
            frame.stays = {e.search == MidpointSearch::LastVisible ? segment(visible, e.from, e.middle)
                                                                   : segment(visible, e.middle, e.to)};
        frame.row = {std::to_string(number_of),
                     search,
                     s.words.place(e.from),
                     s.words.place(e.middle),
                     s.words.place(e.to),
                     fmt::format("{} {} {}", bits(e.from_code), bits(e.middle_code), bits(e.to_code)),
                     both            ? "both halves"
                     : e.keeps_first ? "the first half"
                                     : "the second half"};
        lesson.frames.push_back(std::move(frame));
    }
    summarize();
    LessonFrame frame{"result",
                      "nothing is visible",
                      "Every part of the segment lies beyond a side of the window.",
                      {},
                      {segment(dropped, whole.a, whole.b)},
                      {}};
    if (result) {
        frame.equation = fmt::format("from {} to {}", s.words.place(result->a), s.words.place(result->b));
        frame.caption = fmt::format("{} found both ends to the last bit.", counted(number_of, "halving"));
        frame.now = {segment(visible, result->a, result->b), dot(visible, result->a),
                     dot(visible, result->b)};
    }
    lesson.frames.push_back(std::move(frame));
    return lesson;
}

// ------------------------------------------------------------------------------- Sutherland-Hodgman

constexpr Rgba8 color_of(EdgeKind kind) {
    switch (kind) {
        case EdgeKind::Entering:
            return blue;
        case EdgeKind::Inside:
            return green;
        case EdgeKind::Leaving:
            return vermilion;
        default:
            return rose;
    }
}
constexpr const char* name_of(EdgeKind kind) {
    switch (kind) {
        case EdgeKind::Entering:
            return "entering";
        case EdgeKind::Inside:
            return "inside";
        case EdgeKind::Leaving:
            return "leaving";
        default:
            return "outside";
    }
}
constexpr std::array all_kinds{EdgeKind::Inside, EdgeKind::Leaving, EdgeKind::Outside, EdgeKind::Entering};

Mark arrow(const ShapeEdgeClassified& e) {
    return mark(Kind::Arrow, color_of(e.kind), {spot(e.from), spot(e.to)});
}
Mark emitted_dot(const ShapePointEmitted& e) { return dot(e.crossing ? crossing : visible, e.point); }

double area_of(std::span<const glm::vec2> ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a(ring[i]), b(ring[(i + 1) % ring.size()]);
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2;
}

std::string places(const Subject& s, std::span<const glm::vec2> points) {
    constexpr std::size_t most = 8;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < std::min(points.size(), most); ++i) words.push_back(s.words.place(points[i]));
    if (points.size() > most) words.push_back(fmt::format("and {} more", points.size() - most));
    return fmt::format("{}", fmt::join(words, " "));
}

// Polygons in colours of their own, and the sum of their areas.
LessonFrame pieces_frame(const std::vector<Points>& pieces, std::string title, std::string caption) {
    LessonFrame frame;
    frame.title = std::move(title);
    frame.caption = std::move(caption);
    std::vector<std::string> areas;
    double sum = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        frame.now.push_back(area(accent(i), pieces[i]));
        frame.now.push_back(outline(accent(i), pieces[i]));
        areas.push_back(number(area_of(pieces[i])));
        sum += area_of(pieces[i]);
    }
    frame.equation = pieces.empty()       ? "nothing is left"
                     : pieces.size() == 1 ? fmt::format("area {}", areas[0])
                                          : fmt::format("area {} = {}", fmt::join(areas, " + "), number(sum));
    return frame;
}

void name_edges(Lesson& lesson) {
    for (const EdgeKind kind : all_kinds)
        lesson.legend.push_back({Kind::Arrow, color_of(kind), name_of(kind)});
    lesson.legend.push_back({Kind::Dot, visible, "corner kept"});
    lesson.legend.push_back({Kind::Dot, crossing, "crossing"});
}

// Fig. 4.9: edges upon each other, and what remains without them.
void add_bridges(Lesson& lesson, const Subject& s, const ClippedRing& clipped) {
    Heard<BridgeRemoved, PieceFound> heard;
    const std::vector<Points> pieces = split_bridges(clipped, heard);
    std::vector<Mark> bridges;
    double length = 0;
    for (const auto& event : heard.events)
        if (const auto* e = std::get_if<BridgeRemoved>(&event)) {
            bridges.push_back(segment(vermilion, e->from, e->to));
            const glm::dvec2 along = glm::dvec2(e->to) - glm::dvec2(e->from);
            length += std::sqrt(along.x * along.x + along.y * along.y);
        }
    if (bridges.empty()) return;
    LessonFrame frame;
    frame.title = "bridges";
    frame.equation = fmt::format("there {0} + back {0}: enclosed area 0", number(length));
    frame.caption =
        "Along the window's border edges lie upon each other, there and back: the clipped polygon is held "
        "together "
        "by bridges that belong to no piece.";
    if (!s.clip.split) frame.caption += " (split = true in [clip] cuts them out.)";
    frame.now = {area(left_over, clipped.points), outline(left_over, clipped.points)};
    frame.now.insert(frame.now.end(), bridges.begin(), bridges.end());
    lesson.legend.push_back({Kind::Segment, vermilion, "bridge"});
    lesson.frames.push_back(std::move(frame));
    if (s.clip.split)
        lesson.frames.push_back(pieces_frame(pieces, "bridges removed",
                                             fmt::format("Without the bridges the border links up into {}.",
                                                         counted(std::ssize(pieces), "polygon"))));
}

Lesson passes_lesson(const Subject& s, const Points& polygon) {
    Lesson lesson = lesson_of(s, polygon, true);
    lesson.name = "clip-sutherland-hodgman";
    lesson.title = "Sutherland-Hodgman polygon clipping";
    lesson.sentence = "Cut the whole polygon at one side of the window, then what is left at the next one.";
    lesson.source = "Sutherland and Hodgman 1974; textbook section 4.3.1, figures 4.6 to 4.9";
    lesson.columns = {"side", "inside", "leaving", "outside", "entering", "points"};
    name_edges(lesson);
    Heard<ShapeEdgeClassified, ShapePointEmitted, ShapeSideDone, ClipRefused> heard;
    const ClippedRing clipped =
        clip_ring_sutherland_hodgman(polygon, std::span<const ClipLine>(s.sides), heard);
    lesson.frames.push_back(
        {"the polygon",
         counted(std::ssize(polygon), "point"),
         fmt::format("It will be cut at the sides one after the other: {}.", names(s.side_names)),
         {},
         {area(left_over, polygon), outline(left_over, polygon)},
         {}});
    LessonFrame frame;
    std::map<EdgeKind, int> count;
    int points = 0;
    for (const auto& event : heard.events) {
        if (const auto* refused = std::get_if<ClipRefused>(&event)) {
            refuse(lesson, refused->reason);
        } else if (const auto* edge = std::get_if<ShapeEdgeClassified>(&event)) {
            frame.now.push_back(arrow(*edge)), ++count[edge->kind];
        } else if (const auto* point = std::get_if<ShapePointEmitted>(&event)) {
            frame.stays.push_back(emitted_dot(*point)), ++points;
        } else if (const auto* done = std::get_if<ShapeSideDone>(&event)) {
            const std::string& side = s.side_names[done->side];
            const int usual =
                count[EdgeKind::Inside] + count[EdgeKind::Leaving] + 2 * count[EdgeKind::Entering];
            frame.title = "against the " + side;
            frame.equation = fmt::format(
                "{} inside x 1 + {} leaving x 1 + {} outside x 0 + {} entering x 2 {} {}",
                count[EdgeKind::Inside], count[EdgeKind::Leaving], count[EdgeKind::Outside],
                count[EdgeKind::Entering], points == usual ? "=" : "->", counted(points, "point"));
            frame.caption = fmt::format(
                "An edge inside of the {} leaves its end, one that leaves the crossing, one that enters "
                "both, one "
                "outside nothing.",
                side);
            if (points != usual) frame.caption += " A corner on the side itself needs no crossing.";
            frame.now.insert(frame.now.begin(), side_line(purple, done->line, lesson.view));
            std::ranges::move(std::exchange(frame.stays, {}), std::back_inserter(frame.now));
            frame.row = {side};
            for (const EdgeKind kind : all_kinds) frame.row.push_back(std::to_string(count[kind]));
            frame.row.push_back(std::to_string(points));
            lesson.frames.push_back(std::exchange(frame, {}));
            lesson.frames.push_back({"after the " + side,
                                     counted(points, "point"),
                                     done->polygon.empty()
                                         ? "Nothing is left."
                                         : "What is left: " + places(s, done->polygon) + ".",
                                     {},
                                     {area(left_over, done->polygon), outline(left_over, done->polygon)},
                                     {}});
            for (const glm::vec2& p : done->polygon) lesson.frames.back().now.push_back(dot(left_over, p));
            count.clear(), points = 0;
        }
    }
    add_bridges(lesson, s, clipped);
    return lesson;
}

Lesson pipeline_lesson(const Subject& s, const Points& polygon) {
    constexpr std::size_t most_stages = 4;  // in the table
    Lesson lesson = lesson_of(s, polygon, true);
    lesson.name = "clip-pipeline";
    lesson.title = "Sutherland-Hodgman as a pipeline";
    lesson.sentence =
        "Each side of the window is a stage that holds two corners and hands on at once what it emits: "
        "no list of points in between.";
    lesson.source = "Sutherland and Hodgman 1974; textbook section 4.3.1, figure 4.8";
    const std::size_t shown = std::min(s.sides.size(), most_stages);
    lesson.columns = {"corner"};
    for (std::size_t i = 0; i < shown; ++i) lesson.columns.push_back(s.side_names[i] + ": first, last");
    lesson.columns.push_back("out");
    name_edges(lesson);
    Heard<ShapeEdgeClassified, ShapePointEmitted, ShapeStageHolds, ClipRefused> heard;
    const ClippedRing clipped = clip_ring_pipeline(polygon, std::span<const ClipLine>(s.sides), heard);

    std::vector<std::string> holds(s.sides.size(), "-");
    std::vector<std::vector<std::string>> kinds(shown);  // of the edges of each stage
    LessonFrame frame;
    std::size_t corner = 0;
    int out = 0;
    const auto finish = [&] {
        const bool closing = corner == polygon.size();
        frame.title = closing ? "close" : fmt::format("corner {}", corner + 1);
        std::vector<std::string> stages;
        for (std::size_t i = 0; i < shown; ++i)
            if (!kinds[i].empty())
                stages.push_back(s.side_names[i] + ": " + names(std::exchange(kinds[i], {})));
        frame.equation = stages.empty() ? "no edge yet" : fmt::format("{}", fmt::join(stages, "; "));
        frame.caption =
            closing ? "All corners are in: each side closes the polygon with the edge from its last to its "
                      "first corner."
                    : fmt::format(
                          "Corner {} goes to the first stage, the {}. What a stage emits goes to the next at "
                          "once; after the last it is a point of the answer.",
                          s.words.place(polygon[corner]), s.side_names[0]);
        frame.row = {closing ? "close" : s.words.place(polygon[corner])};
        for (std::size_t i = 0; i < shown; ++i) frame.row.push_back(holds[i]);
        frame.row.push_back(std::to_string(out));
        if (!closing) frame.now.push_back(dot(ink, polygon[corner]));
        lesson.frames.push_back(std::exchange(frame, {}));
        ++corner;
    };
    for (const auto& event : heard.events) {
        if (const auto* refused = std::get_if<ClipRefused>(&event)) {
            refuse(lesson, refused->reason);
            return lesson;
        }
        if (const auto* edge = std::get_if<ShapeEdgeClassified>(&event)) {
            if (edge->side == 0) finish();  // the corner before has run through
            if (edge->side < shown) kinds[edge->side].push_back(name_of(edge->kind));
            frame.now.push_back(arrow(*edge));
        } else if (const auto* point = std::get_if<ShapePointEmitted>(&event)) {
            if (point->side + 1 == s.sides.size()) frame.stays.push_back(dot(visible, point->point)), ++out;
            if (point->crossing) frame.now.push_back(emitted_dot(*point));
        } else if (const auto* stage = std::get_if<ShapeStageHolds>(&event)) {
            holds[stage->side] = s.words.place(stage->first) + " " + s.words.place(stage->last);
        }
    }
    if (!polygon.empty()) finish();
    lesson.frames.push_back(
        pieces_frame(clipped.points.empty() ? std::vector<Points>{} : std::vector<Points>{clipped.points},
                     "result", "The same polygon as by cutting at all sides in passes."));
    add_bridges(lesson, s, clipped);
    return lesson;
}

// ---------------------------------------------------------------------------------- Greiner-Hormann

Lesson greiner_hormann_lesson(const Subject& s, const Points& polygon) {
    Lesson lesson = lesson_of(s, polygon, true);
    lesson.name = "clip-greiner-hormann";
    lesson.title = "Greiner-Hormann polygon clipping";
    lesson.sentence =
        "Mark where the outlines meet, then walk: along the polygon while it is inside, along the window "
        "to the next entry. Windows may be concave.";
    lesson.source = "Weiler and Atherton 1977; Greiner and Hormann 1998; Foster, Hormann and Popa 2019";
    lesson.columns = {"ring", "along", "from", "to"};
    lesson.legend.push_back({Kind::Dot, visible, "the polygon enters"});
    lesson.legend.push_back({Kind::Dot, crossing, "it leaves"});
    lesson.legend.push_back({Kind::Dot, purple, "it only touches"});
    lesson.legend.push_back({Kind::Path, blue, "walked along the polygon"});
    lesson.legend.push_back({Kind::Path, orange, "walked along the window"});
    Heard<OutlinesMeet, OutlineWalked, ClipRefused> heard;
    const std::vector<Points> pieces = clip_shape_greiner_hormann(polygon, s.window, ClipKeep::Inside, heard);

    lesson.frames.push_back(
        {"two outlines",
         counted(std::ssize(polygon), "point") + " and " + counted(std::ssize(s.window), "point"),
         "Polygon and window are both walked clockwise.",
         {},
         {outline(left_over, polygon)},
         {}});
    LessonFrame meetings;
    std::map<MeetingKind, int> count;
    for (const auto& event : heard.events) {
        if (const auto* refused = std::get_if<ClipRefused>(&event)) {
            refuse(lesson, refused->reason);
            return lesson;
        }
        if (const auto* e = std::get_if<OutlinesMeet>(&event)) {
            const bool enters = e->kind == MeetingKind::Enters, leaves = e->kind == MeetingKind::Leaves;
            const Rgba8 color = enters ? visible : leaves ? crossing : purple;
            meetings.stays.push_back(dot(color, e->point));
            meetings.now.push_back(label(spot(e->point), color, enters ? "in" : leaves ? "out" : "touch"));
            ++count[e->kind];
        }
    }
    meetings.title = "where the outlines meet";
    meetings.equation = fmt::format("{} entering, {} leaving, {} touching", count[MeetingKind::Enters],
                                    count[MeetingKind::Leaves], count[MeetingKind::Touches]);
    meetings.caption =
        meetings.stays.empty()
            ? "They do not meet: one lies in the other, or they are apart."
            : "At each point where they meet, the directions of the edges say where the polygon goes: "
              "into the window, out of it, or neither.";
    meetings.now.push_back(outline(left_over, polygon));
    lesson.frames.push_back(std::move(meetings));

    // Stretches along the same outline are one frame.
    std::vector<OutlineWalked> walked;
    for (const auto& event : heard.events)
        if (const auto* e = std::get_if<OutlineWalked>(&event)) walked.push_back(*e);
    for (std::size_t i = 0; i < walked.size();) {
        const OutlineWalked& first = walked[i];
        Points path{first.from};
        for (; i < walked.size() && walked[i].ring == first.ring &&
               walked[i].along_window == first.along_window;
             ++i)
            path.push_back(walked[i].to);
        const Rgba8 color = first.along_window ? orange : blue;
        const char* which = first.along_window ? "window" : "polygon";
        LessonFrame frame;
        frame.title = fmt::format("ring {}: along the {}", first.ring + 1, which);
        frame.equation = s.words.place(path.front()) + " -> " + s.words.place(path.back());
        frame.caption = first.along_window
                            ? "Along the window, inside of the polygon, until the polygon enters again."
                            : "Along the polygon, inside of the window, until it leaves.";
        if (path.size() > 2) frame.caption += " By way of " + places(s, std::span(path).subspan(1)) + ".";
        frame.stays = {mark(Kind::Path, color, spots(path))};
        frame.now = {mark(Kind::Arrow, color, {spot(path[path.size() - 2]), spot(path.back())})};
        frame.row = {std::to_string(first.ring + 1), which, s.words.place(path.front()),
                     s.words.place(path.back())};
        lesson.frames.push_back(std::move(frame));
    }
    lesson.frames.push_back(pieces_frame(
        pieces, "result",
        pieces.empty() ? "They have no area in common."
                       : fmt::format("Every ring is closed: {}.", counted(std::ssize(pieces), "polygon"))));
    return lesson;
}

Lesson segment_lesson(const Subject& s, const Segment& whole) {
    if (!s.upright) return cyrus_beck_lesson(s, whole);
    switch (s.clip.lines) {
        case raster::LineClipper::CohenSutherland:
            return cohen_sutherland_lesson(s, whole);
        case raster::LineClipper::CyrusBeck:
            return cyrus_beck_lesson(s, whole);
        case raster::LineClipper::LiangBarsky:
            return liang_barsky_lesson(s, whole);
        default:
            return midpoint_lesson(s, whole);
    }
}

Lesson polygon_lesson(const Subject& s, const Points& polygon) {
    const bool walks = s.clip.polygons == raster::PolygonClipper::GreinerHormann;
    if (!walks && s.refusal) {
        Lesson lesson = lesson_of(s, polygon, true);
        lesson.name = "clip-sutherland-hodgman", lesson.title = "Sutherland-Hodgman polygon clipping";
        refuse(lesson, *s.refusal);
        return lesson;
    }
    if (walks) return greiner_hormann_lesson(s, polygon);
    return s.clip.polygons == raster::PolygonClipper::SutherlandHodgman ? passes_lesson(s, polygon)
                                                                        : pipeline_lesson(s, polygon);
}

}  // namespace

std::vector<Lesson> clipping_lessons(const scene::LoadedScene& loaded, std::size_t number_of_shape) {
    if (!loaded.shapes.clip.on) return {};
    const Subject s = subject_of(loaded);
    const raster::Shape& shape = loaded.shapes.shapes[number_of_shape];
    const Points& p = shape.points;
    std::vector<Lesson> found;
    switch (shape.kind) {
        case raster::ShapeKind::Line:
        case raster::ShapeKind::Polyline:
            for (std::size_t i = 0; i + 1 < std::min(p.size(), most_segments + 1); ++i)
                found.push_back(segment_lesson(s, {p[i], p[i + 1]}));
            break;
        case raster::ShapeKind::Rectangle:
            if (p.size() == 2)
                found.push_back(polygon_lesson(s, {p[0], {p[1].x, p[0].y}, p[1], {p[0].x, p[1].y}}));
            break;
        case raster::ShapeKind::Triangle:
        case raster::ShapeKind::Polygon:
            found.push_back(polygon_lesson(s, p));
            break;
        default:
            break;  // circles and ellipses: lessons_curve.cpp
    }
    return found;
}

}  // namespace relevo::show
