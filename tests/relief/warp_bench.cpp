// How fast the pre-warp is: warps a second on one thread by each resampler, their times as multiples of
// the interleaved one (Clua 2004, table 8.1: one-dimensional 1.16, asymmetric 1.17, compensated 1.21),
// and what a second thread gives at 1024 x 1024.
//
//   warp_bench [--rounds N]       processor time of ten warps in a row, the best of N (30) rounds, the
//                                 resamplers in turn; one thread and two in turn, the median of N ratios and
//                                 its quartiles, without the pairs during which another machine of the same
//                                 host had the processors (steal in /proc/stat), as far as others are left
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <limits>
#include <vector>

#include "tests/relief/warp_workload.hpp"

namespace relevo {
namespace {

double thread_seconds() {
    std::timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Hundredths of a second, of all processors, since the start of the machine; 0 where the system does not
// tell.
long long stolen_ticks() {
    std::ifstream file("/proc/stat");
    std::string cpu;
    long long field = 0;
    file >> cpu;
    for (int i = 0; i < 8; ++i) file >> field;  // user nice system idle iowait irq softirq steal
    return file ? field : 0;
}

// A warp's, where one follows another as the viewer moves: the source is in the cache as far as it fits.
template <class Clock>
double seconds_of(Clock clock, const tests::WarpWork& work, const relief::PrewarpSettings& settings,
                  relief::Prewarped& result, relief::PrewarpMemory& memory) {
    constexpr int warps = 10;
    const double start = clock();
    for (int i = 0; i < warps; ++i) prewarp(work.source, work.warp, work.window, settings, result, memory);
    return (clock() - start) / warps;
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
                best[i] = std::min(best[i], seconds_of(thread_seconds, work, settings, result, memory));
            }
        std::printf("%-20s %8d", work.name.c_str(), work.texels);
        for (const double seconds : best) std::printf("   %6.0f (x %.2f)", 1 / seconds, seconds / best[0]);
        std::printf("\n");
    }
}

// Times of pairs that follow one another at once: what slows the machine for longer slows both.
void compare_threads(int rounds) {
    for (const tests::WarpWork& work : tests::warp_works(1024)) {
        std::vector<double> undisturbed, all;
        double best = std::numeric_limits<double>::infinity();
        relief::Prewarped result;
        relief::PrewarpMemory memory[2];
        for (int round = 0; round < rounds; ++round) {
            const auto seconds = [&](int threads) {
                relief::PrewarpSettings settings;
                settings.resampler = relief::Resampler::Asymmetric, settings.threads = threads;
                return seconds_of(wall_seconds, work, settings, result, memory[threads - 1]);
            };
            const long long stolen = stolen_ticks();
            const double one = seconds(1), two = seconds(2);
            all.push_back(one / two), best = std::min(best, two);
            if (stolen_ticks() == stolen) undisturbed.push_back(one / two);
        }
        std::vector<double>& ratios = undisturbed.empty() ? all : undisturbed;
        std::sort(ratios.begin(), ratios.end());
        const auto quantile = [&](int quarters) { return ratios[(ratios.size() - 1) * quarters / 4]; };
        std::printf(
            "1024 x 1024, %-18s two threads %.2f times as fast as one (quartiles %.2f, %.2f; %.1f ms; %zu of "
            "%zu pairs undisturbed)\n",
            work.name.c_str(), quantile(2), quantile(1), quantile(3), 1e3 * best, undisturbed.size(),
            all.size());
    }
}

}  // namespace
}  // namespace relevo

int main(int argc, char** argv) {
    const int rounds = argc == 3 && std::strcmp(argv[1], "--rounds") == 0 ? std::atoi(argv[2]) : 30;
    relevo::compare_resamplers(std::max(rounds, 1));
    relevo::compare_threads(std::max(rounds, 1));
}
