// Shading: every pixel of a tile that shows a triangle gets its colour, once.
//
//   visible   id id id id | id id id id | ...      N pixels of a row: a group
//
// A group is one of four kinds, by the runs of equal ids in it:
//   none      background
//   uniform   one triangle: its stored set-up serves all lanes
//   few       up to `most_runs` runs: each triangle's edge values and carried numbers go to its own lanes,
//   then
//             weights, light, texture and output run once for the whole group
//   many      (small triangles) every lane sets up its own triangle
// Set-ups are stored for a band of rows at a time, N triangles together; what finds no room is drawn as many.
#pragma once
#include "raster/fast/cover_tile.hpp"
#include "raster/fast/shade_setup.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

inline constexpr int most_runs = 5, band_rows = 8, max_tile_groups = 128 / lanes;

// The set-ups that are kept, of one tile.
//
//   slots[hash of id] -> number -> ids[number], setups[number]          taken in turn, the oldest goes
struct KeptSetups {
    static constexpr std::uint32_t capacity = 256, slot_bits = 10;
    std::uint32_t ids[capacity];
    std::uint16_t slots[1 << slot_bits] = {};
    std::uint32_t next = 0;
    KeptSetup setups[capacity];

    RELEVO_LANE KeptSetups() {
        for (std::uint32_t& id : ids) id = nothing;
    }
    RELEVO_LANE static std::uint32_t slot(std::uint32_t id) {
        return (id ^ id >> slot_bits) & ((1u << slot_bits) - 1);
    }
    // Null if it is not there.
    RELEVO_LANE const KeptSetup* find(std::uint32_t id) const {
        const std::uint32_t n = slots[slot(id)];
        return ids[n] == id ? &setups[n] : nullptr;
    }
    RELEVO_LANE KeptSetup* add(std::uint32_t id) {
        const std::uint32_t n = next;
        next = (next + 1) % capacity;
        slots[slot(id)] = static_cast<std::uint16_t>(n);
        ids[n] = id;
        return &setups[n];
    }
};

// Which lanes of a group show a triangle, and in which of them a run of equal ids ends.
struct GroupRuns {
    std::uint32_t covered, ends;
};

struct Colors {
    Words packed;
    RgbOf<Floats> linear;
};
RELEVO_LANE Colors select(Bools mask, const Colors& yes, const Colors& no) {
    return {to_word(select(mask, to_whole(yes.packed), to_whole(no.packed))),
            pipeline::select(mask, yes.linear, no.linear)};
}
RELEVO_LANE Colors background_colors(const DrawState& draw) {
    return {Words(std::bit_cast<std::uint32_t>(draw.background8)), draw.background};
}
RELEVO_LANE Bools from_bits(std::uint32_t which) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(which), static_cast<std::uint8_t>(which >> 8)};
    return {hn::LoadMaskBits(TagF(), bytes)};
}

// Calls visit(number of the model, its lanes, ids with one of the model's in every lane) for each model that
// the lanes of `which` show.
template <class Visit>
RELEVO_LANE void for_each_model(const DrawState& draw, Ints id, std::uint32_t which, Visit&& visit) {
    alignas(64) std::uint32_t ids[lanes], primitives[lanes];
    store(id, ids);
    const bool pieces = (bits(is_negative(id)) & which) != 0;
    if (pieces) {
        for (int k = 0; k < lanes; ++k) primitives[k] = which >> k & 1 ? primitive_of(draw, ids[k]) : 0;
    } else {
        store(id, primitives);
    }
    const Ints primitive = load(primitives);
    while (which != 0) {
        const int first = std::countr_zero(which);
        const std::uint32_t number = draw.models.size() == 1 ? 0 : model_of(draw, primitives[first]);
        const ModelState& model = draw.models[number];
        const auto whole = [](std::uint32_t x) { return Ints(static_cast<std::int32_t>(x)); };
        const Bools before = primitive < whole(model.first_primitive),
                    inside = primitive < whole(model.first_primitive + model.triangles) && !before;
        const Bools mine = inside && from_bits(which);
        visit(number, bits(mine),
              LaneIds{select(mine, id, whole(ids[first])), select(mine, primitive, whole(primitives[first])),
                      pieces});
        which &= ~bits(mine);
    }
}

