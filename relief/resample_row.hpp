// The horizontal half of every resampler: the texels of one source row, warped, and the samples at the
// pixel columns between them.
#pragma once
#include <cstring>
#include <limits>
#include <memory>

#include "relief/resample_line.hpp"

namespace relevo::relief {

// One row of the source after the warp: those parts of it that are wanted. Places are in pixels of the
// window. Empty texels are warped with the rest, as if they lay on the plane: no branch, and nothing
// undefined.
//
// Lines of a fixed length, so that one register finds them all and compilers see that they do not overlap;
// a little longer than a row can be, so that they do not meet in one place of a cache. Large: not for the
// stack.
struct WarpedRow {
    static constexpr int length = pipeline::max_picture_size + 16;
    int y = -1;                        // of the source; -1: none of this warp and this band
    int next_y = 0;                    // the row that is likely to follow
    std::vector<raster::Span> wanted;  // texels of the row: those that are here; no two spans touch
    Scalar u[length], v[length];       // where each texel goes
    Scalar weight[length];             // h / (h + d)
    Scalar column[length];             // first_pixel(u), within the band

    // Of the row of blocks to which row y belongs.
    std::vector<raster::Span> blocks;  // texels that may be wanted
    static constexpr int most_blocks = length / block_width + 1;
    Scalar lowest[most_blocks], highest[most_blocks], least_w[most_blocks];  // between which places each lies

