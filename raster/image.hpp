// A picture in memory: rows from top to bottom, pixels from left to right, no padding.
#pragma once
#include <cassert>
#include <cstddef>
#include <new>
#include <vector>

namespace relevo::raster {

// Memory that starts on a cache line: a picture is then written by whole lines.
template <class T>
struct CacheLineAllocator {
    using value_type = T;
    static constexpr std::align_val_t line{64};
    CacheLineAllocator() = default;
    template <class U>
    constexpr CacheLineAllocator(const CacheLineAllocator<U>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), line)); }
    void deallocate(T* p, std::size_t) { ::operator delete(p, line); }
    friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

template <class Pixel>
class Image {
  public:
    using Pixels = std::vector<Pixel, CacheLineAllocator<Pixel>>;
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

    Pixels& pixels() { return pixels_; }
    const Pixels& pixels() const { return pixels_; }

  private:
    int width_ = 0, height_ = 0;
    Pixels pixels_;
};

}  // namespace relevo::raster
