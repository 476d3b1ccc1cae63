// Polygon clipping as a pipeline of sides without lists in between (Sutherland and Hodgman 1974, "Reentrant
// polygon clipping"; textbook section 4.3.1, last paragraph but one).
//
// Every side is a stage that holds two corners only: the first that came, to close the polygon in the end,
// and the last. What a stage emits goes to the next stage at once; after the last stage it is a point of the
// answer. When all corners are in, the stages close one after the other with the edge from last to first.
//
// The same edges meet the same sides in the same order as in clip_shape_sutherland_hodgman.hpp, which says
// what goes in and comes out: the answers are equal to the last bit. Stages would call each other; a stack
// that holds at most one waiting corner a stage replaces that, so windows of any size are safe.
#pragma once
#include <optional>

#include "pipeline/clip_shape_sutherland_hodgman.hpp"

namespace relevo::pipeline {

struct ShapeStageHolds {  // event: a stage has taken a corner
    std::size_t side;
    glm::vec2 first, last;
};

template <class Probe>
class ShapePipeline {
  public:
    ShapePipeline(std::span<const ClipLine> window, Probe& probe) : probe_(&probe) {
        for (const ClipLine& line : window) stages_.push_back({line, {}, {}, 0, 0});
    }

    void push(const ShapeCorner& corner) {
        wait(0, corner);
        run();
    }
    ClippedRing close() && {
        for (std::size_t side = 0; side < stages_.size(); ++side) {
            const Stage stage = stages_[side];
            if (!stage.first) continue;
            clip(side, *stage.last, stage.last_side, *stage.first, stage.first_side);
            run();
        }
        return std::move(ring_).finished();
    }

  private:
    struct Stage {
        ClipLine line;
        std::optional<ShapeCorner> first, last;
        int first_side, last_side;
    };
    struct Waiting {
        std::size_t side;  // of the stage that takes it; their number for the answer
        ShapeCorner corner;
    };

    void wait(std::size_t side, const ShapeCorner& corner) { waiting_.push_back({side, corner}); }

    void run() {
        while (!waiting_.empty()) {
            const auto [side, corner] = waiting_.back();
            waiting_.pop_back();
            side == stages_.size() ? ring_.push(corner) : take(side, corner);
        }
    }

    void take(std::size_t side, const ShapeCorner& corner) {
        Stage& stage = stages_[side];
        const int corner_side = side_of(stage.line, corner);
        if (stage.first) clip(side, *stage.last, stage.last_side, corner, corner_side);
        if (!stage.first) stage.first = corner, stage.first_side = corner_side;
        stage.last = corner, stage.last_side = corner_side;
        note<ShapeStageHolds>(*probe_, side, stage.first->point, corner.point);
    }

    void clip(std::size_t side, const ShapeCorner& from, int from_side, const ShapeCorner& to, int to_side) {
        const std::size_t start = waiting_.size();
        clip_shape_edge(
            from, from_side, to, to_side, stages_[side].line, side,
            [&](const ShapeCorner& corner) { wait(side + 1, corner); }, *probe_);
        std::reverse(waiting_.begin() + std::ptrdiff_t(start), waiting_.end());  // the first one goes first
    }

    std::vector<Stage> stages_;
    std::vector<Waiting> waiting_;
    RingBuilder ring_;
    Probe* probe_;
};

template <class Probe = const NoProbe>
ClippedRing clip_ring_pipeline(std::span<const glm::vec2> polygon, std::span<const ClipLine> window,
                               Probe&& probe = {}) {
    if (!is_finite(polygon)) return note<ClipRefused>(probe, Refusal::NotFinite), ClippedRing{};
    ShapePipeline<std::remove_reference_t<Probe>> stages(window, probe);
    for (std::size_t i = 0; i < polygon.size(); ++i) stages.push(shape_corner(polygon, i));
    return std::move(stages).close();
}
template <class Probe = const NoProbe>
ClippedRing clip_ring_pipeline(std::span<const glm::vec2> polygon, const ClipBox& window,
                               Probe&& probe = {}) {
    return with_window(
        window, [&](auto lines) { return clip_ring_pipeline(polygon, lines, probe); }, probe);
}
template <class Probe = const NoProbe>
ClippedRing clip_ring_pipeline(std::span<const glm::vec2> polygon, std::span<const glm::vec2> window,
                               Probe&& probe = {}) {
    return with_window(
        window, [&](auto lines) { return clip_ring_pipeline(polygon, lines, probe); }, probe);
}

// Only the points. `window` is a ClipBox, the corners of a convex polygon, or lines.
template <class Window, class Probe = const NoProbe>
std::vector<glm::vec2> clip_shape_pipeline(std::span<const glm::vec2> polygon, const Window& window,
                                           Probe&& probe = {}) {
    return clip_ring_pipeline(polygon, window, probe).points;
}

}  // namespace relevo::pipeline
