// Shading: every pixel of a tile that shows a triangle gets its colour, once.
//
//   visible   n n n n | n n n n | ...      blocks of N pixels, 4 wide: few triangles meet in a block
//             n n n n | n n n n |
//
// Small triangles are shaded by their fragments (shade_fragments.hpp), the others by blocks:
//   whole   one triangle in all of the block; first these of a row of blocks, in runs of one triangle
//   mixed   several triangles, or background, too; then these: each lane takes what it needs of the triangle
//           that it shows from the group that this one was set up in
// Untextured Gouraud and flat pixels get their colours at once, others wait for light (waiting_light.hpp).
#pragma once
#include <numeric>

#include "raster/fast/block_weights.hpp"
#include "raster/fast/cover_tile.hpp"
#include "raster/fast/shade_fragments.hpp"
#include "raster/fast/waiting_light.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// ------------------------------------------------------------------------------------------------ whole
// Pixels that can be coloured at once, in two loops: the weights of all blocks first, then their colours.
template <class P>
RELEVO_LANE void color_run(const TileAt& at, const Surface& surface, const CarriedPlanes<P>& planes,
                           RunOfBlocks run, int row, int column, int count, std::uint32_t which,
                           bool displayable) {
    alignas(64) float b1[max_tile / block_columns][lanes], b2[max_tile / block_columns][lanes];
    for (int n = 0; n < count; ++n, run.next()) {
        const PerspectiveWeightsOf<Floats> weights = run.weights();
        store(weights.b1, b1[n]), store(weights.b2, b2[n]);
    }
    const BlockRow blocks(at, row);
    with_light_of(displayable, [&]<class Range>(Range) RELEVO_INSIDE {
        for (int n = 0; n < count; ++n, column += block_columns) {
            const RgbOf<Floats> c = color_at<P>(surface, planes, {load(b1[n]), load(b2[n]), {}});
            blocks.write(at, column, which, packed_rgba8<Floats, Range::value>(c, blocks.output), c);
        }
    });
}

// `count` blocks of a row, from (row, column) on: what of them shows the triangle, of whole ones everything.
template <template <bool> class Program>
RELEVO_LANE void shade_run(const TileAt& at, WaitingPixels& waiting, const KeptSetup& triangle, int row,
                           int column, int count, std::uint32_t which) {
    const SetupGroup& group = *triangle.group;
    const OneColumn of{triangle.column};
    const ModelState& model = at.draw.models[std::size_t(of(group.model))];
    with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
        if constexpr (P::size == 0) {
            const RgbOf<Floats> c{of(group.color[0]), of(group.color[1]), of(group.color[2])};
            const BlockRow blocks(at, row);
            for (int n = 0; n < count; ++n, column += block_columns)
                blocks.write(at, column, which, to_word(Ints(of(group.packed))), c);
        } else {
            const CarriedPlanes<P> planes = carried_planes<P>(group, of);
            RunOfBlocks run(group, of, row, column);
            if constexpr (is_lit_at_once<P>) {
                color_run<P>(at, model.setup.surface, planes, run, row, column, count, which,
                             of(group.displayable));
            } else {
                for (int n = 0; n < count; ++n, column += block_columns, run.next())
                    wait_for_light<Program, P>(at, waiting, model,
                                               {interpolate(planes.plane, run.weights()), planes.face},
                                               BlockTo{row, column, which});
            }
        }
    });
}

// ------------------------------------------------------------------------------------------------ mixed
struct MixedBlock {
    int row, column;
    Ints numbers;           // of the triangles
    std::uint32_t covered;  // lanes that show one
};

// The groups of set-ups that it shows, and the lanes that show them.
struct SeenGroups {
    std::uint32_t number[lanes];
    Bools lanes_of[lanes];
    int count = 0;
    Ints column;  // of each lane in its group; of one that shows nothing another's
};
RELEVO_LANE SeenGroups find_groups(const MixedBlock& block) {
    alignas(64) std::uint32_t numbers[lanes];
    store(block.numbers, numbers);
    const Ints first(static_cast<std::int32_t>(numbers[std::countr_zero(block.covered)]));
    const Ints shown = select(from_bits(block.covered), block.numbers, first);
    const Ints group = shown >> std::countr_zero(0u + lanes);
    SeenGroups seen;
    seen.column = shown & Ints(lanes - 1);
    for (std::uint32_t rest = block.covered; rest != 0; ++seen.count) {
        const std::uint32_t number = numbers[std::countr_zero(rest)] / lanes;
        seen.number[seen.count] = number;
        seen.lanes_of[seen.count] = group == Ints(static_cast<std::int32_t>(number));
        rest &= ~bits(seen.lanes_of[seen.count]);
    }
    return seen;
}

