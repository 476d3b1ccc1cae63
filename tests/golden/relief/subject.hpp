// The small relief textures that the goldens warp, and the places in which a mistake can be made: in what
// goes into the library, in its settings, in what goes from one of its steps to the next, or in the plain
// form (plain.hpp); never in the library itself.
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "relief/prewarp.hpp"
#include "relief/relief_ray.hpp"
#include "relief/view_image.hpp"
#include "tests/golden/product.hpp"

namespace relevo::golden {

// What the plain form does; as it stands, it is right.
struct ReliefRules {
    enum class Weights { Perspective, Linear };
    enum class Codes { Right, DividedBy255, RoundedDown, EmptyIsZero };
    bool plain = false;  // the plain form in the place of the library
    Weights weights = Weights::Perspective;
    bool same_row = false;    // a sample is connected to whatever came last to its column
    bool half_texels = true;  // what has no neighbour sticks out by half a texel
    bool by_sheets = true;    // the epipole cuts the order of painting; else row by row
    Codes codes = Codes::Right;
};

struct ReliefMistake {
    std::string_view name = {}, sentence = {};
    void (*to_source)(relief::ReliefCamera&) = nullptr;    // before the capture
    void (*to_texture)(relief::ReliefTexture&) = nullptr;  // after it
    void (*to_warp)(relief::Warp&) = nullptr;
    void (*to_settings)(relief::PrewarpSettings&) = nullptr;
    void (*to_picture)(relief::Prewarped&, const relief::Warp&) = nullptr;  // the warped one
    void (*to_ray)(relief::ReliefRay&, const relief::Warp&) = nullptr;
    void (*to_product)(Product&) = nullptr;
    ReliefRules rules = {};
    bool clipped = false;   // the window is the source's square
    bool extruded = false;  // no end behind the surface
    bool reversed_depth_test = false;
    int faces = 0;  // of a box: 1 left and right exchanged, 2 front and back exchanged, 3 drawn in order
    bool one_slice_late = false, no_bisection = false;
    bool one_sample = false;  // of the truth, a pixel
};

struct ReliefSubject {
    std::string_view scene;
    bool perspective = false;
    relief::ReliefCamera screen;
    relief::ReliefTexture texture;
    relief::Warp warp;
    relief::Window window;
    relief::PrewarpSettings settings;
    const ReliefMistake* mistake;  // never null; the empty one is right
    // the analytic surface: a picture of it, and its relief texture
    std::function<relief::ReliefTexture(const relief::ReliefCamera&)> capture;
    std::function<relief::ViewImage(const relief::ReliefCamera&, int samples)> truth;
};

// `azimuth` degrees aside, 0.4 times as many up; `perspective`: the source has an eye, 3 in front of the
// object's middle. The screen has twice the source's pixels a side.
ReliefSubject relief_subject(std::string_view scene, double azimuth, bool perspective, int texels,
                             const ReliefMistake& mistake);

// The warped picture, with its maps, by the library or the plain form, as the mistake has it.
relief::Prewarped warped_picture(const ReliefSubject& subject, relief::Resampler resampler);

}  // namespace relevo::golden
