#include "samples/show/view.hpp"

#include <array>
#include <cmath>
#include <tuple>

#include "raster/draw.hpp"
#include "samples/show/numbers.hpp"
#include "samples/show/sheet.hpp"

namespace relevo::show {
namespace {

double dot(glm::dvec3 a, glm::dvec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
glm::dvec3 cross(glm::dvec3 a, glm::dvec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
glm::dvec3 unit(glm::dvec3 a) { return a / std::sqrt(dot(a, a)); }
bool finite(glm::dvec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }
auto key(glm::dvec3 p) { return std::tuple(p.x, p.y, p.z); }

constexpr AxisNames axis_names{"x", "y", "z"};
constexpr std::array<Rgba8, 3> axis_colors{vermilion, green, blue};

}  // namespace

Spot View::spot(glm::dvec3 p) const {
    const glm::dvec3 d = p - center;
    return {middle.x + scale * dot(d, right), middle.y - scale * dot(d, up)};
}
double View::depth(glm::dvec3 p) const { return dot(p - center, toward); }

namespace {

View view_from(glm::dvec3 toward) {
    toward = unit(toward);
    const glm::dvec3 right = unit(cross({0, 1, 0}, toward));
    return {right, cross(toward, right), toward, {0, 0, 0}, {}, 1};
}

}  // namespace

View oblique_view() { return view_from({0.50, 0.42, 0.80}); }

View view_across(glm::dvec3 direction) {
    constexpr std::array<glm::dvec3, 4> places{
        {{0.50, 0.60, 0.80}, {-0.50, 0.60, 0.80}, {0.85, 0.60, 0.35}, {-0.85, 0.60, 0.35}}};
    // Neither along the direction nor quite across it, where what faces it would be seen edge-on.
    const auto off = [&](glm::dvec3 place) {
        return std::abs(std::abs(dot(unit(place), unit(direction))) - 0.4);
    };
    return view_from(
        *std::min_element(places.begin(), places.end(), [&](auto& a, auto& b) { return off(a) < off(b); }));
}
View side_view() { return {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {}, 1}; }
View top_view() { return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {0, 0, 0}, {}, 1}; }
View front_view() { return {}; }

void Box::add(glm::dvec3 p) {
    if (!finite(p)) return;
    for (int k = 0; k < 3; ++k) {
        low[k] = empty ? p[k] : std::min(low[k], p[k]);
        high[k] = empty ? p[k] : std::max(high[k], p[k]);
    }
    empty = false;
}
void Box::add(const Box& box) {
    if (!box.empty) add(box.low), add(box.high);
}
double Box::longest() const { return std::max({size().x, size().y, size().z}); }
glm::dvec3 Box::corner(int number) const {
    return {number & 1 ? high.x : low.x, number & 2 ? high.y : low.y, number & 4 ? high.z : low.z};
}

View fitted(View view, const Box& box, Rect area, int margin) {
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i) corners[std::size_t(i)] = box.corner(i);
    return fitted(view, corners, area, margin);
}

View fitted(View view, std::span<const glm::dvec3> points, Rect area, int margin) {
    Box all, flat;
    for (const glm::dvec3 p : points) all.add(p);
    view.center = all.low + 0.5 * all.size();
    for (const glm::dvec3 p : points)
        flat.add({dot(p - view.center, view.right), dot(p - view.center, view.up), 0});
    const double width = std::max(flat.size().x, 1e-30), height = std::max(flat.size().y, 1e-30);
    view.scale = std::min(std::max(area.width - 2 * margin, 1) / width,
                          std::max(area.height - 2 * margin, 1) / height);
    if (!std::isfinite(view.scale) || view.scale > 1e12) view.scale = 1;
    view.middle = {area.x + area.width / 2.0 - view.scale * (flat.low.x + flat.high.x) / 2,
                   area.y + area.height / 2.0 + view.scale * (flat.low.y + flat.high.y) / 2};
    return view;
}

std::vector<Segment> unique_segments(std::vector<Segment> segments) {
    std::erase_if(segments, [](const Segment& s) { return !finite(s.a) || !finite(s.b); });
    for (Segment& s : segments)
        if (key(s.b) < key(s.a)) std::swap(s.a, s.b);
    const auto both = [](const Segment& s) { return std::pair(key(s.a), key(s.b)); };
    std::sort(segments.begin(), segments.end(), [&](auto& s, auto& t) { return both(s) < both(t); });
    const auto end =
        std::unique(segments.begin(), segments.end(), [&](auto& s, auto& t) { return both(s) == both(t); });
    segments.erase(end, segments.end());
    return segments;
}

std::vector<Segment> mesh_edges(const pipeline::Mesh& mesh, std::span<const glm::dvec3> positions) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(mesh.indices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        edges.push_back(std::minmax({mesh.indices[i], mesh.indices[i % 3 == 2 ? i - 2 : i + 1]}));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<Segment> segments;
    for (const auto& [a, b] : edges)
        if (finite(positions[a]) && finite(positions[b])) segments.push_back({positions[a], positions[b]});
    return segments;
}

// The lines of a wire would fill `ink` of the area that they span. Up to a seventh they are drawn in full;
// then they become thinner, and from one half on translucent.
Stroke wire_stroke(const View& view, std::span<const Segment> wire, Rect area, Rgba8 color, double dense) {
    constexpr double widest = 1.75, thinnest = 0.5, sparse = 0.15;
    double length = 0;
    Box box;
    for (const Segment& s : wire) {
        const Spot a = view.spot(s.a), b = view.spot(s.b);
        double t0 = 0, t1 = 1;
        if (!clip_segment(area, 0, a, b, t0, t1)) continue;
        length += (t1 - t0) * std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
        for (const double t : {t0, t1}) box.add({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0});
    }
    if (!(length > 0)) return {color, widest};
    const double layers = length / (std::max(box.size().x, 4.0) * std::max(box.size().y, 4.0));
    const double width = std::clamp(sparse / layers, thinnest, widest), ink_of_wire = width * layers;
    const double opacity = std::clamp(dense / ink_of_wire, 0.04, 1.0);
    return {with_opacity(color, static_cast<std::uint8_t>(255 * opacity + 0.5)), width};
}

void draw_wire(Canvas canvas, const View& view, std::span<const Segment> wire, Stroke stroke) {
    for (const Segment& s : wire) line(canvas, view.spot(s.a), view.spot(s.b), stroke);
}

// ---- solids ----

Solid draw_solid(const View& view, Rect area, std::span<const raster::Model> models) {
    Solid solid{Picture(area.width, area.height, paper),
                raster::Image<raster::Scalar>(area.width, area.height), area};
    Box depths;
    for (const raster::Model& model : models)
        for (const pipeline::Vertex& v : model.mesh->vertices) {
            const glm::dvec4 p = model.world_from_object.m * glm::dvec4(glm::dvec3(v.position.v), 1);
            depths.add({view.depth(glm::dvec3(p)), 0, 0});
        }
    const double span = std::max(depths.size().x, 1e-12);
    solid.low = depths.low.x - span / 8, solid.high = depths.high.x + span / 8;

    raster::Scene scene;
    scene.models.assign(models.begin(), models.end());
    scene.background = {1, 1, 1};
    scene.camera.parallel = true;
    glm::dmat4 eye(1.0), clip(0.0);
    for (int c = 0; c < 3; ++c) eye[c][0] = view.right[c], eye[c][1] = view.up[c], eye[c][2] = view.toward[c];
    for (int r = 0; r < 3; ++r) {
        const glm::dvec3 axis = r == 0 ? view.right : r == 1 ? view.up : view.toward;
        eye[3][r] = -dot(axis, view.center);
    }
    clip[0][0] = 2 * view.scale / area.width, clip[3][0] = 2 * (view.middle.x - area.x) / area.width - 1;
    clip[1][1] = 2 * view.scale / area.height, clip[3][1] = 1 - 2 * (view.middle.y - area.y) / area.height;
    clip[2][2] = 1 / (solid.high - solid.low), clip[3][2] = -solid.low / (solid.high - solid.low),
    clip[3][3] = 1;
    scene.camera.eye_from_world.m = eye;
    scene.camera.clip_from_eye.m = clip;
    pipeline::Light light{pipeline::Light::Kind::Directional, {}, {}, {1, 1, 1}};
    light.direction.v = pipeline::Vec3(-(view.toward + 0.5 * view.up - 0.45 * view.right));
    scene.lights = {light};
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        const Rgba8 tint = mixed(paper, accent(i), 70);
        const auto part = [](std::uint8_t c) { return raster::Scalar(c) / 255; };
        scene.models[i].material = {
            raster::Scalar(0.62), raster::Scalar(0.40), 0, 1, {part(tint.r), part(tint.g), part(tint.b)}};
        scene.models[i].texture = nullptr;
        scene.models[i].two_sided = true;
    }
    raster::Settings settings;
    settings.shading = raster::Shading::Flat;
    settings.cull = pipeline::Cull::None;
    settings.output = raster::Output::Raw;
    raster::Frame frame{std::move(solid.color), std::move(solid.depth), {}};
    raster::draw(scene, settings, frame);
    solid.color = std::move(frame.color), solid.depth = std::move(frame.depth);
    return solid;
}

