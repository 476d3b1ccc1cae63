// How long things take, for timing.json only.
#pragma once
#include <chrono>
#include <cmath>
#include <utility>

namespace relevo::show {

class Stopwatch {
  public:
    // Milliseconds since the last call.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double, std::milli>(now - std::exchange(start_, now)).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// To the thousandth.
inline double rounded_ms(double ms) { return std::floor(ms * 1000 + 0.5) / 1000; }

}  // namespace relevo::show
