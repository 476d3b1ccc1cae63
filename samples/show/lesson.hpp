// A lesson: one algorithm at work, moment by moment. Whoever explains an algorithm listens to its events and
// fills in a Lesson; lesson_sheet.hpp draws it, lesson_files.hpp writes it.
//
// Places are in pixels of the scene: whole numbers are pixel centres, x to the right, y down. Words name
// places by the axes of the scene (scene::LessonAxes), so that a reader finds the numbers of the scene file.
#pragma once
#include <string>
#include <vector>

#include "raster/pixel.hpp"
#include "samples/show/canvas.hpp"

namespace relevo::show {

// Something drawn over the grid of pixels.
struct Mark {
    enum class Kind {
        Cell,     // points[0]: the whole square of a pixel; `level` 0..255 says how much of `color`
        Frame,    // points[0]: the border of a pixel's square (a candidate)
        Dot,      // points[0], radius in canvas pixels is fixed
        Cross,    // points[0]
        Segment,  // points[0], points[1]
        Dashes,   // points[0], points[1]
        Arrow,    // points[0] to points[1]
        Path,     // open
        Outline,  // closed
        Area,     // closed, filled, see-through
        Curve,    // circle or ellipse around points[0] with radius_x, radius_y
        Box,      // the rectangle between points[0] and points[1]
        Text,     // `text` beside points[0], with a halo
    } kind = Kind::Dot;
    Rgba8 color = ink;
    std::vector<Spot> points{};
    double radius_x = 0, radius_y = 0;
    int level = 255;
    std::string text{};
};

struct LessonFrame {
    std::string title;             // "step 3: x = 4" (short)
    std::string equation;          // "d = 2dy - dx = -3 < 0 -> E", numbers filled in
    std::string caption;           // one plain sentence
    std::vector<Mark> stays;       // from this frame on: pixels lit, corners found
    std::vector<Mark> now;         // in this frame only: candidates, midpoint
    std::vector<std::string> row;  // the state, one cell a column of the lesson; empty: no row in the table
};

struct LegendEntry {
    Mark::Kind kind;
    Rgba8 color;
    std::string words;
};

struct Lesson {
    std::string name;                   // of the files: lower case, digits, '-'; "line-midpoint"
    std::string title;                  // "Midpoint line"
    std::string sentence;               // what it does, for a reader who has never seen it
    std::string source;                 // "Bresenham 1965; textbook section 5.1, algorithm 5.1"
    raster::PixelBox view{0, 0, 0, 0};  // the pixels to show
    bool grid = true;                   // lines between pixels
    std::vector<std::string> columns;   // of the state table
    std::vector<Mark> ground;           // on every frame, beneath: the true shape, the window
    std::vector<LegendEntry> legend;
    std::vector<LessonFrame> frames;  // at least one
};

}  // namespace relevo::show
