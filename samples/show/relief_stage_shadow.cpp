// The shadow that a relief casts on itself: a second search, from the surface to the light.
#include "relief/inverse_slices.hpp"
#include "relief/self_shadow.hpp"
#include "samples/show/relief_stages.hpp"
#include "samples/show/tones.hpp"

namespace relevo::show {
namespace {

using relief::Illumination;
using relief::ReliefLight;
using relief::Represented;
using relief::ViewImage;

constexpr Rgba8 arrives{240, 214, 120}, turned_away{62, 84, 128}, blocked = vermilion;

ReliefLight place_of(const pipeline::Light& light) {
    if (light.kind == pipeline::Light::Kind::Point) return {{glm::dvec3(light.position.v), 1}};
    return {{-glm::dvec3(light.direction.v), 0}};
}

Picture map_of(const relief::Image<Illumination>& seen) {
    Picture out(seen.width(), seen.height());
    for (int y = 0; y < out.height(); ++y)
        for (int x = 0; x < out.width(); ++x) {
            const Illumination here = seen.at(x, y);
            out.at(x, y) = here == Illumination::Lit          ? arrives
                           : here == Illumination::TurnedAway ? turned_away
                           : here == Illumination::Blocked    ? blocked
                                                              : empty_pixel(x, y, out.width());
        }
    return out;
}
std::int64_t pixels_of(const relief::Image<Illumination>& seen, Illumination which) {
    return std::count(seen.pixels().begin(), seen.pixels().end(), which);
}

// The object with its texture, solid and way to search it.
Represented solid_object(const ReliefView& view) {
    relief::RepresentationSettings settings = view.relief.settings;
    if (settings.projection == relief::Projection::Perspective) settings.end = relief::SolidEnd::Thickness;
    settings.search = relief::Search::Slices;
    settings.slices = {128, 8};
    return *view.in_another_way(relief::Representation::ReliefInverse, settings);
}

// The picture without its first light where that light is blocked.
ViewImage with_shadow(const ReliefView& view, const Represented& object, ViewImage lit,
                      const relief::Image<Illumination>& seen) {
    raster::Scene others = view.loaded->scene;
    others.lights.erase(others.lights.begin());
    const ViewImage dark = *view_of(object, view.screen, others, view.loaded->settings);
    for (std::size_t i = 0; i < seen.pixels().size(); ++i)
        if (seen.pixels()[i] == Illumination::Blocked) lit.color.pixels()[i] = dark.color.pixels()[i];
    return lit;
}

}  // namespace

StagePage draw_relief_shadow(const ReliefView& view, const Heading& heading) {
    const ReliefLight light = place_of(view.loaded->scene.lights.front());
    const Represented object = solid_object(view);
    const relief::ReliefSolid& solid = *object.solid;
    const auto seen = *inverse_shadows(
        object.textures[0], solid, view.screen,
        [&](const relief::ReliefRay& ray) { return find_by_slices(solid, ray, object.settings.slices); },
        light);
    const ViewImage lit = *view.view(object), shadowed = with_shadow(view, object, lit, seen);

    const std::int64_t in_light = pixels_of(seen, Illumination::Lit),
                       away = pixels_of(seen, Illumination::TurnedAway),
                       in_shadow = pixels_of(seen, Illumination::Blocked), all = in_light + away + in_shadow;
    using Row = PanelRow::Kind;
    PanelBlock what{"The first light",
                    {sample(Row::Square, arrives, "arrives", share(in_light, all)),
                     sample(Row::Square, turned_away, "behind", share(away, all)),
                     sample(Row::Square, blocked, "blocked", share(in_shadow, all))}};
    const PanelBlock how{
        "Search",
        {quiet("From the point that a line of sight found, a second search follows the line of light. In "
               "the texture's u, v and depth that is a straight line, too."),
         quiet("What the source did not see casts no shadow; what its pillars fill without being there "
               "casts too much.")}};
    const raster::Output output = view.loaded->settings.output;
    const auto colors = [&](const ViewImage& image) {
        return color_picture(image.color, image.coverage, output);
    };
    std::vector<Pane> panes{{"lit", colors(lit)},
                            {"lit, with its shadow", colors(shadowed)},
                            {"what the light does", map_of(seen)}};
    StagePage counted;
    counted.counts = {{"lit", in_light}, {"turned_away", away}, {"blocked", in_shadow}};
    if (view.object->surface) {
        const auto truth = cast_shadows(*view.object->shape().surface, view.screen, light);
        const std::int64_t wrong = shadow_error(seen, truth).wrong;
        panes.push_back({"the truth, by rays", map_of(truth)});
        what.rows.push_back(pair("wrong", share(wrong, all)));
        counted.counts.push_back({"wrong", wrong});
    }
    PanePage page = pane_page(heading, {what, how}, 2, panes);
    page.stage.counts = std::move(counted.counts);
    return std::move(page.stage);
}

}  // namespace relevo::show
