// The pictures of the window: corners snapped to 1/256 pixel, and the triangles that culling drops.
#include <fmt/format.h>

#include <optional>

#include "samples/show/numbers.hpp"
#include "samples/show/stage.hpp"

namespace relevo::show {
namespace {

using Kind = PanelRow::Kind;
constexpr int lens_height = 208, lens_factor = 16;

glm::dvec3 place(const pipeline::SnappedCorner& c) {
    return {c.x / double(pipeline::subpixels), c.y / double(pipeline::subpixels), 0};
}

// A view of the window in pixels, y down; whole factors when the picture is small.
View window_view(const Capture& capture, Rect area) {
    const double w = capture.loaded->width, h = capture.loaded->height;
    double scale = std::min(area.width / w, area.height / h);
    if (scale >= 2) scale = std::floor(scale);
    return {{1, 0, 0},
            {0, -1, 0},
            {0, 0, 1},
            {w / 2, h / 2, 0},
            {area.x + area.width / 2.0, area.y + area.height / 2.0},
            scale};
}

Rect window_rect(const Capture& capture, const View& view) {
    const Spot corner = view.spot({0, 0, 0});
    return {static_cast<int>(std::floor(corner.x)), static_cast<int>(std::floor(corner.y)),
            std::max(1, static_cast<int>(view.scale * capture.loaded->width)),
            std::max(1, static_cast<int>(view.scale * capture.loaded->height))};
}

enum class Group { All, Kept, KeptFront, KeptBack, Culled };

bool belongs(const SeenFace& face, Group group) {
    const bool front = face.facing == pipeline::Facing::Front;
    switch (group) {
        case Group::All:
            return true;
        case Group::Kept:
            return !face.culled;
        case Group::KeptFront:
            return !face.culled && front;
        case Group::KeptBack:
            return !face.culled && !front;
        case Group::Culled:
            return face.culled;
    }
    return false;
}

// The edges of a group of triangles, a list a model.
std::vector<std::vector<Segment>> face_wires(const Capture& capture, Group group) {
    std::vector<std::vector<Segment>> wires(capture.scene().models.size());
    for (const SeenFace& face : capture.seen.geometry.faces)
        for (std::size_t k = 0; belongs(face, group) && k < 3; ++k)
            wires[face.model].push_back({place(face.corners[k]), place(face.corners[(k + 1) % 3])});
    for (std::vector<Segment>& wire : wires) wire = unique_segments(std::move(wire));
    return wires;
}

void draw_faces(Canvas canvas, const View& view, const Capture& capture, Group group, Rgba8 color,
                double dash) {
    for (const std::vector<Segment>& wire : face_wires(capture, group)) {
        Stroke stroke = wire_stroke(view, wire, canvas.clip, color);
        stroke.dash = dash;
        draw_wire(canvas, view, wire, stroke);
    }
}

// The picture's rectangle with pixels drawn where there is room, so that the view stands on whole pixels.
Rect draw_window_frame(Canvas canvas, const Capture& capture, View& view) {
    Rect rect = window_rect(capture, view);
    view.middle.x -= view.spot({0, 0, 0}).x - rect.x, view.middle.y -= view.spot({0, 0, 0}).y - rect.y;
    fill(canvas, rect, paper);
    if (view.scale >= 8) pixel_grid(canvas, rect, static_cast<int>(view.scale), rule);
    frame(canvas, {rect.x - 1, rect.y - 1, rect.width + 2, rect.height + 2}, muted);
    return rect;
}

// The snapped corner nearest to the middle of the picture: where a look through the lens pays.
std::optional<pipeline::SnappedCorner> central_corner(const Capture& capture) {
    std::optional<pipeline::SnappedCorner> best;
    double nearest = 0;
    const double cx = capture.loaded->width / 2.0, cy = capture.loaded->height / 2.0;
    for (const SeenFace& face : capture.seen.geometry.faces)
        for (const pipeline::SnappedCorner& c : face.corners) {
            const glm::dvec3 p = place(c);
            const double away = (p.x - cx) * (p.x - cx) + (p.y - cy) * (p.y - cy);
            if (face.culled || (best && away >= nearest)) continue;
            best = c, nearest = away;
        }
    return best;
}

void draw_lens(Canvas canvas, Rect area, const Capture& capture, const pipeline::SnappedCorner& corner) {
    const Rect rect{area.x, area.y, 18 * lens_factor, 12 * lens_factor};
    const int left = (corner.x >> pipeline::subpixel_bits) - 9,
              top = (corner.y >> pipeline::subpixel_bits) - 6;
    const View view{{1, 0, 0},
                    {0, -1, 0},
                    {0, 0, 1},
                    {double(left), double(top), 0},
                    {double(rect.x), double(rect.y)},
                    double(lens_factor)};
    const Canvas inside = within(canvas, rect);
    fill(inside, rect, paper);
    pixel_grid(inside, rect, lens_factor, rule);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 18; ++x)
            disc(inside, {rect.x + (x + 0.5) * lens_factor, rect.y + (y + 0.5) * lens_factor}, 1.5, haze);
    for (const std::vector<Segment>& wire : face_wires(capture, Group::Kept))
        draw_wire(inside, view, wire, {blue, 1.5});
    const Spot at = view.spot(place(corner));
    ring(inside, at, 6, {vermilion, 2});
    frame(canvas, {rect.x - 1, rect.y - 1, rect.width + 2, rect.height + 2}, muted);

