#include "raster/draw.hpp"

namespace relevo::raster {

template void draw<const NoProbe>(const Scene&, const Settings&, Frame&, const NoProbe&&);

}  // namespace relevo::raster
