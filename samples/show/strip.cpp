#include "samples/show/strip.hpp"

#include <algorithm>
#include <vector>

namespace relevo::show {
namespace {

constexpr int columns = 4, gap = 4;

// The average of the source pixels [x0, x1) x [y0, y1), rounded to nearest.
Rgba8 average(const Picture& source, int x0, int x1, int y0, int y1) {
    int r = 0, g = 0, b = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const Rgba8 p = source.at(x, y);
            r += p.r, g += p.g, b += p.b;
        }
    const int n = (x1 - x0) * (y1 - y0);
    const auto mean = [n](int sum) { return static_cast<std::uint8_t>((sum + n / 2) / n); };
    return {mean(r), mean(g), mean(b), 255};
}

}  // namespace

Picture thumbnail(const Picture& page) {
    // the smaller of both scales as a fraction, at most 1
    const bool wide = page.width() * thumbnail_height > page.height() * thumbnail_width;
    const int under = wide ? page.width() : page.height();
    const int over = std::min(under, wide ? thumbnail_width : thumbnail_height);
    Picture small(std::max(1, page.width() * over / under), std::max(1, page.height() * over / under));
    const auto edge = [](int k, int from, int to) { return k * from / to; };
    for (int y = 0; y < small.height(); ++y)
        for (int x = 0; x < small.width(); ++x)
            small.at(x, y) =
                average(page, edge(x, page.width(), small.width()), edge(x + 1, page.width(), small.width()),
                        edge(y, page.height(), small.height()), edge(y + 1, page.height(), small.height()));
    return small;
}

Picture strip(std::span<const Picture> thumbnails) {
    std::vector<int> tops{gap};  // where each row begins, and the end of the last
    for (std::size_t k = 0; k < thumbnails.size(); k += columns) {
        int height = 0;
        for (const Picture& one :
             thumbnails.subspan(k, std::min(thumbnails.size() - k, std::size_t{columns})))
            height = std::max(height, one.height());
        tops.push_back(tops.back() + height + gap);
    }
    const int across = std::clamp(static_cast<int>(thumbnails.size()), 1, columns);
    Picture all(across * (thumbnail_width + gap) + gap, tops.back(), rule);
    const std::size_t lone = thumbnails.size() % columns;  // in the last row: they stand in its middle
    for (std::size_t k = 0; k < thumbnails.size(); ++k) {
        const Picture& one = thumbnails[k];
        const bool in_short_row = thumbnails.size() > columns && k >= thumbnails.size() - lone;
        const int empty = in_short_row ? columns - static_cast<int>(lone) : 0;
        const int left = gap + (2 * static_cast<int>(k % columns) + empty) * (thumbnail_width + gap) / 2,
                  top = tops[k / columns];
        for (int y = 0; y < one.height(); ++y) std::copy_n(one.row(y), one.width(), all.row(top + y) + left);
    }
    return all;
}

}  // namespace relevo::show
