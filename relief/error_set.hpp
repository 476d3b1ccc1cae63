// The error set: five numbers that say how far a picture of an object is from the truth.
//
// One number would hide what went wrong: a hole, a skin drawn where there is nothing and a wrong colour ask
// for different cures. The pictures are compared over the pixels that at least one of them covers, because
// the background, where both are empty, is always right and would only flatter.
//
//   missing   pixels of the truth that the picture leaves empty       % of the pixels of the truth
//   extra     pixels of the picture where the truth is empty          % of the pixels of the truth
//   psnr      10 log10(1 / MSE) over red, green and blue of the union; what is empty counts as black
//   depth     mean |depth - true depth| where both are covered        world units along the viewer's axis
//   bad       pixels of the union whose colour is more than 0.1 off   % of the union
//             (root of the mean square over red, green and blue)
//
// Equal pictures have an infinite psnr. Two empty ones are equal. Where the truth is empty and the picture is
// not, missing is 0 and extra counts against one pixel. A colour or depth that is not a number makes psnr or
// depth not a number, and its pixel bad.
#pragma once
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "pipeline/elementary.hpp"
#include "relief/view_image.hpp"

namespace relevo::relief {

struct ErrorSet {
    double missing_percent = 0, extra_percent = 0;
    double psnr = std::numeric_limits<double>::infinity();  // dB
    double mean_depth_error = 0;
    double bad_percent = 0;
    std::int64_t union_pixels = 0;
};

inline constexpr double bad_color = 0.1;  // linear light

inline double mean_square_difference(const LinearRgb& a, const LinearRgb& b) {
    const double r = double(a.r) - double(b.r), g = double(a.g) - double(b.g), u = double(a.b) - double(b.b);
    return ((r * r + g * g) + u * u) / 3;
}

inline double decibels(double mean_square_error) {
    constexpr double log10_of_2 = 0x1.34413509f79ffp-2;
    return -10 * log10_of_2 * pipeline::log2(mean_square_error);
}

// Both pictures have the same size.
inline ErrorSet error_set(const ViewImage& picture, const ViewImage& truth) {
    assert(picture.width() == truth.width() && picture.height() == truth.height());
    std::int64_t in_truth = 0, missing = 0, extra = 0, both = 0, bad = 0;
    double squares = 0, depth = 0;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x) {
            const bool seen = picture.coverage.at(x, y) != 0, there = truth.coverage.at(x, y) != 0;
            if (!seen && !there) continue;
            in_truth += there, missing += there && !seen, extra += seen && !there;
            const double square = mean_square_difference(seen ? picture.color.at(x, y) : LinearRgb{},
                                                         there ? truth.color.at(x, y) : LinearRgb{});
            squares += square, bad += !(square <= bad_color * bad_color);
            if (!seen || !there) continue;
            ++both, depth += std::fabs(double(picture.depth.at(x, y)) - double(truth.depth.at(x, y)));
        }
    ErrorSet result;
    const std::int64_t in_union = in_truth + extra;
    result.union_pixels = in_union;
    if (in_union == 0) return result;
    const auto percent = [](std::int64_t part, std::int64_t of) {
        return 100.0 * double(part) / double(std::max<std::int64_t>(of, 1));
    };
    result.missing_percent = percent(missing, in_truth), result.extra_percent = percent(extra, in_truth);
    result.psnr = decibels(squares / double(in_union));
    if (both > 0) result.mean_depth_error = depth / double(both);
    result.bad_percent = percent(bad, in_union);
    return result;
}

}  // namespace relevo::relief