void paste_solid(Canvas canvas, const Solid& solid) {
    const Rect part = common(canvas.clip, solid.area);
    for (int y = part.y; y < part.bottom(); ++y)
        for (int x = part.x; x < part.right(); ++x)
            if (solid.depth.at(x - solid.area.x, y - solid.area.y) > 0)
                canvas.picture->at(x, y) = solid.color.at(x - solid.area.x, y - solid.area.y);
}

namespace {

// A line counts as visible where it is not behind the farthest surface within one pixel: edges lie on
// surfaces.
bool hides(const Solid& solid, int x, int y, double depth) {
    for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i) {
            const double there = solid.depth.holds(i, j) ? static_cast<double>(solid.depth.at(i, j)) : 0;
            if (there == 0 || depth >= there - 2e-3) return false;
        }
    return true;
}

}  // namespace

void draw_wire(Canvas canvas, const View& view, const Solid& solid, std::span<const Segment> wire,
               Stroke visible, Stroke hidden) {
    const auto draw_line = [&](const Segment& s, const Stroke& stroke, bool want_hidden) {
        const double near_a = (view.depth(s.a) - solid.low) / (solid.high - solid.low);
        const double near_b = (view.depth(s.b) - solid.low) / (solid.high - solid.low);
        trace_line(canvas.clip, view.spot(s.a), view.spot(s.b), stroke.width,
                   [&](int x, int y, double coverage, double t) {
                       if (hides(solid, x - solid.area.x, y - solid.area.y, near_a + t * (near_b - near_a)) !=
                           want_hidden)
                           return;
                       blend(*canvas.picture, x, y, stroke.color, static_cast<int>(coverage * 255 + 0.5));
                   });
    };
    for (const Segment& s : wire) draw_line(s, hidden, true);
    for (const Segment& s : wire) draw_line(s, visible, false);
}

