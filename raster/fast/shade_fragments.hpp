// Shading of small triangles: the fragments that coverage kept (fragments.hpp), N at a time.
//
//   group   its triangles are set up together, a lane each
//   seen    a fragment is, where the visibility buffer shows its triangle
//   lanes   each fragment takes what it needs from the lane of its triangle; then weights, light, texture and
//           output run once for N of them
#pragma once
#include "raster/fast/shade_setup.hpp"
#include "raster/fast/tile_at.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// A row of fragments, and the triangle of each.
struct FragmentsAt {
    Picked of_triangle;
    Ints place, e1, e2;
};
RELEVO_LANE FragmentsAt fragments_at(const Fragments& f, int k) {
    const Ints place = load(f.place + k);
    return {Picked(shift_right<16>(place) & Ints(lanes - 1)), place & Ints(0xffff), load(f.e1 + k),
            load(f.e2 + k)};
}

// The colours of fragments of one model; s: what their triangles carry.
template <class P>
RELEVO_LANE RgbOf<Floats> shade(const ModelState& model, const FragmentGroup& group, const LaneSetup<P>& s,
                                const FragmentsAt& f) {
    const Picked& of = f.of_triangle;
    const Ints area = of(load(group.area));
    const auto rw_of = [&](int c) RELEVO_INSIDE { return to_wide(of(load(group.rw[c]))); };
    const InterpolatorOf<Floats> rw{{}, {}, {}, rw_of(0), rw_of(1), rw_of(2)};
    const auto weights =
        perspective_weights<Floats>(rw, {to_wide(area - f.e1 - f.e2), to_wide(f.e1), to_wide(f.e2)});
    std::array<Floats, P::size> carried;
    for (std::size_t k = 0; k < P::size; ++k) {
        const VaryingPlane<1, Floats> plane = s.plane(k);
        const VaryingPlane<1, Floats> picked{{of(plane.a0[0])}, {of(plane.d1[0])}, {of(plane.d2[0])}};
        carried[k] = interpolate(picked, weights)[0];
    }
    LaneFace<P> face{};
    if constexpr (P::needs_face) {
        const auto& [amount, gloss] = s.face;
        face = {{of(amount.r), of(amount.g), of(amount.b)}, {of(gloss.r), of(gloss.g), of(gloss.b)}};
    }
    return P::template pixel<Floats>(model.setup.surface, face, carried.data());
}

// The colours of the fragments in `which` to their places.
RELEVO_LANE void write_fragments(const TileAt& at, const RgbOf<Floats>& c, Words packed, Ints place,
                                 std::uint32_t which) {
    const TileMemory& tile = at.scratch.tile;
    alignas(64) std::uint32_t colors[lanes], places[lanes];
    store(to_whole(packed), colors), store(place, places);
    if (which == all_bits) {
        for (int k = 0; k < lanes; ++k) tile.color[places[k]] = colors[k];
    } else {
        for (std::uint32_t rest = which; rest != 0; rest &= rest - 1) {
            const int k = std::countr_zero(rest);
            tile.color[places[k]] = colors[k];
        }
    }
    if (at.draw.linear == nullptr) return;
    alignas(64) float rgb[3][lanes];
    store(c.r, rgb[0]), store(c.g, rgb[1]), store(c.b, rgb[2]);
    for (std::uint32_t rest = which; rest != 0; rest &= rest - 1) {
        const int k = std::countr_zero(rest), place_of = static_cast<int>(places[k]);
        *linear_at(at, place_of / tile.stride, place_of % tile.stride) = {rgb[0][k], rgb[1][k], rgb[2][k]};
    }
}

// Shades what is seen of all kept fragments. Returns their number. covered: pixels.
template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] std::uint64_t shade_fragments(const TileAt& at, int covered) {
    const Fragments& fragments = at.scratch.fragments;
    const DrawState& draw = at.draw;
    std::uint64_t shaded = 0;
    // Without overlap, known by counting, every fragment is seen.
    const bool all_seen = !at.scratch.in_blocks && covered == fragments.count;
    for (int g = 0; g < fragments.group_count; ++g) {
        const FragmentGroup& group = fragments.groups[g];
        const Ints first_number(static_cast<std::int32_t>(group.first_number | kept_bit));
        std::uint32_t seen[most_walked + 1], any_seen = 0;
        for (int k = group.first, n = 0; k < group.last; k += lanes, ++n) {
            const int left = group.last - k;
            Bools shown = first_lanes(left < lanes ? left : lanes);
            if (!all_seen) {
                const Ints place = load(fragments.place + k);
                shown = shown && gather(at.scratch.tile.visible, place & Ints(0xffff)) ==
                                     first_number + shift_right<16>(place);
            }
            seen[n] = bits(shown);
            any_seen |= seen[n];
            shaded += static_cast<unsigned>(std::popcount(seen[n]));
        }
        if (any_seen == 0) continue;
        const int left = at.listed - static_cast<int>(group.first_number);
        const std::uint32_t triangles = bits(first_lanes(left < lanes ? left : lanes));
        for_each_model(
            draw, load(at.scratch.ids + group.first_number), triangles,
            [&](std::uint32_t number, std::uint32_t which, const LaneIds& ids) RELEVO_INSIDE {
                const ModelState& model = draw.models[number];
                with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
                    LaneSetup<P> s;
                    const Bools negative = from_bits(group.negative);
                    load_carried(draw, model, ids,
                                 {from_bits(group.one), from_bits(group.two),
                                  model.setup.mirrored ? negative : !negative},
                                 s);
                    for (int k = group.first, n = 0; k < group.last; k += lanes, ++n) {
                        const FragmentsAt f = fragments_at(fragments, k);
                        std::uint32_t mine = seen[n];
                        if (which != triangles)
                            mine &= bits(is_negative(f.of_triangle(select(from_bits(which), Ints(-1), Ints(0)))));
                        if (mine == 0) continue;
                        const RgbOf<Floats> c = shade<P>(model, group, s, f);
                        write_fragments(at, c, packed_rgba8<Floats>(c, draw.settings.output), f.place, mine);
                    }
                });
            });
    }
    return shaded;
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
