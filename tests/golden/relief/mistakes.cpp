#include "tests/golden/relief/mistakes.hpp"

#include <algorithm>
#include <bit>

namespace relevo::golden {
namespace {

using namespace relief;

// ---------------------------------------------------------------------------------------------- the source
template <class Pixel>
void flip_rows(raster::Image<Pixel>& image) {
    for (int y = 0; y < image.height() / 2; ++y)
        std::swap_ranges(image.row(y), image.row(y) + image.width(), image.row(image.height() - 1 - y));
}
void bottom_row_first(ReliefTexture& t) {
    flip_rows(t.color), flip_rows(t.normal), flip_rows(t.depth), flip_rows(t.coverage);
}
void half_a_texel(ReliefCamera& c) { c.corner += 0.5 * (c.a + c.b); }
void inwards(ReliefTexture& t) {
    for (Vec3& n : t.normal.pixels()) n = -n;
}
// "Empty" told by a depth at the bottom of everything.
void magic_depth(ReliefTexture& t) {
    const Scalar deepest = depth_range(t).high;
    const bool perspective = t.camera.projection == Projection::Perspective;
    for (std::size_t i = 0; i < t.depth.pixels().size(); ++i)
        if (!t.coverage.pixels()[i]) {
            t.coverage.pixels()[i] = 1;
            t.depth.pixels()[i] = perspective ? deepest / 2 : deepest + Scalar(0.5);
        }
}
void from_the_back(ReliefTexture& t) {
    const DepthRange range = depth_range(t);
    for (std::size_t i = 0; i < t.depth.pixels().size(); ++i)
        if (t.coverage.pixels()[i]) t.depth.pixels()[i] = range.low + range.high - t.depth.pixels()[i];
}

// ------------------------------------------------------------------------------------------------ the warp
void wrong_sign(Warp& w) { w.k1 = -w.k1, w.k2 = -w.k2; }
void k1_for_k2(Warp& w) { w.k2 = w.k1; }
void no_division(Warp& w) { w.k3 = 0; }
void reversed(PrewarpSettings& s) {
    s.painting = s.painting == Painting::Right ? Painting::Reversed : Painting::Right;
}
void other_jump(PrewarpSettings& s) { s.jump = s.jump == Jump::Skin ? Jump::Cut : Jump::Skin; }

// --------------------------------------------------------------------------------------- the warped picture
void flat(Prewarped& p, const Warp&) {
    for (Scalar& d : p.depth.pixels()) d = 0;
}
// X = P + d (P - T), not divided by h
void without_h(Prewarped& p, const Warp& warp) {
    for (Scalar& d : p.depth.pixels()) d *= static_cast<Scalar>(warp.h);
}
void normals_inwards(Prewarped& p, const Warp&) {
    for (Vec3& n : p.normal.pixels()) n = -n;
}
void no_normals(Prewarped& p, const Warp&) {
    for (Vec3& n : p.normal.pixels()) n = {0, 0, -1};
}
void sources_exchanged(Prewarped& p, const Warp&) {
    for (pipeline::Vec2& s : p.source.pixels()) std::swap(s.x, s.y);
}
void sources_at_corners(Prewarped& p, const Warp&) {
    for (pipeline::Vec2& s : p.source.pixels()) s -= pipeline::Vec2(Scalar(0.5));
}
void window_at_square(Prewarped& p, const Warp&) { p.window.x0 = 0, p.window.y0 = 0; }

// ------------------------------------------------------------------------------------------------- the rays
void ray_sign(ReliefRay& r, const Warp&) { r.slope = -r.slope; }
void ray_k1_for_k2(ReliefRay& r, const Warp& w) {
    r.slope.y += w.projection == Projection::Orthographic ? w.k2 - w.k1 : w.k1 - w.k2;
}
void ray_straight_in(ReliefRay& r, const Warp&) { r.slope = {0, 0}; }

// ------------------------------------------------------------------------------------------------- products
void rows_from_below(Product& p) { flip_rows(p.picture), flip_rows(p.numbers); }
void one_bit(Product& p) {
    if (!p.numbers.empty()) {
        for (float& v : p.numbers.pixels())
            if (v != 0) return void(v = std::bit_cast<float>(std::bit_cast<std::uint32_t>(v) ^ 1u));
    }
    p.picture.at(p.picture.width() / 2, p.picture.height() / 2).g ^= 1;
}
void one_code(Product& p) { p.picture.at(p.picture.width() / 3, p.picture.height() / 2).b ^= 1; }

using Codes = ReliefRules::Codes;

constexpr ReliefMistake mistakes[] = {
    {.name = "bottom row first",
     .sentence = "row 0 of the source is its lowest",
     .to_texture = bottom_row_first},
    {.name = "half a texel beside",
     .sentence = "corners of texels taken for centres",
     .to_source = half_a_texel},
    {.name = "relief normals inwards", .sentence = "normals point into the object", .to_texture = inwards},
    {.name = "magic depth", .sentence = "empty texels are surfaces, very deep", .to_texture = magic_depth},
    {.name = "depth from the back", .sentence = "the nearest is the deepest", .to_texture = from_the_back},
    {.name = "wrong sign of the warp", .sentence = "minus k1, minus k2", .to_warp = wrong_sign},
    {.name = "k1 for k2",
     .sentence = "the second row of the warp has the constant of the first",
     .to_warp = k1_for_k2},
    {.name = "not divided by 1 + k3 d", .sentence = "k3 forgotten", .to_warp = no_division},
    {.name = "wrong order",
     .sentence = "painted the other way, as the thesis prints it",
     .to_settings = reversed},
    {.name = "cut for skin", .sentence = "the surface is cut at jumps of depth", .to_settings = other_jump},
    {.name = "depth of the plane", .sentence = "the polygon's own depth is written", .to_picture = flat},
    {.name = "missing h",
     .sentence = "the depth that is written is not divided by h",
     .to_picture = without_h},
    {.name = "warped normals inwards", .sentence = "lit from the wrong side", .to_picture = normals_inwards},
    {.name = "one normal for all",
     .sentence = "the polygon's normal, not the picture's",
     .to_picture = no_normals},
    {.name = "sources exchanged", .sentence = "u for v in the offset map", .to_picture = sources_exchanged},
    {.name = "sources at corners",
     .sentence = "the offset map counts from texel corners",
     .to_picture = sources_at_corners},
    {.name = "window at the square's corner",
     .sentence = "the polygon begins where the source does",
     .to_picture = window_at_square},
    {.name = "ray of the wrong sign", .sentence = "the ray is searched the other way", .to_ray = ray_sign},
    {.name = "ray with k1 for k2",
     .sentence = "the inverse as the thesis prints it",
     .to_ray = ray_k1_for_k2},
    {.name = "ray straight in", .sentence = "no parallax", .to_ray = ray_straight_in},
    {.name = "rows from below",
     .sentence = "the picture is stored from bottom to top",
     .to_product = rows_from_below},
    {.name = "one bit", .sentence = "one bit of one value", .to_product = one_bit},
    {.name = "one code", .sentence = "one number is off by one", .to_product = one_code},
    {.name = "linear weights",
     .sentence = "interpolated without h / (h + d)",
     .rules = {.plain = true, .weights = ReliefRules::Weights::Linear}},
    {.name = "same row",
     .sentence = "a second sample of a row is drawn from the first one of that row",
     .rules = {.plain = true, .same_row = true}},
    {.name = "no half texels",
     .sentence = "runs end at the centre of their last texel",
     .rules = {.plain = true, .half_texels = false}},
    {.name = "row by row",
     .sentence = "the epipole is ignored",
     .rules = {.plain = true, .by_sheets = false}},
    {.name = "255 for 254",
     .sentence = "the code for empty is a depth, too",
     .rules = {.plain = true, .codes = Codes::DividedBy255}},
    {.name = "codes rounded down",
     .sentence = "cut off, not rounded",
     .rules = {.plain = true, .codes = Codes::RoundedDown}},
    {.name = "empty is code 0",
     .sentence = "empty texels are the nearest ones",
     .rules = {.plain = true, .codes = Codes::EmptyIsZero}},
    {.name = "no window", .sentence = "cut off at the source's square", .clipped = true},
    {.name = "extruded", .sentence = "everything behind the surface is solid", .extruded = true},
    {.name = "farther wins", .sentence = "the depth test reversed", .reversed_depth_test = true},
    {.name = "left and right exchanged", .sentence = "two faces of the box change places", .faces = 1},
    {.name = "front and back exchanged", .sentence = "two faces of the box change places", .faces = 2},
    {.name = "faces in order", .sentence = "the last face drawn wins, no depth is compared", .faces = 3},
    {.name = "one slice late", .sentence = "the slice behind the one that was hit", .one_slice_late = true},
    {.name = "one sample a pixel", .sentence = "the truth is not averaged", .one_sample = true},
    {.name = "no bisection", .sentence = "the slice itself", .no_bisection = true},
};

}  // namespace

std::span<const ReliefMistake> all_relief_mistakes() { return mistakes; }

const ReliefMistake* find_relief_mistake(std::string_view name) {
    const auto found = std::find_if(std::begin(mistakes), std::end(mistakes),
                                    [&](const ReliefMistake& m) { return m.name == name; });
    return found == std::end(mistakes) ? nullptr : &*found;
}

}  // namespace relevo::golden
