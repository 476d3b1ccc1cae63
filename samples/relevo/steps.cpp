// relevo steps: a scene in, a picture of every stage of the pipeline out.
#include <fmt/format.h>

#include <memory>

#include "samples/relevo/commands.hpp"
#include "samples/scene/scene.hpp"
#include "samples/show/steps.hpp"

namespace relevo::command {
namespace {

struct StepsArguments {
    std::string scene, size;
    std::vector<std::string> set;
    show::StepsOptions steps;
};

int steps(const StepsArguments& arguments) {
    scene::SceneOptions scene_options{arguments.set, std::nullopt};
    if (!arguments.size.empty()) {
        const auto size = scene::parse_size(arguments.size);
        if (!size) return refuse(size.error());
        scene_options.size = *size;
    }
    const auto loaded = scene::load_scene(arguments.scene, scene_options);
    if (!loaded) return refuse(loaded.error());
    for (const std::string& warning : loaded->warnings)
        std::fprintf(stderr, "warning: %s\n", warning.c_str());
    if (const io::Failure failure = show::write_steps(*loaded, arguments.steps)) return refuse(*failure);
    return done;
}

}  // namespace

void add_steps(CLI::App& app, int& status) {
    const auto arguments = std::make_shared<StepsArguments>();
    CLI::App* const command = app.add_subcommand("steps", "Draw a picture of every stage of the pipeline.");
    command->add_option("scene", arguments->scene, "The scene file (TOML).")->required()->type_name("SCENE");
    command
        ->add_option(
            "-o,--output", arguments->steps.directory,
            "The folder for the pictures, steps.json, timing.json and index.html; made when missing.")
        ->required()
        ->type_name("DIR");
    command
        ->add_option("--stage", arguments->steps.stages,
                     "Only this stage, or this lesson of a scene of shapes; may be repeated. relevo list "
                     "stages names the stages.")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command->add_option("--size", arguments->size, "Picture size in place of the scene's, at most 2048x2048.")
        ->type_name("WIDTHxHEIGHT");
    command
        ->add_option("--set", arguments->set, "A key of [pipeline] in place of the scene's; may be repeated.")
        ->allow_extra_args(false)
        ->type_name("KEY=VALUE");
    command->footer("Example: relevo steps teapot.toml -o out/teapot --set cull=none");
    command->callback([arguments, &status] { status = steps(*arguments); });
}

}  // namespace relevo::command
