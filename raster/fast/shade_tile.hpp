// Shading: every pixel of a tile that shows a triangle gets its colour, once.
//
//   visible   id id id id | id id id id | ...      N pixels of a row: a group
//
// A group is one of four kinds, by the runs of equal ids in it:
//   none      background
//   uniform   one triangle: its stored set-up serves all lanes
//   few       up to `runs_limit` runs: each triangle's edge values and carried numbers go to its own
//             lanes, then weights, light, texture and output run once for the whole group
//   many      (small triangles) every lane sets up its own triangle
// Set-ups are stored for a band of rows at a time, N triangles together; what finds no room is drawn as many.
#pragma once
#include "raster/fast/cover_tile.hpp"
#include "raster/fast/shade_setup.hpp"
#include "raster/fast/twice.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

inline constexpr std::uint32_t full_group = (2u << (lanes - 1)) - 1;
inline constexpr int most_runs = 8, band_rows = 8, max_tile_groups = 128 / lanes;

// Up to so many runs a group counts as few; where triangles have one colour, few costs next to nothing.
template <template <bool> class Program>
inline constexpr int runs_limit = Program<false>::size == 0 ? most_runs : 5;

// Beyond so many runs a look-up for all lanes at once is faster than one for each run.
inline constexpr int looked_up_runs = 3;

// The set-ups that are kept, of one tile.
//
//   slots[hash of id] -> number -> ids[number], setups[number]          taken in turn, the oldest goes
struct KeptSetups {
    static constexpr std::uint32_t capacity = 256, slot_bits = 10;
    std::uint32_t ids[capacity];
    std::uint32_t slots[1 << slot_bits] = {};
    std::uint32_t next = 0;
    KeptSetup setups[capacity];

    RELEVO_LANE KeptSetups() {
        for (std::uint32_t& id : ids) id = nothing;
    }
    RELEVO_LANE static std::uint32_t slot(std::uint32_t id) {
        return (id ^ id >> slot_bits) & ((1u << slot_bits) - 1);
    }
    // The same of each lane: the number, and whether it is the right one.
    struct Found {
        Ints number;
        Bools there;
    };
    RELEVO_LANE Found find(Ints id) const {
        const Ints shifted = to_whole(to_word(id) >> slot_bits);
        const Ints number = gather(slots, (id ^ shifted) & Ints((1 << slot_bits) - 1));
        return {number, gather(ids, number) == id};
    }
    // Null if it is not there.
    RELEVO_LANE const KeptSetup* find(std::uint32_t id) const {
        const std::uint32_t n = slots[slot(id)];
        return ids[n] == id ? &setups[n] : nullptr;
    }
    RELEVO_LANE KeptSetup* add(std::uint32_t id) {
        const std::uint32_t n = next;
        next = (next + 1) % capacity;
        slots[slot(id)] = n;
        ids[n] = id;
        return &setups[n];
    }
};

// Which lanes of a group show a triangle, and in which of them a run of equal ids ends.
struct GroupRuns {
    std::uint32_t covered, ends;
};

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
        const auto whole = [](std::uint32_t x) RELEVO_INSIDE { return Ints(static_cast<std::int32_t>(x)); };
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

// ------------------------------------------------------------------------------------------------ light
// The tile at hand.
struct TileAt {
    const DrawState& draw;
    const TileMemory& tile;
    const TileBox& box;

    RELEVO_LANE std::uint32_t* color(int row, int column) const {
        return tile.color + row * tile.stride + column;
    }
    RELEVO_LANE pipeline::LinearRgb* linear(int row, int column) const {
        return draw.linear + std::size_t(box.y0 + row) * std::size_t(draw.viewport.width) + box.x0 + column;
    }
    // The lanes of `which` of the group.
    RELEVO_LANE void write(Words packed, const RgbOf<Floats>& c, std::uint32_t which, int row,
                           int column) const {
        std::uint32_t* to = color(row, column);
        const Ints colors = to_whole(packed);
        store(which == full_group ? colors : select(from_bits(which), colors, load(to)), to);
        if (draw.linear == nullptr) return;
        alignas(64) float rgb[3][lanes];
        store(c.r, rgb[0]), store(c.g, rgb[1]), store(c.b, rgb[2]);
        for (; which != 0; which &= which - 1) {
            const int k = std::countr_zero(which);
            linear(row, column)[k] = {rgb[0][k], rgb[1][k], rgb[2][k]};
        }
    }
};

