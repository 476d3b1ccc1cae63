// Stage 3 of the fast path: coverage and depth of a tile's triangles. What is left is a visibility buffer:
//
//   nearness   of each pixel (greater is nearer)          rows of `stride`, a little longer than the tile
//   visible    of each pixel: its triangle, by the place in the tile's list of ids (and fragments.hpp's
//              kept_bit)
//
// Where tiles are painted (paint_triangles.hpp), colours stand in place of `visible`.
//
// Set-up is N triangles at a time, a lane each; then small ones together (cover_boxes.hpp) and others alone
// (cover_strips.hpp), all exactly as the textbook path. Groups, and triangles in strips, are drawn in
// their order, so that strict comparison keeps the first of equal depths; within a group of boxes the number
// decides.
#pragma once
#include "raster/fast/cover_boxes.hpp"
#include "raster/fast/cover_strips.hpp"
#include "raster/fast/paint_triangles.hpp"
#include "raster/fast/read_bins.hpp"
#include "raster/fast/stages.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

RELEVO_LANE Ints bias_of(Ints dx, Ints dy) { return select(is_top_left(dx, dy), Ints(0), Ints(1)); }

// N triangles of the tile.
template <class Painter>
RELEVO_LANE void cover_group(Painter& painter, const TileAt& at, const GroupCorners& corners,
                             std::uint32_t first_number, int count_in_group) {
    const DrawState& draw = at.draw;
    TileScratch& scratch = at.scratch;
    const TileBox& box = at.box;
    const TileMemory& tile = scratch.tile;
    const Nearness nearness = nearness_of(draw);
    const auto triangle = canonical_order(corners.a, corners.b, corners.c);
    const LaneCorner &c0 = triangle.c0, &c1 = triangle.c1, &c2 = triangle.c2;
    const Ints dx1 = triangle.dx1, dy1 = triangle.dy1, dx2 = triangle.dx2, dy2 = triangle.dy2;
    const auto plane = make_interpolator(triangle);

    const Ints left = min(c0.x, min(c1.x, c2.x)), right = max(c0.x, max(c1.x, c2.x));
    const Ints top = c0.y, bottom = max(c1.y, c2.y);
    const Ints x0 = max(shift_right<8>(left + Ints(127)), Ints(box.x0)),
               y0 = max(shift_right<8>(top + Ints(127)), Ints(box.y0)),
               x1 = min(shift_right<8>(right - Ints(128)), Ints(box.x0 + box.width - 1)),
               y1 = min(shift_right<8>(bottom - Ints(128)), Ints(box.y0 + box.height - 1));
    const Bools valid = first_lanes(count_in_group) & !(x0 > x1 || y0 > y1);
    const Bools small = max(right - left, bottom - top) < Ints(max_small_extent);
    const Ints px = shift_left<8>(x0) + Ints(128) - c0.x, py = shift_left<8>(y0) + Ints(128) - c0.y;
    const Ints bias0 = bias_of(dx2 - dx1, dy2 - dy1), bias1 = bias_of(Ints(0) - dx2, Ints(0) - dy2),
               bias2 = bias_of(dx1, dy1);

    write_background_row(draw, scratch.background);
    const std::uint32_t valid_bits = bits(valid);
    if (valid_bits == 0) return;
    const Ints columns = select(valid, x1 - x0 + Ints(1), Ints(0)),
               rows = select(valid, y1 - y0 + Ints(1), Ints(0));
    const int most_columns = largest(columns), most_rows = largest(rows);
    if (most_columns * most_rows <= most_walked && bits(valid & small) == valid_bits) {
        const Ints e1 = px * dy2 - py * dx2, e2 = dx1 * py - dy1 * px;
        const Ints area = truncated(select(small, triangle.area, Doubles(0.0)));
        const BoxWalk walk{area,
                           e1,
                           e2,
                           shift_left<8>(dy2),
                           Ints(0) - shift_left<8>(dy1),
                           Ints(0) - shift_left<8>(dx2),
                           shift_left<8>(dx1),
                           bias0,
                           bias1,
                           bias2,
                           (y0 - Ints(box.y0)) * Ints(tile.stride) + (x0 - Ints(box.x0)),
                           columns,
                           rows};
        painter.stop(at);
        Fragments& fragments = scratch.fragments;
        if (is_full(fragments) && !fragments.stays_full) {
            drop_hidden(tile, fragments);
            fragments.stays_full =
                2 * fragments.end > fragments.room || 2 * fragments.group_count > group_room(fragments);
        }
        const bool keep = tile.visible != nullptr && !is_full(fragments);
        scratch.in_blocks |= !keep;
        return cover_boxes(tile, fragments, walk, corners, triangle, plane, nearness, first_number,
                           most_columns, most_rows, keep);
    }
    painter.expect(at, smaller(rounded(triangle.area * Doubles(0x1p-17)), to_real(columns * rows)));
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
        write_background_row(draw, scratch.background);
        const std::uint32_t number = first_number + static_cast<std::uint32_t>(k);
        const bool is_small = small_bits >> k & 1;
        if constexpr (!std::is_same_v<Painter, NoPainter>) {
            if (painter.paints()) {
                painter.paint(at, s, k, is_small, number, nearness);
                continue;
            }
        }
        scratch.in_blocks = true;
        ShowNumber show{Ints(static_cast<std::int32_t>(number)), tile.visible, tile.stride};
        cover_triangle(s, k, is_small, show, nearness, tile);
    }
}

// Draws the triangles of the list into the tile's memory, which is untouched when there are none.
template <class Painter>
RELEVO_LANE void cover_tile(Painter& painter, TileAt& at, TileIds& list) {
    const DrawState& draw = at.draw;
    TileScratch& scratch = at.scratch;
    const TileMemory& tile = scratch.tile;
    list.read(1);
    if (list.known() == 0) return;

    scratch.fragments.end = scratch.fragments.kept = scratch.fragments.group_count = 0;
    scratch.in_blocks = scratch.fragments.stays_full = scratch.painted = false;
    const Floats cleared = cleared_nearness(draw);
    const Ints none(static_cast<std::int32_t>(nothing));
    const bool shows_numbers = tile.visible != nullptr && !painter.paints();
    for (int k = 0, pixels = at.rows_of_blocks() * tile.stride; k < pixels; k += lanes) {
        store(cleared, tile.nearness + k);
        if (shows_numbers) store(none, tile.visible + k);
    }
    for (int first = 0; list.read(first + 2 * ids_ahead + lanes), first < list.known(); first += lanes) {
        at.listed = list.known();
        const int known = at.listed - first, n = known < lanes ? known : lanes;
        cover_group(painter, at, load_group(draw, scratch.ids + first, n, known),
                    static_cast<std::uint32_t>(first), n);
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
