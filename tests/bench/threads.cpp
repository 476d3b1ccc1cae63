// Two threads beside one, wall time: on free cores, and while other threads keep every core busy.
#include <atomic>
#include <functional>
#include <thread>

#include "raster/fast/workers.hpp"
#include "tests/bench/bench.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/ours.hpp"
#include "tests/support/free_cores.hpp"

namespace relevo::bench {
namespace {

// A frame each in turn: how the system deals out busy cores lasts longer than a row of frames.
std::vector<tests::OneAndTwo> measure(const Workload& workload, Mode mode, Rounds rounds) {
    raster::fast::Workers workers(2);
    Ours one(workload, mode, full_width, full_height, {.instruction_set = widest()}),
        two(workload, mode, full_width, full_height, {.instruction_set = widest(), .workers = &workers});
    int frame_of_one = 0, frame_of_two = 0;
    return tests::take_turns_on_free_cores(
        rounds.rounds * rounds.frames, [&] { one.draw(frame_of_one++ % rounds.frames); },
        [&] { two.draw(frame_of_two++ % rounds.frames); });
}

// Medians of the pairs.
struct Measured {
    double one, two;  // milliseconds
    double faster, cores;
    explicit Measured(const std::vector<tests::OneAndTwo>& pairs)
        : one(1e3 * tests::quartile(pairs, 2, std::mem_fn(&tests::OneAndTwo::one))),
          two(1e3 * tests::quartile(pairs, 2, std::mem_fn(&tests::OneAndTwo::two))),
          faster(tests::quartile(pairs, 2, tests::faster_by_two)),
          cores(tests::quartile(pairs, 2, std::mem_fn(&tests::OneAndTwo::cores))) {}
};

// Threads that compute for as long as this object lives.
class Load {
  public:
    explicit Load(unsigned count) {
        for (unsigned k = 0; k < count; ++k)
            threads_.emplace_back([this] {
                while (!done_) tests::multiply_and_add();
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
        "Two threads beside one: wall ms of a frame, in turn, medians of the pairs before and after which two"
        " threads had two cores,\nby plain arithmetic (`cores`: at least 1.9). Under load every core has"
        " another thread that never rests, and all pairs count.");
    report.heading({"scene", "mode", "1 thread", "2 threads", "faster", "at least", "cores", "pairs", "met"});
    for (const Workload& workload : {torus_1k(), torus_100k(), torus_1m(), fill_workload()})
        for (const Mode mode : {Mode::Unlit, Mode::Phong}) {
            std::vector<tests::OneAndTwo> pairs = measure(workload, mode, rounds);
            const std::size_t all = pairs.size();
            std::erase_if(pairs, [](const tests::OneAndTwo& pair) { return !pair.on_two_cores(); });
            const Measured m(pairs);
            const double least = 1.7;
            const bool judged = mode == Mode::Phong && workload.name != "torus_1k";
            std::string met = "-";
            if (pairs.empty())
                met = "never two cores";
            else if (judged)
                met = report.judge(workload.name, name(mode), "1 / 2 threads", m.faster, "times", least,
                                   m.faster >= least);
            else
                report.figure(workload.name, name(mode), "1 / 2 threads", m.faster, "times");
            report.row({workload.name, name(mode), digits(m.one), digits(m.two), digits(m.faster),
                        judged ? digits(least) : "-", digits(m.cores),
                        std::to_string(pairs.size()) + " of " + std::to_string(all), met});
        }
    const Load load(std::max(2u, std::thread::hardware_concurrency()));
    const Workload workload = torus_100k();
    const std::vector<tests::OneAndTwo> pairs = measure(workload, Mode::Phong, rounds);
    const Measured m(pairs);
    report.row({workload.name + " under load", name(Mode::Phong), digits(m.one), digits(m.two),
                digits(m.faster), digits(1), digits(m.cores), std::to_string(pairs.size()),
                report.judge(workload.name + " under load", name(Mode::Phong), "1 / 2 threads", m.faster,
                             "times", 1, m.faster >= 0.95)});
}

}  // namespace relevo::bench
