// Shading: every pixel of a tile that shows a triangle gets its colour, once.
//
//   visible   n n n n | n n n n | ...      blocks of N pixels, 4 wide: few triangles meet in a block
//             n n n n | n n n n |
//
// Small triangles are shaded by their fragments (shade_fragments.hpp), the others by blocks. A block is one
// of three kinds, by the different triangles in it:
//   none   background, or shaded already
//   few    up to `most_seen`: each hands its kept numbers (kept_setups.hpp) to its own lanes; then edge
//          values, weights, light, texture and output run once for the whole block
//   many   (slivers, several models) triangle after triangle
#pragma once
#include "raster/fast/cover_tile.hpp"
#include "raster/fast/kept_setups.hpp"
#include "raster/fast/shade_fragments.hpp"
#include "raster/fast/tile_at.hpp"
#include "raster/fast/twice.hpp"
#include "raster/fast/write_tile.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// With more triangles in a block it is faster to shade one after the other.
inline constexpr int most_seen = lanes == 16 ? 8 : lanes == 8 ? 5 : 3;

// A block of pixels: where it stands in the tile, and which of its lanes show a triangle.
struct BlockAt {
    int row, column;
    Ints x, y;  // of its pixels
    std::uint32_t covered;
    Ints numbers;  // of the triangles
};

// The lanes of `which` of the block.
RELEVO_LANE void write_block(const TileAt& at, Words packed, const RgbOf<Floats>& c, std::uint32_t which,
                             int row, int column) {
    const TileMemory& tile = at.scratch.tile;
    std::uint32_t* to = at.color_row(row) + column;
    Ints colors = to_whole(packed);
    if (which != all_bits) colors = select(from_bits(which), colors, load_block(to, tile.stride));
    store_block(colors, to, tile.stride);
    if (at.draw.linear == nullptr) return;
    alignas(64) std::uint32_t place[lanes];
    store((Ints(row) + lane_rows()) * Ints(tile.stride) + Ints(column) + lane_columns(), place);
    write_linear(at, c, place, which);
}
RELEVO_LANE void write_background(const TileAt& at, int row, int column) {
    const TileMemory& tile = at.scratch.tile;
    store_block(Ints(std::bit_cast<std::int32_t>(at.draw.background8)), at.color_row(row) + column,
                tile.stride);
    if (at.draw.linear == nullptr) return;
    for (int y = row; y < at.box.height && y < row + block_rows; ++y)
        for (int x = column; x < at.box.width && x < column + block_columns; ++x)
            *linear_at(at, y, x) = at.draw.background;
}

// ------------------------------------------------------------------------------------------------ light
// Blocks whose carried numbers are known wait for each other, so that light runs for two of them at once.
//
//   numbers   carried 0 .. 7, then amount and gloss of the face          of each block
struct WaitingBlocks {
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
[[gnu::noinline, gnu::flatten]] void light_blocks(const TileAt& at, WaitingBlocks& waiting) {
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
        write_block(at, packed.a, {c.r.a, c.g.a, c.b.a}, waiting.which[0], waiting.row[0], waiting.column[0]);
        if (waiting.count == 2)
            write_block(at, packed.b, {c.r.b, c.g.b, c.b.b}, waiting.which[1], waiting.row[1],
                        waiting.column[1]);
    });
    waiting.count = 0;
}

// The lanes of `which` of a block are known up to light.
template <template <bool> class Program, class P>
RELEVO_LANE void light(const TileAt& at, WaitingBlocks& waiting, const ModelState& model,
                       const std::array<Floats, P::size>& carried, const LaneFace<P>& face,
                       std::uint32_t which, int row, int column) {
    if constexpr (is_lit_at_once<P>) {
        const RgbOf<Floats> c = P::template pixel<Floats>(model.setup.surface, face, carried.data());
        write_block(at, packed_rgba8<Floats>(c, at.draw.settings.output), c, which, row, column);
    } else {
        if (waiting.count == 1 && waiting.model != &model) light_blocks<Program>(at, waiting);
        const int n = waiting.count++;
        waiting.model = &model;
        waiting.which[n] = which, waiting.row[n] = row, waiting.column[n] = column;
        for (std::size_t k = 0; k < P::size; ++k) store(carried[k], waiting.numbers[k][n]);
        if constexpr (P::needs_face) {
            const Floats of_face[6] = {face.amount.r, face.amount.g, face.amount.b,
                                       face.gloss.r,  face.gloss.g,  face.gloss.b};
            for (int k = 0; k < 6; ++k) store(of_face[k], waiting.numbers[max_carried + k][n]);
        }
        if (waiting.count == 2) light_blocks<Program>(at, waiting);
    }
}

