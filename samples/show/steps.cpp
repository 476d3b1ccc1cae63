#include "samples/show/steps.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "samples/io/suggest.hpp"
#include "samples/show/index_page.hpp"
#include "samples/show/lesson_files.hpp"
#include "samples/show/lessons.hpp"
#include "samples/show/stages.hpp"
#include "samples/show/stopwatch.hpp"
#include "samples/show/strip.hpp"
#include "samples/show/workplace.hpp"

namespace relevo::show {
namespace {

using Json = nlohmann::ordered_json;

struct StageTime {
    std::string stage;
    double draw_ms = 0, write_ms = 0;
};

// ---- the options ----

io::FileResult<std::vector<std::size_t>> chosen_stages(const std::vector<std::string>& names) {
    std::vector<std::size_t> chosen;
    std::vector<std::string_view> known;
    for (const StageInfo& stage : stages()) known.push_back(stage.name);
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            return unknown_name("stage", name, known);
    for (std::size_t i = 0; i < stages().size(); ++i)
        if (names.empty() || std::find(names.begin(), names.end(), stages()[i].name) != names.end())
            chosen.push_back(i);
    return chosen;
}

// ---- the lists ----

std::string steps_json(const scene::LoadedScene& loaded, const std::vector<StageRecord>& records) {
    Json list = Json::array();
    for (const StageRecord& record : records) {
        Json counts = Json::object();
        for (const Count& count : record.counts)
            std::visit([&](auto value) { counts[count.name] = value; }, count.value);
        list.push_back(
            {{"stage", record.name}, {"file", record.file}, {"caption", record.caption}, {"counts", counts}});
    }
    const Json all{
        {"scene", loaded.name}, {"width", loaded.width}, {"height", loaded.height}, {"stages", list}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string timing_json(double capture_ms, const std::vector<StageTime>& times) {
    double total = capture_ms;
    Json list = Json::array();
    for (const StageTime& t : times) {
        list.push_back(
            {{"stage", t.stage}, {"draw_ms", rounded_ms(t.draw_ms)}, {"write_ms", rounded_ms(t.write_ms)}});
        total += t.draw_ms + t.write_ms;
    }
    const Json all{{"capture_ms", rounded_ms(capture_ms)}, {"stages", list}, {"total_ms", rounded_ms(total)}};
    return all.dump(2) + "\n";
}

io::Failure write_stages(const scene::LoadedScene& loaded, const std::vector<std::size_t>& chosen,
                         Workplace& place) {
    Stopwatch watch;
    const Capture seen = capture(loaded);
    const double capture_ms = watch.lap();
    std::vector<StageRecord> records;
    std::vector<StageTime> times;
    std::vector<Picture> thumbnails;
    for (const std::size_t index : chosen) {
        const StageInfo& stage = stages()[index];
        StagePage page = draw_stage(seen, index);
        const std::string file = stage_file(index);
        times.push_back({std::string(stage.name), watch.lap(), 0});
        if (auto failure = place.write(file, page.picture)) return failure;
        thumbnails.push_back(thumbnail(page.picture));
        times.back().write_ms = watch.lap();
        records.push_back({static_cast<int>(index) + 1, std::string(stage.name), file,
                           std::string(stage.sentence), std::move(page.counts), page.picture.width(),
                           page.picture.height()});
    }
    if (auto failure = place.write("strip.png", strip(thumbnails))) return failure;
    const std::array<std::pair<std::string, std::string>, 3> lists{
        {{"steps.json", steps_json(loaded, records)},
         {"timing.json", timing_json(capture_ms, times)},
         {"index.html", index_page(loaded, records)}}};
    for (const auto& [file, bytes] : lists)
        if (auto failure = place.write(file, bytes)) return failure;
    return {};
}

}  // namespace

io::FileError unknown_name(std::string_view kind, const std::string& name,
                           std::span<const std::string_view> known) {
    return {{"--stage"},
            fmt::format("there is no {0} '{1}'{2} ({0}s: {3})", kind, name, io::suggestion(name, known),
                        fmt::join(known, ", "))};
}

io::Failure too_large_for_steps(const scene::LoadedScene& loaded) {
    if (loaded.width > max_steps_size || loaded.height > max_steps_size)
        return io::FileError{
            {loaded.path},
            fmt::format("a picture of {}x{} is too large for steps, at most {}x{} (choose one with --size)",
                        loaded.width, loaded.height, max_steps_size, max_steps_size)};
    return {};
}

io::Failure write_steps(const scene::LoadedScene& loaded, const StepsOptions& options) {
    if (is_lesson(loaded)) return write_lessons(loaded, lessons(loaded), options);
    const auto chosen = chosen_stages(options.stages);
    if (!chosen) return chosen.error();
    if (const auto failure = too_large_for_steps(loaded)) return failure;
    return fill_folder(options.directory,
                       [&](Workplace& place) { return write_stages(loaded, *chosen, place); });
}

}  // namespace relevo::show
