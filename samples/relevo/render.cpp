// relevo render: a scene in, a picture out.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "raster/draw.hpp"
#include "raster/draw_shapes.hpp"
#include "raster/path.hpp"
#include "samples/io/picture.hpp"
#include "samples/io/png.hpp"
#include "samples/io/relief_file.hpp"
#include "samples/io/suggest.hpp"
#include "samples/io/words.hpp"
#include "samples/relevo/commands.hpp"
#include "samples/scene/animation.hpp"
#include "samples/scene/draw_scene.hpp"
#include "samples/scene/shapes2d.hpp"
#include "samples/scene/statistics.hpp"

namespace relevo::command {
namespace {

struct RenderOptions {
    std::string scene, output, size, raw_depth, statistics, threads, frames, relief;
    std::vector<std::string> set;
};

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

constexpr int max_threads = 256;

int all_cores() { return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, max_threads); }

// The argument of --threads; nothing: all cores.
io::FileResult<int> parse_threads(const std::string& text) {
    if (text.empty()) return all_cores();
    const auto threads = io::parse_integer(text);
    if (threads && 1 <= *threads && *threads <= max_threads) return static_cast<int>(*threads);
    return io::FileError{
        {"--threads " + text, 0, 0},
        fmt::format("accepted: a whole number from 1 to {} (default: the number of cores, here {})",
                    max_threads, all_cores())};
}

// ", "path": {...}": the way that a picture of objects took; a lesson has none.
std::string to_json(const raster::Rendering& rendering) {
    const raster::PathPlan& plan = rendering.plan;
    const std::string fast =
        plan.fast
            ? fmt::format(", \"instruction_set\": \"{}\", \"threads\": {}, \"tile\": {}, \"shaded\": {}",
                          name(plan.instruction_set), plan.threads, plan.tile, rendering.counts.shaded_pixels)
            : "";
    return fmt::format(", \"path\": {{\"name\": \"{}\", \"reason\": \"{}\"{}}}",
                       plan.fast ? "fast" : "textbook", plan.reason, fast);
}

void print_path(const raster::Rendering& rendering) {
    if (rendering.plan.fast)
        say("{:>12}  pixels shaded by the fast path, each of them once\n", rendering.counts.shaded_pixels);
    say("{:>12}  {}\n", "path", rendering.plan.reason);
}

// The pictures of objects that are shown by pictures of themselves; a scene without any says nothing.
struct Taken {
    std::vector<scene::PictureCounts> objects;
    double milliseconds = 0;
};
// ", "pictures": [{...}, ...]"
std::string to_json(const Taken& taken) {
    auto objects = nlohmann::ordered_json::array();
    for (const scene::PictureCounts& c : taken.objects)
        objects.push_back({{"object", c.object},
                           {"representation", c.representation},
                           {"pictures", c.pictures},
                           {"width", c.width},
                           {"height", c.height},
                           {"texels", c.texels},
                           {"covered", c.covered}});
    return ", \"pictures\": " + objects.dump();
}
void print_pictures(const Taken& taken) {
    for (const scene::PictureCounts& c : taken.objects) {
        const std::string size =
            c.pictures == 0
                ? "no picture of it"
                : fmt::format("{} of {} x {}, {} texels covered",
                              c.pictures == 1 ? "one picture" : fmt::format("{} pictures", c.pictures),
                              c.width, c.height, c.covered);
        say("{:>12}  texels of {}, drawn as {}: {}\n", c.texels, c.object, c.representation, size);
    }
}

template <class Statistics>
void print_statistics(const RenderOptions& options, const Statistics& statistics,
                      const std::optional<raster::Rendering>& rendering, double load, double draw,
                      const Taken& taken = {}) {
    const bool pictures = !taken.objects.empty();
    const std::vector<scene::NamedCount> counts = named_counts(statistics);
    if (options.statistics == "json") {
        say("{{\"counts\": {}{}{}, \"milliseconds\": {{\"load\": {:.3f}, {}\"draw\": {:.3f}}}}}\n",
            scene::to_json(counts), rendering ? to_json(*rendering) : "", pictures ? to_json(taken) : "",
            load, pictures ? fmt::format("\"pictures\": {:.3f}, ", taken.milliseconds) : "", draw);
        return;
    }
    for (const scene::NamedCount& c : counts) say("{:>12}  {}\n", c.count, c.words);
    if (rendering) print_path(*rendering);
    print_pictures(taken);
    say("{:>12.3f}  milliseconds to load the scene\n", load);
    if (pictures) say("{:>12.3f}  milliseconds to take the pictures\n", taken.milliseconds);
    say("{:>12.3f}  milliseconds to draw it\n", draw);
}

// "out.png" and 12: "out-0012.png".
std::string numbered(const std::string& path, int number) {
    const std::filesystem::path p(path);
    return (p.parent_path() / fmt::format("{}-{:04}{}", p.stem().string(), number, p.extension().string()))
        .string();
}

// The argument of --frames, "A-B" or "A": the first and the last picture of the row.
io::FileResult<std::pair<int, int>> parse_frames(const std::string& text, const scene::LoadedScene& loaded) {
    const int count = loaded.animation ? loaded.animation->frames : 1;
    if (text.empty()) return std::pair<int, int>{0, count - 1};
    const auto wrong = [&](const std::string& accepted) {
        return io::FileError{{"--frames " + text, 0, 0}, accepted};
    };
    if (!loaded.animation) return wrong("this scene has no [animation], and so a single picture");
    const std::size_t dash = text.find('-');
    const auto first = io::parse_integer(text.substr(0, dash)),
               last = dash == std::string::npos ? first : io::parse_integer(text.substr(dash + 1));
    if (first && last && 0 <= *first && *first <= *last && *last < count)
        return std::pair<int, int>{*first, *last};
    return wrong(fmt::format("accepted: A-B or A, whole numbers from 0 to {}", count - 1));
}

// "frame 12 of 36", over and over in one line, where somebody looks at it and it takes more than a second.
class Progress {
  public:
    explicit Progress(int count) : count_(count), shown_(isatty(2) != 0 && count > 1) {}
    ~Progress() {
        if (written_) std::fprintf(stderr, "\r%*s\r", width, "");
    }
    void step() {
        ++done_;
        if (!shown_ || milliseconds_since(start_) < 1000) return;
        written_ = true;
        std::fprintf(stderr, "\r%-*s", width, fmt::format("frame {} of {}", done_, count_).c_str());
    }

