#include "raster/fast/stages_of_target.hpp"

namespace relevo::raster::fast {

const Stages stages_avx2{HWY_NAMESPACE::transform, HWY_NAMESPACE::bin, HWY_NAMESPACE::draw_tile};

}  // namespace relevo::raster::fast