// ---- axes ----
namespace {

bool is_origin(double value, double step) { return std::abs(value) < step / 2; }

std::string tick_text(double value, double step) { return is_origin(value, step) ? "0" : number(value); }

// The ticks of [low, high] at multiples of a nice step of at least `step`.
template <class Visit>
void for_each_tick(double low, double high, double step, Visit&& visit) {
    if (!(step > 0) || !((high - low) / step < 200)) return;
    for (double n = std::ceil(low / step - 1e-9); n * step <= high + 1e-9 * step; ++n) visit(n * step);
}

}  // namespace

void draw_axes(Canvas canvas, const View& view, const Box& box, double at_least) {
    if (box.empty) return;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 3; ++k)
            if (!(i >> k & 1))
                line(canvas, view.spot(box.corner(i)), view.spot(box.corner(i | 1 << k)),
                     {with_opacity(haze, 150), 1});
    const Spot middle = view.spot(box.low + 0.5 * box.size());
    // x along the lower front edge, y along the left front edge, z along the lower right edge.
    const int front = view.toward.z < 0 ? 0 : 4;
    const std::array<int, 3> starts{front, front, 1};
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 start = box.corner(starts[std::size_t(k)] & ~(1 << k)),
                         end = box.corner(starts[std::size_t(k)] | 1 << k);
        const Spot a = view.spot(start), b = view.spot(end);
        const Rgba8 color = axis_colors[std::size_t(k)];
        line(canvas, a, b, {color, 2});
        const double pixels = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
        const double step = nice_step(at_least * box.size()[k] / std::max(pixels, 1.0));
        const double ox = (a.x + b.x) / 2 - middle.x, oy = (a.y + b.y) / 2 - middle.y;
        const double away = std::max(std::sqrt(ox * ox + oy * oy), 1e-9), ux = ox / away, uy = oy / away;
        const auto beside = [&](Spot s, double distance) {
            return Spot{s.x + distance * ux, s.y + distance * uy};
        };
        const Align align = k == 1 ? Align::Right : k == 2 ? Align::Left : Align::Middle;
        for_each_tick(box.low[k], box.high[k], step, [&](double value) {
            glm::dvec3 p = start;
            p[k] = value;
            const Spot at = view.spot(p);
            line(canvas, at, beside(at, 8), {color, 1.5});
            const Spot place = k == 0   ? Spot{at.x + 4 * ux, at.y + 24}
                               : k == 1 ? Spot{at.x - 14, at.y}
                                        : Spot{at.x + 14, at.y + 8};
            label(canvas, place, tick_text(value, step), color, align);
        });
        const Spot half{(a.x + b.x) / 2, (a.y + b.y) / 2};
        const Spot name = k == 0   ? Spot{half.x, half.y + 50}
                          : k == 1 ? Spot{half.x - 74, half.y}
                                   : Spot{half.x + 70, half.y + 26};
        label(canvas, name, axis_names[std::size_t(k)], color, align);
    }
}

