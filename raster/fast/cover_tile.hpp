// Stage 3 of the fast path: coverage and depth of a tile's triangles. What is left is a visibility buffer:
//
//   nearness   of each pixel (greater is nearer)          rows of `stride`, a little longer than the tile
//   visible    of each pixel: the id of its triangle
//
// Set-up is N triangles at a time (a lane each); then, all exactly as the textbook path:
//   tiny    box of up to 12 pixels: still a lane each, all boxes are walked at once, fragments are tested one
//           by one, and the number decides at equal depth
//   other   a pixel a lane, rows of N pixels; edge values in int32 where they fit (max_small_extent), else in
//           double, where every edge value (below 2^49) is exact
// Triangles are drawn in their order, so that strict comparison keeps the first of equal depths.
#pragma once
#include "raster/fast/bins.hpp"
#include "raster/fast/corners.hpp"
#include "raster/fast/stages.hpp"
#include "raster/interpolate.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

struct TileBox {
    int x0, y0, width, height;  // pixels of the picture
};

inline constexpr int tiny_pixels = 12;

// The set-up of N triangles, for the rows of one of them to read.
struct StoredSetup {
    alignas(64) double z0[lanes], g1[lanes], g2[lanes], area[lanes];
    std::int32_t x0[lanes], y0[lanes], x1[lanes], y1[lanes];  // box, within the tile
    std::int32_t left[lanes], above[lanes];                   // corner 0 to the first centre of the box
    std::int32_t dx1[lanes], dy1[lanes], dx2[lanes], dy2[lanes];
    std::int32_t bias0[lanes], bias1[lanes], bias2[lanes];
};

// How depths compare: forward depths turn their sign, so that greater is nearer.
struct Nearness {
    Ints flip;
    RELEVO_LANE Floats operator()(Floats z) const { return bits_float(float_bits(z) ^ flip); }
};

RELEVO_LANE Ints bias_of(Ints dx, Ints dy) { return select(is_top_left(dx, dy), Ints(0), Ints(1)); }

// How the pixels of a box are found to be covered.
enum class Cover {
    Int,     // edge values in int32
    Double,  // edge values in double
    All,     // no edge crosses the box
};

// Rows of one triangle, a pixel a lane. (e1, e2): edge values at the first pixel.
template <Cover cover>
RELEVO_LANE void cover_rows(const StoredSetup& s, int k, std::uint32_t id, const Nearness& nearness,
                            const TileMemory& tile, double first1, double first2) {
    const Interpolator plane{s.z0[k], s.g1[k], s.g2[k], 0, 0, 0};
    const double step1 = 256.0 * s.dy2[k], step2 = -256.0 * s.dy1[k];
    const Doubles across1(lanes * step1), across2(lanes * step2), down1(-256.0 * s.dx2[k]),
        down2(256.0 * s.dx1[k]);
    const Doubles lane = to_wide(lane_numbers());
    Doubles row1 = Doubles(first1) + lane * Doubles(step1), row2 = Doubles(first2) + lane * Doubles(step2);

    // int32: values less their bias, so that covered means none is negative
    const Ints bias0(s.bias0[k]), bias1(s.bias1[k]), bias2(s.bias2[k]);
    const Doubles area = s.area[k], wide_bias0 = to_wide(bias0), wide_bias1 = to_wide(bias1),
                  wide_bias2 = to_wide(bias2);
    const std::int32_t i_step1 = 256 * s.dy2[k], i_step2 = -256 * s.dy1[k];
    const Ints i_across1(lanes * i_step1), i_across2(lanes * i_step2), i_down1(-256 * s.dx2[k]),
        i_down2(256 * s.dx1[k]);
    Ints i_row0{}, i_row1{}, i_row2{};
    if constexpr (cover == Cover::Int) {
        const Ints e1 = Ints(static_cast<std::int32_t>(first1)) + lane_numbers() * Ints(i_step1),
                   e2 = Ints(static_cast<std::int32_t>(first2)) + lane_numbers() * Ints(i_step2);
        i_row1 = e1 - bias1, i_row2 = e2 - bias2;
        i_row0 = Ints(static_cast<std::int32_t>(s.area[k])) - e1 - e2 - bias0;
    }

    const Ints id_lanes(static_cast<std::int32_t>(id));
    const int columns = s.x1[k] - s.x0[k] + 1, rows = s.y1[k] - s.y0[k] + 1;
    const Bools last_columns = first_lanes((columns - 1) % lanes + 1);
    float* near_row = tile.nearness + s.y0[k] * tile.stride + s.x0[k];
    std::uint32_t* visible_row = tile.visible + s.y0[k] * tile.stride + s.x0[k];
    for (int y = 0; y < rows; ++y) {
        Doubles e1 = row1, e2 = row2;
        Ints i0 = i_row0, i1 = i_row1, i2 = i_row2;
        const auto group = [&](int x, Bools in_box) {
            Bools seen = in_box;
            if constexpr (cover == Cover::Int) {
                seen = seen && !is_negative(i0 | i1 | i2);
                if (!any(seen)) return;
            }
            if constexpr (cover == Cover::Double) {
                seen = seen && !is_negative(upper_words(area - e1 - e2 - wide_bias0) |
                                            upper_words(e1 - wide_bias1) | upper_words(e2 - wide_bias2));
                if (!any(seen)) return;
            }
            const Floats z = nearness(depth<Floats>(plane, {0.0, e1, e2}));
            const Floats stored = load(near_row + x);
            seen = seen && z > stored;
            if (!any(seen)) return;
            store(select(seen, z, stored), near_row + x);
            store(select(seen, id_lanes, load(visible_row + x)), visible_row + x);
        };
        int x = 0;
        for (; x + lanes < columns; x += lanes) {
            group(x, all_lanes());
            e1 = e1 + across1, e2 = e2 + across2;
            if constexpr (cover == Cover::Int)
                i1 = i1 + i_across1, i2 = i2 + i_across2, i0 = i0 - i_across1 - i_across2;
        }
        group(x, last_columns);
        row1 = row1 + down1, row2 = row2 + down2;
        if constexpr (cover == Cover::Int)
            i_row1 = i_row1 + i_down1, i_row2 = i_row2 + i_down2, i_row0 = i_row0 - i_down1 - i_down2;
        near_row += tile.stride, visible_row += tile.stride;
    }
}

