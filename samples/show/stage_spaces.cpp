// The pictures of object, world and eye space.
#include <glm/mat4x4.hpp>

#include "samples/show/numbers.hpp"
#include "samples/show/stage.hpp"

namespace relevo::show {
namespace {

using Kind = PanelRow::Kind;
constexpr std::size_t most_panels = 6;

Box box_of(std::span<const glm::dvec3> points) {
    Box box;
    for (const glm::dvec3 p : points) box.add(p);
    return box;
}

std::vector<Segment> world_wire(const Capture& capture, std::size_t m) {
    return mesh_edges(*capture.model(m).mesh, world_positions(capture.model(m)));
}

Stroke hidden_stroke(Stroke stroke) {
    return {with_opacity(haze, static_cast<std::uint8_t>(stroke.color.a * 2 / 5)),
            std::min(stroke.width, 1.0)};
}

// ---- object ----

std::vector<PanelBlock> object_panel(const Capture& capture) {
    const std::size_t models = capture.scene().models.size();
    std::vector<PanelBlock> panel;
    for (std::size_t m = 0; m < std::min(models, most_panels); ++m) {
        const pipeline::Mesh& mesh = *capture.model(m).mesh;
        const Box box = box_of(object_positions(capture.model(m)));
        PanelBlock block{model_name(*capture.loaded, m, panel_columns), {}};
        block.rows.push_back(pair(grouped(std::int64_t(mesh.vertices.size())) + " vertices",
                                  counted(std::int64_t(mesh.triangles()), "triangle")));
        if (models > 3) {
            block.rows.push_back(pair(
                "size", number(box.size().x) + " × " + number(box.size().y) + " × " + number(box.size().z)));
        } else {
            block.rows.push_back(pair("x", range(box.low.x, box.high.x)));
            block.rows.push_back(pair("y", range(box.low.y, box.high.y)));
            block.rows.push_back(pair("z", range(box.low.z, box.high.z)));
            const bool known = m < capture.loaded->descriptions.size();
            if (known && !capture.loaded->descriptions[m].had_normals)
                block.rows.push_back(quiet("normals: averaged from the faces"));
            if (known && !capture.loaded->descriptions[m].has_uv)
                block.rows.push_back(quiet("no texture coordinates"));
        }
        panel.push_back(std::move(block));
    }
    if (models > most_panels)
        panel.push_back({"", {quiet("and " + counted(std::int64_t(models - most_panels), "more model"))}});
    panel.push_back(
        {"Legend",
         {sample(Kind::Line, ink, "edge that can be seen"),
          sample(Kind::Line, haze, "edge behind the surface"), sample(Kind::Ring, ink, "origin"),
          quiet("Seen from the front, the right and above; front faces have counter-clockwise corners.")}});
    return panel;
}

void draw_model(Canvas canvas, Rect area, const Capture& capture, std::size_t m, bool large) {
    const std::vector<glm::dvec3> positions = object_positions(capture.model(m));
    const Box box = box_of(positions);
    if (box.empty || capture.model(m).mesh->triangles() == 0) return say(canvas, area, "no triangles");
    const View view = fitted(oblique_view(), box,
                             large ? Rect{area.x + 96, area.y + 60, area.width - 190, area.height - 150}
                                   : Rect{area.x + 96, area.y + 40, area.width - 180, area.height - 100},
                             0);
    raster::Model alone = capture.model(m);
    alone.world_from_object = {};
    const Solid solid = draw_solid(view, area, std::span(&alone, 1));
    paste_solid(canvas, solid);
    const std::vector<Segment> wire = mesh_edges(*alone.mesh, positions);
    const Stroke stroke = wire_stroke(view, wire, area, ink, 0.25);
    draw_wire(canvas, view, solid, wire, stroke, hidden_stroke(stroke));
    draw_axes(canvas, view, box, large ? 60 : 36);
    const Spot origin = view.spot({0, 0, 0});
    ring(canvas, origin, 5, {ink, 2});
    if (large) label(canvas, {origin.x + 12, origin.y}, "origin", ink);
}

}  // namespace

StagePage draw_object(const Capture& capture, const Heading& heading) {
    const std::size_t models = capture.scene().models.size(), shown = std::min(models, most_panels);
    Page page = diagram_page(heading, object_panel(capture));
    const Canvas canvas = canvas_of(page.picture);
    const int columns = shown <= 1 ? 1 : 2, rows = (static_cast<int>(shown) + columns - 1) / columns;
    for (std::size_t m = 0; m < shown; ++m) {
        const Rect area =
            cell(page.area, static_cast<int>(m) % columns, columns, static_cast<int>(m) / columns, rows, 0);
        frame(canvas, area, rule);
        draw_model(within(canvas, inset(area, 2)), inset(area, 2), capture, m, shown == 1);
        label(within(canvas, area), {area.x + 12.0, area.y + 20.0},
              model_name(*capture.loaded, m, area.width / 12 - 2), ink);
    }
    if (shown == 0) say(canvas, page.area, "no model in this scene");
    return {std::move(page.picture),
            {{"models", std::int64_t(models)},
             {"vertices", capture.vertices()},
             {"triangles", capture.triangles()}},
            {},
            1};
}

// ---- the camera ----
namespace {

// The eye-space point at distance `d` in front of the eye that the projection puts at x = sx w, y = sy w.
glm::dvec3 sight(const glm::dmat4& clip, double sx, double sy, double d) {
    const auto row = [&](int r, double s, int c) { return clip[c][r] - s * clip[c][3]; };
    const double a = row(0, sx, 0), b = row(0, sx, 1), e = -(row(0, sx, 2) * -d + row(0, sx, 3));
    const double c = row(1, sy, 0), f = row(1, sy, 1), g = -(row(1, sy, 2) * -d + row(1, sy, 3));
    const double determinant = a * f - b * c;
    return {(e * f - b * g) / determinant, (a * g - e * c) / determinant, -d};
}

std::vector<PanelRow> camera_rows(const scene::CameraDescription& camera) {
    using CameraKind = scene::CameraDescription::Kind;
    std::vector<PanelRow> rows;
    rows.push_back(pair("projection", camera.kind == CameraKind::Perspective    ? "perspective"
                                      : camera.kind == CameraKind::Orthographic ? "orthographic"
                                                                                : "frustum"));
    if (camera.kind == CameraKind::Perspective)
        rows.push_back(pair("angle of view", number(camera.fov_y) + "°"));
    if (camera.kind == CameraKind::Orthographic) rows.push_back(pair("height", number(camera.height)));
    rows.push_back(pair("near, far", number(camera.near) + ", " + number(camera.far)));
    return rows;
}

// The box of all models in eye space and how far its middle is in front of the eye.
Box eye_box(const Capture& capture) {
    Box box;
    for (std::size_t m = 0; m < capture.scene().models.size(); ++m)
        for (const SeenVertex& v : capture.vertices(m)) box.add(v.eye);
    return box;
}

double middle_distance(const Capture& capture, const Box& box) {
    const double near = capture.loaded->camera.near, middle = box.empty ? 1 : -(box.low.z + box.high.z) / 2;
    return std::max(middle, near + 0.1 * std::abs(near) + 1e-6);
}

struct CameraSymbol {
    glm::dvec3 eye;
    std::array<glm::dvec3, 4> near, body,
        sight;  // corners of the near plane, of the symbol, in the models' middle
};

CameraSymbol camera_symbol(const Capture& capture, double size) {
    const glm::dmat4 world_from_eye = glm::inverse(capture.scene().camera.eye_from_world.m);
    const glm::dmat4& clip = capture.scene().camera.clip_from_eye.m;
    const auto to_world = [&](glm::dvec3 p) { return glm::dvec3(world_from_eye * glm::dvec4(p, 1)); };
    const double distance = middle_distance(capture, eye_box(capture));
    CameraSymbol symbol{to_world({0, 0, 0}), {}, {}, {}};
    constexpr double corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        const double sx = corners[i][0], sy = corners[i][1];
        const glm::dvec3 far_corner = sight(clip, sx, sy, distance),
                         near_corner = sight(clip, sx, sy, capture.loaded->camera.near);
        symbol.near[i] = to_world(near_corner);
        symbol.sight[i] = to_world(far_corner);
        symbol.body[i] =
            capture.scene().camera.parallel ? symbol.near[i] : to_world(far_corner * (size / distance));
    }
    return symbol;
}

void draw_camera(Canvas canvas, const View& view, const CameraSymbol& symbol, bool parallel) {
    const auto rectangle = [&](const std::array<glm::dvec3, 4>& corners, Stroke stroke, Rgba8 inside) {
        std::array<Spot, 4> spots;
        for (std::size_t i = 0; i < 4; ++i) spots[i] = view.spot(corners[i]);
        polygon(canvas, spots, inside);
        path(canvas, spots, stroke, true);
    };
    rectangle(symbol.sight, {purple, 1.5, 6}, with_opacity(purple, 16));
    for (std::size_t i = 0; i < 4; ++i)
        line(canvas, view.spot(parallel ? symbol.near[i] : symbol.eye), view.spot(symbol.sight[i]),
             {with_opacity(purple, 140), 1});
    if (!parallel)
        for (const glm::dvec3 p : symbol.body) line(canvas, view.spot(symbol.eye), view.spot(p), {purple, 2});
    rectangle(symbol.body, {purple, 2}, with_opacity(purple, 60));
    rectangle(symbol.near, {ink, 1.5}, with_opacity(ink, 60));
    const Spot eye = view.spot(
        parallel ? 0.25 * (symbol.near[0] + symbol.near[1] + symbol.near[2] + symbol.near[3]) : symbol.eye);
    disc(canvas, eye, 5, purple);
    label(canvas, {eye.x, eye.y - 24}, "camera", purple, Align::Middle);
}

void draw_ground(Canvas canvas, const View& view, const Box& box, double y) {
    const double step = nice_step(std::max(box.size().x, box.size().z) / 12);
    const auto down = [&](double v) { return std::floor(v / step) * step; };
    const auto up = [&](double v) { return std::ceil(v / step) * step; };
    const double x0 = down(box.low.x), x1 = up(box.high.x), z0 = down(box.low.z), z1 = up(box.high.z);
    if (!((x1 - x0) / step < 100) || !((z1 - z0) / step < 100)) return;
    for (double x = x0; x <= x1 + step / 2; x += step)
        line(canvas, view.spot({x, y, z0}), view.spot({x, y, z1}), {rule, 1});
    for (double z = z0; z <= z1 + step / 2; z += step)
        line(canvas, view.spot({x0, y, z}), view.spot({x1, y, z}), {rule, 1});
}

void draw_light(Canvas canvas, Spot at, int number_of_light) {
    disc(canvas, at, 9, ink);
    disc(canvas, at, 7.5, yellow);
    for (const auto& [dx, dy] : {Spot{1, 0}, Spot{-1, 0}, Spot{0, 1}, Spot{0, -1}, Spot{0.7, 0.7},
                                 Spot{-0.7, 0.7}, Spot{0.7, -0.7}, Spot{-0.7, -0.7}})
        line(canvas, {at.x + 11 * dx, at.y + 11 * dy}, {at.x + 16 * dx, at.y + 16 * dy}, {ink, 1.5});
    const bool at_edge = at.x > canvas.clip.right() - 130;
    label(canvas, {at.x + (at_edge ? -22 : 22), at.y}, "light " + std::to_string(number_of_light), ink,
          at_edge ? Align::Right : Align::Left);
}

// ---- world ----

std::vector<PanelBlock> world_panel(const Capture& capture, const Box& box) {
    const scene::LoadedScene& loaded = *capture.loaded;
    PanelBlock models{"Models", {}}, camera{"Camera", {}}, lights{"Lights", {}};
    const std::size_t count = capture.scene().models.size();
    for (std::size_t m = 0; m < std::min(count, most_panels); ++m)
        models.rows.push_back(sample(Kind::Square, mixed(paper, accent(m), 140), model_name(loaded, m, 28),
                                     grouped(std::int64_t(capture.model(m).mesh->triangles()))));
    if (count > most_panels)
        models.rows.push_back(quiet("and " + counted(std::int64_t(count - most_panels), "more model")));
    if (!box.empty) {
        models.rows.push_back(pair("x", range(box.low.x, box.high.x)));
        models.rows.push_back(pair("y", range(box.low.y, box.high.y)));
        models.rows.push_back(pair("z", range(box.low.z, box.high.z)));
    }
    camera.rows.push_back(pair("eye", triple(loaded.camera.eye)));
    camera.rows.push_back(pair("target", triple(loaded.camera.target)));
    for (PanelRow& row : camera_rows(loaded.camera)) camera.rows.push_back(std::move(row));
    if (loaded.camera.framed) camera.rows.push_back(quiet("chosen so that all is seen"));
    camera.rows.push_back(sample(Kind::Dashes, purple, "what it sees amid the models"));
    for (std::size_t i = 0; i < std::min<std::size_t>(capture.scene().lights.size(), 3); ++i) {
        const pipeline::Light& light = capture.scene().lights[i];
        const bool point = light.kind == pipeline::Light::Kind::Point;
        lights.rows.push_back(
            pair(std::to_string(i + 1) + (point ? " at" : " towards"),
                 triple(point ? glm::dvec3(light.position.v) : glm::dvec3(light.direction.v))));
    }
    if (capture.scene().lights.size() > 3)
        lights.rows.push_back(quiet("and " + std::to_string(capture.scene().lights.size() - 3) + " more"));
    if (capture.scene().lights.empty()) lights.rows.push_back(quiet("none"));
    std::vector<PanelBlock> panel{models, camera, lights};
    if (count > 0)
        panel.push_back(
            matrix_block(shortened("World from object: " + model_name(loaded, 0, 40), panel_columns),
                         capture.model(0).world_from_object.m));
    return panel;
}

}  // namespace

