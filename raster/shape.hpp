// What the two-dimensional machine draws, and how: the vocabulary of raster/draw_shapes.hpp. No algorithm
// here.
//
// All coordinates are pixels of the picture: whole numbers are pixel centres, x to the right, y down.
#pragma once
#include <glm/vec2.hpp>
#include <vector>

#include "pipeline/clip_plane.hpp"
#include "pipeline/color.hpp"
#include "raster/output.hpp"
#include "raster/pixel.hpp"

namespace relevo::raster {

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"  // g++ 12 takes the word Triangle for that of triangle_edge.hpp
enum class ShapeKind { Line, Polyline, Circle, Ellipse, Rectangle, Triangle, Polygon };
#pragma GCC diagnostic pop

// How a shape becomes pixels. Which of them a kind of shape takes: samples/scene/choices.hpp.
enum class ScanAlgorithm {
    Midpoint,      // lines, circles, ellipses: the textbook's (Bresenham 1965)
    SecondOrder,   // circles, ellipses: the same pixels by differences of differences
    Textbook,      // ellipses: as printed in section 5.3, with its failure at flat tips
    Dda,           // lines: one addition of the slope a step
    Explicit,      // lines: y = a x + B a column; fails at the vertical
    Wu,            // lines: two pixels a step, weighted by their distance (Wu 1991)
    GuptaSproull,  // lines: three pixels a step, weighted by a cone (Gupta and Sproull 1981)
    Scanline,      // triangles: long edge, edge 2, edge 3 (section 5.4)
    EdgeFunction,  // triangles: three signs a pixel (Pineda 1988)
    ActiveEdges,   // polygons: an edge table and the edges that cross the row
};

enum class Antialiasing {
    None,         // a pixel belongs to the shape or not
    Area,         // the covered part of the pixel's square (section 8.1, unweighted)
    Weighted,     // a cone of radius 1 over the shape (section 8.2)
    Supersample,  // samples x samples points a pixel, each shape by itself
    Multisample,  // the same points, but shapes share them: no seam between neighbours
};

enum class FillRule { TopLeft, Book };  // which edges belong to an area: left and top rows; or fig. 5.8's
enum class InsideRule { NonZero, EvenOdd };  // what is inside of an outline that crosses itself

struct Shape {
    ShapeKind kind = ShapeKind::Line;
    std::vector<glm::vec2>
        points;  // corners in order; rectangle: two opposite ones; circle, ellipse: the centre
    float radius_x = 0, radius_y = 0;
    bool filled = false;  // circle, ellipse; rectangles, triangles and polygons always are
    ScanAlgorithm algorithm = ScanAlgorithm::Midpoint;
    Antialiasing antialiasing = Antialiasing::None;
    int samples = 4;           // Supersample, Multisample: along each side of the pixel, 1..16
    float width = 1;           // of lines and outlines, pixels; an aliased line of another width is an area
    bool even_weight = false;  // aliased lines of width 1: dimmed by slope, so that all look equally thick
    InsideRule inside = InsideRule::NonZero;
    pipeline::LinearRgb color{1, 1, 1};
    float opacity = 1;
};

enum class LineClipper { CohenSutherland, CyrusBeck, LiangBarsky, MidpointSubdivision };
enum class PolygonClipper { SutherlandHodgman, SutherlandHodgmanPipeline, GreinerHormann };
using pipeline::Side;

// The window that shapes are cut at: a box, or a polygon when `polygon` has corners.
struct ShapeClip {
    bool on = false;
    glm::vec2 low{0, 0}, high{0, 0};  // the box, sides included
    std::vector<glm::vec2> polygon;
    LineClipper lines = LineClipper::CohenSutherland;
    PolygonClipper polygons = PolygonClipper::SutherlandHodgman;
    Side order[4] = {Side::Top, Side::Bottom, Side::Right, Side::Left};  // as the bits of fig. 4.2
    bool split = false;  // Sutherland-Hodgman: cut the bridge edges out, one polygon a piece
};

struct ShapeScene {
    std::vector<Shape> shapes;  // the first is the lowest
    ShapeClip clip;
    FillRule fill_rule = FillRule::TopLeft;
    pipeline::LinearRgb background;
};

}  // namespace relevo::raster