// The rows of triangle k, the cheapest way that is exact.
RELEVO_LANE void cover_triangle(const StoredSetup& s, int k, bool small, std::uint32_t id,
                                const Nearness& nearness, const TileMemory& tile) {
    const double px = s.left[k], py = s.above[k];
    const double e1 = px * s.dy2[k] - py * s.dx2[k], e2 = s.dx1[k] * py - s.dy1[k] * px;
    if (small) return cover_rows<Cover::Int>(s, k, id, nearness, tile, e1, e2);

    const double width = s.x1[k] - s.x0[k], height = s.y1[k] - s.y0[k];
    const double step1 = 256.0 * s.dy2[k], step2 = -256.0 * s.dy1[k], down1 = -256.0 * s.dx2[k],
                 down2 = 256.0 * s.dx1[k];
    bool touches = true, crosses = false;  // the box
    const auto edge = [&](double e, double step, double down, double bias) {
        const double across = step * width, along = down * height;
        touches = touches && e + (across > 0 ? across : 0) + (along > 0 ? along : 0) >= bias;
        crosses = crosses || e + (across < 0 ? across : 0) + (along < 0 ? along : 0) < bias;
    };
    edge(s.area[k] - e1 - e2, -step1 - step2, -down1 - down2, s.bias0[k]);
    edge(e1, step1, down1, s.bias1[k]);
    edge(e2, step2, down2, s.bias2[k]);
    if (!touches) return;
    if (crosses)
        cover_rows<Cover::Double>(s, k, id, nearness, tile, e1, e2);
    else
        cover_rows<Cover::All>(s, k, id, nearness, tile, e1, e2);
}

