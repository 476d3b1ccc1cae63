// Runs the built `relevo` as a user does, through the shell, in a folder of its own.
#pragma once
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::command {

struct Outcome {
    int status = -1;       // exit status; -1 when a signal ended it
    std::string out, err;  // of a run in `folder`, whose name is taken out
};

// `line` is shell text in which `relevo` is the program; the current folder is `folder`.
inline Outcome shell(const io::TemporaryFolder& folder, const std::string& line) {
    const io::TemporaryFolder streams;
    const std::string script =
        "relevo() { '" RELEVO_PROGRAM "' \"$@\"; }; cd '" + folder.path("") + "' || exit 99; " + line;
    const std::string file = streams.write("script", script);
    const int raw = std::system(
        ("bash '" + file + "' >'" + streams.path("out") + "' 2>'" + streams.path("err") + "'").c_str());
    return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, folder.without_path(io::bytes_of(streams.path("out"))),
            folder.without_path(io::bytes_of(streams.path("err")))};
}

inline Outcome run(const io::TemporaryFolder& folder, const std::string& arguments) {
    return shell(folder, "relevo " + arguments);
}

}  // namespace relevo::command