// ------------------------------------------------------------------------------------------------ few
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

// The triangles of a block, and the lanes that show them.
struct Seen {
    std::uint32_t number[most_seen];
    Bools lanes_of[most_seen];
    KeptSetup setup[most_seen];
    int count = 0;
};

// False when there are too many.
RELEVO_LANE bool find_seen(const BlockAt& block, Seen& seen) {
    std::uint32_t firsts = bits(first_of_equals(block.numbers)) & block.covered;
    seen.count = std::popcount(firsts);
    if (seen.count > most_seen) return false;
    alignas(64) std::uint32_t numbers[lanes];
    store(block.numbers, numbers);
    for (int n = 0; n < seen.count; ++n, firsts &= firsts - 1) {
        seen.number[n] = numbers[std::countr_zero(firsts)];
        seen.lanes_of[n] = block.numbers == Ints(static_cast<std::int32_t>(seen.number[n]));
    }
    return true;
}
template <template <bool> class Program>
RELEVO_LANE KeptSetup find_setup(const TileAt& at, KeptSetups& kept, std::uint32_t number) {
    const std::uint32_t group = number / lanes;
    if (!kept.holds(group)) prepare<Program>(at, group, kept);
    return {&kept.groups[group % KeptSetups::slots], number % lanes};
}
// False when the set-ups have no room beside each other.
template <template <bool> class Program>
RELEVO_LANE bool find_setups(const TileAt& at, KeptSetups& kept, Seen& seen) {
    for (int n = 0; n < seen.count; ++n) seen.setup[n] = find_setup<Program>(at, kept, seen.number[n]);
    for (int n = 0; n < seen.count; ++n)
        if (!kept.holds(seen.number[n] / lanes)) return false;
    return true;
}

// In each lane the numbers of the triangle that it shows. Number: Doubles or, where all triangles are small,
// Ints, of which a register holds twice as many.
template <class Number>
struct EdgePlanes {
    Number e1, across1, down1, e2, across2, down2, area;
    Floats rw0, rw1, rw2;
};
template <class Number>
RELEVO_LANE EdgePlanes<Number> edge_planes(const KeptSetup& t) {
    const SetupGroup& g = *t.group;
    const std::uint32_t k = t.column;
    const auto planes = [&](const auto& e) RELEVO_INSIDE {
        return EdgePlanes<Number>{e[0][k], e[1][k], e[2][k],    e[3][k],    e[4][k],
                                  e[5][k], e[6][k], g.rw[0][k], g.rw[1][k], g.rw[2][k]};
    };
    if constexpr (std::is_same_v<Number, Ints>)
        return planes(g.small_edges);
    else
        return planes(g.edges);
}
RELEVO_LANE Bools mask_for(Ints, Bools mask) { return mask; }
RELEVO_LANE WideBools mask_for(const Doubles&, Bools mask) { return widen(mask); }
template <class Number>
RELEVO_LANE EdgePlanes<Number> select(Bools mask, const EdgePlanes<Number>& yes,
                                      const EdgePlanes<Number>& no) {
    const auto m = mask_for(Number(), mask);
    return {select(m, yes.e1, no.e1),     select(m, yes.across1, no.across1), select(m, yes.down1, no.down1),
            select(m, yes.e2, no.e2),     select(m, yes.across2, no.across2), select(m, yes.down2, no.down2),
            select(m, yes.area, no.area), select(mask, yes.rw0, no.rw0),      select(mask, yes.rw1, no.rw1),
            select(mask, yes.rw2, no.rw2)};
}
// At the pixels (x, y), of one block or of two.
template <class Real, class Number, class Place>
RELEVO_LANE PerspectiveWeightsOf<Real> weights_at(const EdgePlanes<Number>& p, const Place& x,
                                                  const Place& y) {
    const auto as_number = [](const Place& a) RELEVO_INSIDE {
        if constexpr (std::is_same_v<Number, Ints>)
            return a;
        else
            return to_wide(a);
    };
    const auto across = as_number(x), down = as_number(y);
    const auto e1 = p.e1 + across * p.across1 + down * p.down1,
               e2 = p.e2 + across * p.across2 + down * p.down2;
    return perspective_weights<Real>(
        InterpolatorOf<Floats>{{}, {}, {}, to_wide(p.rw0), to_wide(p.rw1), to_wide(p.rw2)},
        EdgeValuesOf<Real>{to_wide(p.area - e1 - e2), to_wide(e1), to_wide(e2)});
}

