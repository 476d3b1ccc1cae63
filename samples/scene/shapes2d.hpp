// The two-dimensional lesson of a scene: [[shape2d]], [axes], [clip], and what [image] and [pipeline] say
// about it.
#pragma once
#include <optional>
#include <vector>

#include "raster/image.hpp"
#include "samples/scene/fields.hpp"

namespace relevo::scene {

// Places in a lesson: pixels from the picture's first one. Whole numbers up to here, and 1/256 of them, are
// exact in every algorithm.
inline constexpr int largest_place = raster::largest_place;

inline constexpr std::string_view lesson_image_keys[] = {"width", "height", "background", "output", "zoom"};
inline constexpr std::string_view lesson_pipeline_keys[] = {"fill_rule", "algorithm", "antialiasing",
                                                            "samples"};

// The tables of a lesson, as they stand in the document. [axes] and [clip] may be missing.
struct LessonTables {
    const Value &image, &pipeline;
    const std::optional<Value>&axes, &clip;
    const std::vector<Value>& shapes;
};

// Fills in shapes, axes, size and zoom; width, height, background and output of [image] have been read.
// Coordinates in the file are those of [axes]; in `out` they are pixels. `size` is that of --size.
void read_lesson(const LessonTables& tables, std::optional<std::pair<int, int>> size, LoadedScene& out,
                 Diagnosis& diagnosis);

// The picture with each pixel drawn zoom x zoom, so that it can be seen. zoom >= 1.
raster::Image<raster::Rgba8> enlarged(const raster::Image<raster::Rgba8>& picture, int zoom);

}  // namespace relevo::scene
