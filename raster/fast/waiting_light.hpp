// Pixels wait for light, N in a register, until there are many registers; then come
//
//   directions   normal, viewer and first light of every register   (Phong: its roots and divisions)
//   light        of two registers at a time (twice.hpp), texture, output
//
// Light is a long chain of operations that wait for each other. A processor looks some hundred operations
// ahead: in short loops over independent registers it finds others to do meanwhile, in one long loop it would
// not.
#pragma once
#include <new>

#include "raster/fast/shade_setup.hpp"
#include "raster/fast/twice.hpp"
#include "raster/fast/write_pixels.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

// What reaches the pixels of one model from their triangles.
template <class P>
struct PixelNumbers {
    std::array<Floats, P::size> carried;
    LaneFace<P> face;
};

struct WaitingPixels {
    static constexpr int room = 16;
    alignas(64) float carried[room][max_carried][lanes], face[room][6][lanes], directions[room][9][lanes];
    PixelsTo to[room];
    int count = 0;
    const ModelState* model;  // of all
};
// Not on the stack: there it drove what shading keeps at hand apart, and cost small triangles 4 %.
RELEVO_LANE WaitingPixels& nobody_waits(const TileScratch& scratch) {
    static_assert(sizeof(WaitingPixels) <= waiting_bytes);
    return *new (scratch.waiting) WaitingPixels;
}

// Untextured, these are coloured at once: Gouraud's light is interpolated, and without anything carried all
// pixels of a triangle have one colour.
template <class P>
inline constexpr bool is_lit_at_once = std::is_same_v<P, Gouraud<false>> || P::size == 0;

RELEVO_LANE void store_three(Floats a, Floats b, Floats c, float (*rows)[lanes]) {
    store(a, rows[0]), store(b, rows[1]), store(c, rows[2]);
}

template <class P>
RELEVO_LANE void find_directions(WaitingPixels& waiting) {
    for (int n = 0; n < waiting.count; ++n) {
        std::array<Floats, 6> a;
        for (std::size_t k = 0; k < 6; ++k) a[k] = load(waiting.carried[n][k]);
        const auto to = P::template directions<Floats>(waiting.model->setup.surface, a.data());
        float(*rows)[lanes] = waiting.directions[n];
        store_three(to.normal.x, to.normal.y, to.normal.z, rows);
        store_three(to.viewer.x, to.viewer.y, to.viewer.z, rows + 3);
        store_three(to.light.x, to.light.y, to.light.z, rows + 6);
    }
}

// The colours of registers n and m.
template <class P>
RELEVO_LANE RgbOf<Floats2> colors_of(const WaitingPixels& waiting, int n, int m) {
    const auto both = [&](const auto& rows, int k)
                          RELEVO_INSIDE { return Floats2(load(rows[n][k]), load(rows[m][k])); };
    const auto three = [&](const auto& rows, int k) RELEVO_INSIDE {
        return Vec3Of<Floats2>(both(rows, k), both(rows, k + 1), both(rows, k + 2));
    };
    const Surface& surface = waiting.model->setup.surface;
    if constexpr (P::lights_pixels) {
        constexpr int first_uv = 6;
        Floats2 uv[2]{};
        if constexpr (P::textured)
            uv[0] = both(waiting.carried, first_uv), uv[1] = both(waiting.carried, first_uv + 1);
        const auto point = [&]() RELEVO_INSIDE { return three(waiting.carried, 0); };
        return P::template pixel<Floats2>(
            surface, uv, point,
            {three(waiting.directions, 0), three(waiting.directions, 3), three(waiting.directions, 6)});
    } else {
        std::array<Floats2, P::size> a;
        for (int k = 0; k < static_cast<int>(P::size); ++k) a[std::size_t(k)] = both(waiting.carried, k);
        FaceOf<P, Floats2> face{};
        if constexpr (P::needs_face) {
            const auto amount = three(waiting.face, 0), gloss = three(waiting.face, 3);
            face = {{amount.x, amount.y, amount.z}, {gloss.x, gloss.y, gloss.z}};
        }
        return P::template pixel<Floats2>(surface, face, a.data());
    }
}

template <class P>
[[gnu::noinline, gnu::flatten]] void light_waiting(const TileAt& at, WaitingPixels& waiting) {
    if constexpr (P::lights_pixels) find_directions<P>(waiting);
    for (int n = 0; n < waiting.count; n += 2) {
        const int m = std::min(n + 1, waiting.count - 1);  // an odd last one goes along with itself
        const RgbOf<Floats2> c = colors_of<P>(waiting, n, m);
        const Twice<Words> packed = packed_rgba8<Floats2>(c, at.draw.settings.output);
        write_pixels(at, waiting.to[n], packed.a, {c.r.a, c.g.a, c.b.a});
        write_pixels(at, waiting.to[m], packed.b, {c.r.b, c.g.b, c.b.b});
    }
    waiting.count = 0;
}
// None is left waiting.
template <template <bool> class Program>
RELEVO_LANE void light_waiting(const TileAt& at, WaitingPixels& waiting) {
    if (waiting.count == 0) return;
    with_texture<Program>(*waiting.model, [&]<class P>(P) RELEVO_INSIDE {
        if constexpr (!is_lit_at_once<P>) light_waiting<P>(at, waiting);
    });
}

// The pixels `to` are known up to light.
template <template <bool> class Program, class P, class To>
RELEVO_LANE void wait_for_light(const TileAt& at, WaitingPixels& waiting, const ModelState& model,
                                const PixelNumbers<P>& numbers, const To& to) {
    if (waiting.count == WaitingPixels::room || (waiting.count > 0 && waiting.model != &model))
        light_waiting<Program>(at, waiting);
    const int n = waiting.count++;
    waiting.model = &model, waiting.to[n] = to;
    for (std::size_t k = 0; k < P::size; ++k) store(numbers.carried[k], waiting.carried[n][k]);
    if constexpr (P::needs_face) {
        const auto& [amount, gloss] = numbers.face;
        store_three(amount.r, amount.g, amount.b, waiting.face[n]);
        store_three(gloss.r, gloss.g, gloss.b, waiting.face[n] + 3);
    }
}

// Now or later.
template <template <bool> class Program, class P, class To>
RELEVO_LANE void light(const TileAt& at, WaitingPixels& waiting, const ModelState& model,
                       const PixelNumbers<P>& numbers, const To& to) {
    if constexpr (is_lit_at_once<P>) {
        const RgbOf<Floats> c =
            P::template pixel<Floats>(model.setup.surface, numbers.face, numbers.carried.data());
        write_pixels(at, to, packed_rgba8<Floats>(c, at.draw.settings.output), c);
    } else {
        wait_for_light<Program, P>(at, waiting, model, numbers, to);
    }
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
