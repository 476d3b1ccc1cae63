// The machine once more in its plainest form, from clip space on, with the mistakes that people make in it.
//
// Without a mistake it must give the machine's own numbers, which is a test: then a mistake changes a golden
// for its own sake and not for the plainness of this code.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/cull.hpp"
#include "pipeline/viewport.hpp"
#include "raster/image.hpp"
#include "tests/golden/subject.hpp"

namespace relevo::golden {

struct Rules {
    enum class Clipping { Right, NoNear, NoFar, NoGuardBand, InFloat, FromFirstCorner, NotPinned } clipping{};
    enum class Snapping { Nearest, Down, HalfUp, Sixteenths, WholePixels } snapping{};
    enum class Fill { TopLeft, Open, Closed, BottomRight } fill{};
    enum class Depth { Nearer, LaterWinsTies, Ignored } depth{};
    enum class Weights { Right, Affine, Permuted, DepthCorrected } weights{};
    int sample = 128;  // where in a pixel it is sampled, in 1/256
    friend constexpr bool operator==(const Rules&, const Rules&) = default;
};

struct PlainTriangle {
    std::uint32_t primitive, model;
    const pipeline::Vertex* vertex[3];
    pipeline::SnappedCorner corner[3];
    std::int64_t area2;
    pipeline::Facing facing;
    bool culled;
};
// Triangles that cross no clip plane; those without an area are left out.
std::vector<PlainTriangle> plain_triangles(const Subject& subject, const Rules& rules);

struct PlainPixel {
    std::uint32_t last = 0, count = 0;  // coverage: the number + 1 of the last triangle there, how many
    pipeline::Scalar z = 0;             // of the visible one
    pipeline::Scalar b[3] = {0, 0, 0}, inv_w = 0, uv[2] = {0, 0};
    std::uint32_t model = 0;
    bool drawn = false;
};
raster::Image<PlainPixel> plain_pixels(const Subject& subject, const Rules& rules);

// What is left of each triangle that crosses a plane, as text (stages.hpp).
std::string plain_clipped(const Subject& subject, const Rules& rules);

// The lines of the texts: the same for the machine and for this one.
std::string clipped_line(std::uint32_t primitive, std::span<const pipeline::HPoint<pipeline::Clip>> polygon);
std::string window_line(std::uint32_t primitive, const pipeline::SnappedCorner (&corners)[3],
                        std::int64_t area2, pipeline::Facing facing, bool culled);

}  // namespace relevo::golden
