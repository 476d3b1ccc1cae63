// What a pre-warp may cost: instructions of one interleaved warp, for each texel with a surface.
// scripts/budgets counts them under valgrind.
//   warp_budgets             warps everything; each dump is named "row +"
//   warp_budgets --items     the rows: name, a tab, texels
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstring>

#include "tests/relief/warp_workload.hpp"

int main(int argc, char** argv) {
    using namespace relevo;
    const bool names_only = argc == 2 && std::strcmp(argv[1], "--items") == 0;
    for (const tests::WarpWork& work : tests::warp_works()) {
        const std::string name = "interleaved warp, texel of " + work.name, dump = name + " +";
        if (names_only) {
            std::printf("%s\t%d\n", name.c_str(), work.texels);
            continue;
        }
        relief::Prewarped result;
        relief::PrewarpMemory memory;
        prewarp(work.source, work.warp, work.window, {}, result, memory);
        CALLGRIND_ZERO_STATS;  // the second time: all memory is there
        prewarp(work.source, work.warp, work.window, {}, result, memory);
        CALLGRIND_DUMP_STATS_AT(dump.c_str());
    }
    return 0;
}
