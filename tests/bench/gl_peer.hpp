// The same work done by the machine's OpenGL 3.3, without a window: with Mesa's llvmpipe a CPU rasterizer to
// be measured against (LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe, LP_NUM_THREADS=0 for one thread).
#pragma once
#include <string>

#include "raster/image.hpp"
#include "raster/output.hpp"
#include "tests/bench/workload.hpp"

namespace relevo::bench {

class GlPeer {
  public:
    // Ends the program with a sentence when there is no OpenGL 3.3 to be had.
    GlPeer(const Workload& workload, Mode mode, int width, int height);
    ~GlPeer();
    GlPeer(const GlPeer&) = delete;
    GlPeer& operator=(const GlPeer&) = delete;

    void draw(int frame);  // returns when the picture stands in memory
    raster::Image<raster::Rgba8> picture() const;
    static std::string renderer();  // its name and versions

  private:
    const Workload& workload_;
    int width_, height_;
    unsigned program_ = 0, vertex_array_ = 0, buffers_[2] = {0, 0}, renderbuffers_[2] = {0, 0},
             framebuffer_ = 0, texture_ = 0;
};

}  // namespace relevo::bench
