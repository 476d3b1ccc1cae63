// Hard triangles: what naive rasterizers and clippers get wrong. Each family is a pure function of a seed, so
// "needle_at_centre:17" in a failed test is the whole case.
#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include "pipeline/elementary.hpp"

namespace relevo::tests::hard {

// Numbers that are the same on every machine: xorshift64* (Marsaglia 2003, Vigna 2016).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_((seed + 1) * 0xD1342543DE82EF95u) {
        if (state_ == 0) state_ = 1;
        for (int i = 0; i < 4; ++i) bits();
    }
    std::uint64_t bits() {
        state_ ^= state_ >> 12, state_ ^= state_ << 25, state_ ^= state_ >> 27;
        return state_ * 0x2545F4914F6CDD1Du;
    }
    bool coin() { return bits() >> 63; }
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  // [0, 1)
    double between(double a, double b) { return a + (b - a) * unit(); }
    std::int64_t integer(std::int64_t a, std::int64_t b) {  // a..b
        return a + static_cast<std::int64_t>((bits() >> 1) % static_cast<std::uint64_t>(b - a + 1));
    }
    float any_finite_float() {  // every exponent alike
        for (;;) {
            const float f = std::bit_cast<float>(static_cast<std::uint32_t>(bits() >> 32));
            if (std::isfinite(f)) return f;
        }
    }

  private:
    std::uint64_t state_;
};

// How many cases the long tests run: scripts/oracle asks for more.
inline int cases(int usual) {
    const char* factor = std::getenv("RELEVO_CASES_TIMES");
    return usual * (factor ? std::max(1, std::atoi(factor)) : 1);
}

// ------------------------------------------------------------------------- triangles of the screen
struct Spot {  // pixels, y down
    double x, y;
};
using ScreenTriangle = std::array<Spot, 3>;

inline constexpr double one = 256;  // subpixels
inline double on_grid(double v) { return std::nearbyint(v * one) / one; }

struct Screen {
    Random random;
    int width, height;

    Spot anywhere() { return {random.between(0, width), random.between(0, height)}; }
    Spot snapped() {
        return {static_cast<double>(random.integer(0, 256 * width)) / one,
                static_cast<double>(random.integer(0, 256 * height)) / one};
    }
    Spot a_centre() {
        return {static_cast<double>(random.integer(0, width - 1)) + 0.5,
                static_cast<double>(random.integer(0, height - 1)) + 0.5};
    }
    Spot turned(double radius) {  // a vector of this length, any direction
        const pipeline::Degrees angle{random.between(0, 360)};
        return {radius * pipeline::cos(angle), radius * pipeline::sin(angle)};
    }
};

// (x, y) with dx y - dy x = gcd(dx, dy), by Euclid.
inline Spot bezout(std::int64_t dx, std::int64_t dy) {
    std::int64_t r0 = dx, r1 = dy, s0 = 1, s1 = 0, t0 = 0, t1 = 1;
    while (r1 != 0) {
        const std::int64_t q = r0 / r1;
        r0 = std::exchange(r1, r0 - q * r1);
        s0 = std::exchange(s1, s0 - q * s1);
        t0 = std::exchange(t1, t0 - q * t1);
    }
    const double sign = r0 < 0 ? -1 : 1;
    return {-sign * static_cast<double>(t0), sign * static_cast<double>(s0)};
}

// An edge that passes a pixel's centre with the edge value `value` (in 2^-16 pixel^2): as near as can be, or
// through it.
inline ScreenTriangle near_tie(Screen& s, int value) {
    for (;;) {
        const std::int64_t reach = s.random.integer(4, 8000 * 256);
        const std::int64_t dx = s.random.integer(-reach, reach), dy = s.random.integer(-reach, reach);
        if (dx == 0 || dy == 0 || std::gcd(dx, dy) != 1) continue;
        const Spot p = s.a_centre(), step = bezout(dx, dy);  // p - a = value * step
        const Spot a = value == 0
                           ? Spot{p.x - static_cast<double>(dx) / one, p.y - static_cast<double>(dy) / one}
                           : Spot{p.x - value * step.x / one, p.y - value * step.y / one};
        const Spot b{a.x + static_cast<double>(dx) / one, a.y + static_cast<double>(dy) / one};
        const Spot c{on_grid(p.x + s.random.between(-60, 60)), on_grid(p.y + s.random.between(-60, 60))};
        return {a, b, c};
    }
}

