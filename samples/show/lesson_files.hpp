// Everything behind `relevo steps` of a two-dimensional scene: for each lesson
//   NN-name.png        a strip of its frames, to print        NN-name/001.png, ...  the frames
//   NN-name.apng       the frames as a film, a second each    NN-name.csv, .json    the table of states
// and final.png (what `relevo render` draws; final-enlarged.png too when it is small), steps.json,
// timing.json and index.html, which shows all of it.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "samples/io/place.hpp"
#include "samples/scene/scene.hpp"
#include "samples/show/lesson.hpp"
#include "samples/show/steps.hpp"

namespace relevo::show {

// "02-line-midpoint/003.png" for frame 2.
std::string lesson_frame_file(const Lesson& lesson, std::size_t frame);

// A row for every frame that has one: the number of the frame, then the lesson's columns. RFC 4180, lines end
// in \n.
std::string lesson_csv(const Lesson& lesson);

// The lesson in words: what it is, the columns, and each frame's title, equation, caption, row and file.
std::string lesson_json(const Lesson& lesson, const scene::LessonAxes& axes);

// Writes the lessons that `options.stages` names (all when it names none): "line-midpoint" or
// "02-line-midpoint". All files appear at the end, or none. The same scene gives the same bytes, except for
// timing.json. Errors: an unknown lesson, a picture above max_steps_size, a folder or file that cannot be
// written.
io::Failure write_lessons(const scene::LoadedScene& loaded, std::span<const Lesson> lessons,
                          const StepsOptions& options);

}  // namespace relevo::show