// Calls use(Program{}) with the program of the model: textured or not.
template <template <bool> class Program, class Use>
RELEVO_LANE void with_texture(const ModelState& model, Use&& use) {
    model.textured ? use(Program<true>{}) : use(Program<false>{});
}

template <class Program>
RELEVO_LANE Colors shade_lanes(const DrawState& draw, const ModelState& model, const LaneFace<Program>& face,
                               const std::array<Floats, Program::size>& carried) {
    const RgbOf<Floats> c = Program::template pixel<Floats>(model.setup.surface, face, carried.data());
    return {packed_rgba8(c, draw.settings.output), c};
}

// ------------------------------------------------------------------------------------------------ many
template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] void shade_many(const DrawState& draw, const std::uint32_t* visible,
                                                std::uint32_t covered, int x, int y, Colors& colors) {
    for_each_model(
        draw, load(visible), covered, [&](std::uint32_t number, std::uint32_t which, const LaneIds& ids) {
            const ModelState& model = draw.models[number];
            with_texture<Program>(model, [&]<class P>(P) {
                const LaneSetup<P> s = set_up<P>(draw, model, ids);
                std::array<Floats, P::size> carried;
                if constexpr (P::size > 0) {
                    const auto e = edge_values(s, Ints(x) + lane_numbers(), Ints(y));
                    const InterpolatorOf<Floats> rw{
                        {}, {}, {}, to_wide(s.rw0), to_wide(s.rw1), to_wide(s.rw2)};
                    carried = interpolate(s.plane, perspective_weights<Floats>(rw, e));
                }
                colors = select(from_bits(which), shade_lanes<P>(draw, model, s.face, carried), colors);
            });
        });
}

// ------------------------------------------------------------------------------------------------ stored
// Prepares the set-ups of N triangles.
template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] void prepare(const DrawState& draw, const std::uint32_t (&ids)[lanes],
                                             std::uint32_t which, KeptSetup* const (&to)[lanes]) {
    for_each_model(draw, load(ids), which,
                   [&](std::uint32_t number, std::uint32_t mine, const LaneIds& lane_ids) {
                       const ModelState& model = draw.models[number];
                       with_texture<Program>(model, [&]<class P>(P) {
                           store_setups(draw, number, set_up<P>(draw, model, lane_ids), mine, to);
                       });
                   });
}

// Finds the runs of a band's groups, and prepares the triangles of those that are uniform or few.
template <template <bool> class Program>
RELEVO_LANE void prepare_band(const DrawState& draw, const TileMemory& tile, const TileBox& box,
                              int first_row, int last_row, KeptSetups& stored, GroupRuns* groups) {
    alignas(64) std::uint32_t ids[lanes];
    KeptSetup* to[lanes];
    int waiting = 0;
    for (int row = first_row; row < last_row; ++row) {
        const std::uint32_t* visible = tile.visible + row * tile.stride;
        for (int x = 0; x < box.width; x += lanes, ++groups) {
            const Ints id = load(visible + x), next = load(visible + x + 1);
            const int count_here = box.width - x < lanes ? box.width - x : lanes;
            const std::uint32_t last = 1u << (count_here - 1);
            groups->covered = ~bits(id == Ints(-1)) & (2 * last - 1);
            groups->ends = (~bits(id == next) | last) & groups->covered;
            if (std::popcount(groups->ends) > most_runs) continue;
            for (std::uint32_t rest = groups->ends; rest != 0; rest &= rest - 1) {
                const std::uint32_t new_id = visible[x + std::countr_zero(rest)];
                if (stored.find(new_id) != nullptr) continue;
                ids[waiting] = new_id;
                to[waiting++] = stored.add(new_id);
                if (waiting < lanes) continue;
                prepare<Program>(draw, ids, (2u << (lanes - 1)) - 1, to);
                waiting = 0;
            }
        }
    }
    if (waiting > 0) prepare<Program>(draw, ids, (1u << waiting) - 1, to);
}

RELEVO_LANE EdgeValuesOf<Floats> edge_values(const KeptSetup& t, Doubles x, double y) {
    const auto value = [&](int k) { return Doubles(t.e[k] + y * t.down[k]) + x * Doubles(t.across[k]); };
    return {value(0), value(1), value(2)};
}