// Groups whose carried numbers are known wait for each other, so that light runs for two of them at once.
//
//   numbers   carried 0 .. 7, then amount and gloss of the face          of each group
struct WaitingGroups {
    alignas(64) float numbers[max_carried + 6][2][lanes];
    int count = 0;
    const ModelState* model;  // of both
    int row[2], column[2];
    std::uint32_t which[2];

    RELEVO_LANE Floats2 operator()(std::size_t k) const {
        return {load(numbers[k][0]), load(numbers[k][count - 1])};
    }
};

template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] void light_groups(const TileAt& at, WaitingGroups& waiting) {
    with_texture<Program>(*waiting.model, [&]<class P>(P) RELEVO_INSIDE {
        std::array<Floats2, P::size> carried;
        for (std::size_t k = 0; k < P::size; ++k) carried[k] = waiting(k);
        FaceOf<P, Floats2> face{};
        if constexpr (P::needs_face) {
            constexpr std::size_t first = max_carried;
            face = {{waiting(first), waiting(first + 1), waiting(first + 2)},
                    {waiting(first + 3), waiting(first + 4), waiting(first + 5)}};
        }
        const RgbOf<Floats2> c =
            P::template pixel<Floats2>(waiting.model->setup.surface, face, carried.data());
        const Twice<Words> packed = packed_rgba8<Floats2>(c, at.draw.settings.output);
        at.write(packed.a, {c.r.a, c.g.a, c.b.a}, waiting.which[0], waiting.row[0], waiting.column[0]);
        if (waiting.count == 2)
            at.write(packed.b, {c.r.b, c.g.b, c.b.b}, waiting.which[1], waiting.row[1], waiting.column[1]);
    });
    waiting.count = 0;
}

// The lanes of `which` of a group are known up to light.
template <template <bool> class Program, class P>
RELEVO_LANE void light_later(const TileAt& at, WaitingGroups& waiting, const ModelState& model,
                             const std::array<Floats, P::size>& carried, const LaneFace<P>& face,
                             std::uint32_t which, int row, int column) {
    if (waiting.count == 1 && waiting.model != &model) light_groups<Program>(at, waiting);
    const int n = waiting.count++;
    waiting.model = &model;
    waiting.which[n] = which, waiting.row[n] = row, waiting.column[n] = column;
    for (std::size_t k = 0; k < P::size; ++k) store(carried[k], waiting.numbers[k][n]);
    if constexpr (P::needs_face) {
        const Floats of_face[6] = {face.amount.r, face.amount.g, face.amount.b,
                                   face.gloss.r,  face.gloss.g,  face.gloss.b};
        for (int k = 0; k < 6; ++k) store(of_face[k], waiting.numbers[max_carried + k][n]);
    }
    if (waiting.count == 2) light_groups<Program>(at, waiting);
}

// ------------------------------------------------------------------------------------------------ many
template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] void shade_many(const TileAt& at, WaitingGroups& waiting,
                                                std::uint32_t covered, int row, int column) {
    const Ints id = load(at.tile.visible + row * at.tile.stride + column);
    for_each_model(
        at.draw, id, covered,
        [&](std::uint32_t number, std::uint32_t which, const LaneIds& ids) RELEVO_INSIDE {
            const ModelState& model = at.draw.models[number];
            with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
                const LaneSetup<P> s = set_up<P>(at.draw, model, ids);
                if constexpr (P::size == 0) {
                    const RgbOf<Floats> c = P::template pixel<Floats>(model.setup.surface, s.face, nullptr);
                    at.write(packed_rgba8<Floats>(c, at.draw.settings.output), c, which, row, column);
                } else {
                    const auto e =
                        edge_values(s, Ints(at.box.x0 + column) + lane_numbers(), Ints(at.box.y0 + row));
                    const InterpolatorOf<Floats> rw{
                        {}, {}, {}, to_wide(s.rw0), to_wide(s.rw1), to_wide(s.rw2)};
                    const auto weights = perspective_weights<Floats>(rw, e);
                    std::array<Floats, P::size> carried;
                    for (std::size_t k = 0; k < P::size; ++k)
                        carried[k] = interpolate(s.plane(k), weights)[0];
                    light_later<Program, P>(at, waiting, model, carried, s.face, which, row, column);
                }
            });
        });
}