void draw_flat_axes(Canvas canvas, const View& view, Rect area, int horizontal, int vertical,
                    const AxisNames& names) {
    if (!(view.scale > 0) || area.width < 40 || area.height < 40) return;
    const double step = nice_step(90 / view.scale);
    const Canvas inside = within(canvas, area);
    const double run = view.right[horizontal], rise = view.up[vertical];  // +1 or -1
    const double x0 = (area.x - view.middle.x) / view.scale, x1 = (area.right() - view.middle.x) / view.scale;
    const double y0 = (view.middle.y - area.bottom()) / view.scale,
                 y1 = (view.middle.y - area.y) / view.scale;
    const auto along = [](double center, double a, double b, double sign) {
        return std::pair(center + std::min(a * sign, b * sign), center + std::max(a * sign, b * sign));
    };
    const auto [low_x, high_x] = along(view.center[horizontal], x0, x1, run);
    const auto [low_y, high_y] = along(view.center[vertical], y0, y1, rise);
    const auto rule_of = [&](double value) {
        return is_origin(value, step) ? Stroke{haze, 2} : Stroke{rule, 1};
    };
    for_each_tick(low_x, high_x, step, [&](double value) {
        const double x = view.middle.x + view.scale * run * (value - view.center[horizontal]);
        line(inside, {x, double(area.y)}, {x, double(area.bottom())}, rule_of(value));
    });
    for_each_tick(low_y, high_y, step, [&](double value) {
        const double y = view.middle.y - view.scale * rise * (value - view.center[vertical]);
        line(inside, {double(area.x), y}, {double(area.right()), y}, rule_of(value));
    });
    const std::string right_name =
        (run < 0 ? "← " : "") + std::string(names[std::size_t(horizontal)]) + (run < 0 ? "" : " →");
    const std::string left_name = names[std::size_t(vertical)] + std::string(rise < 0 ? " ↓" : " ↑");
    for_each_tick(low_x, high_x, step, [&](double value) {
        const double x = view.middle.x + view.scale * run * (value - view.center[horizontal]);
        const int half = text_width(tick_text(value, step)) / 2 + 14;
        if (x - half > area.x + 8 + text_width(left_name) &&
            x + half < area.right() - 6 - text_width(right_name))
            label(inside, {x, area.bottom() - 14.0}, tick_text(value, step), muted, Align::Middle);
    });
    for_each_tick(low_y, high_y, step, [&](double value) {
        const double y = view.middle.y - view.scale * rise * (value - view.center[vertical]);
        if (y > area.y + 44 && y < area.bottom() - 44)
            label(inside, {area.x + 8.0, y}, tick_text(value, step), muted);
    });
    label(inside, {area.right() - 6.0, area.bottom() - 14.0}, right_name, ink, Align::Right);
    label(inside, {area.x + 8.0, area.bottom() - 14.0}, left_name, ink);
}

void draw_frame(Canvas canvas, const View& view, glm::dvec3 origin, double length) {
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 tip = origin;
        tip[k] += length;
        const Spot a = view.spot(origin), b = view.spot(tip);
        if (std::abs(a.x - b.x) + std::abs(a.y - b.y) < 4) continue;
        arrow(canvas, a, b, {axis_colors[std::size_t(k)], 2.5});
        label(canvas, {b.x + 6, b.y - 6}, axis_names[std::size_t(k)], axis_colors[std::size_t(k)]);
    }
}

}  // namespace relevo::show
