#include "samples/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <tuple>

#include "samples/io/file.hpp"
#include "samples/io/suggest.hpp"
#include "samples/io/words.hpp"
#include "samples/scene/animation.hpp"
#include "samples/scene/camera.hpp"
#include "samples/scene/objects.hpp"
#include "samples/scene/shapes2d.hpp"

namespace relevo::scene {
namespace {

using pipeline::max_picture_size;
using pipeline::Scalar;

constexpr std::string_view tables[] = {"image", "camera", "light",   "object",  "animation",
                                       "axes",  "clip",   "shape2d", "pipeline"};
constexpr std::string_view image_keys[] = {"width", "height", "background", "output"};
constexpr std::string_view light_keys[] = {"type", "position", "direction", "color"};
constexpr std::string_view pipeline_keys[] = {"shading", "texture_filter", "depth",
                                              "cull",    "path",           "instruction_set"};

// The tables of the document: empty where the file has none.
struct Tables {
    Value image, camera, pipeline;
    std::optional<Value> animation, axes, clip;
    std::vector<Value> lights, objects, shapes;
    bool lesson() const { return !shapes.empty(); }
};

std::vector<Value> list_of_tables(const Entry& entry, Diagnosis& diagnosis) {
    if (const auto* list = std::get_if<std::vector<Value>>(&entry.value.data)) return *list;
    diagnosis.say(entry.place,
                  fmt::format("[{0}] is one table, accepted: [[{0}]], which may be repeated", entry.key));
    return {};
}

// A scene is made of objects or of shapes; the tables of the other kind have no place in it.
void refuse_foreign_tables(const Table& document, const Tables& found, Diagnosis& diagnosis) {
    constexpr std::string_view of_objects[] = {"camera", "light", "animation"},
                               of_shapes[] = {"axes", "clip"};
    const auto holds = [](std::span<const std::string_view> keys, std::string_view key) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    const bool both = found.lesson() && !found.objects.empty();
    for (const Entry& entry : document) {
        if (both && entry.key == "object")
            diagnosis.say(entry.place, "a scene is made of [[object]]s or of [[shape2d]]s, not of both");
        if (!both && found.lesson() && holds(of_objects, entry.key))
            diagnosis.say(entry.place,
                          entry.key + " is for [[object]]s, and this scene is made of [[shape2d]]s");
        if (!both && !found.objects.empty() && holds(of_shapes, entry.key))
            diagnosis.say(entry.place,
                          entry.key + " is for [[shape2d]]s, and this scene is made of [[object]]s");
    }
}

Tables split(const Value& document, const std::string& path, Diagnosis& diagnosis) {
    const Value empty{{path, 1, 1}, Table{}};
    Tables out{empty, empty, empty, {}, {}, {}, {}, {}, {}};
    for (const Entry& entry : std::get<Table>(document.data)) {
        if (entry.key == "image")
            out.image = entry.value;
        else if (entry.key == "camera")
            out.camera = entry.value;
        else if (entry.key == "pipeline")
            out.pipeline = entry.value;
        else if (entry.key == "animation")
            out.animation = entry.value;
        else if (entry.key == "axes")
            out.axes = entry.value;
        else if (entry.key == "clip")
            out.clip = entry.value;
        else if (entry.key == "light")
            out.lights = list_of_tables(entry, diagnosis);
        else if (entry.key == "object")
            out.objects = list_of_tables(entry, diagnosis);
        else if (entry.key == "shape2d")
            out.shapes = list_of_tables(entry, diagnosis);
        else
            diagnosis.say(entry.place,
                          fmt::format("unknown table or key {}, accepted: [image], [camera], [[light]], "
                                      "[[object]], [animation], [axes], [clip], [[shape2d]], [pipeline]{}",
                                      entry.key, io::suggestion(entry.key, tables)));
    }
    if (out.objects.empty() && out.shapes.empty())
        diagnosis.say({path, 0, 0},
                      "there is no [[object]] with a mesh and no [[shape2d]]: a scene needs at least one");
    refuse_foreign_tables(std::get<Table>(document.data), out, diagnosis);
    return out;
}

// "key=value" replaces or adds a key of [pipeline]; its place in messages is the option itself.
void apply_options(const std::vector<std::string>& options, std::span<const std::string_view> keys,
                   Value& pipeline, Diagnosis& diagnosis) {
    auto* table = std::get_if<Table>(&pipeline.data);
    for (const std::string& option : options) {
        const io::Place place{"--set " + option, 0, 0};
        const std::size_t equals = option.find('=');
        if (equals == std::string::npos || equals == 0)
            return diagnosis.say(place, "accepted: key=value, with a key of [pipeline]: " + joined(keys));
        const std::string key = option.substr(0, equals), text = option.substr(equals + 1);
        if (!table) return;
        std::erase_if(*table, [&](const Entry& entry) { return entry.key == key; });
        const auto number = io::parse_integer(text);
        table->push_back({key, place, number ? Value{place, *number} : Value{place, text}});
    }
}

void read_instruction_set(const Fields& fields, raster::Settings& settings) {
    settings.instruction_set = fields.choice("instruction_set", settings.instruction_set, instruction_sets);
    const auto there = raster::fast::instruction_sets();
    std::vector<std::string_view> names;
    for (const auto& choice : instruction_sets) {
        const bool found =
            !choice.meaning || std::find(there.begin(), there.end(), *choice.meaning) != there.end();
        if (found && choice.meaning == settings.instruction_set) return;
        if (found) names.push_back(choice.name);
    }
    fields.refuse("instruction_set", joined(names) + " (what this processor and this build have)");
}

raster::Settings read_pipeline(const Value& table, Diagnosis& diagnosis) {
    const Fields fields(table, "pipeline", pipeline_keys, diagnosis);
    raster::Settings settings;
    settings.shading = fields.choice("shading", settings.shading, shadings);
    settings.texture_filter = fields.choice("texture_filter", settings.texture_filter, texture_filters);
    settings.depth = fields.choice("depth", settings.depth, depth_formats);
    settings.cull = fields.choice("cull", settings.cull, culls);
    settings.path = fields.choice("path", settings.path, paths);
    read_instruction_set(fields, settings);
    return settings;
}

void read_image(const Value& table, std::span<const std::string_view> keys, LoadedScene& out,
                Diagnosis& diagnosis) {
    const Fields fields(table, "image", keys, diagnosis);
    out.width = fields.whole("width", out.width, 1, max_picture_size);
    out.height = fields.whole("height", out.height, 1, max_picture_size);
    out.scene.background = fields.color("background", out.scene.background, zero_to_one);
    out.settings.output = fields.choice("output", out.settings.output, outputs);
}

void refuse_size(const std::optional<std::pair<int, int>>& size, Diagnosis& diagnosis) {
    if (!size) return;
    const auto good = [](int n) { return 1 <= n && n <= max_picture_size; };
    if (!good(size->first) || !good(size->second))
        diagnosis.say(
            {fmt::format("--size {}x{}", size->first, size->second), 0, 0},
            fmt::format("accepted: WIDTHxHEIGHT, two whole numbers from 1 to {}", max_picture_size));
}

pipeline::Light read_light(const Value& table, const SceneCamera& camera, Diagnosis& diagnosis) {
    using Kind = pipeline::Light::Kind;
    const Fields fields(table, "light", light_keys, diagnosis);
    pipeline::Light light;
    light.kind = fields.choice("type", Kind::Point, light_types);
    light.color = fields.color("color", light.color, zero_or_more);
    const std::string_view foreign = light.kind == Kind::Point ? "direction" : "position";
    if (fields.has(foreign))
        diagnosis.say(fields.place(foreign),
                      fmt::format("{} is for type = \"{}\" only", fields.full(foreign),
                                  light.kind == Kind::Point ? "directional" : "point"));
    const glm::dvec3 lamp = lamp_position(camera);
    if (light.kind == Kind::Point) {
        light.position = {pipeline::Vec3(fields.triple("position", lamp))};
    } else {
        light.direction = {pipeline::Vec3(fields.triple("direction", camera.description.target - lamp))};
        if (light.direction.v == pipeline::Vec3(0, 0, 0))
            fields.refuse("direction", "the way the light travels, three numbers that are not all 0");
    }
    return light;
}

// Only a relief texture on its plane is defined for a viewer at infinity.
void refuse_parallel_views(const LoadedScene& scene, Diagnosis& diagnosis) {
    if (!scene.scene.camera.parallel) return;
    for (const ReliefObject& object : scene.reliefs)
        if (object.representation != relief::Representation::Relief)
            diagnosis.say(object.place,
                          fmt::format("{} by \"{}\" needs a viewer with an eye, accepted with "
                                      "projection = \"orthographic\": representation = \"relief\", and "
                                      "\"geometry\" of a mesh",
                                      object.name, name_of(object.representation, representations)));
}

// What lessons and scenes of objects have in common.
void read_picture(const Tables& found, const SceneOptions& options, LoadedScene& out, Diagnosis& diagnosis) {
    if (found.lesson())
        read_image(found.image, lesson_image_keys, out, diagnosis);
    else
        read_image(found.image, image_keys, out, diagnosis);
    refuse_size(options.size, diagnosis);
    if (options.size) std::tie(out.width, out.height) = *options.size;
}

void read_objects(const Tables& found, const std::string& path, LoadedScene& out, Diagnosis& diagnosis) {
    const auto encoding =
        out.settings.output == raster::Output::Srgb ? raster::Encoding::Srgb : raster::Encoding::Raw;
    ObjectReader objects(out, std::filesystem::path(path).parent_path().string(), encoding, diagnosis);
    for (const Value& object : found.objects)
        if (diagnosis.fine()) objects.read(object);
    if (!diagnosis.fine()) return;
    SceneCamera camera = read_camera(found.camera, double(out.width) / out.height, out.settings.depth,
                                     objects.all_models(), diagnosis);
    if (found.animation) out.animation = read_animation(*found.animation, camera, diagnosis);
    out.scene.camera = camera.camera;
    out.camera = camera.description;
    refuse_parallel_views(out, diagnosis);
    for (const Value& light : found.lights) out.scene.lights.push_back(read_light(light, camera, diagnosis));
    if (found.lights.empty())
        out.scene.lights.push_back(read_light(Value{{path, 1, 1}, Table{}}, camera, diagnosis));
    for (const ReliefObject& object : out.reliefs) object.models->lights = out.scene.lights;
}

// All tables in turn; the first thing that is wrong stays in `diagnosis`.
void read_tables(const Tables& found, const std::string& path, const SceneOptions& options, LoadedScene& out,
                 Diagnosis& diagnosis) {
    if (found.lesson()) {
        read_picture(found, options, out, diagnosis);
        read_lesson({found.image, found.pipeline, found.axes, found.clip, found.shapes}, options.size, out,
                    diagnosis);
    } else {
        out.settings = read_pipeline(found.pipeline, diagnosis);
        read_picture(found, options, out, diagnosis);
        read_objects(found, path, out, diagnosis);
    }
}

}  // namespace

io::FileResult<LoadedScene> parse_scene(std::string_view text, const std::string& path,
                                        const SceneOptions& options) {
    const auto document = parse_document(text, path);
    if (!document) return document.error();
    Diagnosis diagnosis;
    Tables tables_found = split(*document, path, diagnosis);
    const std::span<const std::string_view> keys =
        tables_found.lesson() ? std::span<const std::string_view>(lesson_pipeline_keys) : pipeline_keys;
    apply_options(options.set, keys, tables_found.pipeline, diagnosis);
    LoadedScene out;
    out.path = path;
    out.name = std::filesystem::path(path).stem().string();
    if (diagnosis.fine()) read_tables(tables_found, path, options, out, diagnosis);
    if (!diagnosis.fine()) return *diagnosis.error;
    return out;
}

io::FileResult<LoadedScene> load_scene(const std::string& path, const SceneOptions& options) {
    const auto text = io::read_text(path, std::size_t(16) << 20);
    if (!text) return text.error();
    return parse_scene(*text, path, options);
}

io::FileResult<std::pair<int, int>> parse_size(std::string_view text) {
    const io::FileError error{
        {"--size " + std::string(text), 0, 0},
        fmt::format("accepted: WIDTHxHEIGHT, two whole numbers from 1 to {}", max_picture_size)};
    const char* const end = text.data() + text.size();
    int width = 0, height = 0;
    const auto first = std::from_chars(text.data(), end, width);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != 'x') return error;
    const auto second = std::from_chars(first.ptr + 1, end, height);
    if (second.ec != std::errc() || second.ptr != end) return error;
    const auto good = [](int n) { return 1 <= n && n <= max_picture_size; };
    if (!good(width) || !good(height)) return error;
    return std::pair<int, int>{width, height};
}

relief::ShapeCapture shape_capture(const LoadedScene& scene, const ReliefObject& object) {
    return {object.shape(), scene.settings, object.material, false};
}

raster::Frame make_frame(const LoadedScene& scene) {
    raster::Frame frame;
    frame.color = raster::Image<raster::Rgba8>(scene.width, scene.height);
    frame.depth = raster::Image<Scalar>(scene.width, scene.height);
    return frame;
}

}  // namespace relevo::scene
