// Lessons of smooth edges: the covered area of a pixel, the cone over it, its sample points, and samples that
// shapes share.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "pipeline/clip_shape_sutherland_hodgman.hpp"
#include "raster/area_coverage.hpp"
#include "raster/line_outline.hpp"
#include "raster/supersample.hpp"
#include "raster/weighted_coverage.hpp"
#include "samples/show/lesson_marks.hpp"
#include "samples/show/lessons.hpp"
#include "samples/show/numbers.hpp"

namespace relevo::show {
namespace {

using Kind = Mark::Kind;
using raster::Antialiasing;
using raster::full_coverage;
using raster::PixelBox;
using raster::ScanAlgorithm;
using raster::Shape;
using raster::ShapeKind;
using Rings = std::vector<std::vector<glm::dvec2>>;
using Place = std::pair<int, int>;  // (y, x): pixels in the order of the rows

constexpr std::size_t most_shown = 40;  // pixels one by one; with the frames around them at most 48
constexpr Rgba8 covered_color = blue, now_color = vermilion;

// ------------------------------------------------------------------------------- a shape and its pixels
bool is_smooth_area(const Shape& s) {
    const auto near = [](double c) { return std::abs(c) <= raster::largest_place; };
    const bool line = s.kind == ShapeKind::Line || s.kind == ShapeKind::Polyline;
    const bool weighs = s.algorithm == ScanAlgorithm::Wu || s.algorithm == ScanAlgorithm::GuptaSproull;
    const std::size_t least = s.kind == ShapeKind::Triangle || s.kind == ShapeKind::Polygon ? 3 : 2;
    return s.kind != ShapeKind::Circle && s.kind != ShapeKind::Ellipse && !(line && weighs) &&
           s.points.size() >= least && s.width > 0 && near(s.width) &&
           std::all_of(s.points.begin(), s.points.end(),
                       [&](const glm::vec2& p) { return near(p.x) && near(p.y); });
}

Rings outline_of(const Shape& s) {
    if (s.kind == ShapeKind::Rectangle)
        return {{s.points[0], {s.points[1].x, s.points[0].y}, s.points[1], {s.points[0].x, s.points[1].y}}};
    if (s.kind != ShapeKind::Line && s.kind != ShapeKind::Polyline)
        return {{s.points.begin(), s.points.end()}};
    Rings rings;
    for (std::size_t i = 0; i + 1 < s.points.size(); ++i) {
        const auto corners = raster::line_outline(s.points[i], s.points[i + 1], s.width);
        rings.emplace_back(corners.begin(), corners.end());
    }
    return rings;
}

struct Subject {
    const scene::LoadedScene& loaded;
    std::size_t number;  // of the shape
    const Shape& shape;
    Rings rings;
    PixelBox view;
    std::string left_out;  // what the lesson does not show

