#include "samples/show/canvas.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include "samples/show/font.hpp"

namespace relevo::show {
namespace {

bool finite(Spot s) { return std::isfinite(s.x) && std::isfinite(s.y); }

int to_coverage(double share) { return static_cast<int>(std::clamp(share, 0.0, 1.0) * 255 + 0.5); }

}  // namespace

Rect inset(Rect rect, int margin) {
    return {rect.x + margin, rect.y + margin, std::max(rect.width - 2 * margin, 0),
            std::max(rect.height - 2 * margin, 0)};
}

Rect common(Rect a, Rect b) {
    const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    return {x, y, std::max(std::min(a.right(), b.right()) - x, 0),
            std::max(std::min(a.bottom(), b.bottom()) - y, 0)};
}

Canvas canvas_of(Picture& picture) { return {&picture, {0, 0, picture.width(), picture.height()}}; }

Canvas within(Canvas canvas, Rect rect) { return {canvas.picture, common(canvas.clip, rect)}; }

void blend(Picture& picture, int x, int y, Rgba8 color, int coverage) {
    const int a = (color.a * coverage + 127) / 255;
    Rgba8& pixel = picture.at(x, y);
    const auto mix = [a](int old, int fresh) {
        return static_cast<std::uint8_t>((fresh * a + old * (255 - a) + 127) / 255);
    };
    pixel = {mix(pixel.r, color.r), mix(pixel.g, color.g), mix(pixel.b, color.b), 255};
}

void fill(Canvas canvas, Rect rect, Rgba8 color) {
    const Rect area = common(canvas.clip, rect);
    for (int y = area.y; y < area.bottom(); ++y)
        for (int x = area.x; x < area.right(); ++x) blend(*canvas.picture, x, y, color);
}

void frame(Canvas canvas, Rect rect, Rgba8 color, int width) {
    fill(canvas, {rect.x, rect.y, rect.width, width}, color);
    fill(canvas, {rect.x, rect.bottom() - width, rect.width, width}, color);
    fill(canvas, {rect.x, rect.y + width, width, rect.height - 2 * width}, color);
    fill(canvas, {rect.right() - width, rect.y + width, width, rect.height - 2 * width}, color);
}

bool clip_segment(Rect rect, double margin, Spot a, Spot b, double& t0, double& t1) {
    if (!finite(a) || !finite(b)) return false;
    const double delta[2] = {b.x - a.x, b.y - a.y}, start[2] = {a.x, a.y};
    const double low[2] = {rect.x - margin, rect.y - margin},
                 high[2] = {rect.right() + margin, rect.bottom() + margin};
    for (int axis = 0; axis < 2; ++axis) {
        if (delta[axis] == 0) {
            if (start[axis] < low[axis] || start[axis] > high[axis]) return false;
            continue;
        }
        const double at_low = (low[axis] - start[axis]) / delta[axis],
                     at_high = (high[axis] - start[axis]) / delta[axis];
        t0 = std::max(t0, std::min(at_low, at_high));
        t1 = std::min(t1, std::max(at_low, at_high));
    }
    return t0 <= t1;
}

void line(Canvas canvas, Spot a, Spot b, Stroke stroke) {
    const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    trace_line(canvas.clip, a, b, stroke.width, [&](int x, int y, double coverage, double t) {
        if (stroke.dash > 0) {
            const double dashes = t * length / (2 * stroke.dash);
            if (dashes - std::floor(dashes) >= 0.5) return;
        }
        blend(*canvas.picture, x, y, stroke.color, to_coverage(coverage));
    });
}

void path(Canvas canvas, std::span<const Spot> corners, Stroke stroke, bool closed) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) line(canvas, corners[i], corners[i + 1], stroke);
    if (closed && corners.size() > 2) line(canvas, corners.back(), corners.front(), stroke);
}

void arrow(Canvas canvas, Spot from, Spot to, Stroke stroke) {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0) || !std::isfinite(length)) return;
    const double ux = dx / length, uy = dy / length, head = std::min(length, 5 + 3 * stroke.width),
                 half = head * 0.4;
    const Spot neck{to.x - head * ux, to.y - head * uy};
    line(canvas, from, neck, stroke);
    const std::array<Spot, 3> tip{to, Spot{neck.x - half * uy, neck.y + half * ux},
                                  Spot{neck.x + half * uy, neck.y - half * ux}};
    polygon(canvas, tip, stroke.color);
}

