#include "samples/show/stages.hpp"

#include <fmt/format.h>

#include <array>

namespace relevo::show {
namespace {

constexpr std::array<StageInfo, 17> all_stages{{
    {"object", "Every model stands alone in coordinates of its own, as its file or its formula made it.",
     draw_object},
    {"world", "The models are placed in one common world, together with the camera and the lights.",
     draw_world},
    {"eye", "The same world, measured from the eye: the eye is the origin, looks down -z, and +y is up.",
     draw_eye},
    {"clip", "The projection gives each corner x, y, z and w. What is seen has -w ≤ x, y ≤ w and 0 ≤ z ≤ w.",
     draw_clip},
    {"clipped",
     "What lies outside of the view volume is cut away; an edge that crosses a plane gets a new corner on "
     "it.",
     draw_clipped},
    {"ndc", "After the division by w the view volume is a box: x and y go from -1 to 1, depth z from 0 to 1.",
     draw_ndc},
    {"window", "The box is stretched to the size of the picture, and every corner snaps to 1/256 of a pixel.",
     draw_window},
    {"culled", "A triangle that turns the wrong side to the eye is dropped before any pixel is touched.",
     draw_culled},
    {"coverage",
     "A pixel belongs to a triangle when its centre lies inside. Every triangle has its own colour; the "
     "nearest shows.",
     draw_coverage},
    {"depth",
     "Each pixel remembers the depth of the nearest surface so far; whatever lies behind it is thrown away.",
     draw_depth},
    {"visibility",
     "The fast path first finds the triangle that each pixel shows; then it shades every pixel exactly once.",
     draw_visibility},
    {"attributes", "What the corners carry is interpolated to every pixel, correctly in perspective.",
     draw_attributes},
    {"flat", "One light calculation for a whole triangle: every facet shows a single colour.", draw_flat},
    {"gouraud", "One light calculation at every corner; the colours in between are interpolated.",
     draw_gouraud},
    {"phong", "The normals are interpolated, and light is calculated anew at every pixel.", draw_phong},
    {"texture", "The surface's own colour, taken from its texture, without any light.", draw_texture},
    {"final", "The finished picture, exactly as `relevo render` writes it.", draw_final},
}};

}  // namespace

std::span<const StageInfo> stages() { return all_stages; }

StagePage draw_stage(const Capture& capture, std::size_t index) {
    const StageInfo& stage = all_stages[index];
    const Heading heading{
        static_cast<int>(index) + 1, static_cast<int>(all_stages.size()), std::string(stage.name),
        std::string(stage.sentence),
        fmt::format("{} · {}×{}", capture.loaded->name, capture.loaded->width, capture.loaded->height)};
    return stage.draw(capture, heading);
}

std::string stage_file(std::size_t index) {
    return fmt::format("{:02}-{}.png", index + 1, all_stages[index].name);
}

}  // namespace relevo::show
