// The work done by Relevo, by either path.
#pragma once
#include "raster/fast/draw_fast.hpp"
#include "raster/scene.hpp"
#include "tests/bench/workload.hpp"

namespace relevo::bench {

class Ours {
  public:
    Ours(const Workload& workload, Mode mode, int width, int height, raster::fast::Options options = {});

    void draw(int frame);  // by the fast path
    void draw_textbook(int frame);
    const raster::Frame& picture() const { return frame_; }
    std::size_t workspace_bytes() const { return workspace_.bytes(); }

  private:
    void place(int frame);

    const Workload& workload_;
    raster::Scene scene_;
    raster::Settings settings_;
    raster::Frame frame_;
    raster::fast::Workspace workspace_;
    raster::fast::Options options_;
};

// The widest instruction set of this processor; ends the program with a sentence where there is no fast path.
raster::fast::InstructionSet widest();

bool same_bytes(const raster::Frame& a, const raster::Frame& b);

}  // namespace relevo::bench
