// The vertical half of every resampler: samples arrive row after row of the source, and each column paints
// the pixels between the sample of this row and that of the row before.
//
// A row may reach a column twice, where it folds. Both samples are connected to the row before, never to one
// another: the next row sees the one that came last, which is the nearest.
#pragma once
#include "relief/resample_row.hpp"

namespace relevo::relief {

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

    void paint(int x, int y, const Carried<maps>& c, Kind kind) const {
        const std::size_t i = std::size_t(y) * std::size_t(width_) + std::size_t(x);
        const Scalar r = 1 / c.slot[c.weight], d = c.slot[c.depth] * r;
        if constexpr (maps) writes_[i] += writes_[i] < 65535;
        if (depth_test_ && coverage_[i] && depth_[i] < d) return;
        color_[i] = {c.slot[c.red] * r, c.slot[c.green] * r, c.slot[c.blue] * r};
        normal_[i] = {c.slot[c.normal_x] * r, c.slot[c.normal_y] * r, c.slot[c.normal_z] * r};
        depth_[i] = d;
        coverage_[i] = 1;
        if constexpr (maps) {
            source_[i] = {c.slot[c.source_u] * r, c.slot[c.source_v] * r};
            kind_[i] = kind;
        }
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

// Columns first..last-1 of the window.
template <bool maps>
class ColumnResampler {
  public:
    ColumnResampler(const DepthWarp& warp, const PrewarpSettings& settings, const Painter<maps>& painter,
                    const Window& window, int first, int last)
        : warp_(warp),
          settings_(settings),
          painter_(painter),
          window_(window),
          first_(first),
          before_(static_cast<std::size_t>(last - first)),
          now_(before_.size()) {}

    // feed_row(y, sink) sends the samples of row y of the source to sink(x, sample); rows outside of
    // 0..rows-1 are asked for, too, and have none.
    template <class FeedRow>
    void run(const OcclusionOrder& order, int rows, FeedRow&& feed_row) {
        const int above = texels_before(order.v, rows);
        int held = -2;  // the row in before_
        for_each_gap(order.v, rows, order.toward, [&](int k) {
            if (held != k && held != k + 1) {
                held = (k < above) == order.toward ? k : k + 1;
                clear(before_);
                feed_row(held, [&](int x, const RowSample<maps>& sample) { keep(before_, x, sample); });
            }
            const bool down = held == k;
            const int row = down ? k + 1 : k;
            clear(now_);
            if (down)
                feed_row(row, [&](int x, const RowSample<maps>& sample) { arrive<true>(x, row, sample); });
            else
                feed_row(row, [&](int x, const RowSample<maps>& sample) { arrive<false>(x, row, sample); });
            for (std::size_t i = 0; i < before_.size(); ++i)
                if (before_[i].state == State::Open)
                    stick_out(first_ + static_cast<int>(i), held, before_[i].sample, down ? 1 : -1);
            held = row;
            std::swap(before_, now_);
        });
    }

  private:
    enum class State : std::uint8_t { Empty, Open, Connected };  // Open: nothing painted beyond it yet
    struct Place {
        RowSample<maps> sample;
        int pixel;  // first_pixel(sample.v)
        State state;
    };
    using Line = std::vector<Place>;

    static void clear(Line& line) {
        for (Place& place : line) place.state = State::Empty;
    }
    Place& keep(Line& line, int x, const RowSample<maps>& sample) {
        return line[static_cast<std::size_t>(x - first_)] = {sample, first_pixel(sample.v, window_.height),
                                                             State::Open};
    }

    template <bool down>
    void arrive(int x, int row, const RowSample<maps>& sample) {
        constexpr int back = down ? -1 : 1;
        const Place& now = keep(now_, x, sample);
        Place& before = before_[static_cast<std::size_t>(x - first_)];
        if (before.state == State::Empty) return stick_out(x, row, sample, back);
        const Carried<maps>&c = sample.carried, &b = before.sample.carried;
        // whether the depths differ by more than the jump, both sides times both weights
        const Scalar apart =
            std::abs(b.slot[b.depth] * c.slot[c.weight] - c.slot[c.depth] * b.slot[b.weight]);
        const bool jump = apart > settings_.jump_depth * (b.slot[b.weight] * c.slot[c.weight]);
        if (jump && settings_.jump == Jump::Cut) {
            if (before.state == State::Open) stick_out(x, row + back, before.sample, -back);
            before.state = State::Connected;
            return stick_out(x, row, sample, back);
        }
        before.state = State::Connected;
        down ? stretch(x, before, now, jump) : stretch(x, now, before, jump);
    }

    // From the sample of the upper source row to that of the lower one.
    void stretch(int x, const Place& upper, const Place& lower, bool jump) const {
        const int from = std::min(upper.pixel, lower.pixel), to = std::max(upper.pixel, lower.pixel);
        if (from == to) return;
        const RowSample<maps>&a = upper.sample, &b = lower.sample;
        const Scalar inverse = 1 / (b.v - a.v);
        for (int y = from; y < to; ++y) {
            const Scalar at = static_cast<Scalar>(y) + Scalar(0.5);
            const Kind kind = maps ? kind_between(at, a.v, b.v, a.kind, b.kind, jump) : Kind::Sampled;
            painter_.paint(x, y, lerp(a.carried, b.carried, (at - a.v) * inverse), kind);
        }
    }

    // The half texel above (-1) or below (1) a sample of a row of the source that has no neighbour there.
    void stick_out(int x, int row, const RowSample<maps>& a, int side) const {
        const Carried<maps> end = half_texel_beyond(a.carried, a.slope, warp_);
        const Scalar v_end = warped_v_of(end, static_cast<Scalar>(2 * row + 1 + side) / 2, warp_) -
                             static_cast<Scalar>(window_.y0);
        const int from = first_pixel(a.v, window_.height), to = first_pixel(v_end, window_.height);
        const Scalar inverse = 1 / (v_end - a.v);
        for (int y = std::min(from, to); y < std::max(from, to); ++y)
            painter_.paint(x, y, lerp(a.carried, end, (static_cast<Scalar>(y) + Scalar(0.5) - a.v) * inverse),
                           a.kind);
    }

    DepthWarp warp_;
    PrewarpSettings settings_;
    Painter<maps> painter_;
    Window window_;
    int first_;
    Line before_, now_;
};

}  // namespace relevo::relief