StagePage draw_world(const Capture& capture, const Heading& heading) {
    const std::vector<raster::Model>& models = capture.scene().models;
    Box box;
    for (const raster::Model& model : models) box.add(box_of(world_positions(model)));
    Page page = diagram_page(heading, world_panel(capture, box));
    const Rect area = inset(page.area, 2);
    const Canvas canvas = within(canvas_of(page.picture), area);

    CameraSymbol symbol = camera_symbol(capture, 1);
    std::vector<glm::dvec3> points(symbol.sight.begin(), symbol.sight.end());
    points.push_back(symbol.eye);
    if (capture.scene().camera.parallel) points.insert(points.end(), symbol.near.begin(), symbol.near.end());
    for (const raster::Model& model : models) {
        const Box one = box_of(world_positions(model));
        for (int i = 0; i < 8; ++i) points.push_back(one.corner(i));
    }
    const Box all = box_of(points);
    symbol = camera_symbol(capture, 0.08 * all.longest());
    // Lights far outside stay out of the picture; the panel tells where they are.
    for (const pipeline::Light& light : capture.scene().lights) {
        const glm::dvec3 p(light.position.v), away = p - (all.low + 0.5 * all.size());
        const bool close =
            std::max({std::abs(away.x), std::abs(away.y), std::abs(away.z)}) < 1.5 * all.longest();
        if (light.kind == pipeline::Light::Kind::Point && close) points.push_back(p);
    }
    const glm::dmat4 world_from_eye = glm::inverse(capture.scene().camera.eye_from_world.m);
    const View view = fitted(view_across(glm::dvec3(world_from_eye[2])), points, area, 60);
    const double ground = box.empty ? 0 : box.low.y;
    draw_ground(canvas, view, all, ground);
    const Solid solid = draw_solid(view, area, models);
    paste_solid(canvas, solid);
    for (std::size_t m = 0; m < models.size(); ++m) {
        const std::vector<Segment> wire = world_wire(capture, m);
        const Stroke stroke = wire_stroke(view, wire, area, ink, 0.25);
        draw_wire(canvas, view, solid, wire, stroke, hidden_stroke(stroke));
    }
    draw_camera(canvas, view, symbol, capture.scene().camera.parallel);
    draw_frame(canvas, view, {0, 0, 0}, 70 / view.scale);
    int n = 0;
    for (const pipeline::Light& light : capture.scene().lights) {
        ++n;
        const Spot middle = view.spot(all.low + 0.5 * all.size());
        if (light.kind == pipeline::Light::Kind::Point) {
            draw_light(canvas, view.spot(glm::dvec3(light.position.v)), n);
            continue;
        }
        View direction = view;
        direction.center = {0, 0, 0}, direction.middle = {0, 0}, direction.scale = 1;
        const Spot d = direction.spot(glm::dvec3(light.direction.v));
        const double length = std::max(std::sqrt(d.x * d.x + d.y * d.y), 1e-30),
                     reach = 0.42 * std::min(area.width, area.height);
        const Spot start{middle.x - d.x / length * reach, middle.y - d.y / length * reach};
        arrow(canvas, start, {start.x + d.x / length * 70, start.y + d.y / length * 70}, {orange, 3});
        draw_light(canvas, start, n);
    }
    label(canvas, {area.x + 10.0, area.bottom() - 20.0},
          "grid at y = " + number(std::abs(ground) < 1e-7 * all.longest() ? 0 : ground) + ", squares of " +
              number(nice_step(std::max(all.size().x, all.size().z) / 12)),
          muted);
    return {std::move(page.picture),
            {{"models", std::int64_t(models.size())},
             {"triangles", capture.triangles()},
             {"lights", std::int64_t(capture.scene().lights.size())}},
            {},
            1};
}

