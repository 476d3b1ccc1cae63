// relevo: draws scenes, shows every stage of the pipeline, compares pictures.
#include <csignal>
#include <cstdio>
#include <new>
#include <string>
#include <vector>

#include "samples/io/suggest.hpp"
#include "samples/relevo/commands.hpp"

namespace {

using relevo::command::wrong_input;

// A file-size limit then shows as a failed write, with a message, not as a sudden end. A reader of our output
// that goes away ends us quietly, as is usual in a pipe.
void choose_signals() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_DFL);
}

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& names) {
    const std::vector<std::string_view> views(names.begin(), names.end());
    return relevo::io::suggestion(word.substr(0, word.find('=')), views);
}

int refuse(const std::string& command, const std::string& message) {
    std::fprintf(stderr, "%s: %s (%s --help tells more)\n", command.c_str(), message.c_str(),
                 command.c_str());
    return wrong_input;
}

// What CLI11 could not read, in our words: one line, status 2.
int explain(const CLI::App& app, const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    if (chosen.empty()) {
        const std::vector<std::string> rest = app.remaining();
        if (rest.empty())
            return refuse("relevo", "a command is missing, accepted: render, steps, compare, list");
        const bool option = rest.front().starts_with("-");
        return refuse("relevo",
                      (option ? "unknown option '" : "unknown command '") + rest.front() + "'" +
                          suggestion(rest.front(), option ? option_names(app) : command_names(app)));
    }
    const CLI::App& command = *chosen.front();
    const std::string name = "relevo " + command.get_name();
    const std::vector<std::string> rest = command.remaining();
    if (rest.empty()) return refuse(name, error.what());
    if (rest.front().starts_with("-"))
        return refuse(
            name, "unknown option '" + rest.front() + "'" + suggestion(rest.front(), option_names(command)));
    return refuse(name, "'" + rest.front() + "' is one argument too many");
}

int run(int argc, char** argv) {
    CLI::App app{"Relevo draws scenes on the CPU and shows every stage of the pipeline.", "relevo"};
    app.set_version_flag("--version", "relevo " RELEVO_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Example: relevo render teapot.toml -o teapot.png --set shading=gouraud\n"
        "Exit status: 0 done, 1 a check failed, 2 the input or the command was wrong.");
    int status = relevo::command::done;
    relevo::command::add_render(app, status);
    relevo::command::add_steps(app, status);
    relevo::command::add_compare(app, status);
    relevo::command::add_list(app, status);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        app.exit(asked);
    } catch (const CLI::ParseError& error) {
        return explain(app, error);
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "relevo: there is not enough memory for this\n");
        return wrong_input;
    }
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    choose_signals();
    const int status = run(argc, argv);
    if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return status;
    std::fprintf(stderr, "standard output: cannot be written\n");
    return wrong_input;
}
