// relevo list: what there is, a sentence each.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "samples/io/suggest.hpp"
#include "samples/relevo/commands.hpp"
#include "samples/scene/accuracy.hpp"
#include "samples/scene/choices.hpp"
#include "samples/scene/generators.hpp"
#include "samples/scene/relief_objects.hpp"
#include "samples/show/relief_stages.hpp"

namespace relevo::command {
namespace {

struct Item {
    std::string_view name, sentence;
};

constexpr Item stages[] = {
    {"object", "each mesh in its own coordinates"},
    {"world", "all meshes where their transforms put them, with camera and lights"},
    {"eye", "the world as the camera has it: eye in the origin, looking down -z"},
    {"clip", "homogeneous coordinates: what crosses which plane of the view volume"},
    {"clipped", "the triangles cut at the planes of the view volume"},
    {"ndc", "after the division by w: the view volume is a box"},
    {"window", "the wire frame in pixels, corners snapped to 1/256 pixel"},
    {"culled", "which faces look away and are dropped"},
    {"coverage", "which triangle covers which pixel centre"},
    {"depth", "the depth buffer: what is nearest"},
    {"visibility", "which triangle each pixel shows, and how often the textbook path shaded it"},
    {"attributes", "barycentric weights, normals, texture coordinates and 1/w, interpolated"},
    {"flat", "one light equation a face"},
    {"gouraud", "one light equation a corner, colours interpolated"},
    {"phong", "one light equation a pixel, normals interpolated"},
    {"texture", "the texture alone, looked up with the interpolated coordinates"},
    {"final", "the picture that render writes"},
};

constexpr Item algorithms[] = {
    {"transforms",
     "translate, scale, rotate, look-at in double, rounded once; normals by the cofactor matrix"},
    {"projections", "perspective, frustum, orthographic; depth 0..1, reversed or forward"},
    {"clipping", "homogeneous, Sutherland and Hodgman 1974, in double; shared edges get bit-equal corners"},
    {"snapping", "window coordinates to 1/256 pixel, ties to even"},
    {"culling", "by the sign of the snapped area"},
    {"coverage", "exact integer edge functions (Pineda 1988) with the top-left rule"},
    {"depth test", "nearer wins, at equal depth the first triangle wins"},
    {"interpolation", "barycentric weights from the exact edge values, corrected once for the perspective"},
    {"shading", "unlit, flat, Gouraud 1971, Phong 1975: one light equation in four places"},
    {"texture", "nearest and bilinear with 8-bit weights, summed exactly in integers"},
    {"colour", "linear light; sRGB codes by a table of exact thresholds"},
};

// Of lessons. Those that a scene names stand in samples/scene/choices.hpp.
constexpr Item clipping_algorithms[] = {
    {"split bridges", "cuts what Sutherland and Hodgman leave of a concave area into separate polygons"},
    {"curve clipping", "box, quadrant and octant tests, then pixel by pixel (section 4.2)"},
};
constexpr Item smoothing_algorithms[] = {
    {"curve coverage", "the exact area of discs and rings in each pixel"},
    {"even weight", "thin lines dimmed by their slope, so that all look equally thick"},
    {"over", "a colour laid over the picture by opacity and coverage (Porter and Duff 1984)"},
};

constexpr Item events[] = {
    {"VertexTransformed",
     "a vertex went through the transforms: object, eye and clip coordinates, clip codes"},
    {"TriangleRejected", "a triangle or piece ended: NonFinite, Outside, ZeroArea, Culled or NoPixel"},
    {"TriangleClipped", "a triangle crossed near, far or the guard band; the polygon that is left"},
    {"EdgeCrossed", "an edge of the clipped triangle crosses a plane: the new corner"},
    {"PolygonClipped", "one plane of the view volume is done: corners before and after"},
    {"TriangleSnapped", "a triangle or piece reached the window with an area: corners, area, facing"},
    {"FragmentCovered", "a pixel centre belongs to a triangle"},
    {"DepthTested", "its depth was compared with the stored one"},
    {"FragmentShaded", "it was lit and written: weights, interpolated values, colour"},
};

constexpr Item lesson_events[] = {
    {"ShapeStarted", "a shape of a lesson begins"},
    {"ShapeRefused", "a shape was left out: a coordinate, radius or width is too large or not finite"},
    {"ShapeClipped", "the window cut an area or a smooth line: corners before and after"},
    {"SpanPainted", "a run of pixels got the shape's colour by one coverage"},
    {"LineStarted", "midpoint line: its direction, the first d, what a step adds to it"},
    {"LineStep", "midpoint line: d, the candidates, the midpoint, the choice"},
    {"DdaStarted", "DDA: the slope"},
    {"DdaStep", "DDA: the sum and the pixel nearest to it"},
    {"ExplicitStarted", "explicit line: a and B of y = a x + B"},
    {"ExplicitColumn", "explicit line: y of a column, and its pixel"},
    {"SlopeUndefined", "explicit line: it is upright, and there is no slope"},
    {"WuStarted", "smooth line of Wu: its direction"},
    {"WuPair", "smooth line of Wu: two pixels share the light of a column"},
    {"GuptaSproullStarted", "smooth line by a cone: its width and angle"},
    {"GuptaSproullColumn", "smooth line by a cone: where it passes a column"},
    {"GuptaSproullPixel", "smooth line by a cone: distance, table, ends, coverage of a pixel"},
    {"CircleStarted", "a circle begins: centre and radius"},
    {"CircleStep", "circle: d at a pixel of the octant, E or SE"},
    {"CircleSecondOrderStep", "circle: d and both its increments"},
    {"CirclePart", "the clipper kept, dropped or cut a circle, quadrant or octant"},
    {"EllipseStarted", "an ellipse begins: centre, radii, where region 1 ends"},
    {"EllipseStep", "ellipse: the region, d at a pixel, the choice"},
    {"EllipseTurned", "ellipse: region 2 begins, and d is computed anew"},
    {"EllipseSecondOrderStep", "ellipse: d and the parts of its increment"},
    {"EllipseGradient", "the textbook's ellipse: its test for the end of region 1"},
    {"EllipseStopped", "the textbook's ellipse: where it ended, and where it should have"},
    {"DiscRow", "a row of a filled circle or ellipse"},
    {"CurveRow", "a row of a smooth disc or ring: half widths and area"},
    {"RectangleBounded", "the pixels of a rectangle"},
    {"TriangleClassified", "corners from top to bottom, and on which side the long edge is"},
    {"TriangleEdgeStarted", "an edge of a triangle begins to bound the rows"},
    {"TriangleRow", "a row between two edges of a triangle"},
    {"EdgeTableBuilt", "polygon: the edges sorted by their first row"},
    {"EdgeEnters", "polygon: an edge becomes active"},
    {"EdgeLeaves", "polygon: an edge has ended"},
    {"RowCrossed", "polygon: the active edges of a row, from left to right"},
    {"PolygonSpan", "polygon: pixels between two edges, and their winding number"},
    {"EdgeShared", "area coverage: the share that an edge gives to a pixel"},
    {"RunCovered", "coverage of a run of pixels by area, weight or samples"},
    {"SamplesInside", "a run of sample points lies inside of the shape"},
    {"PixelResolved", "multisample: a pixel became the average of its points"},
    {"ClipRefused", "a clipper refused: a number that is not finite, or no such window"},
    {"OutcodesCompared", "Cohen-Sutherland: the codes of both ends"},
    {"SideCrossed", "Cohen-Sutherland: an end moves to a side of the window"},
    {"SideParameterFound", "Cyrus-Beck: normal, numerator, denominator and t of a side"},
    {"BoxParameterFound", "Liang-Barsky: numerator, denominator and t of a side"},
    {"SegmentHalved", "midpoint subdivision: the middle and its code"},
    {"ShapeEdgeClassified", "Sutherland-Hodgman: entering, inside, leaving or outside (fig. 4.7)"},
    {"ShapePointEmitted", "Sutherland-Hodgman: a corner or crossing goes into the result (fig. 4.8)"},
    {"ShapeSideDone", "Sutherland-Hodgman: the polygon after one side (fig. 4.6)"},
    {"ShapeStageHolds", "Sutherland-Hodgman as a pipeline: what a stage remembers"},
    {"BridgeRemoved", "two edges that lie upon each other are cut out"},
    {"PieceFound", "a polygon that came apart"},
    {"OutlinesMeet", "Greiner-Hormann: the outlines meet; entering, leaving or touching"},
    {"OutlineWalked", "Greiner-Hormann: a stretch of the result, along which outline"},
};

constexpr Item formats[] = {
    {".toml", "scenes, read"},
    {".obj", "Wavefront meshes with materials (.mtl), read"},
    {".solid", "the textbook's two formats for solids (sections 2.4 and 10), read and written"},
    {".png", "pictures, written (those of a lesson's steps are animated); read as textures"},
    {"images", "textures of every format that OpenImageIO reads: JPEG, TIFF, EXR, ..."},
    {".exr", "the depth buffer as 32-bit float, written by --raw-depth; channels of a relief texture"},
    {"relief .json", "a relief texture: its camera, and pictures beside it (EXR or PNG), read and written"},
    {".json", "counts and captions of steps, states of lessons, milliseconds, --stats=json, written"},
    {".csv", "the states of a lesson, a row a moment, written by steps"},
    {".html", "the pages of steps: pictures of stages, lessons moment by moment, written"},
};

void print(const Item& item, int indent = 0, int column = 18) {
    say("{:{}}{:<{}}  {}\n", "", indent, item.name, column - indent, item.sentence);
}

void print_all(std::span<const Item> items) {
    for (const Item& item : items) print(item);
}

template <class Meaning, std::size_t count>
void print_knob(std::string_view key, const scene::Choice<Meaning> (&choices)[count], Meaning standard) {
    say("{}\n", key);
    for (const auto& choice : choices) {
        print({choice.name, choice.sentence}, 2);
        if (choice.meaning == standard) say("{:20}(the default)\n", "");
    }
}

void list_stages() {
    print_all(stages);
    say("\nOf objects that are shown by pictures (representation, surface):\n");
    for (const show::ReliefStageInfo& stage : show::relief_stages())
        print({stage.name, stage.sentence}, 2, 24);
}

template <class Meaning, std::size_t count>
void print_choices(const scene::Choice<Meaning> (&choices)[count]) {
    for (const auto& choice : choices) print({choice.name, choice.sentence}, 2);
}

void list_algorithms() {
    print_all(algorithms);
    say("\nReliefs, [[object]] representation = \"name\":\n");
    print_choices(scene::representations);
    say("\nReliefs, [object.relief] resampler = \"name\":\n");
    print_choices(scene::resamplers);
    say("\nReliefs, [object.relief] search = \"name\":\n");
    print_choices(scene::searches);
    say("\nLessons, [[shape2d]] algorithm = \"name\":\n");
    print_choices(scene::scan_algorithms);
    say("\nLessons, [[shape2d]] antialiasing = \"name\":\n");
    print_choices(scene::antialiasings);
    for (const Item& item : smoothing_algorithms) print(item, 2);
    say("\nLessons, [clip] lines = \"name\":\n");
    print_choices(scene::line_clippers);
    say("\nLessons, [clip] polygons = \"name\":\n");
    print_choices(scene::polygon_clippers);
    for (const Item& item : clipping_algorithms) print(item, 2);
}

void list_events() {
    print_all(events);
    say("\nLessons:\n");
    for (const Item& item : lesson_events) print(item, 2, 24);
}

void list_formats() {
    print_all(formats);
    say("\nShapes made by Relevo itself (mesh = \"name\"):\n");
    for (const scene::Generator& generator : scene::generators())
        print({generator.name, generator.sentence}, 2);
    say("\nSurfaces that rays are cast at (surface = \"name\"):\n");
    for (const scene::SurfaceInfo& surface : scene::surfaces()) print({surface.name, surface.sentence}, 2);
}

// "midpoint, dda, ...": the first is the default.
std::string algorithm_names(raster::ShapeKind kind) {
    std::vector<std::string_view> names;
    for (const raster::ScanAlgorithm algorithm : scene::algorithms_of(kind))
        names.push_back(scene::name_of(algorithm, scene::scan_algorithms));
    return fmt::format("{}", fmt::join(names, ", "));
}

void list_knobs() {
    constexpr raster::Settings standard;
    say("Keys of [pipeline] in a scene, and of --set key=value:\n\n");
    print_knob("shading", scene::shadings, standard.shading);
    print_knob("texture_filter", scene::texture_filters, standard.texture_filter);
    print_knob("depth", scene::depth_formats, standard.depth);
    print_knob("cull", scene::culls, standard.cull);
    print_knob("path", scene::paths, standard.path);
    print_knob("instruction_set", scene::instruction_sets, standard.instruction_set);
    constexpr relief::RepresentationSettings relief;
    say("\nKeys of [object.relief]:\n\n");
    print_knob("resampler", scene::resamplers, relief.prewarp.resampler);
    print_knob("jump", scene::jumps, relief.prewarp.jump);
    print_knob("source", scene::relief_sources, relief.projection);
    print_knob("bits", scene::depth_bits, relief.bits);
    print_knob("light", scene::relief_lights, relief.lit);
    print_knob("reading", scene::readings, relief.reading);
    print_knob("search", scene::searches, relief.search);
    print_knob("end", scene::solid_ends, relief.end);
    print_knob("composite", scene::composites, relief.composite);
    say("\nKeys of [pipeline] in a lesson, for all shapes that say nothing themselves:\n\n");
    print_knob("fill_rule", scene::fill_rules, raster::FillRule::TopLeft);
    say("algorithm\n");
    for (const auto& kind : scene::shape_kinds) print({kind.name, algorithm_names(kind.meaning)}, 2);
    print_knob("antialiasing", scene::antialiasings, raster::Antialiasing::None);
    say("samples\n{:2}1 to 16  along each side of a pixel, of supersample and multisample\n{:20}(4 is the "
        "default)\n",
        "", "");
}

// Columns as wide as their longest entry.
void list_accuracy() {
    const auto width = [](std::string_view title, auto column) {
        std::size_t widest = title.size();
        for (const scene::AccuracyRow& row : scene::accuracy_table())
            widest = std::max(widest, column(row).size());
        return widest;
    };
    using Row = scene::AccuracyRow;
    const std::size_t name = width("approximation", [](const Row& row) { return row.name; });
    const std::size_t reference = width("compared with", [](const Row& row) { return row.reference; });
    const std::size_t domain = width("for", [](const Row& row) { return row.domain; });
    const std::size_t unit = width("times", [](const Row& row) { return row.unit; });
    const auto line = [&](auto... columns) {
        say("{:<{}}  {:<{}}  {:<{}}  {:>9}  {:<{}}  {:>12}\n", columns...);
    };
    line("approximation", name, "compared with", reference, "for", domain, "error <=", "times", unit,
         "instructions");
    for (const Row& row : scene::accuracy_table())
        line(row.name, name, row.reference, reference, row.domain, domain,
             fmt::format("{:.4g}", row.allowed_error), row.unit, unit, row.instructions);
}

struct List {
    std::string_view name;
    void (*print)();
};
constexpr List lists[] = {{"stages", list_stages},
                          {"knobs", list_knobs},
                          {"algorithms", list_algorithms},
                          {"events", list_events},
                          {"formats", list_formats}};

int list_one(const std::string& what) {
    std::vector<std::string_view> names;
    for (const List& list : lists) {
        if (list.name == what) return list.print(), done;
        names.push_back(list.name);
    }
    return refuse(
        io::FileError{{"relevo list " + what, 0, 0},
                      fmt::format("accepted: {}{}", fmt::join(names, ", "), io::suggestion(what, names))});
}

int list(const std::string& what, bool accuracy) {
    if (accuracy && what != "knobs")
        return refuse(
            io::FileError{{"relevo list --accuracy", 0, 0}, "accepted: relevo list knobs --accuracy"});
    if (accuracy) return list_accuracy(), done;
    if (!what.empty()) return list_one(what);
    for (const List& each : lists) {
        say("{}{}\n", &each == lists ? "" : "\n", each.name);
        each.print();
    }
    return done;
}

}  // namespace

void add_list(CLI::App& app, int& status) {
    struct Options {
        std::string what;
        bool accuracy = false;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* const command = app.add_subcommand("list", "Tell what there is, a sentence each.");
    command->add_option("WHAT", options->what, "stages, knobs, algorithms, events or formats; default: all.")
        ->type_name("");
    command->add_flag("--accuracy", options->accuracy,
                      "With knobs: the table of approximations and their errors.");
    command->footer("Example: relevo list knobs --accuracy");
    command->callback([options, &status] { status = list(options->what, options->accuracy); });
}

}  // namespace relevo::command
