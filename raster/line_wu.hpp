// The antialiased line of Wu, "An efficient antialiasing technique", SIGGRAPH 1991: two pixels a column share
// the light by their distance from the line.
//
// Where the line passes a column between the rows r and r + 1, at r + f, pixel r gets 1 - f and pixel r + 1
// gets f. With f in 1/65536, rounded to the nearest, each pair sums to exactly 65536. (The light of a line is
// its number of columns, not its length: Wu's lines look thinner at 45 degrees, as aliased ones do.)
//
// The line ends upright at its ends, wherever they are: the first and the last column get the part of their
// width that the line passes, and that part is shared by the same rule, with f where the line, prolonged if
// need be, passes the middle of the column. A line from pixel to pixel so has half of its light in its first
// and last column, and lines that follow one another add up to one. A line without length has no light.
//
// A steep line is the same with rows for columns. A to B is B to A. f is exact to 2^-17 + 2^-53 a column
// (line_track.hpp), and only columns in the box cost anything; they get the light of the uncut line. Ends
// that are not finite or beyond largest_line_place: nothing is drawn.
#pragma once
#include "pipeline/probe.hpp"
#include "raster/line_track.hpp"

namespace relevo::raster {

struct WuStarted {
    LineTrack track;
};

// A column (steep: row) whose pair, or one pixel of it, can lie in the box.
struct WuPair {
    std::int64_t column;
    double position;   // across, where the line passes the middle of the column
    std::int64_t row;  // the pair is `row` and `row + 1` (steep: columns)
    int extent;        // how much of the column's width the line passes, in 1/65536
    int light[2];      // of the pair; the sum is `extent`
};

namespace line_wu_detail {

inline constexpr Fixed half_unit = Fixed{1} << 47;  // added to a position, so that 1/65536 are rounded

// The pair of one column. `inside`: it lies in the box, nothing needs to be compared.
template <bool steep, bool inside, class Cover, class Probe>
void pair(Fixed position, std::int64_t column, int extent, const PixelBox& box, Cover& cover, Probe& probe) {
    const std::int64_t row = pixel_of(position);
    const auto f = static_cast<int>(static_cast<std::uint64_t>(position) >> 48);
    const int far = static_cast<int>((std::int64_t{extent} * f + full_coverage / 2) / full_coverage);
    const int light[2] = {extent - far, far};
    if constexpr (pipeline::Wants<Probe, WuPair>)
        probe.on(WuPair{
            column, static_cast<double>(position - half_unit) * 0x1p-64, row, extent, {light[0], light[1]}});
    for (int i = 0; i < 2; ++i) {
        const std::int64_t x = steep ? row + i : column, y = steep ? column : row + i;
        if (light[i] > 0 && (inside || box.holds(x, y)))
            cover(static_cast<int>(y), static_cast<int>(x), static_cast<int>(x) + 1, light[i]);
    }
}

template <bool steep, bool inside, class Cover, class Probe>
void pairs(const LineTrack& track, Columns columns, const PixelBox& box, Cover& cover, Probe& probe) {
    Fixed position = track.position(columns.first) + half_unit;
    for (std::int64_t column = columns.first; column <= columns.last; ++column, position += track.step)
        pair<steep, inside>(position, column, full_coverage, box, cover, probe);
}

template <bool steep, class Cover, class Probe>
void draw(const LineTrack& track, const PixelBox& box, Cover& cover, Probe& probe) {
    const std::int64_t low = steep ? box.x0 : box.y0, high = steep ? box.x1 : box.y1;
    const auto last = std::max(track.first, static_cast<std::int64_t>(std::ceil(track.to.x - 0.5)));
    const Columns in_box{std::max<std::int64_t>(track.first, steep ? box.y0 : box.x0),
                         std::min<std::int64_t>(last, steep ? box.y1 : box.x1)};
    const auto rows_from = [](std::int64_t row) { return Fixed{row} * one_pixel - half_unit; };
    Columns columns = columns_within(track, in_box, rows_from(low - 1), rows_from(high + 1) - 1);
    if (columns.empty()) return;
    const auto end = [&](std::int64_t column) {  // the first or the last column: part of its width
        const double width = std::min(track.to.x, static_cast<double>(column) + 0.5) -
                             std::max(track.from.x, static_cast<double>(column) - 0.5);
        pair<steep, false>(track.position(column) + half_unit, column,
                           static_cast<int>(std::floor(full_coverage * width + 0.5)), box, cover, probe);
    };
    const bool ends_here = columns.last == last;
    if (columns.first == track.first) end(columns.first++);
    if (ends_here && last > track.first) --columns.last;
    if (!columns.empty()) {
        const Columns clear = columns_within(track, columns, rows_from(low), rows_from(high) - 1);
        const bool inside = clear.first == columns.first && clear.last == columns.last;
        inside ? pairs<steep, true>(track, columns, box, cover, probe)
               : pairs<steep, false>(track, columns, box, cover, probe);
    }
    if (ends_here && last > track.first) end(last);
}

}  // namespace line_wu_detail

// Calls cover(y, x, x + 1, coverage) for each pixel in the box that gets light, 1..65536, column by column.
template <class Cover, class Probe = const pipeline::NoProbe>
void line_wu(glm::dvec2 a, glm::dvec2 b, const PixelBox& box, Cover&& cover, Probe&& probe = {}) {
    const auto track = line_track(a, b);
    if (!track || box.empty()) return;
    pipeline::note<WuStarted>(probe, *track);
    track->steep ? line_wu_detail::draw<true>(*track, box, cover, probe)
                 : line_wu_detail::draw<false>(*track, box, cover, probe);
}

}  // namespace relevo::raster