// False when it shows several models, or its groups have no room beside each other.
template <template <bool> class Program>
RELEVO_LANE bool shade_mixed(const TileAt& at, KeptSetups& kept, WaitingPixels& waiting,
                             const MixedBlock& block) {
    const SeenGroups seen = find_groups(block);
    const OwnColumn of{Picked(seen.column)};
    for (int n = 0; n < seen.count; ++n)
        if (!kept.holds(seen.number[n])) prepare<Program>(at, seen.number[n], kept);
    bool small = true;
    for (int n = 0; n < seen.count; ++n) {
        if (!kept.holds(seen.number[n])) return false;
        small &= kept.group(seen.number[n]).small;
    }
    // In each lane what value() takes from the lane's group.
    const auto mixed = [&](auto&& value) RELEVO_INSIDE {
        auto result = value(kept.group(seen.number[0]));
        for (int n = 1; n < seen.count; ++n)
            result = select(seen.lanes_of[n], value(kept.group(seen.number[n])), result);
        return result;
    };
    std::uint32_t model_number = 0;
    if (at.draw.models.size() > 1) {
        const Ints models = mixed([&](const SetupGroup& g) RELEVO_INSIDE { return Ints(of(g.model)); });
        model_number = static_cast<std::uint32_t>(first_lane(models));
        if (!all(models == Ints(first_lane(models)))) return false;
    }
    const ModelState& model = at.draw.models[model_number];
    const BlockTo to{block.row, block.column, block.covered};
    with_texture<Program>(model, [&]<class P>(P) RELEVO_INSIDE {
        if constexpr (P::size == 0) {
            const auto color = [&](int k) RELEVO_INSIDE {
                return mixed([&](const SetupGroup& g) RELEVO_INSIDE { return Floats(of(g.color[k])); });
            };
            RgbOf<Floats> c{};
            if (at.draw.linear != nullptr) c = {color(0), color(1), color(2)};
            const Ints packed = mixed([&](const SetupGroup& g) RELEVO_INSIDE { return Ints(of(g.packed)); });
            write_pixels(at, to, to_word(packed), c);
        } else {
            const Ints x = Ints(block.column) + lane_columns(), y = Ints(block.row) + lane_rows();
            const auto weights_by = [&]<class Number>(Number) RELEVO_INSIDE {
                return weights_at(
                    mixed([&](const SetupGroup& g) RELEVO_INSIDE { return edge_planes<Number>(g, of); }), x,
                    y);
            };
            const auto weights = small ? weights_by(Ints()) : weights_by(Doubles());
            const CarriedPlanes<P> planes =
                mixed([&](const SetupGroup& g) RELEVO_INSIDE { return carried_planes<P>(g, of); });
            light<Program, P>(at, waiting, model, {interpolate(planes.plane, weights), planes.face}, to);
        }
    });
    return true;
}
// One triangle after the other: slower, and right for any number of them, of any models.
template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] void shade_many(const TileAt& at, KeptSetups& kept, WaitingPixels& waiting,
                                                const MixedBlock& block) {
    alignas(64) std::uint32_t numbers[lanes];
    store(block.numbers, numbers);
    for (std::uint32_t rest = block.covered; rest != 0;) {
        const std::uint32_t number = numbers[std::countr_zero(rest)];
        const std::uint32_t which = rest & bits(block.numbers == Ints(static_cast<std::int32_t>(number)));
        shade_run<Program>(at, waiting, find_setup<Program>(at, kept, number), block.row, block.column, 1,
                           which);
        rest &= ~which;
    }
}