template <class Program>
struct CarriedPlanes {
    VaryingPlane<Program::size, Floats> plane;
    LaneFace<Program> face;
};
template <class Program>
RELEVO_LANE CarriedPlanes<Program> carried_planes(const KeptSetup& t) {
    const SetupGroup& g = *t.group;
    const std::uint32_t k = t.column;
    CarriedPlanes<Program> c;
    for (std::size_t j = 0; j < Program::size; ++j)
        c.plane.a0[j] = g.plane[j][0][k], c.plane.d1[j] = g.plane[j][1][k], c.plane.d2[j] = g.plane[j][2][k];
    if constexpr (Program::needs_face)
        c.face = {{g.face[0][k], g.face[1][k], g.face[2][k]}, {g.face[3][k], g.face[4][k], g.face[5][k]}};
    return c;
}
template <class Program>
RELEVO_LANE CarriedPlanes<Program> select(Bools mask, const CarriedPlanes<Program>& yes,
                                          const CarriedPlanes<Program>& no) {
    CarriedPlanes<Program> c;
    for (std::size_t j = 0; j < Program::size; ++j) {
        c.plane.a0[j] = select(mask, yes.plane.a0[j], no.plane.a0[j]);
        c.plane.d1[j] = select(mask, yes.plane.d1[j], no.plane.d1[j]);
        c.plane.d2[j] = select(mask, yes.plane.d2[j], no.plane.d2[j]);
    }
    if constexpr (Program::needs_face)
        c.face = {pipeline::select<Floats>(mask, yes.face.amount, no.face.amount),
                  pipeline::select<Floats>(mask, yes.face.gloss, no.face.gloss)};
    return c;
}

// Every triangle has one colour: a look-up for each lane.
RELEVO_LANE void shade_colors(const TileAt& at, const KeptSetups& kept, const BlockAt& block) {
    constexpr int words = sizeof(SetupGroup) / 4;
    const Ints known = max(block.numbers, Ints(0));
    const Ints slot = (known >> std::countr_zero(0u + lanes)) & Ints(KeptSetups::slots - 1);
    const Ints place = slot * Ints(words) + (known & Ints(lanes - 1));
    const auto colors = [&](int k) RELEVO_INSIDE { return gather(kept.groups->color[k], place); };
    RgbOf<Floats> c{};
    if (at.draw.linear != nullptr) c = {colors(0), colors(1), colors(2)};
    write_block(at, to_word(gather(kept.groups->packed, place)), c, block.covered, block.row, block.column);
}

RELEVO_LANE const ModelState& model_of(const TileAt& at, const KeptSetup& t) {
    return at.draw.models[t.group->model[t.column]];
}

// One triangle, in the lanes that are covered.
template <template <bool> class Program>
RELEVO_LANE void shade_one(const TileAt& at, WaitingBlocks& waiting, const BlockAt& block,
                           const KeptSetup& t) {
    const ModelState& model = model_of(at, t);
    with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
        if constexpr (P::size == 0) {
            const SetupGroup& g = *t.group;
            const std::uint32_t k = t.column;
            write_block(at, Words(g.packed[k]), {g.color[0][k], g.color[1][k], g.color[2][k]}, block.covered,
                        block.row, block.column);
        } else {
            const auto weights = weights_at<Floats>(edge_planes<Doubles>(t), block.x, block.y);
            const CarriedPlanes<P> planes = carried_planes<P>(t);
            light<Program, P>(at, waiting, model, interpolate(planes.plane, weights), planes.face,
                              block.covered, block.row, block.column);
        }
    });
}

