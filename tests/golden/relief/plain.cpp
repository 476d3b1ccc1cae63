#include "tests/golden/relief/plain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace relevo::golden {
namespace {

using namespace relief;

struct Epipole {
    double u, v;
    bool toward;
};
Epipole epipole(const Warp& warp, Painting painting) {
    const bool orthographic = warp.projection == Projection::Orthographic;
    const bool toward = orthographic || warp.k3 <= 0;
    const auto at = [&](double k) {
        if (warp.k3 != 0) return std::min(std::max(k / warp.k3, -1e9), 1e9);
        return k == 0 ? 0.0 : (k > 0) == orthographic ? 1e9 : -1e9;
    };
    return {at(warp.k1), at(warp.k2), toward == (painting == Painting::Right)};
}

// The places first..first + count - 1 (their middles given by `middle`), sorted by their distance from the
// epipole: farthest first when painting goes towards it. Which side comes first is that of the library.
std::vector<int> by_distance(int first, int count, double middle, double e, bool toward) {
    std::vector<int> order;
    for (int k = first; k < first + count; ++k) order.push_back(k);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        const bool left_a = a + middle < e, left_b = b + middle < e;
        if (left_a != left_b) return left_a;
        const double da = std::abs(a + middle - e), db = std::abs(b + middle - e);
        return toward ? da > db : da < db;
    });
    return order;
}

// One texel, or one sample, with all that it carries.
using Sample = PlainSample;

struct Plain {
    const ReliefTexture& texture;
    const Warp& warp;
    const Window& window;
    const PrewarpSettings& settings;
    const ReliefRules& rules;
    Epipole e = epipole(warp, settings.painting);
    // how the surface goes on where it ends is known before any warp, and is no matter of this form
    PreparedRelief prepared = prepare(texture, settings.jump, settings.jump_depth);

    int width() const { return texture.camera.width; }
    int height() const { return texture.camera.height; }
    bool covered(int x, int y) const {
        return texture.coverage.holds(x, y) && texture.coverage.at(x, y) != 0;
    }
    double depth(int x, int y) const {
        const double stored = double{texture.depth.at(x, y)};
        return warp.projection == Projection::Orthographic ? stored : warp.source_h * (1 / stored - 1);
    }
    bool jump(double a, double b) const { return std::abs(a - b) > double{settings.jump_depth}; }
    bool joined(int x0, int y0, int x1, int y1) const {
        return covered(x0, y0) && covered(x1, y1) &&
               !(settings.jump == Jump::Cut && jump(depth(x0, y0), depth(x1, y1)));
    }

    // The place in the window of a point (u, v) of the source at a depth behind the plane.
    struct Place {
        double u, v, weight;
    };
    Place place(double u, double v, double d) const {
        const bool flat = warp.projection == Projection::Orthographic;
        const double q = flat ? d : -d / (warp.source_h + d), w = 1 / (1 + warp.k3 * q);
        return {(u + warp.k1 * q) * w - window.x0, (v + warp.k2 * q) * w - window.y0, 1 / (1 + d / warp.h)};
    }
    Sample texel(int x, int y) const {
        const LinearRgb& c = texture.color.at(x, y);
        const Vec3& n = texture.normal.at(x, y);
        Sample s;
        s.there = true, s.kind = Kind::Sampled, s.depth = depth(x, y);
        s.color[0] = c.r, s.color[1] = c.g, s.color[2] = c.b;
        for (int k = 0; k < 3; ++k) s.normal[k] = n[k];
        s.source[0] = x + 0.5, s.source[1] = y + 0.5;
        const Place p = place(x + 0.5, y + 0.5, s.depth);
        s.v = p.v, s.weight = p.weight;
        return s;
    }
    Sample mix(const Sample& a, const Sample& b, double t) const {
        const double w = (1 - t) * a.weight + t * b.weight,
                     s = rules.weights == ReliefRules::Weights::Linear ? t : t * b.weight / w;
        Sample m = a;
        const auto lerp = [s](double x, double y) { return x + s * (y - x); };
        for (int k = 0; k < 3; ++k)
            m.color[k] = lerp(a.color[k], b.color[k]), m.normal[k] = lerp(a.normal[k], b.normal[k]);
        for (int k = 0; k < 2; ++k) m.source[k] = lerp(a.source[k], b.source[k]);
        m.depth = lerp(a.depth, b.depth), m.v = a.v + t * (b.v - a.v), m.weight = w;
        return m;
    }
    static Kind kind_of(double at, double a, double b, Kind kind_a, Kind kind_b, bool across) {
        const double to_a = std::abs(at - a), to_b = std::abs(at - b);
        if (std::min(to_a, to_b) > 0.5) return across ? Kind::FilledAcross : Kind::Filled;
        return to_a <= to_b ? kind_a : kind_b;
    }

