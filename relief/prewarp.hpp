// The pre-warp of a whole relief texture: settings and result. The work is in the headers of the
// resamplers.
#pragma once
#include <memory>
#include <vector>

#include "raster/pixel.hpp"
#include "relief/carried.hpp"
#include "relief/occlusion_order.hpp"
#include "relief/window.hpp"

namespace relevo::relief {

using pipeline::Vec2;

// How the warped texels, which no longer lie on a grid, become a picture (Clua 2004, 8.2).
enum class Resampler {
    Splat,           // each texel paints the one pixel it falls into: holes, no cost (splat.hpp)
    OneDimensional,  // rows, then columns; the displacement is interpolated linearly
    Asymmetric,      // rows, then columns; the row that a sample goes to is carried along
    Compensated,     // rows, then columns; the displacement is chosen so that its row is right
    Interleaved,     // each sample of a row goes on to its column at once: one pass
    Mesh,            // triangles between the texels, with a z-buffer: the reference
};

// What happens between two neighbours of very different depth: a skin is stretched from one to the
// other, or the surface is cut there.
enum class Jump { Skin, Cut };

// Between the texels k and k + 1 of a line: nothing, the half texels that stick out of them, or a
// connection.
enum class Gap : std::uint8_t { Empty, AfterFirst, BeforeSecond, Cut, Joined, Across };
inline bool sticks_out(Gap gap) { return gap < Gap::Joined; }

struct PrewarpSettings {
    Resampler resampler = Resampler::Interleaved;
    Jump jump = Jump::Skin;
    Scalar jump_depth = Scalar(0.1);  // world units along f; a greater difference of depth is a jump
    Painting painting = Painting::Right;
    bool depth_test = false;  // compare depths instead of trusting the order
    bool maps = false;        // fill the last three pictures of the result, too
    int threads = 1;          // of the resamplers of rows and columns; never changes a byte
};

enum class Kind : std::uint8_t {
    Empty,
    Sampled,       // a warped texel lies within half a texel, along both axes
    Filled,        // interpolated between neighbours that were drawn apart
    FilledAcross,  // the same across a jump of depth: a skin
};

// The warped picture on the source's plane. Where coverage is 0 the other channels mean nothing; so they
// may hold what a former warp left there.
struct Prewarped {
    Window window;  // pixel (0, 0) is texel (window.x0, window.y0) of the plane
    Image<LinearRgb> color;
    Image<Vec3> normal;   // interpolated: of any length
    Image<Scalar> depth;  // behind the plane along f, in world units, for either kind of source
    Image<std::uint8_t> coverage;
    // only with settings.maps
    Image<Vec2> source;  // (u, v) of the source that is seen here, in texels
    Image<Kind> kind;
    Image<std::uint16_t> writes;  // how often the pixel was painted (at most 65535)
};

// Of the blocks into which a relief texture is divided, in texels.
inline constexpr int block_width = 16, block_height = 8;

// A relief texture laid out for warping. It depends on no viewer: made once, it serves all warps. What a
// resampler reads together lies together; which neighbours hang together, and how the surface goes on
// where it ends (resample_line.hpp), is known beforehand.
struct PreparedRelief {
    ReliefCamera camera;
    Jump jump;
    Scalar jump_depth;
    std::vector<raster::Span> covered;  // of each row: from the first surface to behind the last
    Image<Scalar> parameter;            // q of the warp; 0 where there is no surface
    Image<Carried<false>> carried;
    Image<Gap> gap;          // (k + 1, y): between the texels k and k + 1 of row y
    Image<Scalar> growth_u;  // of the depth beyond the last texel of a run of the row
    // Of each block of texels, with the half texels that stick out of its rows; infinite where one is not
    // finite, least > largest where there is no surface.
    struct Parameters {
        Scalar least, largest;
    };
    Image<Parameters> parameters;
};
PreparedRelief prepare(const ReliefTexture& texture, Jump jump = Jump::Skin, Scalar jump_depth = Scalar(0.1));

// Memory and threads that the resamplers keep from one warp to the next; nothing to read. For one warp at a
// time.
class PrewarpMemory {
  public:
    PrewarpMemory();
    ~PrewarpMemory();
    PrewarpMemory(PrewarpMemory&&) noexcept;
    PrewarpMemory& operator=(PrewarpMemory&&) noexcept;
    struct Parts;
    Parts& parts() { return *parts_; }

  private:
    std::unique_ptr<Parts> parts_;
};

// The warped picture. `window` is at most max_picture_size a side; texels that go beyond it are cut off.
// The first form fills `result`, for one picture after another: it takes no new memory for it when it has the
// size already, nor, with a `memory`, for what lies between. (It goes by the jump rule of `relief`; the
// second prepares the texture by that of `settings`.)
void prewarp(const PreparedRelief& relief, const Warp& warp, const Window& window,
             const PrewarpSettings& settings, Prewarped& result, PrewarpMemory& memory);
void prewarp(const PreparedRelief& relief, const Warp& warp, const Window& window,
             const PrewarpSettings& settings, Prewarped& result);
Prewarped prewarp(const ReliefTexture& texture, const Warp& warp, const Window& window,
                  const PrewarpSettings& settings = {});

}  // namespace relevo::relief