    const int x = rect.right() + 20;
    const auto write = [&](int row, const std::string& words_of_row, Rgba8 color) {
        text(within(canvas, area), x, rect.y + 4 + 26 * row,
             shortened(words_of_row, (area.right() - x) / (2 * letter_cell)), color);
    };
    write(0, fmt::format("The pixels round one corner, {}×", lens_factor), ink);
    write(1, "Dots are the pixel centres, the ring", muted);
    write(2, "is the corner nearest to the middle:", muted);
    write(3, fmt::format("x = {} / 256 = {:.6g}", corner.x, corner.x / 256.0), vermilion);
    write(4, fmt::format("y = {} / 256 = {:.6g}", corner.y, corner.y / 256.0), vermilion);
    write(5, "depth " + number(corner.z) + ", 1/w " + number(corner.rw), muted);
}

std::int64_t rejected(const Capture& capture, raster::Rejection reason) {
    return capture.seen.geometry.rejected[static_cast<std::size_t>(reason)];
}

PanelBlock fate_block(const Capture& capture) {
    using raster::Rejection;
    const GeometryProbe& geometry = capture.seen.geometry;
    PanelBlock block{"Triangles",
                     {pair("in the scene", grouped(capture.triangles())),
                      pair("outside, not drawn", grouped(rejected(capture, Rejection::Outside))),
                      pair("cut (near, far, guard band)", grouped(geometry.clipped)),
                      pair("no area after snapping", grouped(rejected(capture, Rejection::ZeroArea)))}};
    if (rejected(capture, Rejection::NonFinite) > 0)
        block.rows.push_back(pair("not finite", grouped(rejected(capture, Rejection::NonFinite))));
    block.rows.push_back(pair("in the window", grouped(std::int64_t(geometry.faces.size()))));
    return block;
}

}  // namespace

StagePage draw_window(const Capture& capture, const Heading& heading) {
    const scene::LoadedScene& loaded = *capture.loaded;
    const PanelBlock viewport{"Window",
                              {pair("picture", fmt::format("{} × {}", loaded.width, loaded.height)),
                               words("x = (x_ndc + 1) / 2 × width"), words("y = (1 - y_ndc) / 2 × height"),
                               quiet("Rounded once to 1/256 pixel, ties to even. y runs down; pixel (0, 0) "
                                     "is at the upper left, its centre at (0.5, 0.5).")}};
    const PanelBlock legend{
        "Legend",
        {sample(Kind::Line, blue, "edge of a triangle"), sample(Kind::Square, paper, "the picture"),
         sample(Kind::Ring, vermilion, "corner under the lens")}};
    Page page = diagram_page(heading, {fate_block(capture), viewport, legend});
    const Canvas canvas = canvas_of(page.picture);
    const Rect area = inset(page.area, 2), upper{area.x, area.y, area.width, area.height - lens_height - 12};
    fill(canvas, upper, mist);
    View view = window_view(capture, inset(upper, 16));
    draw_window_frame(within(canvas, upper), capture, view);
    draw_faces(within(canvas, upper), view, capture, Group::All, blue, 0);
    const Rect lens{area.x + 10, upper.bottom() + 10, area.width - 20, lens_height};
    if (const auto corner = central_corner(capture))
        draw_lens(canvas, lens, capture, *corner);
    else
        say(canvas, upper, "no triangle reaches the window");
    return {std::move(page.picture),
            {{"triangles", capture.triangles()},
             {"outside", rejected(capture, raster::Rejection::Outside)},
             {"clipped", capture.seen.geometry.clipped},
             {"zero_area", rejected(capture, raster::Rejection::ZeroArea)},
             {"not_finite", rejected(capture, raster::Rejection::NonFinite)},
             {"in_window", std::int64_t(capture.seen.geometry.faces.size())}},
            {},
            1};
}

