#include "samples/scene/statistics.hpp"

#include <fmt/format.h>

namespace relevo::scene {

std::vector<NamedCount> named_counts(const Statistics& s) {
    using raster::Rejection;
    return {
        {"triangles", "triangles in the scene", s.triangles},
        {"vertices", "vertices transformed", s.vertices},
        {"clipped", "triangles clipped at near, far or the guard band", s.clipped},
        {"rejected_non_finite", "dropped: a coordinate that is not finite",
         s.rejected_for(Rejection::NonFinite)},
        {"rejected_outside", "dropped: outside the view volume", s.rejected_for(Rejection::Outside)},
        {"rejected_zero_area", "dropped: no area", s.rejected_for(Rejection::ZeroArea)},
        {"rejected_culled", "dropped: face turned away", s.rejected_for(Rejection::Culled)},
        {"rejected_no_pixel", "dropped: holds no pixel centre", s.rejected_for(Rejection::NoPixel)},
        {"pieces", "triangles and pieces that reached the window", s.pieces},
        {"drawn", "triangles that cover a pixel", s.drawn},
        {"covered", "pixels covered", s.covered},
        {"depth_passed", "depth tests passed", s.depth_passed},
        {"depth_failed", "depth tests failed", s.depth_failed},
        {"shaded", "pixels shaded", s.shaded},
    };
}

std::vector<NamedCount> named_counts(const ShapeStatistics& s) {
    return {
        {"shapes", "shapes drawn", s.shapes},
        {"refused", "shapes left out: a coordinate too large", s.refused},
        {"cut", "areas cut at the window", s.cut},
        {"gone", "areas outside of the window", s.gone},
        {"spans", "runs of equal coverage", s.spans},
        {"painted", "pixels painted, once for each shape over them", s.painted},
        {"partly", "of these, pixels covered in part", s.partly},
        {"lit", "different pixels lit", s.lit},
        {"area", "pixels that all coverages add up to, rounded",
         static_cast<ShapeStatistics::Count>(s.coverage + 0.5)},
    };
}

std::string to_json(const std::vector<NamedCount>& counts) {
    std::string out = "{";
    for (const NamedCount& c : counts)
        out += fmt::format("{}\"{}\": {}", out.size() > 1 ? ", " : "", c.name, c.count);
    return out + "}";
}

}  // namespace relevo::scene
