// Stage 2 of the fast path: N triangles at a time are culled and listed in the tiles that their boxes touch.
//
//   indices  i0 i1 i2 | i0 i1 i2 | ...   -> the corners in the window, a triangle a lane
//   lanes    area, facing, box (cut to the picture)   -> ids in the tiles' lists, in their order
//
// Dropped here, by proof: what faces the wrong way, has no area, holds no pixel centre in its box, or holds a
// single one that it does not cover. Nothing is kept of a triangle but its number: computing its set-up again
// costs less than writing and reading it.
#pragma once
#include "raster/fast/bins.hpp"
#include "raster/fast/corners.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// Whether the only centre in the box (pixel x, y) is covered, for extents below max_small_extent.
RELEVO_LANE Bools covers_centre(const LaneCorner& a, const LaneCorner& b, const LaneCorner& c, Bools negative,
                                Ints x, Ints y) {
    const LaneCorner p = a, q = select(negative, c, b), r = select(negative, b, c);  // positive area
    const Ints px = shift_left<8>(x) + Ints(128), py = shift_left<8>(y) + Ints(128);
    const auto inside = [&](const LaneCorner& s, const LaneCorner& t) {
        const Ints dx = t.x - s.x, dy = t.y - s.y;
        const Ints value = dx * (py - s.y) - dy * (px - s.x);
        return !is_negative(select(is_top_left(dx, dy), value, value - Ints(1)));
    };
    return inside(p, q) & inside(q, r) & inside(r, p);
}

// The corners of N triangles in a row; index: 3 N numbers of vertices.
RELEVO_LANE GroupCorners mesh_corners(const SnappedCorner* window, const std::uint32_t* index) {
    const auto corners = [&](int c) RELEVO_INSIDE {
        return corner_of(load_quads(
            [&](int k) RELEVO_INSIDE { return reinterpret_cast<const float*>(window + index[3 * k + c]); }));
    };
    return {corners(0), corners(1), corners(2), nullptr, {}};
}

RELEVO_LANE void bin_group(const DrawState& draw, Chunk& chunk, const ModelState& model,
                           const GroupCorners& corners, std::uint32_t primitive, int count_in_group,
                           int tile_bits) {
    const LaneCorner &a = corners.a, &b = corners.b, &c = corners.c;
    const Bools valid = first_lanes(count_in_group);
    const Bools coded = (a.rw == 0 || b.rw == 0 || c.rw == 0) && valid;

    const Ints upper =
        upper_words(area2<Floats>(a, b, c));  // all 0 but the sign for an area of 0 or -0, else |area| >= 1
    const Bools zero = shift_left<1>(upper) == Ints(0), negative = is_negative(upper);
    const Bools drawable = valid & !coded;
    const Bools front = model.setup.mirrored ? !negative : negative;
    Bools culled{};
    switch (draw.settings.cull) {
        case pipeline::Cull::None:
            culled = first_lanes(0);
            break;
        case pipeline::Cull::Back:
            culled = drawable & !zero & !front;
            break;
        case pipeline::Cull::Front:
            culled = drawable & !zero & front;
            break;
    }
    const auto reject = [&](Rejection reason, Bools which) RELEVO_INSIDE {
        chunk.counts.rejected[static_cast<int>(reason)] += static_cast<unsigned>(count(which));
    };
    reject(Rejection::Culled, culled);
    if (bits(culled) == bits(valid)) return;  // neighbours of a mesh mostly face the same way

    const Ints left = min(a.x, min(b.x, c.x)), right = max(a.x, max(b.x, c.x));
    const Ints top = min(a.y, min(b.y, c.y)), bottom = max(a.y, max(b.y, c.y));
    const Ints x0 = max(shift_right<8>(left + Ints(127)), Ints(0)),
               y0 = max(shift_right<8>(top + Ints(127)), Ints(0)),
               x1 = min(shift_right<8>(right - Ints(128)), Ints(draw.viewport.width - 1)),
               y1 = min(shift_right<8>(bottom - Ints(128)), Ints(draw.viewport.height - 1));
    const Bools no_pixel = x0 > x1 || y0 > y1;
    const Bools flat = drawable & zero, empty = drawable & !zero & !culled & no_pixel;
    reject(Rejection::ZeroArea, flat), reject(Rejection::NoPixel, empty);

    Bools drawn = drawable & !(flat | culled | empty);
    const Bools small = max(right - left, bottom - top) < Ints(max_small_extent);
    const Bools single = drawn & small & (x0 == x1) & (y0 == y1);
    if (any(single)) drawn = drawn & !(single & !covers_centre(a, b, c, negative, x0, y0));

    const std::uint32_t coded_bits = bits(coded);
    std::uint32_t left_to_do = bits(drawn) | coded_bits;
    if (left_to_do == 0) return;
    const Ints tile_x0 = x0 >> tile_bits, tile_y0 = y0 >> tile_bits, tile_x1 = x1 >> tile_bits,
               tile_y1 = y1 >> tile_bits;
    alignas(64) std::int32_t from_x[lanes], from_y[lanes], to_x[lanes], to_y[lanes];
    store(tile_x0, from_x), store(tile_y0, from_y);
    const int first_lane = std::countr_zero(left_to_do);
    // Neighbours of a mesh mostly lie in the same tile.
    const Ints x(from_x[first_lane]), y(from_y[first_lane]);
    if (coded_bits == 0 && !any(drawn && !(tile_x0 == x && tile_x1 == x && tile_y0 == y && tile_y1 == y))) {
        TileList& list = chunk.lists[from_y[first_lane] * draw.tiles_across + from_x[first_lane]];
        if (list.room >= lanes) {
            const Ints ids = Ints(static_cast<std::int32_t>(primitive)) + lane_numbers();
            store(compress(ids, drawn), chunk.words + list.end);
            const std::uint32_t n = static_cast<std::uint32_t>(std::popcount(left_to_do));
            list.end += n, list.room -= n, list.count += n;
            return;
        }
    }
    store(tile_x1, to_x), store(tile_y1, to_y);
    for (; left_to_do != 0; left_to_do &= left_to_do - 1) {
        const int k = std::countr_zero(left_to_do);
        const std::uint32_t id = primitive + static_cast<std::uint32_t>(k);
        if (coded_bits >> k & 1)
            clip_into_bins(draw, chunk, model, id);
        else if (from_x[k] == to_x[k] && from_y[k] == to_y[k])
            append(chunk, from_y[k] * draw.tiles_across + from_x[k], id);
        else
            append(draw, chunk, id, from_x[k], from_y[k], to_x[k], to_y[k]);
    }
}

RELEVO_LANE void bin_triangles(const DrawState& draw, Chunk& chunk) {
    const int tile_bits = std::countr_zero(static_cast<unsigned>(draw.tile));
    for (const ModelState& model : draw.models) {
        const std::uint32_t first = std::max(chunk.first, model.first_primitive),
                            last = std::min(chunk.last, model.first_primitive + model.triangles);
        for (std::uint32_t primitive = first; primitive < last; primitive += lanes) {
            const int n = static_cast<int>(std::min<std::uint32_t>(lanes, last - primitive));
            const std::uint32_t* index = &model.indices[3 * (std::size_t{primitive} - model.first_primitive)];
            std::uint32_t some[3 * lanes];
            if (n < lanes) {
                for (int k = 0; k < 3 * lanes; ++k) some[k] = index[std::min(k, 3 * n - 1)];
                index = some;
            }
            bin_group(draw, chunk, model, mesh_corners(model.window, index), primitive, n, tile_bits);
        }
        if (last > first) chunk.counts.triangles += last - first;
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