// ---- eye ----
namespace {

// The models' box with the eye, but not much more than the view volume: a floor to the horizon must not make
// all else a dot.
Box shown_part(const Capture& capture, Box box) {
    box.add({0, 0, 0});
    const double reach =
        1.4 * std::min(capture.loaded->camera.far, std::max(-box.low.z, capture.loaded->camera.near));
    for (int k = 0; k < 3 && reach > 0; ++k) {
        box.low[k] = std::max(box.low[k], -reach);
        box.high[k] = std::min(box.high[k], k == 2 ? 0.3 * reach : reach);
    }
    return box;
}

void draw_sight_lines(Canvas canvas, const View& view, bool side, const Capture& capture, double reach) {
    const glm::dmat4& clip = capture.scene().camera.clip_from_eye.m;
    const double near = capture.loaded->camera.near, far = std::min(capture.loaded->camera.far, near + reach);
    const auto at = [&](double sign, double d) {
        return view.spot(side ? sight(clip, 0, sign, d) : sight(clip, sign, 0, d));
    };
    const std::array<Spot, 4> volume{at(-1, near), at(-1, far), at(1, far), at(1, near)};
    polygon(canvas, volume, with_opacity(purple, 18));
    for (const double sign : {-1.0, 1.0}) {
        line(canvas, at(sign, near), at(sign, far), {purple, 2});
        if (!capture.scene().camera.parallel)
            line(canvas, view.spot({0, 0, 0}), at(sign, near), {purple, 1, 4});
    }
    line(canvas, at(-1, near), at(1, near), {purple, 2.5});
    if (capture.loaded->camera.far <= near + reach) line(canvas, at(-1, far), at(1, far), {purple, 2.5});
}

void draw_eye_view(Canvas canvas, Rect area, const Capture& capture, const Box& box, bool side) {
    const View view = fitted(side ? side_view() : top_view(), box, area, 46);
    draw_flat_axes(canvas, view, area, side ? 2 : 0, side ? 1 : 2);
    draw_sight_lines(canvas, view, side, capture, 4 * box.longest());
    for (std::size_t m = 0; m < capture.scene().models.size(); ++m) {
        std::vector<glm::dvec3> positions;
        for (const SeenVertex& v : capture.vertices(m)) positions.push_back(v.eye);
        const std::vector<Segment> wire = mesh_edges(*capture.model(m).mesh, positions);
        draw_wire(canvas, view, wire, wire_stroke(view, wire, area, accent(m)));
    }
    const Spot eye = view.spot({0, 0, 0});
    disc(canvas, eye, 6, purple);
    label(canvas, {eye.x + 12, eye.y + 18}, "eye", purple);
    label(canvas, {area.x + 12.0, area.y + 18.0}, side ? "from the side (z, y)" : "from above (x, z)", ink);
}

}  // namespace

