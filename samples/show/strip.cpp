#include "samples/show/strip.hpp"

#include <algorithm>

namespace relevo::show {
namespace {

constexpr int columns = 4, gap = 4;
constexpr Rgba8 paper{255, 255, 255, 255};

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
    // the smaller of both scales as a fraction over / under, at most 1
    const bool wide = page.width() * thumbnail_height > page.height() * thumbnail_width;
    int over = wide ? thumbnail_width : thumbnail_height, under = wide ? page.width() : page.height();
    if (over > under) over = under;
    const int width = std::max(1, page.width() * over / under),
              height = std::max(1, page.height() * over / under);
    Picture small(thumbnail_width, thumbnail_height, paper);
    const int left = (thumbnail_width - width) / 2, top = (thumbnail_height - height) / 2;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            small.at(left + x, top + y) =
                average(page, x * page.width() / width,
                        std::max(x * page.width() / width + 1, (x + 1) * page.width() / width),
                        y * page.height() / height,
                        std::max(y * page.height() / height + 1, (y + 1) * page.height() / height));
    return small;
}

Picture strip(std::span<const Picture> thumbnails) {
    const int count = static_cast<int>(thumbnails.size()), across = std::clamp(count, 1, columns);
    const int rows = std::max(1, (count + across - 1) / across);
    Picture all(across * (thumbnail_width + gap) + gap, rows * (thumbnail_height + gap) + gap,
                Rgba8{200, 205, 212, 255});
    for (int k = 0; k < count; ++k) {
        const Picture& one = thumbnails[std::size_t(k)];
        const int left = gap + k % across * (thumbnail_width + gap),
                  top = gap + k / across * (thumbnail_height + gap);
        for (int y = 0; y < thumbnail_height; ++y)
            std::copy_n(one.row(y), thumbnail_width, all.row(top + y) + left);
    }
    return all;
}

}  // namespace relevo::show
