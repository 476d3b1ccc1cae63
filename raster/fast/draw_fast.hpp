// The fast path: the same bytes as raster/draw.hpp, N lanes and several threads at a time.
//
//   1  transform   N vertices at a time: clip codes, window, what they carry         by blocks of vertices
//   2  bin         N triangles at a time: cull, clip, into the lists of their tiles  by chunks of triangles
//   3  tile        for each tile, in memory that stays in the caches: coverage and   by tiles
//                  depth of its triangles, and which of them is seen (a visibility buffer); then every
//                  visible pixel is shaded once: of few pixels' triangles fragment by fragment, of others
//                  in blocks. Or, where that is cheaper, triangles are painted at once; then out
//
// Nothing that a probe could see between the stages exists here: the textbook path is the one to watch.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "raster/fast/draw_state.hpp"
#include "raster/scene.hpp"

namespace relevo::raster::fast {

class Workers;

enum class InstructionSet { Sse4, Avx2, Avx512 };
std::string_view name(InstructionSet);  // "SSE4", "AVX2", "AVX-512"
// Those that this processor and this build have, the widest last; empty where the fast path cannot run.
std::span<const InstructionSet> instruction_sets();

// The memory that draws need, kept from one to the next; it never changes a pixel. One draw at a time.
class Workspace {
  public:
    Workspace();
    ~Workspace();
    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;
    std::size_t bytes() const;  // held now

    struct Memory;
    Memory& memory() { return *memory_; }

  private:
    std::unique_ptr<Memory> memory_;
};

struct Options {
    InstructionSet instruction_set = InstructionSet::Sse4;  // one of instruction_sets()
    int tile = 128;                                         // pixels a side: 32, 64 or 128
    Workers* workers = nullptr;                             // null: this thread alone
    Image<std::uint32_t>* visible = nullptr;  // if given: the primitive that each pixel shows, or `nothing`
};

// As raster::draw() without a probe: same preconditions, same bytes in frame.color, frame.depth and
// frame.linear, for any options. The scene has fewer than 2^26 triangles (max_triangles).
inline constexpr std::uint32_t max_triangles = max_chunks * max_chunk_triangles;
Counts draw(const Scene& scene, const Settings& settings, Frame& frame, Workspace& workspace,
            const Options& options);

}  // namespace relevo::raster::fast
