#include "samples/scene/objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "pipeline/transform.hpp"
#include "samples/io/obj.hpp"
#include "samples/io/picture.hpp"
#include "samples/io/solid.hpp"
#include "samples/io/suggest.hpp"
#include "samples/scene/framing.hpp"
#include "samples/scene/generators.hpp"
#include "samples/scene/relief_objects.hpp"
#include "samples/scene/shapes/cube.hpp"

namespace relevo::scene {
namespace {

using pipeline::Material;
using pipeline::Scalar;
using pipeline::World;
using WorldFromObject = pipeline::Affine<World, pipeline::Object>;
using Step = pipeline::Affine<World, World>;

constexpr std::string_view object_keys[] = {"mesh",   "surface", "name",     "transform", "representation",
                                            "relief", "step",    "material", "segments",  "tube",
                                            "repeat", "seed",    "height"};
constexpr std::string_view generator_keys[] = {"segments", "tube", "repeat", "seed", "height"};
constexpr std::string_view step_keys[] = {"scale", "rotate", "translate"};
constexpr std::string_view rotation_keys[] = {"axis", "degrees"};
constexpr std::string_view lit_material_keys[] = {"ambient", "diffuse", "specular", "shininess"};
constexpr std::string_view material_keys[] = {"ambient", "diffuse", "specular", "shininess",
                                              "color",   "texture", "two_sided"};

bool is_file_name(std::string_view mesh) { return mesh.find_first_of("./\\") != std::string_view::npos; }

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

Step scaling(const Fields& step) {
    const Value& value = *step.find("scale");
    const bool is_list = std::holds_alternative<std::vector<Value>>(value.data);
    const glm::dvec3 by = is_list ? step.triple("scale", {1, 1, 1}) : glm::dvec3(step.number("scale", 1));
    if (by == glm::dvec3(0, 0, 0)) step.refuse("scale", "a number other than 0, or three");
    return pipeline::scale<World>(by);
}

Step rotation(const Fields& step) {
    const Fields how(*step.find("rotate"), step.full("rotate"), rotation_keys, step.diagnosis());
    for (const std::string_view key : rotation_keys)
        if (!how.has(key)) how.refuse(key, "axis = [x, y, z] and degrees");
    const auto turned =
        pipeline::rotate<World>(how.triple("axis", {0, 1, 0}), pipeline::Degrees{how.number("degrees", 0)});
    if (turned) return *turned;
    how.refuse("axis", "a direction, three numbers that are not all 0");
    return {};
}

Step read_step(const Value& value, const std::string& name, Diagnosis& diagnosis) {
    const Fields step(value, name, step_keys, diagnosis);
    if (!diagnosis.fine()) return {};
    const bool scaled = step.has("scale"), turned = step.has("rotate"), moved = step.has("translate");
    if (scaled + turned + moved != 1) {
        diagnosis.say(value.place, name + " holds " +
                                       (scaled + turned + moved == 0 ? "nothing" : "several steps") +
                                       ", accepted: one of scale, rotate, translate");
        return {};
    }
    if (scaled) return scaling(step);
    if (turned) return rotation(step);
    return pipeline::translate<World>(step.triple("translate", {0, 0, 0}));
}

// The steps act from the first to the last: each new one is multiplied from the left.
WorldFromObject read_transform(const Fields& object) {
    WorldFromObject world_from_object;
    const Value* value = object.find("transform");
    if (!value) return world_from_object;
    const auto* steps = std::get_if<std::vector<Value>>(&value->data);
    if (!steps)
        object.refuse("transform", "a list of steps, as in [ { scale = 2 }, { translate = [0, 1, 0] } ]");
    for (std::size_t i = 0; steps && i < steps->size(); ++i)
        world_from_object =
            read_step((*steps)[i], fmt::format("{}[{}]", object.full("transform"), i), object.diagnosis()) *
            world_from_object;
    return world_from_object;
}

// The keys that are given replace those of `base`.
Material read_material(const Fields& fields, Material base) {
    const auto number = [&](std::string_view key, Scalar fallback, const Range& range) {
        return static_cast<Scalar>(fields.number(key, fallback, range));
    };
    base.ambient = number("ambient", base.ambient, zero_to_one);
    base.diffuse = number("diffuse", base.diffuse, zero_to_one);
    base.specular = number("specular", base.specular, zero_to_one);
    base.shininess = number("shininess", base.shininess, zero_or_more);
    base.color = fields.color("color", base.color, zero_to_one);
    return base;
}

// A parameter that the shape does not have would be silently without effect.
void refuse_foreign_parameters(const Fields& object, std::string_view kind, std::string_view mesh,
                               std::span<const std::string_view> accepted) {
    for (const std::string_view key : generator_keys)
        if (object.has(key) && std::find(accepted.begin(), accepted.end(), key) == accepted.end())
            object.diagnosis().say(
                object.place(key),
                fmt::format("{} is no parameter of {} = \"{}\", accepted: {}", object.full(key), kind, mesh,
                            accepted.empty() ? "none" : joined(accepted)));
}

}  // namespace

void ObjectReader::read(const Value& table) {
    const Fields object(table, "object", object_keys, diagnosis_);
    const WorldFromObject world_from_object = read_transform(object);
    if (!diagnosis_.fine()) return;
    if (object.has("surface")) return read_surface(object, world_from_object);
    if (object.has("step"))
        diagnosis_.say(object.place("step"), "object.step is for surface = \"plane-step\" only");
    ReliefObject relief = relief_object(object);
    const bool as_it_is = relief.representation == relief::Representation::Geometry;
    for (const Part& part : find_parts(object)) {
        if (part.transparent && !as_it_is)
            diagnosis_.say(
                relief.place,
                fmt::format("{} is of a transparent material, and pictures with depth know one "
                            "surface a texel, accepted: representation = \"geometry\" (drawn opaque)",
                            part.description.name));
        add_model(part, object, world_from_object, as_it_is ? scene_.scene.models : relief.models->models);
    }
    if (as_it_is || !diagnosis_.fine()) return;
    relief.material = relief.models->models.front().material;
    if (relief.name.empty()) relief.name = object.text("mesh", "");
    scene_.reliefs.push_back(std::move(relief));
}

ReliefObject ObjectReader::relief_object(const Fields& object) {
    ReliefObject relief;
    relief.name = object.text("name", "");
    relief.place = object.place(object.has("representation") ? "representation" : "");
    relief.representation = object.choice("representation", relief.representation, representations);
    relief.settings = read_relief(object, relief.representation, diagnosis_);
    relief.models = std::make_unique<raster::Scene>();
    return relief;
}

void ObjectReader::read_surface(const Fields& object, const WorldFromObject& world_from_surface) {
    if (object.has("mesh"))
        diagnosis_.say(object.place("surface"), "an object has a mesh or a surface, not both");
    refuse_foreign_parameters(object, "surface", object.text("surface", ""), {});
    ReliefObject relief = relief_object(object);
    const relief::AnalyticSurface surface = find_surface(object, diagnosis_);
    if (!(std::fabs(glm::determinant(world_from_surface.m)) > 0))
        diagnosis_.say(
            object.place("transform"),
            "object.transform flattens the surface or shrinks it to nothing: it must have an inverse");
    const Value none{object.place(""), Table{}};
    const Value* given = object.find("material");
    const Fields fields(given ? *given : none, object.full("material"), lit_material_keys, diagnosis_);
    relief.material = read_material(fields, {});
    if (!diagnosis_.fine()) return;
    relief.surface = std::make_unique<relief::PlacedSurface>(relief::placed(surface, world_from_surface.m));
    if (relief.name.empty()) relief.name = object.text("surface", "");
    scene_.reliefs.push_back(std::move(relief));
}

std::vector<raster::Model> ObjectReader::all_models() {
    std::vector<raster::Model> models = scene_.scene.models;
    for (const ReliefObject& relief : scene_.reliefs) {
        models.insert(models.end(), relief.models->models.begin(), relief.models->models.end());
        if (!relief.surface) continue;
        const relief::BoundingBall ball = bounding_ball(*relief.surface);
        boxes_.push_back(std::make_unique<const pipeline::Mesh>(cube()));
        raster::Model box;
        box.mesh = boxes_.back().get();
        box.world_from_object.m =
            (pipeline::translate<World>(ball.centre) * pipeline::scale<World>(glm::dvec3(2 * ball.radius))).m;
        models.push_back(box);
    }
    return models;
}

ObjectReader::Parts ObjectReader::find_parts(const Fields& object) {
    const std::string name = object.text("mesh", "");
    if (!diagnosis_.fine()) return {};
    if (name.empty()) return object.refuse("mesh", "a file ending in .obj or .solid, or a shape"), Parts{};
    if (!is_file_name(name)) return generated_part(object, name);
    refuse_foreign_parameters(object, "mesh", name, {});
    return diagnosis_.fine() ? file_parts(object, name) : Parts{};
}

ObjectReader::Parts ObjectReader::generated_part(const Fields& object, std::string_view name) {
    const Generator* generator = find_generator(name);
    if (!generator) {
        std::vector<std::string_view> names;
        for (const Generator& known : generators()) names.push_back(known.name);
        object.refuse("mesh", "a file ending in .obj or .solid, or a shape: " + joined(names) +
                                  io::suggestion(name, names));
        return {};
    }
    refuse_foreign_parameters(object, "mesh", name, generator->parameters);
    pipeline::Mesh mesh = generate(*generator, object);
    if (!diagnosis_.fine()) return {};
    return {{{std::string(name), "", true, true}, keep(std::move(mesh)), {}, ""}};
}

const ObjectReader::Parts& ObjectReader::file_parts(const Fields& object, const std::string& name) {
    const std::string path = resolved(name);
    const auto known = files_.find(path);
    if (known != files_.end()) return known->second;
    asked_ = object.place("mesh");
    asked_as_ = object.full("mesh");
    const std::string ending = std::filesystem::path(path).extension().string();
    Parts& parts = files_[path];
    if (ending == ".obj")
        parts = obj_parts(path);
    else if (ending == ".solid")
        parts = solid_parts(path);
    else
        object.refuse("mesh", "a file ending in .obj or .solid");
    return parts;
}

ObjectReader::Parts ObjectReader::obj_parts(const std::string& path) {
    auto read = io::read_obj(path);
    if (!read) return say_file(read.error()), Parts{};
    Parts parts;
    for (io::ObjPart& part : *read) {
        const io::ObjMaterial material = part.material.value_or(io::ObjMaterial{});
        const std::string name = part.name.empty() ? stem(path) : part.name;
        parts.push_back({{name, "", part.had_uv, part.had_normals},
                         keep(std::move(part.mesh)),
                         material.material,
                         material.texture_path,
                         material.transparent});
    }
    return parts;
}

ObjectReader::Parts ObjectReader::solid_parts(const std::string& path) {
    auto read = io::read_solid(path);
    if (!read) return say_file(read.error()), Parts{};
    scene_.warnings.insert(scene_.warnings.end(), read->warnings.begin(), read->warnings.end());
    return {{{stem(path), "", read->had_uv, read->had_normals}, keep(std::move(read->mesh)), {}, ""}};
}

void ObjectReader::add_model(const Part& part, const Fields& object, const WorldFromObject& world_from_object,
                             std::vector<raster::Model>& models) {
    const Value none{object.place(""), Table{}};
    const Value* given = object.find("material");
    const Fields fields(given ? *given : none, object.full("material"), material_keys, diagnosis_);
    raster::Model model;
    model.mesh = part.mesh;
    model.world_from_object = world_from_object;
    model.material = read_material(fields, part.material);
    model.two_sided = fields.flag("two_sided", false);
    const std::string own_texture = fields.text("texture", "");
    const std::string path =
        fields.has("texture") ? (own_texture.empty() ? "" : resolved(own_texture)) : part.texture_path;
    if (!diagnosis_.fine()) return;
    const io::Place place = fields.has("texture") ? fields.place("texture") : object.place("mesh");
    const std::string key = fields.has("texture") ? fields.full("texture") : object.full("mesh");
    if (!path.empty()) model.texture = texture(path, place, key);
    ModelDescription description = part.description;
    description.name = object.text("name", description.name);
    if (model.texture) description.texture = std::filesystem::path(path).filename().string();
    if (model.texture && !description.has_uv)
        scene_.warnings.push_back(io::FileError{
            place, fmt::format("{}: the mesh has no texture coordinates everywhere, so (0, 0) is used "
                               "where they are missing",
                               key)}
                                      .text());
    models.push_back(model);
    if (&models == &scene_.scene.models) scene_.descriptions.push_back(std::move(description));
}

const raster::Texture* ObjectReader::texture(const std::string& path, const io::Place& place,
                                             const std::string& key) {
    const auto known = textures_.find(path);
    if (known != textures_.end()) return known->second;
    asked_ = place;
    asked_as_ = key;
    const auto picture = io::read_picture(path);
    if (!picture) return say_file(picture.error()), nullptr;
    scene_.textures.push_back(std::make_unique<const raster::Texture>(raster::make_texture(
        picture->width, picture->height, picture->channels, picture->pixels, encoding_)));
    return textures_[path] = scene_.textures.back().get();
}

const pipeline::Mesh* ObjectReader::keep(pipeline::Mesh mesh) {
    scene_.meshes.push_back(std::make_unique<const pipeline::Mesh>(std::move(mesh)));
    return scene_.meshes.back().get();
}

std::string ObjectReader::resolved(const std::string& path) const {
    return (std::filesystem::path(folder_) / path).lexically_normal().string();
}

// A line of the file is the place to look at; a file that is wrong as a whole is pointed at where it is
// named.
void ObjectReader::say_file(const io::FileError& error) {
    if (error.place.line > 0) return diagnosis_.say(error.place, error.message);
    diagnosis_.say(asked_, asked_as_ + ": " + error.text());
}

}  // namespace relevo::scene
