// Numbers as the step pictures write them.
#pragma once
#include <cstdint>
#include <string>

namespace relevo::show {

// Four significant digits: 0.3333, -12.5, 1.234e-5; no "-0"; the sign of infinity is drawn.
std::string number(double value);

// At most so many decimals, none of them a trailing 0: "2.875", "3"; no "-0".
std::string decimals(double value, int most = 3);

// 69666 -> "69,666".
std::string grouped(std::int64_t count);

// "1 triangle", "12 triangles".
std::string counted(std::int64_t count, const std::string& noun);

// 1, 2 or 5 times a power of ten, at least `least` (which is more than 0 and finite; else 1).
double nice_step(double least);

}  // namespace relevo::show