    std::string x(int px) const { return number_of(loaded.axes.x_of(px)); }
    std::string y(int py) const { return number_of(loaded.axes.y_of(py)); }
    std::string place(Place p) const { return fmt::format("({}, {})", x(p.second), y(p.first)); }
    static std::string number_of(double v) { return show::number(v); }
};

using Coverages = std::map<Place, int>;

Coverages coverages(Antialiasing how, const Shape& shape, const Rings& rings, const PixelBox& box) {
    Coverages found;
    const auto cover = [&](int y, int x0, int x1, int coverage) {
        for (int x = x0; x < x1; ++x) found[{y, x}] = coverage;
    };
    if (how == Antialiasing::Area)
        raster::area_coverage(rings, shape.inside, box, cover);
    else if (how == Antialiasing::Weighted)
        raster::weighted_coverage(rings, shape.inside, box, cover);
    else
        raster::supersample(shape.samples, rings, shape.inside, box, cover);
    return found;
}

// Around the shape as far as it lies in the picture; when that is too much, around a pixel of its border.
std::optional<Subject> subject_of(const scene::LoadedScene& loaded, std::size_t number, int columns,
                                  int rows) {
    const Shape& shape = loaded.shapes.shapes[number];
    if (!is_smooth_area(shape)) return {};
    Subject s{loaded, number, shape, outline_of(shape), {}, {}};
    double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
    for (const auto& ring : s.rings)
        for (const glm::dvec2& p : ring) {
            left = std::min(left, p.x), right = std::max(right, p.x);
            top = std::min(top, p.y), bottom = std::max(bottom, p.y);
        }
    const auto whole = [](double v) { return static_cast<int>(std::floor(v + 0.5)); };
    const int margin = shape.antialiasing == Antialiasing::Weighted ? 2 : 1;  // the cones of the border
    const PixelBox seen{std::max(whole(left) - margin, 0), std::max(whole(top) - margin, 0),
                        std::min(whole(right) + margin, loaded.width - 1),
                        std::min(whole(bottom) + margin, loaded.height - 1)};
    if (seen.empty()) return {};
    s.view = seen;
    if (loaded.shapes.clip.on)
        s.left_out = " The shape is smoothed whole here; its own lesson shows how it is cut.";
    if (seen.x1 - seen.x0 < columns && seen.y1 - seen.y0 < rows) return s;
    Place middle{(seen.y0 + seen.y1) / 2, (seen.x0 + seen.x1) / 2}, best = middle;
    int distance = 1 << 30;
    for (const auto& [at, coverage] : coverages(Antialiasing::Area, shape, s.rings, seen)) {
        const int away = std::abs(at.first - middle.first) + std::abs(at.second - middle.second);
        if (coverage < full_coverage && away < distance) best = at, distance = away;
    }
    const auto part = [](int low, int high, int at, int most) {
        if (high - low < most) return std::pair{low, high};
        const int from = std::clamp(at - most / 2, low, high - most + 1);
        return std::pair{from, from + most - 1};
    };
    const auto [x0, x1] = part(seen.x0, seen.x1, best.second, columns);
    const auto [y0, y1] = part(seen.y0, seen.y1, best.first, rows);
    s.view = {x0, y0, x1, y1};
    s.left_out += fmt::format(" Only {} by {} pixels of it are shown, so that they are large enough.",
                              x1 - x0 + 1, y1 - y0 + 1);
    return s;
}

// ---------------------------------------------------------------------------------------------- marks
Mark frame_of(Place p) { return mark(Kind::Frame, now_color, {{double(p.second), double(p.first)}}); }
Mark cell_of(Place p, int coverage) {
    return cell(spot_of(raster::Pixel{p.second, p.first}), covered_color, level_of(coverage));
}

double share(int coverage) { return coverage / double(full_coverage); }
std::string percent(int coverage) {
    const int whole = static_cast<int>((std::int64_t{coverage} * 100 + full_coverage / 2) / full_coverage);
    if (whole == 0) return "under 1 %";
    return whole == 100 && coverage < full_coverage ? "over 99 %" : fmt::format("{} %", whole);
}
bool is_border(int coverage) { return 0 < coverage && coverage < full_coverage; }

// The pieces of the outline in the square of a pixel.
std::vector<std::vector<Spot>> pieces_in(const Rings& rings, Place at) {
    const glm::vec2 center{float(at.second), float(at.first)};
    const pipeline::ClipBox square{center - 0.5f, center + 0.5f};
    std::vector<std::vector<Spot>> pieces;
    for (const auto& ring : rings) {
        const std::vector<glm::vec2> corners(ring.begin(), ring.end());
        const auto cut = pipeline::clip_shape_sutherland_hodgman(std::span<const glm::vec2>(corners), square);
        if (cut.size() < 3) continue;
        pieces.emplace_back();
        for (const glm::vec2& p : cut) pieces.back().push_back({p.x, p.y});
    }
    return pieces;
}

std::vector<Mark> outlines_of(const Rings& rings, Rgba8 color) {
    std::vector<Mark> outlines;
    for (const auto& ring : rings) {
        if (ring.size() > 5000) continue;
        outlines.push_back(mark(Kind::Outline, color, {}));
        for (const glm::dvec2& p : ring) outlines.back().points.push_back({p.x, p.y});
    }
    return outlines;
}

Lesson lesson_of(const Subject& s, std::string name, std::string title, std::string sentence,
                 std::string source) {
    Lesson lesson;
    lesson.name = std::move(name);
    lesson.title = std::move(title);
    lesson.sentence = std::move(sentence);
    lesson.source = std::move(source);
    lesson.view = s.view;
    lesson.ground = outlines_of(s.rings, ink);
    lesson.legend = {{Kind::Cell, covered_color, "the more of it, the more is covered"},
                     {Kind::Frame, now_color, "the pixel of this step"}};
    return lesson;
}

// The whole pixels in one frame, and then those of the border, `tell(place, coverage)` for each that is
// shown.
template <class Tell>
void add_pixels(Lesson& lesson, const Coverages& all, const std::string& whole, Tell&& tell) {
    LessonFrame inside;
    std::size_t border = 0, full = 0;
    for (const auto& [at, coverage] : all)
        if (is_border(coverage))
            ++border;
        else
            inside.stays.push_back(cell_of(at, coverage)), ++full;
    if (full > 0) {
        inside.title = counted(std::int64_t(full), "pixel") + " inside";
        inside.equation = whole;
        inside.caption = "Inside the shape there is nothing to weigh: these pixels take the colour as it is.";
        lesson.frames.push_back(std::move(inside));
    }
    const std::size_t shown = std::min(border, most_shown);
    std::size_t seen = 0, left_out = 0;
    std::vector<Mark> waiting;
    for (const auto& [at, coverage] : all) {
        if (!is_border(coverage)) continue;
        ++seen;
        if (shown * seen / border == shown * (seen - 1) / border) {
            waiting.push_back(cell_of(at, coverage));
            ++left_out;
            continue;
        }
        LessonFrame frame = tell(at, coverage);
        if (left_out > 0)
            frame.caption +=
                fmt::format(" ({} before this one, treated alike, {} left out here.)",
                            counted(std::int64_t(left_out), "pixel"), left_out == 1 ? "is" : "are");
        frame.stays = std::move(waiting);
        frame.stays.push_back(cell_of(at, coverage));
        waiting.clear(), left_out = 0;
        lesson.frames.push_back(std::move(frame));
    }
}

// Two border pixels whose `by` is the same within `near` and not small, as far apart
// in `differ` as there are.
template <class By, class Differ>
std::optional<std::pair<Place, Place>> alike(const Coverages& all, By&& by, Differ&& differ, double near,
                                             double least) {
    std::optional<std::pair<Place, Place>> best;
    std::vector<std::pair<double, Place>> order;
    for (const auto& [at, coverage] : all)
        if (is_border(coverage) && by(at) >= 0.2) order.push_back({by(at), at});
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i + 1 < order.size(); ++i)
        for (std::size_t k = i + 1; k < order.size() && order[k].first - order[i].first <= near; ++k) {
            const double apart = differ(order[i].second, order[k].second);
            if (apart > least) least = apart, best = {{order[i].second, order[k].second}};
        }
    return best;
}

Spot middle_of(const std::vector<std::vector<Spot>>& pieces, Place at) {
    Spot sum{0, 0};
    double corners = 0;
    for (const auto& piece : pieces)
        for (const Spot& p : piece) sum.x += p.x - at.second, sum.y += p.y - at.first, ++corners;
    return corners > 0 ? Spot{sum.x / corners, sum.y / corners} : sum;
}

int at_or_0(const Coverages& all, Place p) {
    const auto found = all.find(p);
    return found == all.end() ? 0 : found->second;
}

// Another smooth shape that shares a border pixel with this one so that both together fill it.
struct Neighbour {
    const Shape* shape;
    Rings rings;
    Place at;
    int mine, theirs;