void disc(Canvas canvas, Spot center, double radius, Rgba8 color) {
    trace_line(canvas.clip, center, center, 2 * radius, [&](int x, int y, double coverage, double) {
        blend(*canvas.picture, x, y, color, to_coverage(coverage));
    });
}

void ring(Canvas canvas, Spot center, double radius, Stroke stroke) {
    trace_line(
        canvas.clip, center, center, 2 * radius + stroke.width, [&](int x, int y, double coverage, double) {
            const double dx = x + 0.5 - center.x, dy = y + 0.5 - center.y;
            const double inner = std::sqrt(dx * dx + dy * dy) - (radius - stroke.width / 2) + 0.5;
            blend(*canvas.picture, x, y, stroke.color, to_coverage(std::min(coverage, std::max(inner, 0.0))));
        });
}

namespace {

// Adds the share of each pixel that [from, to) covers on one of the four lines through a pixel row.
void add_span(std::vector<double>& shares, int left, double from, double to) {
    from = std::max(from, double(left));
    to = std::min(to, left + double(shares.size()));
    for (int x = static_cast<int>(std::floor(from)); x < to; ++x) {
        const double share = std::min(to, x + 1.0) - std::max(from, double(x));
        if (share > 0) shares[static_cast<std::size_t>(x - left)] += share / 4;
    }
}

std::vector<double> crossings(std::span<const Spot> corners, double y) {
    std::vector<double> found;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Spot a = corners[i], b = corners[(i + 1) % corners.size()];
        if ((a.y <= y) != (b.y <= y)) found.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

void polygon(Canvas canvas, std::span<const Spot> corners, Rgba8 color) {
    if (corners.size() < 3 || !std::all_of(corners.begin(), corners.end(), finite)) return;
    if (canvas.clip.width <= 0) return;
    double top = corners[0].y, bottom = corners[0].y, left = corners[0].x, right = corners[0].x;
    for (const Spot s : corners) {
        top = std::min(top, s.y), bottom = std::max(bottom, s.y);
        left = std::min(left, s.x), right = std::max(right, s.x);
    }
    const auto bounded = [](double v, int low, int high) {
        return static_cast<int>(std::floor(std::clamp(v, double(low), double(high))));
    };
    const Rect clip = canvas.clip;
    const int first_x = bounded(left, clip.x, clip.right() - 1),
              last_x = bounded(right, clip.x, clip.right() - 1);
    std::vector<double> shares(static_cast<std::size_t>(last_x - first_x + 1));
    for (int y = bounded(top, clip.y, clip.bottom()); y < bounded(bottom + 1, clip.y, clip.bottom()); ++y) {
        std::fill(shares.begin(), shares.end(), 0.0);
        for (int part = 0; part < 4; ++part) {
            const std::vector<double> at = crossings(corners, y + 0.125 + 0.25 * part);
            for (std::size_t i = 0; i + 1 < at.size(); i += 2) add_span(shares, first_x, at[i], at[i + 1]);
        }
        for (std::size_t i = 0; i < shares.size(); ++i)
            if (shares[i] > 0)
                blend(*canvas.picture, first_x + static_cast<int>(i), y, color, to_coverage(shares[i]));
    }
}

void paste(Canvas canvas, const Picture& source, int x, int y, int factor) {
    const Rect area = common(canvas.clip, {x, y, source.width() * factor, source.height() * factor});
    for (int j = area.y; j < area.bottom(); ++j)
        for (int i = area.x; i < area.right(); ++i)
            canvas.picture->at(i, j) = source.at((i - x) / factor, (j - y) / factor);
}

void pixel_grid(Canvas canvas, Rect rect, int factor, Rgba8 color) {
    for (int x = rect.x; x <= rect.right(); x += factor) fill(canvas, {x, rect.y, 1, rect.height + 1}, color);
    for (int y = rect.y; y <= rect.bottom(); y += factor) fill(canvas, {rect.x, y, rect.width + 1, 1}, color);
}

// ---- text ----
namespace {

constexpr int enlargement = 8;
using Dots = std::vector<std::uint8_t>;

// Doubles a drawing and rounds its corners (EPX: Eric Johnston 1992; Scale2x: Andrea Mazzoleni 2001).
Dots doubled(const Dots& dots, int width, int height) {
    const auto dot = [&](int x, int y) -> int {
        return x >= 0 && x < width && y >= 0 && y < height ? dots[static_cast<std::size_t>(y * width + x)]
                                                           : 0;
    };
    Dots out(dots.size() * 4);
    for (int y = 0; y < 2 * height; ++y)
        for (int x = 0; x < 2 * width; ++x) {
            const int cx = x / 2, cy = y / 2, dx = x % 2 ? 1 : -1, dy = y % 2 ? 1 : -1;
            const int side = dot(cx + dx, cy), upright = dot(cx, cy + dy);
            const bool corner = side == upright && side != dot(cx - dx, cy) && upright != dot(cx, cy - dy);
            out[static_cast<std::size_t>(y * 2 * width + x)] =
                static_cast<std::uint8_t>(corner ? side : dot(cx, cy));
        }
    return out;
}

// The glyph at 8 times its size, 40 x 72.
Dots enlarged_glyph(int glyph) {
    Dots dots;
    for (int y = 0; y < glyph_height; ++y)
        for (int x = 0; x < glyph_width; ++x) dots.push_back(glyph_dot(glyph, x, y));
    for (int factor = 1; factor < enlargement; factor *= 2)
        dots = doubled(dots, glyph_width * factor, glyph_height * factor);
    return dots;
}

// How much of pixel (x, y) of the glyph drawn at `size` pixels a dot is ink: the mean over its part of the
// drawing.
int glyph_coverage(const Dots& dots, int size, int x, int y) {
    const auto overlap = [size](int cell, int pixel) {  // in 1/size of a cell
        return std::min((cell + 1) * size, (pixel + 1) * enlargement) -
               std::max(cell * size, pixel * enlargement);
    };
    int sum = 0;
    for (int j = y * enlargement / size; j * size < (y + 1) * enlargement; ++j)
        for (int i = x * enlargement / size; i * size < (x + 1) * enlargement; ++i)
            if (dots[static_cast<std::size_t>(j * glyph_width * enlargement + i)])
                sum += overlap(i, x) * overlap(j, y);
    return sum * 255 / (enlargement * enlargement);
}

// The next letter of UTF-8 text; what is no valid sequence counts as one unknown letter a byte.
char32_t next_letter(std::string_view words, std::size_t& at) {
    const auto byte = [&](std::size_t i) {
        return i < words.size() ? static_cast<unsigned char>(words[i]) : static_cast<unsigned char>(0);
    };
    const unsigned first = byte(at);
    const int more = first < 0x80                    ? 0
                     : first >= 0xF0 && first < 0xF8 ? 3
                     : first >= 0xE0                 ? 2
                     : first >= 0xC0                 ? 1
                                                     : 0;
    char32_t letter = more == 0 ? first : first & (0x3Fu >> more);
    for (int i = 1; i <= more; ++i) {
        const unsigned next = byte(at + static_cast<std::size_t>(i));
        if ((next & 0xC0u) != 0x80u) return ++at, U'\u007f';
        letter = letter << 6 | (next & 0x3Fu);
    }
    at += static_cast<std::size_t>(more) + 1;
    return letter;
}

void draw_glyph(Canvas canvas, int x, int y, int glyph, Rgba8 color, int size) {
    const Rect cell{x, y, glyph_width * size, glyph_height * size}, area = common(canvas.clip, cell);
    if (area.width == 0 || area.height == 0) return;
    const Dots dots = enlarged_glyph(glyph);
    for (int j = area.y; j < area.bottom(); ++j)
        for (int i = area.x; i < area.right(); ++i)
            if (const int coverage = glyph_coverage(dots, size, i - x, j - y))
                blend(*canvas.picture, i, j, color, coverage);
}

}  // namespace

void text(Canvas canvas, int x, int y, std::string_view words, Rgba8 color, int size) {
    for (std::size_t at = 0; at < words.size(); x += letter_cell * size)
        if (const int glyph = glyph_of(next_letter(words, at)); glyph != 0)
            draw_glyph(canvas, x, y, glyph, color, size);
}

int letters(std::string_view words) {
    int count = 0;
    for (std::size_t at = 0; at < words.size(); ++count) next_letter(words, at);
    return count;
}

int text_width(std::string_view words, int size) {
    return std::max(letters(words) * letter_cell - 1, 0) * size;
}

std::string shortened(std::string_view words, int most) {
    if (letters(words) <= most) return std::string(words);
    std::size_t at = 0;
    for (int i = 0; i < most - 3; ++i) next_letter(words, at);
    return std::string(words.substr(0, at)) +
           std::string("...").substr(0, static_cast<std::size_t>(std::max(0, std::min(most, 3))));
}

}  // namespace relevo::show
