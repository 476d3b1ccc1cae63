#include "tests/bench/ours.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "raster/draw.hpp"

namespace relevo::bench {
namespace {

using namespace raster;

const Texture& texture() {
    static const Texture made = [] {
        auto rows = checkerboard();  // bottom row first; make_texture takes the top row first
        const std::ptrdiff_t stride = 3 * texture_size;
        for (std::ptrdiff_t y = 0; y < texture_size / 2; ++y)
            std::swap_ranges(rows.begin() + y * stride, rows.begin() + (y + 1) * stride,
                             rows.end() - (y + 1) * stride);
        return make_texture(texture_size, texture_size, 3, rows, Encoding::Raw);
    }();
    return made;
}

}  // namespace

Ours::Ours(const Workload& workload, Mode mode, int width, int height, fast::Options options)
    : workload_(workload),
      scene_{{{&workload.mesh, {}, material(), mode == Mode::Textured ? &texture() : nullptr, false}},
             {light()},
             camera(width, height, pipeline::DepthRange::Reversed),
             background},
      frame_{Image<Rgba8>(width, height), Image<pipeline::Scalar>(width, height), {}},
      options_(options) {
    settings_.shading = shading(mode);
    settings_.output = Output::Raw;
}

void Ours::place(int frame) { scene_.models[0].world_from_object = placement(workload_, frame); }

void Ours::draw(int frame) {
    place(frame);
    fast::draw(scene_, settings_, frame_, workspace_, options_);
}

void Ours::draw_textbook(int frame) {
    place(frame);
    raster::draw(scene_, settings_, frame_);
}

fast::InstructionSet widest() {
    if (fast::instruction_sets().empty()) {
        std::fprintf(stderr, "this processor, or this build, has no fast path to measure\n");
        std::exit(2);
    }
    return fast::instruction_sets().back();
}

bool same_bytes(const Frame& a, const Frame& b) {
    const auto equal = [](const auto& p, const auto& q) {
        return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size() * sizeof p[0]) == 0;
    };
    return equal(a.color.pixels(), b.color.pixels()) && equal(a.depth.pixels(), b.depth.pixels());
}

}  // namespace relevo::bench
