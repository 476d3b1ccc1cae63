// The slow oracles, in rational numbers and big integers. Heavy to compile: few tests include it.
#pragma once
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "tests/support/exact.hpp"

namespace relevo::tests::exact {

using Rational = boost::multiprecision::cpp_rational;
using Integer = boost::multiprecision::cpp_int;

// The top-left rule in the words of Direct3D 11.3, 3.4.2.1: strictly inside, or on edges that are all top or
// left. A top edge is horizontal and above the third corner; a left one is not horizontal and left of it.
inline bool covers_by_the_words(const Triangle& t, Site p) {
    const auto cross = [](Site a, Site b, Site c) {
        return Rational(b.x - a.x) * (c.y - a.y) - Rational(b.y - a.y) * (c.x - a.x);
    };
    const Rational area = cross(t[0], t[1], t[2]);
    if (area == 0) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        const Site a = t[i], b = t[(i + 1) % 3], third = t[(i + 2) % 3];
        const Rational share = cross(a, b, p) / area;
        if (share < 0) return false;
        if (share > 0) continue;
        const bool top = a.y == b.y && third.y > a.y;
        const bool left =
            a.y != b.y && Rational(third.x) > a.x + Rational((third.y - a.y) * (b.x - a.x)) / (b.y - a.y);
        if (!top && !left) return false;
    }
    return true;
}

// sum of share_i value_i over a triangle at p, where share_i are the barycentric coordinates times factor_i:
// with factor 1 the plane through the corners, with factor 1/w the perspective value.
inline Rational interpolated(const Triangle& t, Site p, const std::array<Rational, 3>& value,
                             const std::array<Rational, 3>& factor) {
    Rational sum = 0, whole = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Site a = t[(i + 1) % 3], b = t[(i + 2) % 3];
        const Rational share = factor[i] * Rational((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
        sum += share * value[i], whole += share;
    }
    return sum / whole;
}

// Coverage from clip space, before any division or clipping: the ray through a pixel's centre hits the
// triangle.
//
// A point sum l_i V_i of the triangle (l_i >= 0, not all 0) is seen at (x/w, y/w) where w > 0. So the centre
// (c.x, c.y) is covered when  M l = (c.x, c.y, 1)  has a solution l >= 0, with M the columns (x, y, w) of the
// corners, and the point hit has 0 <= z <= w. Everything is an integer: the corners share one power of two.
class ClipTriangle {
  public:
    ClipTriangle(const std::array<std::array<double, 4>, 3>& corners, int width, int height)
        : width_(width), height_(height) {
        int lowest = 2000;
        for (const auto& c : corners)
            for (const double v : c)
                if (v != 0) lowest = std::min(lowest, std::ilogb(v) - 52);
        Integer v[3][4];
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 4; ++k) v[i][k] = scaled(corners[std::size_t(i)][std::size_t(k)], lowest);
        for (int i = 0; i < 3; ++i) {
            const auto &a = v[(i + 1) % 3], &b = v[(i + 2) % 3];
            form_[i] = {a[1] * b[3] - a[3] * b[1], a[3] * b[0] - a[0] * b[3], a[0] * b[1] - a[1] * b[0]};
        }
        determinant_ = form_[0].x * v[0][0] + form_[0].y * v[0][1] + form_[0].w * v[0][3];
        for (int i = 0; i < 3; ++i) add(form_[3], form_[i], v[i][2]);            // z
        for (int i = 0; i < 3; ++i) add(form_[4], form_[i], v[i][3] - v[i][2]);  // w - z
        if (determinant_ < 0)
            for (Form& f : form_) f = {-f.x, -f.y, -f.w};
    }

    bool edge_on() const { return determinant_ == 0; }  // seen as a line: it has no pixels

    struct Answer {
        bool covered;
        double distance;  // pixels, to the nearest line that bounds the region
    };
    Answer at(int x, int y) const {
        // centre in ndc, times width * height
        const Integer cx = Integer(2 * x + 1 - width_) * height_, cy = Integer(height_ - 2 * y - 1) * width_,
                      cw = Integer(width_) * height_;
        Answer answer{true, 1e9};
        for (const Form& f : form_) {
            const Integer value = f.x * cx + f.y * cy + f.w * cw;
            if (value < 0) answer.covered = false;
            // per pixel the value changes by 2 height f.x to the right and by 2 width f.y upwards
            const long double across = static_cast<long double>(Integer(2 * f.x * height_)),
                              up = static_cast<long double>(Integer(2 * f.y * width_));
            if (across == 0 && up == 0) continue;
            const long double d = static_cast<long double>(value) / std::hypot(across, up);
            answer.distance = std::min(answer.distance, static_cast<double>(std::abs(d)));
        }
        return answer;
    }

  private:
    struct Form {  // value at (x, y, w): l_0, l_1, l_2, z, w - z of the point hit, times |determinant|
        Integer x = 0, y = 0, w = 0;
    };
    static Integer scaled(double v, int lowest) {
        if (v == 0) return 0;
        int e;
        const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(v, &e), 53));
        return Integer(digits) << (e - 53 - lowest + 1);
    }
    static void add(Form& to, const Form& f, const Integer& factor) {
        to.x += f.x * factor, to.y += f.y * factor, to.w += f.w * factor;
    }
    int width_, height_;
    Form form_[5];
    Integer determinant_;
};

}  // namespace relevo::tests::exact