// ------------------------------------------------------------------------------------------------ stored
// Prepares the set-ups of N triangles.
template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] void prepare(const DrawState& draw, const std::uint32_t (&ids)[lanes],
                                             std::uint32_t which, KeptSetup* const (&to)[lanes]) {
    for_each_model(draw, load(ids), which,
                   [&](std::uint32_t number, std::uint32_t mine, const LaneIds& lane_ids) RELEVO_INSIDE {
                       const ModelState& model = draw.models[number];
                       with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
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
    std::uint32_t known = nothing;  // an id that needs no preparation
    for (int row = first_row; row < last_row; ++row) {
        const std::uint32_t* visible = tile.visible + row * tile.stride;
        for (int x = 0; x < box.width; x += lanes, ++groups) {
            const Ints id = load(visible + x);
            if (x + lanes <= box.width && all(id == Ints(static_cast<std::int32_t>(known)))) {
                *groups = known == nothing ? GroupRuns{0, 0} : GroupRuns{full_group, 1u << (lanes - 1)};
                continue;
            }
            const Ints next = load(visible + x + 1);
            const int count_here = box.width - x < lanes ? box.width - x : lanes;
            const std::uint32_t last = 1u << (count_here - 1);
            groups->covered = ~bits(id == Ints(-1)) & (2 * last - 1);
            groups->ends = (~bits(id == next) | last) & groups->covered;
            if (std::popcount(groups->ends) > runs_limit<Program>) continue;
            known = visible[x + count_here - 1];
            std::uint32_t rest = groups->ends;
            if (std::popcount(rest) > looked_up_runs) rest &= ~bits(stored.find(id).there);
            for (; rest != 0; rest &= rest - 1) {
                const std::uint32_t new_id = visible[x + std::countr_zero(rest)];
                if (stored.find(new_id) != nullptr) continue;
                ids[waiting] = new_id;
                to[waiting++] = stored.add(new_id);
                if (waiting < lanes) continue;
                prepare<Program>(draw, ids, full_group, to);
                waiting = 0;
            }
        }
    }
    if (waiting > 0) prepare<Program>(draw, ids, (1u << waiting) - 1, to);
}

RELEVO_LANE EdgeValuesOf<Floats> edge_values(const KeptSetup& t, Doubles x, double y) {
    const auto value = [&](int k) RELEVO_INSIDE {
        return Doubles(t.e[k] + y * t.down[k]) + x * Doubles(t.across[k]);
    };
    return {value(0), value(1), value(2)};
}

template <class Program>
RELEVO_LANE std::array<Floats, Program::size> carried_at(const KeptSetup& t,
                                                         const PerspectiveWeightsOf<Floats>& weights) {
    std::array<Floats, Program::size> a;
    for (std::size_t k = 0; k < Program::size; ++k)
        a[k] = interpolate(VaryingPlane<1>{{t.a0[k]}, {t.d1[k]}, {t.d2[k]}}, weights)[0];
    return a;
}

template <class Program>
RELEVO_LANE LaneFace<Program> face_of(const KeptSetup& t) {
    if constexpr (Program::needs_face) {
        const pipeline::Reflection r = t.reflection();
        return {r.amount, r.gloss};
    } else {
        return {};
    }
}

// All lanes show one triangle.
template <template <bool> class Program>
RELEVO_LANE void shade_uniform(const TileAt& at, WaitingGroups& waiting, const KeptSetup& t,
                               std::uint32_t covered, int row, int column) {
    const ModelState& model = at.draw.models[t.model];
    with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
        if constexpr (P::size == 0) {
            at.write(Words(t.packed), t.rgb(), covered, row, column);
        } else {
            const Interpolator rw{0, 0, 0, t.rw[0], t.rw[1], t.rw[2]};
            const auto e =
                edge_values(t, to_wide(lane_numbers() + Ints(at.box.x0 + column)), at.box.y0 + row);
            light_later<Program, P>(at, waiting, model, carried_at<P>(t, perspective_weights<Floats>(rw, e)),
                                    face_of<P>(t), covered, row, column);
        }
    });
}

