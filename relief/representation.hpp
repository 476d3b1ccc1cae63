// An object of a scene that is shown by pictures of itself: which pictures are taken, and how a viewer's
// picture is made of them (Clua 2004, chapters 3 and 6).
//
//   sprite           one picture, flat on its plane
//   sprite-depth     the same, warped in two passes: depths forwards, colours backwards
//   relief           one relief texture, pre-warped, on its plane, lit by its own normals
//   relief-inverse   one or two, searched along the line of sight of every pixel
//   relief-box       six round the object
//   ldi              several surfaces behind one another
//   morph            two views and what belongs together in them: every view between (2.4.2)
//   geometry         no picture: the object itself, by casting rays. The truth of all others
//
// Taking the pictures (represent) needs no viewer and is done once; drawing them (view_of,
// draw_represented) is done for every viewer.
#pragma once
#include "relief/box.hpp"
#include "relief/capture.hpp"
#include "relief/capture_raster.hpp"
#include "relief/cone_step_map.hpp"
#include "relief/inverse_slices.hpp"
#include "relief/layered_depth_image.hpp"
#include "relief/morph.hpp"
#include "relief/placed_surface.hpp"
#include "relief/prewarp.hpp"
#include "relief/relief_solid.hpp"
#include "relief/scene_light.hpp"

namespace relevo::relief {

enum class Representation { Geometry, Relief, ReliefBox, ReliefInverse, Sprite, SpriteDepth, Ldi, Morph };

enum class DepthBits { Float, Sixteen, Eight };             // of stored displacements (quantize.hpp)
enum class Search { Slices, Texels, Cones, RelaxedCones };  // of relief-inverse
enum class SolidEnd { None, Thickness, Back };              // how far behind its surface an object goes on
enum class Morphing { View, Plain };                        // view_morph.hpp, morph.hpp
enum class Lit { Drawn, Captured };  // colours lit for the viewer, by the normals; or as the source saw them

struct RepresentationSettings {
    // The source: it looks from this direction at the middle of the object. Azimuth 0 is +z, 90 is +x;
    // elevation 90 is +y. Its plane touches the ball round the object, of which it sees all.
    pipeline::Degrees azimuth{0}, elevation{0};
    Projection projection = Projection::Orthographic;
    double distance = 3;  // of a perspective source's eye from the middle, in radii of the ball; > 1
    int texels = 256;     // along each side; of a box along its longest
    double radius = 0;    // of the ball, in world units; 0: what the object needs
    DepthBits bits = DepthBits::Float;
    Lit lit = Lit::Drawn;
    Reading reading = Reading::Bilinear;
    PrewarpSettings prewarp;  // its jump_depth in radii of the ball
    // relief-inverse
    Search search = Search::Slices;
    SliceSettings slices{32, 8};
    SolidEnd end = SolidEnd::Back;
    double thickness = 0.1;  // in radii of the ball
    // relief-box, ldi
    Composite composite = Composite::Depth;
    int layers = 4;
    // morph: two perspective views, so far to both sides of the azimuth
    Morphing morphing = Morphing::View;
    pipeline::Degrees aside{15};
};

// What the pictures show: meshes, or one analytic surface. All is borrowed.
struct RepresentedShape {
    const raster::Scene* models = nullptr;   // its models and lights
    const PlacedSurface* surface = nullptr;  // in place of models
};
BoundingBall bounding_ball(const RepresentedShape& shape);

// The shape as a capture (capture.hpp), unlit, or lit as the source's eye sees it. Filtering and culling as
// `settings` say (layers always hold both sides).
struct ShapeCapture {
    RepresentedShape shape;
    raster::Settings settings;
    pipeline::Material material;  // of an analytic surface
    bool lit = false;
    Result<ReliefTexture> operator()(const ReliefCamera& camera) const;
};

// The object with its pictures. `textures`: one; the two views of a morph; front and back of a solid with a
// back; the layers; the six faces in the order of all_faces.
struct Represented {
    Representation representation = Representation::Geometry;
    RepresentationSettings settings;
    ShapeCapture capture;
    BoundingBall ball;
    std::vector<ReliefTexture> textures;
    std::optional<ReliefSolid> solid;  // of relief-inverse
    std::optional<ConeStepMap> cones;
    std::optional<Correspondence> to1, to0;  // of morph: from the first view to the second, and back
    Scalar jump_depth() const {
        return static_cast<Scalar>(double{settings.prewarp.jump_depth} * ball.radius);
    }
};

// The source's camera for a ball; sources are `texels` wide and high.
Result<ReliefCamera> source_camera(const RepresentationSettings& settings, const BoundingBall& ball);
// The relief texture of one source camera: captured, its depth in as few bits as the settings say.
Result<ReliefTexture> captured_texture(const ShapeCapture& capture, const ReliefCamera& camera,
                                       DepthBits bits);
// The box that a six-faced relief stands on: the ball's.
Box box_round(const BoundingBall& ball);
// The solid of relief-inverse, of the first texture and, with SolidEnd::Back, the second.
ReliefSolid solid_of(const std::vector<ReliefTexture>& textures, const RepresentationSettings& settings,
                     double radius);
// Errors: the captures'; a shape of no extent. Layers are always lit for the viewer.
Result<Represented> represent(Representation representation, const RepresentationSettings& settings,
                              const ShapeCapture& capture);

// Why the pictures cannot be drawn for this camera: its viewer is on or behind the plane of the only one, or
// so near before it that what is warped shrinks to a few texels (nearer than 4 of them, or than 1/16 of the
// picture if that is less: a depth as great as the picture is wide then is as many texels wide); or it is not
// between the two views of a morph (up to half the way beyond either is allowed).
std::optional<pipeline::Error> refusal(const Represented& object, const raster::Camera& camera);

// What a screen gets of the pictures, Representation::Relief included. Errors: those of refusal(); a
// screen that is not perspective.
Result<ViewImage> view_of(const Represented& object, const ReliefCamera& screen, const raster::Scene& scene,
                          const raster::Settings& settings);
// The truth: the shape itself, samples x samples rays or centres a pixel.
Result<ViewImage> true_view(const ShapeCapture& capture, const ReliefCamera& screen,
                            const raster::Scene& scene, const raster::Settings& settings, int samples = 1);

// Into the frame, after raster::draw(): nearer wins. Errors as view_of; a parallel view, for which only
// Representation::Relief is defined.
std::optional<pipeline::Error> draw_represented(const Represented& object, const raster::Scene& scene,
                                                const raster::Settings& settings, raster::Frame& frame);

}  // namespace relevo::relief
