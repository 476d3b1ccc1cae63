#include "samples/scene/shapes2d.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/simple_polygon.hpp"

namespace relevo::scene {
namespace {

using raster::Antialiasing;
using raster::ScanAlgorithm;
using raster::Shape;
using raster::ShapeKind;
using Point = glm::vec2;

constexpr std::string_view axes_keys[] = {"extent", "y"};
constexpr std::string_view clip_keys[] = {"window", "polygon", "lines", "polygons", "order", "split"};
constexpr std::string_view shape_keys[] = {"type",    "points",  "center",       "radius", "algorithm",
                                           "samples", "width",   "antialiasing", "filled", "inside",
                                           "color",   "opacity", "even_weight"};
constexpr double half_the_least_float = 0x1p-150;  // what is not larger is 0 as a float
constexpr int largest_zoom = 64, most_samples = 16;
constexpr std::size_t most_points = 1'000'000, most_walked = 4096;

bool is_line(ShapeKind kind) { return kind == ShapeKind::Line || kind == ShapeKind::Polyline; }
bool is_curve(ShapeKind kind) { return kind == ShapeKind::Circle || kind == ShapeKind::Ellipse; }
bool smooths_itself(ScanAlgorithm algorithm) {
    return algorithm == ScanAlgorithm::Wu || algorithm == ScanAlgorithm::GuptaSproull;
}
bool counts_samples(Antialiasing antialiasing) {
    return antialiasing == Antialiasing::Supersample || antialiasing == Antialiasing::Multisample;
}
bool walks(const raster::ShapeClip& clip) { return clip.polygons == raster::PolygonClipper::GreinerHormann; }
template <class Meaning>
bool holds(const std::vector<Meaning>& all, Meaning one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

template <class Meaning, std::size_t count>
std::string names(const std::vector<Meaning>& all, const Choice<Meaning> (&choices)[count]) {
    std::vector<std::string_view> words;
    for (const Meaning one : all) words.push_back(name_of(one, choices));
    return joined(words);
}

// ------------------------------------------------------------------------------------------------- [axes]
// Turns the coordinates of the file into pixels, within the range in which all algorithms are exact.
class Places {
  public:
    explicit Places(const LessonAxes& axes)
        : axes_(axes),
          across_(range(axes.left - largest_place, axes.left + largest_place)),
          along_(range(axes.top - largest_place, axes.top + largest_place)),
          words_(fmt::format("from {} to {} for x and from {} to {} for y", across_.low, across_.high,
                             along_.low, along_.high)) {
        across_.accepted = along_.accepted = words_;
    }
    Places(const Places&) = delete;

    Point point(const Fields& fields, const Value& value, std::string_view key) const {
        const Range ranges[] = {across_, along_};
        const std::vector<double> n = fields.numbers(value, key, ranges);
        return {static_cast<float>(axes_.pixel_x(n[0])), static_cast<float>(axes_.pixel_y(n[1]))};
    }
    // [x0, y0, x1, y1] in the file's order.
    std::vector<double> box(const Fields& fields, std::string_view key) const {
        const Range ranges[] = {across_, along_, across_, along_};
        return fields.numbers(*fields.find(key), key, ranges);
    }
    const LessonAxes& axes() const { return axes_; }

  private:
    static Range range(int low, int high) { return {double(low), double(high), false, false, ""}; }

    const LessonAxes& axes_;
    Range across_, along_;
    std::string words_;
};

// Both numbers of the picture's size in turn: what [image] or --size says must be what the extent says.
void take_size_of_extent(const LessonTables& tables, std::optional<std::pair<int, int>> size, int width,
                         int height, LoadedScene& out, Diagnosis& diagnosis) {
    if (size && *size != std::pair(width, height))
        diagnosis.say({fmt::format("--size {}x{}", size->first, size->second), 0, 0},
                      fmt::format("the picture of a lesson with axes.extent is {}x{}; image.zoom enlarges it",
                                  width, height));
    const Fields image(tables.image, "image", lesson_image_keys, diagnosis);
    const auto check = [&](std::string_view key, int right) {
        if (image.has(key) && image.whole(key, right, 1, pipeline::max_picture_size) != right)
            image.refuse(key, fmt::format("{}, the pixels of axes.extent, or no {} at all", right, key));
    };
    if (!size) check("width", width), check("height", height);
    out.width = width, out.height = height;
}

void read_axes(const LessonTables& tables, std::optional<std::pair<int, int>> size, LoadedScene& out,
               Diagnosis& diagnosis) {
    if (!tables.axes) return;
    const Fields fields(*tables.axes, "axes", axes_keys, diagnosis);
    constexpr std::string_view up_down[] = {"up", "down"};
    const std::string y = fields.text("y", "down");
    if (y != up_down[0] && y != up_down[1]) fields.refuse("y", joined(up_down));
    out.axes.y_up = y == up_down[0];
    const Value* extent = fields.find("extent");
    if (!extent) {  // pixel (0, 0) is the origin's, at the lower left when y goes up
        out.axes.top = out.axes.y_up ? out.height - 1 : 0;
        return;
    }
    constexpr double far = 1'000'000;
    const Range range{-far, far, false, false, "a whole number from -1000000 to 1000000"};
    const Range ranges[] = {range, range, range, range};
    const std::vector<double> n = fields.numbers(*extent, "extent", ranges);
    if (!diagnosis.fine()) return;
    for (std::size_t i = 0; i < n.size(); ++i)
        if (n[i] != std::floor(n[i]))
            return fields.refuse(std::get<std::vector<Value>>(extent->data)[i], fmt::format("extent[{}]", i),
                                 range.accepted);
    if (n[0] > n[2] || n[1] > n[3])
        return diagnosis.say(extent->place,
                             fmt::format("axes.extent goes from ({}, {}) to ({}, {}), accepted: [x0, y0, x1, "
                                         "y1] with x0 <= x1 and y0 <= y1",
                                         n[0], n[1], n[2], n[3]));
    const double width = n[2] - n[0] + 1, height = n[3] - n[1] + 1;
    if (width > pipeline::max_picture_size || height > pipeline::max_picture_size)
        return diagnosis.say(extent->place,
                             fmt::format("axes.extent has {}x{} pixels, accepted: at most {} a "
                                         "side",
                                         width, height, pipeline::max_picture_size));
    out.axes.left = static_cast<int>(n[0]);
    out.axes.top = static_cast<int>(out.axes.y_up ? n[3] : n[1]);
    take_size_of_extent(tables, size, static_cast<int>(width), static_cast<int>(height), out, diagnosis);
}

void read_zoom(const LessonTables& tables, LoadedScene& out, Diagnosis& diagnosis) {
    const Fields fields(tables.image, "image", lesson_image_keys, diagnosis);
    out.zoom = fields.whole("zoom", 1, 1, largest_zoom);
    const int largest = std::max(out.width, out.height) * out.zoom;
    if (largest > pipeline::max_picture_size)
        diagnosis.say(fields.place("zoom"),
                      fmt::format("image.zoom makes a picture of {}x{} pixels, accepted: at most {} a side",
                                  out.width * out.zoom, out.height * out.zoom, pipeline::max_picture_size));
}

// --------------------------------------------------------------------------------------------- [pipeline]
// What [pipeline] says for all shapes that take it and say nothing themselves.
struct Defaults {
    std::optional<ScanAlgorithm> algorithm;
    std::optional<Antialiasing> antialiasing;
    std::optional<int> samples;
    bool algorithm_used = false, antialiasing_used = false, samples_used = false;
};

template <class Meaning, std::size_t count>
std::optional<Meaning> given_choice(const Fields& fields, std::string_view key,
                                    const Choice<Meaning> (&choices)[count]) {
    if (!fields.has(key)) return std::nullopt;
    return fields.choice(key, choices[0].meaning, choices);
}

Defaults read_defaults(const Fields& pipeline) {
    Defaults out;
    out.algorithm = given_choice(pipeline, "algorithm", scan_algorithms);
    out.antialiasing = given_choice(pipeline, "antialiasing", antialiasings);
    if (pipeline.has("samples")) out.samples = pipeline.whole("samples", 4, 1, most_samples);
    return out;
}

// A key without effect would be a puzzle.
void refuse_unused(const Fields& pipeline, const Defaults& defaults) {
    const auto refuse = [&](std::string_view key) {
        pipeline.diagnosis().say(pipeline.place(key),
                                 fmt::format("{} is {}, which no shape of this scene takes (a shape's own "
                                             "keys come first)",
                                             pipeline.full(key), describe(*pipeline.find(key))));
    };
    if (defaults.algorithm && !defaults.algorithm_used) refuse("algorithm");
    if (defaults.antialiasing && !defaults.antialiasing_used) refuse("antialiasing");
    if (defaults.samples && !defaults.samples_used) refuse("samples");
}

// "clip.order is a list of 1, accepted: ..."
void refuse_list(const Fields& fields, std::string_view key, std::string_view accepted) {
    const Value* value = fields.find(key);
    const auto* list = value ? std::get_if<std::vector<Value>>(&value->data) : nullptr;
    if (!list) return fields.refuse(key, accepted);
    fields.diagnosis().say(value->place, fmt::format("{} is a list of {}, accepted: {}", fields.full(key),
                                                     list->size(), accepted));
}

// Greiner and Hormann walk along outlines, and lose their way where one meets itself.
void check_walkable(const Fields& fields, std::string_view key, std::span<const Point> ring,
                    std::string_view way_out) {
    if (!fields.diagnosis().fine()) return;
    const auto refuse = [&](const std::string& what) {
        fields.diagnosis().say(fields.place(key), fmt::format("{} {}", fields.full(key), what));
    };
    if (ring.size() > most_walked)
        return refuse(
            fmt::format("is a list of {}, accepted: at most {} corners with polygons = "
                        "\"greiner-hormann\"; {}",
                        ring.size(), most_walked, way_out));
    if (const auto crossing = pipeline::crossing_of(ring))
        refuse(
            fmt::format("crosses or touches itself: the edge from {0}[{1}] meets the edge from "
                        "{0}[{2}], accepted with polygons = \"greiner-hormann\": an outline that does "
                        "not; {3}",
                        key, crossing->first, crossing->second, way_out));
}

// -------------------------------------------------------------------------------------------- [[shape2d]]
class ShapeReader {
  public:
    ShapeReader(const Value& table, const Places& places, const raster::ShapeClip& clip, Defaults& defaults,
                Diagnosis& diagnosis)
        : fields_(table, "shape2d", shape_keys, diagnosis),
          places_(places),
          clip_(clip),
          defaults_(defaults),
          diagnosis_(diagnosis) {}

    Shape read() {
        if (!fields_.has("type")) return fields_.refuse("type", names_of_kinds()), shape_;
        shape_.kind = fields_.choice("type", shape_.kind, shape_kinds);
        type_ = fmt::format("type = \"{}\"", name_of(shape_.kind, shape_kinds));
        if (!diagnosis_.fine()) return shape_;
        if (is_curve(shape_.kind))
            shape_.filled = fields_.flag("filled", false);
        else
            refuse_key("filled", "is for circles and ellipses; a polyline draws the outline of an area");
        read_algorithm();
        read_antialiasing();
        if (diagnosis_.fine()) read_line_keys();
        if (diagnosis_.fine()) is_curve(shape_.kind) ? read_curve() : read_points();
        if (shape_.kind != ShapeKind::Polygon) refuse_key("inside", "is for polygons");
        shape_.inside = fields_.choice("inside", shape_.inside, inside_rules);
        shape_.color = fields_.color("color", shape_.color, zero_to_one);
        shape_.opacity = static_cast<float>(fields_.number("opacity", 1, zero_to_one));
        return shape_;
    }

  private:
    static std::string names_of_kinds() {
        std::vector<std::string_view> words;
        for (const auto& kind : shape_kinds) words.push_back(kind.name);
        return joined(words);
    }

    // "shape2d.filled is for circles and ellipses ..."
    void refuse_key(std::string_view key, std::string_view reason) {
        if (fields_.has(key))
            diagnosis_.say(fields_.place(key), fmt::format("{} {}", fields_.full(key), reason));
    }

    void read_algorithm() {
        const std::vector<ScanAlgorithm> own = algorithms_of(shape_.kind);
        shape_.algorithm = own.front();
        if (shape_.filled) return refuse_key("algorithm", "is for outlines; filled = true has only one");
        if (const auto given = given_choice(fields_, "algorithm", scan_algorithms)) {
            shape_.algorithm = *given;
            if (diagnosis_.fine() && !holds(own, *given))
                fields_.refuse("algorithm", fmt::format("{} for {}", names(own, scan_algorithms), type_));
        } else if (defaults_.algorithm && holds(own, *defaults_.algorithm)) {
            shape_.algorithm = *defaults_.algorithm;
            defaults_.algorithm_used = true;
        }
    }

    void read_antialiasing() {
        const std::vector<Antialiasing> own = antialiasings_of(shape_.kind);
        const bool own_algorithm = fields_.has("algorithm");
        if (own_algorithm && smooths_itself(shape_.algorithm))
            return refuse_key("antialiasing", "has no place here: this algorithm smooths the line itself");
        if (const auto given = given_choice(fields_, "antialiasing", antialiasings)) {
            shape_.antialiasing = *given;
            if (diagnosis_.fine() && !holds(own, *given))
                fields_.refuse("antialiasing", fmt::format("{} for {}", names(own, antialiasings), type_));
            else if (own_algorithm && *given != Antialiasing::None)
                diagnosis_.say(
                    fields_.place("algorithm"),
                    "shape2d.algorithm is for antialiasing = \"none\": a smooth shape has no pixels "
                    "to choose");
        } else if (defaults_.antialiasing && holds(own, *defaults_.antialiasing)) {
            shape_.antialiasing = *defaults_.antialiasing;
            defaults_.antialiasing_used = true;
        }
        if (shape_.antialiasing != Antialiasing::None) shape_.algorithm = algorithms_of(shape_.kind).front();
        if (!counts_samples(shape_.antialiasing))
            return refuse_key("samples", "is for antialiasing = \"supersample\" or \"multisample\"");
        if (defaults_.samples) defaults_.samples_used = defaults_.samples_used || !fields_.has("samples");
        shape_.samples = fields_.whole("samples", defaults_.samples.value_or(4), 1, most_samples);
    }

    // width and even_weight.
    void read_line_keys() {
        const bool smooth = shape_.antialiasing != Antialiasing::None;
        const bool outline = is_line(shape_.kind) || (is_curve(shape_.kind) && !shape_.filled);
        if (!outline)
            refuse_key("width", "is for lines and outlines");
        else if (is_curve(shape_.kind) && !smooth)
            refuse_key("width",
                       "is for antialiasing = \"area\": the outline of whole pixels is one pixel thin");
        else if (shape_.algorithm == ScanAlgorithm::Wu)
            refuse_key("width", "has no place here: the lines of Wu are one pixel wide");
        shape_.width = static_cast<float>(fields_.number(
            "width", 1, {half_the_least_float, 1024, true, false, "more than 0, at most 1024 pixels"}));
        if (!is_line(shape_.kind) || smooth || smooths_itself(shape_.algorithm))
            refuse_key("even_weight", "is for lines that are not smoothed");
        shape_.even_weight = fields_.flag("even_weight", false);
        if (shape_.even_weight && shape_.width != 1)
            refuse_key("even_weight", "is for lines of width 1: wider ones are areas and need no help");
    }

    // Who works in whole pixels and so takes whole numbers only, in words; empty when nobody does.
    std::string whole_pixel_algorithm() const {
        if (shape_.antialiasing != Antialiasing::None) return "";
        if (shape_.filled) return "the filled form";
        if (smooths_itself(shape_.algorithm)) return "";
        if (!is_curve(shape_.kind) && !(is_line(shape_.kind) && lights_pixels())) return "";
        return fmt::format("algorithm = \"{}\"", name_of(shape_.algorithm, scan_algorithms));
    }

    // Of a line: it chooses or weights single pixels, and is no area.
    bool lights_pixels() const {
        return smooths_itself(shape_.algorithm) ||
               (shape_.antialiasing == Antialiasing::None && shape_.width == 1);
    }

    void check_whole(const Value& value, const std::string& key, glm::dvec2 numbers) {
        const std::string who = whole_pixel_algorithm();
        if (who.empty() || !diagnosis_.fine()) return;
        if (numbers.x == std::floor(numbers.x) && numbers.y == std::floor(numbers.y)) return;
        const bool both = std::holds_alternative<std::vector<Value>>(value.data);
        const std::string found = both ? fmt::format("[{}, {}]", numbers.x, numbers.y) : describe(numbers.x);
        diagnosis_.say(value.place, fmt::format("{} is {}, accepted: whole numbers, since {} works in whole "
                                                "pixels (antialiasing = \"area\" takes any number)",
                                                fields_.full(key), found, who));
    }

    Point place(const Value& value, const std::string& key) {
        const Point at = places_.point(fields_, value, key);
        const LessonAxes& axes = places_.axes();
        check_whole(value, key, {axes.x_of(at.x), axes.y_of(at.y)});
        check_reach(value, key, at);
        return at;
    }

    // A wide line is an area, whose corners must stay in reach, too.
    void check_reach(const Value& value, const std::string& key, const Point& at) {
        const float half = is_line(shape_.kind) && !lights_pixels() ? shape_.width / 2 : 0;
        if (std::max(std::abs(at.x), std::abs(at.y)) + half > largest_place)
            diagnosis_.say(value.place,
                           fmt::format("{}: this line is {} wide, so its corners lie more than {} "
                                       "pixels from the picture's first one",
                                       fields_.full(key), shape_.width, largest_place));
    }

    void read_points() {
        refuse_key("center", "is for circles and ellipses");
        refuse_key("radius", "is for circles and ellipses");
        const auto [least, most, words] = counts();
        const Value* value = fields_.find("points");
        const auto* list = value ? std::get_if<std::vector<Value>>(&value->data) : nullptr;
        if (!list || list->size() < least || list->size() > most)
            return refuse_list(fields_, "points", words);
        shape_.points.reserve(list->size());
        for (std::size_t i = 0; i < list->size() && diagnosis_.fine(); ++i)
            shape_.points.push_back(place((*list)[i], fmt::format("points[{}]", i)));
        if (shape_.kind == ShapeKind::Polygon && walks(clip_))
            check_walkable(fields_, "points", shape_.points,
                           "\"sutherland-hodgman\" and \"pipeline\" take any outline in a convex window");
    }

    struct Counts {
        std::size_t least, most;
        std::string words;
    };
    Counts counts() const {
        switch (shape_.kind) {
            case ShapeKind::Line:
                return {2, 2, "[[x0, y0], [x1, y1]], the two ends of the line"};
            case ShapeKind::Rectangle:
                return {2, 2, "[[x0, y0], [x1, y1]], two opposite corners"};
            case ShapeKind::Triangle:
                return {3, 3, "three corners, as in [[0, 0], [8, 0], [0, 6]]"};
            case ShapeKind::Polyline:
                return {2, most_points, fmt::format("2 to {} points [x, y]", most_points)};
            default:
                return {3, most_points, fmt::format("3 to {} corners [x, y]", most_points)};
        }
    }

    void read_curve() {
        refuse_key("points", "has no place here: circles and ellipses have center and radius");
        const Value* center = fields_.find("center");
        if (!center) return fields_.refuse("center", "[x, y]");
        shape_.points = {place(*center, "center")};
        const Value* radius = fields_.find("radius");
        const bool circle = shape_.kind == ShapeKind::Circle;
        const std::string range = fmt::format("0 to {}", largest_place);
        const std::string words =
            circle ? "a number from " + range : "[a, b], the radii across and down, each from " + range;
        if (!radius) return fields_.refuse("radius", words);
        const Range accepted{0, double(largest_place), false, false, range};
        const Range ranges[] = {accepted, accepted};
        if (circle == std::holds_alternative<std::vector<Value>>(radius->data))
            return fields_.refuse("radius", words);
        const double across = circle ? fields_.number("radius", 0, accepted) : 0;
        const std::vector<double> both =
            circle ? std::vector{across, across} : fields_.numbers(*radius, "radius", ranges);
        check_whole(*radius, "radius", {both[0], both[1]});
        shape_.radius_x = static_cast<float>(both[0]), shape_.radius_y = static_cast<float>(both[1]);
    }

    Fields fields_;
    const Places& places_;
    const raster::ShapeClip& clip_;
    Defaults& defaults_;
    Diagnosis& diagnosis_;
    Shape shape_;
    std::string type_;
};

// ------------------------------------------------------------------------------------------------- [clip]
void read_window(const Fields& fields, const Places& places, raster::ShapeClip& clip) {
    const std::vector<double> n = places.box(fields, "window");
    if (!fields.diagnosis().fine()) return;
    if (n[0] > n[2] || n[1] > n[3])
        return fields.diagnosis().say(
            fields.place("window"), fmt::format("clip.window is [{}, {}, {}, {}], accepted: [x0, y0, x1, y1] "
                                                "with x0 <= x1 and y0 <= y1",
                                                n[0], n[1], n[2], n[3]));
    const LessonAxes& axes = places.axes();
    const auto [top, bottom] = std::minmax({axes.pixel_y(n[1]), axes.pixel_y(n[3])});
    clip.low = {static_cast<float>(axes.pixel_x(n[0])), static_cast<float>(top)};
    clip.high = {static_cast<float>(axes.pixel_x(n[2])), static_cast<float>(bottom)};
}

void read_polygon(const Fields& fields, const Places& places, raster::ShapeClip& clip) {
    constexpr std::string_view words = "at least three corners [x, y] that do not lie on one line";
    const auto* list = std::get_if<std::vector<Value>>(&fields.find("polygon")->data);
    if (!list || list->size() < 3) return refuse_list(fields, "polygon", words);
    for (std::size_t i = 0; i < list->size() && fields.diagnosis().fine(); ++i)
        clip.polygon.push_back(places.point(fields, (*list)[i], fmt::format("polygon[{}]", i)));
    if (!fields.diagnosis().fine()) return;
    const auto window = pipeline::convex_window(clip.polygon);
    const bool convex = bool(window);
    if (!convex && window.error() == pipeline::Refusal::NoArea)
        return fields.diagnosis().say(
            fields.place("polygon"),
            fmt::format("clip.polygon has all corners on one line, accepted: {}", words));
    if (walks(clip))
        check_walkable(fields, "polygon", clip.polygon, "the other clippers take convex windows only");
    else if (!convex)
        fields.diagnosis().say(fields.place("polygon"),
                               fmt::format("clip.polygon is not convex, which polygons = \"{}\" cannot do; "
                                           "accepted: a convex one, or polygons = \"greiner-hormann\"",
                                           name_of(clip.polygons, polygon_clippers)));
    if (fields.has("lines") && clip.lines != raster::LineClipper::CyrusBeck)
        fields.refuse("lines", "\"cyrus-beck\": the others know upright windows only");
    if (!convex && fields.has("lines"))
        fields.diagnosis().say(
            fields.place("lines"),
            "clip.lines has no place here: no line clipper takes a window that is not convex");
    clip.lines = raster::LineClipper::CyrusBeck;
}

void read_order(const Fields& fields, raster::ShapeClip& clip) {
    const Value* value = fields.find("order");
    if (!value) return;
    constexpr std::string_view words =
        "top, bottom, right and left, each once, as in "
        "[\"top\", \"bottom\", \"right\", \"left\"]";
    const auto* list = std::get_if<std::vector<Value>>(&value->data);
    if (!list || list->size() != std::size(clip.order)) return refuse_list(fields, "order", words);
    for (std::size_t i = 0; i < list->size(); ++i) {
        const auto* text = std::get_if<std::string>(&(*list)[i].data);
        const auto* side = std::find_if(std::begin(sides), std::end(sides),
                                        [&](const auto& s) { return text && s.name == *text; });
        if (side == std::end(sides)) return fields.refuse((*list)[i], fmt::format("order[{}]", i), words);
        clip.order[i] = side->meaning;
        if (std::find(clip.order, clip.order + i, side->meaning) != clip.order + i)
            return fields.refuse((*list)[i], fmt::format("order[{}]", i), words);
    }
}

raster::ShapeClip read_clip(const std::optional<Value>& table, const Places& places, Diagnosis& diagnosis) {
    raster::ShapeClip clip;
    if (!table) return clip;
    const Fields fields(*table, "clip", clip_keys, diagnosis);
    const auto say = [&](std::string_view key, std::string_view why) {
        if (fields.has(key)) diagnosis.say(fields.place(key), fmt::format("{} {}", fields.full(key), why));
    };
    clip.on = true;
    clip.lines = fields.choice("lines", clip.lines, line_clippers);
    clip.polygons = fields.choice("polygons", clip.polygons, polygon_clippers);
    clip.split = fields.flag("split", false);
    read_order(fields, clip);
    if (fields.has("window") == fields.has("polygon"))
        diagnosis.say(table->place, fmt::format("clip has {}, accepted: either window or polygon",
                                                fields.has("window") ? "both window and polygon"
                                                                     : "neither window nor polygon"));
    if (walks(clip)) say("split", "has no place here: greiner-hormann makes no bridges to be cut");
    if (fields.has("polygon"))
        say("order", "is for a window: the sides of a polygon come in their own order");
    if (!diagnosis.fine()) return clip;
    fields.has("window") ? read_window(fields, places, clip) : read_polygon(fields, places, clip);
    return clip;
}

}  // namespace

void read_lesson(const LessonTables& tables, std::optional<std::pair<int, int>> size, LoadedScene& out,
                 Diagnosis& diagnosis) {
    read_axes(tables, size, out, diagnosis);
    read_zoom(tables, out, diagnosis);
    if (!diagnosis.fine()) return;
    const Places places(out.axes);
    const Fields pipeline(tables.pipeline, "pipeline", lesson_pipeline_keys, diagnosis);
    out.shapes.fill_rule = pipeline.choice("fill_rule", out.shapes.fill_rule, fill_rules);
    out.shapes.background = out.scene.background;
    Defaults defaults = read_defaults(pipeline);
    out.shapes.clip = read_clip(tables.clip, places, diagnosis);
    for (const Value& shape : tables.shapes)
        if (diagnosis.fine())
            out.shapes.shapes.push_back(
                ShapeReader(shape, places, out.shapes.clip, defaults, diagnosis).read());
    if (diagnosis.fine()) refuse_unused(pipeline, defaults);
}

raster::Image<raster::Rgba8> enlarged(const raster::Image<raster::Rgba8>& picture, int zoom) {
    raster::Image<raster::Rgba8> out(picture.width() * zoom, picture.height() * zoom);
    for (int y = 0; y < out.height(); ++y)
        for (int x = 0; x < out.width(); ++x) out.row(y)[x] = picture.row(y / zoom)[x / zoom];
    return out;
}

}  // namespace relevo::scene
