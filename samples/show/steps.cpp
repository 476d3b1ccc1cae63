#include "samples/show/steps.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "samples/io/file.hpp"
#include "samples/io/png.hpp"
#include "samples/io/suggest.hpp"
#include "samples/show/index_page.hpp"
#include "samples/show/stages.hpp"
#include "samples/show/strip.hpp"

namespace relevo::show {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct StageTime {
    std::string stage;
    double draw_ms = 0, write_ms = 0;
};

class Stopwatch {
  public:
    // Milliseconds since the last call.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double, std::milli>(now - std::exchange(start_, now)).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// ---- the options ----

io::FileError unknown_stage(const std::string& name) {
    std::vector<std::string_view> known;
    std::string all;
    for (const StageInfo& stage : stages()) {
        known.push_back(stage.name);
        all += (all.empty() ? "" : ", ") + std::string(stage.name);
    }
    return {{"--stage"},
            fmt::format("there is no stage '{}'{} (stages: {})", name, io::suggestion(name, known), all)};
}

io::FileResult<std::vector<std::size_t>> chosen_stages(const std::vector<std::string>& names) {
    std::vector<std::size_t> chosen;
    for (const std::string& name : names)
        if (std::none_of(stages().begin(), stages().end(),
                         [&](const StageInfo& s) { return s.name == name; }))
            return unknown_stage(name);
    for (std::size_t i = 0; i < stages().size(); ++i)
        if (names.empty() || std::find(names.begin(), names.end(), stages()[i].name) != names.end())
            chosen.push_back(i);
    return chosen;
}

// ---- the folder ----

// Files are written into a folder inside of the target and moved out of it when all of them are complete.
struct Workplace {
    fs::path target, draft;
    fs::path made;  // the topmost folder that did not exist before; empty when all did
};

io::FileResult<Workplace> open_workplace(const std::string& directory) {
    const auto refuse = [&](const std::string& why) {
        return io::FileError{{directory}, "cannot write into this folder: " + why};
    };
    Workplace place{fs::path(directory), {}, {}};
    std::error_code error;
    for (fs::path p = fs::absolute(place.target, error).lexically_normal();
         !p.empty() && !fs::exists(p, error); p = p.parent_path()) {
        if (p.has_filename()) place.made = p;
        if (p == p.root_path()) break;
    }
    error.clear();
    fs::create_directories(place.target, error);
    if (error) return refuse(error.message());
    std::string name = (place.target / ".steps-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        const std::string why = std::generic_category().message(errno);
        if (!place.made.empty()) fs::remove_all(place.made, error);
        return refuse(why);
    }
    place.draft = name;
    return place;
}

void abandon(const Workplace& place) {
    std::error_code ignored;
    fs::remove_all(place.draft, ignored);
    if (!place.made.empty()) fs::remove_all(place.made, ignored);
}

// The failure as the user knows the file: by its final name.
io::Failure renamed_failure(io::Failure failure, const Workplace& place, const std::string& file) {
    if (failure) failure->place.file = (place.target / file).string();
    return failure;
}

io::Failure publish(const Workplace& place, const std::vector<std::string>& files) {
    std::error_code error;
    for (const std::string& file : files) {
        fs::rename(place.draft / file, place.target / file, error);
        if (error)
            return io::FileError{{(place.target / file).string()},
                                 "cannot write this file: " + error.message()};
    }
    fs::remove_all(place.draft, error);
    return {};
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
    const auto rounded_ms = [](double ms) { return std::floor(ms * 1000 + 0.5) / 1000; };
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

// Draws and writes everything into the draft folder; `files` are the names to publish.
io::Failure write_draft(const scene::LoadedScene& loaded, const std::vector<std::size_t>& chosen,
                        const Workplace& place, std::vector<std::string>& files) {
    Stopwatch watch;
    const Capture seen = capture(loaded);
    const double capture_ms = watch.lap();
    std::vector<StageRecord> records;
    std::vector<StageTime> times;
    std::vector<Picture> thumbnails;
    const auto path_of = [&](const std::string& file) {
        return files.push_back(file), (place.draft / file).string();
    };
    for (const std::size_t index : chosen) {
        const StageInfo& stage = stages()[index];
        StagePage page = draw_stage(seen, index);
        const std::string file = stage_file(index);
        times.push_back({std::string(stage.name), watch.lap(), 0});
        if (auto failure = io::write_png(path_of(file), page.picture))
            return renamed_failure(failure, place, file);
        thumbnails.push_back(thumbnail(page.picture));
        times.back().write_ms = watch.lap();
        records.push_back({static_cast<int>(index) + 1, std::string(stage.name), file,
                           std::string(stage.sentence), std::move(page.counts), page.picture.width(),
                           page.picture.height()});
    }
    if (auto failure = io::write_png(path_of("strip.png"), strip(thumbnails)))
        return renamed_failure(failure, place, "strip.png");
    const std::array<std::pair<std::string, std::string>, 3> lists{
        {{"steps.json", steps_json(loaded, records)},
         {"timing.json", timing_json(capture_ms, times)},
         {"index.html", index_page(loaded, records)}}};
    for (const auto& [file, bytes] : lists)
        if (auto failure = io::write_file(path_of(file), bytes)) return renamed_failure(failure, place, file);
    return {};
}

}  // namespace

io::Failure write_steps(const scene::LoadedScene& loaded, const StepsOptions& options) {
    const auto chosen = chosen_stages(options.stages);
    if (!chosen) return chosen.error();
    if (loaded.width > max_steps_size || loaded.height > max_steps_size)
        return io::FileError{
            {loaded.path},
            fmt::format("a picture of {}x{} is too large for steps, at most {}x{} (choose one with --size)",
                        loaded.width, loaded.height, max_steps_size, max_steps_size)};
    const auto place = open_workplace(options.directory);
    if (!place) return place.error();
    std::vector<std::string> files;
    io::Failure failure = write_draft(loaded, *chosen, *place, files);
    if (!failure) failure = publish(*place, files);
    if (failure) abandon(*place);
    return failure;
}

}  // namespace relevo::show
