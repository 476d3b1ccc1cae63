// Two threads beside one, wall time: on free cores, and while other threads keep every core busy.
#include <atomic>
#include <cstdint>
#include <thread>

#include "raster/fast/workers.hpp"
#include "tests/bench/bench.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/ours.hpp"

namespace relevo::bench {
namespace {

// A few milliseconds of a processor's time; touches no memory.
void keep_busy() {
    std::uint64_t x = 1;
    for (int k = 0; k < 4'000'000; ++k) x = x * 6364136223846793005u + 1442695040888963407u;
    asm volatile("" : : "r"(x));
}

struct Measured {
    double one, two, cores;  // milliseconds; how many cores this program really got
};
Measured measure(const Workload& workload, Mode mode, Rounds rounds) {
    raster::fast::Workers workers(2);
    Ours one(workload, mode, full_width, full_height, {.instruction_set = widest()}),
        two(workload, mode, full_width, full_height, {.instruction_set = widest(), .workers = &workers});
    Contestant contestants[] = {{"1", [&](int frame) { one.draw(frame); }},
                                {"2", [&](int frame) { two.draw(frame); }},
                                {"busy", [](int) { keep_busy(); }},
                                {"busy twice", [&](int) { workers.run(2, [](int, int) { keep_busy(); }); }}};
    // a frame each: how the system deals out busy cores lasts longer than a row of frames
    take_turns(contestants, Clock::Wall, {rounds.rounds * rounds.frames, 1});
    return {contestants[0].milliseconds, contestants[1].milliseconds,
            2 * contestants[2].milliseconds / contestants[3].milliseconds};
}

// Threads that compute for as long as this object lives.
class Load {
  public:
    explicit Load(unsigned count) {
        for (unsigned k = 0; k < count; ++k)
            threads_.emplace_back([this] {
                while (!done_) keep_busy();
            });
    }
    ~Load() {
        done_ = true;
        for (std::thread& thread : threads_) thread.join();
    }

  private:
    std::atomic<bool> done_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace

void threads(Report& report, bool quick) {
    const Rounds rounds = quick ? Rounds{1, 3} : Rounds{5, 7};
    report.say(
        "Two threads beside one: wall ms of a frame, in turn. `cores`: how many a program of two threads got"
        " meanwhile, by plain arithmetic;\nwith fewer than 1.9 the row says nothing about us. Under load "
        "every core"
        " has another thread that never rests.");
    report.heading({"scene", "mode", "1 thread", "2 threads", "faster", "at least", "cores", "met"});
    for (const Workload& workload : {torus_1k(), torus_100k(), torus_1m(), fill_workload()})
        for (const Mode mode : {Mode::Unlit, Mode::Phong}) {
            const Measured m = measure(workload, mode, rounds);
            const double faster = m.one / m.two, least = 1.7;
            const bool judged = mode == Mode::Phong && workload.name != "torus_1k", free = m.cores >= 1.9;
            std::string met = "-";
            if (judged && free)
                met = report.judge(workload.name, name(mode), "1 / 2 threads", faster, "times", least,
                                   faster >= least);
            else
                report.figure(workload.name, name(mode), "1 / 2 threads", faster, "times");
            if (judged && !free) met = "fewer than 2 free cores";
            report.figure(workload.name, name(mode), "free cores", m.cores, "cores");
            report.row({workload.name, name(mode), digits(m.one), digits(m.two), digits(faster),
                        judged ? digits(least) : "-", digits(m.cores), met});
        }
    const Load load(std::max(2u, std::thread::hardware_concurrency()));
    const Workload workload = torus_100k();
    const Measured m = measure(workload, Mode::Phong, rounds);
    const double faster = m.one / m.two;
    report.row({workload.name + " under load", name(Mode::Phong), digits(m.one), digits(m.two),
                digits(faster), digits(1), digits(m.cores),
                report.judge(workload.name + " under load", name(Mode::Phong), "1 / 2 threads", faster,
                             "times", 1, faster >= 0.95)});
}

}  // namespace relevo::bench
