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
        for (std::size_t k = 0; k < contestants.size(); ++k) {
            const Contestant& contestant = contestants[k];
            std::vector<double> times;
            const int first = contestant.slow && round >= 0 ? rounds.frames / 2 : 0;
            const int count = contestant.slow || round < 0 ? 1 : rounds.frames;
            for (int frame = first; frame < first + count; ++frame) {
                const double start = milliseconds(clock);
                contestant.draw(frame);
                times.push_back(milliseconds(clock) - start);
            }
            if (round >= 0) medians[k].push_back(median(times));
        }
    }
    for (std::size_t k = 0; k < contestants.size(); ++k) contestants[k].milliseconds = median(medians[k]);
}

}  // namespace relevo::bench
