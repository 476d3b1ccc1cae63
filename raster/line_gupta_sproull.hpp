// The antialiased line of Gupta and Sproull, "Filtering edges for gray-scale displays", SIGGRAPH 1981, for
// any width: weighted area sampling by a table (textbook section 8.2).
//
// Each pixel looks at the strip of width w through a cone of radius 1 (cone_table.hpp), and what it sees
// depends only on the distance t from its centre to the middle of the line: H(t + w/2) - H(t - w/2). With
// cos = major / length,
//
//     t = (row - y) cos            y: where the line passes the middle of the column, carried by additions
//
// which for ends on pixels is the midpoint line's d: t = (2 minor - major - d) / (2 length) at the pixel
// before the choice. Pixels above and below are cos nearer or farther. A line one pixel wide lights three
// pixels a column, up to five near 45 degrees.
//
// Ends follow the same rule along the line: the weight is multiplied by H(s) - H(s - length), where s is how
// far along the line the pixel lies. That is exact where a cone sees only the sides or only an end. Where it
// sees both, a cone is no product: off by at most 0.01 of full coverage for lines longer than 2, by 0.014 for
// shorter ones (measured: the tests, the accuracy table). The table is within 2^-16.
//
// The light of a long line is width * length, within 1 % from 60 pixels on; a line along a row is sampled at
// the same distances in every column, and is exact for whole widths only.
//
// Lines across all of the plane, zero lengths (nothing), refusals: as line_wu.hpp. A width that is not above
// 0, not finite or beyond largest_line_place: nothing is drawn.
#pragma once
#include "pipeline/probe.hpp"
#include "raster/cone_table.hpp"
#include "raster/line_outline.hpp"
#include "raster/line_track.hpp"

namespace relevo::raster {

struct GuptaSproullStarted {
    LineTrack track;
    double width, length, cosine, sine;  // of the angle between the line and its major coordinate
};

// A column (steep: row) is begun.
struct GuptaSproullColumn {
    std::int64_t column;
    double position;   // across, where the line passes the middle of the column
    std::int64_t row;  // of the pixel nearest to the line
    double distance;   // from the line to that pixel's centre, positive towards larger rows
};

// A pixel of the box gets light.
struct GuptaSproullPixel {
    Pixel pixel;
    double distance;  // from the middle of the line
    double strip;     // what the cone sees of the strip
    double end;       // factor of the ends, 1 away from them
    int coverage;
};

namespace line_gupta_sproull_detail {

// The ends of a line multiply two weights; the middle of a thin one never looks beyond the table.
enum class Part { End, Middle, ThinMiddle };

// Distances and table values are in 2^-32 and 2^-30.
struct Strip {
    LineTrack track;
    double length, cosine, sine;
    std::int64_t step, half;  // from row to row; half the width
    Fixed reach;              // across, how far the line has light
    const ConeTable& table;

