#include "samples/scene/relief_objects.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "samples/io/suggest.hpp"
#include "samples/scene/shapes/spheres.hpp"

namespace relevo::scene {
namespace {

using relief::Representation;
using enum relief::Representation;

constexpr SurfaceInfo all_surfaces[] = {
    {"sphere", "a ball of radius 1"},
    {"bumpy", "a ball with 60 small ones on it, all in the ball of radius 1"},
    {"complex", "40 balls that hide much of each other, all in the ball of radius 1"},
    {"plane-step", "a checkered square with straight lines across a step; step = its height"},
    {"checker-cube", "a checkered cube, turned"},
};

// A key of [object.relief] and the representations that it means something to.
struct Key {
    std::string_view name;
    std::vector<Representation> of;  // empty: all
};
const std::vector<Key>& all_keys() {
    static const std::vector<Representation> one_plane = {Relief,      ReliefInverse, Sprite,
                                                          SpriteDepth, Ldi,           Morph},
                                             warped = {Relief,    SpriteDepth, ReliefInverse,
                                                       ReliefBox, Ldi,         Morph};
    static const std::vector<Key> keys = {
        {"texels", {}},
        {"radius", {}},
        {"light", {Relief, ReliefBox, ReliefInverse, Sprite, SpriteDepth, Morph}},
        {"bits", {Relief, ReliefBox, ReliefInverse, SpriteDepth}},
        {"azimuth", one_plane},
        {"elevation", one_plane},
        {"source", {Relief, ReliefInverse, Sprite, Ldi}},
        {"distance", {Relief, ReliefInverse, Sprite, Ldi, Morph}},
        {"jump_depth", warped},
        {"resampler", {Relief}},
        {"jump", {Relief}},
        {"depth_test", {Relief}},
        {"reading", {Relief, ReliefInverse, Sprite, SpriteDepth}},
        {"search", {ReliefInverse}},
        {"slices", {ReliefInverse}},
        {"bisections", {ReliefInverse}},
        {"end", {ReliefInverse}},
        {"thickness", {ReliefInverse}},
        {"composite", {ReliefBox}},
        {"layers", {Ldi}},
        {"morphing", {Morph}},
        {"aside", {Morph}},
    };
    return keys;
}
bool belongs(const Key& key, Representation representation) {
    return key.of.empty() || std::find(key.of.begin(), key.of.end(), representation) != key.of.end();
}

void read_source(const Fields& fields, Representation representation, relief::RepresentationSettings& out) {
    constexpr Range elevations{-90, 90, false, false, "-90 to 90 degrees"};
    constexpr Range outside{1, largest_number, true, false, "more than 1 (radii of the ball)"};
    out.azimuth = {fields.number("azimuth", 0)};
    out.elevation = {fields.number("elevation", 0, elevations)};
    out.projection = fields.choice("source", out.projection, relief_sources);
    out.distance = fields.number("distance", out.distance, outside);
    out.texels = fields.whole("texels", out.texels, 1, 2048);
    // far enough from the ends of float32 that a texel and the square of a distance lie between them
    constexpr Range radius{1e-15, 1e15, false, false, "1e-15 to 1e15"};
    out.radius = fields.number("radius", 0, radius);
    out.bits = fields.choice("bits", out.bits, depth_bits);
    out.lit = fields.choice("light", out.lit, relief_lights);
    out.reading = fields.choice("reading", out.reading, readings);
    if (fields.has("distance") && representation != Morph &&
        out.projection != relief::Projection::Perspective)
        fields.diagnosis().say(fields.place("distance"),
                               fields.full("distance") + " is for source = \"perspective\" only");
}

void read_search(const Fields& fields, relief::RepresentationSettings& out) {
    const bool parallel = out.projection == relief::Projection::Orthographic;
    out.search = fields.choice("search", out.search, searches);
    // Maps of cones cost the fourth power of the texels along a side, and more.
    const int most = out.search == relief::Search::Cones          ? 512
                     : out.search == relief::Search::RelaxedCones ? 128
                                                                  : out.texels;
    if (!fields.has("texels")) out.texels = std::min(out.texels, most);
    if (out.texels > most)
        fields.refuse("texels", fmt::format("with search = \"{}\": a whole number from 1 to {}",
                                            name_of(out.search, searches), most));
    out.slices.slices = fields.whole("slices", out.slices.slices, 1, 65536);
    out.slices.bisections = fields.whole("bisections", out.slices.bisections, 0, 64);
    out.end =
        fields.choice("end", parallel ? relief::SolidEnd::Back : relief::SolidEnd::Thickness, solid_ends);
    out.thickness = fields.number("thickness", out.thickness, positive);
    if (!parallel && out.end == relief::SolidEnd::Back)
        fields.refuse("end", "with source = \"perspective\": thickness, none");
    if (fields.has("thickness") && out.end != relief::SolidEnd::Thickness)
        fields.diagnosis().say(fields.place("thickness"),
                               fields.full("thickness") + " is for end = \"thickness\" only");
    const bool exact = out.search == relief::Search::Texels || out.search == relief::Search::Cones;
    if (exact && out.reading == relief::Reading::Bilinear && fields.has("reading"))
        fields.refuse("reading", "with search = \"texels\" or \"cones\": nearest");
    if (out.search != relief::Search::Slices) out.reading = relief::Reading::Nearest;
}

}  // namespace

std::span<const SurfaceInfo> surfaces() { return all_surfaces; }

relief::AnalyticSurface find_surface(const Fields& object, Diagnosis& diagnosis) {
    const std::string name = object.text("surface", "");
    if (name != "plane-step" && object.has("step"))
        diagnosis.say(object.place("step"), "object.step is for surface = \"plane-step\" only");
    if (name == "sphere") return sphere_object;
    if (name == "bumpy") return bumpy_object;
    if (name == "complex") return complex_object;
    if (name == "plane-step") return relief::PlaneStep{object.number("step", 0.5, positive)};
    if (name == "checker-cube") return relief::CheckerCube{};
    std::vector<std::string_view> names;
    for (const SurfaceInfo& surface : all_surfaces) names.push_back(surface.name);
    object.refuse("surface", joined(names) + io::suggestion(name, names));
    return relief::Spheres{};
}

relief::RepresentationSettings read_relief(const Fields& object, Representation representation,
                                           Diagnosis& diagnosis) {
    relief::RepresentationSettings out;
    const Value* table = object.find("relief");
    if (table && representation == Geometry)
        diagnosis.say(object.place("relief"),
                      "object.relief has no meaning for representation = \"geometry\", which is the default");
    if (!table || !diagnosis.fine()) return out;
    std::vector<std::string_view> known;
    for (const Key& key : all_keys())
        if (belongs(key, representation)) known.push_back(key.name);
    const Fields fields(*table, object.full("relief"), known, diagnosis);
    read_source(fields, representation, out);
    out.prewarp.resampler = fields.choice("resampler", out.prewarp.resampler, resamplers);
    out.prewarp.jump = fields.choice("jump", out.prewarp.jump, jumps);
    out.prewarp.jump_depth =
        static_cast<pipeline::Scalar>(fields.number("jump_depth", double{out.prewarp.jump_depth}, positive));
    out.prewarp.depth_test = fields.flag("depth_test", false);
    if (representation == ReliefInverse) read_search(fields, out);
    out.composite = fields.choice("composite", out.composite, composites);
    out.layers = fields.whole("layers", out.layers, 1, 16);
    constexpr Range beside{0, 60, true, false, "more than 0, up to 60 degrees"};
    out.morphing = fields.choice("morphing", out.morphing, morphings);
    out.aside = {fields.number("aside", out.aside.value, beside)};
    return out;
}

}  // namespace relevo::scene