// Two whole blocks side by side show one triangle.
template <template <bool> class Program>
RELEVO_LANE void shade_pair(const TileAt& at, const BlockAt& left, const KeptSetup& t) {
    const ModelState& model = model_of(at, t);
    with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
        RgbOf<Floats2> c;
        Twice<Words> packed;
        if constexpr (P::size == 0) {
            const SetupGroup& g = *t.group;
            const std::uint32_t k = t.column;
            c = {g.color[0][k], g.color[1][k], g.color[2][k]}, packed = g.packed[k];
        } else {
            const Twice<Ints> x{left.x, left.x + Ints(block_columns)}, y = left.y;
            const auto weights = weights_at<Floats2>(edge_planes<Doubles>(t), x, y);
            const CarriedPlanes<P> planes = carried_planes<P>(t);
            const auto carried = interpolate<P::size, Floats, Floats2>(planes.plane, weights);
            FaceOf<P, Floats2> face{};
            if constexpr (P::needs_face) {
                const auto& [amount, gloss] = planes.face;
                face = {{amount.r, amount.g, amount.b}, {gloss.r, gloss.g, gloss.b}};
            }
            c = P::template pixel<Floats2>(model.setup.surface, face, carried.data());
            packed = packed_rgba8<Floats2>(c, at.draw.settings.output);
        }
        write_block(at, packed.a, {c.r.a, c.g.a, c.b.a}, all_bits, left.row, left.column);
        write_block(at, packed.b, {c.r.b, c.g.b, c.b.b}, all_bits, left.row, left.column + block_columns);
    });
}

// False when the block shows too many triangles, or of several models, or their set-ups have no room beside
// each other.
template <template <bool> class Program>
RELEVO_LANE bool shade_few(const TileAt& at, KeptSetups& kept, WaitingBlocks& waiting, const BlockAt& block) {
    Seen seen;
    if (!find_seen(block, seen) || !find_setups<Program>(at, kept, seen)) return false;
    const ModelState& model = model_of(at, seen.setup[0]);
    for (int n = 1; n < seen.count && at.draw.models.size() > 1; ++n)
        if (&model_of(at, seen.setup[n]) != &model) return false;
    with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
        if constexpr (P::size == 0) {
            shade_colors(at, kept, block);
        } else {
            bool small = true;
            for (int n = 0; n < seen.count; ++n) small &= seen.setup[n].group->small;
            const auto weights_by = [&]<class Number>(Number) RELEVO_INSIDE {
                EdgePlanes<Number> edges = edge_planes<Number>(seen.setup[0]);
                for (int n = 1; n < seen.count; ++n)
                    edges = select(seen.lanes_of[n], edge_planes<Number>(seen.setup[n]), edges);
                return weights_at<Floats>(edges, block.x, block.y);
            };
            const auto weights = small ? weights_by(Ints()) : weights_by(Doubles());
            CarriedPlanes<P> planes = carried_planes<P>(seen.setup[0]);
            for (int n = 1; n < seen.count; ++n)
                planes = select<P>(seen.lanes_of[n], carried_planes<P>(seen.setup[n]), planes);
            light<Program, P>(at, waiting, model, interpolate(planes.plane, weights), planes.face,
                              block.covered, block.row, block.column);
        }
    });
    return true;
}

// One triangle after the other: slower, and right for any number of them, of any models.
template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] void shade_many(const TileAt& at, KeptSetups& kept, WaitingBlocks& waiting,
                                                const BlockAt& block) {
    alignas(64) std::uint32_t numbers[lanes];
    store(block.numbers, numbers);
    for (std::uint32_t rest = block.covered; rest != 0;) {
        const std::uint32_t number = numbers[std::countr_zero(rest)];
        BlockAt part = block;
        part.covered = rest & bits(block.numbers == Ints(static_cast<std::int32_t>(number)));
        shade_one<Program>(at, waiting, part, find_setup<Program>(at, kept, number));
        rest &= ~part.covered;
    }
}

// ------------------------------------------------------------------------------------------------ a tile
RELEVO_LANE void write_shaded_row(const TileAt& at, int row) {
    const std::uint32_t* colors = at.color_row(row);
    write_tile_row(at.draw, at.scratch, at.box, row,
                   [colors](int k) RELEVO_INSIDE { return load(colors + k); });
}

