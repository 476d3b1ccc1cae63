// shade_tile() for one instruction set: compiled once for each, as SHADE_TILE.
#include "raster/fast/shade_tile.hpp"

namespace relevo::tests {

std::uint64_t SHADE_TILE(const raster::fast::DrawState& draw, const raster::fast::TileMemory& tile, int x0,
                         int y0, int width, int height) {
    return raster::fast::HWY_NAMESPACE::shade_tile(draw, tile, {x0, y0, width, height});
}

}  // namespace relevo::tests
