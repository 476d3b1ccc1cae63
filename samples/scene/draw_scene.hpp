// A scene with everything in it: models by the machine, then the objects that are shown by pictures of
// themselves.
#pragma once
#include "raster/path.hpp"
#include "samples/scene/scene.hpp"

namespace relevo::scene {

// The pictures of the scene's relief objects, taken once.
struct ReliefPictures {
    std::vector<relief::Represented> objects;  // one for each of LoadedScene::reliefs, from which they borrow
    std::vector<std::string> notes;            // an object a line of whom no texel shows anything
};
// With how many threads they are warped later changes no byte. Errors name the place of the object.
io::FileResult<ReliefPictures> take_pictures(const LoadedScene& scene, int threads = 1);

// What was taken of one object. Texels are those of all its pictures, which are of one size.
struct PictureCounts {
    std::string object;
    std::string_view representation;
    std::size_t pictures;
    int width, height;  // 0 where there are none
    std::uint64_t texels, covered;
};
std::vector<PictureCounts> picture_counts(const LoadedScene& scene, const ReliefPictures& pictures);

struct Drawn {
    raster::Rendering rendering;     // of the models
    std::vector<std::string> notes;  // an object a line that was drawn in another way than asked for, and why
};

// Frame 0 .. frames - 1 of the scene's animation, or its only picture. A relief whose plane the viewer is on
// or behind cannot be warped: it is drawn as geometry, and noted.
io::FileResult<Drawn> draw_scene(const LoadedScene& scene, const ReliefPictures& pictures, int frame_number,
                                 raster::Frame& frame, raster::fast::Workspace& workspace,
                                 raster::fast::Workers* workers = nullptr);

}  // namespace relevo::scene