    // emit(x, sample) at every pixel's middle in [a, b) or [b, a).
    template <class Emit>
    void across(double ua, double ub, const Sample& a, const Sample& b, bool over_jump, Emit&& emit) const {
        for (int x = 0; x < window.width; ++x) {
            const double at = x + 0.5;
            if (!(std::min(ua, ub) <= at && at < std::max(ua, ub))) continue;
            const double t = (at - ua) / (ub - ua);
            Sample s = mix(a, b, t);
            s.kind = kind_of(at, ua, ub, Kind::Sampled, Kind::Sampled, over_jump);
            if (settings.resampler == Resampler::OneDimensional) {
                s.depth = a.depth + t * (b.depth - a.depth), s.weight = 1 / (1 + s.depth / warp.h);
            }
            emit(x, s);
        }
    }
    template <class Emit>
    void row(int y, Emit&& emit) const {
        if (y < 0 || y >= height()) return;
        const auto u = [&](int x) { return place(x + 0.5, y + 0.5, depth(x, y)).u; };
        const auto stick_out = [&](int x, int side) {
            if (!rules.half_texels || !covered(x, y)) return;
            const Sample a = texel(x, y);
            Sample b = a;
            b.depth = std::max(a.depth + double{prepared.growth_u.at(x, y)}, 0.0);
            const Place p = place(x + 0.5 + 0.5 * side, y + 0.5, b.depth);
            if (side * (p.u - u(x)) <= 0) return;  // it would fold back
            b.v = p.v, b.weight = p.weight;
            across(u(x), p.u, a, b, false, emit);
        };
        std::vector<int> gaps = by_distance(-1, width() + 1, 1, e.u, e.toward);
        for (const int k : gaps) {
            if (joined(k, y, k + 1, y)) {
                // a skin that folds back is not drawn
                if (jump(depth(k, y), depth(k + 1, y)) && u(k) > u(k + 1)) continue;
                across(u(k), u(k + 1), texel(k, y), texel(k + 1, y), jump(depth(k, y), depth(k + 1, y)),
                       emit);
            } else {
                stick_out(k, 1), stick_out(k + 1, -1);
            }
        }
    }

    // --------------------------------------------------------------------------------------- columns
    struct Arrival {
        int x;
        Sample s;
        int before = -1;
        bool connected = false;
    };
    std::vector<Arrival> arrivals(int y, const Image<PlainSample>* rows) const {
        std::vector<Arrival> all;
        if (!rows) {
            row(y, [&](int x, const Sample& s) { all.push_back({x, s}); });
        } else if (y >= 0 && y < height()) {
            for (int x = 0; x < window.width; ++x) {
                if (!rows->at(x, y).there) continue;
                Sample s = rows->at(x, y);
                if (settings.resampler != Resampler::Asymmetric) s.v = place(0, y + 0.5, s.depth).v;
                all.push_back({x, s});
            }
        }
        return all;
    }

