// A picture in memory: rows from top to bottom, pixels from left to right, no padding.
#pragma once
#include <cassert>
#include <cstddef>
#include <vector>

namespace relevo::raster {

template <class Pixel>
class Image {
  public:
    Image() = default;
    // Sizes are the caller's to check (1..max_picture_size) before memory is taken.
    Image(int width, int height, Pixel fill = {})
        : width_(width), height_(height), pixels_(std::size_t(width) * std::size_t(height), fill) {}

    int width() const { return width_; }
    int height() const { return height_; }
    bool empty() const { return pixels_.empty(); }

    Pixel* row(int y) { return pixels_.data() + std::size_t(y) * std::size_t(width_); }
    const Pixel* row(int y) const { return pixels_.data() + std::size_t(y) * std::size_t(width_); }
    Pixel& at(int x, int y) { return assert(holds(x, y)), row(y)[x]; }
    const Pixel& at(int x, int y) const { return assert(holds(x, y)), row(y)[x]; }
    bool holds(int x, int y) const { return 0 <= x && x < width_ && 0 <= y && y < height_; }

    std::vector<Pixel>& pixels() { return pixels_; }
    const std::vector<Pixel>& pixels() const { return pixels_; }

  private:
    int width_ = 0, height_ = 0;
    std::vector<Pixel> pixels_;
};

}  // namespace relevo::raster