    // Between texel k and the next, as if they hung together. All gaps are treated alike, four side by side,
    // which costs less than to ask which of them matter.
    enum Work : std::uint8_t { None, OneSample, More };
    Work work[length];         // what there is to do at gap k - 1
    Scalar from[length];       // the first of the columns
    Scalar t[length];          // the first sample, if there is one: its share of the way
    Scalar corrected[length];  // the same, perspective-correct
    Scalar sample_v[length], sample_weight[length];  // as in RowSample
};
inline std::unique_ptr<WarpedRow> make_warped_row() { return std::unique_ptr<WarpedRow>(new WarpedRow); }

// Columns first..last-1 of the window: those whose samples are wanted.
struct Band {
    int first, last;
};
inline Band whole(const Window& window) { return {0, window.width}; }

// The texels of a row of blocks that may have to do with a band: the blocks within, with a neighbour on
// either side, and the two texels at which a block on its left meets one on its right. With the whole window,
// all blocks with a surface.
//
// The centres of a block and the halves that stick out of its rows lie between the places to which its least
// and its largest parameter take its first and its last texel: in rounded numbers, too, because rounding
// keeps the order of sums and of products.
inline void find_blocks(const Band& band, const PreparedRelief& relief, const Warp& warp,
                        const Window& window, int row_of_blocks, WarpedRow& row) {
    const Scalar k1 = static_cast<Scalar>(warp.k1), k3 = static_cast<Scalar>(warp.k3),
                 x0 = static_cast<Scalar>(window.x0), width = static_cast<Scalar>(window.width),
                 infinity = std::numeric_limits<Scalar>::infinity();
    const bool everywhere = band.first == 0 && band.last == window.width;
    const PreparedRelief::Parameters* const blocks = relief.parameters.row(row_of_blocks);
    const int count = relief.parameters.width();
    for (int i = 0; i < (everywhere ? 0 : count); ++i) {
        const Scalar least = blocks[i].least, largest = blocks[i].largest, w_a = 1 / (1 + k3 * least),
                     w_b = 1 / (1 + k3 * largest), shift_a = k1 * least, shift_b = k1 * largest,
                     from = static_cast<Scalar>(i * block_width) + std::min(shift_a, shift_b),
                     to = static_cast<Scalar>((i + 1) * block_width) + std::max(shift_a, shift_b);
        row.lowest[i] = std::min(from * w_a, from * w_b) - x0;
        row.highest[i] = std::max(to * w_a, to * w_b) - x0;
        row.least_w[i] = std::min(w_b, w_a);  // not a number when w_b is none; where w_a is, lowest is none
    }
    enum class Side { Nowhere, Left, Within, Right };  // of the band; nowhere: there is no surface
    const auto side_of = [&](int i) {
        if (blocks[i].least > blocks[i].largest) return Side::Nowhere;
        if (everywhere || !(row.least_w[i] > 0 && row.highest[i] - row.lowest[i] < infinity))
            return Side::Within;
        if (first_pixel(row.highest[i], width) <= static_cast<Scalar>(band.first)) return Side::Left;
        if (first_pixel(row.lowest[i], width) >= static_cast<Scalar>(band.last)) return Side::Right;
        return Side::Within;
    };
    row.blocks.clear();
    const auto add = [&](int from, int to) {
        if (row.blocks.empty() || row.blocks.back().x1 < from)
            row.blocks.push_back({from, to});
        else
            row.blocks.back().x1 = to;
    };
    Side before = Side::Nowhere;
    for (int i = 0; i < count; ++i) {
        const int x = i * block_width;
        const Side side = side_of(i);
        if (side == Side::Within)
            add(x - 1, x + block_width + 1);
        else if (side != before && side != Side::Nowhere && before != Side::Nowhere)
            add(x - 1, x + 1);
        before = side;
    }
}

inline void warp_row(const PreparedRelief& relief, const Warp& warp, const Window& window, const Band& band,
                     int y, WarpedRow& row) {
    const Scalar k1 = static_cast<Scalar>(warp.k1), k2 = static_cast<Scalar>(warp.k2),
                 k3 = static_cast<Scalar>(warp.k3), at_v = static_cast<Scalar>(y) + Scalar(0.5),
                 x0 = static_cast<Scalar>(window.x0), y0 = static_cast<Scalar>(window.y0),
                 width = static_cast<Scalar>(window.width), first = static_cast<Scalar>(band.first),
                 last = static_cast<Scalar>(band.last),
                 perspective = warp.projection == Projection::Perspective ? 1 : 0;
    const Scalar* const parameter = relief.parameter.row(y);
    if (row.y < 0 || row.y / block_height != y / block_height)
        find_blocks(band, relief, warp, window, y / block_height, row);
    row.next_y = std::clamp(2 * y - row.y, 0, relief.camera.height - 1);
    row.y = y;
    row.wanted.clear();
    const raster::Span covered = relief.covered[std::size_t(y)];
    for (const raster::Span& texels : row.blocks)
        if (const raster::Span both{std::max(texels.x0, covered.x0), std::min(texels.x1, covered.x1)};
            both.x0 < both.x1)
            row.wanted.push_back(both);
    for (const raster::Span& texels : row.wanted) {
        for (int x = texels.x0; x < texels.x1; ++x) {
            const Scalar q = parameter[x], w = 1 / (1 + k3 * q);
            row.u[x] = ((static_cast<Scalar>(x) + Scalar(0.5)) + k1 * q) * w - x0;
            row.v[x] = (at_v + k2 * q) * w - y0;
            row.weight[x] = (1 + perspective * q) * w;
        }
        for (int x = texels.x0; x < texels.x1; ++x)
            row.column[x] = std::clamp(first_pixel(row.u[x], width), first, last);
    }
}

// The numbers of the gaps between the wanted texels of the row, less those at the ends of a span that have no
// sample in the band; the gaps beyond the ends matter only where the row's surface ends there. A skin that
// folds back is not drawn: it hangs behind the sheet from whose border it comes.
inline void sample_gaps(const Gap* gaps, raster::Span covered, WarpedRow& row) {
    const auto is_idle = [&](int k) {
        return row.column[k] == row.column[k + 1] && (gaps[k] >= Gap::Joined || gaps[k] == Gap::Empty);
    };
    for (raster::Span& texels : row.wanted) {
        if (texels.x0 > covered.x0)
            while (texels.x0 < texels.x1 - 1 && is_idle(texels.x0)) ++texels.x0;
        if (texels.x1 < covered.x1)
            while (texels.x0 < texels.x1 - 1 && is_idle(texels.x1 - 2)) --texels.x1;
        const int first = texels.x0, last = texels.x1 - 1;
        for (int k = first; k < last; ++k) {
            row.from[k] = std::min(row.column[k], row.column[k + 1]);
            const int columns = static_cast<int>(row.column[k + 1] - row.column[k]),
                      samples = std::min(std::abs(columns), 2);
            const bool folds = columns < 0, is_skin = gaps[k] == Gap::Across;
            const int drawn = (folds & is_skin) ? 0 : samples, sticks_out = gaps[k] == Gap::Empty ? 0 : 2;
            row.work[k + 1] = static_cast<WarpedRow::Work>(gaps[k] >= Gap::Joined ? drawn : sticks_out);
        }
        for (int k = first; k < last; ++k) {
            const Scalar at = row.from[k] + Scalar(0.5),
                         t = (at - row.u[k]) * (1 / (row.u[k + 1] - row.u[k])),
                         weight = row.weight[k] + t * (row.weight[k + 1] - row.weight[k]);
            row.t[k] = t, row.sample_weight[k] = weight;
            row.corrected[k] = t * row.weight[k + 1] / weight;
            row.sample_v[k] = row.v[k] + t * (row.v[k + 1] - row.v[k]);
        }
        row.work[first] = first == covered.x0 ? WarpedRow::More : WarpedRow::None;
        row.work[last + 1] = last + 1 == covered.x1 ? WarpedRow::More : WarpedRow::None;
    }
}

// A sample of a row at the middle of a pixel column.
template <bool maps>
struct RowSample {
    Carried<maps> carried;
    Scalar v = 0;  // where it goes, in pixels of the window
    Scalar weight = 1;
    Kind kind = Kind::Empty;
};

// The samples of a row by pixel column, each kind of number in a line of its own: of every column the
// sample that is in it, or the first of several. The memory is a SampleMemory's.
template <bool maps>
struct SampleLine {
    std::uint8_t* count;  // of the samples of a column; 2: or more
    Carried<maps>* carried;
    Scalar *v, *weight;
    Kind* kind;  // with maps only

