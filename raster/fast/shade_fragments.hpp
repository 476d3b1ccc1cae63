// Shading of small triangles: the fragments that coverage kept (fragments.hpp), N at a time.
//
//   group   its triangles are set up together, a lane each
//   seen    a fragment is, where the visibility buffer shows its triangle
//   lanes   each fragment takes what it needs from the lane of its triangle, and gets its weights; then N of
//           them wait for light (waiting_light.hpp)
#pragma once
#include "raster/fast/fragment_groups.hpp"
#include "raster/fast/shade_setup.hpp"
#include "raster/fast/waiting_light.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// A register of fragments, and the triangle of each.
struct FragmentsAt {
    Picked of_triangle;
    Ints e1, e2;
    Bools valid;
    const std::uint32_t* place;
};
// From the k-th on. Lanes past the end stand on corner 0 of the group's first triangle: there no number is
// extreme, as a rule, so that light need not go its slow ways.
RELEVO_LANE FragmentsAt fragments_at(const Fragments& f, int k, int end) {
    const Bools valid = first_lanes(end - k < lanes ? end - k : lanes);
    const auto value = [&](const auto* from) RELEVO_INSIDE { return select(valid, load(from + k), Ints(0)); };
    return {Picked(shift_right<16>(value(f.place)) & Ints(lanes - 1)), value(f.e1), value(f.e2), valid,
            f.place + k};
}

template <class P>
RELEVO_LANE PixelNumbers<P> pixel_numbers(const FragmentGroup& group, const LaneSetup<P>& s,
                                          const FragmentsAt& f) {
    const Picked& of = f.of_triangle;
    PixelNumbers<P> n;
    if constexpr (P::size > 0) {
        const Ints area = of(load(group.area));
        const auto rw_of = [&](int c) RELEVO_INSIDE { return to_wide(of(load(group.rw[c]))); };
        const InterpolatorOf<Floats> rw{{}, {}, {}, rw_of(0), rw_of(1), rw_of(2)};
        const auto weights =
            perspective_weights<Floats>(rw, {to_wide(area - f.e1 - f.e2), to_wide(f.e1), to_wide(f.e2)});
        for (std::size_t k = 0; k < P::size; ++k) {
            const VaryingPlane<1, Floats> plane = s.plane(k);
            const VaryingPlane<1, Floats> picked{{of(plane.a0[0])}, {of(plane.d1[0])}, {of(plane.d2[0])}};
            n.carried[k] = interpolate(picked, weights)[0];
        }
    }
    if constexpr (P::needs_face) {
        const auto& [amount, gloss] = s.face;
        n.face = {{of(amount.r), of(amount.g), of(amount.b)}, {of(gloss.r), of(gloss.g), of(gloss.b)}};
    }
    return n;
}

// Asks for what the corners carry, which stands all over memory.
RELEVO_LANE void prefetch_carried(const FragmentGroup& group) {
    if (group.model == nullptr || group.model->carried == nullptr) return;
    for (int k = 0; k < lanes; ++k)
        for (const int corner : {0, 2})  // two of three are all, in strips and grids
            hwy::Prefetch(group.model->carried + group.corner[corner][k] * std::size_t(group.model->stride));
}

// The pixels of the group's triangles `which`, which are of one model. `ids`: of these in their lanes.
template <template <bool> class Program, class P>
RELEVO_LANE void shade_group(const TileAt& at, WaitingPixels& waiting, const ModelState& model,
                             const FragmentGroup& group, const LaneIds& ids, std::uint32_t which, bool all) {
    const Fragments& fragments = at.scratch.fragments;
    std::array<Ints, 3> corner{load(group.corner[0]), load(group.corner[1]), load(group.corner[2])};
    if (group.model == nullptr) corner = vertices_of(model, ids);
    const Bools negative = from_bits(group.negative);
    LaneSetup<P> s;
    load_carried(at.draw, model, ids, corner,
                 {from_bits(group.one), from_bits(group.two), model.setup.mirrored ? negative : !negative},
                 s);

    const auto shown_by = [&](const FragmentsAt& f) RELEVO_INSIDE {
        if (all) return bits(f.valid);
        return bits(f.valid & is_negative(f.of_triangle(select(from_bits(which), Ints(-1), Ints(0)))));
    };
    for (int k = group.first; k < group.last; k += lanes) {
        const FragmentsAt f = fragments_at(fragments, k, group.last);
        light<Program, P>(at, waiting, model, pixel_numbers<P>(group, s, f),
                          FragmentsTo{f.place, shown_by(f)});
    }
}

// Shades what is seen of all kept fragments. Returns their number. covered: pixels that show one.
template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] std::uint64_t shade_fragments(const TileAt& at, int covered) {
    Fragments& fragments = at.scratch.fragments;
    // As many as pixels that show one: then every one is seen, for each pixel shows one alone.
    if (covered != fragments.kept) drop_hidden(at.scratch.tile, fragments);
    const FragmentGroup* groups = groups_of(fragments);
    WaitingPixels& waiting = nobody_waits(at.scratch);
    for (int g = 0; g < fragments.group_count; ++g) {
        const FragmentGroup& group = groups[g];
        if (g + 2 < fragments.group_count) prefetch_carried(groups[g + 2]);
        const int left = at.listed - static_cast<int>(group.first_number);
        const std::uint32_t all = bits(first_lanes(left < lanes ? left : lanes));
        for_each_model(at.draw, load(at.scratch.ids + group.first_number), all,
                       [&](std::uint32_t number, std::uint32_t which, const LaneIds& ids) RELEVO_INSIDE {
                           const ModelState& model = at.draw.models[number];
                           with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
                               shade_group<Program, P>(at, waiting, model, group, ids, which, which == all);
                           });
                       });
    }
    light_waiting<Program>(at, waiting);
    return static_cast<std::uint64_t>(fragments.kept);
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
