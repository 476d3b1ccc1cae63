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

[[gnu::flatten]] static std::uint64_t draw_tile(const DrawState& draw, const Chunk* chunks, int chunk_count,
                                                TileScratch& scratch, int number) {
    const TileBox box = tile_box(draw, number);
    std::uint64_t shaded = 0;
    if (const int listed = cover_tile(draw, chunks, chunk_count, scratch, number, box); listed > 0)
        shaded = shade_tile(draw, scratch, listed, box);
    while (scratch.background.count > 0) write_background_row(draw, scratch.background);
    hwy::FlushStream();
    return shaded;
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
