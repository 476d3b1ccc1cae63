// Colour as the pipeline computes with it: linear light, red green blue.
#pragma once
#include "pipeline/scalar.hpp"

namespace relevo::pipeline {

struct LinearRgb {
    Scalar r = 0, g = 0, b = 0;
    friend constexpr bool operator==(const LinearRgb&, const LinearRgb&) = default;
};
constexpr LinearRgb operator+(LinearRgb a, LinearRgb b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr LinearRgb operator*(LinearRgb a, LinearRgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr LinearRgb operator*(Scalar k, LinearRgb a) { return {k * a.r, k * a.g, k * a.b}; }

}  // namespace relevo::pipeline