    void paint(Prewarped& p, int x, int y, const Sample& s, Kind kind) const {
        auto& writes = p.writes.at(x, y);
        if (writes < 65535) ++writes;
        if (settings.depth_test && p.coverage.at(x, y) && double{p.depth.at(x, y)} < s.depth) return;
        p.color.at(x, y) = {Scalar(s.color[0]), Scalar(s.color[1]), Scalar(s.color[2])};
        p.normal.at(x, y) = {Scalar(s.normal[0]), Scalar(s.normal[1]), Scalar(s.normal[2])};
        p.depth.at(x, y) = static_cast<Scalar>(s.depth), p.coverage.at(x, y) = 1, p.kind.at(x, y) = kind;
        p.source.at(x, y) = {Scalar(s.source[0]), Scalar(s.source[1])};
    }
    void stretch(Prewarped& p, int x, const Sample& a, const Sample& b) const {
        for (int y = 0; y < window.height; ++y) {
            const double at = y + 0.5;
            if (!(std::min(a.v, b.v) <= at && at < std::max(a.v, b.v))) continue;
            paint(p, x, y, mix(a, b, (at - a.v) / (b.v - a.v)),
                  kind_of(at, a.v, b.v, a.kind, b.kind, jump(a.depth, b.depth)));
        }
    }
    void stick_out(Prewarped& p, const Arrival& a, int row, int side) const {
        if (!rules.half_texels) return;
        Sample end = a.s;
        end.depth = std::max(a.s.depth + growth(a, row), 0.0), end.kind = Kind::Sampled;
        const Place at = place(0, row + 0.5 + 0.5 * side, end.depth);
        if (side * (at.v - a.s.v) <= 0) return;
        end.v = at.v, end.weight = at.weight;
        side < 0 ? stretch(p, a.x, end, a.s) : stretch(p, a.x, a.s, end);
    }
    // How much deeper the surface gets beyond the end of its column, interpolated along the row between the
    // texels that the sample came from.
    double growth(const Arrival& a, int row) const {
        const int left = static_cast<int>(std::floor(a.s.source[0] - 0.5));
        const double t = a.s.source[0] - 0.5 - left;
        const auto of = [&](int x) { return double{prepared.carried.at(x, row).part[1][3]}; };
        return t == 0 || !covered(left + 1, row) ? of(left) : of(left) + t * (of(left + 1) - of(left));
    }

    void columns(Prewarped& p, const Image<PlainSample>* rows) const {
        const int above =
            static_cast<int>(std::min(std::max(std::ceil(e.v - 0.5), 0.0), static_cast<double>(height())));
        std::vector<int> order;  // towards: from both borders, and last the gap that holds the epipole
        for (int k = -1; k < above - 1; ++k) order.push_back(k);
        for (int k = height() - 1; k >= above; --k) order.push_back(k);
        order.push_back(above - 1);
        if (!e.toward) {
            order.clear();
            for (int k = above - 1; k >= -1; --k) order.push_back(k);
            for (int k = above; k < height(); ++k) order.push_back(k);
        }
        for (const int k : order) {
            bool down = (k < above) == e.toward;
            if (e.toward && k == above - 1) down = above == height();
            const int first = down ? k : k + 1, second = down ? k + 1 : k;
            std::vector<Arrival> before = arrivals(first, rows), now = arrivals(second, rows);
            if (rules.same_row) {
                std::vector<int> last(std::size_t(window.width), -1);
                for (std::size_t i = 0; i < before.size(); ++i) last[std::size_t(before[i].x)] = int(i);
                std::vector<const Sample*> newest(std::size_t(window.width), nullptr);
                for (std::size_t x = 0; x < last.size(); ++x)
                    if (last[x] >= 0) newest[x] = &before[std::size_t(last[x])].s;
                for (const Arrival& a : now) {
                    const Sample*& other = newest[std::size_t(a.x)];
                    if (other) down ? stretch(p, a.x, *other, a.s) : stretch(p, a.x, a.s, *other);
                    if (!other) stick_out(p, a, second, down ? -1 : 1);
                    other = &a.s;
                }
                for (const Arrival& b : before)
                    if (newest[std::size_t(b.x)] == &b.s) stick_out(p, b, first, down ? 1 : -1);
                continue;
            }
            for (Arrival& a : now)
                for (std::size_t i = before.size();
                     i-- > 0;) {  // of equally near ones the last one that came
                    if (before[i].x != a.x) continue;
                    const double apart = std::abs(before[i].s.depth - a.s.depth);
                    if (settings.jump == Jump::Cut && apart > double{settings.jump_depth}) continue;
                    if (a.before < 0 || apart < std::abs(before[std::size_t(a.before)].s.depth - a.s.depth))
                        a.before = int(i);
                }
            for (const Arrival& a : now)
                if (a.before >= 0) before[std::size_t(a.before)].connected = true;
            for (const Arrival& b : before)
                if (!b.connected) stick_out(p, b, first, down ? 1 : -1);
            for (const Arrival& a : now) {
                if (a.before < 0) {
                    stick_out(p, a, second, down ? -1 : 1);
                    continue;
                }
                const Sample& other = before[std::size_t(a.before)].s;
                down ? stretch(p, a.x, other, a.s) : stretch(p, a.x, a.s, other);
            }
        }
    }