StagePage draw_eye(const Capture& capture, const Heading& heading) {
    std::int64_t behind = 0;
    for (std::size_t m = 0; m < capture.scene().models.size(); ++m)
        for (const SeenVertex& v : capture.vertices(m)) behind += v.eye.z >= 0;
    Box box = eye_box(capture);
    PanelBlock numbers{"Vertices in eye space", {}};
    if (!box.empty) {
        numbers.rows = {pair("x", range(box.low.x, box.high.x)), pair("y", range(box.low.y, box.high.y)),
                        pair("z", range(box.low.z, box.high.z))};
    }
    numbers.rows.push_back(pair("in front of the eye", grouped(capture.vertices() - behind)));
    numbers.rows.push_back(pair("behind it (z ≥ 0)", grouped(behind)));
    PanelBlock legend{"Legend",
                      {sample(Kind::Dot, purple, "the eye, at 0, 0, 0"),
                       sample(Kind::Square, mixed(paper, purple, 40), "what the picture shows"),
                       sample(Kind::Line, purple, "edges of the view volume")}};
    for (std::size_t m = 0; m < std::min(capture.scene().models.size(), most_panels); ++m)
        legend.rows.push_back(sample(Kind::Line, accent(m), model_name(*capture.loaded, m, 28)));
    Page page =
        diagram_page(heading, {matrix_block("Eye from world", capture.scene().camera.eye_from_world.m),
                               {"Camera", camera_rows(capture.loaded->camera)},
                               numbers,
                               legend});
    const Canvas canvas = canvas_of(page.picture);
    box = shown_part(capture, box);
    for (int i = 0; i < 2; ++i) {
        const Rect area = cell(page.area, 0, 1, i, 2, 0);
        frame(canvas, area, rule);
        draw_eye_view(within(canvas, inset(area, 2)), inset(area, 2), capture, box, i == 0);
    }
    return {
        std::move(page.picture), {{"vertices", capture.vertices()}, {"vertices_behind_eye", behind}}, {}, 1};
}

}  // namespace relevo::show
