// The [[object]] tables: meshes, where they stand, what they are made of.
#pragma once
#include <map>

#include "samples/scene/fields.hpp"

namespace relevo::scene {

// Reads objects one after the other into `scene`; a file named by several of them is read once.
class ObjectReader {
  public:
    // Paths are relative to `folder`. `encoding` says what the numbers in texture files mean.
    ObjectReader(LoadedScene& scene, std::string folder, raster::Encoding encoding, Diagnosis& diagnosis)
        : scene_(scene), folder_(std::move(folder)), encoding_(encoding), diagnosis_(diagnosis) {}

    void read(const Value& table);

    // What the camera must see when nobody says where it stands: the models, and the ball round each relief
    // object as the box that holds it. To be used while this reader lives.
    std::vector<raster::Model> all_models();

  private:
    // A mesh as a file or a generator brings it, before the scene's own material.
    struct Part {
        ModelDescription description;
        const pipeline::Mesh* mesh;
        pipeline::Material material;
        std::string texture_path;
        bool transparent = false;  // says its file; the machine draws it opaque
    };
    using Parts = std::vector<Part>;

    Parts find_parts(const Fields& object);
    Parts generated_part(const Fields& object, std::string_view name);
    const Parts& file_parts(const Fields& object, const std::string& name);
    Parts obj_parts(const std::string& path);
    Parts solid_parts(const std::string& path);
    using Map = pipeline::Affine<pipeline::World, pipeline::Object>;
    void add_model(const Part& part, const Fields& object, const Map& world_from_object,
                   std::vector<raster::Model>& models);
    void read_surface(const Fields& object, const Map& world_from_surface);
    ReliefObject relief_object(const Fields& object);
    const raster::Texture* texture(const std::string& path, const io::Place& place, const std::string& key);
    const pipeline::Mesh* keep(pipeline::Mesh mesh);
    std::string resolved(const std::string& path) const;
    void say_file(const io::FileError& error);

    LoadedScene& scene_;
    std::string folder_;
    raster::Encoding encoding_;
    Diagnosis& diagnosis_;
    io::Place asked_;       // where the file being read is named
    std::string asked_as_;  // and as what
    std::map<std::string, Parts> files_;
    std::map<std::string, const raster::Texture*> textures_;
    std::vector<std::unique_ptr<const pipeline::Mesh>> boxes_;  // of all_models()
};

}  // namespace relevo::scene
