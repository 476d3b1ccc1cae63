#include "samples/show/lesson_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "raster/draw_shapes.hpp"
#include "samples/io/apng.hpp"
#include "samples/io/png.hpp"
#include "samples/scene/shapes2d.hpp"
#include "samples/show/lesson_page.hpp"
#include "samples/show/lesson_sheet.hpp"
#include "samples/show/stopwatch.hpp"
#include "samples/show/workplace.hpp"

namespace relevo::show {
namespace {

using Json = nlohmann::ordered_json;

constexpr int frame_ms = 1000, last_frame_ms = 3000;

struct LessonTime {
    std::string lesson;
    double draw_ms = 0, write_ms = 0;
};

// "line-midpoint" of "02-line-midpoint".
std::string_view short_name(const Lesson& lesson) {
    const std::string_view name = lesson.name;
    const std::size_t number_end = name.find_first_not_of("0123456789");
    return number_end > 0 && number_end < name.size() && name[number_end] == '-' ? name.substr(number_end + 1)
                                                                                 : name;
}

io::FileResult<std::vector<const Lesson*>> chosen_lessons(std::span<const Lesson> lessons,
                                                          const std::vector<std::string>& names) {
    std::vector<std::string_view> known;
    for (const Lesson& lesson : lessons)
        if (std::find(known.begin(), known.end(), short_name(lesson)) == known.end())
            known.push_back(short_name(lesson));
    const auto is = [](const Lesson& lesson, const std::string& name) {
        return name == lesson.name || name == short_name(lesson);
    };
    for (const std::string& name : names)
        if (std::none_of(lessons.begin(), lessons.end(), [&](const Lesson& l) { return is(l, name); }))
            return unknown_name("lesson", name, known);
    std::vector<const Lesson*> chosen;
    for (const Lesson& lesson : lessons)
        if (names.empty() || std::any_of(names.begin(), names.end(),
                                         [&](const std::string& name) { return is(lesson, name); }))
            chosen.push_back(&lesson);
    return chosen;
}

// ---- the table ----

std::string csv_cell(const std::string& words) {
    if (words.find_first_of(",\"\r\n") == std::string::npos) return words;
    std::string out = "\"";
    for (const char c : words) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::string dumped(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string steps_json(const scene::LoadedScene& loaded, const std::vector<LessonRecord>& records) {
    Json list = Json::array();
    for (const LessonRecord& record : records) {
        const Lesson& lesson = *record.lesson;
        list.push_back({{"lesson", lesson.name},
                        {"title", lesson.title},
                        {"sentence", lesson.sentence},
                        {"source", lesson.source},
                        {"frames", lesson.frames.size()},
                        {"first_frame", lesson_frame_file(lesson, 0)},
                        {"strip", lesson.name + ".png"},
                        {"film", lesson.name + ".apng"},
                        {"table", {lesson.name + ".csv", lesson.name + ".json"}}});
    }
    return dumped({{"scene", loaded.name},
                   {"width", loaded.width},
                   {"height", loaded.height},
                   {"final", "final.png"},
                   {"lessons", list}});
}

std::string timing_json(double final_ms, const std::vector<LessonTime>& times) {
    double total = final_ms;
    Json list = Json::array();
    for (const LessonTime& t : times) {
        list.push_back(
            {{"lesson", t.lesson}, {"draw_ms", rounded_ms(t.draw_ms)}, {"write_ms", rounded_ms(t.write_ms)}});
        total += t.draw_ms + t.write_ms;
    }
    return dumped({{"final_ms", rounded_ms(final_ms)}, {"lessons", list}, {"total_ms", rounded_ms(total)}});
}

// ---- the pictures ----

std::string diagram(const Picture& picture) { return io::png_bytes(picture, 3, io::PngContents::Diagram); }

io::Failure write_lesson(const Lesson& lesson, const scene::LessonAxes& axes, Workplace& place,
                         LessonRecord& record, LessonTime& time) {
    Stopwatch watch;
    io::AnimatedPng film;
    for (std::size_t i = 0; i < lesson.frames.size(); ++i) {
        const Picture picture = draw_lesson_frame(lesson, axes, i).picture;
        time.draw_ms += watch.lap();
        record.frame_width = picture.width(), record.frame_height = picture.height();
        if (auto failure = place.write(lesson_frame_file(lesson, i), diagram(picture))) return failure;
        film.add(picture, i + 1 < lesson.frames.size() ? frame_ms : last_frame_ms);
        time.write_ms += watch.lap();
    }
    const Picture strip = draw_lesson_strip(lesson, axes);
    record.strip_width = strip.width(), record.strip_height = strip.height();
    time.draw_ms += watch.lap();
    if (auto failure = place.write(lesson.name + ".png", diagram(strip))) return failure;
    if (auto failure = place.write(lesson.name + ".apng", film.bytes())) return failure;
    if (auto failure = place.write(lesson.name + ".csv", lesson_csv(lesson))) return failure;
    if (auto failure = place.write(lesson.name + ".json", lesson_json(lesson, axes))) return failure;
    time.write_ms += watch.lap();
    return {};
}

// What `relevo render` writes.
Picture final_picture(const scene::LoadedScene& loaded) {
    raster::Image<raster::LinearRgb> picture(loaded.width, loaded.height);
    raster::draw_shapes(loaded.shapes, picture);
    return scene::enlarged(raster::encoded(picture, loaded.settings.output), loaded.zoom);
}

io::Failure write_draft(const scene::LoadedScene& loaded, std::span<const Lesson* const> lessons,
                        Workplace& place) {
    Stopwatch watch;
    const Picture picture = final_picture(loaded);
    const int factor =
        std::max(1, std::min(lesson_width / picture.width(), lesson_height / picture.height()));
    if (auto failure = place.write("final.png", picture)) return failure;
    if (factor > 1)
        if (auto failure = place.write("final-enlarged.png", scene::enlarged(picture, factor)))
            return failure;
    const double final_ms = watch.lap();
    std::vector<LessonRecord> records;
    std::vector<LessonTime> times;
    for (const Lesson* lesson : lessons) {
        records.push_back({lesson});
        times.push_back({lesson->name});
        if (auto failure = write_lesson(*lesson, loaded.axes, place, records.back(), times.back()))
            return failure;
    }
    const std::array<std::pair<std::string, std::string>, 3> lists{
        {{"steps.json", steps_json(loaded, records)},
         {"timing.json", timing_json(final_ms, times)},
         {"index.html", lesson_page(loaded, records, picture, factor)}}};
    for (const auto& [file, bytes] : lists)
        if (auto failure = place.write(file, bytes)) return failure;
    return {};
}

}  // namespace

std::string lesson_frame_file(const Lesson& lesson, std::size_t frame) {
    return fmt::format("{}/{:03}.png", lesson.name, frame + 1);
}

std::string lesson_csv(const Lesson& lesson) {
    std::string out = "frame";
    for (const std::string& column : lesson.columns) out += "," + csv_cell(column);
    out += "\n";
    for (std::size_t i = 0; i < lesson.frames.size(); ++i) {
        const std::vector<std::string>& row = lesson.frames[i].row;
        if (row.empty()) continue;
        out += fmt::format("{}", i + 1);
        for (std::size_t c = 0; c < lesson.columns.size(); ++c)
            out += "," + (c < row.size() ? csv_cell(row[c]) : std::string());
        out += "\n";
    }
    return out;
}

std::string lesson_json(const Lesson& lesson, const scene::LessonAxes& axes) {
    Json frames = Json::array();
    for (std::size_t i = 0; i < lesson.frames.size(); ++i) {
        const LessonFrame& f = lesson.frames[i];
        frames.push_back({{"frame", i + 1},
                          {"title", f.title},
                          {"equation", f.equation},
                          {"caption", f.caption},
                          {"row", f.row},
                          {"file", lesson_frame_file(lesson, i)}});
    }
    return dumped({{"lesson", lesson.name},
                   {"title", lesson.title},
                   {"sentence", lesson.sentence},
                   {"source", lesson.source},
                   {"axes", {{"left", axes.left}, {"top", axes.top}, {"y", axes.y_up ? "up" : "down"}}},
                   {"columns", lesson.columns},
                   {"frames", frames}});
}

io::Failure write_lessons(const scene::LoadedScene& loaded, std::span<const Lesson> lessons,
                          const StepsOptions& options) {
    const auto chosen = chosen_lessons(lessons, options.stages);
    if (!chosen) return chosen.error();
    if (const auto failure = too_large_for_steps(loaded)) return failure;
    return fill_folder(options.directory,
                       [&](Workplace& place) { return write_draft(loaded, *chosen, place); });
}

}  // namespace relevo::show