// N triangles of the tile, corners staged side by side.
RELEVO_LANE void cover_group(const DrawState& draw, const TileMemory& tile, const TileBox& box,
                             const SnappedCorner* corner0, const SnappedCorner* corner1,
                             const SnappedCorner* corner2, const std::uint32_t* ids, int count_in_group) {
    const auto [c0, c1, c2] =
        canonical_order(load_corners(corner0), load_corners(corner1), load_corners(corner2));
    const auto triangle = make_triangle<Floats>(c0, c1, c2);
    const auto plane = make_interpolator(triangle);
    const Ints dx1 = c1.x - c0.x, dy1 = c1.y - c0.y, dx2 = c2.x - c0.x, dy2 = c2.y - c0.y;

    const Ints left = min(c0.x, min(c1.x, c2.x)), right = max(c0.x, max(c1.x, c2.x));
    const Ints top = c0.y, bottom = max(c1.y, c2.y);
    const Ints x0 = max(shift_right<8>(left + Ints(127)), Ints(box.x0)),
               y0 = max(shift_right<8>(top + Ints(127)), Ints(box.y0)),
               x1 = min(shift_right<8>(right - Ints(128)), Ints(box.x0 + box.width - 1)),
               y1 = min(shift_right<8>(bottom - Ints(128)), Ints(box.y0 + box.height - 1));
    const Bools valid = first_lanes(count_in_group) & !(x0 > x1 || y0 > y1);
    const Bools small = max(right - left, bottom - top) < Ints(max_small_extent);
    const Ints columns = x1 - x0 + Ints(1), rows = y1 - y0 + Ints(1);
    const Bools tiny = small & (columns < Ints(tiny_pixels + 1)) & (rows < Ints(tiny_pixels + 1)) &
                       (columns * rows < Ints(tiny_pixels + 1));

    const Ints px = shift_left<8>(x0) + Ints(128) - c0.x, py = shift_left<8>(y0) + Ints(128) - c0.y;
    const Ints bias0 = bias_of(dx2 - dx1, dy2 - dy1), bias1 = bias_of(Ints(0) - dx2, Ints(0) - dy2),
               bias2 = bias_of(dx1, dy1);
    const Nearness nearness{Ints(draw.settings.depth == DepthFormat::Float32Reversed ? 0 : INT32_MIN)};

    const std::uint32_t valid_bits = bits(valid);
    if (bits(tiny & valid) == valid_bits) {
        // a lane each: all boxes are walked at once, row by row
        const Ints step1 = shift_left<8>(dy2), step2 = Ints(0) - shift_left<8>(dy1);
        const Ints down1 = Ints(0) - shift_left<8>(dx2), down2 = shift_left<8>(dx1);
        const Ints area32 = truncated(select(small, triangle.area, Doubles(0.0)));
        Ints row1 = px * dy2 - py * dx2, row2 = dx1 * py - dy1 * px;
        Ints e1 = row1, e2 = row2, x = x0, y = y0;
        Ints place = (y0 - Ints(box.y0)) * Ints(tile.stride) + (x0 - Ints(box.x0));
        Bools walking = valid;
        while (any(walking)) {
            const Ints e0 = area32 - e1 - e2;
            const Bools covered = walking & !is_negative((e0 - bias0) | (e1 - bias1) | (e2 - bias2));
            std::uint32_t fragments = bits(covered);
            if (fragments != 0) {
                alignas(64) float z_of[lanes];
                alignas(64) std::int32_t place_of[lanes];
                store(nearness(depth<Floats>(plane, {0.0, to_wide(e1), to_wide(e2)})), z_of);
                store(place, place_of);
                do {
                    const int k = std::countr_zero(fragments);
                    float& stored = tile.nearness[place_of[k]];
                    std::uint32_t& seen = tile.visible[place_of[k]];
                    if (z_of[k] > stored ||
                        (z_of[k] == stored && seen != nothing && is_before(draw, ids[k], seen)))
                        stored = z_of[k], seen = ids[k];
                    fragments &= fragments - 1;
                } while (fragments != 0);
            }
            const Bools at_end = x == x1;
            row1 = select(at_end, row1 + down1, row1), row2 = select(at_end, row2 + down2, row2);
            e1 = select(at_end, row1, e1 + step1), e2 = select(at_end, row2, e2 + step2);
            place = place + select(at_end, Ints(tile.stride) - columns + Ints(1), Ints(1));
            x = select(at_end, x0, x + Ints(1)), y = select(at_end, y + Ints(1), y);
            walking = walking & !(y > y1);
        }
        return;
    }

    StoredSetup s;
    store(plane.z0, s.z0), store(plane.g1, s.g1), store(plane.g2, s.g2), store(triangle.area, s.area);
    store(x0 - Ints(box.x0), s.x0), store(x1 - Ints(box.x0), s.x1);
    store(y0 - Ints(box.y0), s.y0), store(y1 - Ints(box.y0), s.y1);
    store(px, s.left), store(py, s.above);
    store(dx1, s.dx1), store(dy1, s.dy1), store(dx2, s.dx2), store(dy2, s.dy2);
    store(bias0, s.bias0), store(bias1, s.bias1), store(bias2, s.bias2);
    const std::uint32_t small_bits = bits(small);
    for (std::uint32_t rest = valid_bits; rest != 0; rest &= rest - 1) {
        const int k = std::countr_zero(rest);
        cover_triangle(s, k, small_bits >> k & 1, ids[k], nearness, tile);
    }
}

