// A scene file read, checked and ready to draw.
//
// Tables, keys and defaults are listed in samples/scenes/README.md; samples/scene/choices.hpp holds the words
// that keys accept. Paths in a scene are relative to the scene file.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "raster/scene.hpp"
#include "raster/shape.hpp"
#include "relief/representation.hpp"
#include "samples/io/place.hpp"

namespace relevo::scene {

// The camera in the words of the scene file, for captions. World units and degrees.
struct CameraDescription {
    enum class Kind { Perspective, Orthographic, Frustum } kind = Kind::Perspective;
    glm::dvec3 eye{0, 0, 3}, target{0, 0, 0}, up{0, 1, 0};
    double fov_y = 40;                                  // perspective: vertical angle of view
    double height = 2;                                  // orthographic: world units seen from bottom to top
    double left = -1, right = 1, bottom = -1, top = 1;  // frustum: the window on the near plane
    double near = 0.1, far = 0;                         // distances in front of the eye; far may be infinite
    bool framed = false;  // the scene named no eye: chosen so that all objects are seen
};

// What is worth saying about a model besides its numbers. models[i] is described by descriptions[i].
struct ModelDescription {
    std::string name;         // "teapot", or "bunny" of bunny.obj, or the object's name in the file
    std::string texture;      // its file name; empty without a texture
    bool has_uv = true;       // whether the mesh brought texture coordinates
    bool had_normals = true;  // false: they were averaged from the faces
};

// The axes of a two-dimensional lesson in the words of the scene file: pixel (0, 0) is the point (left, top),
// a unit is a pixel, and y grows upwards or downwards.
struct LessonAxes {
    int left = 0, top = 0;
    bool y_up = false;
    double x_of(double pixel_x) const { return left + pixel_x; }
    double y_of(double pixel_y) const { return y_up ? top - pixel_y : top + pixel_y; }
    double pixel_x(double x) const { return x - left; }
    double pixel_y(double y) const { return y_up ? top - y : y - top; }
};

// An [[object]] that is shown by pictures of itself, or an analytic surface.
struct ReliefObject {
    std::string name;
    io::Place place;  // of its representation: for messages
    relief::Representation representation = relief::Representation::Geometry;
    relief::RepresentationSettings settings;
    std::unique_ptr<raster::Scene> models;           // its meshes, with the scene's lights
    std::unique_ptr<relief::PlacedSurface> surface;  // in place of meshes
    pipeline::Material material;                     // by which its pictures are lit
    relief::RepresentedShape shape() const { return {models.get(), surface.get()}; }
};

// A row of pictures from eyes that differ. World units, degrees.
struct Animation {
    enum class Kind { Orbit, Path } kind = Kind::Orbit;
    int frames = 36;
    glm::dvec3 target{0, 0, 0};
    double radius = 3, elevation = 0, from = 0, to = 360;  // of an orbit: azimuths; 0 is +z, 90 is +x
    std::vector<glm::dvec3> eyes;                          // of a path: passed through in equal times
};

// Owns the meshes and textures that `scene.models` points to; may be moved, not copied.
struct LoadedScene {
    std::string name;  // of the file, without folder and ending
    std::string path;
    raster::Scene scene;
    raster::Settings settings;
    int width = 640, height = 480;  // 1..max_picture_size
    int zoom = 1;                   // of a lesson: render draws each pixel zoom x zoom
    raster::ShapeScene shapes;      // a two-dimensional lesson when it has shapes: then there are no models
    LessonAxes axes;
    CameraDescription camera;
    std::vector<ModelDescription> descriptions;  // one a model
    std::vector<ReliefObject> reliefs;           // drawn after the models
    std::optional<Animation> animation;          // the camera above is that of its first frame
    std::vector<std::string> warnings;           // whole lines, with their place: worth showing, not wrong
    std::vector<std::unique_ptr<const pipeline::Mesh>> meshes;
    std::vector<std::unique_ptr<const raster::Texture>> textures;
};

inline bool is_lesson(const LoadedScene& scene) { return !scene.shapes.shapes.empty(); }

// What the command line changes: `set` holds "key=value" for keys of [pipeline], `size` replaces width and
// height.
struct SceneOptions {
    std::vector<std::string> set;
    std::optional<std::pair<int, int>> size;
};

// Reads a scene and all that it names. Errors point at the line and column of what is wrong, or at the
// option.
io::FileResult<LoadedScene> load_scene(const std::string& path, const SceneOptions& options = {});

// The same from text; `path` names it in messages and gives the folder that paths in the scene start from.
io::FileResult<LoadedScene> parse_scene(std::string_view text, const std::string& path,
                                        const SceneOptions& options = {});

// "640x480" as the argument of --size: two whole numbers from 1 to max_picture_size.
io::FileResult<std::pair<int, int>> parse_size(std::string_view text);

// Colour and depth pictures of the scene's size.
raster::Frame make_frame(const LoadedScene& scene);

// How a relief object is captured: unlit, by the scene's texture filter and culling.
relief::ShapeCapture shape_capture(const LoadedScene& scene, const ReliefObject& object);

}  // namespace relevo::scene
