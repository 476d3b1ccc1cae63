#include "tests/golden/relief/points.hpp"

#include <array>
#include <cmath>

#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"
#include "raster/draw.hpp"
#include "relief/box.hpp"
#include "relief/draw_relief.hpp"
#include "relief/inverse_slices.hpp"
#include "relief/inverse_view.hpp"
#include "relief/offset_map.hpp"
#include "relief/resample_asymmetric.hpp"
#include "relief/resample_compensated.hpp"
#include "relief/resample_one_dimensional.hpp"
#include "tests/golden/relief/mistakes.hpp"
#include "tests/golden/relief/pictures.hpp"
#include "tests/golden/relief/plain.hpp"

namespace relevo::golden {
namespace {

using namespace relief;
using raster::to_rgba8;

constexpr std::array four_resamplers = {Resampler::OneDimensional, Resampler::Asymmetric,
                                        Resampler::Compensated, Resampler::Interleaved};

// ------------------------------------------------------------------------------------- sources and orders
Product source_product(const ReliefSubject& s) {
    Product p;
    p.picture = shown(s.texture.color, s.texture.coverage);
    append(p.picture, shown(s.texture.normal, s.texture.coverage));
    append(p.picture, shown(Image<LinearRgb>(s.texture.camera.width, s.texture.camera.height, {1, 1, 1}),
                            s.texture.coverage));
    p.numbers = numbers(s.texture.depth, s.texture.coverage);
    return p;
}

Product codes_product(const ReliefSubject& s) {
    const auto q =
        s.mistake->rules.plain ? plain_codes(s.texture, s.mistake->rules) : quantize<std::uint8_t>(s.texture);
    Product p;
    p.text = line("nearest, deepest, step", {double{q.range.low}, double{q.range.high}, step(q)});
    p.picture = Image<Rgba8>(q.code.width(), q.code.height());
    p.numbers = Image<float>(q.code.width(), q.code.height());
    for (int y = 0; y < q.code.height(); ++y)
        for (int x = 0; x < q.code.width(); ++x) {
            const std::uint8_t code = q.code.at(x, y);
            p.picture.at(x, y) = {code, code, code};
            if (s.texture.coverage.at(x, y))
                p.numbers.at(x, y) = static_cast<float>(value(q, code) - s.texture.depth.at(x, y));
        }
    return p;
}

Product order_product(const ReliefSubject& s) {
    const int width = s.texture.camera.width, height = s.texture.camera.height;
    const OcclusionOrder order = occlusion_order(s.warp, s.settings.painting);
    Image<int> rank(width, height);
    int next = 0;
    for_each_in_order(order, width, height, [&](int x, int y) { rank.at(x, y) = next++; });
    if (s.mistake->rules.plain)
        rank = plain_ranks(s.warp, width, height, s.settings.painting, s.mistake->rules);
    Product p;
    p.text = std::string(order.toward ? "towards" : "away from") + line(" the epipole", {order.u, order.v});
    p.picture = Image<Rgba8>(2 * width, height);
    const int left = texels_before(order.u, width), top = texels_before(order.v, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int n = rank.at(x, y);  // dark to light, and to the bit in blue and green
            p.picture.at(x, y) = {static_cast<std::uint8_t>(255 * n / (width * height - 1)),
                                  static_cast<std::uint8_t>(n / 256), static_cast<std::uint8_t>(n % 256)};
            const bool right = x >= left, below = y >= top;
            p.picture.at(width + x, y) = {static_cast<std::uint8_t>(right ? 220 : 60),
                                          static_cast<std::uint8_t>(below ? 200 : 40), 90};
        }
    return p;
}

Product displacement_product(const ReliefSubject& s) {
    const int width = s.texture.camera.width, height = s.texture.camera.height;
    Product p;
    p.picture = Image<Rgba8>(width, height, Rgba8{0, 0, 0, 0});
    p.numbers = Image<float>(2 * width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!s.texture.coverage.at(x, y)) continue;
            const WarpedPoint to = warp_texel(s.warp, s.texture, x, y);
            const double du = to.u - (x + 0.5), dv = to.v - (y + 0.5);
            p.numbers.at(2 * x, y) = static_cast<float>(du),
                                p.numbers.at(2 * x + 1, y) = static_cast<float>(dv);
            p.picture.at(x, y) = to_rgba8({Scalar(0.5 + du / width), Scalar(0.5 + dv / height), Scalar(0.4)},
                                          raster::Output::Raw);
        }
    return p;
}

// ---------------------------------------------------------------------------------------------- resamplers
// Hears the picture between the passes.
struct RowsKeeper {
    Image<LinearRgb>& color;
    Image<Scalar>&depth, &v;
    Image<std::uint8_t>& kind;
    void on(const RowResampled<true>& row) {
        const int y = row.row;
        for (int x = 0; x < depth.width(); ++x) {
            const RowSample<true> sample = row.at(x);
            const Four& c = sample.carried.part[0];
            color.at(x, y) = {c[0], c[1], c[2]}, depth.at(x, y) = c[3], v.at(x, y) = sample.v;
            kind.at(x, y) = static_cast<std::uint8_t>(sample.kind);
        }
    }
};
template <class Method>
void run_rows(const ReliefSubject& s, Method method, Resampler resampler, RowsKeeper keeper) {
    PrewarpSettings settings = s.settings;
    settings.resampler = resampler;
    if (s.mistake->rules.plain) {
        const auto rows = plain_rows(s.texture, s.warp, s.window, settings, s.mistake->rules);
        for (int y = 0; y < rows.height(); ++y)
            for (int x = 0; x < rows.width(); ++x) {
                const PlainSample& from = rows.at(x, y);
                if (!from.there) continue;
                keeper.color.at(x, y) = {Scalar(from.color[0]), Scalar(from.color[1]), Scalar(from.color[2])};
                keeper.depth.at(x, y) = Scalar(from.depth), keeper.v.at(x, y) = Scalar(from.v);
                keeper.kind.at(x, y) = static_cast<std::uint8_t>(from.kind);
            }
        return;
    }
    const PreparedRelief prepared = prepare(s.texture, settings.jump, settings.jump_depth);
    Prewarped picture;
    PrewarpMemory memory;
    prewarp(prepared, s.warp, s.window, settings, picture, memory);
    resample_picture<true>(method, prepared, s.warp, settings, picture, memory.parts(), keeper);
}

Rgba8 kind_color(Kind kind) {
    constexpr Rgba8 colors[] = {{0, 0, 0, 0}, {60, 160, 60}, {220, 200, 60}, {210, 50, 40}};
    return colors[static_cast<int>(kind)];
}

Product rows_product(const ReliefSubject& s) {
    const int w = s.window.width, h = s.texture.camera.height;
    Product p;
    int tile = 0;
    const auto keep = [&](auto method, Resampler resampler, bool with_row) {
        Image<LinearRgb> color(w, h);
        Image<Scalar> depth(w, h), v(w, h);
        Image<std::uint8_t> kind(w, h);
        run_rows(s, method, resampler, {color, depth, v, kind});
        append(p.numbers, numbers(with_row ? v : depth, kind));
        if (tile++ > 0) return;
        p.picture = shown(color, kind);
        Image<Rgba8> kinds(w, h);
        for (std::size_t i = 0; i < kinds.pixels().size(); ++i)
            kinds.pixels()[i] = kind_color(static_cast<Kind>(kind.pixels()[i]));
        append(p.picture, kinds);
    };
    keep(CompensatedMethod{}, Resampler::Compensated, false);
    keep(OneDimensionalMethod{}, Resampler::OneDimensional, false);
    keep(AsymmetricMethod{}, Resampler::Asymmetric, true);
    return p;
}

Product resamplers_product(const ReliefSubject& s) {
    Product p;
    for (const Resampler resampler : four_resamplers) {
        const Prewarped picture = warped_picture(s, resampler);
        append(p.picture, shown(picture.color, picture.coverage));
        append(p.numbers, numbers(picture.depth, picture.coverage));
    }
    return p;
}

Product mesh_product(const ReliefSubject& s) {
    PrewarpSettings settings = s.settings;
    settings.resampler = Resampler::Mesh;
    const Warp right = *make_warp(s.texture.camera, viewer_at(s.screen.eye));
    const Prewarped mesh = prewarp(s.texture, right, s.window, settings);
    Product p;
    for (const Resampler resampler : four_resamplers) {
        const Prewarped picture = warped_picture(s, resampler);
        Image<Rgba8> tile(s.window.width, s.window.height, Rgba8{0, 0, 0, 0});
        for (std::size_t i = 0; i < tile.pixels().size(); ++i) {
            const bool here = picture.coverage.pixels()[i], there = mesh.coverage.pixels()[i];
            if (here != there) tile.pixels()[i] = here ? Rgba8{230, 60, 40} : Rgba8{60, 90, 230};
            if (!here || !there) continue;
            const auto off = static_cast<Scalar>(
                std::sqrt(mean_square_difference(picture.color.pixels()[i], mesh.color.pixels()[i])));
            tile.pixels()[i] = to_rgba8({4 * off, 4 * off, 4 * off}, raster::Output::Raw);
        }
        append(p.picture, tile);
    }
    return p;
}

Product kinds_product(const ReliefSubject& s) {
    Product p;
    for (const Resampler resampler : {Resampler::Interleaved, Resampler::Compensated, Resampler::Splat}) {
        const Prewarped picture = warped_picture(s, resampler);
        Image<Rgba8> kinds(s.window.width, s.window.height), writes = kinds;
        for (std::size_t i = 0; i < kinds.pixels().size(); ++i) {
            kinds.pixels()[i] = kind_color(picture.kind.pixels()[i]);
            const auto n = static_cast<std::uint8_t>(40 * std::min<int>(picture.writes.pixels()[i], 6));
            writes.pixels()[i] = {n, n, n};
        }
        append(p.picture, kinds), append(p.picture, writes);
    }
    return p;
}

Product wrong_order_product(const ReliefSubject& s) {
    ReliefSubject reversed = s, by_depth = s;
    reversed.settings.painting =
        s.settings.painting == Painting::Right ? Painting::Reversed : Painting::Right;
    by_depth.settings.depth_test = true;
    const Prewarped right = warped_picture(s, Resampler::Splat),
                    wrong = warped_picture(reversed, Resampler::Splat),
                    judge = warped_picture(by_depth, Resampler::Splat);
    Product p;
    append(p.picture, shown(right.color, right.coverage)),
        append(p.picture, shown(wrong.color, wrong.coverage));
    // green: the nearest of all texels that meet; red: another
    for (const Prewarped* picture : {&right, &wrong}) {
        Image<Rgba8> marks(s.window.width, s.window.height, Rgba8{0, 0, 0, 0});
        for (std::size_t i = 0; i < marks.pixels().size(); ++i)
            if (judge.coverage.pixels()[i])
                marks.pixels()[i] = picture->depth.pixels()[i] == judge.depth.pixels()[i]
                                        ? Rgba8{60, 160, 60}
                                        : Rgba8{210, 50, 40};
        append(p.picture, marks);
    }
    return p;
}

Product offset_product(const ReliefSubject& s) {
    const Prewarped picture = warped_picture(s, Resampler::Interleaved);
    Product p;
    p.picture = shown(fetch_by_map(picture, s.texture, s.texture.color), picture.coverage);
    // Lit anew: Lambert's law with the normals that the map fetches.
    const Image<Vec3> normal = fetch_by_map(picture, s.texture, s.texture.normal);
    Image<LinearRgb> lit(s.window.width, s.window.height);
    p.numbers = Image<float>(2 * s.window.width, s.window.height);
    const Vec3 light = pipeline::normalize(Vec3(s.screen.eye));
    for (int y = 0; y < lit.height(); ++y)
        for (int x = 0; x < lit.width(); ++x) {
            if (!picture.coverage.at(x, y)) continue;
            const Scalar c = std::max(glm::dot(pipeline::normalize(normal.at(x, y)), light), Scalar(0));
            lit.at(x, y) = {c, c, c};
            p.numbers.at(2 * x, y) = static_cast<float>(picture.source.at(x, y).x);
            p.numbers.at(2 * x + 1, y) = static_cast<float>(picture.source.at(x, y).y);
        }
    append(p.picture, shown(lit, picture.coverage));
    return p;
}

// --------------------------------------------------------------------------------------------- on the screen
raster::Scene scene_of(const ReliefSubject& s) {
    raster::Scene scene;
    scene.camera.eye_from_world = *pipeline::look_at(s.screen.eye, {0, 0, 0}, {0, 1, 0});
    scene.camera.clip_from_eye = *pipeline::perspective({45}, 1, 0.5, std::numeric_limits<double>::infinity(),
                                                        pipeline::DepthRange::Reversed);
    scene.background = {0, 0, 0};
    const glm::dvec3 lamp = s.screen.eye + glm::dvec3(1, 2, 0);
    scene.lights.push_back({pipeline::Light::Kind::Point, {Vec3(lamp)}, {{0, 0, -1}}, {1, 1, 1}});
    return scene;
}
raster::Settings settings_of(const ReliefSubject& s, raster::Shading shading) {
    raster::Settings settings;
    settings.shading = shading, settings.output = raster::Output::Raw, settings.cull = pipeline::Cull::None;
    if (s.mistake->reversed_depth_test) settings.depth = raster::DepthFormat::Float32Forward;
    return settings;
}
raster::Frame frame_of(int size) { return {{size, size}, {size, size}, {size, size}}; }

// The relief over what is there.
void draw_over(const ReliefSubject& s, const raster::Scene& scene, raster::Shading shading,
               raster::Frame& frame) {
    const Prewarped picture = warped_picture(s, Resampler::Interleaved);
    ReliefModel model;
    model.picture = &picture, model.source = s.texture.camera, model.viewer = viewer_at(s.screen.eye);
    model.jump_depth = Scalar(0.3);
    draw_relief(model, scene, settings_of(s, shading), frame);
}

// As the viewer sees it: near / reversed depth is the distance along the axis.
ViewImage view_of(const raster::Frame& frame) {
    ViewImage view(frame.depth.width(), frame.depth.height());
    view.color = frame.linear;
    for (std::size_t i = 0; i < view.depth.pixels().size(); ++i) {
        const Scalar z = frame.depth.pixels()[i];
        view.coverage.pixels()[i] = z > 0;
        if (z > 0) view.depth.pixels()[i] = Scalar(0.5) / z;
    }
    return view;
}
ViewImage relief_alone(const ReliefSubject& s, raster::Shading shading) {
    const raster::Scene scene = scene_of(s);
    raster::Frame frame = frame_of(s.screen.width);
    raster::draw(scene, settings_of(s, shading), frame);
    draw_over(s, scene, shading, frame);
    return view_of(frame);
}

void draw_line(Image<Rgba8>& picture, glm::dvec2 a, glm::dvec2 b, const Rgba8& color) {
    for (int i = 0; i <= 64; ++i) {
        const glm::dvec2 at = a + (b - a) * (i / 64.0);
        const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
        if (picture.holds(x, y)) picture.at(x, y) = color;
    }
}

Product polygon_product(const ReliefSubject& s) {
    Product p;
    const Prewarped warped = warped_picture(s, Resampler::Interleaved);
    Window window = s.mistake->clipped ? source_window(s.texture.camera) : warped.window;
    if (s.mistake->to_warp) window = *target_window(s.texture.camera, s.warp, depth_range(s.texture));
    p.text = "window " + std::to_string(window.x0) + ' ' + std::to_string(window.y0) + ' ' +
             std::to_string(window.width) + " x " + std::to_string(window.height) + '\n';
    const ViewImage view = relief_alone(s, raster::Shading::Unlit);
    p.picture = shown(view.color, view.coverage);
    const glm::dmat3 screen_from_plane = plane_homography(s.texture.camera, s.screen);
    const auto frame = [&](const char* name, const Window& w, const Rgba8& color) {
        glm::dvec2 corner[4];
        for (int i = 0; i < 4; ++i) {
            const double u = w.x0 + (i == 1 || i == 2 ? w.width : 0), v = w.y0 + (i >= 2 ? w.height : 0);
            const glm::dvec3 x = screen_from_plane * glm::dvec3(u, v, 1);
            corner[i] = {x.x / x.z, x.y / x.z};
            p.text += line(name, {corner[i].x, corner[i].y});
        }
        for (int i = 0; i < 4; ++i) draw_line(p.picture, corner[i], corner[(i + 1) % 4], color);
    };
    frame("window", window, {240, 200, 60});
    frame("source", source_window(s.texture.camera), {90, 160, 240});
    return p;
}

Product final_product(const ReliefSubject& s) {
    const ViewImage unlit = relief_alone(s, raster::Shading::Unlit),
                    lit = relief_alone(s, raster::Shading::Phong);
    Product p;
    append(p.picture, shown(unlit.color, unlit.coverage)), append(p.picture, shown(lit.color, lit.coverage));
    p.numbers = numbers(unlit.depth, unlit.coverage);
    return p;
}

Product truth_product(const ReliefSubject& s) {
    ReliefCamera screen = s.screen;
    if (s.mistake->to_source) s.mistake->to_source(screen);
    const ViewImage truth = s.truth(screen, s.mistake->one_sample ? 1 : 4);
    return {"", shown(truth.color, truth.coverage), numbers(truth.depth, truth.coverage)};
}

Product difference_product(const ReliefSubject& s) {
    const ViewImage truth = s.truth(s.screen, 4), unlit = relief_alone(s, raster::Shading::Unlit);
    const ErrorSet e = error_set(unlit, truth);
    Product p;
    p.text = line("missing, extra, psnr, depth, bad",
                  {e.missing_percent, e.extra_percent, e.psnr, e.mean_depth_error, e.bad_percent});
    p.picture = Image<Rgba8>(truth.width(), truth.height(), Rgba8{0, 0, 0, 0});
    for (std::size_t i = 0; i < p.picture.pixels().size(); ++i) {
        const bool seen = unlit.coverage.pixels()[i], there = truth.coverage.pixels()[i];
        if (seen != there) p.picture.pixels()[i] = seen ? Rgba8{230, 60, 40} : Rgba8{60, 90, 230};
        if (!seen || !there) continue;
        const auto off = static_cast<Scalar>(
            std::sqrt(mean_square_difference(unlit.color.pixels()[i], truth.color.pixels()[i])));
        p.picture.pixels()[i] = to_rgba8({off, off, off}, raster::Output::Raw);
    }
    return p;
}

// A slanted plane through the object: which of the two is seen.
Product cut_product(const ReliefSubject& s) {
    const double turned = s.screen.eye.z < 0 ? 1 : -1;  // towards the viewer
    const auto at = [&](double x, double y) { return Vec3(glm::dvec3(x, y, turned * (0.4 * x - 0.5))); };
    pipeline::Mesh plane;
    for (const Vec3& p : {at(-3, -3), at(3, -3), at(3, 3), at(-3, 3)})
        plane.vertices.push_back({{p}, {{0, 0, 1}}, {0, 0}});
    plane.indices = {0, 1, 2, 0, 2, 3};
    raster::Scene scene = scene_of(s);
    raster::Model& model = scene.models.emplace_back();
    model.mesh = &plane, model.material.color = {1, 1, 1}, model.two_sided = true;
    raster::Frame frame = frame_of(s.screen.width);
    raster::draw(scene, settings_of(s, raster::Shading::Unlit), frame);
    const Image<Scalar> before = frame.depth;
    draw_over(s, scene, raster::Shading::Unlit, frame);
    const ViewImage view = view_of(frame);
    Product p;
    p.picture = shown(view.color, view.coverage);
    Image<Rgba8> labels(frame.depth.width(), frame.depth.height(), Rgba8{0, 0, 0, 0});
    for (std::size_t i = 0; i < labels.pixels().size(); ++i)
        if (view.coverage.pixels()[i])
            labels.pixels()[i] =
                frame.depth.pixels()[i] == before.pixels()[i] ? Rgba8{200, 200, 200} : Rgba8{60, 160, 60};
    append(p.picture, labels);
    p.numbers = numbers(view.depth, view.coverage);
    return p;
}

// ---------------------------------------------------------------------------------------------- the inverse
void append_view(Product& p, const ViewImage& view) {
    append(p.picture, shown(view.color, view.coverage));
    append(p.numbers, numbers(view.depth, view.coverage));
}

ViewImage searched(const ReliefSubject& s, const ReliefSolid& solid, SliceSettings slices) {
    if (s.mistake->no_bisection) slices.bisections = 0;
    const double step = (solid.high - solid.low) / slices.slices;
    return *inverse_view(s.texture, solid, s.screen, [&](ReliefRay ray) {
        if (s.mistake->to_ray) s.mistake->to_ray(ray, s.warp);
        auto hit = find_by_slices(solid, ray, slices);
        if (hit && s.mistake->one_slice_late) hit->z += step;
        return hit;
    });
}

Product slices_product(const ReliefSubject& s) {
    const ReliefSolid solid =
        s.mistake->extruded ? extruded_solid(s.texture) : solid_of_thickness(s.texture, 0.3);
    Product p;
    for (const int slices : {8, 16, 32, 64, 128, 256}) append_view(p, searched(s, solid, {slices, 0}));
    append_view(p, searched(s, solid, {32, 8}));
    return p;
}

Product thickness_product(const ReliefSubject& s) {
    const ReliefTexture back = s.capture(opposite_camera(s.texture.camera, 2));
    const ReliefSolid extruded = extruded_solid(s.texture), thick = solid_of_thickness(s.texture, 0.3),
                      between = solid_between(s.texture, back);
    Product p;
    for (const ReliefSolid* solid : {&extruded, &thick, &between})
        append_view(p, searched(s, s.mistake->extruded ? extruded : *solid, {64, 8}));
    return p;
}

// ------------------------------------------------------------------------------------------------ six faces
Image<Rgba8> labels_of(const ViewImage& view) {
    constexpr Rgba8 colors[] = {{0, 0, 0, 0},   {200, 70, 60},  {70, 180, 80}, {70, 90, 210},
                                {210, 200, 70}, {180, 80, 190}, {80, 190, 200}};
    Image<Rgba8> labels(view.width(), view.height());
    for (std::size_t i = 0; i < labels.pixels().size(); ++i)
        labels.pixels()[i] = colors[view.coverage.pixels()[i]];
    return labels;
}

Product box_product(const ReliefSubject& s) {
    BoxRelief relief{{{-1, -1, -1}, {1, 1, 1}}, {}};
    for (const Face face : all_faces) {
        ReliefCamera camera = *face_camera(relief.box, face, s.texture.camera.height);
        if (s.mistake->to_source) s.mistake->to_source(camera);
        relief.face[std::size_t(face)] = s.capture(camera);
    }
    const auto exchange = [&](Face a, Face b) {
        std::swap(relief.face[std::size_t(a)], relief.face[std::size_t(b)]);
    };
    if (s.mistake->faces == 1) exchange(Face::Left, Face::Right);
    if (s.mistake->faces == 2) exchange(Face::Back, Face::Front);
    const BoxRegion region = box_region(relief.box, s.screen.eye);
    Product p;
    p.text = "region " + std::to_string(region.number()) + ", faces in front " +
             std::to_string(region.faces()) + '\n';
    for (const Face face : all_faces) {
        const ReliefTexture& texture = relief.face[std::size_t(face)];
        append(p.picture, shown(texture.color, texture.coverage));
    }
    const ViewImage by_depth =
                        draw_box(relief, s.screen,
                                 {0.3, s.mistake->faces == 3 ? Composite::FaceOrder : Composite::Depth}),
                    by_order = draw_box(relief, s.screen, {0.3, Composite::FaceOrder});
    Image<Rgba8> views = labels_of(by_depth);
    append(views, labels_of(by_order)), append(views, shown(by_depth.color, by_depth.coverage));
    append_below(p.picture, views);
    p.numbers = numbers(by_depth.depth, by_depth.coverage);
    return p;
}

// ---------------------------------------------------------------------------------------------- the
// catalogue
struct Point {
    const char* folder;
    Product (*make)(const ReliefSubject&);
    Allowed allowed;
    bool has_plain = false;
};

constexpr const char* resampled_reason =
    "the order of float operations inside a resampler is its own affair: 1 level, and a hundredth of the "
    "pixels may lie on the other side of a border";
constexpr Allowed exact{};
constexpr Allowed resampled{1e-4, 1, 0.01, resampled_reason};
constexpr Allowed by_error_set{
    1e-3,
    0,
    0,
    "a view of a scene: by the error set, never by PSNR alone; what lies on a border "
    "may be rounded to the other side of it",
    true,
    0.4,
    0.4,
    45,
    2e-4,
    0.4};

constexpr Point points[] = {
    {"r01-source", source_product, exact},
    {"r02-codes", codes_product, exact, true},
    {"r03-order", order_product, exact, true},
    {"r04-displacement", displacement_product, exact},
    {"r05-rows", rows_product, resampled, true},
    {"r06-resamplers", resamplers_product, resampled, true},
    {"r07-mesh", mesh_product, {0, 4, 0.01, "differences, shown four times as large"}, true},
    {"r08-kinds", kinds_product, exact, true},
    {"r09-wrong-order", wrong_order_product, exact, true},
    {"r10-offset-map", offset_product, resampled},
    {"r11-polygon", polygon_product, {1e-9, 1, 0.01, resampled_reason}},
    {"r12-final", final_product, by_error_set},
    {"r13-truth", truth_product, exact},
    {"r14-difference", difference_product, {0.02, 2, 0.01, "the error of r12, which may differ a little"}},
    {"r15-depth", cut_product, by_error_set},
    {"r16-inverse", slices_product, {1e-6, 1, 0, "computed in double, kept in float"}},
    {"r17-thickness", thickness_product, {1e-6, 1, 0, "computed in double, kept in float"}},
    {"r18-six-faces", box_product, exact},
};

// Which scenes show which points, from where.
struct Showing {
    const char *scene, *points;
    double azimuth;
    bool perspective;
};
constexpr Showing showings[] = {
    {"plane_step", "r01 r04 r06 r08 r12 r15", 25, false},
    {"sphere", "r01 r02 r03 r05 r10 r11 r13 r14 r16", 25, false},
    {"bumpy", "r01 r03 r07 r08 r09 r10 r17 r18", 10, false},
    {"complex", "r01 r02 r05 r06 r09 r12 r13 r14 r15 r17 r18", 25, false},
    {"checker_cube", "r01 r03 r04 r07 r11 r16", 40, true},
};
constexpr int texels = 24;

Exhibit exhibit(const Showing& showing, const Point& point) {
    const auto make = [&showing, &point](const ReliefMistake& mistake) {
        Product product =
            point.make(relief_subject(showing.scene, showing.azimuth, showing.perspective, texels, mistake));
        if (mistake.to_product) mistake.to_product(product);
        return product;
    };
    static constexpr ReliefMistake none{}, plain{.rules = {.plain = true}};
    Exhibit e;
    e.name = std::string("relief/") + point.folder + '/' + showing.scene;
    e.product = [make] { return make(none); };
    e.mistaken = [make](std::string_view name) -> std::optional<Product> {
        const ReliefMistake* const mistake = find_relief_mistake(name);
        if (!mistake) return {};
        return make(*mistake);
    };
    e.plain = [make, &point]() -> std::optional<Product> {
        if (!point.has_plain) return {};
        return make(plain);
    };
    e.noticed = [&point](const Product& a, const Product& b) {
        return difference_beyond(point.allowed, a, b);
    };
#ifdef RELEVO_DOUBLE
    e.difference = [&point](const Product& a, const Product& b) {
        return difference_beyond(loosened(point.allowed), a, b);
    };
#else
    e.difference = e.noticed;
#endif
    return e;
}

}  // namespace

std::vector<Exhibit> relief_exhibits() {
    std::vector<Exhibit> all;
    for (const Point& point : points)
        for (const Showing& showing : showings)
            if (std::string_view(showing.points).find(std::string_view(point.folder).substr(0, 3)) !=
                std::string_view::npos)
                all.push_back(exhibit(showing, point));
    return all;
}

std::vector<MistakeName> relief_mistake_names() {
    std::vector<MistakeName> names;
    for (const ReliefMistake& m : all_relief_mistakes()) names.push_back({m.name, m.sentence});
    return names;
}

}  // namespace relevo::golden