    [[gnu::always_inline]] void set(int x, const RowSample<maps>& sample) const {
        carried[x] = sample.carried;
        v[x] = sample.v, weight[x] = sample.weight;
        if constexpr (maps) kind[x] = sample.kind;
    }
    // Kind::Empty: there is none.
    RowSample<maps> at(int x) const {
        if (count[x] == 0) return {};
        return {carried[x], v[x], weight[x], maps ? kind[x] : Kind::Sampled};
    }
};

// From the first column with a sample to behind the last.
inline raster::Span occupied(const std::uint8_t* count, int columns) {
    const auto eight_without = [count](int x) {
        std::uint64_t eight;
        std::memcpy(&eight, count + x, sizeof eight);
        return eight == 0;
    };
    raster::Span span{0, columns};
    while (span.x1 - span.x0 >= 8 && eight_without(span.x0)) span.x0 += 8;
    while (span.x0 < span.x1 && count[span.x0] == 0) ++span.x0;
    while (span.x1 - span.x0 >= 8 && eight_without(span.x1 - 8)) span.x1 -= 8;
    while (span.x0 < span.x1 && count[span.x1 - 1] == 0) --span.x1;
    return span;
}

// The memory of a line.
template <bool maps>
class SampleMemory {
  public:
    SampleMemory() = default;
    // No column has a sample.
    explicit SampleMemory(int size)
        : size_(size),
          count_(new std::uint8_t[std::size_t(size)]{}),
          carried_(new Carried<maps>[std::size_t(size)]),
          v_(new Scalar[std::size_t(size)]{}),
          weight_(new Scalar[std::size_t(size)]{}),
          kind_(maps ? new Kind[std::size_t(size)] : nullptr) {}
    int size() const { return size_; }
    SampleLine<maps> line() const {
        return {count_.get(), carried_.get(), v_.get(), weight_.get(), kind_.get()};
    }
    // Twice as long; what it holds stays.
    void widen() {
        SampleMemory wider(2 * size_);
        const SampleLine<maps> from = line(), to = wider.line();
        for (int i = 0; i < size_; ++i)
            to.count[i] = from.count[i],
            to.set(i, {from.carried[i], from.v[i], from.weight[i], maps ? from.kind[i] : Kind::Sampled});
        *this = std::move(wider);
    }

