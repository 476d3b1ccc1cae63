// The weight of a cone over a half-plane: what weighted area sampling needs to know of straight edges
// (textbook section 8.2; Gupta and Sproull, "Filtering edges for gray-scale displays", SIGGRAPH 1981).
//
// The cone stands on a pixel's centre with radius 1 and height 3/pi, so that its volume is 1 (the textbook
// leaves the height open). Cut by a line at the distance s from the centre, its part on one side is
//
//     H(s) = 1/2 + (2 s L + asin s - s^3 ln((1 + L) / s)) / pi,   L = sqrt(1 - s^2),   H(-s) = 1 - H(s)
//
// for 0 < s <= 1: the volume of all slices p(u) = 3/pi (L - u^2 ln((1 + L) / u)) with u < s. A strip of width
// w whose middle passes at the distance t weighs H(t + w/2) - H(t - w/2): one table serves every width, and
// the weights of a line, summed across it, are its width.
#pragma once
#include <array>
#include <cstdint>

namespace relevo::raster {

// H(s), from the formula, to 1e-13. 0 below -1 and 1 above 1; not a number for one.
double cone_half_plane(double s);

// H at steps of 1/256, in 2^-30. Between the steps a straight line is within 3e-6 of the truth. The table
// goes on to -reach and reach with 0 and 1, so that thin lines need not ask where the cone ends.
struct ConeTable {
    static constexpr int steps = 256, reach = 3;
    static constexpr std::int64_t one = std::int64_t{1} << 32;
    std::array<std::int32_t, 2 * reach * steps + 2> at;  // one more: the right neighbour of the last

    // H(s) in 2^-30, s in 2^-32.
    std::int32_t operator()(std::int64_t s) const { return within(s < -one ? -one : s > one ? one : s); }

    // The same for -reach <= s <= reach.
    std::int32_t within(std::int64_t s) const {
        const std::int64_t place = s + reach * one;
        const auto i = static_cast<std::size_t>(place >> 24);
        const std::int64_t part = place & 0xffffff;
        return at[i] + static_cast<std::int32_t>((std::int64_t{at[i + 1] - at[i]} * part) >> 24);
    }
};

const ConeTable& cone_table();

}  // namespace relevo::raster