template <class Program>
RELEVO_LANE std::array<Floats, Program::size> carried_at(const KeptSetup& t,
                                                         const PerspectiveWeightsOf<Floats>& weights) {
    VaryingPlane<Program::size> plane;
    for (std::size_t j = 0; j < Program::size; ++j)
        plane.a0[j] = t.a0[j], plane.d1[j] = t.d1[j], plane.d2[j] = t.d2[j];
    return interpolate(plane, weights);
}

// All lanes show one triangle.
template <class Program>
RELEVO_LANE Colors shade_uniform(const DrawState& draw, const KeptSetup& t, Doubles x, double y) {
    if constexpr (Program::size == 0) {
        return {Words(t.packed), t.color};
    } else {
        const Interpolator rw{0, 0, 0, t.rw[0], t.rw[1], t.rw[2]};
        const auto weights = perspective_weights<Floats>(rw, edge_values(t, x, y));
        LaneFace<Program> face{};
        if constexpr (Program::needs_face) face = {t.face.amount, t.face.gloss};
        return shade_lanes<Program>(draw, draw.models[t.model], face, carried_at<Program>(t, weights));
    }
}

// A truth a lane, as wide as the lanes of Doubles.
struct WideMask {
    hn::Mask<TagD> low, high;
};
RELEVO_LANE WideMask wide_mask(Bools mask) {
    const auto whole = hn::VecFromMask(TagI(), int_mask(mask));
    const auto widen = [](auto half) {
        return hn::MaskFromVec(hn::BitCast(TagD(), hn::PromoteTo(hn::ScalableTag<std::int64_t>(), half)));
    };
    return {widen(hn::LowerHalf(whole)), widen(hn::UpperHalf(HalfI(), whole))};
}
RELEVO_LANE Doubles select(const WideMask& mask, Doubles yes, Doubles no) {
    return {hn::IfThenElse(mask.low, yes.low, no.low), hn::IfThenElse(mask.high, yes.high, no.high)};
}

struct Few {
    const KeptSetup* setup[most_runs];
    Bools lanes_of[most_runs];
    int count = 0;
};

// The lanes show the triangles of `few`, all of one model.
template <class Program>
RELEVO_LANE Colors shade_few(const DrawState& draw, const Few& few, Doubles x, double y) {
    const KeptSetup& first = *few.setup[0];
    if constexpr (Program::size == 0) {
        Colors colors{Words(first.packed), first.color};
        for (int n = 1; n < few.count; ++n)
            colors = select(few.lanes_of[n], {Words(few.setup[n]->packed), few.setup[n]->color}, colors);
        return colors;
    } else {
        EdgeValuesOf<Floats> e = edge_values(first, x, y);
        InterpolatorOf<Floats> rw{{}, {}, {}, first.rw[0], first.rw[1], first.rw[2]};
        for (int n = 1; n < few.count; ++n) {
            const KeptSetup& t = *few.setup[n];
            const EdgeValuesOf<Floats> other = edge_values(t, x, y);
            const WideMask mask = wide_mask(few.lanes_of[n]);
            e = {select(mask, other.e0, e.e0), select(mask, other.e1, e.e1), select(mask, other.e2, e.e2)};
            rw.rw0 = select(mask, Doubles(t.rw[0]), rw.rw0);
            rw.rw1 = select(mask, Doubles(t.rw[1]), rw.rw1);
            rw.rw2 = select(mask, Doubles(t.rw[2]), rw.rw2);
        }
        const auto weights = perspective_weights<Floats>(rw, e);
        std::array<Floats, Program::size> carried = carried_at<Program>(first, weights);
        LaneFace<Program> face{};
        if constexpr (Program::needs_face) face = {first.face.amount, first.face.gloss};
        for (int n = 1; n < few.count; ++n) {
            const auto other = carried_at<Program>(*few.setup[n], weights);
            for (std::size_t j = 0; j < Program::size; ++j)
                carried[j] = select(few.lanes_of[n], other[j], carried[j]);
            if constexpr (Program::needs_face) {
                const pipeline::Reflection& f = few.setup[n]->face;
                face.amount = pipeline::select<Floats>(few.lanes_of[n], f.amount, face.amount);
                face.gloss = pipeline::select<Floats>(few.lanes_of[n], f.gloss, face.gloss);
            }
        }
        return shade_lanes<Program>(draw, draw.models[first.model], face, carried);
    }
}

