// A lesson made by hand for tests: the midpoint line from (0,0) to (7,3) (textbook section 5.1), a step a
// frame.
#pragma once
#include <fmt/format.h>

#include "samples/show/lesson.hpp"

namespace relevo::show {

inline Lesson demo_lesson() {
    using Kind = Mark::Kind;
    Lesson lesson;
    lesson.name = "01-line-midpoint";
    lesson.title = "Midpoint line";
    lesson.sentence = "From column to column, the line goes east or north-east: the sign of d says which.";
    lesson.source = "Bresenham 1965; textbook section 5.1, algorithm 5.1";
    lesson.view = {-1, -1, 9, 5};
    lesson.columns = {"x", "y", "d", "choice"};
    lesson.ground = {{Kind::Segment, ink, {{0, 0}, {7, 3}}}};
    lesson.legend = {{Kind::Segment, ink, "the true line"},
                     {Kind::Cell, blue, "pixel lit"},
                     {Kind::Frame, orange, "candidate E (east)"},
                     {Kind::Frame, purple, "candidate SE (south-east)"},
                     {Kind::Dot, vermilion, "midpoint between the candidates"}};
    const int dx = 7, dy = 3;
    int y = 0, d = 2 * dy - dx;
    const auto lit = [](int px, int py) { return Mark{Kind::Cell, blue, {{double(px), double(py)}}}; };
    lesson.frames.push_back({"start",
                             "d = 2dy - dx = 2*3 - 7 = -1",
                             "The first pixel is the start itself.",
                             {lit(0, 0)},
                             {},
                             {"0", "0", fmt::format("{}", d), ""}});
    for (int x = 0; x < dx; ++x) {
        const bool east = d < 0;
        LessonFrame frame;
        frame.title = fmt::format("step {}: x = {}", x + 1, x + 1);
        frame.equation = fmt::format("d = {} {} 0 -> {}", d, east ? "<" : "≥",
                                     east ? "E, d = d + 2dy" : "SE, d = d + 2dy - 2dx");
        frame.caption = east ? "The line passes above the midpoint, so the pixel in the same row is nearer."
                             : "The line passes below the midpoint, so the pixel in the next row is nearer.";
        frame.now = {{Kind::Frame, orange, {{x + 1.0, double(y)}}},
                     {Kind::Frame, purple, {{x + 1.0, y + 1.0}}},
                     {Kind::Dot, vermilion, {{x + 1.0, y + 0.5}}},
                     {Kind::Text, vermilion, {{x + 1.0, y + 0.5}}, 0, 0, 255, "M"}};
        y += east ? 0 : 1;
        d += east ? 2 * dy : 2 * dy - 2 * dx;
        frame.stays = {lit(x + 1, y)};
        frame.row = {fmt::format("{}", x + 1), fmt::format("{}", y), fmt::format("{}", d), east ? "E" : "SE"};
        lesson.frames.push_back(frame);
    }
    return lesson;
}

}  // namespace relevo::show
