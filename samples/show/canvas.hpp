// Drawing on a picture: lines, areas, discs, text. For diagrams: smooth edges by coverage, the same bytes
// everywhere.
//
// Places are in pixels from the upper-left corner, x to the right, y down; pixel (i, j) is [i, i+1) x [j,
// j+1). A colour's alpha is its opacity. Everything is cut at the canvas's clip rectangle; what is not finite
// is not drawn.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "raster/image.hpp"
#include "raster/output.hpp"
#include "samples/show/palette.hpp"

namespace relevo::show {

using Picture = raster::Image<Rgba8>;

struct Spot {
    double x = 0, y = 0;
};

struct Rect {
    int x = 0, y = 0, width = 0, height = 0;
    int right() const { return x + width; }
    int bottom() const { return y + height; }
    friend bool operator==(const Rect&, const Rect&) = default;
};
Rect inset(Rect rect, int margin);
Rect common(Rect a, Rect b);

struct Canvas {
    Picture* picture = nullptr;  // borrowed
    Rect clip;                   // within the picture
};
Canvas canvas_of(Picture& picture);
Canvas within(Canvas canvas, Rect rect);

struct Stroke {
    Rgba8 color = ink;
    double width = 1.5;
    double dash = 0;  // length of a dash and of a gap; 0: unbroken
};

// `coverage` 0..255 of the pixel is painted.
void blend(Picture& picture, int x, int y, Rgba8 color, int coverage = 255);
void fill(Canvas canvas, Rect rect, Rgba8 color);
void frame(Canvas canvas, Rect rect, Rgba8 color, int width = 1);
void line(Canvas canvas, Spot a, Spot b, Stroke stroke);
void path(Canvas canvas, std::span<const Spot> corners, Stroke stroke, bool closed);
void arrow(Canvas canvas, Spot from, Spot to, Stroke stroke);
void disc(Canvas canvas, Spot center, double radius, Rgba8 color);
void ring(Canvas canvas, Spot center, double radius, Stroke stroke);
void polygon(Canvas canvas, std::span<const Spot> corners,
             Rgba8 color);  // any shape; inside by the even-odd rule

// The picture `source`, every pixel `factor` x `factor` big, upper-left corner at (x, y).
void paste(Canvas canvas, const Picture& source, int x, int y, int factor = 1);
// Lines between the pixels of a picture pasted with this factor.
void pixel_grid(Canvas canvas, Rect rect, int factor, Rgba8 color);

// Text in cells of 6 x 11 dots, `size` pixels a dot. (x, y) is the upper-left corner of the first letter.
inline constexpr int letter_cell = 6, line_cell = 12, letter_height = 7;
void text(Canvas canvas, int x, int y, std::string_view words, Rgba8 color, int size = 2);
int text_width(std::string_view words, int size = 2);
int letters(std::string_view words);  // how many (UTF-8)
// The words cut to so many letters, with an ellipsis where something is missing.
std::string shortened(std::string_view words, int most);

// Visits every pixel that a line of this width touches: plot(x, y, coverage 0..1, t 0..1 along the line).
template <class Plot>
void trace_line(Rect clip, Spot a, Spot b, double width, Plot&& plot);

// ---- the rest is how trace_line does it ----

// The part [t0, t1] of the segment that lies in the rectangle grown by `margin`; false: none (Liang and
// Barsky 1984).
bool clip_segment(Rect rect, double margin, Spot a, Spot b, double& t0, double& t1);

template <class Plot>
void trace_line(Rect clip, Spot a, Spot b, double width, Plot&& plot) {
    const double radius = std::max(width, 1.0) / 2, strength = std::min(width, 1.0);
    double t0 = 0, t1 = 1;
    if (clip.width <= 0 || clip.height <= 0 || !clip_segment(clip, radius + 1, a, b, t0, t1)) return;
    const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    const Spot from{a.x + t0 * dx, a.y + t0 * dy}, to{a.x + t1 * dx, a.y + t1 * dy};
    const bool flat = std::abs(dx) >= std::abs(dy);
    // Steps along the longer direction; `reach` is how far the line reaches across it.
    const double slope = length2 == 0 ? 0 : (flat ? dy / dx : dx / dy);
    const double reach = (radius + 0.5) * std::sqrt(1 + slope * slope);
    const auto low = [&](double p, double q, double r) {
        return static_cast<int>(std::floor(std::min(p, q) - r));
    };
    const auto high = [&](double p, double q, double r) {
        return static_cast<int>(std::floor(std::max(p, q) + r));
    };
    const int first =
        std::max(flat ? clip.x : clip.y, low(flat ? from.x : from.y, flat ? to.x : to.y, radius + 0.5));
    const int last = std::min((flat ? clip.right() : clip.bottom()) - 1,
                              high(flat ? from.x : from.y, flat ? to.x : to.y, radius + 0.5));
    const double base = flat ? a.y : a.x, start = flat ? a.x : a.y;
    const int side_low = flat ? clip.y : clip.x, side_high = (flat ? clip.bottom() : clip.right()) - 1;
    for (int i = first; i <= last; ++i) {
        const double middle = base + slope * (i + 0.5 - start);
        const int end = std::min(side_high, static_cast<int>(std::floor(std::min(middle + reach, 1e9))));
        for (int j = std::max(side_low, static_cast<int>(std::floor(std::max(middle - reach, -1e9))));
             j <= end; ++j) {
            const double px = (flat ? i : j) + 0.5 - a.x, py = (flat ? j : i) + 0.5 - a.y;
            const double t = length2 == 0 ? 0 : std::clamp((px * dx + py * dy) / length2, 0.0, 1.0);
            const double away_x = px - t * dx, away_y = py - t * dy;
            const double coverage = radius + 0.5 - std::sqrt(away_x * away_x + away_y * away_y);
            if (coverage > 0) plot(flat ? i : j, flat ? j : i, strength * std::min(coverage, 1.0), t);
        }
    }
}

}  // namespace relevo::show
