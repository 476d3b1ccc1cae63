// The vertical half of every resampler: samples arrive row after row of the source, and each column
// paints the pixels between a sample of this row and one of the row before.
//
// Where a row folds it reaches a column several times. Each of the samples is connected to the row
// before, never to one another, and there to the one that is nearest in depth: so sheets of the surface
// stay apart.
#pragma once
#include "relief/resample_row.hpp"

namespace relevo::relief {

// Columns first..last-1 of the result become empty.
inline void clear_columns(Prewarped& result, int first, int last) {
    const auto clear = [&](auto& image) {
        for (int y = 0; y < image.height(); ++y) {
            auto* const row = image.row(y);
            std::fill(row + first, row + last, std::remove_reference_t<decltype(*row)>{});
        }
    };
    clear(result.coverage), clear(result.kind), clear(result.writes);
}

// Writes pixels of the result.
template <bool maps>
class Painter {
  public:
    Painter(Prewarped& result, bool depth_test)
        : color_(result.color.pixels().data()),
          normal_(result.normal.pixels().data()),
          depth_(result.depth.pixels().data()),
          coverage_(result.coverage.pixels().data()),
          source_(result.source.pixels().data()),
          kind_(result.kind.pixels().data()),
          writes_(result.writes.pixels().data()),
          width_(result.window.width),
          depth_test_(depth_test) {}

    [[gnu::always_inline]] void paint(int x, int y, const Carried<maps>& c, Kind kind) const {
        const std::size_t i = std::size_t(y) * std::size_t(width_) + std::size_t(x);
        if constexpr (maps) writes_[i] = static_cast<std::uint16_t>(writes_[i] + (writes_[i] < 65535));
        if (depth_test_ && coverage_[i] && depth_[i] < c.depth()) return;
        color_[i] = {c.part[0][0], c.part[0][1], c.part[0][2]};
        normal_[i] = {c.part[1][0], c.part[1][1], c.part[1][2]};
        depth_[i] = c.depth();
        coverage_[i] = 1;
        if constexpr (maps) source_[i] = {c.part[2][0], c.part[2][1]}, kind_[i] = kind;
    }

  private:
    LinearRgb* color_;
    Vec3* normal_;
    Scalar* depth_;
    std::uint8_t* coverage_;
    Vec2* source_;
    Kind* kind_;
    std::uint16_t* writes_;
    int width_;
    bool depth_test_;
};

// Columns first..last-1 of the window; here they count from 0.
template <bool maps>
class ColumnResampler {
  public:
    // What one row of the source has for the columns: samples 0..columns-1 are those that came first to each
    // column, behind them are those that came to a column that had one.
    class Line {
      public:
        raster::Span span{0, 0};  // columns outside have no sample
        SampleLine<maps> samples;

        explicit Line(int columns) : memory_(2 * columns), columns_(columns), size_(columns) {
            samples = memory_.line();
            make_room();
        }

        // One more sample of column x, which has one already.
        [[gnu::noinline]] void add(int x, const RowSample<maps>& sample) {
            if (size_ == memory_.size()) {
                memory_.widen(), samples = memory_.line();
                make_room();
            }
            const int i = size_++;
            next_[std::size_t(samples.count[x] == 1 ? x : last_[std::size_t(x)])] = i;
            next_[std::size_t(i)] = -1, last_[std::size_t(x)] = i;
            samples.count[x] = 2, samples.set(i, sample);
        }
        void clear() {
            std::fill(samples.count + span.x0, samples.count + span.x1, std::uint8_t{0});
            std::fill(next_.begin() + span.x0, next_.begin() + span.x1, -1);
            span = {0, 0}, size_ = columns_;
        }

      private:
        friend ColumnResampler;
        void make_room() {
            const std::size_t room = std::size_t(memory_.size());
            pixel_.resize(room), partner_.resize(room), next_.resize(room, -1);
            last_.resize(std::size_t(columns_));
        }
        void find_pixels(Scalar height) {
            const Scalar* const v = samples.v;
            Scalar* const pixel = pixel_.data();
            for (int x = span.x0; x < span.x1; ++x) pixel[x] = first_pixel(v[x], height);
            for (int i = columns_; i < size_; ++i) pixel[i] = first_pixel(v[i], height);
        }
        // The samples of a column in the order of their coming: visit(first_of(x)), then next_of.
        int first_of(int x) const { return samples.count[x] != 0 ? x : -1; }
        int next_of(int i) const { return next_[std::size_t(i)]; }
        Scalar depth(int i) const { return samples.carried[i].depth(); }

