// The promise "same bytes": a scene drawn by the textbook path and by the fast one, and what differs first.
//
//     const Answer right = textbook(subject);
//     for (const Way& way : all_ways()) EXPECT_EQ(difference(right, fast_path(subject, way)), "");
#pragma once
#include <string>
#include <vector>

#include "raster/draw.hpp"
#include "raster/fast/draw_fast.hpp"
#include "raster/fast/workers.hpp"
#include "tests/support/drawing.hpp"

namespace relevo::tests::identity {

namespace fast = raster::fast;

// How the fast path is asked, and whether linear colour and the visible primitives are wanted, too.
struct Way {
    fast::InstructionSet set;
    int threads, tile;
    bool linear = true, visible = true;
};
std::string text(const Way& way);  // "AVX2, 7 threads, tile 32"

inline constexpr int thread_counts[] = {1, 2, 7}, tile_sizes[] = {32, 64, 128};
// Each instruction set of this machine, thread count and tile size; none where there is no fast path.
std::vector<Way> all_ways();
// Each instruction set once; threads, tile and what is wanted turn with the number: 36 numbers make all.
std::vector<Way> few_ways(std::size_t number);

struct Size {
    int width, height;
};
// Sizes that fit no tile.
inline constexpr Size odd_sizes[] = {{1, 1}, {3, 2}, {33, 65}, {127, 129}, {200, 31}, {641, 479}};

struct Answer {
    raster::Frame frame;
    raster::Image<std::uint32_t> visible;  // primitive of each pixel, or fast::nothing
    fast::Counts counts;
};
Answer textbook(const raster::Scene& scene, const raster::Settings& settings, Size size);
// In a workspace that all calls of a program share, or in the one that is given. The pictures hold rubbish
// before: every pixel must be written.
Answer fast_path(const raster::Scene& scene, const raster::Settings& settings, Size size, const Way& way);
Answer fast_path(const raster::Scene& scene, const raster::Settings& settings, Size size, const Way& way,
                 fast::Workspace& workspace);

// Empty if all bytes and counts are the same; else the first pixel of the first picture that differs, both
// values, and how many more there are. `loose`: in linear colour one not-a-number is as good as another.
enum class Linear { Exact, AnyNan };
std::string difference(const Answer& right, const Answer& got, Linear linear = Linear::Exact);

// The textbook's answer against each of the ways: empty, or the first difference and its way. `drawn` counts
// pixels that were not background, so that a test can see that it saw something.
std::string first_difference(const raster::Scene& scene, const raster::Settings& settings, Size size,
                             const std::vector<Way>& ways, std::uint64_t* drawn = nullptr,
                             Linear linear = Linear::Exact);

}  // namespace relevo::tests::identity