// ------------------------------------------------------------------------------------------------ a tile
// The blocks of a row of them that show triangles, a bit each. Numbers below 0 are the background's, or those
// of fragments.
struct RowBlocks {
    std::uint32_t whole = 0, mixed = 0, goes_on = 0;
};
// Bit k: bits 4 k .. 4 k + 3 are set.
RELEVO_LANE std::uint32_t all_of_fours(std::uint64_t m) {
    m &= m >> 1;
    m &= m >> 2 & 0x1111111111111111;
    m = (m | m >> 3) & 0x0303030303030303;
    m = (m | m >> 6) & 0x000f000f000f000f;
    m = (m | m >> 12) & 0x000000ff000000ff;
    return static_cast<std::uint32_t>((m | m >> 24) & 0xffff);
}
RELEVO_LANE RowBlocks blocks_of_row(const std::uint32_t* visible, int stride, int width) {
    constexpr int part = 64;
    static_assert(max_tile <= 2 * part && block_columns == 4);
    RowBlocks blocks;
    for (int x0 = 0; x0 < width; x0 += part) {
        const int columns = std::min(part, width - x0);
        std::uint64_t same = 0, none = 0, next = 0;  // all are like the block's first one; none is 0 or more
        for (int x = 0; x < columns; x += lanes) {
            const std::uint32_t* from = visible + x0 + x;
            const Ints top = load(from), first = first_of_four(top);
            Bools like_first = top == first;
            Ints negative = top;
            for (int y = 1; y < block_rows; ++y) {
                const Ints row = load(from + y * stride);
                like_first = like_first & (row == first), negative = negative & row;
            }
            same |= std::uint64_t{bits(like_first)} << x;
            next |= std::uint64_t{bits(top == load(from + block_columns))} << x;
            none |= std::uint64_t{bits(is_negative(negative))} << x;
        }
        const int count = (columns + block_columns - 1) / block_columns;
        const std::uint32_t one = all_of_fours(same), seen = ~all_of_fours(none) & ((1u << count) - 1);
        blocks.whole |= (one & seen) << x0 / block_columns;
        blocks.goes_on |= all_of_fours(next) << x0 / block_columns;
        blocks.mixed |= (~one & seen) << x0 / block_columns;
    }
    return blocks;
}

RELEVO_LANE void write_shaded_row(const TileAt& at, int row) {
    const std::uint32_t* colors = at.color_row(row);
    const std::uint32_t* visible = at.scratch.tile.visible + row * at.scratch.tile.stride;
    const Ints background(std::bit_cast<std::int32_t>(at.draw.background8)),
        none(static_cast<std::int32_t>(nothing));
    write_tile_row(at.draw, at.scratch, at.box, row, [=](int k) RELEVO_INSIDE {
        return select(load(visible + k) == none, background, load(colors + k));
    });
}

template <template <bool> class Program>
[[gnu::noinline, gnu::flatten]] std::uint64_t shade_blocks(const TileAt& at) {
    const TileMemory& tile = at.scratch.tile;
    KeptSetups kept(at.scratch.kept);
    WaitingPixels& waiting = nobody_waits(at.scratch);
    std::uint64_t shaded = 0;
    for (int row = 0; row < at.box.height; row += block_rows) {
        const std::uint32_t* visible = tile.visible + row * tile.stride;
        RowBlocks blocks = blocks_of_row(visible, tile.stride, at.box.width);
        shaded += static_cast<unsigned>(std::popcount(blocks.whole) * lanes);
        const std::uint32_t goes_on = blocks.whole & (blocks.whole >> 1) & blocks.goes_on;
        while (blocks.whole != 0) {
            write_background_row(at.draw, at.scratch.background);
            const int first = std::countr_zero(blocks.whole);
            const int column = first * block_columns;
            const std::uint32_t number = visible[column];
            const int count = std::countr_one(goes_on >> first) + 1;
            shade_run<Program>(at, waiting, find_setup<Program>(at, kept, number), row, column, count,
                               all_bits);
            blocks.whole &= ~(((2u << (count - 1)) - 1) << first);
        }
        for (; blocks.mixed != 0; blocks.mixed &= blocks.mixed - 1) {
            write_background_row(at.draw, at.scratch.background);
            const int column = std::countr_zero(blocks.mixed) * block_columns;
            const Ints numbers = load_block(visible + column, tile.stride);
            const MixedBlock block{row, column, numbers, all_bits & ~bits(is_negative(numbers))};
            shaded += static_cast<unsigned>(std::popcount(block.covered));
            if (!shade_mixed<Program>(at, kept, waiting, block))
                shade_many<Program>(at, kept, waiting, block);
        }
        light_waiting<Program>(at, waiting);
        write_background_row(at.draw, at.scratch.background);
        for (int line = row; line < row + block_rows && line < at.box.height; ++line)
            write_shaded_row(at, line);
    }
    return shaded;
}

