// The words that [pipeline] and other keys of a scene accept, what they mean, and a sentence for each: the
// reader of scenes and `relevo list` use the same tables.
#pragma once
#include <string_view>

#include "raster/fast/draw_fast.hpp"
#include "raster/scene.hpp"
#include "raster/shape.hpp"
#include "relief/representation.hpp"
#include "samples/scene/scene.hpp"

namespace relevo::scene {

template <class Meaning>
struct Choice {
    std::string_view name;
    Meaning meaning;
    std::string_view sentence;
};

inline constexpr Choice<raster::Shading> shadings[] = {
    {"unlit", raster::Shading::Unlit, "the surface's own colour, no light"},
    {"flat", raster::Shading::Flat, "one light equation a face"},
    {"gouraud", raster::Shading::Gouraud,
     "one light equation a corner, the colours interpolated (Gouraud 1971)"},
    {"phong", raster::Shading::Phong, "one light equation a pixel, the normals interpolated (Phong 1975)"},
};

inline constexpr Choice<raster::Filter> texture_filters[] = {
    {"nearest", raster::Filter::Nearest, "the texel that holds the point"},
    {"bilinear", raster::Filter::Bilinear, "the four nearest texels, weighted in steps of 1/256"},
};

inline constexpr Choice<raster::DepthFormat> depth_formats[] = {
    {"float32-reversed", raster::DepthFormat::Float32Reversed,
     "near 1, far 0: the same relative precision at every distance"},
    {"float32-forward", raster::DepthFormat::Float32Forward,
     "near 0, far 1: nearly all precision is spent close to the eye"},
};

inline constexpr Choice<pipeline::Cull> culls[] = {
    {"back", pipeline::Cull::Back, "faces that turn their back are not drawn"},
    {"front", pipeline::Cull::Front, "only backs are drawn: a look inside"},
    {"none", pipeline::Cull::None, "every face is drawn"},
};

inline constexpr Choice<raster::Path> paths[] = {
    {"auto", raster::Path::Auto, "fast where that is possible, else the textbook's: the same bytes"},
    {"fast", raster::Path::Fast,
     "many pixels and several threads at a time; with a warning the textbook's where it is impossible"},
    {"textbook", raster::Path::Textbook, "one pixel after the other, as the lecture has it"},
};

inline constexpr Choice<std::optional<raster::fast::InstructionSet>> instruction_sets[] = {
    {"auto", std::nullopt, "of the fast path: the widest that the processor has"},
    {"sse4", raster::fast::InstructionSet::Sse4, "4 numbers at a time"},
    {"avx2", raster::fast::InstructionSet::Avx2, "8 numbers at a time"},
    {"avx512", raster::fast::InstructionSet::Avx512, "16 numbers at a time"},
};

inline constexpr Choice<raster::Output> outputs[] = {
    {"srgb", raster::Output::Srgb, "8 bits by the sRGB curve: looks right on a screen"},
    {"raw", raster::Output::Raw, "8 bits straight from linear light, as the textbook's pictures are"},
};

inline constexpr Choice<CameraDescription::Kind> projections[] = {
    {"perspective", CameraDescription::Kind::Perspective, "a vertical angle of view, fov_y"},
    {"orthographic", CameraDescription::Kind::Orthographic,
     "parallel lines of sight, height = world units seen"},
    {"frustum", CameraDescription::Kind::Frustum, "the window left, right, bottom, top on the near plane"},
};

inline constexpr Choice<pipeline::Light::Kind> light_types[] = {
    {"point", pipeline::Light::Kind::Point, "shines from one position in all directions"},
    {"directional", pipeline::Light::Kind::Directional, "shines in one direction, as the sun does"},
};

// ------------------------------------------------------------------------------------------- of lessons
inline constexpr Choice<raster::ShapeKind> shape_kinds[] = {
    {"line", raster::ShapeKind::Line, "from one point to another"},
    {"polyline", raster::ShapeKind::Polyline, "lines from point to point"},
    {"circle", raster::ShapeKind::Circle, "center and radius; filled = true makes a disc"},
    {"ellipse", raster::ShapeKind::Ellipse, "center and radius = [across, down]"},
    {"rectangle", raster::ShapeKind::Rectangle, "the area between two opposite corners"},
    {"triangle", raster::ShapeKind::Triangle, "the area between three corners"},
    {"polygon", raster::ShapeKind::Polygon, "the area inside of an outline, which may cross itself"},
};

inline constexpr Choice<raster::ScanAlgorithm> scan_algorithms[] = {
    {"midpoint", raster::ScanAlgorithm::Midpoint,
     "lines, circles, ellipses: the pixel on the curve's side of the midpoint (Bresenham 1965)"},
    {"second-order", raster::ScanAlgorithm::SecondOrder,
     "circles, ellipses: the same pixels by differences of differences"},
    {"textbook", raster::ScanAlgorithm::Textbook,
     "ellipses as printed in section 5.3, which loses the tips of flat ones"},
    {"dda", raster::ScanAlgorithm::Dda, "lines: one addition of the slope a step"},
    {"explicit", raster::ScanAlgorithm::Explicit,
     "lines: y = a x + B a column, with gaps where the line is steep"},
    {"wu", raster::ScanAlgorithm::Wu, "lines: two pixels a step, weighted by their distance (Wu 1991)"},
    {"gupta-sproull", raster::ScanAlgorithm::GuptaSproull,
     "lines: three pixels a step, weighted by a cone (Gupta and Sproull 1981)"},
    {"scanline", raster::ScanAlgorithm::Scanline,
     "rectangles; triangles by the long edge and edges 2 and 3 (section 5.4)"},
    {"edge-function", raster::ScanAlgorithm::EdgeFunction, "triangles: three signs a pixel (Pineda 1988)"},
    {"active-edges", raster::ScanAlgorithm::ActiveEdges,
     "areas: the edges that cross a row, from left to right"},
};

inline constexpr Choice<raster::Antialiasing> antialiasings[] = {
    {"none", raster::Antialiasing::None, "a pixel belongs to the shape or not"},
    {"area", raster::Antialiasing::Area, "the part of the pixel's square that the shape covers"},
    {"weighted", raster::Antialiasing::Weighted, "the same, weighted by a cone around the pixel's centre"},
    {"supersample", raster::Antialiasing::Supersample,
     "samples x samples points a pixel, each shape by itself"},
    {"multisample", raster::Antialiasing::Multisample,
     "the same points, which all shapes share: no seam between neighbours"},
};

inline constexpr Choice<raster::FillRule> fill_rules[] = {
    {"top-left", raster::FillRule::TopLeft,
     "a pixel centre on the top or left edge of an area belongs to it"},
    {"book", raster::FillRule::Book, "on the bottom or left edge, as fig. 5.8 of the textbook has it"},
};

inline constexpr Choice<raster::InsideRule> inside_rules[] = {
    {"non-zero", raster::InsideRule::NonZero, "inside is what the outline goes around"},
    {"even-odd", raster::InsideRule::EvenOdd,
     "inside is what an odd number of edges separates from far away"},
};

inline constexpr Choice<raster::LineClipper> line_clippers[] = {
    {"cohen-sutherland", raster::LineClipper::CohenSutherland, "by outcodes, one side of the window a turn"},
    {"cyrus-beck", raster::LineClipper::CyrusBeck, "by entering and leaving values of t; any convex window"},
    {"liang-barsky", raster::LineClipper::LiangBarsky, "the same, made short for upright windows"},
    {"midpoint", raster::LineClipper::MidpointSubdivision, "by halving what is neither inside nor outside"},
};

inline constexpr Choice<raster::PolygonClipper> polygon_clippers[] = {
    {"sutherland-hodgman", raster::PolygonClipper::SutherlandHodgman, "one pass over all corners a side"},
    {"pipeline", raster::PolygonClipper::SutherlandHodgmanPipeline,
     "the same without lists in between: each corner goes through all sides"},
    {"greiner-hormann", raster::PolygonClipper::GreinerHormann,
     "walks along both outlines; the window may be concave (Greiner and Hormann 1998)"},
};

inline constexpr Choice<raster::Side> sides[] = {
    {"left", raster::Side::Left, "as seen in the picture"},
    {"right", raster::Side::Right, "as seen in the picture"},
    {"bottom", raster::Side::Bottom, "as seen in the picture"},
    {"top", raster::Side::Top, "as seen in the picture"},
};

inline constexpr Choice<Animation::Kind> animation_types[] = {
    {"orbit", Animation::Kind::Orbit, "round the target at one distance and elevation"},
    {"path", Animation::Kind::Path, "from eye to eye in straight lines"},
};

// ------------------------------------------------------------------------------------------- of reliefs
inline constexpr Choice<relief::Representation> representations[] = {
    {"geometry", relief::Representation::Geometry, "the object itself: triangles, or rays for a surface"},
    {"relief", relief::Representation::Relief,
     "a relief texture, pre-warped onto its plane and lit there (Oliveira 2000)"},
    {"relief-box", relief::Representation::ReliefBox, "six relief textures round the object, nearest wins"},
    {"relief-inverse", relief::Representation::ReliefInverse,
     "a search along each line of sight through a relief texture (Policarpo 2005)"},
    {"sprite", relief::Representation::Sprite, "one picture, flat"},
    {"sprite-depth", relief::Representation::SpriteDepth,
     "depths warped forwards, colours fetched backwards (Shade 1998)"},
    {"ldi", relief::Representation::Ldi, "a layered depth image: what lies behind the first surface, too"},
    {"morph", relief::Representation::Morph, "two views, and every view between them (Seitz 1996)"},
};

inline constexpr Choice<relief::Morphing> morphings[] = {
    {"view", relief::Morphing::View, "prewarp, morph, postwarp: straight lines stay straight"},
    {"plain", relief::Morphing::Plain, "places and colours faded evenly: straight lines bend"},
};

inline constexpr Choice<relief::Resampler> resamplers[] = {
    {"interleaved", relief::Resampler::Interleaved, "each sample of a row goes on to its column at once"},
    {"one-dimensional", relief::Resampler::OneDimensional,
     "rows, then columns; displacement interpolated linearly"},
    {"asymmetric", relief::Resampler::Asymmetric, "rows, then columns; each sample knows its row"},
    {"compensated", relief::Resampler::Compensated,
     "rows, then columns; displacement chosen so that its row is right"},
    {"mesh", relief::Resampler::Mesh, "triangles between the texels with a z-buffer: the reference"},
    {"splat", relief::Resampler::Splat, "each texel paints the one pixel it falls into"},
};

inline constexpr Choice<relief::Jump> jumps[] = {
    {"skin", relief::Jump::Skin, "a skin is stretched over a jump of depth"},
    {"cut", relief::Jump::Cut, "the surface ends at a jump of depth"},
};

inline constexpr Choice<relief::Projection> relief_sources[] = {
    {"orthographic", relief::Projection::Orthographic, "parallel rays, displacements in world units"},
    {"perspective", relief::Projection::Perspective, "rays from an eye, disparities"},
};

inline constexpr Choice<relief::DepthBits> depth_bits[] = {
    {"float", relief::DepthBits::Float, "displacement as computed"},
    {"16", relief::DepthBits::Sixteen, "65535 equal steps"},
    {"8", relief::DepthBits::Eight, "255 equal steps, as in the thesis"},
};

inline constexpr Choice<relief::Lit> relief_lights[] = {
    {"drawn", relief::Lit::Drawn, "lit for the viewer, by the texture's normals"},
    {"captured", relief::Lit::Captured, "as the source saw it: gloss stands still"},
};

inline constexpr Choice<relief::Reading> readings[] = {
    {"bilinear", relief::Reading::Bilinear, "between four texels, not across a jump of depth"},
    {"nearest", relief::Reading::Nearest, "the texel that holds the place"},
};

inline constexpr Choice<relief::Search> searches[] = {
    {"slices", relief::Search::Slices, "equal steps of depth, then bisections"},
    {"texels", relief::Search::Texels, "every texel under the line of sight: exact"},
    {"cones", relief::Search::Cones, "jumps through cones that hold nothing (Dummer 2006)"},
    {"relaxed-cones", relief::Search::RelaxedCones, "wider cones, then bisections (Policarpo 2007)"},
};

inline constexpr Choice<relief::SolidEnd> solid_ends[] = {
    {"back", relief::SolidEnd::Back, "a second texture of the object's back says where it ends"},
    {"thickness", relief::SolidEnd::Thickness, "every texel is equally thick"},
    {"none", relief::SolidEnd::None, "everything behind the surface is solid"},
};

inline constexpr Choice<relief::Composite> composites[] = {
    {"depth", relief::Composite::Depth, "the nearest point of all faces"},
    {"order", relief::Composite::FaceOrder, "face after face, the most frontal last: the thesis's"},
};

// What a kind of shape takes; the first is the default.
inline std::vector<raster::ScanAlgorithm> algorithms_of(raster::ShapeKind kind) {
    using enum raster::ScanAlgorithm;
    switch (kind) {
        case raster::ShapeKind::Line:
        case raster::ShapeKind::Polyline:
            return {Midpoint, Dda, Explicit, Wu, GuptaSproull};
        case raster::ShapeKind::Circle:
            return {Midpoint, SecondOrder};
        case raster::ShapeKind::Ellipse:
            return {Midpoint, SecondOrder, Textbook};
        case raster::ShapeKind::Rectangle:
            return {Scanline, ActiveEdges};
        case raster::ShapeKind::Triangle:
            return {Scanline, EdgeFunction, ActiveEdges};
        case raster::ShapeKind::Polygon:
            return {ActiveEdges};
    }
    return {};
}
inline std::vector<raster::Antialiasing> antialiasings_of(raster::ShapeKind kind) {
    using enum raster::Antialiasing;
    if (kind == raster::ShapeKind::Circle || kind == raster::ShapeKind::Ellipse) return {None, Area};
    return {None, Area, Weighted, Supersample, Multisample};
}
template <class Meaning, std::size_t count>
std::string_view name_of(Meaning meaning, const Choice<Meaning> (&choices)[count]) {
    for (const auto& choice : choices)
        if (choice.meaning == meaning) return choice.name;
    return "";
}

}  // namespace relevo::scene