    std::vector<Mark> marks() const {
        std::vector<Mark> found = outlines_of(rings, orange);
        found.push_back(frame_of(at));
        return found;
    }
};
std::optional<Neighbour> neighbour_of(const Subject& s, const Coverages& mine, Antialiasing how) {
    std::optional<Neighbour> best;
    int least = full_coverage / 4;  // the smaller half: a good example is near half and half
    for (std::size_t i = 0; i < s.loaded.shapes.shapes.size(); ++i) {
        const Shape& other = s.loaded.shapes.shapes[i];
        if (i == s.number || !is_smooth_area(other) || other.antialiasing != s.shape.antialiasing) continue;
        const Rings rings = outline_of(other);
        for (const auto& [at, theirs] : coverages(how, other, rings, s.view)) {
            const int here = at_or_0(mine, at), smaller = std::min(here, theirs);
            if (std::abs(here + theirs - full_coverage) <= 4 && smaller > least)
                least = smaller, best = Neighbour{&other, rings, at, here, theirs};
        }
    }
    return best;
}

// ------------------------------------------------------------------------------------ area (section 8.1)
// "0.62 - 0.31 = ": what the edges of a convex shape give to a pixel; those on its left give all of its rows.
struct EdgeShares {
    int sign = 0;  // 1: the left side goes down; 0: not told
    std::map<Place, std::vector<int>> of{};

