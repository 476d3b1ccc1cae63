// The page that shows all lessons of a scene: the frames with buttons, arrow keys and a slider, captions and
// tables as text. It needs no network; without scripts it shows the strips and lists the frames.
#pragma once
#include <span>
#include <string>

#include "samples/scene/scene.hpp"
#include "samples/show/lesson.hpp"

namespace relevo::show {

// A lesson that has been drawn; sizes are of its pictures.
struct LessonRecord {
    const Lesson* lesson;  // borrowed
    int frame_width = 0, frame_height = 0, strip_width = 0, strip_height = 0;
};

// `final_picture` is final.png; `factor`: how many times larger final-enlarged.png is; 1: there is none.
std::string lesson_page(const scene::LoadedScene& loaded, std::span<const LessonRecord> records,
                        const Picture& final_picture, int factor);

}  // namespace relevo::show
