// shade_tile() for one instruction set: compiled once for each, as SHADE_TILE.
#include "raster/fast/shade_tile.hpp"

namespace relevo::tests {

std::uint64_t SHADE_TILE(const raster::fast::DrawState& draw, raster::fast::TileScratch& scratch, int listed,
                         int tile) {
    namespace stage = raster::fast::HWY_NAMESPACE;
    return stage::shade_tile(draw, scratch, listed, stage::tile_box(draw, tile));
}

}  // namespace relevo::tests
