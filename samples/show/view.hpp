// Parallel views of three-dimensional things for the diagrams: wire frames, soft shaded solids, boxes with
// ticks.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "raster/scene.hpp"
#include "samples/show/canvas.hpp"

namespace relevo::show {

// Looks along -toward; `right` and `up` are unit vectors of the picture, `center` is drawn at `middle`.
struct View {
    glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, toward{0, 0, 1}, center{0, 0, 0};
    Spot middle;
    double scale = 1;  // pixels a unit

    Spot spot(glm::dvec3 p) const;
    double depth(glm::dvec3 p) const;  // larger is nearer
};
View oblique_view();  // from the front, the right and above
// Obliquely from above and from the side of this direction.
View view_across(glm::dvec3 direction);
View side_view();   // from +x: -z runs to the right, y up
View top_view();    // from +y: x runs to the right, -z up
View front_view();  // from +z: x runs to the right, y up

struct Box {
    glm::dvec3 low{0, 0, 0}, high{0, 0, 0};
    bool empty = true;

    void add(glm::dvec3 p);  // what is not finite is left out
    void add(const Box& box);
    glm::dvec3 size() const { return high - low; }
    double longest() const;
    glm::dvec3 corner(int number) const;  // bits 0, 1, 2 choose high x, y, z
};

// The view moved and scaled so that the box (the points) fills the area, less a margin in pixels.
View fitted(View view, const Box& box, Rect area, int margin);
View fitted(View view, std::span<const glm::dvec3> points, Rect area, int margin);

struct Segment {
    glm::dvec3 a, b;
};
// Each segment once, whichever end came first; those that are not finite are left out.
std::vector<Segment> unique_segments(std::vector<Segment> segments);
std::vector<Segment> mesh_edges(const pipeline::Mesh& mesh, std::span<const glm::dvec3> positions);

// A stroke for so much wire: the denser it is in the view, the thinner and the more translucent, so that in
// the mean no more than `dense` of its area is inked.
Stroke wire_stroke(const View& view, std::span<const Segment> wire, Rect area, Rgba8 color,
                   double dense = 0.5);
void draw_wire(Canvas canvas, const View& view, std::span<const Segment> wire, Stroke stroke);

// Models drawn softly shaded in one tint each, with the depth that hides lines. All of `area`'s size.
struct Solid {
    Picture color;
    raster::Image<raster::Scalar> depth;
    Rect area;
    double low = 0, high = 1;  // View::depth of the stored depths 0 and 1
};
Solid draw_solid(const View& view, Rect area, std::span<const raster::Model> models);
void paste_solid(Canvas canvas, const Solid& solid);
// What the solid hides is drawn in `hidden`'s stroke.
void draw_wire(Canvas canvas, const View& view, const Solid& solid, std::span<const Segment> wire,
               Stroke visible, Stroke hidden);

// A box with ticks and numbers along three of its edges, named x, y, z; ticks are at least so many pixels
// apart.
void draw_axes(Canvas canvas, const View& view, const Box& box, double at_least = 60);
// Axes of a flat view: grid lines with numbers at the left and the bottom of the area. `horizontal` and
// `vertical` are the axes (0 x, 1 y, 2 z) that run along the picture's sides; the view may run them
// backwards.
using AxisNames = std::array<const char*, 3>;
void draw_flat_axes(Canvas canvas, const View& view, Rect area, int horizontal, int vertical,
                    const AxisNames& names = {"x", "y", "z"});
// Three arrows x, y, z at a place, `length` units long.
void draw_frame(Canvas canvas, const View& view, glm::dvec3 origin, double length);

}  // namespace relevo::show
