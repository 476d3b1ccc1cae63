// Coverage of antialiased lines in tests: pixel -> coverage, and which pixels were told twice.
#pragma once
#include <cstdint>
#include <map>
#include <random>
#include <utility>

#include "raster/pixel.hpp"

namespace relevo::tests {

struct Coverage {
    std::map<std::pair<int, int>, int> at;  // (y, x)
    bool twice = false, outside_of_range = false;

    void operator()(int y, int x0, int x1, int coverage) {
        outside_of_range = outside_of_range || coverage < 1 || coverage > raster::full_coverage || x0 >= x1;
        for (int x = x0; x < x1; ++x) twice = !at.emplace(std::pair{y, x}, coverage).second || twice;
    }
    bool sound() const { return !twice && !outside_of_range; }
    int of(int x, int y) const {
        const auto found = at.find({y, x});
        return found == at.end() ? 0 : found->second;
    }
    double sum() const {
        double total = 0;
        for (const auto& [place, coverage] : at) total += coverage;
        return total / raster::full_coverage;
    }
    Coverage within(const raster::PixelBox& box) const {
        Coverage kept;
        for (const auto& [place, coverage] : at)
            if (box.holds(place.second, place.first)) kept.at.emplace(place, coverage);
        return kept;
    }
    friend bool operator==(const Coverage& a, const Coverage& b) { return a.at == b.at; }
};

class Random {
  public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}
    double real(double low, double high) { return low + (high - low) * (double(bits_() >> 11) * 0x1p-53); }
    int whole(int low, int high) { return low + int(bits_() % std::uint64_t(std::int64_t{high} - low + 1)); }

  private:
    std::mt19937_64 bits_;
};

}  // namespace relevo::tests
