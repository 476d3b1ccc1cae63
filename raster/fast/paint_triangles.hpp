// Painting: untextured pixels of Gouraud's and of flat shading are coloured as soon as their depth lets them
// pass, triangle after triangle. Where little is painted over, that costs less than to show numbers first and
// to find out later which pixel shows which: no visibility buffer, no registers with pixels of several
// triangles.
//
//   strips    of 8 columns (SSE4: 4), as many rows at a time as fill a register: depth, seen lanes, weights
//   colours   of all the triangle's registers, where they are seen; in a loop of its own: it needs weights
//
// Flat triangles have one colour, which takes the place of their number (cover_strips.hpp).
//
// Painting ends with the first small triangles, whose fragments are kept (fragments.hpp), and Gouraud's when
// the pixels of all triangles so far would cover the tile twice. From there on numbers are shown:
//
//   visible   `painted` where anything is painted: no number that follows stands before it
#pragma once
#include "raster/fast/block_weights.hpp"
#include "raster/fast/cover_strips.hpp"
#include "raster/fast/tile_at.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// As if it were a fragment of the tile's first triangle: nothing that follows is before it at equal depth.
// Where anything is painted, that one has no fragments: with them, painting would have ended.
inline constexpr std::uint32_t painted = kept_bit;

// The registers of one triangle's strips.
struct PaintedStrips {
    static constexpr int columns = lanes < 8 ? lanes : 8, rows = rows_of_lanes<columns>;
    static constexpr int room = max_tile * max_tile / lanes;
    struct Strip {
        int at, registers;  // its first pixel in the tile's memory
    };
    alignas(64) float b1[room][lanes], b2[room][lanes];
    std::uint16_t seen[room];
    Strip strips[2 * max_tile / columns];  // of large triangles' parts two stand below each other
};
static_assert(sizeof(PaintedStrips) <= painting_bytes);

// Pixels that are seen wait for their colours.
struct KeepWeights {
    static constexpr int columns = PaintedStrips::columns;
    PaintedStrips& memory;
    Interpolator corners;
    double area, down0 = 0;
    Doubles e0{};
    int registers = 0, strips = 0;

    RELEVO_LANE KeepWeights(PaintedStrips& to, const SetupGroup& group, OneColumn of)
        : memory(to),
          corners{0, 0, 0, of(group.rw[0]), of(group.rw[1]), of(group.rw[2])},
          area(of(group.edges[6])) {}
    RELEVO_LANE void begin_strip(int at, int count, const Doubles& e1, const Doubles& e2, double down) {
        memory.strips[strips++] = {at, count};
        e0 = area - e1 - e2, down0 = down;
    }
    RELEVO_LANE void show(Bools seen, const Doubles& e1, const Doubles& e2) {
        const auto weights = perspective_weights<Floats>(corners, EdgeValuesOf<Floats>{e0, e1, e2});
        store(weights.b1, memory.b1[registers]), store(weights.b2, memory.b2[registers]);
        memory.seen[registers++] = static_cast<std::uint16_t>(bits(seen));
        e0 = e0 - down0;
    }
};

// The colours that wait.
template <class P>
RELEVO_LANE void color_strips(const TileAt& at, const KeepWeights& kept, const SetupGroup& group,
                              OneColumn of) {
    const PaintedStrips& from = kept.memory;
    const CarriedPlanes<P> planes = carried_planes<P>(group, of);
    const Surface& surface = at.draw.models[std::size_t(of(group.model))].setup.surface;
    const Output output = at.draw.settings.output;
    const int stride = at.scratch.tile.stride;
    with_light_of(of(group.displayable), [&]<class Range>(Range) RELEVO_INSIDE {
        int n = 0;
        for (int strip = 0; strip < kept.strips; ++strip) {
            std::uint32_t* to = at.scratch.tile.color + from.strips[strip].at;
            const int end = n + from.strips[strip].registers;
            for (; n < end; ++n, to += PaintedStrips::rows * stride) {
                const RgbOf<Floats> c =
                    color_at<P>(surface, planes, {load(from.b1[n]), load(from.b2[n]), {}});
                store_rows_where<PaintedStrips::columns>(
                    from_bits(from.seen[n]), to_whole(packed_rgba8<Floats, Range::value>(c, output)), to,
                    stride);
            }
        }
    });
}

// Not begun where the triangles are so many that small ones must be among them.
RELEVO_LANE bool is_worth_painting(const TileBox& box, std::size_t triangles) {
    return 64 * triangles <= std::size_t(box.width) * std::size_t(box.height);
}

inline constexpr float most_painted = 2;  // tiles

// Paints a tile's triangles until stop().
template <template <bool> class Program>
class Painter {
  public:
    using P = Program<false>;
    RELEVO_LANE explicit Painter(const TileScratch& scratch)
        : kept_(scratch.kept), memory_(*reinterpret_cast<PaintedStrips*>(scratch.painting)) {}
    RELEVO_LANE bool paints() const { return paints_; }

    // Triangle k of the set-up; `number` in the tile's list.
    RELEVO_LANE void paint(const TileAt& at, const StoredSetup& s, int k, bool small, std::uint32_t number,
                           const Nearness& nearness) {
        const TileMemory& tile = at.scratch.tile;
        const KeptSetup triangle = find_setup<Program>(at, kept_, number);
        const SetupGroup& group = *triangle.group;
        const OneColumn of{triangle.column};
        if constexpr (P::size == 0) {
            ShowNumber show{Ints(of(group.packed)), tile.color, tile.stride};
            cover_triangle(s, k, small, show, nearness, tile);
        } else {
            KeepWeights show(memory_, group, of);
            cover_triangle(s, k, small, show, nearness, tile);
            color_strips<P>(at, show, group, of);
        }
        anything_ = true;
    }
    // Triangles come next that cover so many pixels of the tile, or fewer.
    RELEVO_LANE void expect(const TileAt& at, Floats pixels) {
        if constexpr (P::size == 0) return;
        pixels_ += sum(pixels);
        if (pixels_ > most_painted * static_cast<float>(at.box.width * at.box.height)) stop(at);
    }
    // From here on numbers are shown.
    RELEVO_LANE void stop(const TileAt& at) {
        if (!paints_) return;
        paints_ = false, at.scratch.painted = anything_;
        const TileMemory& tile = at.scratch.tile;
        const Floats cleared = cleared_nearness(at.draw);
        const Ints none(static_cast<std::int32_t>(nothing)), some(static_cast<std::int32_t>(painted));
        for (int k = 0, end = at.rows_of_blocks() * tile.stride; k < end; k += lanes)
            store(select(load(tile.nearness + k) > cleared, some, none), tile.visible + k);
    }

  private:
    KeptSetups kept_;
    PaintedStrips& memory_;
    bool paints_ = true, anything_ = false;
    float pixels_ = 0;
};
// Numbers are shown from the beginning.
struct NoPainter {
    RELEVO_LANE void expect(const TileAt&, Floats) {}
    RELEVO_LANE bool paints() const { return false; }
    RELEVO_LANE void stop(const TileAt&) {}
};

}  // namespace relevo::raster::fast::HWY_NAMESPACE
