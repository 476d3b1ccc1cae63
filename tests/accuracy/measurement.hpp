// How far the machine is from exact arithmetic: what the rows of samples/scene/accuracy.hpp are checked with.
//
// To add a row: write it into that table, a function that measures it into one of the files here, and a piece
// of work of the same name into instructions.cpp; `scripts/instructions` prints the figure for the table.
#pragma once
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <span>
#include <string>
#include <string_view>

namespace relevo::accuracy {

// The largest error seen, and the input that had it.
struct Measured {
    double error = 0;
    std::string worst;

    template <class Describe>
    void see(double candidate, Describe&& describe) {
        if (!(candidate <= error)) error = candidate, worst = describe();
    }
};

struct Measurement {
    std::string_view row;  // its name in the table
    Measured (*measure)();
};

std::span<const Measurement> elementary_measurements();
std::span<const Measurement> geometry_measurements();
std::span<const Measurement> surface_measurements();
std::span<const Measurement> knob_measurements();
std::span<const Measurement> line_measurements();
std::span<const Measurement> curve_measurements();
std::span<const Measurement> plane_measurements();
std::span<const Measurement> relief_measurements();

// One ulp of a float in [1, 2) is two of these.
inline constexpr double float_unit = 0x1p-24;

// The same numbers with every library: the generator is fixed by the standard, its distributions are not.
class Random {
  public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}
    double between(double low, double high) { return low + (high - low) * (double(bits_() >> 11) * 0x1p-53); }
    int whole(int low, int high) { return low + int(bits_() % std::uint64_t(high - low + 1)); }
    // Every size between low and high is as likely as any other: 0.01..0.1 as 10..100.
    double of_any_size(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

  private:
    std::mt19937_64 bits_;
};

template <class... Values>
std::string text(const char* format, Values... values) {
    char line[300];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

}  // namespace relevo::accuracy
