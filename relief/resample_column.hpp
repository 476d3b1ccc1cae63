// The vertical half of every resampler: samples arrive row after row of the source, and each column
// paints the pixels between a sample of this row and one of the row before.
//
// Where a row folds it reaches a column several times. Each of the samples is connected to the row
// before, never to one another, and there to the one that is nearest in depth: so sheets of the surface
// stay apart.
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

// Columns first..last-1 of the window.
template <bool maps>
class ColumnResampler {
  public:
    ColumnResampler(const PreparedRelief& relief, const DepthWarp& warp, const Painter<maps>& painter,
                    const Window& window, int first, int last)
        : warp_(warp),
          cut_(relief.jump == Jump::Cut),
          jump_depth_(relief.jump_depth),
          painter_(painter),
          y0_(static_cast<Scalar>(window.y0)),
          height_(static_cast<Scalar>(window.height)),
          first_(first),
          before_(static_cast<std::size_t>(last - first)),
          now_(static_cast<std::size_t>(last - first)) {}

    // feed_row(y, emit) asks emit(x) for a place for each sample of row y of the source, in the order of
    // painting; rows outside of 0..rows-1 are asked for, too, and have none.
    template <class FeedRow>
    void run(const OcclusionOrder& order, int rows, FeedRow&& feed_row) {
        const int above = texels_before(order.v, rows);
        int held = -2;  // the row in before_
        const auto fill = [&](Line& line, int row) {
            line.clear();
            feed_row(row, [&line, first = first_](int x) -> RowSample<maps>& { return line.add(x, first); });
            for (int i = 0; i < line.count; ++i)
                line.place[std::size_t(i)].pixel =
                    static_cast<std::int16_t>(first_pixel(line.place[std::size_t(i)].sample.v, height_));
        };
        for_each_gap(order.v, rows, order.toward, [&](int k) {
            if (held != k && held != k + 1) {
                held = (k < above) == order.toward ? k : k + 1;
                fill(before_, held);
            }
            const bool down = held == k;
            const int row = down ? k + 1 : k;
            fill(now_, row);
            connect();
            for (int i = 0; i < before_.count; ++i)
                if (!before_.place[std::size_t(i)].connected)
                    stick_out(held, before_.place[std::size_t(i)], down ? 1 : -1);
            down ? paint_row<true>(row) : paint_row<false>(row);
            held = row;
            std::swap(before_, now_);
        });
    }

  private:
    struct Place {
        RowSample<maps> sample;
        bool connected;         // with a sample of the next row
        std::int16_t x, pixel;  // first_pixel(sample.v); both at most max_picture_size
        int next;               // the sample that reached the column before it; -1: none
        int before;             // the one of the row before with which it is connected; -1: none
    };
    struct Line {
        std::vector<Place> place;  // in the order of arrival, `count` of them
        int count = 0, room;
        std::vector<int> last;  // of each column; -1: none
        explicit Line(std::size_t columns)
            : place(2 * columns), room(static_cast<int>(2 * columns)), last(columns, -1) {}
        void clear() {
            count = 0;
            std::fill(last.begin(), last.end(), -1);
        }
        void grow() { place.resize(2 * place.size()), room *= 2; }
        RowSample<maps>& add(int x, int first) {
            if (count == room) grow();
            int& newest = last[static_cast<std::size_t>(x - first)];
            Place& to = place[static_cast<std::size_t>(count)];
            to.x = static_cast<std::int16_t>(x), to.next = newest, to.connected = false;
            newest = count++;
            return to.sample;
        }
    };

    // Each sample of this row with the one of the row before, in its column, that is nearest in depth.
    void connect() {
        Place* const before = before_.place.data();
        for (int i = 0; i < now_.count; ++i) {
            Place& place = now_.place[static_cast<std::size_t>(i)];
            int nearest = before_.last[static_cast<std::size_t>(place.x - first_)];
            if (nearest >= 0 && (cut_ || before[nearest].next >= 0)) {
                const Scalar depth = place.sample.carried.depth();
                const auto apart = [&](int k) { return std::abs(before[k].sample.carried.depth() - depth); };
                for (int k = before[nearest].next; k >= 0; k = before[k].next)
                    if (apart(k) < apart(nearest)) nearest = k;
                if (cut_ && apart(nearest) > jump_depth_) nearest = -1;
            }
            place.before = nearest;
            if (nearest >= 0) before[nearest].connected = true;
        }
    }

    template <bool down>
    void paint_row(int row) const {
        const Place* const before = before_.place.data();
        for (int i = 0; i < now_.count; ++i) {
            const Place& place = now_.place[static_cast<std::size_t>(i)];
            if (place.before < 0) {
                stick_out(row, place, down ? -1 : 1);
                continue;
            }
            const Place& other = before[place.before];
            stretch(down ? other : place, down ? place : other);
        }
    }

    // From the sample of the upper source row to that of the lower one.
    [[gnu::always_inline]] void stretch(const Place& upper, const Place& lower) const {
        const int from = std::min(upper.pixel, lower.pixel), to = std::max(upper.pixel, lower.pixel);
        const RowSample<maps>&a = upper.sample, &b = lower.sample;
        const bool jump = maps && std::abs(a.carried.depth() - b.carried.depth()) > jump_depth_;
        for (int y = from; y < to; ++y) {
            const Scalar at = static_cast<Scalar>(y) + Scalar(0.5);
            const Kind kind = maps ? kind_between(at, a.v, b.v, a.kind, b.kind, jump) : Kind::Sampled;
            const Scalar share = corrected_share(a.weight, b.weight, at - a.v, b.v - at);
            painter_.paint(upper.x, y, lerp(a.carried, b.carried, share), kind);
        }
    }

    // The half texel above (-1) or below (1) a sample of a row of the source that has no neighbour
    // there.
    [[gnu::noinline]] void stick_out(int row, const Place& place, int side) const {
        Place end = place;
        RowSample<maps>& sample = end.sample;
        const Scalar depth = depth_beyond(sample.carried.depth(), sample.carried.slope());
        sample.carried.set_depth(depth), sample.weight = weight_at(depth, warp_);
        sample.v = warped_v(static_cast<Scalar>(2 * row + 1 + side) / 2, depth, warp_) - y0_;
        sample.kind = Kind::Sampled, end.pixel = static_cast<std::int16_t>(first_pixel(sample.v, height_));
        stretch(place, end);
    }

    DepthWarp warp_;
    bool cut_;
    Scalar jump_depth_;
    Painter<maps> painter_;
    Scalar y0_, height_;
    int first_;
    Line before_, now_;
};

}  // namespace relevo::relief
