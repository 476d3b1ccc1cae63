// Limits: a frame beside the plainest ways to write its colour and depth, 8 bytes a pixel: streaming stores,
// which go past the caches, and memset, which may stay in them.
#include <emmintrin.h>

#include <cstring>
#include <memory>

#include "tests/bench/bench.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/ours.hpp"

namespace relevo::bench {
namespace {

constexpr std::size_t frame_bytes = std::size_t{8} * full_width * full_height;

struct alignas(64) CacheLine {
    __m128i parts[4];
};

void stream(std::vector<CacheLine>& memory, int value) {
    const __m128i part = _mm_set1_epi32(value);
    for (CacheLine& line : memory)
        for (__m128i& place : line.parts) _mm_stream_si128(&place, part);
    _mm_sfence();
}

}  // namespace

void limits(Report& report, bool quick) {
    const Rounds rounds = quick ? Rounds{1, 5} : Rounds{5, 15};
    const raster::fast::Options options{.instruction_set = widest()};
    const Workload empty{"nothing", {}, false}, torus = torus_1k(), fill = fill_workload();
    Ours draws_nothing(empty, Mode::Unlit, full_width, full_height, options),
        draws_torus(torus, Mode::Unlit, full_width, full_height, options),
        draws_fill(fill, Mode::Unlit, full_width, full_height, options);
    std::vector<CacheLine> streamed(frame_bytes / sizeof(CacheLine)), filled(streamed);
    Contestant contestants[] = {
        {"streaming stores", [&](int frame) { stream(streamed, frame); }},
        {"memset", [&](int frame) { std::memset(static_cast<void*>(filled.data()), frame, frame_bytes); }},
        {"frame of nothing", [&](int frame) { draws_nothing.draw(frame); }},
        {"frame of torus_1k, unlit", [&](int frame) { draws_torus.draw(frame); }},
        {"frame of fill, unlit", [&](int frame) { draws_fill.draw(frame); }}};
    take_turns(contestants, Clock::Cpu, rounds);

    report.say("Limits, one thread: a frame's colour and depth are " + digits(frame_bytes * 1e-6) +
               " MB; CPU ms beside the plainest ways to write as many bytes.");
    report.heading({"what", "ms", "GB/s", "times streaming stores", "times memset"});
    for (const Contestant& c : contestants) {
        const double streaming = c.milliseconds / contestants[0].milliseconds;
        report.row({c.name, digits(c.milliseconds), digits(frame_bytes * 1e-6 / c.milliseconds),
                    digits(streaming), digits(c.milliseconds / contestants[1].milliseconds)});
        report.figure(c.name, "", "frame", c.milliseconds, "CPU ms");
        report.figure(c.name, "", "frame / streaming stores", streaming, "times");
    }
}

}  // namespace relevo::bench