template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] std::uint64_t shade_blocks(const TileAt& at) {
    KeptSetups kept(at.scratch.kept);
    WaitingBlocks waiting;
    std::uint64_t shaded = 0;
    const TileMemory tile = at.scratch.tile;
    const bool has_plane = at.has_plane;
    std::uint32_t last = nothing;  // number of the triangle that `setup` is of
    KeptSetup setup{};
    const auto set_up_of = [&](std::uint32_t number) RELEVO_INSIDE {
        if (number != last) setup = find_setup<Program>(at, kept, number), last = number;
        return setup;
    };
    for (int row = 0; row < at.box.height; row += block_rows) {
        const Ints y = Ints(row) + lane_rows();
        for (int column = 0; column < at.box.width; column += block_columns) {
            const Ints x = Ints(column) + lane_columns();
            write_background_row(at.draw, at.scratch.background);
            const std::uint32_t* visible = tile.visible + row * tile.stride + column;
            const Ints numbers = load_block(visible, tile.stride);
            const std::uint32_t first = *visible;
            const Bools like_first = numbers == Ints(static_cast<std::int32_t>(first));
            if (has_plane && all(is_negative(numbers))) continue;
            if (bits(like_first) == all_bits) {
                BlockAt block{row, column, x, y, all_bits, numbers};
                if (first == nothing) {
                    write_background(at, row, column);
                    continue;
                }
                shaded += lanes;
                const Ints next = load_block(visible + block_columns, tile.stride);
                if (all(next == numbers)) {
                    shaded += lanes;
                    shade_pair<Program>(at, block, set_up_of(first));
                    column += block_columns;
                } else {
                    shade_one<Program>(at, waiting, block, set_up_of(first));
                }
                continue;
            }
            const BlockAt block{row, column, x, y, all_bits & ~bits(is_negative(numbers)), numbers};
            shaded += static_cast<unsigned>(std::popcount(block.covered));
            if (block.covered != all_bits && !has_plane) write_background(at, row, column);
            if (!shade_few<Program>(at, kept, waiting, block)) shade_many<Program>(at, kept, waiting, block);
            last = nothing;  // its set-up may have been replaced
        }
        if (waiting.count > 0) light_blocks<Program>(at, waiting);
        for (int line = row; line < row + block_rows && line < at.box.height; ++line)
            write_shaded_row(at, line);
    }
    return shaded;
}

// A tile with kept fragments.
template <template <bool> class Program>
RELEVO_LANE std::uint64_t shade_plane(const TileAt& at) {
    const TileMemory& tile = at.scratch.tile;
    const Ints background(std::bit_cast<std::int32_t>(at.draw.background8));
    const int rows = (at.box.height + block_rows - 1) / block_rows * block_rows;
    int covered = 0;
    for (int k = 0; k < rows * tile.stride; k += lanes) {
        store(background, tile.color + k);
        const Ints number = load(tile.visible + k);
        covered += count(is_negative(number) && !(number == Ints(-1)));
    }
    for (int y = 0; at.draw.linear != nullptr && y < at.box.height; ++y)
        std::fill_n(linear_at(at, y, 0), at.box.width, at.draw.background);
    std::uint64_t shaded = shade_fragments<Program>(at, covered);
    if (at.scratch.in_blocks) return shaded + shade_blocks<Program>(at);
    for (int y = 0; y < at.box.height; ++y) {
        write_shaded_row(at, y);
        write_background_row(at.draw, at.scratch.background);
    }
    return shaded;
}
template <template <bool> class Program>
RELEVO_LANE std::uint64_t shade_any(const TileAt& at) {
    return at.has_plane ? shade_plane<Program>(at) : shade_blocks<Program>(at);
}

// Everything is of one colour.
RELEVO_LANE std::uint64_t shade_one_color(const TileAt& at) {
    const DrawState& draw = at.draw;
    const Ints background(std::bit_cast<std::int32_t>(draw.background8));
    const RgbOf<Floats> color = draw.models[0].setup.surface.color;
    const Ints packed = to_whole(packed_rgba8<Floats>(color, draw.settings.output));
    const Floats cleared = cleared_nearness(draw);
    std::uint64_t shaded = 0;
    for (int row = 0; row < at.box.height; ++row) {
        const float* nearness = at.scratch.tile.nearness + row * at.scratch.tile.stride;
        for (int k = 0; k < at.box.width; k += lanes)
            shaded += static_cast<unsigned>(count(load(nearness + k) > cleared));
        write_tile_row(draw, at.scratch, at.box, row, [&](int k) RELEVO_INSIDE {
            return select(load(nearness + k) > cleared, packed, background);
        });
        write_background_row(draw, at.scratch.background);
    }
    return shaded;
}

// Colours and writes the tile. Returns the number of shaded pixels.
RELEVO_LANE std::uint64_t shade_tile(const DrawState& draw, TileScratch& scratch, int listed,
                                     const TileBox& box) {
    const TileAt at{draw, scratch, listed, box};
    switch (draw.settings.shading) {
        case Shading::Unlit:
            if (scratch.tile.visible == nullptr) return shade_one_color(at);
            return shade_any<Unlit>(at);
        case Shading::Flat:
            return shade_any<Flat>(at);
        case Shading::Gouraud:
            return shade_any<Gouraud>(at);
        case Shading::Phong:
            return shade_any<Phong>(at);
    }
    return 0;
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
