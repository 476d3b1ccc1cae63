// Growth: one thread, CPU time and memory of a frame, by the number of triangles and of pixels.
//
// Time is linear within 20 % when the straight line  ms = a + b n  that comes nearest to all sizes misses
// none of them by more than 20 %. "Nearest": its largest relative miss is the smallest possible, a >= 0.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>

#include "tests/bench/bench.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/ours.hpp"

namespace relevo::bench {
namespace {

constexpr double MiB = 1 << 20;

struct Line {
    double a = 0, b = 0, miss = std::numeric_limits<double>::infinity();  // the largest |a + b n - t| / t
};
Line line_through(double a, double b, const std::vector<double>& n, const std::vector<double>& t) {
    Line line{a, b, 0};
    for (std::size_t k = 0; k < n.size(); ++k)
        line.miss = std::max(line.miss, std::abs(a + b * n[k] - t[k]) / t[k]);
    return line;
}
// A best line misses three points alike, in turn above and below (Chebyshev), or has a = 0 and misses two:
// all such lines are tried.
Line nearest_line(const std::vector<double>& n, const std::vector<double>& t) {
    Line best;
    const auto consider = [&](double a, double b) {
        const Line line = line_through(a, b, n, t);
        if (a >= 0 && line.miss < best.miss) best = line;
    };
    const std::size_t size = n.size();
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = i + 1; j < size; ++j) {
            const double p = n[i] / t[i], q = n[j] / t[j];
            consider(0, 2 / (p + q));
            for (std::size_t k = j + 1; k < size; ++k)
                for (const double sign : {1, -1}) {
                    // a + b n = t (1 + sign e), t (1 - sign e), t (1 + sign e) at i, j, k: a, b, e by
                    // Cramer's rule
                    const double s[3] = {sign * t[i], -sign * t[j], sign * t[k]};
                    const double det = (n[j] * -s[2] - n[k] * -s[1]) - (n[i] * -s[2] - n[k] * -s[0]) +
                                       (n[i] * -s[1] - n[j] * -s[0]);
                    if (det == 0) continue;
                    const double a =
                        (t[i] * (n[j] * -s[2] - n[k] * -s[1]) - t[j] * (n[i] * -s[2] - n[k] * -s[0]) +
                         t[k] * (n[i] * -s[1] - n[j] * -s[0])) /
                        det;
                    const double b = ((t[j] * -s[2] - t[k] * -s[1]) - (t[i] * -s[2] - t[k] * -s[0]) +
                                      (t[i] * -s[1] - t[j] * -s[0])) /
                                     det;
                    consider(a, b);
                }
        }
    return best;
}

// A line of /proc/self/status in bytes, such as VmRSS (resident now) and VmHWM (the most since the last
// reset).
double memory(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key + ":")) return std::strtod(line.c_str() + key.size() + 1, nullptr) * 1024;
    return 0;
}
void reset_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

struct Size {
    Workload workload;
    int side = 0;  // of a square picture; 0: the usual one
    double n;      // triangles or pixels
};

// One scene in one mode at all sizes, in turn.
void measure(const std::string& what, const std::vector<Size>& sizes, Mode mode, Rounds rounds,
             Report& report) {
    std::vector<std::unique_ptr<Ours>> all;
    std::vector<Contestant> contestants;
    std::vector<double> held, peak, allowed;
    for (const Size& size : sizes) {
        Ours& one = *all.emplace_back(std::make_unique<Ours>(
            size.workload, mode, size.side ? size.side : full_width, size.side ? size.side : full_height,
            raster::fast::Options{.instruction_set = widest()}));
        contestants.push_back({"", [&](int frame) { one.draw(frame); }});
        // everything but the workspace is there by now
        const double before = memory("VmRSS");
        reset_peak();
        one.draw(0);
        peak.push_back(memory("VmHWM") - before);
        held.push_back(static_cast<double>(one.workspace_bytes()));
        allowed.push_back(48.0 * static_cast<double>(size.workload.mesh.vertices.size()) +
                          8.0 * static_cast<double>(size.workload.mesh.triangles()) + 64 * MiB);
    }
    take_turns(contestants, Clock::Cpu, rounds);

    std::vector<double> n, t;
    for (std::size_t k = 0; k < sizes.size(); ++k)
        n.push_back(sizes[k].n), t.push_back(contestants[k].milliseconds);
    const Line line = nearest_line(n, t);
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        const std::string size = digits(n[k] * 1e-6) + " M " + what, how = name(mode);
        const double off = 1 - (line.a + line.b * n[k]) / t[k];
        report.figure(size, how, "frame", t[k], "CPU ms");
        const bool linear = std::abs(off) <= 0.2, small = std::max(held[k], peak[k]) <= allowed[k];
        std::string met = report.judge(size, how, "off the line", off * 100, "%", 20, linear);
        const std::string word =
            report.judge(size, how, "memory beyond scene and pictures", std::max(held[k], peak[k]) / MiB,
                         "MiB", allowed[k] / MiB, small);
        if (linear) met = word;
        report.row({size, how, digits(t[k]), digits(t[k] / n[k] * 1e6), digits(off * 100) + " %",
                    digits(held[k] / MiB), digits(peak[k] / MiB), digits(allowed[k] / MiB), met});
    }
}

}  // namespace

void growth(Report& report, bool quick) {
    const Rounds rounds = quick ? Rounds{1, 1} : Rounds{5, 3};
    report.say(
        "Growth, one thread: CPU ms of a frame by triangles (1920 x 1080) and by pixels (square pictures of"
        " torus_100k). Linear within 20 %: the straight line\nthat comes nearest to all sizes misses none by "
        "more."
        " Memory beyond scene and pictures, in MiB: what the workspace says, how far resident memory "
        "rose,\nand"
        " what is allowed: 48 bytes a vertex, 8 a triangle, 64 MiB.");
    report.heading(
        {"size", "mode", "ms", "ns each", "off the line", "workspace", "resident", "allowed", "met"});
    std::vector<Size> meshes;
    for (const int ring : {316, 548, 1000, 1732, 3162}) {
        if (quick && ring > 1000) break;
        Workload torus = torus_workload("torus", ring, ring / 2);
        const double triangles = static_cast<double>(torus.mesh.triangles());
        meshes.push_back({std::move(torus), 0, triangles});
    }
    for (const Mode mode : {Mode::Unlit, Mode::Phong}) measure("triangles", meshes, mode, rounds, report);
    meshes.clear();
    std::vector<Size> pictures;
    for (const int side : {548, 1096, 2192, 4384, 8192})
        if (!quick || side < 4000) pictures.push_back({torus_100k(), side, double(side) * side});
    for (const Mode mode : {Mode::Unlit, Mode::Phong}) measure("pixels", pictures, mode, rounds, report);
}

}  // namespace relevo::bench
