// One thread: the fast path in each instruction set, the textbook path and llvmpipe on the same work.
//
// CPU time of a frame, from the vertices to the 8-bit picture. llvmpipe draws one constant colour where
// Relevo is unlit: the same work. Relevo's flat shading lights every face, which is more.
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "tests/bench/bench.hpp"
#include "tests/bench/gl_peer.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/ours.hpp"

namespace relevo::bench {
namespace {

using raster::fast::InstructionSet;

constexpr double slack = 0.05;  // what a figure may miss, as times move on a shared machine

// How many times as fast as llvmpipe the widest instruction set has to be; AVX2 half as many.
struct Required {
    const char* scene;
    Mode mode;
    double times;
};
constexpr Required required[] = {
    {"torus_1k", Mode::Unlit, 5.1},   {"torus_1k", Mode::Gouraud, 4.4},   {"torus_1k", Mode::Phong, 3.8},
    {"torus_100k", Mode::Unlit, 7.9}, {"torus_100k", Mode::Gouraud, 5.2}, {"torus_100k", Mode::Phong, 6.2},
    {"torus_1m", Mode::Unlit, 11},    {"torus_1m", Mode::Gouraud, 6.2},   {"torus_1m", Mode::Phong, 8.3},
    {"fill", Mode::Unlit, 4.7},       {"fill", Mode::Gouraud, 4.0},       {"fill", Mode::Phong, 5.3}};

std::optional<double> required_times(const std::string& scene, Mode mode) {
    for (const Required& r : required)
        if (r.scene == scene && r.mode == mode) return r.times;
    return {};
}

// The share of pixels that differ by more than 2 of 255 in a channel: silhouettes, and a little filtering.
double unlike(const raster::Image<raster::Rgba8>& a, const raster::Image<raster::Rgba8>& b) {
    std::size_t different = 0;
    for (std::size_t k = 0; k < a.pixels().size(); ++k) {
        const raster::Rgba8 p = a.pixels()[k], q = b.pixels()[k];
        different += std::abs(p.r - q.r) > 2 || std::abs(p.g - q.g) > 2 || std::abs(p.b - q.b) > 2;
    }
    return static_cast<double>(different) / static_cast<double>(a.pixels().size());
}

// The instruction sets, the widest first.
std::vector<InstructionSet> sets() {
    const auto all = raster::fast::instruction_sets();
    return {all.rbegin(), all.rend()};
}

void measure(const Workload& workload, Mode mode, Rounds rounds, Report& report) {
    std::vector<std::unique_ptr<Ours>> fast;
    std::vector<Contestant> contestants;
    for (const InstructionSet set : sets()) {
        Ours& one = *fast.emplace_back(std::make_unique<Ours>(workload, mode, full_width, full_height,
                                                              raster::fast::Options{.instruction_set = set}));
        contestants.push_back({std::string(raster::fast::name(set)), [&](int frame) { one.draw(frame); }});
    }
    Ours textbook(workload, mode, full_width, full_height);
    contestants.push_back({"textbook", [&](int frame) { textbook.draw_textbook(frame); }, true});
    GlPeer peer(workload, mode, full_width, full_height);
    contestants.push_back({"llvmpipe", [&](int frame) { peer.draw(frame); }});
    take_turns(contestants, Clock::Cpu, rounds);

    for (Contestant& c : contestants) c.draw(0);
    const bool same = std::all_of(fast.begin(), fast.end(), [&](const auto& one) {
        return same_bytes(one->picture(), textbook.picture());
    });
    const double different =
        mode == Mode::Flat ? 0 : unlike(textbook.picture().color, peer.picture());  // flat: another picture
    const bool same_work = different < 0.005;
    if (!same || !same_work) report.fail();

    const double theirs = contestants.back().milliseconds;
    const std::string scene = workload.name, how = name(mode);
    std::vector<std::string> cells{scene, how};
    for (const Contestant& c : contestants) {
        cells.push_back(digits(c.milliseconds));
        report.figure(scene, how, c.name, c.milliseconds, "CPU ms");
    }
    std::string met;
    const auto wanted = required_times(scene, mode);
    for (std::size_t k = 0; k < fast.size(); ++k) {
        const Contestant& c = contestants[k];
        const double times = theirs / c.milliseconds;
        const bool is_avx2 = c.name == name(InstructionSet::Avx2);
        if (k > 0 && !is_avx2) continue;
        const std::string what = c.name + " / llvmpipe";
        const double factor = k == 0 ? 1 : 0.5;
        cells.push_back("**" + digits(times) + "**" + (wanted ? " (" + digits(*wanted * factor) + ")" : ""));
        if (!wanted) {
            report.figure(scene, how, what, times, "times");
            continue;
        }
        const bool good = times >= *wanted * factor * (1 - slack);
        const std::string word = report.judge(scene, how, what, times, "times", *wanted * factor, good);
        if (met.empty() || !good) met = word;
    }
    report.figure(scene, how, "pixels unlike llvmpipe's", different * 100, "%");
    cells.push_back(mode == Mode::Flat ? "-" : digits(different * 100) + " %");
    cells.push_back(!same ? "**OTHER BYTES**" : !same_work ? "**OTHER PICTURE**" : met.empty() ? "-" : met);
    report.row(cells);
}

// Shading beside our own constant colour, in turn: llvmpipe's Gouraud moves too much to be the only measure.
void measure_shading(const Workload& workload, Rounds rounds, Report& report) {
    const raster::fast::Options options{.instruction_set = widest()};
    Ours unlit(workload, Mode::Unlit, full_width, full_height, options),
        gouraud(workload, Mode::Gouraud, full_width, full_height, options),
        phong(workload, Mode::Phong, full_width, full_height, options);
    Contestant contestants[] = {{"unlit", [&](int frame) { unlit.draw(frame); }},
                                {"Gouraud", [&](int frame) { gouraud.draw(frame); }},
                                {"Phong", [&](int frame) { phong.draw(frame); }}};
    take_turns(contestants, Clock::Cpu, rounds);
    report.heading({"scene", "mode", "CPU ms", "times unlit", "at most", "met"});
    for (const int k : {1, 2}) {
        const double times = contestants[k].milliseconds / contestants[0].milliseconds,
                     most = k == 1 ? 1.3 : 1.9;
        report.row({workload.name, contestants[k].name, digits(contestants[k].milliseconds), digits(times),
                    digits(most),
                    report.judge(workload.name, contestants[k].name, "shaded / unlit", times, "times", most,
                                 times <= most * (1 + slack))});
    }
}

}  // namespace

void speed(Report& report, bool quick) {
    const Rounds rounds = quick ? Rounds{1, 3} : Rounds{5, 7};
    const std::string best(raster::fast::name(widest()));
    report.say("CPU ms of a frame of " + std::to_string(full_width) + " x " + std::to_string(full_height) +
               " on one thread, median of " + std::to_string(rounds.rounds) + " rounds of " +
               std::to_string(rounds.frames) +
               " frames, in turn;\nin bold how many times as fast as llvmpipe, in brackets what is required"
               " (met within 5 %).\nllvmpipe's flat is one colour: the work of our unlit rows.");
    std::vector<std::string> cells{"scene", "mode"};
    for (const InstructionSet set : sets()) cells.emplace_back(raster::fast::name(set));
    cells.insert(cells.end(), {"textbook", "llvmpipe", best + " / llvmpipe"});
    if (widest() == InstructionSet::Avx512) cells.push_back("AVX2 / llvmpipe");
    cells.insert(cells.end(), {"unlike pixels", "met"});
    report.heading(cells);
    for (const Workload& workload : {torus_1k(), torus_100k(), torus_1m(), fill_workload()})
        for (const Mode mode : {Mode::Unlit, Mode::Flat, Mode::Gouraud, Mode::Phong, Mode::Textured})
            measure(workload, mode, rounds, report);
    measure_shading(torus_1k(), rounds, report);
}

}  // namespace relevo::bench
