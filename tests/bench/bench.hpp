// The parts of the benchmark: each writes its tables and says what was missed. `quick`: fewer rounds and
// sizes, to see that all works; its figures mean little.
#pragma once
#include "tests/bench/report.hpp"
#include "tests/bench/workload.hpp"

namespace relevo::bench {

inline constexpr int full_width = 1920, full_height = 1080;

inline Workload torus_1k() { return torus_workload("torus_1k", 32, 16); }
inline Workload torus_100k() { return torus_workload("torus_100k", 316, 158); }
inline Workload torus_1m() { return torus_workload("torus_1m", 1000, 500); }

void machine(Report& report);              // what all this was measured on
void speed(Report& report, bool quick);    // one thread, beside llvmpipe and the textbook path
void threads(Report& report, bool quick);  // two threads beside one, on free cores and on busy ones
void growth(Report& report, bool quick);   // time and memory, by triangles and by pixels
void limits(Report& report, bool quick);   // how far from what memory can take

}  // namespace relevo::bench