    void on(const raster::EdgeShared& e) {
        if (e.share != 0) of[{e.y, e.x}].push_back(sign * e.share);
    }
    std::string sum(Place at, int coverage) const {
        const auto found = of.find(at);
        if (sign == 0 || found == of.end() || found->second.size() > 3) return {};
        std::vector<int> parts = found->second;
        std::sort(parts.rbegin(), parts.rend());
        int rest = coverage;
        for (const int part : parts) rest -= part;
        if (rest != 0) parts.insert(parts.begin(), rest);
        if (parts.size() < 2 || parts[0] < 0) return {};
        std::string text = number(share(parts[0]));
        for (std::size_t i = 1; i < parts.size(); ++i)
            text += (parts[i] < 0 ? " - " : " + ") + number(share(std::abs(parts[i])));
        return text + " = ";
    }
};

int turn_of(const Subject& s) {
    if (s.shape.kind == ShapeKind::Polygon || s.rings.size() != 1) return 0;
    double twice = 0;
    const auto& ring = s.rings[0];
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice < 0 ? 1 : -1;
}

Lesson area_lesson(const Subject& s) {
    Lesson lesson = lesson_of(
        s, "area-coverage", "Covered area",
        "Each pixel is a square around its centre; it takes as much of the colour as the shape covers of it.",
        "Catmull 1978; textbook section 8.1, figures 8.3 to 8.5");
    lesson.columns = {"x", "y", "corners", "area", "of 65536", "%"};
    const Coverages all = coverages(Antialiasing::Area, s.shape, s.rings, s.view);
    EdgeShares edges{turn_of(s)};
    raster::area_coverage(
        std::span<const std::vector<glm::dvec2>>(s.rings), s.shape.inside, s.view, [](int, int, int, int) {},
        edges);
    lesson.frames.push_back({"the shape",
                             "coverage = area of the shape in the pixel's square",
                             "A pixel that is covered whole takes the colour, one that is not touched stays, "
                             "and those on the border mix." +
                                 s.left_out,
                             {},
                             {},
                             {}});
    add_pixels(lesson, all, "area = 1 -> 100 %", [&](Place at, int coverage) {
        LessonFrame frame;
        frame.title = "pixel " + s.place(at);
        frame.equation = fmt::format("area = {}{} -> {}", edges.sum(at, coverage), number(share(coverage)),
                                     percent(coverage));
        std::size_t corners = 0;
        for (auto& piece : pieces_in(s.rings, at)) {
            corners += piece.size();
            frame.now.push_back(mark(Kind::Area, now_color, piece));
            frame.now.push_back(mark(Kind::Outline, now_color, std::move(piece)));
        }
        frame.now.push_back(frame_of(at));
        frame.caption = fmt::format(
            "The piece of the shape in this square has {} and {} of its area. Of the "
            "pixel's colour that much is the shape's.",
            counted(std::int64_t(corners), "corner"), percent(coverage));
        frame.row = {s.x(at.second),          s.y(at.first),     std::to_string(corners),
                     number(share(coverage)), grouped(coverage), percent(coverage)};
        return frame;
    });
    const auto apart = [&](Place a, Place b) {
        const Spot p = middle_of(pieces_in(s.rings, a), a), q = middle_of(pieces_in(s.rings, b), b);
        return std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
    };
    if (const auto pair = all.size() > 4000
                              ? std::nullopt
                              : alike(
                                    all, [&](Place p) { return share(all.at(p)); }, apart, 0.5 / 255, 0.2)) {
        LessonFrame frame;
        frame.title = "same area, other place";
        frame.equation = fmt::format("{} and {}: the same grey", number(share(all.at(pair->first))),
                                     number(share(all.at(pair->second))));
        frame.caption = fmt::format(
            "Pixels {} and {} are covered alike, though in other places of their "
            "squares: where the piece lies does not matter here (figure 8.5).",
            s.place(pair->first), s.place(pair->second));
        for (const Place& at : {pair->first, pair->second}) {
            for (auto& piece : pieces_in(s.rings, at))
                frame.now.push_back(mark(Kind::Area, now_color, std::move(piece)));
            frame.now.push_back(frame_of(at));
        }
        lesson.frames.push_back(std::move(frame));
    }
    if (const auto seam = neighbour_of(s, all, Antialiasing::Area)) {
        const double a = share(seam->mine), b = share(seam->theirs);
        lesson.frames.push_back(
            {"a seam",
             fmt::format("1 - (1 - {})(1 - {}) = {}, not 1", number(a), number(b),
                         number(1 - (1 - a) * (1 - b))),
             fmt::format(
                 "Pixel {} is shared with the shape outlined in orange, and both together fill it. "
                 "But each mixes with what it finds, so {} of the background stays: area is right for "
                 "a shape and wrong for neighbours. Samples that shapes share leave no seam.",
                 s.place(seam->at), percent(static_cast<int>(std::lrint((1 - a) * (1 - b) * full_coverage)))),
             {},
             seam->marks(),
             {}});
    }
    std::int64_t sum = 0;
    for (const auto& [at, coverage] : all) sum += coverage;
    lesson.frames.push_back(
        {"all pixels",
         fmt::format("sum of all areas = {}", number(double(sum) / full_coverage)),
         s.left_out.empty() ? "Nothing is lost: the pixels add up to the area of the shape in the picture."
                            : "Nothing is lost: the pixels add up to the area of the shape in this view.",
         {},
         {},
         {}});
    return lesson;
}

// -------------------------------------------------------------------------------- weighted (section 8.2)
// The cone from above: discs upon discs, darker towards the centre.
std::vector<Mark> cone_over(Place at) {
    std::vector<Mark> discs;
    for (const double radius : {1.0, 0.75, 0.5, 0.25}) {
        Mark disc = mark(Kind::Area, purple, {});
        for (int degrees = 0; degrees < 360; degrees += 10)
            disc.points.push_back({at.second + radius * pipeline::cos({double(degrees)}),
                                   at.first + radius * pipeline::sin({double(degrees)})});
        discs.push_back(std::move(disc));
    }
    discs.push_back({Kind::Curve, purple, {{double(at.second), double(at.first)}}, 1, 1, 255, {}});
    discs.push_back(frame_of(at));
    return discs;
}

Lesson weighted_lesson(const Subject& s) {
    Lesson lesson =
        lesson_of(s, "weighted-coverage", "Weighted area",
                  "A pixel looks at the shape through a cone of radius 1 that stands on its centre: "
                  "what is near the centre counts more, and what is near the square counts, too.",
                  "textbook section 8.2, figure 8.6; Feibush, Levoy and Cook 1980");
    lesson.columns = {"x", "y", "weight", "%", "area"};
    lesson.legend.push_back({Kind::Area, purple, "the cone, darker where it is higher"});
    const Coverages all = coverages(Antialiasing::Weighted, s.shape, s.rings, s.view),
                    areas = coverages(Antialiasing::Area, s.shape, s.rings, s.view);
    lesson.frames.push_back(
        {"the cone",
         "volume = pi r^2 h / 3 = 1 for r = 1, h = 3/pi = 0.9549",
         "The cone's volume over the shape is the coverage. The cone reaches as far as the "
         "centres of the neighbours." +
             s.left_out,
         {},
         cone_over({(s.view.y0 + s.view.y1) / 2, (s.view.x0 + s.view.x1) / 2}),
         {}});
    add_pixels(
        lesson, all, "the whole cone stands on the shape: volume = 1 -> 100 %", [&](Place at, int coverage) {
            const int area = at_or_0(areas, at);
            LessonFrame frame;
            frame.title = "pixel " + s.place(at);
            frame.equation = fmt::format("volume over the shape = {} -> {}  (area alone: {})",
                                         number(share(coverage)), percent(coverage), number(share(area)));
            frame.caption =
                area == 0 ? "The shape does not touch this pixel's square, but the cone reaches it: the "
                            "tones pass over softly."
                : number(share(coverage)) == number(share(area))
                    ? "As much as the area alone: what the cone meets beyond the square makes up for its "
                      "height, less than 1 everywhere."
                : coverage > area
                    ? "More than the area alone: the cone meets the shape beyond the square, too."
                    : "Less than the area alone: the cone is lower than 1 everywhere, and what it "
                      "meets beyond the square does not make up for it.";
            frame.now = cone_over(at);
            frame.row = {s.x(at.second), s.y(at.first), number(share(coverage)), percent(coverage),
                         number(share(area))};
            return frame;
        });
    const auto difference = [&](Place a, Place b) { return std::abs(share(all.at(a)) - share(all.at(b))); };
    if (const auto pair = all.size() > 4000 ? std::nullopt
                                            : alike(
                                                  all, [&](Place p) { return share(at_or_0(areas, p)); },
                                                  difference, 1.0 / full_coverage, 0.05)) {
        LessonFrame frame;
        frame.title = "same area, other weight";
        frame.equation =
            fmt::format("area {} and {}, weight {} and {}", number(share(at_or_0(areas, pair->first))),
                        number(share(at_or_0(areas, pair->second))), number(share(all.at(pair->first))),
                        number(share(all.at(pair->second))));
        frame.caption = fmt::format(
            "The shape has the same area in pixels {} and {}, but the cone sees where: near the centre "
            "counts more, and beyond the square counts, too (figure 8.6).",
            s.place(pair->first), s.place(pair->second));
        for (const Place& at : {pair->first, pair->second})
            for (Mark& m : cone_over(at)) frame.now.push_back(std::move(m));
        lesson.frames.push_back(std::move(frame));
    }
    return lesson;
}

// ------------------------------------------------------------------------------------------- sample points
// The points of the view that a shape covers: (y, x) on the finer grid.
struct Points {
    std::map<Place, std::size_t> owner;  // and by which shape, the last one wins
    std::size_t shape = 0;
    void on(const raster::SamplesInside& e) {
        for (int x = e.x0; x < e.x1; ++x) owner[{e.y, x}] = shape;
    }
};

void add_points(Points& points, const Shape& shape, int n, std::size_t number, const PixelBox& box) {
    points.shape = number;
    const Rings rings = outline_of(shape);
    raster::supersample(
        n, std::span<const std::vector<glm::dvec2>>(rings), shape.inside, box, [](int, int, int, int) {},
        points);
}

template <class Visit>
void each_point(Place at, int n, Visit&& visit) {
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            visit(Place{n * at.first + j, n * at.second + i},
                  Spot{at.second - 0.5 + (i + 0.5) / n, at.first - 0.5 + (j + 0.5) / n});
}

// Pixels in a row, so that the points stand apart on a page.
int view_size(int n) { return n <= 2 ? 12 : n <= 4 ? 7 : n <= 8 ? 4 : 2; }

Lesson supersample_lesson(const Subject& s) {
    const int n = s.shape.samples;
    Lesson lesson = lesson_of(
        s, "supersample", fmt::format("{} x {} samples a pixel", n, n),
        "Points on a finer grid ask whether they lie in the shape; the share that do is the coverage.",
        "Crow 1977");
    lesson.columns = {"x", "y", "inside", "coverage", "area"};
    lesson.legend.push_back({Kind::Dot, green, "point inside"});
    lesson.legend.push_back({Kind::Cross, haze, "point outside"});
    const Coverages all = coverages(Antialiasing::Supersample, s.shape, s.rings, s.view),
                    areas = coverages(Antialiasing::Area, s.shape, s.rings, s.view);
    Points points;
    add_points(points, s.shape, n, s.number, s.view);
    lesson.frames.push_back({"the points",
                             fmt::format("{} x {} points a pixel: steps of 1/{}", n, n, n * n),
                             "Each point is decided exactly, like the centre of a small pixel." + s.left_out,
                             {},
                             {},
                             {}});
    add_pixels(
        lesson, all, fmt::format("{} of {} points -> 100 %", n * n, n * n), [&](Place at, int coverage) {
            LessonFrame frame;
            int inside = 0;
            std::vector<Mark> hits;
            each_point(at, n, [&](Place p, Spot spot) {
                const bool hit = points.owner.contains(p);
                inside += hit;
                (hit ? hits : frame.now)
                    .push_back(mark(hit ? Kind::Dot : Kind::Cross, hit ? green : haze, {spot}));
            });
            std::move(hits.begin(), hits.end(), std::back_inserter(frame.now));
            frame.now.push_back(frame_of(at));
            const double area = share(at_or_0(areas, at));
            frame.title = "pixel " + s.place(at);
            frame.equation = fmt::format("{} of {} = {} -> {}  (area: {})", inside, n * n,
                                         number(double(inside) / (n * n)), percent(coverage), number(area));
            frame.caption = fmt::format("{} inside. The area is {}, so the points are off by {}.",
                                        inside == 1 ? "One point lies" : fmt::format("{} points lie", inside),
                                        number(area), number(std::abs(double(inside) / (n * n) - area)));
            frame.row = {s.x(at.second), s.y(at.first), fmt::format("{} of {}", inside, n * n),
                         number(share(coverage)), number(area)};
            return frame;
        });
    int missed = 0;
    for (const auto& [at, area] : areas) missed += area > 0 && !all.contains(at);
    if (missed > 0)
        lesson.frames.push_back(
            {"missed",
             fmt::format("{} touched, but no point is inside", counted(missed, "pixel")),
             "What slips between the points is not seen at all. More points miss less; the "
             "exact area misses nothing.",
             {},
             [&] {
                 std::vector<Mark> marks;
                 for (const auto& [at, area] : areas)
                     if (area > 0 && !all.contains(at)) marks.push_back(frame_of(at));
                 return marks;
             }(),
             {}});
    return lesson;
}

Lesson multisample_lesson(const Subject& s) {
    const int n = s.shape.samples;
    Lesson lesson = lesson_of(s, "multisample", fmt::format("{} x {} samples that shapes share", n, n),
                              "Every point keeps its own colour until all shapes are drawn; a pixel is the "
                              "average of its points. Neighbours share out the points, so no seam is left.",
                              "Akeley 1993");
    lesson.columns = {"x", "y", "this", "others", "free"};
    const Coverages all = coverages(Antialiasing::Multisample, s.shape, s.rings, s.view);
    Points points;
    for (std::size_t i = 0; i < s.loaded.shapes.shapes.size(); ++i) {
        const Shape& other = s.loaded.shapes.shapes[i];
        if (other.antialiasing == Antialiasing::Multisample && is_smooth_area(other))
            add_points(points, other, n, i, s.view);
    }
    lesson.legend.push_back({Kind::Dot, green, "point of this shape"});
    lesson.legend.push_back({Kind::Dot, orange, "point of another shape"});
    lesson.legend.push_back({Kind::Cross, haze, "point of the background"});
    lesson.frames.push_back(
        {"the points",
         fmt::format("pixel = average of its {} points", n * n),
         "A shape paints the points inside it. A point on a shared edge belongs to one of the "
         "two shapes, never to both, never to none." +
             s.left_out,
         {},
         {},
         {}});
    add_pixels(
        lesson, all, fmt::format("{} of {} points -> 100 %", n * n, n * n), [&](Place at, int coverage) {
            LessonFrame frame;
            int mine = 0, others = 0;
            each_point(at, n, [&](Place p, Spot spot) {
                const auto found = points.owner.find(p);
                const bool free = found == points.owner.end(), own = !free && found->second == s.number;
                mine += own, others += !free && !own;
                frame.now.push_back(mark(free ? Kind::Cross : Kind::Dot,
                                         free  ? haze
                                         : own ? green
                                               : orange,
                                         {spot}));
            });
            frame.now.push_back(frame_of(at));
            const int free = n * n - mine - others;
            frame.title = "pixel " + s.place(at);
            frame.equation = fmt::format("{} + {} of {} = {}", mine, others, n * n,
                                         number(double(mine + others) / (n * n)));
            frame.caption =
                others == 0 ? fmt::format("{} of the pixel is this shape's.", percent(coverage))
                : free == 0 ? "All points have an owner: nothing of the background shines through."
                            : fmt::format("{} left to the background.",
                                          free == 1 ? "One point is" : fmt::format("{} points are", free));
            frame.row = {s.x(at.second), s.y(at.first), std::to_string(mine), std::to_string(others),
                         std::to_string(free)};
            return frame;
        });
    if (const auto seam = neighbour_of(s, all, Antialiasing::Multisample)) {
        const PixelBox pixel{seam->at.second, seam->at.first, seam->at.second, seam->at.first};
        const auto area = [&](const Rings& rings, const Shape& shape) {
            return share(at_or_0(coverages(Antialiasing::Area, shape, rings, pixel), seam->at));
        };
        const auto points_of = [&](int coverage) { return std::lround(share(coverage) * n * n); };
        const double a = area(s.rings, s.shape), b = area(seam->rings, *seam->shape);
        lesson.frames.push_back(
            {"no seam",
             fmt::format("{} + {} = {};  area: 1 - (1 - {})(1 - {}) = {}", points_of(seam->mine),
                         points_of(seam->theirs), n * n, number(a), number(b), number(1 - (1 - a) * (1 - b))),
             fmt::format("Pixel {} is shared with the shape outlined in orange: together they own all its "
                         "{}. By their "
                         "areas, one after the other, they would leave a seam of the background.",
                         s.place(seam->at), counted(n * n, "point")),
             {},
             seam->marks(),
             {}});
    }
    return lesson;
}

}  // namespace

std::vector<Lesson> antialiasing_lessons(const scene::LoadedScene& loaded, std::size_t shape) {
    const Shape& s = loaded.shapes.shapes[shape];
    if (s.antialiasing == Antialiasing::None) return {};
    const bool points =
        s.antialiasing == Antialiasing::Supersample || s.antialiasing == Antialiasing::Multisample;
    if (points && (s.samples < 1 || s.samples > raster::most_samples)) return {};
    const int columns = points ? view_size(s.samples) : 24;
    const auto subject = subject_of(loaded, shape, columns, points ? columns : 18);
    if (!subject) return {};
    switch (s.antialiasing) {
        case Antialiasing::Area:
            return {area_lesson(*subject)};
        case Antialiasing::Weighted:
            return {weighted_lesson(*subject)};
        case Antialiasing::Supersample:
            return {supersample_lesson(*subject)};
        default:
            return {multisample_lesson(*subject)};
    }
}

}  // namespace relevo::show
