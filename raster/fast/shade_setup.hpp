// The set-up of shading: what the pixels of a triangle need to know of it, N triangles at a time, a lane
// each.
//
//   ids -> corners in the window, canonical order -> edge values, 1 / w, and planes of what the corners carry
//
// Fragments take from the lanes what they need at once (shade_fragments.hpp), blocks of pixels keep them for
// those to come (kept_setups.hpp).
#pragma once
#include "raster/fast/corners.hpp"
#include "raster/fast/draw_state.hpp"
#include "raster/fast/lanes.hpp"
#include "raster/fast/load_quads.hpp"
#include "raster/interpolate.hpp"
#include "raster/output.hpp"
#include "raster/shading.hpp"
#include "raster/triangle_edge.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

using pipeline::RgbOf;
using pipeline::Vec3Of;

// ------------------------------------------------------------------------------------------------ lanes
template <class Program, class Real>
using FaceOf = std::conditional_t<Program::needs_face, pipeline::ReflectionOf<Real>, typename Program::Face>;
template <class Program>
using LaneFace = FaceOf<Program, Floats>;

template <class Program>
struct LaneSetup {
    Ints x0, y0;                       // corner 0, in 1/256 pixel
    Doubles dx1, dy1, dx2, dy2, area;  // exact
    Floats rw0, rw1, rw2;
    Floats carried[3][Program::size + 1];  // (no array has size 0)
    LaneFace<Program> face;

    RELEVO_LANE VaryingPlane<1, Floats> plane(std::size_t k) const {
        return make_plane<1, Floats>({carried[0][k]}, {carried[1][k]}, {carried[2][k]});
    }
};

// Triangles of one model: the ids and, of each, its primitive. They differ for pieces.
struct LaneIds {
    Ints id, primitive;
    bool pieces;  // whether there is any
};

// What the vertices carry; offset: vertex * stride / 2.
template <class Program>
RELEVO_LANE void load_carried(const Scalar* from, const std::uint32_t (&offset)[lanes], Floats* a) {
    const auto part = [&](std::size_t first) RELEVO_INSIDE {
        const Quad q = load_quads(from + first, offset);
        const Floats four[4] = {q.a, q.b, q.c, q.d};
        for (std::size_t j = first; j < Program::size && j < first + 4; ++j) a[j] = four[j - first];
    };
    part(0);
    if constexpr (Program::size > 4) part(4);
}

// Vertices of the mesh; offset: 4 times their number.
RELEVO_LANE Vec3Of<Floats> eye_position(const ModelState& model, const std::uint32_t (&offset)[lanes]) {
    const Quad q = load_quads(model.vertices.data(), offset);
    return moved_point<Floats>(model.setup.eye_from_object.row, {q.a, q.b, q.c});
}
// What they carry to a back face that is lit by its own normal.
template <class Program>
RELEVO_LANE std::array<Floats, Program::size> carried_to_back(const ModelState& model,
                                                              const std::uint32_t (&offset)[lanes]) {
    const auto* from = reinterpret_cast<const float*>(model.vertices.data());
    const Quad px_nx = load_quads(from, offset), ny_v = load_quads(from + 4, offset);
    return varying_of<Program, Floats>(model.setup, {px_nx.a, px_nx.b, px_nx.c}, {px_nx.d, ny_v.a, ny_v.b},
                                       {ny_v.c, ny_v.d}, true);
}

// Pieces stand elsewhere: they replace what was read of the mesh, lane by lane. This is rare, so it is kept
// out of the way.
struct PieceLanes {
    alignas(64) std::uint32_t id[lanes];
    alignas(64) std::int32_t x[3][lanes], y[3][lanes], turn[lanes];
    alignas(64) float rw[3][lanes], carried[3][max_carried][lanes];
};
template <class Visit>
RELEVO_LANE void for_each_piece(const DrawState& draw, const PieceLanes& p, Visit&& visit) {
    Piece again;
    for (int k = 0; k < lanes; ++k)
        if (p.id[k] & piece_bit) visit(k, piece(draw, p.id[k], again));
}
[[gnu::noinline]] static void read_corners(const DrawState& draw, PieceLanes& p) {
    for_each_piece(draw, p, [&](int k, const Piece& from) {
        for (int c = 0; c < 3; ++c) {
            const SnappedCorner& corner = from.window[c];
            p.x[c][k] = corner.x, p.y[c][k] = corner.y, p.rw[c][k] = corner.rw;
        }
    });
}
[[gnu::noinline]] static void read_carried(const DrawState& draw, PieceLanes& p, std::size_t size) {
    for_each_piece(draw, p, [&](int k, const Piece& from) {
        for (int c = 0; c < 3; ++c)
            for (std::size_t j = 0; j < size; ++j) p.carried[c][j][k] = from.carried[(p.turn[k] + c) % 3][j];
    });
}

// How the corners stand in the window, of N triangles.
struct LaneOrder {
    Bools one, two;  // corner 0 is the mesh's 1, or 2
    Bools back;      // is seen
};

// The numbers of the vertices, in the order of the mesh.
RELEVO_LANE std::array<Ints, 3> vertices_of(const ModelState& model, const LaneIds& ids) {
    const Ints local = ids.primitive - Ints(static_cast<std::int32_t>(model.first_primitive));
    const Ints first_index = local + local + local;
    const auto corner = [&](int c) RELEVO_INSIDE { return gather(model.indices.data() + c, first_index); };
    return {corner(0), corner(1), corner(2)};
}