    Image<PlainSample> rows() const {
        Image<PlainSample> image(window.width, height());
        for (int y = 0; y < height(); ++y) row(y, [&](int x, const Sample& s) { image.at(x, y) = s; });
        return image;
    }
};

}  // namespace

Image<PlainSample> plain_rows(const ReliefTexture& texture, const Warp& warp, const Window& window,
                              const PrewarpSettings& settings, const ReliefRules& rules) {
    return Plain{texture, warp, window, settings, rules}.rows();
}

Prewarped plain_prewarp(const ReliefTexture& texture, const Warp& warp, const Window& window,
                        const PrewarpSettings& settings, const ReliefRules& rules) {
    assert(settings.resampler != Resampler::Mesh);
    const int w = window.width, h = window.height;
    Prewarped p{window, {w, h}, {w, h}, {w, h}, {w, h}, {w, h}, {w, h}, {w, h}};
    const Plain plain{texture, warp, window, settings, rules};
    if (settings.resampler == Resampler::Splat) {
        const Image<int> rank =
            plain_ranks(warp, texture.camera.width, texture.camera.height, settings.painting, rules);
        std::vector<std::pair<int, int>> at(rank.pixels().size());
        for (int y = 0; y < rank.height(); ++y)
            for (int x = 0; x < rank.width(); ++x) at[std::size_t(rank.at(x, y))] = {x, y};
        for (const auto& [x, y] : at) {
            if (!plain.covered(x, y)) continue;
            const auto place = plain.place(x + 0.5, y + 0.5, plain.depth(x, y));
            if (place.u < 0 || place.v < 0 || place.u >= w || place.v >= h) continue;
            plain.paint(p, static_cast<int>(place.u), static_cast<int>(place.v), plain.texel(x, y),
                        Kind::Sampled);
        }
        return p;
    }
    if (settings.resampler == Resampler::Interleaved) {
        plain.columns(p, nullptr);
    } else {
        const Image<PlainSample> rows = plain.rows();
        plain.columns(p, &rows);
    }
    return p;
}

Image<int> plain_ranks(const Warp& warp, int width, int height, Painting painting, const ReliefRules& rules) {
    const Epipole e = epipole(warp, painting);
    Image<int> rank(width, height);
    int next = 0;
    std::vector<int> rows = by_distance(0, height, 0.5, e.v, e.toward),
                     columns = by_distance(0, width, 0.5, e.u, e.toward);
    if (!rules.by_sheets) std::sort(rows.begin(), rows.end()), std::sort(columns.begin(), columns.end());
    for (const int y : rows)
        for (const int x : columns) rank.at(x, y) = next++;
    return rank;
}

QuantizedDepth<std::uint8_t> plain_codes(const ReliefTexture& texture, const ReliefRules& rules) {
    using Codes = ReliefRules::Codes;
    QuantizedDepth<std::uint8_t> q{depth_range(texture), {texture.camera.width, texture.camera.height, 255}};
    const double extent = double{q.range.high} - double{q.range.low},
                 steps = rules.codes == Codes::DividedBy255 ? 255 : 254;
    for (int y = 0; y < q.code.height(); ++y)
        for (int x = 0; x < q.code.width(); ++x) {
            if (rules.codes == Codes::EmptyIsZero && !texture.coverage.at(x, y)) q.code.at(x, y) = 0;
            if (!texture.coverage.at(x, y)) continue;
            const double place = (double{texture.depth.at(x, y)} - double{q.range.low}) * (steps / extent);
            q.code.at(x, y) =
                static_cast<std::uint8_t>(std::floor(place + (rules.codes == Codes::RoundedDown ? 0 : 0.5)));
        }
    return q;
}

}  // namespace relevo::golden
