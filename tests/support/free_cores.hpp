// One thread beside two, where two have a processor each.
//
// The processors of a virtual machine may be two threads of one core, or be shared with its neighbours, from
// one tenth of a second to the next; the system counts no time as stolen then. So arithmetic is timed on one
// thread and on two: it fills a processor's multipliers and touches no memory. Two threads of one core
// do 1.05 times as much as one of them, two cores 2 times.
#pragma once
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <vector>

#include "raster/fast/workers.hpp"

namespace relevo::tests {

template <class Work>
double seconds_of(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A few milliseconds of a processor's time.
inline void multiply_and_add() {
    constexpr int chains = 12;  // more than a processor has multipliers, times what a product takes
    std::uint64_t x[chains];
    for (int i = 0; i < chains; ++i) x[i] = i;
    for (int k = 0; k < 2'000'000; ++k)
        for (int i = 0; i < chains; ++i) x[i] = x[i] * 6364136223846793005u + 1442695040888963407u;
    for (int i = 0; i < chains; ++i) asm volatile("" : : "r"(x[i]));
}

// How many processors two threads have at the moment. `workers`: two threads.
inline double free_cores(raster::fast::Workers& workers) {
    const double one = seconds_of(multiply_and_add),
                 two = seconds_of([&] { workers.run(2, [](int, int) { multiply_and_add(); }); });
    return 2 * one / two;
}

struct OneAndTwo {
    double one, two;  // seconds
    double cores;     // the fewer of before and after
    bool on_two_cores() const { return cores >= 1.9; }
};

// one() and two() in turn, what slows the machine for longer slows both: until `wanted` pairs had two cores,
// and at most ten times as often.
template <class One, class Two>
std::vector<OneAndTwo> take_turns_on_free_cores(int wanted, One&& one, Two&& two) {
    raster::fast::Workers workers(2, false);
    std::vector<OneAndTwo> result;
    one(), two();
    double before = free_cores(workers);
    for (int found = 0; found < wanted && std::ssize(result) < 10 * wanted;) {
        const double seconds_of_one = seconds_of(one), seconds_of_two = seconds_of(two),
                     after = free_cores(workers);
        result.push_back({seconds_of_one, seconds_of_two, std::min(before, after)});
        found += result.back().on_two_cores();
        before = after;
    }
    return result;
}

// The value at 0, 1, ... 4 quarters of the pairs in rising order; not a number if there are none.
template <class Value>
double quartile(const std::vector<OneAndTwo>& pairs, int quarters, Value&& value) {
    if (pairs.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> values;
    for (const OneAndTwo& pair : pairs) values.push_back(value(pair));
    std::sort(values.begin(), values.end());
    return values[(values.size() - 1) * quarters / 4];
}
inline double faster_by_two(const OneAndTwo& pair) { return pair.one / pair.two; }

}  // namespace relevo::tests
