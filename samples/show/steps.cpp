#include "samples/show/steps.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "samples/io/suggest.hpp"
#include "samples/show/index_page.hpp"
#include "samples/show/lesson_files.hpp"
#include "samples/show/lessons.hpp"
#include "samples/show/relief_stages.hpp"
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

// A stage of this scene.
struct Step {
    int number;
    std::string_view name, sentence;
    std::function<StagePage(const Heading&)> draw;
    std::string file() const { return fmt::format("{:02}-{}.png", number, name); }
};

// The stages of the machine, for models; those of a relief, for objects that are shown by pictures. What is
// captured for them is captured when the first of them is drawn.
std::vector<Step> steps_of(const scene::LoadedScene& loaded) {
    std::vector<Step> steps;
    const auto add = [&](const auto& stage, auto&& draw) {
        steps.push_back({static_cast<int>(steps.size()) + 1, stage.name, stage.sentence, draw});
    };
    if (!loaded.scene.models.empty()) {
        const auto seen = std::make_shared<std::optional<Capture>>();
        for (const StageInfo& stage : stages()) {
            if (stage.name == "final" && !loaded.reliefs.empty()) continue;  // the relief's shows all
            add(stage, [&loaded, seen, draw = stage.draw](const Heading& heading) {
                if (!*seen) *seen = capture(loaded);
                return draw(**seen, heading);
            });
        }
    }
    if (!loaded.reliefs.empty()) {
        const auto view = std::make_shared<std::optional<ReliefView>>();
        for (const ReliefStageInfo& stage : relief_stages())
            add(stage, [&loaded, view, &stage](const Heading& heading) {
                if (!*view) *view = relief_view(loaded);
                return draw_stage(**view, stage, heading);
            });
    }
    return steps;
}

io::FileResult<std::vector<Step>> chosen_steps(std::vector<Step> all, const std::vector<std::string>& names) {
    std::vector<std::string_view> known;
    for (const Step& step : all) known.push_back(step.name);
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            return unknown_name("stage", name, known);
    std::erase_if(all, [&](const Step& step) {
        return !names.empty() && std::find(names.begin(), names.end(), step.name) == names.end();
    });
    return all;
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

std::string timing_json(const std::vector<StageTime>& times) {
    double total = 0;
    Json list = Json::array();
    for (const StageTime& t : times) {
        list.push_back(
            {{"stage", t.stage}, {"draw_ms", rounded_ms(t.draw_ms)}, {"write_ms", rounded_ms(t.write_ms)}});
        total += t.draw_ms + t.write_ms;
    }
    const Json all{{"stages", list}, {"total_ms", rounded_ms(total)}};
    return all.dump(2) + "\n";
}

io::Failure write_stages(const scene::LoadedScene& loaded, const std::vector<Step>& chosen, std::size_t of,
                         Workplace& place) {
    Stopwatch watch;
    std::vector<StageRecord> records;
    std::vector<StageTime> times;
    std::vector<Picture> thumbnails;
    for (const Step& step : chosen) {
        StagePage page =
            step.draw({step.number, static_cast<int>(of), std::string(step.name), std::string(step.sentence),
                       fmt::format("{} · {}×{}", loaded.name, loaded.width, loaded.height)});
        times.push_back({std::string(step.name), watch.lap(), 0});
        if (auto failure = place.write(step.file(), page.picture)) return failure;
        thumbnails.push_back(thumbnail(page.picture));
        times.back().write_ms = watch.lap();
        records.push_back({step.number, std::string(step.name), step.file(), std::string(step.sentence),
                           std::move(page.counts), page.picture.width(), page.picture.height()});
    }
    if (auto failure = place.write("strip.png", strip(thumbnails))) return failure;
    const std::array<std::pair<std::string, std::string>, 3> lists{
        {{"steps.json", steps_json(loaded, records)},
         {"timing.json", timing_json(times)},
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
    const std::vector<Step> all = steps_of(loaded);
    const auto chosen = chosen_steps(all, options.stages);
    if (!chosen) return chosen.error();
    if (const auto failure = too_large_for_steps(loaded)) return failure;
    return fill_folder(options.directory,
                       [&](Workplace& place) { return write_stages(loaded, *chosen, all.size(), place); });
}

}  // namespace relevo::show
