// What a search by slices may cost: instructions of a ray, seen 25 degrees aside. scripts/budgets counts them
// under valgrind. 32 slices and 8 bisections are to cost at most a third of 256 slices.
//   slice_budgets             searches everything; each dump is named "row +"
//   slice_budgets --items     the rows: name, a tab, rays
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstring>

#include "tests/relief/slice_workload.hpp"

int main(int argc, char** argv) {
    using namespace relevo;
    const bool names_only = argc == 2 && std::strcmp(argv[1], "--items") == 0;
    for (const tests::SliceWork& work : tests::slice_works(64))
        for (const relief::SliceSettings& settings : {relief::SliceSettings{256, 0}, {32, 0}, {32, 8}}) {
            const std::string name = std::to_string(settings.slices) + " slices" +
                                     (settings.bisections ? " and 8 bisections" : "") + ", ray of " +
                                     work.name,
                              dump = name + " +";
            if (names_only) {
                std::printf("%s\t%d\n", name.c_str(), int(work.rays.size()));
                continue;
            }
            CALLGRIND_ZERO_STATS;
            for (const relief::ReliefRay& ray : work.rays)
                if (find_by_slices(work.solid, ray, settings)) asm volatile("" : : : "memory");
            CALLGRIND_DUMP_STATS_AT(dump.c_str());
        }
    return 0;
}