// A truth a lane, as wide as the lanes of Doubles.
struct WideMask {
    hn::Mask<TagD> low, high;
};
RELEVO_LANE WideMask wide_mask(Bools mask) {
    const auto whole = hn::VecFromMask(TagI(), int_mask(mask));
    const auto widen = [](auto half) RELEVO_INSIDE {
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
template <template <bool> class Program>
RELEVO_LANE void shade_few(const TileAt& at, WaitingGroups& waiting, const Few& few, std::uint32_t covered,
                           int row, int column) {
    const KeptSetup& first = *few.setup[0];
    const ModelState& model = at.draw.models[first.model];
    with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
        if constexpr (P::size == 0) {
            Ints packed(static_cast<std::int32_t>(first.packed));
            RgbOf<Floats> c = first.rgb();
            for (int n = 1; n < few.count; ++n) {
                packed =
                    select(few.lanes_of[n], Ints(static_cast<std::int32_t>(few.setup[n]->packed)), packed);
                c = pipeline::select<Floats>(few.lanes_of[n], few.setup[n]->rgb(), c);
            }
            at.write(to_word(packed), c, covered, row, column);
        } else {
            const Doubles x = to_wide(lane_numbers() + Ints(at.box.x0 + column));
            const double y = at.box.y0 + row;
            EdgeValuesOf<Floats> e = edge_values(first, x, y);
            InterpolatorOf<Floats> rw{{}, {}, {}, first.rw[0], first.rw[1], first.rw[2]};
            for (int n = 1; n < few.count; ++n) {
                const KeptSetup& t = *few.setup[n];
                const EdgeValuesOf<Floats> other = edge_values(t, x, y);
                const WideMask mask = wide_mask(few.lanes_of[n]);
                e = {select(mask, other.e0, e.e0), select(mask, other.e1, e.e1),
                     select(mask, other.e2, e.e2)};
                rw.rw0 = select(mask, Doubles(t.rw[0]), rw.rw0);
                rw.rw1 = select(mask, Doubles(t.rw[1]), rw.rw1);
                rw.rw2 = select(mask, Doubles(t.rw[2]), rw.rw2);
            }
            const auto weights = perspective_weights<Floats>(rw, e);
            std::array<Floats, P::size> carried = carried_at<P>(first, weights);
            LaneFace<P> face = face_of<P>(first);
            for (int n = 1; n < few.count; ++n) {
                const auto other = carried_at<P>(*few.setup[n], weights);
                for (std::size_t j = 0; j < P::size; ++j)
                    carried[j] = select(few.lanes_of[n], other[j], carried[j]);
                if constexpr (P::needs_face) {
                    const pipeline::Reflection f = few.setup[n]->reflection();
                    face.amount = pipeline::select<Floats>(few.lanes_of[n], f.amount, face.amount);
                    face.gloss = pipeline::select<Floats>(few.lanes_of[n], f.gloss, face.gloss);
                }
            }
            light_later<Program, P>(at, waiting, model, carried, face, covered, row, column);
        }
    });
}