  private:
    static constexpr int width = 30;
    Clock::time_point start_ = Clock::now();
    int count_, done_ = 0;
    bool shown_, written_ = false;
};

// --relief: the first picture that was taken, with its depth.
io::Failure write_first_relief(const RenderOptions& options, const scene::ReliefPictures& pictures) {
    if (options.relief.empty()) return {};
    for (const relief::Represented& object : pictures.objects)
        if (!object.textures.empty())
            return io::write_relief(options.relief, object.textures.front(), io::ReliefNumbers::Float);
    return io::FileError{{"--relief " + options.relief, 0, 0},
                         "this scene has no object that is shown by pictures (representation)"};
}

int render_objects(const RenderOptions& options, const scene::LoadedScene& loaded, const std::string& output,
                   int threads, double load) {
    const auto frames = parse_frames(options.frames, loaded);
    if (!frames) return refuse(frames.error());
    raster::Frame frame = scene::make_frame(loaded);
    std::optional<raster::fast::Workers> workers;
    if (plan_path(loaded.scene, loaded.settings).fast) workers.emplace(threads);
    raster::fast::Workspace workspace;
    const Clock::time_point start = Clock::now();
    const auto pictures = scene::take_pictures(loaded, threads);
    if (!pictures) return refuse(pictures.error());
    for (const std::string& note : pictures->notes) std::fprintf(stderr, "warning: %s\n", note.c_str());
    const Taken taken{picture_counts(loaded, *pictures), milliseconds_since(start)};
    double draw = 0;
    if (const io::Failure failure = write_first_relief(options, *pictures)) return refuse(*failure);
    raster::Rendering rendering;
    Progress progress(frames->second - frames->first + 1);
    for (int number = frames->first; number <= frames->second; ++number, progress.step()) {
        const Clock::time_point frame_start = Clock::now();
        const auto drawn =
            scene::draw_scene(loaded, *pictures, number, frame, workspace, workers ? &*workers : nullptr);
        if (!drawn) return refuse(drawn.error());
        draw += milliseconds_since(frame_start);
        rendering = drawn->rendering;
        for (const std::string& note : drawn->notes)
            std::fprintf(stderr, "warning: %s%s\n",
                         loaded.animation ? fmt::format("frame {}: ", number).c_str() : "", note.c_str());
        const auto named = [&](const std::string& path) {
            return loaded.animation ? numbered(path, number) : path;
        };
        if (const io::Failure failure = io::write_png(named(output), frame.color)) return refuse(*failure);
        if (!options.raw_depth.empty())
            if (const io::Failure failure = io::write_exr(named(options.raw_depth), frame.depth))
                return refuse(*failure);
    }
    if (loaded.settings.path == raster::Path::Fast && !rendering.plan.fast)
        std::fprintf(stderr, "warning: %s: pipeline.path is \"fast\", which is impossible here (%s)\n",
                     loaded.path.c_str(), rendering.plan.reason.c_str());
    if (!options.statistics.empty()) {  // drawn once more: the probe costs time, but moves no pixel
        raster::Scene scene = loaded.scene;
        scene.camera = scene::camera_at(loaded, frames->second);
        scene::Statistics statistics = scene::statistics_of(scene);
        raster::draw(scene, loaded.settings, frame, statistics);
        print_statistics(options, statistics, rendering, load, draw, taken);
    }
    return done;
}

int render_lesson(const RenderOptions& options, const scene::LoadedScene& loaded, const std::string& output,
                  double load) {
    if (!options.frames.empty())
        return refuse(io::FileError{{"--frames " + options.frames, 0, 0},
                                    "a lesson has one picture; only scenes with [animation] have frames"});
    if (!options.relief.empty())
        return refuse(io::FileError{{"--relief " + options.relief, 0, 0},
                                    "a lesson has no relief; only scenes of [[object]]s have one"});
    if (!options.raw_depth.empty())
        return refuse(io::FileError{{"--raw-depth " + options.raw_depth, 0, 0},
                                    "a lesson has no depth buffer; only scenes of [[object]]s have one"});
    raster::Image<raster::LinearRgb> picture(loaded.width, loaded.height);
    const Clock::time_point start = Clock::now();
    raster::draw_shapes(loaded.shapes, picture);
    const double draw = milliseconds_since(start);
    if (std::all_of(picture.pixels().begin(), picture.pixels().end(),
                    [&](raster::LinearRgb p) { return p == loaded.shapes.background; }))
        std::fprintf(stderr,
                     "warning: %s: all pixels are background: every shape lies outside of the picture or "
                     "the window, has no area or length, or cannot be seen\n",
                     loaded.path.c_str());
    const auto encoded = raster::encoded(picture, loaded.settings.output);
    if (const io::Failure failure = io::write_png(output, scene::enlarged(encoded, loaded.zoom)))
        return refuse(*failure);
    if (!options.statistics.empty()) {
        scene::ShapeStatistics statistics(loaded.width, loaded.height);
        raster::draw_shapes(loaded.shapes, picture, statistics);
        print_statistics(options, statistics, std::nullopt, load, draw);
    }
    return done;
}

int render(const RenderOptions& options) {
    if (!options.statistics.empty() && options.statistics != "text" && options.statistics != "json") {
        constexpr std::string_view accepted[] = {"json", "text"};
        return refuse(io::FileError{{"--stats=" + options.statistics, 0, 0},
                                    "accepted: json, text" + io::suggestion(options.statistics, accepted)});
    }
    const auto threads = parse_threads(options.threads);
    if (!threads) return refuse(threads.error());
    if (!options.relief.empty())
        if (const io::Failure failure = io::refused_relief_name(options.relief)) return refuse(*failure);
    scene::SceneOptions scene_options{options.set, std::nullopt};
    if (!options.size.empty()) {
        const auto size = scene::parse_size(options.size);
        if (!size) return refuse(size.error());
        scene_options.size = *size;
    }
    const Clock::time_point start = Clock::now();
    const auto loaded = scene::load_scene(options.scene, scene_options);
    if (!loaded) return refuse(loaded.error());
    for (const std::string& warning : loaded->warnings)
        std::fprintf(stderr, "warning: %s\n", warning.c_str());
    const double load = milliseconds_since(start);
    const std::string output = options.output.empty() ? loaded->name + ".png" : options.output;
    return is_lesson(*loaded) ? render_lesson(options, *loaded, output, load)
                              : render_objects(options, *loaded, output, *threads, load);
}

}  // namespace

