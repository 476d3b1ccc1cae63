// The same primitives drawn by cairo and by Anti-Grain Geometry, one path a primitive, as their manuals show.
#pragma once
#include <memory>
#include <span>
#include <string>

#include "tests/bench/plane_work.hpp"

namespace relevo::bench {

enum class CairoMode { None, Fast, Good, Best };

class Cairo {
  public:
    Cairo();
    ~Cairo();
    static std::string version();
    // Clears to black and draws all.
    void draw(Kind kind, CairoMode mode, std::span<const Primitive> all);
    Picture picture() const;

  private:
    struct Surface;
    std::unique_ptr<Surface> surface_;
};

enum class AggMode {
    Primitives,      // renderer_primitives: aliased, whole-number algorithms; no triangles
    ScanlineBin,     // the area rasterizer, every touched pixel set
    ScanlineSmooth,  // the area rasterizer with 256 levels
    OutlineSmooth,   // rasterizer_outline_aa: lines only
};

class Agg {
  public:
    Agg();
    ~Agg();
    static bool draws(Kind kind, AggMode mode);
    void draw(Kind kind, AggMode mode, std::span<const Primitive> all);
    Picture picture() const;

  private:
    struct Canvas;
    std::unique_ptr<Canvas> canvas_;
};

}  // namespace relevo::bench
