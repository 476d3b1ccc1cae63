// The set-ups of a tile's triangles that shading and painting keep: N triangles that follow each other in the
// tile's list are set up together when the first of them is seen, or painted.
//
//   groups[g % slots]   of the triangles N g .. N g + N - 1: a row for each number, a column a triangle
//   tag[g % slots]      g: whose numbers stand there
//
// Edge values are planes over the pixels of the tile, exact (below 2^50):
//   E_k (x, y) = e_k + x across_k + y down_k     k = 1, 2          E_0 = area - E_1 - E_2
// Where a triangle is seen they lie between 0 and its area. So int32 is enough for small triangles, of an
// area below 2^31 (in 1/256 pixel: 16,384 pixels), whatever overflows on the way.
#pragma once
#include <type_traits>

#include "raster/fast/shade_setup.hpp"
#include "raster/fast/stages.hpp"
#include "raster/fast/tile_at.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

struct SetupGroup {
    alignas(64) double edges[7][lanes];  // e1, across1, down1, e2, across2, down2, area
    std::int32_t small_edges[7][lanes];  // the same, mod 2^32
    float rw[3][lanes];
    float plane[max_carried][3][lanes];  // a0, d1, d2 of each number that is carried
    float face[6][lanes];                // amount, gloss
    float color[3][lanes];               // where nothing is carried: of every pixel
    std::int32_t packed[lanes], model[lanes];
    std::int32_t displayable[lanes];  // whether no clamp is needed (output.hpp)
    bool small;                       // all triangles are
};

struct KeptSetups {
    static constexpr std::uint32_t slots = kept_triangles / lanes;
    SetupGroup* groups;
    std::uint32_t tag[slots];

    RELEVO_LANE explicit KeptSetups(std::byte* memory) : groups(reinterpret_cast<SetupGroup*>(memory)) {
        static_assert(slots * sizeof(SetupGroup) <= kept_bytes);
        for (std::uint32_t k = 0; k < slots; k += lanes) store(Ints(-1), tag + k);
    }
    RELEVO_LANE const SetupGroup& group(std::uint32_t number) const { return groups[number % slots]; }
    RELEVO_LANE bool holds(std::uint32_t group) const { return tag[group % slots] == group; }
};

// A triangle in its group.
struct KeptSetup {
    const SetupGroup* group;
    std::uint32_t column;
};

// The lanes of `which` of a group, triangles of one model.
template <class Program>
RELEVO_LANE void keep(const DrawState& draw, std::uint32_t model, const LaneSetup<Program>& s, int x0, int y0,
                      std::uint32_t which, SetupGroup& to) {
    const Bools mask = from_bits(which);
    const auto put = [&](Floats value, float* row)
                         RELEVO_INSIDE { store(select(mask, value, load(row)), row); };
    const auto put_words = [&](Ints value, auto* row)
                               RELEVO_INSIDE { store(select(mask, value, load(row)), row); };
    const auto put_wide = [&](Doubles value, double* row)
                              RELEVO_INSIDE { store(select(mask, value, load(row)), row); };
    put_words(Ints(static_cast<std::int32_t>(model)), to.model);
    if constexpr (Program::size == 0) {
        const RgbOf<Floats> c =
            Program::template pixel<Floats>(draw.models[model].setup.surface, s.face, nullptr);
        put(c.r, to.color[0]), put(c.g, to.color[1]), put(c.b, to.color[2]);
        put_words(to_whole(packed_rgba8(c, draw.settings.output)), to.packed);
    } else {
        const EdgeValuesOf<Floats> e = edge_values(s, Ints(x0), Ints(y0));
        const Doubles edges[7] = {e.e1,  s.dy2 * Doubles(256.0),  s.dx2 * Doubles(-256.0),
                                  e.e2,  s.dy1 * Doubles(-256.0), s.dx1 * Doubles(256.0),
                                  s.area};
        for (int k = 0; k < 7; ++k) {
            put_wide(edges[k], to.edges[k]);
            put_words(low_words(edges[k]), to.small_edges[k]);
        }
        to.small &= !any(!(s.area < Doubles(0x1p31)) && mask);
        put(s.rw0, to.rw[0]), put(s.rw1, to.rw[1]), put(s.rw2, to.rw[2]);
        for (std::size_t j = 0; j < Program::size; ++j) {
            const VaryingPlane<1, Floats> plane = s.plane(j);
            put(plane.a0[0], to.plane[j][0]), put(plane.d1[0], to.plane[j][1]);
            put(plane.d2[0], to.plane[j][2]);
        }
        if constexpr (std::is_same_v<Program, Gouraud<false>>) {
            Bools within = first_lanes(lanes);
            for (int c = 0; c < 3; ++c)
                for (std::size_t j = 0; j < Program::size; ++j)
                    within = within && s.carried[c][j] >= Floats(0.f) && s.carried[c][j] <= Floats(1.f);
            put_words(select(within, Ints(1), Ints(0)), to.displayable);
        }
        if constexpr (Program::needs_face) {
            put(s.face.amount.r, to.face[0]), put(s.face.amount.g, to.face[1]);
            put(s.face.amount.b, to.face[2]);
            put(s.face.gloss.r, to.face[3]), put(s.face.gloss.g, to.face[4]), put(s.face.gloss.b, to.face[5]);
        }
    }
}

template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] void prepare(const TileAt& at, std::uint32_t group, KeptSetups& kept) {
    const std::uint32_t first = group * lanes, slot = group % KeptSetups::slots;
    const int left = at.listed - static_cast<int>(first);
    kept.groups[slot].small = true;  // until one is not
    for_each_model(at.draw, load(at.scratch.ids + first), bits(first_lanes(left < lanes ? left : lanes)),
                   [&](std::uint32_t number, std::uint32_t which, const LaneIds& ids) RELEVO_INSIDE {
                       const ModelState& model = at.draw.models[number];
                       with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
                           keep(at.draw, number, set_up<P>(at.draw, model, ids), at.box.x0, at.box.y0, which,
                                kept.groups[slot]);
                       });
                   });
    kept.tag[slot] = group;
}
template <template <bool> class Program>
RELEVO_LANE KeptSetup find_setup(const TileAt& at, KeptSetups& kept, std::uint32_t number) {
    const std::uint32_t group = number / lanes;
    if (!kept.holds(group)) prepare<Program>(at, group, kept);
    return {&kept.group(group), number % lanes};
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
