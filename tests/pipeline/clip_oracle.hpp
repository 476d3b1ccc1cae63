// Clipping in rational numbers: the oracle of the clippers, and hard input for them.
#pragma once
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <span>
#include <vector>

#include "pipeline/clip_plane.hpp"
#include "tests/support/exact_rational.hpp"
#include "tests/support/hard.hpp"

namespace relevo::pipeline {

inline void PrintTo(const Segment& s, std::ostream* out) {
    const auto flags = out->flags();
    *out << std::hexfloat << "(" << s.a.x << ", " << s.a.y << ") (" << s.b.x << ", " << s.b.y << ")";
    out->flags(flags);
    *out << " = (" << s.a.x << ", " << s.a.y << ") (" << s.b.x << ", " << s.b.y << ")";
}
inline void PrintTo(const ClipBox& b, std::ostream* out) { PrintTo(Segment{b.low, b.high}, out); }

}  // namespace relevo::pipeline

namespace relevo::tests::exact {

using pipeline::ClipBox;
using pipeline::Segment;

struct RationalPoint {
    Rational x, y;
    friend bool operator==(const RationalPoint&, const RationalPoint&) = default;
};
inline RationalPoint rational(const glm::vec2& p) { return {Rational(p.x), Rational(p.y)}; }

// x X + y Y + c >= 0 is inside.
struct RationalHalf {
    Rational x, y, c;
    Rational at(const RationalPoint& p) const { return x * p.x + y * p.y + c; }
};
inline std::vector<RationalHalf> halves_of(const ClipBox& box) {
    return {{1, 0, -Rational(box.low.x)},
            {-1, 0, Rational(box.high.x)},
            {0, 1, -Rational(box.low.y)},
            {0, -1, Rational(box.high.y)}};
}

inline Rational twice_area(std::span<const RationalPoint> ring) {
    Rational sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
        sum += a.x * b.y - b.x * a.y;
    }
    return sum;
}
inline Rational twice_area(std::span<const glm::vec2> ring) {
    std::vector<RationalPoint> exactly;
    for (const glm::vec2& p : ring) exactly.push_back(rational(p));
    return twice_area(exactly);
}

// Of a convex polygon, in either winding.
inline std::vector<RationalHalf> halves_of(std::span<const glm::vec2> polygon) {
    const int winding = twice_area(polygon) > 0 ? 1 : -1;
    std::vector<RationalHalf> halves;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const RationalPoint a = rational(polygon[i]), b = rational(polygon[(i + 1) % polygon.size()]);
        const Rational dx = winding * (b.x - a.x), dy = winding * (b.y - a.y);
        halves.push_back({-dy, dx, dy * a.x - dx * a.y});
    }
    return halves;
}

struct RationalSegment {
    RationalPoint a, b;
};
// Liang and Barsky's, for any half-planes.
inline std::optional<RationalSegment> clip(const Segment& s, std::span<const RationalHalf> window) {
    const RationalPoint a = rational(s.a), b = rational(s.b);
    Rational in = 0, out = 1;
    for (const RationalHalf& half : window) {
        const Rational from = half.at(a), rise = half.at(b) - from;
        if (rise == 0) {
            if (from < 0) return std::nullopt;
            continue;
        }
        const Rational t = -from / rise;
        if (rise > 0) in = std::max(in, t);
        if (rise < 0) out = std::min(out, t);
        if (in > out) return std::nullopt;
    }
    const auto at = [&](const Rational& t) {
        return RationalPoint{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
    };
    return RationalSegment{at(in), at(out)};
}

// Correctly rounded, ties to even.
inline float rounded(const Rational& value) {
    const float start = static_cast<float>(static_cast<double>(value));
    const float infinity = std::numeric_limits<float>::infinity();
    float best = start;
    for (const float other : {std::nextafterf(start, -infinity), std::nextafterf(start, infinity)}) {
        if (!std::isfinite(other)) continue;
        const Rational here = abs(Rational(best) - value), there = abs(Rational(other) - value);
        if (there < here || (there == here && (std::bit_cast<std::uint32_t>(other) & 1) == 0)) best = other;
    }
    return best;
}
inline Segment rounded(const RationalSegment& s) {
    return {{rounded(s.a.x), rounded(s.a.y)}, {rounded(s.b.x), rounded(s.b.y)}};
}
inline std::optional<Segment> right_answer(const Segment& s, std::span<const RationalHalf> window) {
    const auto exactly = clip(s, window);
    return exactly ? std::optional(rounded(*exactly)) : std::nullopt;
}

}  // namespace relevo::tests::exact