        SampleMemory<maps> memory_;
        int columns_, size_;
        std::vector<Scalar> pixel_;  // first_pixel(v), of every sample
        std::vector<int> partner_;   // the sample of the other row with which it is connected; -1: none
        std::vector<int> next_;      // the next sample of the same column; -1: none
        std::vector<int> last_;      // of a column with several
    };

    ColumnResampler(const PreparedRelief& relief, const DepthWarp& warp, const Painter<maps>& painter,
                    const Window& window, int first, int last)
        : warp_(warp),
          cut_(relief.jump == Jump::Cut),
          jump_depth_(relief.jump_depth),
          painter_(painter),
          y0_(static_cast<Scalar>(window.y0)),
          height_(static_cast<Scalar>(window.height)),
          first_(first),
          before_(last - first),
          now_(last - first),
          work_(std::size_t(last - first)),
          from_(std::size_t(last - first)),
          share_(std::size_t(last - first)) {}

    // feed_row(y, line) fills a line, in which are the samples of an older row, with those of row y.
    template <class FeedRow>
    void run(const std::vector<RowStep>& steps, FeedRow&& feed_row) {
        for (const RowStep& step : steps) {
            feed_row(step.row, now_);
            now_.find_pixels(height_);
            if (step.connects) connect(held_, step.row);
            held_ = step.row;
            std::swap(before_, now_);
        }
    }

  private:
    // A sample on its way down or up its column.
    struct Stop {
        const Carried<maps>* carried;
        Scalar v, weight;
        Scalar pixel;  // first_pixel(v)
        Kind kind;
    };

    // Paints what lies between the rows `held` (before_) and `row` (now_).
    void connect(int held, int row) {
        const bool down = held < row;
        const Line &upper = down ? before_ : now_, &lower = down ? now_ : before_;
        const SampleLine<maps>&a = upper.samples, &b = lower.samples;
        const raster::Span span = hull(upper.span, lower.span);
        find_work(span, a, b, upper.pixel_.data(), lower.pixel_.data(), work_.data(), from_.data(),
                  share_.data());
        if (cut_)
            for (int x = span.x0; x < span.x1; ++x)
                if (a.count[x] == 1 && b.count[x] == 1 && is_jump(a.carried[x], b.carried[x]))
                    work_[std::size_t(x)] = Work::Other;
        const Work* const work = work_.data();
        const Scalar *const from = from_.data(), *const share = share_.data();
        const Painter<maps> painter = painter_;
        for (int x = span.x0; x < span.x1; ++x) {
            if (work[x] == Work::None) continue;
            if (work[x] == Work::Other) {
                connect_column(x, held, row);
                continue;
            }
            const Kind kind = maps ? kind_between(from[x] + Scalar(0.5), a.v[x], b.v[x], a.kind[x], b.kind[x],
                                                  is_jump(a.carried[x], b.carried[x]))
                                   : Kind::Sampled;
            painter.paint(first_ + x, static_cast<int>(from[x]), lerp(a.carried[x], b.carried[x], share[x]),
                          kind);
            if (work[x] == Work::Pixels) [[unlikely]] {
                const Stop upper_stop = stop(upper, x), lower_stop = stop(lower, x);
                stretch(x, static_cast<int>(from[x]) + 1,
                        static_cast<int>(std::max(upper_stop.pixel, lower_stop.pixel)), upper_stop,
                        lower_stop);
            }
        }
    }

    // What there is to do in a column: connect one sample with one, which makes no pixel, one, or more; or
    // something else.
    enum class Work : std::uint8_t { None, Pixel, Pixels, Other };

    // Of each column the first pixel between a sample of a and one of b, and its share, as if there were one
    // of each.
    [[gnu::noinline]] static void find_work(raster::Span span, const SampleLine<maps>& a,
                                            const SampleLine<maps>& b, const Scalar* pixel_a,
                                            const Scalar* pixel_b, Work* __restrict work,
                                            Scalar* __restrict from, Scalar* __restrict share) {
        const Scalar *const v_a = a.v, *const v_b = b.v, *const weight_a = a.weight,
                            *const weight_b = b.weight;
        const std::uint8_t *const count_a = a.count, *const count_b = b.count;
        for (int x = span.x0; x < span.x1; ++x) {
            const Scalar first = std::min(pixel_a[x], pixel_b[x]), at = first + Scalar(0.5);
            from[x] = first;
            share[x] = corrected_share(weight_a[x], weight_b[x], at - v_a[x], v_b[x] - at);
        }
        for (int x = span.x0; x < span.x1; ++x) {
            const int pixels = static_cast<int>(std::min(std::abs(pixel_a[x] - pixel_b[x]), Scalar(2))),
                      any = (count_a[x] | count_b[x]) != 0 ? 3 : 0;
            work[x] = static_cast<Work>(((count_a[x] == 1) & (count_b[x] == 1)) ? pixels : any);
        }
    }

