// What the resamplers keep from one warp to the next.
#pragma once
#include "raster/fast/workers.hpp"
#include "relief/resample_row.hpp"

namespace relevo::relief {

struct PrewarpMemory::Parts {
    SampleLines<false> samples;  // the picture between two passes
    SampleLines<true> samples_with_maps;
    std::unique_ptr<raster::fast::Workers> workers;

    template <bool maps>
    SampleLines<maps>& samples_for() {
        if constexpr (maps)
            return samples_with_maps;
        else
            return samples;
    }
    raster::fast::Workers& workers_for(int threads) {
        if (!workers || threads_ != threads)
            workers = std::make_unique<raster::fast::Workers>(threads, false), threads_ = threads;
        return *workers;
    }

  private:
    int threads_ = 0;
};

}  // namespace relevo::relief