struct ScreenFamily {
    std::string_view name;
    bool in_range;  // finite, within 2^15 pixels of the picture: may be snapped without clipping
    ScreenTriangle (*make)(Screen&);
};

inline const auto& screen_families() {
    using S = Screen&;
    static constexpr double inf = std::numeric_limits<double>::infinity();
    static const ScreenFamily all[] = {
        {"uniform", true,
         [](S s) {
             return ScreenTriangle{s.anywhere(), s.anywhere(), s.anywhere()};
         }},
        {"snapped", true,
         [](S s) {
             return ScreenTriangle{s.snapped(), s.snapped(), s.snapped()};
         }},
        {"half_pixel_ties", true,
         [](S s) {
             const auto spot = [&] {
                 return Spot{static_cast<double>(s.random.integer(0, 2 * s.width)) * 0.5,
                             static_cast<double>(s.random.integer(0, 2 * s.height)) * 0.5};
             };
             return ScreenTriangle{spot(), spot(), spot()};
         }},
        {"sliver", true,
         [](S s) {
             const Spot m = s.anywhere(), d = s.turned(1);
             const double length = s.random.between(10, 3.0 * s.width),
                          width = pipeline::exp2(-s.random.between(0, 10));
             return ScreenTriangle{Spot{m.x - length * d.x, m.y - length * d.y},
                                   Spot{m.x + length * d.x, m.y + length * d.y},
                                   Spot{m.x + length * d.x - width * d.y, m.y + length * d.y + width * d.x}};
         }},
        {"needle_at_centre", true,
         [](S s) {
             const Spot p = s.a_centre(), d = s.turned(s.random.between(20, 2.0 * s.width + 20));
             const double e = static_cast<double>(s.random.integer(1, 3)) / one;
             return ScreenTriangle{Spot{on_grid(p.x - d.x), on_grid(p.y - d.y)}, Spot{p.x + e, p.y},
                                   Spot{p.x - e, s.random.coin() ? p.y + e : p.y}};
         }},
        {"point_at_centre", true,  // a corner exactly on a centre
         [](S s) {
             return ScreenTriangle{s.a_centre(), s.snapped(), s.snapped()};
         }},
        {"collinear", true,
         [](S s) {
             const Spot a = s.snapped();
             const double dx = static_cast<double>(s.random.integer(-900, 900)) / one,
                          dy = static_cast<double>(s.random.integer(-900, 900)) / one;
             return ScreenTriangle{a, Spot{a.x + dx, a.y + dy}, Spot{a.x + 3 * dx, a.y + 3 * dy}};
         }},
        {"one_point_twice", true,
         [](S s) {
             const Spot a = s.anywhere();
             return ScreenTriangle{a, a, s.random.coin() ? a : s.anywhere()};
         }},
        {"axis_parallel_at_centres", true,
         [](S s) {
             const Spot p = s.a_centre();
             const double w = static_cast<double>(s.random.integer(-16, 16)),
                          h = static_cast<double>(s.random.integer(-16, 16));
             return ScreenTriangle{p, Spot{p.x + w, p.y}, Spot{s.random.coin() ? p.x : p.x + w, p.y + h}};
         }},
        {"one_subpixel_tall", true,
         [](S s) {
             const double y = s.a_centre().y + static_cast<double>(s.random.integer(-1, 1)) / one;
             return ScreenTriangle{Spot{s.random.between(-s.width, s.width), y},
                                   Spot{s.random.between(0, 2 * s.width), y},
                                   Spot{s.random.between(0, s.width), y + 1 / one}};
         }},
        {"one_subpixel_wide", true,
         [](S s) {
             const double x = s.a_centre().x + static_cast<double>(s.random.integer(-1, 1)) / one;
             return ScreenTriangle{Spot{x, s.random.between(-s.height, s.height)},
                                   Spot{x, s.random.between(0, 2 * s.height)},
                                   Spot{x + 1 / one, s.random.between(0, s.height)}};
         }},
        {"edge_through_centres", true,
         [](S s) {
             const Spot p = s.a_centre();
             const double dx = static_cast<double>(s.random.integer(1, 9)),
                          dy = static_cast<double>(s.random.integer(-9, 9)),
                          k = static_cast<double>(s.random.integer(1, 40));
             return ScreenTriangle{Spot{p.x - k * dx, p.y - k * dy}, Spot{p.x + k * dx, p.y + k * dy},
                                   s.snapped()};
         }},
        {"near_tie_inside", true, [](S s) { return near_tie(s, 1); }},
        {"near_tie_outside", true, [](S s) { return near_tie(s, -1); }},
        {"exact_tie", true, [](S s) { return near_tie(s, 0); }},
        {"guard_band", true,
         [](S s) {
             const auto far = [&](int size) { return s.random.coin() ? 4.0 * size : -3.0 * size; };
             const auto spot = [&] { return Spot{far(s.width), far(s.height)}; };
             return ScreenTriangle{spot(), s.random.coin() ? spot() : s.snapped(), s.anywhere()};
         }},
        {"int32_wraps", true,  // edge values pass 2^31 about 128 pixels away
         [](S s) {
             const double reach = s.random.between(120, 140);
             const Spot a = s.anywhere();
             return ScreenTriangle{a, Spot{a.x + reach, a.y + s.random.between(-2, 2)},
                                   Spot{a.x + s.random.between(-2, 2), a.y + reach}};
         }},
        {"float_wraps", true,  // edge values pass 2^24 about 16 pixels away
         [](S s) {
             const double reach = s.random.between(15, 17);
             const Spot a = s.snapped();
             return ScreenTriangle{a, Spot{on_grid(a.x + reach), on_grid(a.y + s.random.between(-1, 1))},
                                   Spot{on_grid(a.x + s.random.between(-1, 1)), on_grid(a.y + reach)}};
         }},
        {"snap_turns_it_over", true,
         [](S s) {
             const Spot a = s.snapped();
             const double e = 0.49 / one;
             return ScreenTriangle{
                 Spot{a.x + e, a.y},
                 Spot{a.x - e + static_cast<double>(s.random.integer(-1, 1)) / one, a.y + 20},
                 Spot{a.x - e, a.y + 40}};
         }},
        {"snap_to_nothing", true,
         [](S s) {
             const Spot a = s.anywhere();
             return ScreenTriangle{a, Spot{a.x + 0.3 / one, a.y}, Spot{a.x, a.y + 0.3 / one}};
         }},
        {"ties_to_even", true,
         [](S s) {
             const auto spot = [&] {
                 return Spot{(static_cast<double>(s.random.integer(0, 256 * s.width)) + 0.5) / one,
                             (static_cast<double>(s.random.integer(0, 256 * s.height)) + 0.5) / one};
             };
             return ScreenTriangle{spot(), spot(), spot()};
         }},
        {"negative", true,
         [](S s) {
             return ScreenTriangle{Spot{-s.random.between(0, s.width), -s.random.between(0, s.height)},
                                   Spot{s.random.between(0, s.width), -s.random.between(0, s.height)},
                                   s.anywhere()};
         }},
        {"negative_zero", true,
         [](S s) {
             return ScreenTriangle{Spot{-0.0, -0.0},
                                   Spot{static_cast<double>(s.random.integer(1, s.width)), -0.0},
                                   Spot{-0.0, static_cast<double>(s.random.integer(1, s.height))}};
         }},
        {"denormal", true,
         [](S s) {
             return ScreenTriangle{Spot{5e-324, 1e-310}, Spot{s.random.between(1, s.width), 1e-40},
                                   Spot{1e-45, s.random.between(1, s.height)}};
         }},
        {"whole_picture", true,  // a border exactly on the outermost centres
         [](S s) {
             const double w = s.width - 0.5, h = s.height - 0.5;
             return s.random.coin() ? ScreenTriangle{Spot{0.5, 0.5}, Spot{w, 0.5}, Spot{0.5, h}}
                                    : ScreenTriangle{Spot{w, h}, Spot{0.5, h}, Spot{w, 0.5}};
         }},
        {"huge", false,
         [](S s) {
             const auto spot = [&] { return Spot{s.random.between(-1e9, 1e9), s.random.between(-1e9, 1e9)}; };
             return ScreenTriangle{spot(), spot(), s.anywhere()};
         }},
        {"not_a_number", false,
         [](S s) {
             ScreenTriangle t{s.anywhere(), s.anywhere(), s.anywhere()};
             Spot& bad = t[std::size_t(s.random.integer(0, 2))];
             (s.random.coin() ? bad.x : bad.y) = std::numeric_limits<double>::quiet_NaN();
             return t;
         }},
        {"infinite", false,
         [](S s) {
             ScreenTriangle t{s.anywhere(), s.anywhere(), s.anywhere()};
             Spot& bad = t[std::size_t(s.random.integer(0, 2))];
             (s.random.coin() ? bad.x : bad.y) = s.random.coin() ? inf : -inf;
             return t;
         }},
    };
    return all;
}