// False when a set-up is missing or the triangles are of several models.
RELEVO_LANE bool find_few(const KeptSetups& stored, const std::uint32_t* visible, Ints ids,
                          std::uint32_t ends, Few& few) {
    while (ends != 0) {
        const std::uint32_t id = visible[std::countr_zero(ends)];
        const KeptSetup* t = stored.find(id);
        if (t == nullptr || (few.count > 0 && t->model != few.setup[0]->model)) return false;
        const Bools mine = ids == Ints(static_cast<std::int32_t>(id));
        few.setup[few.count] = t;
        few.lanes_of[few.count++] = mine;
        ends &= ~bits(mine);
    }
    return true;
}

// ------------------------------------------------------------------------------------------------ a tile
RELEVO_LANE void store_linear(const RgbOf<Floats>& c, int n, pipeline::LinearRgb* to) {
    alignas(64) float rgb[3 * lanes];
    hn::StoreInterleaved3(c.r.v, c.g.v, c.b.v, TagF(), rgb);
    for (int k = 0; k < n; ++k) to[k] = {rgb[3 * k], rgb[3 * k + 1], rgb[3 * k + 2]};
}

template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] std::uint64_t shade_rows(const DrawState& draw, const TileMemory& tile,
                                                         const TileBox& box) {
    KeptSetups stored;
    GroupRuns groups[band_rows * max_tile_groups];
    const Colors background = background_colors(draw);
    std::uint64_t shaded = 0;
    for (int first_row = 0; first_row < box.height; first_row += band_rows) {
        const int last_row = first_row + band_rows < box.height ? first_row + band_rows : box.height;
        prepare_band<Program>(draw, tile, box, first_row, last_row, stored, groups);
        const GroupRuns* group = groups;
        for (int row = first_row; row < last_row; ++row) {
            const std::uint32_t* visible = tile.visible + row * tile.stride;
            const int y = box.y0 + row;
            for (int column = 0; column < box.width; column += lanes, ++group) {
                const int x = box.x0 + column;
                Colors colors = background;
                if (group->covered != 0) {
                    shaded += static_cast<unsigned>(std::popcount(group->covered));
                    const Doubles centres = to_wide(lane_numbers() + Ints(x));
                    const KeptSetup* one = nullptr;
                    Few few;
                    if (std::has_single_bit(group->ends) &&
                        (one = stored.find(visible[column + std::countr_zero(group->ends)])) != nullptr) {
                        with_texture<Program>(draw.models[one->model], [&]<class P>(P) {
                            colors = shade_uniform<P>(draw, *one, centres, y);
                        });
                        if (group->covered != (2u << (lanes - 1)) - 1)
                            colors = select(from_bits(group->covered), colors, background);
                    } else if (std::popcount(group->ends) <= most_runs &&
                               find_few(stored, visible + column, load(visible + column), group->ends, few)) {
                        with_texture<Program>(draw.models[few.setup[0]->model], [&]<class P>(P) {
                            colors = shade_few<P>(draw, few, centres, y);
                        });
                        colors = select(from_bits(group->covered), colors, background);
                    } else {
                        shade_many<Program>(draw, visible + column, group->covered, x, y, colors);
                    }
                }
                store(to_whole(colors.packed), tile.color + row * tile.stride + column);
                if (draw.linear != nullptr)
                    store_linear(colors.linear, box.width - column < lanes ? box.width - column : lanes,
                                 draw.linear + std::size_t(y) * std::size_t(draw.viewport.width) + x);
            }
        }
    }
    return shaded;
}

// Fills tile.color of the box, and the picture of linear colour if it was asked for. Returns the number of
// shaded pixels.
RELEVO_LANE std::uint64_t shade_tile(const DrawState& draw, const TileMemory& tile, const TileBox& box) {
    switch (draw.settings.shading) {
        case Shading::Unlit:
            return shade_rows<Unlit>(draw, tile, box);
        case Shading::Flat:
            return shade_rows<Flat>(draw, tile, box);
        case Shading::Gouraud:
            return shade_rows<Gouraud>(draw, tile, box);
        case Shading::Phong:
            return shade_rows<Phong>(draw, tile, box);
    }
    return 0;
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
