// Animated PNG files: pictures shown one after the other, again and again. Viewers that know no animation
// show the first.
//
// Source: APNG specification (S. Parmenter, V. Vukicevic, A. Smith 2004), since 2025 part of W3C, Portable
// Network Graphics (PNG) Specification, third edition: chunks acTL, fcTL and fdAT.
#pragma once
#include <cstdint>
#include <string>

#include "raster/image.hpp"
#include "raster/output.hpp"

namespace relevo::io {

// Pictures go in one by one and are compressed at once, so a long film needs little memory. A frame stores
// the rectangle in which it differs from the frame before. The same pictures give the same bytes. Alpha is
// not stored.
class AnimatedPng {
  public:
    // All pictures have the size of the first, which is not empty. The frame is seen for 1..65535 ms.
    void add(const raster::Image<raster::Rgba8>& picture, int milliseconds);

    // The file so far; empty without a picture.
    std::string bytes() const;

  private:
    void add_control(int x, int y, int width, int height, int milliseconds);

    raster::Image<raster::Rgba8> last_;
    std::uint32_t frames_ = 0, sequence_ = 0;  // of frames; of chunks that must stay in order
    std::string header_, chunks_;              // IHDR; fcTL, IDAT and fdAT
};

}  // namespace relevo::io