  private:
    int size_ = 0;
    std::unique_ptr<std::uint8_t[]> count_;
    std::unique_ptr<Carried<maps>[]> carried_;
    std::unique_ptr<Scalar[]> v_, weight_;
    std::unique_ptr<Kind[]> kind_;
};

// What texel (x, y) carries, c, as a resampler takes it along: the maps want to know where it came from,
// too.
template <bool maps>
[[gnu::always_inline]] inline decltype(auto) carried_by(const Carried<false>& c, int x, int y) {
    if constexpr (maps)
        return Carried<true>{
            {c.part[0], c.part[1],
             Four{static_cast<Scalar>(x) + Scalar(0.5), static_cast<Scalar>(y) + Scalar(0.5)}}};
    else
        return (c);
}

// A texel, or the end of the half texel that sticks out of it.
template <bool maps>
struct RowEnd {
    const Carried<maps>& carried;
    Scalar u, v, weight;
    Scalar column;
};

// The samples between a and b, a being the texel of the lower number or that of which b sticks out.
template <bool maps, class Method, class Emit>
[[gnu::noinline]] void sample_between(const RowEnd<maps>& a, const RowEnd<maps>& b, bool across,
                                      const DepthWarp& warp, Emit& emit) {
    const int from = static_cast<int>(std::min(a.column, b.column)),
              to = static_cast<int>(std::max(a.column, b.column));
    if (from == to) return;
    const Scalar inverse = 1 / (b.u - a.u);
    for (int x = from; x < to; ++x)
        emit(x, [&] {
            const Scalar at = static_cast<Scalar>(x) + Scalar(0.5), t = (at - a.u) * inverse,
                         weight = a.weight + t * (b.weight - a.weight);
            RowSample<maps> sample{
                lerp(a.carried, b.carried, t * b.weight / weight), a.v + t * (b.v - a.v), weight,
                maps ? kind_between(at, a.u, b.u, Kind::Sampled, Kind::Sampled, across) : Kind::Sampled};
            Method::adjust(sample, a.carried, b.carried, t, warp);
            return sample;
        });
}

// The samples from texel k half a texel to the left (side -1) or to the right (1).
template <bool maps, class Method, class Emit>
[[gnu::noinline]] void stick_out_of_row(const PreparedRelief& relief, WarpedRow& row, int k, int side,
                                        const DepthWarp& warp, const Window& window, const Band& band,
                                        Emit& emit) {
    const Carried<maps> c = carried_by<maps>(relief.carried.row(row.y)[k], k, row.y);
    Carried<maps> end = c;
    __builtin_prefetch(relief.growth_u.row(row.next_y) + k, 0, 2);  // an outline goes on close by
    const Scalar depth = depth_beyond(c.depth(), relief.growth_u.row(row.y)[k]),
                 weight = weight_at(depth, warp),
                 u = warped_u(static_cast<Scalar>(2 * k + 1 + side) / 2, depth, warp) -
                     static_cast<Scalar>(window.x0),
                 v = warped_v(static_cast<Scalar>(row.y) + Scalar(0.5), depth, warp) -
                     static_cast<Scalar>(window.y0);
    end.set_depth(depth);
    const Scalar column = row.column[k],
                 beyond = std::clamp(first_pixel(u, static_cast<Scalar>(window.width)),
                                     static_cast<Scalar>(band.first), static_cast<Scalar>(band.last));
    if (static_cast<Scalar>(side) * (beyond - column) <= 0) return;  // folds back
    sample_between<maps, Method>({c, row.u[k], row.v[k], row.weight[k], column}, {end, u, v, weight, beyond},
                                 false, warp, emit);
}

// A row is further away than processors look ahead; of the row that follows, what warping it reads first.
// Inlined always: a function that does nothing else counts as one without effect and would be left out.
[[gnu::always_inline]] inline void ask_for_next_row(const PreparedRelief& relief, const WarpedRow& row) {
    constexpr int line = 64;  // bytes
    const raster::Span texels{row.wanted.front().x0, row.wanted.back().x1};
    const Scalar* const parameter = relief.parameter.row(row.next_y);
    const Gap* const gap = relief.gap.row(row.next_y);
    for (int x = texels.x0; x < texels.x1; x += line / int(sizeof(Scalar)))
        __builtin_prefetch(parameter + x, 0, 2);
    for (int x = texels.x0; x < texels.x1; x += line) __builtin_prefetch(gap + x, 0, 2);
}

// The samples of a row in the order of painting: emit(x, sample) for one in pixel column x, where
// sample() computes it. Method: what is interpolated how
// (resample_picture.hpp).
template <bool maps, class Method, class Emit>
void resample_row(const PreparedRelief& relief, WarpedRow& row, const DepthWarp& warp,
                  const OcclusionOrder& order, const Window& window, const Band& band, Emit emit) {
    if (row.wanted.empty()) return;
    const Gap* const gaps = relief.gap.row(row.y) + 1;
    const Carried<false>*const carried = relief.carried.row(row.y), *const next =
                                                                        relief.carried.row(row.next_y);
    ask_for_next_row(relief, row);
    sample_gaps(gaps, relief.covered[std::size_t(row.y)], row);
    const raster::Span texels{row.wanted.front().x0, row.wanted.back().x1};
    const std::size_t spans = row.wanted.size();
    const int y = row.y;
    // the first sample of a connection
    const auto first_sample = [&](int k) {
        const auto& a = carried_by<maps>(carried[k], k, y);
        const auto& b = carried_by<maps>(carried[k + 1], k + 1, y);
        const Kind kind =
            maps ? kind_between(static_cast<Scalar>(row.from[k]) + Scalar(0.5), row.u[k], row.u[k + 1],
                                Kind::Sampled, Kind::Sampled, gaps[k] == Gap::Across)
                 : Kind::Sampled;
        RowSample<maps> sample{lerp<maps>(a, b, row.corrected[k]), row.sample_v[k], row.sample_weight[k],
                               kind};
        Method::adjust(sample, a, b, row.t[k], warp);
        return sample;
    };
    for (const Run& run : gap_runs(order.u - texels.x0, texels.x1 - texels.x0, order.toward)) {
        const int lowest = texels.x0 + (run.step > 0 ? run.first : run.first - run.count + 1),
                  highest = lowest + run.count - 1;
        for (std::size_t i = 0; i < spans; ++i) {
            const raster::Span& span = row.wanted[run.step > 0 ? i : spans - 1 - i];
            const int from = std::max(lowest, span.x0 - 1), to = std::min(highest, span.x1 - 1);
            std::ptrdiff_t at = run.step > 0 ? from : to;
            for (int left = to - from + 1; left > 0; --left, at += run.step) {
                const int k = static_cast<int>(at);
                const WarpedRow::Work work = row.work[k + 1];
                __builtin_prefetch(next + at, 0, 2);  // little by little: all at once would be in the way
                if (work == WarpedRow::None) continue;
                if (work == WarpedRow::OneSample) [[likely]] {
                    emit(static_cast<int>(row.from[k]), [&] { return first_sample(k); });
                    continue;
                }
                const Gap gap = gaps[k];
                if (gap >= Gap::Joined) {
                    sample_between<maps, Method>({carried_by<maps>(carried[k], k, y), row.u[k], row.v[k],
                                                  row.weight[k], row.column[k]},
                                                 {carried_by<maps>(carried[k + 1], k + 1, y), row.u[k + 1],
                                                  row.v[k + 1], row.weight[k + 1], row.column[k + 1]},
                                                 gap == Gap::Across, warp, emit);
                } else {
                    if (gap != Gap::BeforeSecond)
                        stick_out_of_row<maps, Method>(relief, row, k, 1, warp, window, band, emit);
                    if (gap != Gap::AfterFirst)
                        stick_out_of_row<maps, Method>(relief, row, k + 1, -1, warp, window, band, emit);
                }
            }
        }
    }
}

}  // namespace relevo::relief
