#include "tests/bench/measure.hpp"

#include <algorithm>
#include <ctime>

namespace relevo::bench {

double milliseconds(Clock clock) {
    timespec t;
    clock_gettime(clock == Clock::Cpu ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void take_turns(std::span<Contestant> contestants, Clock clock, Rounds rounds) {
    std::vector<std::vector<double>> medians(contestants.size());
    for (int round = -1; round < rounds.rounds; ++round) {
        std::vector<std::vector<double>> times(contestants.size());
        for (int frame = 0; frame < (round < 0 ? 1 : rounds.frames); ++frame)
            for (std::size_t k = 0; k < contestants.size(); ++k) {
                if (contestants[k].slow && frame != (round < 0 ? 0 : rounds.frames / 2)) continue;
                const double start = milliseconds(clock);
                contestants[k].draw(frame);
                times[k].push_back(milliseconds(clock) - start);
            }
        if (round < 0) continue;
        for (std::size_t k = 0; k < contestants.size(); ++k) medians[k].push_back(median(times[k]));
    }
    for (std::size_t k = 0; k < contestants.size(); ++k) contestants[k].milliseconds = median(medians[k]);
}

}  // namespace relevo::bench
