// The sub-commands of `relevo`, one file each.
#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <utility>

#include "samples/io/place.hpp"

namespace relevo::command {

// Exit status: 0 done, 1 a check failed, 2 the input or the command was wrong.
inline constexpr int done = 0, check_failed = 1, wrong_input = 2;

// Each adds its sub-command to `app`; when it is called, it does its work and sets `status`.
void add_render(CLI::App& app, int& status);
void add_steps(CLI::App& app, int& status);
void add_compare(CLI::App& app, int& status);
void add_list(CLI::App& app, int& status);

// Formatted text on standard output. A write that fails is left to main, which looks once, at the end.
template <class... Arguments>
void say(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    const std::string out = fmt::format(text, std::forward<Arguments>(arguments)...);
    std::fwrite(out.data(), 1, out.size(), stdout);
}

// One line on standard error; the status that goes with it.
inline int refuse(const io::FileError& error) {
    std::fprintf(stderr, "%s\n", error.text().c_str());
    return wrong_input;
}

}  // namespace relevo::command