inline std::uint64_t seed_of(std::string_view family, std::uint64_t seed) {
    for (const char c : family) seed = (seed ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    return seed;
}
inline ScreenTriangle make(const ScreenFamily& family, std::uint64_t seed, int width, int height) {
    Screen screen{Random(seed_of(family.name, seed)), width, height};
    return family.make(screen);
}

// --------------------------------------------------------- triangles of clip space, 0 <= z <= w
using ClipPoint = std::array<double, 4>;  // x y z w, each a float's value
using ClipTriangle = std::array<ClipPoint, 3>;

struct ClipFamily {
    std::string_view name;
    bool finite;
    void (*spoil)(Random&, ClipTriangle&);  // from corners of all kinds with w > 0
};

inline const auto& clip_families() {
    using R = Random&;
    using T = ClipTriangle&;
    static constexpr double inf = std::numeric_limits<double>::infinity(),
                            nan = std::numeric_limits<double>::quiet_NaN(), largest = 0x1.fffffep127;
    static const auto pick = [](R r, T t) -> ClipPoint& { return t[std::size_t(r.integer(0, 2))]; };
    static const auto inside = [](R r, T t) {
        for (auto& p : t) p = {p[3] * r.between(-1, 1), p[3] * r.between(-1, 1), p[3] * r.unit(), p[3]};
    };
    static const ClipFamily all[] = {
        {"inside", true, [](R r, T t) { inside(r, t); }},
        {"mixed_planes", true, [](R, T) {}},
        {"all_behind", true,
         [](R, T t) {
             for (auto& p : t) p[3] = -p[3];
         }},
        {"one_behind", true,
         [](R r, T t) {
             auto& p = pick(r, t);
             p[3] = -p[3];
         }},
        {"w_zero", true, [](R r, T t) { pick(r, t)[3] = r.coin() ? 0.0 : -0.0; }},
        {"the_eye_itself", true,
         [](R r, T t) {
             pick(r, t) = {0, 0, 0, 0};
         }},
        {"w_tiny", true, [](R r, T t) { pick(r, t)[3] = pipeline::exp2(-r.between(20, 149)); }},
        {"on_a_side", true,
         [](R, T t) {
             for (auto& p : t) p[0] = p[3];
         }},
        {"edge_on_a_guard_plane", true, [](R, T t) { t[0][0] = 7 * t[0][3], t[1][0] = 7 * t[1][3]; }},
        {"edge_on_near", true, [](R, T t) { t[0][2] = t[0][3], t[1][2] = t[1][3]; }},
        {"edge_on_far", true, [](R, T t) { t[0][2] = 0, t[1][2] = -0.0; }},
        {"huge", true,
         [](R, T t) {
             for (auto& p : t)
                 for (auto& v : p) v *= 1e30;
         }},
        {"tiny", true,
         [](R, T t) {
             for (auto& p : t)
                 for (auto& v : p) v *= 0x1p-100;
         }},
        {"largest_float", true, [](R r, T t) { pick(r, t)[0] = largest, t[0][3] = largest / 16; }},
        {"far_behind", true,
         [](R r, T t) {
             auto& p = pick(r, t);
             p[2] = 1e6, p[3] = -1e6;
         }},
        {"outside_but_seen", true,
         [](R, T t) {
             t = {ClipPoint{5, 0, 0.5, 1}, ClipPoint{-5, 0, 0.5, 1}, ClipPoint{0, 5, 0.5, 1}};
         }},
        {"round_a_corner", true,
         [](R r, T t) {
             t = {ClipPoint{1, 3, 0.5, 1}, ClipPoint{3, 1, 0.5, 1},
                  ClipPoint{r.between(2, 4), r.between(2, 4), 0.5, 1}};
         }},
        {"round_a_guard_corner", true,
         [](R r, T t) {
             t = {ClipPoint{0, r.between(7, 30), 0.5, 1}, ClipPoint{r.between(7, 30), 0, 0.5, 1},
                  ClipPoint{-r.between(0, 30), -r.between(0, 30), 0.5, 1}};
         }},
        {"thin_at_near", true,
         [](R r, T t) {
             for (auto& p : t) p[2] = p[3] * (1 + static_cast<double>(r.integer(-2, 2)) * 0x1p-23);
         }},
        {"thin_at_far", true,
         [](R r, T t) {
             for (auto& p : t) p[2] = p[3] * static_cast<double>(r.integer(-2, 2)) * 0x1p-40;
         }},
        {"camera_inside", true,
         [](R r, T t) {
             t = {ClipPoint{-50, -50, 0.1, -10}, ClipPoint{50, -50, 0.1, -10},
                  ClipPoint{r.between(-9, 9), 80, 0.1, 40}};
         }},
        {"floor_to_the_horizon", true,
         [](R r, T t) {
             const double far = pipeline::exp2(r.between(5, 60)), side = r.between(1, 4) * far;
             t = {ClipPoint{-side, -1, 0.1, far}, ClipPoint{r.between(-2, 2), -1, 0.1, -1},
                  ClipPoint{side, -1, 0.1, far}};
         }},
        {"through_the_eye", true,
         [](R r, T t) {
             const double k =
                 r.coin() ? pipeline::exp2(static_cast<double>(r.integer(-2, 2))) : r.between(0.2, 3);
             for (int i = 0; i < 4; ++i) t[1][std::size_t(i)] = -k * t[0][std::size_t(i)];
         }},
        {"denormal_coordinates", true,
         [](R r, T t) {
             auto& p = pick(r, t);
             p[0] = 0x1p-149, p[1] = -0x1p-140;
         }},
        {"infinite", false,
         [](R r, T t) { pick(r, t)[std::size_t(r.integer(0, 3))] = r.coin() ? inf : -inf; }},
        {"not_a_number", false, [](R r, T t) { pick(r, t)[std::size_t(r.integer(0, 2))] = nan; }},
        {"w_not_a_number", false, [](R r, T t) { pick(r, t)[3] = nan; }},
    };
    return all;
}

inline ClipTriangle make(const ClipFamily& family, std::uint64_t seed) {
    Random random(seed_of(family.name, seed));
    ClipTriangle t;
    for (auto& p : t)
        p = {random.between(-2, 2), random.between(-2, 2), random.between(-1, 2), random.between(0.1, 3)};
    family.spoil(random, t);
    for (auto& p : t)
        for (auto& v : p) v = static_cast<double>(static_cast<float>(v));
    return t;
}

inline std::string name(std::string_view family, std::uint64_t seed) {
    return std::string(family) + ":" + std::to_string(seed);
}

}  // namespace relevo::tests::hard
