// The relief on the screen: beside the truth, in the depth buffer, and by other ways from pictures to pixels.
#include <fmt/format.h>

#include "relief/inverse_slices.hpp"
#include "relief/inverse_view.hpp"
#include "relief/unseen.hpp"
#include "samples/scene/choices.hpp"
#include "samples/scene/draw_scene.hpp"
#include "samples/show/numbers.hpp"
#include "samples/show/relief_stages.hpp"
#include "samples/show/tones.hpp"

namespace relevo::show {
namespace {

using Row = PanelRow::Kind;
using relief::Representation;
using relief::RepresentationSettings;
using relief::ViewImage;

Picture colors_of(const ReliefView& view, const ViewImage& image) {
    return color_picture(image.color, image.coverage, view.loaded->settings.output);
}

// The scene's picture with its first relief object in this way; the others as they are.
raster::Frame whole_frame(const ReliefView& view, const relief::Represented& object) {
    raster::Frame frame = scene::make_frame(*view.loaded);
    raster::fast::Workspace workspace;
    auto pictures = scene::take_pictures(*view.loaded);
    pictures->objects[0] = object;
    // what cannot be drawn was said before: `problem`
    (void)scene::draw_scene(*view.loaded, *pictures, 0, frame, workspace);
    return frame;
}
relief::Represented as_geometry(const ReliefView& view) {
    relief::Represented object = view.relief;
    object.representation = Representation::Geometry;
    return object;
}
relief::Represented as_asked(const ReliefView& view) {
    return *view.in_another_way(view.object->representation, view.object->settings);
}

Picture depth_buffer(const ReliefView& view, const relief::Image<raster::Scalar>& depth) {
    const raster::Scalar cleared = raster::cleared_depth(view.loaded->settings.depth);
    relief::Image<std::uint8_t> covered(depth.width(), depth.height());
    relief::Image<raster::Scalar> away = depth;
    const bool reversed = view.loaded->settings.depth == raster::DepthFormat::Float32Reversed;
    for (std::size_t i = 0; i < covered.pixels().size(); ++i) {
        covered.pixels()[i] = depth.pixels()[i] != cleared;
        if (reversed) away.pixels()[i] = -depth.pixels()[i];
    }
    return depth_picture(away, covered);
}

// Which object a pixel shows: 1, what is no relief; 2, the relief; 0, neither.
relief::Image<std::uint8_t> shown(const ReliefView& view, const raster::Frame& others,
                                  const raster::Frame& with) {
    relief::Image<std::uint8_t> out(view.loaded->width, view.loaded->height);
    const raster::Scalar cleared = raster::cleared_depth(view.loaded->settings.depth);
    for (std::size_t i = 0; i < out.pixels().size(); ++i)
        out.pixels()[i] = with.depth.pixels()[i] != others.depth.pixels()[i] ? 2
                          : others.depth.pixels()[i] != cleared              ? 1
                                                                             : 0;
    return out;
}

constexpr const char* face_names[] = {"left", "right", "bottom", "top", "back", "front"};

}  // namespace

StagePage draw_relief_final(const ReliefView& view, const Heading& heading) {
    const raster::Frame frame = whole_frame(view, as_asked(view));
    const PanelBlock what{
        "Object",
        {pair("name", shortened(view.object->name, 20)),
         pair("drawn as", std::string(scene::name_of(view.object->representation, scene::representations))),
         pair("lit", view.object->settings.lit == relief::Lit::Drawn ? "for the viewer" : "for the source"),
         pair("relief objects", std::to_string(view.loaded->reliefs.size())),
         pair("models", std::to_string(view.loaded->scene.models.size()))}};
    PanePage page = pane_page(heading, {what}, 1, {{"the picture", frame.color}});
    page.stage.pixels = page.rects[0];
    page.stage.factor = page.scales[0].factor;
    return std::move(page.stage);
}

StagePage draw_relief_truth(const ReliefView& view, const Heading& heading) {
    const raster::Frame frame = whole_frame(view, as_geometry(view));
    const PanelBlock how{
        "How",
        {words(view.object->surface ? "a ray through the centre of each pixel, in double"
                                    : "its triangles, 16 samples a pixel where it is compared"),
         quiet("No picture is between the object and the viewer: what a relief is measured against.")}};
    PanePage page = pane_page(heading, {how}, 1, {{"the truth", frame.color}});
    page.stage.pixels = page.rects[0];
    page.stage.factor = page.scales[0].factor;
    return std::move(page.stage);
}

StagePage draw_relief_error(const ReliefView& view, const Heading& heading) {
    RepresentationSettings settings = view.relief.settings;
    const auto sprite = view.in_another_way(Representation::Sprite, settings);
    const ViewImage flat = *view.view(*sprite);
    const relief::ErrorSet relief = error_set(view.seen, view.truth), none = error_set(flat, view.truth);
    const PanelBlock legend{"Legend",
                            {ramp(night, paper, "equal", "0.25 apart"), sample(Row::Square, sky, "missing"),
                             sample(Row::Square, orange, "extra")}};
    PanePage page =
        pane_page(heading, {error_block("Relief", relief), error_block("Flat sprite", none), legend}, 2,
                  {{"relief", colors_of(view, view.seen)},
                   {"difference", difference_picture(view.seen, view.truth)},
                   {"flat sprite", colors_of(view, flat)},
                   {"its difference", difference_picture(flat, view.truth)}});
    add_counts(page.stage, "relief", relief);
    add_counts(page.stage, "sprite", none);
    return std::move(page.stage);
}

StagePage draw_relief_depth(const ReliefView& view, const Heading& heading) {
    const auto sprite = view.in_another_way(Representation::Sprite, view.relief.settings);
    scene::LoadedScene const& loaded = *view.loaded;
    raster::Frame others = scene::make_frame(loaded);
    raster::draw(loaded.scene, loaded.settings, others);
    const raster::Frame relief = whole_frame(view, view.relief), truth = whole_frame(view, as_geometry(view)),
                        flat = whole_frame(view, *sprite);
    const auto truly = shown(view, others, truth);
    const auto compared = [&](const raster::Frame& frame, std::int64_t& wrong) {
        const auto is = shown(view, others, frame);
        Picture out(loaded.width, loaded.height);
        wrong = 0;
        for (int y = 0; y < out.height(); ++y)
            for (int x = 0; x < out.width(); ++x) {
                const bool off = is.at(x, y) != truly.at(x, y);
                wrong += off;
                out.at(x, y) = off                ? vermilion
                               : is.at(x, y) == 2 ? Rgba8{150, 185, 215}
                               : is.at(x, y) == 1 ? Rgba8{214, 222, 230}
                                                  : empty_pixel(x, y, out.width());
            }
        return out;
    };
    std::int64_t wrong = 0, flat_wrong = 0;
    const Picture right = compared(relief, wrong), sprite_wrong = compared(flat, flat_wrong);
    const std::int64_t all = std::int64_t(loaded.width) * loaded.height;
    PanelBlock numbers{
        "Wrong object shown",
        {pair("relief", share(wrong, all)), pair("flat sprite", share(flat_wrong, all)),
         quiet(
             "X = P + d (P - T) / h: from the point P on the plane, seen from T, the surface lies d deeper. "
             "That depth is written and compared, so objects meet where they really do.")}};
    PanelBlock legend{"Legend",
                      {sample(Row::Square, {150, 185, 215}, "the relief, rightly"),
                       sample(Row::Square, {214, 222, 230}, "another object, rightly"),
                       sample(Row::Square, vermilion, "wrong")}};
    if (loaded.scene.models.empty())
        numbers.rows.push_back(quiet("This scene has nothing else that the relief could meet."));
    PanePage page = pane_page(heading, {numbers, legend}, 2,
                              {{"depth buffer", depth_buffer(view, relief.depth)},
                               {"true depth buffer", depth_buffer(view, truth.depth)},
                               {"relief", right},
                               {"flat sprite", sprite_wrong}});
    page.stage.counts = {{"wrong_object", wrong}, {"wrong_object_of_the_sprite", flat_wrong}};
    return std::move(page.stage);
}

StagePage draw_relief_inverse(const ReliefView& view, const Heading& heading) {
    RepresentationSettings settings = view.relief.settings;
    if (settings.projection == relief::Projection::Perspective) settings.end = relief::SolidEnd::Thickness;
    settings.search = relief::Search::Slices;
    auto object = *view.in_another_way(Representation::ReliefInverse, settings);
    std::vector<Pane> panes;
    PanelBlock quality{"PSNR, missing", {}};
    std::vector<Count> counts;
    for (const relief::SliceSettings slices :
         {relief::SliceSettings{8, 0}, {16, 0}, {32, 0}, {64, 0}, {128, 0}, {256, 0}, {32, 8}}) {
        object.settings.slices = slices;
        const ViewImage image = *view.view(object);
        const relief::ErrorSet error = error_set(image, view.truth);
        const bool bisected = slices.bisections > 0;
        const std::string name = bisected ? fmt::format("{} + {} halvings", slices.slices, slices.bisections)
                                          : fmt::format("{} slices", slices.slices);
        panes.push_back({name, colors_of(view, image)});
        quality.rows.push_back(pair(
            name, fmt::format("{} dB, {} %", decimals(error.psnr, 2), decimals(error.missing_percent, 2))));
        const std::string key =
            bisected ? "psnr_32_slices_8_halvings" : fmt::format("psnr_{}_slices", slices.slices);
        counts.push_back({key, error.psnr});
    }
    panes.push_back({"the truth", colors_of(view, view.truth)});
    const PanelBlock how{
        "Search",
        {quiet("Each line of sight is a straight line in the texture. The depths between the nearest and the "
               "deepest texel are cut into slices; the first one at which the line is inside the object is "
               "the hit."),
         quiet("The error falls as 1 / N, the work grows as N. Halving the last slice eight times finds the "
               "depth as finely as 8192 slices; but what is thinner than a slice can still be missed.")}};
    PanePage page = pane_page(heading, {quality, how}, 3, panes);
    page.stage.counts = std::move(counts);
    return std::move(page.stage);
}

StagePage draw_relief_solid(const ReliefView& view, const Heading& heading) {
    using relief::SolidEnd;
    RepresentationSettings settings = view.relief.settings;
    std::vector<Pane> panes;
    std::vector<PanelBlock> blocks;
    StagePage counted;
    const auto add = [&](SolidEnd end, const std::string& title, const std::string& name) {
        settings.end = end;
        const ViewImage image = *view.view(*view.in_another_way(Representation::ReliefInverse, settings));
        const relief::ErrorSet error = error_set(image, view.truth);
        panes.push_back({title, colors_of(view, image)});
        blocks.push_back(error_block(title, error));
        add_counts(counted, name, error);
    };
    add(SolidEnd::None, "without an end", "without_end");
    add(SolidEnd::Thickness, fmt::format("thickness {}", decimals(settings.thickness, 2)), "thickness");
    if (settings.projection == relief::Projection::Orthographic) add(SolidEnd::Back, "with its back", "back");
    panes.push_back({"the truth", colors_of(view, view.truth)});
    blocks.push_back({"", {quiet("The back is a second relief texture, taken from the opposite side.")}});
    PanePage page = pane_page(heading, blocks, 2, panes);
    page.stage.counts = std::move(counted.counts);
    return std::move(page.stage);
}

StagePage draw_relief_faces(const ReliefView& view, const Heading& heading) {
    RepresentationSettings settings = view.relief.settings;
    auto object = *view.in_another_way(Representation::ReliefBox, settings);
    const relief::Box box = box_round(object.ball);
    const relief::BoxRegion region = box_region(box, view.screen.eye);
    std::vector<Pane> panes;
    for (const relief::Face face : relief::all_faces) {
        const auto f = static_cast<std::size_t>(face);
        const relief::ReliefTexture& texture = object.textures[f];
        panes.push_back(
            {face_names[f], color_picture(texture.color, texture.coverage, view.loaded->settings.output)});
    }
    const ViewImage by_depth = *view.view(object);
    object.settings.composite = relief::Composite::FaceOrder;
    const ViewImage by_order = *view.view(object);
    Picture faces(by_depth.width(), by_depth.height());
    std::array<std::int64_t, 7> pixels{};
    for (int y = 0; y < faces.height(); ++y)
        for (int x = 0; x < faces.width(); ++x) {
            const std::uint8_t label = by_depth.coverage.at(x, y);
            ++pixels[label];
            faces.at(x, y) = label ? accent(label - 1u) : empty_pixel(x, y, faces.width());
        }
    panes.push_back({"who drew it", faces});
    panes.push_back({"nearest wins", colors_of(view, by_depth)});
    panes.push_back({"in order of faces", colors_of(view, by_order)});
    PanelBlock where{"Viewer",
                     {pair("region", fmt::format("{} of 26", region.number())),
                      pair("faces in front", std::to_string(region.faces()))}};
    PanelBlock who{"Pixels by face", {}};
    for (std::size_t f = 0; f < 6; ++f)
        who.rows.push_back(sample(
            Row::Square, accent(f),
            std::string(face_names[f]) + (region.shows(static_cast<relief::Face>(f)) ? ", in front" : ""),
            grouped(pixels[f + 1]) + " px"));
    std::optional<Count> unseen;
    if (const raster::Scene& shape = *view.object->models; !shape.models.empty()) {
        std::vector<relief::ReliefCamera> cameras;
        for (const relief::ReliefTexture& texture : object.textures) cameras.push_back(texture.camera);
        const auto seen = relief::seen_triangles(shape, cameras, view.loaded->settings.cull);
        const auto all = std::int64_t(seen.size()),
                   never = std::int64_t(std::count(seen.begin(), seen.end(), 0));
        where.rows.push_back(pair("never seen", grouped(never)));
        where.rows.push_back(
            quiet(fmt::format("of {} triangles: those that no texel of any face shows.", grouped(all))));
        unseen = Count{"triangles_no_face_sees", never};
    }
    const relief::ErrorSet depth_error = error_set(by_depth, view.truth),
                           order_error = error_set(by_order, view.truth);
    PanePage page = pane_page(
        heading,
        {where, who, error_block("Nearest wins", depth_error), error_block("Order of faces", order_error)}, 3,
        panes);
    page.stage.counts = {{"region", std::int64_t(region.number())},
                         {"faces_in_front", std::int64_t(region.faces())}};
    if (unseen) page.stage.counts.push_back(*unseen);
    add_counts(page.stage, "nearest", depth_error);
    add_counts(page.stage, "order", order_error);
    return std::move(page.stage);
}

}  // namespace relevo::show
