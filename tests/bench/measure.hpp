// How the benchmarks measure: contestants take turns, round by round, so that whatever else the machine does
// meets all of them alike. Only ratios mean anything on a shared machine.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace relevo::bench {

enum class Clock {
    Cpu,  // of the whole process, all its threads: not disturbed by other programs' turns
    Wall
};
double milliseconds(Clock clock);
double median(std::vector<double> values);

struct Contestant {
    std::string name;
    std::function<void(int frame)> draw;
    bool slow = false;        // draws one frame a round instead of all
    double milliseconds = 0;  // found by take_turns: the median of the rounds, each the median of its frames
};

// In each round a contestant draws its frames 0, 1, 2, ... one after the other, as a program does, then the
// next one has its turn: each finds in the caches what it left there itself. One round without a clock comes
// first.
struct Rounds {
    int rounds = 5, frames = 7;
};
void take_turns(std::span<Contestant> contestants, Clock clock, Rounds rounds);

}  // namespace relevo::bench