// Reads the ids of a tile in drawing order: chunk after chunk, each list merged with the chunk's wide ones.
class TileReader {
  public:
    RELEVO_LANE TileReader(const DrawState& draw, const Chunk* chunks, int chunk_count, int tile)
        : draw_(draw), chunk_(chunks), end_(chunks + chunk_count), tile_(tile) {
        open();
    }
    // Fills `ids` with at most `room` ids; 0 at the end.
    RELEVO_LANE int read(std::uint32_t* ids, int room) {
        int n = 0;
        while (n < room && chunk_ != end_) {
            if (listed_ == 0 && wide_ == chunk_->wide_count) {
                ++chunk_;
                open();
                continue;
            }
            const bool take_wide =
                wide_ < chunk_->wide_count &&
                (listed_ == 0 || is_before(draw_, chunk_->wide[wide_], block_->ids[place_]));
            if (take_wide) {
                ids[n++] = chunk_->wide[wide_++];
                continue;
            }
            ids[n++] = block_->ids[place_];
            --listed_;
            if (++place_ == Block::capacity && listed_ > 0)
                block_ = &chunk_->blocks[block_->next], place_ = 0;
        }
        return n;
    }

  private:
    RELEVO_LANE void open() {
        if (chunk_ == end_) return;
        const TileList& list = chunk_->lists[tile_];
        listed_ = list.count, wide_ = 0, place_ = 0;
        if (listed_ > 0) block_ = &chunk_->blocks[list.first];
    }
    const DrawState& draw_;
    const Chunk *chunk_, *end_;
    int tile_;
    const Block* block_ = nullptr;
    std::uint32_t listed_ = 0, wide_ = 0, place_ = 0;
};

inline constexpr int cover_batch = 64;

// Copies the corners of the triangles side by side; they are of any models, whole or pieces.
RELEVO_LANE void stage_corners(const DrawState& draw, const std::uint32_t* ids, int n,
                               SnappedCorner (&staged)[3][cover_batch + 16]) {
    std::uint32_t model_first = 1, model_last = 0;  // of the model at hand: none yet
    const ModelState* model = nullptr;
    for (int k = 0; k < n; ++k) {
        const std::uint32_t id = ids[k];
        if (id & piece_bit) {
            const Piece& p = piece(draw, id);
            for (int corner = 0; corner < 3; ++corner) copy_corner(p.window[corner], staged[corner][k]);
            continue;
        }
        if (!(model_first <= id && id < model_last)) {
            model = &draw.models[model_of(draw, id)];
            model_first = model->first_primitive, model_last = model_first + model->triangles;
        }
        const std::uint32_t* index = &model->indices[3 * (std::size_t{id} - model_first)];
        for (int corner = 0; corner < 3; ++corner)
            copy_corner(model->window[index[corner]], staged[corner][k]);
    }
}

// Draws the tile's triangles into its memory; false when nothing touches it (the memory is untouched then).
RELEVO_LANE bool cover_tile(const DrawState& draw, const Chunk* chunks, int chunk_count,
                            const TileScratch& scratch, int tile_number, const TileBox& box) {
    const TileMemory& tile = scratch.tile;
    TileReader reader(draw, chunks, chunk_count, tile_number);
    bool touched = false;
    for (;;) {
        const int in_batch = reader.read(scratch.ids, tile_batch);
        if (in_batch == 0) return touched;
        if (!touched) {
            const Floats cleared(draw.settings.depth == DepthFormat::Float32Reversed ? 0.f : -1.f);
            for (int k = 0; k < box.height * tile.stride; k += lanes) {
                store(cleared, tile.nearness + k);
                store(Ints(static_cast<std::int32_t>(nothing)), tile.visible + k);
            }
            touched = true;
        }
        alignas(64) SnappedCorner staged[3][cover_batch + 16];
        for (int first = 0; first < in_batch; first += cover_batch) {
            const int n = in_batch - first < cover_batch ? in_batch - first : cover_batch;
            stage_corners(draw, scratch.ids + first, n, staged);
            for (int k = 0; k < n; k += lanes)
                cover_group(draw, tile, box, &staged[0][k], &staged[1][k], &staged[2][k],
                            scratch.ids + first + k, n - k < lanes ? n - k : lanes);
        }
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
