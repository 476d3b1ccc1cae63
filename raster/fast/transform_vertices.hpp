// Stage 1 of the fast path: N vertices at a time to the window, with what they carry.
//
//   mesh      px py pz nx ny nz u v | ...      32 bytes a vertex
//   window    x y z rw | ...                   16 bytes; rw = 0 and x = clip code where there is one
//   carried   a0 .. a3 [a4 .. a7] | ...        16 or 32 bytes: what the shading interpolates
#pragma once
#include <algorithm>

#include "raster/fast/draw_state.hpp"
#include "raster/fast/lanes.hpp"
#include "raster/shading.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

struct LaneVertex {
    pipeline::Vec3Of<Floats> position, normal;
    Floats u, v;
};

static_assert(sizeof(pipeline::Vertex) == 32, "eight floats, no padding");
RELEVO_LANE LaneVertex load_vertices(const pipeline::Vertex* vertices) {
    const float* p = reinterpret_cast<const float*>(vertices);
    hn::Vec<TagF> px_ny[2], py_nz[2], pz_u[2], nx_v[2];  // of each half of the lanes, by turns
    for (int half = 0; half < 2; ++half)
        hn::LoadInterleaved4(TagF(), p + 4 * lanes * half, px_ny[half], py_nz[half], pz_u[half], nx_v[half]);
    const auto even = [](hn::Vec<TagF>(&of)[2]) { return Floats(hn::ConcatEven(TagF(), of[1], of[0])); };
    const auto odd = [](hn::Vec<TagF>(&of)[2]) { return Floats(hn::ConcatOdd(TagF(), of[1], of[0])); };
    return {
        {even(px_ny), even(py_nz), even(pz_u)}, {even(nx_v), odd(px_ny), odd(py_nz)}, odd(pz_u), odd(nx_v)};
}

template <class Program>
RELEVO_LANE void transform_group(const ModelState& model, const pipeline::Viewport& viewport,
                                 const pipeline::Vertex* vertices, SnappedCorner* window, float* carried,
                                 bool past_caches) {
    const LaneVertex vertex = load_vertices(vertices);
    const auto& to_clip = model.setup.clip_from_object.row;
    const pipeline::Vec4Of<Floats> clip{pipeline::row_times_point(to_clip[0], vertex.position),
                                        pipeline::row_times_point(to_clip[1], vertex.position),
                                        pipeline::row_times_point(to_clip[2], vertex.position),
                                        pipeline::row_times_point(to_clip[3], vertex.position)};
    const Ints codes = pipeline::lanes_clip_codes<Floats>(clip);
    const auto corner = pipeline::lanes_to_window<Floats>(clip, viewport);
    const Bools clean = codes == Ints(0);
    hn::StoreInterleaved4(bits_float(select(clean, corner.x, codes)).v, bits_float(corner.y).v, corner.z.v,
                          select(clean, corner.rw, Floats(0.f)).v, TagF(), reinterpret_cast<float*>(window));
    if constexpr (Program::size > 0) {
        const auto values = varying_of<Program, Floats>(model.setup, vertex.position, vertex.normal,
                                                        {vertex.u, vertex.v}, false);
        Floats a[max_carried];
        for (int k = 0; k < max_carried; ++k)
            a[k] = k < int(Program::size) ? values[std::size_t(k)] : Floats(0.f);
        constexpr int stride = Program::size <= 4 ? 4 : 8;
        alignas(64) float rows[stride * lanes];
        stride == 4 ? store_fours(a, rows) : store_eights(a, rows);
        for (int k = 0; k < stride * lanes; k += lanes)
            past_caches ? stream(load(rows + k), carried + k) : store(load(rows + k), carried + k);
    }
}

// Vertices first..last-1, `first` a multiple of 16. The window and the carried numbers have room up to the
// next multiple of 16. Carried numbers are not read before shading: where there are so many that they would
// not stay in the cache until then, they go past it, which saves memory reading what they overwrite.
inline constexpr std::size_t stays_in_cache = 2 << 20;  // bytes
template <class Program>
RELEVO_LANE void transform_vertices(const ModelState& model, const pipeline::Viewport& viewport,
                                    std::uint32_t first, std::uint32_t last) {
    const std::size_t bytes = model.vertices.size() * std::size_t(model.stride) * sizeof(float);
    const bool past_caches = bytes > stays_in_cache;
    for (std::size_t i = first; i < last; i += lanes) {
        SnappedCorner* window = model.window + i;
        float* carried = model.carried + i * std::size_t(model.stride);
        if (i + lanes <= last) {
            transform_group<Program>(model, viewport, &model.vertices[i], window, carried, past_caches);
        } else {  // the last few of the mesh
            pipeline::Vertex some[lanes];
            for (std::size_t k = 0; k < lanes; ++k)
                some[k] = model.vertices[std::min<std::size_t>(i + k, last - 1)];
            transform_group<Program>(model, viewport, some, window, carried, past_caches);
        }
    }
    if (past_caches) hwy::FlushStream();
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
