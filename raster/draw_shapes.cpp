#include "raster/draw_shapes.hpp"

#include "raster/polygon_active_edges.hpp"

namespace relevo::raster {
namespace {

// Calls fill(y, x0, x1) for the pixels of the box whose centre lies on the edge, exactly.
template <class Fill>
void mark_border(SnappedPoint a, SnappedPoint b, const PixelBox& box, Fill&& fill) {
    if (a.y > b.y) std::swap(a, b);
    const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
    const auto [left, right] = std::minmax({a.x, b.x});
    const int first = std::max(box.x0, (left + 127) >> 8), last = std::min(box.x1, (right - 128) >> 8);
    for (int y = std::max(box.y0, (a.y + 127) >> 8); y <= std::min(box.y1, (b.y - 128) >> 8); ++y) {
        const std::int64_t across = (256 * std::int64_t{y} + 128 - a.y) * dx;
        if (dy == 0 && first <= last) fill(y, first, last + 1);
        if (dy == 0 || across % dy != 0) continue;
        const std::int64_t x = a.x + across / dy - 128;
        const int pixel = static_cast<int>(x >> 8);
        if (x % 256 == 0 && box.x0 <= pixel && pixel <= box.x1) fill(y, pixel, pixel + 1);
    }
}

}  // namespace

Image<std::uint8_t> window_mask(std::span<const glm::vec2> polygon, int width, int height) {
    Image<std::uint8_t> mask(width, height);
    const PixelBox box{0, 0, width - 1, height - 1};
    const auto window = pipeline::convex_window(polygon);
    if (!window && window.error() != pipeline::Refusal::NotConvex) return mask;
    SnappedRing ring;
    for (const glm::vec2& p : polygon) {
        if (!(std::abs(p.x) <= largest_place && std::abs(p.y) <= largest_place)) return mask;
        ring.push_back(snapped(p.x, p.y));
    }
    const auto fill = [&](int y, int x0, int x1) { std::fill(mask.row(y) + x0, mask.row(y) + x1, 1); };
    polygon_active_edges(std::span(&ring, 1), InsideRule::NonZero, FillRule::TopLeft, box, fill);
    for (std::size_t i = 0; i < ring.size(); ++i)
        mark_border(ring[i], ring[(i + 1) % ring.size()], box, fill);
    return mask;
}

Image<Rgba8> encoded(const Image<LinearRgb>& picture, Output output) {
    Image<Rgba8> out(picture.width(), picture.height());
    std::transform(picture.pixels().begin(), picture.pixels().end(), out.pixels().begin(),
                   [&](const LinearRgb& c) { return to_rgba8(c, output); });
    return out;
}

template void draw_shapes<const NoProbe>(const ShapeScene&, Image<LinearRgb>&, const NoProbe&&);

}  // namespace relevo::raster
