// The perspective weights of a block's pixels, and the planes they weigh, from kept set-ups
// (kept_setups.hpp).
//
//   one triangle   a run of blocks of a row: edge values at the first, and a step to each further one
//   mixed          each lane takes the planes of the triangle that it shows, and puts its own pixel in
#pragma once
#include "raster/fast/kept_setups.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// A row of a group, a column a triangle: one column's number in all lanes, or in each lane its own column's.
struct OneColumn {
    std::uint32_t number;
    template <class T>
    RELEVO_LANE T operator()(const T* row) const {
        return row[number];
    }
};
struct OwnColumn {
    Picked picked;
    template <class T>
    RELEVO_LANE auto operator()(const T* row) const {
        return picked(load(row));
    }
};

template <class Program>
struct CarriedPlanes {
    VaryingPlane<Program::size, Floats> plane;
    LaneFace<Program> face;
};
template <class Program, class Column>
RELEVO_LANE CarriedPlanes<Program> carried_planes(const SetupGroup& g, const Column& of) {
    CarriedPlanes<Program> c;
    for (std::size_t j = 0; j < Program::size; ++j)
        c.plane.a0[j] = of(g.plane[j][0]), c.plane.d1[j] = of(g.plane[j][1]),
        c.plane.d2[j] = of(g.plane[j][2]);
    if constexpr (Program::needs_face)
        c.face = {{of(g.face[0]), of(g.face[1]), of(g.face[2])},
                  {of(g.face[3]), of(g.face[4]), of(g.face[5])}};
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

// Calls use() with what is known of the light: in the type, so that each has code of its own.
template <class Use>
RELEVO_LANE void with_light_of(bool displayable, Use&& use) {
    displayable ? use(std::integral_constant<Light, Light::Displayable>())
                : use(std::integral_constant<Light, Light::Any>());
}

// Of pixels that are lit at the corners. Number after number: an array of all would be written to memory.
template <class Program>
RELEVO_LANE RgbOf<Floats> color_at(const Surface& surface, const CarriedPlanes<Program>& planes,
                                   const PerspectiveWeightsOf<Floats>& weights) {
    Floats carried[Program::size];
    for (std::size_t j = 0; j < Program::size; ++j) {
        const auto& [a0, d1, d2] = planes.plane;
        carried[j] = interpolate(VaryingPlane<1, Floats>{{a0[j]}, {d1[j]}, {d2[j]}}, weights)[0];
    }
    return Program::template pixel<Floats>(surface, planes.face, carried);
}

// ------------------------------------------------------------------------------------------ one triangle
// At one block of a row after the other.
struct RunOfBlocks {
    Doubles e0, e1, e2;
    double step0, step1, step2;
    Interpolator corners;

    RELEVO_LANE RunOfBlocks(const SetupGroup& g, OneColumn of, int row, int column) {
        const Doubles x = to_wide(lane_columns()), y = to_wide(lane_rows());
        const auto edge = [&](const auto& first, const auto& across, const auto& down,
                              double& step) RELEVO_INSIDE {
            step = block_columns * of(across);
            return (x * of(across) + y * of(down)) + (of(first) + (column * of(across) + row * of(down)));
        };
        e1 = edge(g.edges[0], g.edges[1], g.edges[2], step1);
        e2 = edge(g.edges[3], g.edges[4], g.edges[5], step2);
        e0 = of(g.edges[6]) - e1 - e2, step0 = -(step1 + step2);
        corners = {0, 0, 0, of(g.rw[0]), of(g.rw[1]), of(g.rw[2])};
    }
    RELEVO_LANE PerspectiveWeightsOf<Floats> weights() const {
        return perspective_weights<Floats>(corners, EdgeValuesOf<Floats>{e0, e1, e2});
    }
    RELEVO_LANE void next() { e0 = e0 + step0, e1 = e1 + step1, e2 = e2 + step2; }
};

// ------------------------------------------------------------------------------------------------ mixed
// Number: Doubles or, where all triangles are small, Ints, of which a register holds twice as many.
template <class Number>
struct EdgePlanes {
    Number e1, across1, down1, e2, across2, down2, area;
    Floats rw0, rw1, rw2;
};
template <class Number>
RELEVO_LANE EdgePlanes<Number> edge_planes(const SetupGroup& g, const OwnColumn& of) {
    const auto planes = [&](const auto& e) RELEVO_INSIDE {
        return EdgePlanes<Number>{of(e[0]), of(e[1]), of(e[2]),    of(e[3]),    of(e[4]),
                                  of(e[5]), of(e[6]), of(g.rw[0]), of(g.rw[1]), of(g.rw[2])};
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
// At the pixels (x, y).
template <class Number>
RELEVO_LANE PerspectiveWeightsOf<Floats> weights_at(const EdgePlanes<Number>& p, Ints x, Ints y) {
    const auto as_number = [](Ints a) RELEVO_INSIDE {
        if constexpr (std::is_same_v<Number, Ints>)
            return a;
        else
            return to_wide(a);
    };
    const auto across = as_number(x), down = as_number(y);
    const auto e1 = p.e1 + across * p.across1 + down * p.down1,
               e2 = p.e2 + across * p.across2 + down * p.down2;
    return perspective_weights<Floats>(
        InterpolatorOf<Floats>{{}, {}, {}, to_wide(p.rw0), to_wide(p.rw1), to_wide(p.rw2)},
        EdgeValuesOf<Floats>{to_wide(p.area - e1 - e2), to_wide(e1), to_wide(e2)});
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