// A tile with kept fragments, or where some is painted.
template <template <bool> class Program>
RELEVO_LANE std::uint64_t shade_plane(const TileAt& at) {
    const TileMemory& tile = at.scratch.tile;
    const Ints none(static_cast<std::int32_t>(nothing)), some(static_cast<std::int32_t>(painted));
    int negative = 0, before = 0;  // pixels that show fragments or are painted; that are painted
    for (int k = 0, end = at.rows_of_blocks() * tile.stride; k < end; k += lanes) {
        const Ints number = load(tile.visible + k);
        negative += count(is_negative(number) && !(number == none));
        before += count(number == some);
    }
    if (!at.scratch.painted) before = 0;
    std::uint64_t shaded = shade_fragments<Program>(at, negative - before) + std::uint64_t(before);
    if (at.scratch.in_blocks) return shaded + shade_blocks<Program>(at);
    for (int y = 0; y < at.box.height; ++y) {
        write_shaded_row(at, y);
        write_background_row(at.draw, at.scratch.background);
    }
    return shaded;
}
template <template <bool> class Program>
RELEVO_LANE std::uint64_t shade_any(const TileAt& at) {
    for (int y = 0; at.draw.linear != nullptr && y < at.box.height; ++y)
        std::fill_n(linear_at(at, y, 0), at.box.width, at.draw.background);
    return at.has_plane ? shade_plane<Program>(at) : shade_blocks<Program>(at);
}

// A tile where depth tells what is covered; color(k) of the pixels there, k as in the tile's memory. Counted
// before they are written: that brings the row into the cache.
template <class Color>
RELEVO_LANE std::uint64_t write_covered(const DrawState& draw, TileScratch& scratch, const TileBox& box,
                                        Color&& color) {
    const Ints background(std::bit_cast<std::int32_t>(draw.background8));
    const Floats cleared = cleared_nearness(draw);
    const int stride = scratch.tile.stride;
    Ints sum(0);
    for (int row = 0; row < box.height; ++row) {
        const float* nearness = scratch.tile.nearness + row * stride;
        const auto covered = [=](int k) RELEVO_INSIDE { return load(nearness + k) > cleared; };
        for (int k = 0; k < box.width; k += lanes)  // past the row's end all is clear
            sum = select(covered(k), sum + Ints(1), sum);
        write_tile_row(draw, scratch, box, row, [=](int k) RELEVO_INSIDE {
            return select(covered(k), color(row * stride + k), background);
        });
        write_background_row(draw, scratch.background);
    }
    alignas(64) std::uint32_t sums[lanes];
    store(sum, sums);
    return std::accumulate(sums, sums + lanes, std::uint64_t{0});
}

// All of the tile is painted.
RELEVO_LANE std::uint64_t write_painted(const TileAt& at) {
    return write_covered(at.draw, at.scratch, at.box,
                         [from = at.scratch.tile.color](int k) RELEVO_INSIDE { return load(from + k); });
}
// Everything is of one colour.
RELEVO_LANE std::uint64_t shade_one_color(const DrawState& draw, TileScratch& scratch, const TileBox& box) {
    const RgbOf<Floats> color = draw.models[0].setup.surface.color;
    const Ints packed = to_whole(packed_rgba8<Floats>(color, draw.settings.output));
    return write_covered(draw, scratch, box, [=](int) RELEVO_INSIDE { return packed; });
}

// Colours and writes the tile. Returns the number of shaded pixels.
RELEVO_LANE std::uint64_t shade_tile(const DrawState& draw, TileScratch& scratch, int listed,
                                     const TileBox& box) {
    const TileAt at{draw, scratch, box, listed};
    switch (draw.settings.shading) {
        case Shading::Unlit:
            if (scratch.tile.visible == nullptr) return shade_one_color(draw, scratch, box);
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