StagePage draw_culled(const Capture& capture, const Heading& heading) {
    const pipeline::Cull cull = capture.loaded->settings.cull;
    std::int64_t front = 0, back = 0, culled = 0, kept_front = 0;
    for (const SeenFace& face : capture.seen.geometry.faces) {
        ++(face.facing == pipeline::Facing::Front ? front : back);
        culled += face.culled;
        kept_front += belongs(face, Group::KeptFront);
    }
    const std::int64_t no_pixel = rejected(capture, raster::Rejection::NoPixel), kept = front + back - culled;
    Page page = diagram_page(
        heading,
        {{"Triangles in the window",
          {pair("all", grouped(front + back)), pair("front faces", grouped(front)),
           pair("back faces", grouped(back))}},
         {"Culling",
          {pair("setting", cull == pipeline::Cull::Back    ? "cull back faces"
                           : cull == pipeline::Cull::Front ? "cull front faces"
                                                           : "cull none"),
           sample(Kind::Line, blue, "kept, front", grouped(kept_front)),
           sample(Kind::Line, purple, "kept, back", grouped(kept - kept_front)),
           sample(Kind::Dashes, vermilion, "culled", grouped(culled)),
           pair("kept, but without a pixel", grouped(no_pixel))}},
         {"How",
          {quiet(
              "The sign of the snapped area decides: when the corners run counter-clockwise in the picture, "
              "the "
              "front is seen. The area is an exact integer, so no rounding can turn a triangle around.")}}});
    const Canvas canvas = canvas_of(page.picture);
    const Rect area = inset(page.area, 2);
    struct Drawn {
        Group group;
        std::int64_t count;
        Rgba8 color;
        double dash;
        const char* name;
    };
    std::vector<Drawn> groups{{Group::Culled, culled, vermilion, 5, "culled"},
                              {Group::KeptBack, kept - kept_front, purple, 0, "kept, back"},
                              {Group::KeptFront, kept_front, blue, 0, "kept, front"}};
    std::erase_if(groups, [](const Drawn& g) { return g.count == 0; });
    // Few triangles: all in one drawing. Many: one drawing each, or nobody could tell them apart.
    const bool apart = groups.size() > 1 && front + back > 400;
    const int parts = apart ? static_cast<int>(groups.size()) : 1;
    for (int i = 0; i < parts; ++i) {
        const Rect part = cell(area, 0, 1, parts - 1 - i, parts, 4);
        const Canvas inside = within(canvas, part);
        fill(inside, part, mist);
        View view = window_view(capture, inset(part, 16));
        draw_window_frame(inside, capture, view);
        for (std::size_t g = 0; g < groups.size(); ++g)
            if (!apart || g == std::size_t(i))
                draw_faces(inside, view, capture, groups[g].group, groups[g].color,
                           apart ? 0 : groups[g].dash);
        if (apart)
            label(inside, {part.x + 12.0, part.y + 20.0}, groups[std::size_t(i)].name,
                  groups[std::size_t(i)].color);
    }
    if (front + back == 0) say(canvas, area, "no triangle reaches the window");
    if (front + back > 0 && kept == 0) say(canvas, area, "every triangle is culled: the picture stays empty");
    return {
        std::move(page.picture),
        {{"front", front}, {"back", back}, {"culled", culled}, {"kept", kept}, {"without_pixel", no_pixel}},
        {},
        1};
}

}  // namespace relevo::show
