// Draws lessons: a moment as a page to look at, and all of them as a strip to print.
//
// A page has a title bar, the equation in large letters, the caption, the pixels with numbers along the edges
// in the words of the scene's axes, the legend and the table of states. All pages of a lesson are laid out
// alike, so that only what changes moves. Nothing overflows: long words break, wide tables are shortened,
// many pixels make the page larger.
#pragma once
#include <cstddef>
#include <vector>

#include "samples/scene/scene.hpp"
#include "samples/show/lesson.hpp"

namespace relevo::show {

// Where the pixels of a lesson are on a page: pixel `view.x0, view.y0` is the square of `cell` canvas pixels
// in the upper-left corner of `area`.
struct LessonGrid {
    Rect area;
    int cell = 1;
    raster::PixelBox view{0, 0, 0, 0};

    Spot spot(double x, double y) const {
        return {area.x + (x - view.x0 + 0.5) * cell, area.y + (y - view.y0 + 0.5) * cell};
    }
    Rect square(int x, int y) const {
        return {area.x + (x - view.x0) * cell, area.y + (y - view.y0) * cell, cell, cell};
    }
};

struct LessonPage {
    Picture picture;
    LessonGrid grid;
};

inline constexpr int lesson_width = 960, lesson_height = 720;  // at least

// The page of one frame, 0 <= frame < lesson.frames.size(). The view is not empty, at most 2048 a side.
LessonPage draw_lesson_frame(const Lesson& lesson, const scene::LessonAxes& axes, std::size_t frame);

// Which frames are printed: all, or so many of them at even steps, with the first and the last.
inline constexpr std::size_t printed_frames = 12;
std::vector<std::size_t> frames_to_print(std::size_t frames);

// The lesson on one sheet of paper.
Picture draw_lesson_strip(const Lesson& lesson, const scene::LessonAxes& axes);

}  // namespace relevo::show