    template <Part part>
    std::int32_t weight(std::int64_t t) const {
        if constexpr (part == Part::ThinMiddle) return table.within(t + half) - table.within(t - half);
        return table(t + half) - table(t - half);
    }
    // The factor of the ends: the same cone, seen along the line.
    std::int32_t end(std::int64_t column, std::int64_t row) const {
        const double s = (static_cast<double>(column) - track.from.x) * cosine +
                         (static_cast<double>(row) - track.from.y) * sine;
        return table(static_cast<std::int64_t>(s * 0x1p32)) -
               table(static_cast<std::int64_t>((s - length) * 0x1p32));
    }
};

template <bool steep, Part part, class Cover, class Probe>
void columns(const Strip& strip, Columns range, const PixelBox& box, Cover& cover, Probe& probe) {
    constexpr bool ends = part == Part::End;
    const std::int64_t least = steep ? box.x0 : box.y0, most = steep ? box.x1 : box.y1;
    Fixed position = strip.track.position(range.first);
    for (std::int64_t column = range.first; column <= range.last; ++column, position += strip.track.step) {
        const std::int64_t row = pixel_of(position + one_pixel / 2);
        const auto above = static_cast<std::int64_t>((row * one_pixel - position) >> 33);  // -2^30..2^30
        const std::int64_t nearest = (above * strip.step) >> 31;
        if constexpr (pipeline::Wants<Probe, GuptaSproullColumn>)
            pipeline::note<GuptaSproullColumn>(probe, column, static_cast<double>(position) * 0x1p-64, row,
                                               static_cast<double>(nearest) * 0x1p-32);
        const std::int64_t low = std::max(pixel_of(position - strip.reach) + 1, least),
                           high = std::min(pixel_of(position + strip.reach), most);
        std::int64_t t = nearest + (low - row) * strip.step;
        for (std::int64_t across = low; across <= high; ++across, t += strip.step) {
            const std::int64_t weight = strip.template weight<part>(t),
                               end = ends ? strip.end(column, across) : 1 << 30;
            const int coverage = static_cast<int>(((ends ? (weight * end) >> 30 : weight) + (1 << 13)) >> 14);
            if (coverage <= 0) continue;
            const int x = static_cast<int>(steep ? across : column),
                      y = static_cast<int>(steep ? column : across);
            if constexpr (pipeline::Wants<Probe, GuptaSproullPixel>)
                pipeline::note<GuptaSproullPixel>(probe, Pixel{x, y}, static_cast<double>(t) * 0x1p-32,
                                                  static_cast<double>(weight) * 0x1p-30,
                                                  static_cast<double>(end) * 0x1p-30, coverage);
            cover(y, x, x + 1, coverage);
        }
    }
}

template <bool steep, class Cover, class Probe>
void draw(const Strip& strip, const PixelBox& box, Cover& cover, Probe& probe) {
    const auto& [from, to, is_steep, slope, first, at_first, step] = strip.track;
    const Fixed low = Fixed{steep ? box.x0 : box.y0} * one_pixel - strip.reach,
                high = Fixed{steep ? box.x1 : box.y1} * one_pixel + strip.reach;
    // Along the line, cones reach 1 beyond the ends, and as much inwards: so far do ends matter. The strip is
    // tilted, which carries its corners farther.
    const double margin =
        strip.cosine + std::fabs(strip.sine) * (static_cast<double>(strip.half) * 0x1p-32 + 1) + 1e-6;
    const auto up = [](double x) { return static_cast<std::int64_t>(std::ceil(x)); };
    const auto down = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
    const Columns in_box{std::max<std::int64_t>(up(from.x - margin), steep ? box.y0 : box.x0),
                         std::min<std::int64_t>(down(to.x + margin), steep ? box.y1 : box.x1)};
    const Columns all = columns_within(strip.track, in_box, low, high);
    if (all.empty()) return;
    const std::int64_t inner_first = std::clamp(up(from.x + margin), all.first, all.last + 1),
                       inner_last = std::clamp(down(to.x - margin), inner_first - 1, all.last);
    columns<steep, Part::End>(strip, {all.first, inner_first - 1}, box, cover, probe);
    if (strip.half < ConeTable::one * 3 / 4)  // a weight looks up to 2 half + 1 and a rounding far
        columns<steep, Part::ThinMiddle>(strip, {inner_first, inner_last}, box, cover, probe);
    else
        columns<steep, Part::Middle>(strip, {inner_first, inner_last}, box, cover, probe);
    columns<steep, Part::End>(strip, {inner_last + 1, all.last}, box, cover, probe);
}

}  // namespace line_gupta_sproull_detail

// Calls cover(y, x, x + 1, coverage) for each pixel in the box that gets light, 1..65536, column by column.
template <class Cover, class Probe = const pipeline::NoProbe>
void line_gupta_sproull(glm::dvec2 a, glm::dvec2 b, double width, const PixelBox& box, Cover&& cover,
                        Probe&& probe = {}) {
    namespace detail = line_gupta_sproull_detail;
    const auto track = line_track(a, b);
    if (!track || box.empty() || !(width > 0) || !(width <= largest_line_place) || a == b) return;
    const double major = track->to.x - track->from.x, minor = track->to.y - track->from.y;
    const double length = vector_length(major, minor), cosine = major / length, sine = minor / length;
    const detail::Strip strip{*track,
                              length,
                              cosine,
                              sine,
                              static_cast<std::int64_t>(std::floor(cosine * 0x1p32 + 0.5)),
                              static_cast<std::int64_t>(std::floor(width * 0x1p31 + 0.5)),
                              fixed((width / 2 + 1) / cosine),
                              cone_table()};
    pipeline::note<GuptaSproullStarted>(probe, *track, width, length, cosine, sine);
    track->steep ? detail::draw<true>(strip, box, cover, probe)
                 : detail::draw<false>(strip, box, cover, probe);
}

}  // namespace relevo::raster