// What the corners of the triangles `ids` of the model carry, and their faces' light.
template <class Program>
RELEVO_LANE void load_carried(const DrawState& draw, const ModelState& model, const LaneIds& ids,
                              const std::array<Ints, 3>& corner, const LaneOrder& order,
                              LaneSetup<Program>& s) {
    constexpr std::size_t size = Program::size;
    if constexpr (size == 0 && !Program::needs_face) return;

    alignas(64) std::uint32_t offset[3][lanes];
    if constexpr (size > 0) {
        const std::array<Ints, 3> ordered = in_order(order.one, order.two, corner[0], corner[1], corner[2]);
        for (int c = 0; c < 3; ++c) {
            store(size > 4 ? shift_left<2>(ordered[std::size_t(c)]) : shift_left<1>(ordered[std::size_t(c)]),
                  offset[c]);
            load_carried<Program>(model.carried, offset[c], s.carried[c]);
        }
        if (ids.pieces) {
            PieceLanes pieces;
            store(ids.id, pieces.id);
            store(select(order.two, Ints(2), select(order.one, Ints(1), Ints(0))), pieces.turn);
            for (int c = 0; c < 3; ++c)
                for (std::size_t j = 0; j < size; ++j) store(s.carried[c][j], pieces.carried[c][j]);
            read_carried(draw, pieces, size);
            for (int c = 0; c < 3; ++c)
                for (std::size_t j = 0; j < size; ++j) s.carried[c][j] = load(pieces.carried[c][j]);
        }
        if constexpr (Program::needs_eye) {
            const Bools turned = order.back && !is_negative(ids.id);  // a piece already carries its side's
            if (model.setup.both_sides && any(turned)) {
                for (int c = 0; c < 3; ++c) {
                    store(shift_left<2>(ordered[std::size_t(c)]), offset[c]);
                    const std::array<Floats, size> other = carried_to_back<Program>(model, offset[c]);
                    for (std::size_t j = 0; j < size; ++j)
                        s.carried[c][j] = select(turned, other[j], s.carried[c][j]);
                }
            }
        }
    }
    if constexpr (Program::needs_face) {
        for (int c = 0; c < 3; ++c) store(shift_left<2>(corner[std::size_t(c)]), offset[c]);
        s.face = reflect_face<Floats>(
            model.setup.surface,
            {eye_position(model, offset[0]), eye_position(model, offset[1]), eye_position(model, offset[2])},
            order.back, model.setup.mirrored);
    }
}

// The triangles `ids` of the model, in every lane one.
template <class Program>
RELEVO_LANE LaneSetup<Program> set_up(const DrawState& draw, const ModelState& model, const LaneIds& ids) {
    LaneSetup<Program> s;
    if constexpr (Program::size == 0 && !Program::needs_face) return s;
    LaneOrder order{first_lanes(0), first_lanes(0), first_lanes(0)};
    const std::array<Ints, 3> corner = vertices_of(model, ids);
    if (Program::size > 0 || model.setup.surface.two_sided) {
        LaneCorner window[3];
        for (int c = 0; c < 3; ++c) {
            alignas(64) std::uint32_t offset[lanes];
            store(shift_left<1>(corner[std::size_t(c)]), offset);
            window[c] = corner_of(load_quads(model.window, offset));
        }
        if (ids.pieces) {
            PieceLanes pieces;
            store(ids.id, pieces.id);
            for (int c = 0; c < 3; ++c)
                store(window[c].x, pieces.x[c]), store(window[c].y, pieces.y[c]),
                    store(window[c].rw, pieces.rw[c]);
            read_corners(draw, pieces);
            for (int c = 0; c < 3; ++c)
                window[c] = {load(pieces.x[c]), load(pieces.y[c]), window[c].z, load(pieces.rw[c])};
        }
        const OrderedTriangles t = canonical_order(window[0], window[1], window[2]);
        order = {t.one, t.two, model.setup.mirrored ? t.negative : !t.negative};
        s.x0 = t.c0.x, s.y0 = t.c0.y, s.rw0 = t.c0.rw, s.rw1 = t.c1.rw, s.rw2 = t.c2.rw;
        s.dx1 = to_wide(t.dx1), s.dy1 = to_wide(t.dy1), s.dx2 = to_wide(t.dx2), s.dy2 = to_wide(t.dy2);
        s.area = t.area;
    }
    load_carried(draw, model, ids, corner, order, s);
    return s;
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

// Edge values at the centres of the pixels (x, y).
template <class Program>
RELEVO_LANE EdgeValuesOf<Floats> edge_values(const LaneSetup<Program>& s, Ints x, Ints y) {
    const Doubles px = to_wide(shift_left<8>(x) + Ints(128) - s.x0),
                  py = to_wide(shift_left<8>(y) + Ints(128) - s.y0);
    const Doubles positive_zero = 0.0;  // an edge value of 0 is +0, as a whole number's is
    const Doubles e1 = (px * s.dy2 - py * s.dx2) + positive_zero,
                  e2 = (s.dx1 * py - s.dy1 * px) + positive_zero;
    return {s.area - e1 - e2, e1, e2};
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