    static raster::Span hull(raster::Span a, raster::Span b) {
        if (a.x0 >= a.x1) return b;
        if (b.x0 >= b.x1) return a;
        return {std::min(a.x0, b.x0), std::max(a.x1, b.x1)};
    }
    bool is_jump(const Carried<maps>& a, const Carried<maps>& b) const {
        return std::abs(a.depth() - b.depth()) > jump_depth_;
    }

    static Stop stop(const Line& line, int i) {
        return {&line.samples.carried[i], line.samples.v[i], line.samples.weight[i],
                line.pixel_[std::size_t(i)], maps ? line.samples.kind[i] : Kind::Sampled};
    }

    // Each sample of this row with the one of the row before, in its column, that is nearest in depth. What
    // is not connected sticks out.
    [[gnu::noinline]] void connect_column(int x, int held, int row) {
        const bool down = held < row;
        Line &before = before_, &now = now_;
        int *const before_partner = before.partner_.data(), *const now_partner = now.partner_.data();
        for (int i = before.first_of(x); i >= 0; i = before.next_of(i)) before_partner[i] = -1;
        for (int i = now.first_of(x); i >= 0; i = now.next_of(i)) {
            int nearest = before.first_of(x);
            now_partner[i] = -1;
            if (nearest < 0) continue;
            const Scalar depth = now.depth(i);
            Scalar least = std::abs(before.depth(nearest) - depth);
            for (int k = before.next_of(nearest); k >= 0; k = before.next_of(k))
                if (const Scalar apart = std::abs(before.depth(k) - depth); apart <= least)
                    least = apart, nearest = k;
            if (cut_ && least > jump_depth_) continue;
            now_partner[i] = nearest, before_partner[nearest] = i;
        }
        for (int i = before.first_of(x); i >= 0; i = before.next_of(i))
            if (before_partner[i] < 0) stick_out(x, held, stop(before, i), down ? 1 : -1);
        for (int i = now.first_of(x); i >= 0; i = now.next_of(i)) {
            const int other = now_partner[i];
            if (other < 0) {
                stick_out(x, row, stop(now, i), down ? -1 : 1);
                continue;
            }
            const Scalar one = now.pixel_[std::size_t(i)], two = before.pixel_[std::size_t(other)];
            if (one == two) continue;
            const Stop here = stop(now, i), there = stop(before, other);
            down ? stretch(x, there, here) : stretch(x, here, there);
        }
    }

    // From the sample of the upper source row to that of the lower one: pixels from..to-1.
    void stretch(int x, int from, int to, const Stop& a, const Stop& b) const {
        const bool jump = maps && is_jump(*a.carried, *b.carried);
        for (int y = from; y < to; ++y) {
            const Scalar at = static_cast<Scalar>(y) + Scalar(0.5);
            const Kind kind = maps ? kind_between(at, a.v, b.v, a.kind, b.kind, jump) : Kind::Sampled;
            const Scalar share = corrected_share(a.weight, b.weight, at - a.v, b.v - at);
            painter_.paint(first_ + x, y, lerp(*a.carried, *b.carried, share), kind);
        }
    }
    void stretch(int x, const Stop& a, const Stop& b) const {
        stretch(x, static_cast<int>(std::min(a.pixel, b.pixel)), static_cast<int>(std::max(a.pixel, b.pixel)),
                a, b);
    }

    // The half texel above (-1) or below (1) a sample of a row of the source that has no neighbour
    // there.
    void stick_out(int x, int row, const Stop& stop, int side) const {
        Carried<maps> carried = *stop.carried;
        const Scalar depth = depth_beyond(carried.depth(), carried.growth()),
                     v = warped_v(static_cast<Scalar>(2 * row + 1 + side) / 2, depth, warp_) - y0_;
        const Scalar end = first_pixel(v, height_);
        if (static_cast<Scalar>(side) * (end - stop.pixel) <= 0) return;  // folds back
        carried.set_depth(depth);
        stretch(x, stop, {&carried, v, weight_at(depth, warp_), end, Kind::Sampled});
    }

    DepthWarp warp_;
    bool cut_;
    Scalar jump_depth_;
    Painter<maps> painter_;
    Scalar y0_, height_;
    int first_;
    Line before_, now_;
    int held_ = -2;           // the row in before_
    std::vector<Work> work_;  // these three: of each column, between the two lines
    std::vector<Scalar> from_, share_;
};

}  // namespace relevo::relief
