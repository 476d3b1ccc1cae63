// Exact signs and correctly rounded quotients of formulas over floats (Dekker 1971, "A floating-point
// technique for extending the available precision"; Shewchuk 1997, "Adaptive precision floating-point
// arithmetic and fast robust geometric predicates").
//
// A geometric decision is the sign of a short formula: sums and products of coordinates. Rounding can turn
// that sign. So a formula is written once, over any kind of number, and evaluated twice at most:
//   Bounded  a double and how far it can be from the truth. Mostly that is enough.
//   Exact    a sum of doubles without rounding, for the rest.
//
//     sign_of([&](auto n) { return n(b.x) * n(p.y) - n(b.y) * n(p.x); })
//
// Limits: the products of a formula have at most 5 float factors. Then nothing overflows or underflows in
// double, whatever finite floats they are: 2^-149 to the fifth is above 2^-1022, 2^128 to the fifth below
// 2^1024. No fused multiply-add is used. Values that are not finite have no meaning here.
#pragma once
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "pipeline/scalar.hpp"

namespace relevo::pipeline {

// high + low is the exact result, high the rounded one.
struct TwoDoubles {
    double high, low;
};

constexpr TwoDoubles two_sum(double a, double b) {
    const double sum = a + b, b_part = sum - a, a_part = sum - b_part;
    return {sum, (a - a_part) + (b - b_part)};
}

// A double as two numbers of at most 26 bits, whose products are exact.
constexpr TwoDoubles split(double a) {
    const double shifted = 0x8000001p0 * a, high = shifted - (shifted - a);
    return {high, a - high};
}

constexpr TwoDoubles two_product(double a, double b) {
    const double product = a * b;
    const auto [ah, al] = split(a);
    const auto [bh, bl] = split(b);
    return {product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
}

// A number as a sum of doubles that do not overlap, the smallest first, none of them zero.
class Exact {
  public:
    Exact(double value = 0) { add(value); }
    Exact(const Exact& other) { *this = other; }
    Exact& operator=(const Exact& other) {
        std::copy(other.begin(), other.end(), part_);
        size_ = other.size_;
        return *this;
    }

    int sign() const { return size_ == 0 ? 0 : part_[size_ - 1] > 0 ? 1 : -1; }
    // As a double, with a relative error below 2^-50.
    double value() const {
        double sum = 0;
        for (const double part : *this) sum += part;
        return sum;
    }
    Exact half() const {
        Exact result;
        for (const double part : *this) result.part_[result.size_++] = 0.5 * part;
        return result;
    }

    friend Exact operator+(Exact a, const Exact& b) {
        for (const double part : b) a.add(part);
        return a;
    }
    friend Exact operator-(Exact a, const Exact& b) {
        for (const double part : b) a.add(-part);
        return a;
    }
    friend Exact operator*(const Exact& a, const Exact& b) {
        Exact result;
        for (const double p : a)
            for (const double q : b) {
                const auto [high, low] = two_product(p, q);
                result.add(low), result.add(high);
            }
        return result;
    }

  private:
    // Five factors span 1385 bits, which 28 packed doubles hold.
    static constexpr std::size_t capacity = 48;

    const double* begin() const { return part_; }
    const double* end() const { return part_ + size_; }

    // What a rounded sum loses is kept and the sum carried on: Grow-Expansion.
    void add(double carry) {
        if (size_ == capacity) pack();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const auto [sum, lost] = two_sum(carry, part_[i]);
            if (lost != 0) part_[kept++] = lost;
            carry = sum;
        }
        if (carry != 0) part_[kept++] = carry;
        size_ = kept;
    }

    // The same number in as few doubles as can be, each below half a unit of the last place of the next:
    // Compress. From the largest down what rounding loses is carried on, then from the smallest up.
    void pack() {
        double sums[capacity];  // the largest first
        std::size_t count = 0;
        double carry = 0;
        for (std::size_t i = size_; i-- > 0;) {
            const auto [sum, lost] = two_sum(carry, part_[i]);
            if (lost != 0) sums[count++] = sum;
            carry = lost != 0 ? lost : sum;
        }
        size_ = 0;
        while (count > 0) {
            const auto [sum, lost] = two_sum(sums[--count], carry);
            if (lost != 0) part_[size_++] = lost;
            carry = sum;
        }
        part_[size_++] = carry;
        assert(size_ < capacity);
    }

    std::size_t size_ = 0;
    double part_[capacity];
};

// |truth - value| <= error.
struct Bounded {
    double value = 0, error = 0;

    Bounded(double exact = 0) : value(exact) {}
    Bounded(double rounded, double inherited)
        : value(rounded), error((inherited + std::abs(rounded) * 0x1p-53) * (1 + 0x1p-49)) {}

    friend Bounded operator+(const Bounded& a, const Bounded& b) {
        return {a.value + b.value, a.error + b.error};
    }
    friend Bounded operator-(const Bounded& a, const Bounded& b) {
        return {a.value - b.value, a.error + b.error};
    }
    friend Bounded operator*(const Bounded& a, const Bounded& b) {
        return {a.value * b.value,
                std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error};
    }
};

// What a formula is given to turn coordinates into numbers.
template <class Number>
struct As {
    Number operator()(float value) const { return Number(static_cast<double>(value)); }
};

template <class Number>
struct Fraction {
    Number top, bottom;
};
template <class Number>
Fraction(Number, Number) -> Fraction<Number>;

// -1, 0 or 1. `formula(n)` is built from n(coordinate), +, - and *.
template <class Formula>
int sign_of(const Formula& formula) {
    const Bounded quick = formula(As<Bounded>{});
    if (std::abs(quick.value) > quick.error) return quick.value > 0 ? 1 : -1;
    return formula(As<Exact>{}).sign();
}

// The float nearest to top / bottom, ties to even; zero is +0. The bottom is not 0, the quotient within the
// range of floats, and the products in both have at most 4 float factors.
inline float nearest_float(const Exact& top, const Exact& bottom) {
    const double q = top.value() / bottom.value(), error = std::abs(q) * 0x1p-48;
    const float below = static_cast<float>(q - error), above = static_cast<float>(q + error);
    if (below == above) return below + 0.0f;
    // Two neighbours: which side of their middle?
    const double middle = (static_cast<double>(below) + static_cast<double>(above)) / 2;
    const int side = (top - bottom * middle).sign() * bottom.sign();
    return (side < 0 ? below : side > 0 ? above : static_cast<float>(middle)) + 0.0f;
}

// The same for a formula(n) that gives a Fraction.
template <class Formula>
float nearest_float(const Formula& formula) {
    const Fraction<Bounded> quick = formula(As<Bounded>{});
    if (const double bottom = std::abs(quick.bottom.value); quick.bottom.error < bottom / 4) {
        const double q = quick.top.value / quick.bottom.value;
        const double error =
            2 * (quick.top.error + std::abs(q) * quick.bottom.error) / bottom + std::abs(q) * 0x1p-50;
        const float below = static_cast<float>(q - error), above = static_cast<float>(q + error);
        if (below == above) return below + 0.0f;
    }
    const Fraction<Exact> exact = formula(As<Exact>{});
    return nearest_float(exact.top, exact.bottom);
}

}  // namespace relevo::pipeline
