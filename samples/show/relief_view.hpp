// Everything that the step pictures need to know about a relief object of a scene: its texture, the warp for
// the scene's viewer, what the resamplers make of it, and the truth.
#pragma once
#include "relief/error_set.hpp"
#include "relief/representation.hpp"
#include "samples/scene/scene.hpp"
#include "samples/show/canvas.hpp"

namespace relevo::show {

struct ReliefView {
    const scene::LoadedScene* loaded = nullptr;   // borrowed, as is what stands in it
    const scene::ReliefObject* object = nullptr;  // the scene's first
    std::string problem;                          // why there is nothing to show; empty: all below is there
    relief::Represented relief;                   // as Representation::Relief, captured unlit
    relief::ReliefCamera screen;
    relief::Warp warp{};
    relief::Window window;
    relief::Prewarped picture;      // by the scene's resampler, with maps
    relief::ViewImage seen, truth;  // lit, on the screen: warped, and as the object really looks
    const relief::ReliefTexture& texture() const { return relief.textures[0]; }
    relief::PrewarpSettings settings_with(relief::Resampler resampler) const;
    relief::Prewarped warped(const relief::PrewarpSettings& settings) const;
    // The object's pictures in another representation, with these settings.
    relief::Result<relief::Represented> in_another_way(relief::Representation representation,
                                                       const relief::RepresentationSettings& settings) const;
    relief::Result<relief::ViewImage> view(const relief::Represented& object) const;
};
// The scene has a relief object. What cannot be shown (a parallel view, a viewer behind the plane) is said in
// `problem`. A box is looked at by the face that the viewer sees most frontally.
ReliefView relief_view(const scene::LoadedScene& loaded);

// ---- pictures of it ----

Picture color_picture(const relief::Image<relief::LinearRgb>& color,
                      const relief::Image<std::uint8_t>& coverage, raster::Output output);
// Each component of the unit normal, -1 to 1, as a colour from dark to bright.
Picture normal_picture(const relief::Image<relief::Vec3>& normal,
                       const relief::Image<std::uint8_t>& coverage);
// Near is light.
Picture depth_picture(const relief::Image<relief::Scalar>& depth,
                      const relief::Image<std::uint8_t>& coverage);
// The difference of the colours, four times as bright; orange where only `a` has something, sky where only
// `b` has.
Picture difference_picture(const relief::ViewImage& a, const relief::ViewImage& b);

// The warped picture as if its plane were a screen.
relief::ViewImage as_view(const relief::Prewarped& picture);

}  // namespace relevo::show