void add_render(CLI::App& app, int& status) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App* const command = app.add_subcommand("render", "Draw a scene into a PNG file.");
    command->add_option("SCENE", options->scene, "The scene file (TOML).")->required()->type_name("");
    command
        ->add_option("-o,--output", options->output, "The picture; default: the scene's name + .png, here.")
        ->type_name("FILE.png");
    command->add_option("--size", options->size, "Picture size in place of the scene's.")
        ->type_name("WIDTHxHEIGHT");
    command
        ->add_option("--set", options->set, "A key of [pipeline] in place of the scene's; may be repeated.")
        ->allow_extra_args(false)
        ->type_name("KEY=VALUE");
    command->add_option("--raw-depth", options->raw_depth, "Also write the depth buffer, 32-bit float.")
        ->type_name("FILE.exr");
    command
        ->add_option(
            "--relief", options->relief,
            "Also write the first relief texture of the scene: its camera, and EXR pictures beside it.")
        ->type_name("FILE.json");
    command
        ->add_option(
            "--threads", options->threads,
            "Threads of the fast path and of the pre-warp, 1 to 256; default: as many as there are cores.")
        ->type_name("N");
    command
        ->add_option(
            "--frames", options->frames,
            "Of a scene with [animation]: these pictures of the row; default: all. They are numbered: "
            "NAME-0000.png.")
        ->type_name("A-B");
    command->add_flag("--stats{text}", options->statistics,
                      "Print what happened, and milliseconds; --stats=json as JSON.");
    command->footer(
        "Example: relevo render teapot.toml -o teapot.png --size 800x600 --set shading=flat --stats");
    command->callback([options, &status] { status = render(*options); });
}

}  // namespace relevo::command