namespace relevo::tests::hard {

// ---------------------------------------------------------------- segments that are hard for a window
struct LineCase {
    pipeline::Segment segment;
    pipeline::ClipBox box;
};
struct LineFamily {
    std::string_view name;
    LineCase (*make)(Random&);
    bool all_visible = false;
};

inline float moved(float v, std::int64_t ulps) {  // so many floats up or down
    for (; ulps > 0; --ulps) v = std::nextafterf(v, std::numeric_limits<float>::max());
    for (; ulps < 0; ++ulps) v = std::nextafterf(v, std::numeric_limits<float>::lowest());
    return v;
}
inline float real(Random& r, double a, double b) { return static_cast<float>(r.between(a, b)); }
inline float whole(Random& r, int a, int b) { return static_cast<float>(r.integer(a, b)); }

inline std::span<const LineFamily> line_families() {
    using R = Random&;
    static constexpr pipeline::ClipBox usual{{0, 0}, {10, 10}};
    static const auto corner = [](R r) { return glm::vec2(r.coin() ? 0 : 10, r.coin() ? 0 : 10); };
    static const LineFamily all[] = {
        {"uniform",
         [](R r) {
             const auto p = [&] { return glm::vec2(real(r, -12, 22), real(r, -12, 22)); };
             return LineCase{{p(), p()}, usual};
         }},
        {"any box",
         [](R r) {
             const float x0 = real(r, -9, 9), y0 = real(r, -9, 9), x1 = real(r, -9, 9), y1 = real(r, -9, 9);
             const auto p = [&] { return glm::vec2(real(r, -12, 12), real(r, -12, 12)); };
             return LineCase{{p(), p()},
                             {{std::min(x0, x1), std::min(y0, y1)}, {std::max(x0, x1), std::max(y0, y1)}}};
         }},
        {"integers far away",
         [](R r) {
             const auto p = [&] {
                 return glm::vec2(whole(r, -9999999, 9999999), whole(r, -9999999, 9999999));
             };
             return LineCase{{p(), p()}, {{-1000000, -2000000}, {1000001, 3000003}}};
         }},
        {"through a corner",
         [](R r) {
             const glm::vec2 c = corner(r), d(whole(r, -900, 900), whole(r, -900, 900));
             const float before = whole(r, 1, 40), after = whole(r, 1, 40);
             return LineCase{{c - d * before, c + d * after}, usual};
         },
         true},
        {"past a corner by an ulp",
         [](R r) {
             const glm::vec2 c = corner(r), d(whole(r, -90, 90) / 64, whole(r, -90, 90) / 64);
             pipeline::Segment s{c - d * whole(r, 1, 9), c + d * whole(r, 1, 9)};
             for (float* v : {&s.a.x, &s.a.y, &s.b.x, &s.b.y}) *v = moved(*v, r.integer(-1, 1));
             return LineCase{s, usual};
         }},
        {"ends an ulp from corners",
         [](R r) {
             const auto p = [&] {
                 const glm::vec2 c = corner(r);
                 return glm::vec2(moved(c.x, r.integer(-2, 2)), moved(c.y, r.integer(-2, 2)));
             };
             return LineCase{{p(), p()}, usual};
         }},
        {"one end an ulp from a corner",
         [](R r) {
             const glm::vec2 c = corner(r);
             return LineCase{{{moved(c.x, r.integer(-2, 2)), moved(c.y, r.integer(-2, 2))},
                              {real(r, -30, 40), real(r, -30, 40)}},
                             usual};
         }},
        {"along a side",
         [](R r) {
             const glm::vec2 c = corner(r);
             pipeline::Segment s{{c.x, real(r, -20, 30)}, {c.x, real(r, -20, 30)}};
             if (r.coin()) s.b.x = moved(s.b.x, r.integer(-1, 1));
             if (r.coin()) std::swap(s.a.x, s.a.y), std::swap(s.b.x, s.b.y);
             return LineCase{s, usual};
         }},
        {"largest floats",
         [](R r) {
             const auto v = [&] {
                 return r.coin()   ? (r.coin() ? 3e38f : -3e38f)
                        : r.coin() ? real(r, -20, 30)
                                   : whole(r, 0, 10);
             };
             return LineCase{{{v(), v()}, {v(), v()}}, usual};
         }},
        {"denormal",
         [](R r) {
             const auto v = [&] { return whole(r, -9, 9) * 0x1p-149f; };
             return LineCase{{{v(), v()}, {v(), v()}}, {{-0.0f, 0}, {5 * 0x1p-149f, 4 * 0x1p-149f}}};
         }},
        {"denormal beside large",
         [](R r) {
             const auto v = [&] { return r.coin() ? whole(r, -9, 9) * 0x1p-149f : real(r, -3e38, 3e38); };
             return LineCase{{{v(), v()}, {v(), v()}}, {{0, 0}, {5 * 0x1p-149f, 4}}};
         }},
        {"any floats",
         [](R r) {
             const auto v = [&] { return r.any_finite_float(); };
             const float x0 = v(), y0 = v(), x1 = v(), y1 = v();
             return LineCase{{{v(), v()}, {v(), v()}},
                             {{std::min(x0, x1), std::min(y0, y1)}, {std::max(x0, x1), std::max(y0, y1)}}};
         }},
        {"zeros of both signs",
         [](R r) {
             const auto v = [&] { return r.coin() ? 0.0f : r.coin() ? -0.0f : whole(r, -2, 2); };
             return LineCase{{{v(), v()}, {v(), v()}}, {{-0.0f, -1}, {0.0f, 1}}};
         }},
        {"a window without area",
         [](R r) {
             const auto p = [&] { return glm::vec2(whole(r, -9, 9), whole(r, -9, 9)); };
             const glm::vec2 low(whole(r, -2, 2), whole(r, -2, 2));
             return LineCase{{p(), p()}, {low, {low.x, low.y + (r.coin() ? 0.0f : whole(r, 0, 3))}}};
         }},
        {"points",
         [](R r) {
             const glm::vec2 p(whole(r, -1, 11), whole(r, -1, 11));
             return LineCase{{p, p}, usual};
         }},
    };
    return all;
}

}  // namespace relevo::tests::hard
