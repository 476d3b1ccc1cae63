// Draws scenes and writes what must be the same bytes wherever it runs: colour, then depth, one file a
// picture.
//   hash_scenes FOLDER WIDTHxHEIGHT SCENE...       FOLDER/NAME-SHADING for each scene in every shading;
//                                                  FOLDER/NAME for each lesson, linear light, in its own
//                                                  size, and for each scene of reliefs, the frames one after
//                                                  another
// The fast path draws each picture, too, with every instruction set: other bytes are an error.
// scripts/determinism builds it in many ways and compares the sums of what it wrote.
#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>

#include "raster/draw.hpp"
#include "raster/draw_shapes.hpp"
#include "raster/fast/draw_fast.hpp"
#include "raster/fast/workers.hpp"
#include "samples/io/file.hpp"
#include "samples/scene/draw_scene.hpp"
#include "samples/scene/scene.hpp"

namespace {

using namespace relevo;

constexpr std::pair<const char*, raster::Shading> shadings[] = {
    {"unlit", raster::Shading::Unlit},
    {"flat", raster::Shading::Flat},
    {"gouraud", raster::Shading::Gouraud},
    {"phong", raster::Shading::Phong},
};

template <class Pixel>
std::string_view bytes(const raster::Image<Pixel>& image) {
    return {reinterpret_cast<const char*>(image.pixels().data()), image.pixels().size() * sizeof(Pixel)};
}

io::Failure write_lesson(const scene::LoadedScene& lesson, const std::string& folder) {
    raster::Image<raster::LinearRgb> picture(lesson.width, lesson.height);
    raster::draw_shapes(lesson.shapes, picture);
    return io::write_file(folder + "/" + lesson.name, std::string(bytes(picture)));
}

std::string bytes(const raster::Frame& frame) {
    return std::string(bytes(frame.color)).append(bytes(frame.depth));
}

// At most this many frames of an animation.
constexpr int most_frames = 4;

io::Failure write_reliefs(const scene::LoadedScene& loaded, const std::string& folder) {
    const auto pictures = scene::take_pictures(loaded);
    if (!pictures) return pictures.error();
    raster::Frame frame = scene::make_frame(loaded);
    raster::fast::Workspace workspace;
    std::string all;
    const int frames = loaded.animation ? std::min(loaded.animation->frames, most_frames) : 1;
    for (int number = 0; number < frames; ++number) {
        const auto drawn = scene::draw_scene(loaded, *pictures, number, frame, workspace);
        if (!drawn) return drawn.error();
        all += bytes(frame);
    }
    return io::write_file(folder + "/relief-" + loaded.name, all);
}

io::Failure write_pictures(const std::string& path, std::pair<int, int> size, const std::string& folder) {
    const auto as_it_is = scene::load_scene(path);
    if (as_it_is && is_lesson(*as_it_is)) return write_lesson(*as_it_is, folder);
    auto loaded = scene::load_scene(path, {{}, size});
    if (!loaded) return loaded.error();
    if (!loaded->reliefs.empty()) return write_reliefs(*loaded, folder);
    raster::Frame frame = scene::make_frame(*loaded);
    raster::fast::Workspace workspace;
    raster::fast::Workers workers(2);
    for (const auto& [name, shading] : shadings) {
        loaded->settings.shading = shading;
        raster::draw(loaded->scene, loaded->settings, frame);
        const std::string out = folder + "/" + loaded->name + "-" + name;
        const std::string right = bytes(frame);
        if (auto failure = io::write_file(out, right)) return failure;
        for (const raster::fast::InstructionSet set : raster::fast::instruction_sets()) {
            raster::fast::draw(loaded->scene, loaded->settings, frame, workspace, {set, 64, &workers});
            if (bytes(frame) != right)
                return io::error_in(path, "the fast path (" + std::string(raster::fast::name(set)) + ", " +
                                              name + ") draws other bytes than the textbook path");
        }
    }
    return {};
}

}  // namespace

int main(int count, char** words) {
    if (count < 4) return std::fprintf(stderr, "hash_scenes FOLDER WIDTHxHEIGHT SCENE...\n"), 2;
    const auto size = scene::parse_size(words[2]);
    io::Failure failure;
    if (!size) failure = size.error();
    for (int i = 3; i < count && !failure; ++i) failure = write_pictures(words[i], *size, words[1]);
    if (failure) return std::fprintf(stderr, "%s\n", failure->text().c_str()), 2;
}
