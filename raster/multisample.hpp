// Antialiasing by samples that shapes share: no seam between neighbours (Akeley 1993, "RealityEngine
// graphics": multisampling).
//
// Coverage by area is right for each shape and wrong for a mesh: two triangles that share a pixel half and
// half each paint half of what they find, and a quarter of the background stays (1 - 1/2)(1 - 1/2): 75 %
// instead of 100 %, a seam. Here n x n points a pixel carry a colour each; a shape paints the points inside
// it, and every point belongs to exactly one of the two triangles (supersample.hpp). At the end a pixel is
// the average of its points: the background is gone.
#pragma once
#include <vector>

#include "raster/composite.hpp"
#include "raster/image.hpp"
#include "raster/supersample.hpp"

namespace relevo::raster {

struct SampledShape {
    std::span<const std::vector<glm::dvec2>> rings;
    InsideRule inside = InsideRule::NonZero;
    LinearRgb color;
    Scalar opacity = 1;
};

// A pixel's points are averaged: not all of them have the same colour.
struct PixelResolved {
    int x, y;
    std::span<const LinearRgb> samples;  // n rows of n
    LinearRgb color;
};

// Draws the shapes, the first is the lowest, over what is in the pixels of the box, which is cut to the
// picture. n and coordinates as supersample.hpp; a shape that is refused there is left out. Memory: a band of
// rows of points, at most 2^18 points or a row of pixels.
template <class Probe = NoProbe>
void multisample(int n, std::span<const SampledShape> shapes, const PixelBox& box, Image<LinearRgb>& picture,
                 Probe&& probe = Probe{}) {
    const PixelBox seen{std::max(box.x0, 0), std::max(box.y0, 0), std::min(box.x1, picture.width() - 1),
                        std::min(box.y1, picture.height() - 1)};
    if (n < 1 || n > most_samples || seen.empty()) return;
    const int width = seen.x1 - seen.x0 + 1, height = seen.y1 - seen.y0 + 1;
    const int band = std::clamp((1 << 18) / (n * n * width), 1, height);
    Image<LinearRgb> points(n * width, n * band);
    std::vector<LinearRgb> samples(static_cast<std::size_t>(n * n));
    for (int top = seen.y0; top <= seen.y1; top += band) {
        const PixelBox rows{seen.x0, top, seen.x1, std::min(seen.y1, top + band - 1)};
        for (int y = 0; y < n * (rows.y1 - top + 1); ++y)
            for (int x = 0; x < n * width; ++x) points.at(x, y) = picture.at(seen.x0 + x / n, top + y / n);
        for (const SampledShape& shape : shapes)
            for_each_sample_run(
                n, shape.rings, shape.inside, rows,
                [&](int y, int x0, int x1) {
                    note<SamplesInside>(probe, y, x0, x1);
                    over(points.row(y - n * top), x0 - n * seen.x0, x1 - n * seen.x0, shape.color,
                         shape.opacity, full_coverage);
                },
                [](int) {});
        for (int y = top; y <= rows.y1; ++y)
            for (int x = seen.x0; x <= seen.x1; ++x) {
                double r = 0, g = 0, b = 0;
                bool alike = true;
                for (int i = 0; i < n * n; ++i) {
                    const LinearRgb& c = points.at(n * (x - seen.x0) + i % n, n * (y - top) + i / n);
                    samples[static_cast<std::size_t>(i)] = c;
                    r += c.r, g += c.g, b += c.b;
                    alike = alike && c == samples[0];
                }
                const double count = n * n;
                LinearRgb& pixel = picture.at(x, y);
                pixel = alike ? samples[0]
                              : LinearRgb{static_cast<Scalar>(r / count), static_cast<Scalar>(g / count),
                                          static_cast<Scalar>(b / count)};
                if (!alike) note<PixelResolved>(probe, x, y, std::span<const LinearRgb>(samples), pixel);
            }
    }
}

}  // namespace relevo::raster
