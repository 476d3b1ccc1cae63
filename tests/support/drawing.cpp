#include "tests/support/drawing.hpp"

#include "raster/draw.hpp"

namespace relevo::tests {

void draw_watched(const raster::Scene& scene, const raster::Settings& settings, raster::Frame& frame,
                  Watch& watch) {
    raster::draw(scene, settings, frame, watch);
}

}  // namespace relevo::tests
