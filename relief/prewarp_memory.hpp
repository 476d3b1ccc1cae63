// What the resamplers keep from one warp to the next.
#pragma once
#include "raster/fast/workers.hpp"
#include "relief/resample_row.hpp"

namespace relevo::relief {

struct PrewarpMemory::Parts {
    std::vector<std::unique_ptr<WarpedRow>> rows;  // at least one a thread
    std::unique_ptr<raster::fast::Workers> workers;

    void fit(int threads) {
        while (static_cast<int>(rows.size()) < threads) rows.push_back(make_warped_row());
        if (!workers || threads_ != threads)
            workers = std::make_unique<raster::fast::Workers>(threads, false), threads_ = threads;
    }

  private:
    int threads_ = 0;
};

}  // namespace relevo::relief
