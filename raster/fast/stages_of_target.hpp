// The three stages of one instruction set; included by one source file for each, which is compiled for it.
#pragma once
#include "raster/fast/bin_triangles.hpp"
#include "raster/fast/cover_tile.hpp"
#include "raster/fast/shade_tile.hpp"
#include "raster/fast/stages.hpp"
#include "raster/fast/transform_vertices.hpp"
#include "raster/fast/write_tile.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

[[gnu::flatten]] static void transform(const ModelState& model, const pipeline::Viewport& viewport,
                                       std::uint32_t first, std::uint32_t last) {
    const auto with = [&]<class Program>(Program) {
        transform_vertices<Program>(model, viewport, first, last);
    };
    switch (model.shading) {
        case Shading::Unlit:
        case Shading::Flat:
            return model.textured ? with(Unlit<true>{}) : with(Unlit<false>{});
        case Shading::Gouraud:
            return model.textured ? with(Gouraud<true>{}) : with(Gouraud<false>{});
        case Shading::Phong:
            return model.textured ? with(Phong<true>{}) : with(Phong<false>{});
    }
}

[[gnu::flatten]] static void bin(const DrawState& draw, Chunk& chunk) { bin_triangles(draw, chunk); }

template <class Painter>
[[gnu::noinline, gnu::flatten]] std::uint64_t cover_and_shade(Painter painter, TileAt at, TileIds list) {
    cover_tile(painter, at, list);
    if (at.listed == 0) return 0;
    return painter.paints() ? write_painted(at) : shade_tile(at.draw, at.scratch, at.listed, at.box);
}

[[gnu::flatten]] static std::uint64_t draw_tile(const DrawState& draw, const Chunk* chunks, int chunk_count,
                                                TileScratch& scratch, int number) {
    const TileAt at{draw, scratch, tile_box(draw, number)};
    const TileIds list(draw, chunks, chunk_count, number, scratch.ids);
    const std::size_t listed = listed_in(chunks, chunk_count, number);
    const bool paints = draw.paints && is_worth_painting(at.box, listed);
    std::uint64_t shaded = 0;
    if (paints && draw.settings.shading == Shading::Gouraud)
        shaded = cover_and_shade(Painter<Gouraud>(scratch), at, list);
    else if (paints)
        shaded = cover_and_shade(Painter<Flat>(scratch), at, list);
    else
        shaded = cover_and_shade(NoPainter(), at, list);
    while (scratch.background.count > 0) write_background_row(draw, scratch.background);
    hwy::FlushStream();
    return shaded;
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
