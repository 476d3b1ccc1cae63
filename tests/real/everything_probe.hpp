// A probe that hears every event of the machine and reads every number in it.
#pragma once
#include <cstdint>
#include <cstring>

#include "pipeline/clip_polygon.hpp"
#include "raster/events.hpp"

namespace relevo::real {

class EverythingProbe {
  public:
    void on(const raster::VertexTransformed& e) { read(e); }
    void on(const raster::TriangleRejected& e) { read(e); }
    void on(const raster::TriangleClipped& e) {
        read(e.primitive), read(e.model), read(e.crossed);
        for (const auto& p : e.polygon) read(p);
    }
    void on(const raster::TriangleSnapped& e) {
        read(e.primitive), read(e.area2), read(e.facing), read(e.culled);
        for (const auto& corner : e.corners) read(corner);
    }
    void on(const raster::FragmentCovered& e) { read(e); }
    void on(const raster::DepthTested& e) { read(e); }
    void on(const raster::FragmentShaded& e) {
        read(e.x), read(e.y), read(e.z), read(e.inv_w), read(e.b0), read(e.b1), read(e.b2), read(e.color);
        for (const auto v : e.varying) read(v);
    }
    void on(const pipeline::EdgeCrossed& e) { read(e); }
    void on(const pipeline::PolygonClipped& e) { read(e); }

    std::uint64_t events = 0;

  private:
    // Copied where the compiler cannot see that nobody looks.
    template <class Value>
    void read(const Value& value) {
        static_assert(sizeof value <= sizeof seen_);
        std::memcpy(seen_, static_cast<const void*>(&value), sizeof value);
        asm volatile("" : : "g"(&seen_) : "memory");
        ++events;
    }
    unsigned char seen_[256];
};

}  // namespace relevo::real
