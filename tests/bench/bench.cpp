// The benchmark: tests/bench/run builds and runs it, part by part. Writes Markdown to standard output and
// every figure as CSV. Exit status 1 when a figure misses what is required of it.
//
// usage: bench machine|speed|threads|growth|limits FIGURES.csv [--quick]
#include "tests/bench/bench.hpp"

#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>

#include "raster/fast/draw_fast.hpp"
#include "tests/bench/gl_peer.hpp"

namespace relevo::bench {
namespace {

// The text behind `key` in /proc/cpuinfo.
std::string processor(const std::string& key) {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with(key + "\t")) return line.substr(std::min(line.size(), line.find(':') + 2));
    return "?";
}

int processors() {
    std::ifstream info("/proc/cpuinfo");
    int count = 0;
    for (std::string line; std::getline(info, line);) count += line.starts_with("processor\t");
    return count;
}

}  // namespace

void machine(Report& report) {
    char date[16];
    const std::time_t now = std::time(nullptr);
    std::strftime(date, sizeof date, "%Y-%m-%d", std::gmtime(&now));
    std::string sets;
    for (const auto set : raster::fast::instruction_sets())
        sets += (sets.empty() ? "" : ", ") + std::string(name(set));
#ifdef __clang__
    const std::string compiler = "clang++ " __clang_version__;
#else
    const std::string compiler = "g++ " __VERSION__;
#endif
    report.say(std::string(date) + ", " + processor("model name") + " (family " + processor("cpu family") +
               ", model " + processor("model") + ", " + std::to_string(processors()) + " cores; " + sets +
               "), " + compiler + ";\npeer: " + GlPeer::renderer() + ".");
}

}  // namespace relevo::bench

int main(int argc, char** argv) {
    using namespace relevo::bench;
    const std::string part = argc > 1 ? argv[1] : "";
    const bool quick = argc == 4 && std::strcmp(argv[3], "--quick") == 0;
    const bool known =
        part == "machine" || part == "speed" || part == "threads" || part == "growth" || part == "limits";
    if (!known || argc < 3 || argc > 4 || (argc == 4 && !quick))
        return std::fprintf(stderr,
                            "usage: bench machine|speed|threads|growth|limits FIGURES.csv [--quick]\n"),
               2;
    Report report(part, argv[2]);
    if (part == "machine") machine(report);
    if (part == "speed") speed(report, quick);
    if (part == "threads") threads(report, quick);
    if (part == "growth") growth(report, quick);
    if (part == "limits") limits(report, quick);
    if (!report.written()) return std::fprintf(stderr, "cannot write %s\n", argv[2]), 2;
    return report.good() ? 0 : 1;
}