// Where triangles have one colour each: a look-up for every lane. False when a set-up is missing, when a
// model has a texture, or when linear colour is asked for, too.
RELEVO_LANE bool shade_colors(const TileAt& at, const KeptSetups& kept, std::uint32_t covered, int row,
                              int column) {
    if (at.draw.linear != nullptr) return false;
    const Ints id = load(at.tile.visible + row * at.tile.stride + column);
    const KeptSetups::Found found = kept.find(id);
    if ((covered & ~bits(found.there)) != 0) return false;
    constexpr int words = sizeof(KeptSetup) / 4;
    const Ints place = found.number * Ints(words);
    const Ints one_color = gather(&kept.setups[0].one_color, place);
    if ((covered & bits(one_color == Ints(0))) != 0) return false;
    at.write(to_word(gather(&kept.setups[0].packed, place)), {}, covered, row, column);
    return true;
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
template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] std::uint64_t shade_rows(const DrawState& draw, const TileMemory& tile,
                                                         const TileBox& box) {
    const TileAt at{draw, tile, box};
    const Words background(std::bit_cast<std::uint32_t>(draw.background8));
    KeptSetups kept;
    WaitingGroups waiting;
    GroupRuns groups[band_rows * max_tile_groups];
    std::uint64_t shaded = 0;
    for (int first_row = 0; first_row < box.height; first_row += band_rows) {
        const int last_row = first_row + band_rows < box.height ? first_row + band_rows : box.height;
        prepare_band<Program>(draw, tile, box, first_row, last_row, kept, groups);
        const GroupRuns* group = groups;
        for (int row = first_row; row < last_row; ++row) {
            const std::uint32_t* visible = tile.visible + row * tile.stride;
            for (int column = 0; column < box.width; column += lanes, ++group) {
                if (group->covered != full_group) {
                    const int in_box = box.width - column < lanes ? box.width - column : lanes;
                    store(to_whole(background), at.color(row, column));
                    if (draw.linear != nullptr)
                        for (int k = 0; k < in_box; ++k) at.linear(row, column)[k] = draw.background;
                    if (group->covered == 0) continue;
                }
                shaded += static_cast<unsigned>(std::popcount(group->covered));
                const KeptSetup* one = nullptr;
                Few few;
                if (std::has_single_bit(group->ends) &&
                    (one = kept.find(visible[column + std::countr_zero(group->ends)])) != nullptr)
                    shade_uniform<Program>(at, waiting, *one, group->covered, row, column);
                else if (Program<false>::size == 0 && std::popcount(group->ends) > looked_up_runs &&
                         shade_colors(at, kept, group->covered, row, column))
                    continue;
                else if (std::popcount(group->ends) <= runs_limit<Program> &&
                         find_few(kept, visible + column, load(visible + column), group->ends, few))
                    shade_few<Program>(at, waiting, few, group->covered, row, column);
                else
                    shade_many<Program>(at, waiting, group->covered, row, column);
            }
        }
    }
    if (waiting.count > 0) light_groups<Program>(at, waiting);
    return shaded;
}

// Everything is of one colour: which triangle a pixel shows does not matter.
RELEVO_LANE std::uint64_t shade_one_color(const DrawState& draw, const TileMemory& tile, const TileBox& box) {
    const Ints background(std::bit_cast<std::int32_t>(draw.background8));
    const RgbOf<Floats> color = draw.models[0].setup.surface.color;
    const Ints packed = to_whole(packed_rgba8<Floats>(color, draw.settings.output));
    std::uint64_t shaded = 0;
    for (int row = 0; row < box.height; ++row) {
        const std::uint32_t* visible = tile.visible + row * tile.stride;
        for (int x = 0; x < box.width; x += lanes) {
            const Bools covered = !(load(visible + x) == Ints(static_cast<std::int32_t>(nothing)));
            store(select(covered, packed, background), tile.color + row * tile.stride + x);
            const int in_box = box.width - x < lanes ? box.width - x : lanes;
            shaded += static_cast<unsigned>(count(covered && first_lanes(in_box)));
        }
    }
    return shaded;
}

// Fills tile.color of the box, and the picture of linear colour if it was asked for. Returns the number of
// shaded pixels.
RELEVO_LANE std::uint64_t shade_tile(const DrawState& draw, const TileMemory& tile, const TileBox& box) {
    switch (draw.settings.shading) {
        case Shading::Unlit:
            if (draw.models.size() == 1 && !draw.models[0].textured && draw.linear == nullptr)
                return shade_one_color(draw, tile, box);
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
