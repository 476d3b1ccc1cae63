// How fast the pre-warp is: warps a second on one thread by each resampler, their times as multiples of
// the interleaved one (Clua 2004, table 8.1: one-dimensional 1.16, asymmetric 1.17, compensated 1.21),
// and what a second thread gives at 1024 x 1024.
//
//   warp_bench [--rounds N]       processor time of ten warps in a row, the best of N (30) rounds, the
//                                 resamplers in turn; one thread and two in turn, the median of N ratios and
//                                 its quartiles, of pairs before and after which two threads had two
//                                 cores by plain arithmetic (at least 1.9); at most 10 N pairs
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <vector>

#include "tests/relief/warp_workload.hpp"
#include "tests/support/free_cores.hpp"

namespace relevo {
namespace {

double thread_seconds() {
    std::timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
// Warps that follow one another as the viewer moves: the source is in the cache as far as it fits.
void warp_on(int warps, const tests::WarpWork& work, const relief::PrewarpSettings& settings,
             relief::Prewarped& result, relief::PrewarpMemory& memory) {
    for (int i = 0; i < warps; ++i) prewarp(work.source, work.warp, work.window, settings, result, memory);
}

void compare_resamplers(int rounds) {
    std::printf("%-20s %8s", "256 x 256, warps/s", "texels");
    for (const auto& [name, resampler] : tests::warp_resamplers) std::printf(" %17s", name);
    std::printf("\n");
    for (const tests::WarpWork& work : tests::warp_works()) {
        constexpr std::size_t count = std::size(tests::warp_resamplers);
        double best[count];
        std::fill_n(best, count, std::numeric_limits<double>::infinity());
        relief::Prewarped result;
        relief::PrewarpMemory memory;
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < count; ++i) {
                relief::PrewarpSettings settings;
                settings.resampler = tests::warp_resamplers[i].resampler;
                constexpr int warps = 10;
                const double start = thread_seconds();
                warp_on(warps, work, settings, result, memory);
                best[i] = std::min(best[i], (thread_seconds() - start) / warps);
            }
        std::printf("%-20s %8d", work.name.c_str(), work.texels);
        for (const double seconds : best) std::printf("   %6.0f (x %.2f)", 1 / seconds, seconds / best[0]);
        std::printf("\n");
    }
}

void compare_threads(int rounds) {
    for (const tests::WarpWork& work : tests::warp_works(1024)) {
        relief::Prewarped result;
        relief::PrewarpMemory memory[2];
        const auto warps_by = [&](int threads) {
            return [&, threads] {
                relief::PrewarpSettings settings;
                settings.resampler = relief::Resampler::Asymmetric, settings.threads = threads;
                warp_on(4, work, settings, result, memory[threads - 1]);
            };
        };
        std::vector<tests::OneAndTwo> pairs =
            tests::take_turns_on_free_cores(rounds, warps_by(1), warps_by(2));
        const std::size_t all = pairs.size();
        std::erase_if(pairs, [](const tests::OneAndTwo& pair) { return !pair.on_two_cores(); });
        const auto faster = [&](int quarters) {
            return tests::quartile(pairs, quarters, tests::faster_by_two);
        };
        std::printf(
            "1024 x 1024, %-18s two threads %.2f times as fast as one (quartiles %.2f, %.2f; %zu of %zu "
            "pairs "
            "had two cores)\n",
            work.name.c_str(), faster(2), faster(1), faster(3), pairs.size(), all);
    }
}

}  // namespace
}  // namespace relevo

int main(int argc, char** argv) {
    const int rounds = argc == 3 && std::strcmp(argv[1], "--rounds") == 0 ? std::atoi(argv[2]) : 30;
    relevo::compare_resamplers(std::max(rounds, 1));
    relevo::compare_threads(std::max(rounds, 1));
}
