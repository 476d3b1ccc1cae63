#include "tests/golden/mistakes.hpp"

#include <algorithm>
#include <bit>
#include <glm/matrix.hpp>

#include "pipeline/normalize.hpp"

namespace relevo::golden {
namespace {

using pipeline::Mesh;
using pipeline::Scalar;
using pipeline::Vertex;
using raster::Rgba8;

// -------------------------------------------------------------------------------------------------- scenes
template <int row>
void negate_row(Subject& s) {
    for (int c = 0; c < 4; ++c) s.scene.camera.clip_from_eye.m[c][row] *= -1;
}

// A half pixel is 1 / size in units of w.
void half_pixel(Subject& s) {
    glm::dmat4& m = s.scene.camera.clip_from_eye.m;
    for (int c = 0; c < 4; ++c) m[c][0] += m[c][3] / s.width, m[c][1] += m[c][3] / s.height;
}

void no_aspect(Subject& s) {
    for (int c = 0; c < 4; ++c) s.scene.camera.clip_from_eye.m[c][0] *= double(s.width) / s.height;
}

void cull_front(Subject& s) {
    s.settings.cull = s.settings.cull == pipeline::Cull::Front ? pipeline::Cull::Back : pipeline::Cull::Front;
}
void cull_nothing(Subject& s) { s.settings.cull = pipeline::Cull::None; }
void cull_back(Subject& s) { s.settings.cull = pipeline::Cull::Back; }

void reverse_winding(Subject& s) {
    for (Mesh& mesh : s.meshes)
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
            std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
}

// The mirrored models look as if nobody had told the culling.
void forget_mirror(Subject& s) {
    for (raster::Model& model : s.scene.models)
        if (glm::determinant(model.world_from_object.m) < 0)
            for (Mesh& mesh : s.meshes)
                if (&mesh == model.mesh)
                    for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
                        std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
}

void reverse_depth_test(Subject& s) { s.settings.depth = raster::DepthFormat::Float32Forward; }

template <class Change>
void change_vertices(Subject& s, Change change) {
    for (Mesh& mesh : s.meshes)
        for (Vertex& v : mesh.vertices) change(v);
}
void swap_uv(Subject& s) {
    change_vertices(s, [](Vertex& v) { std::swap(v.uv.x, v.uv.y); });
}
void flip_v(Subject& s) {
    change_vertices(s, [](Vertex& v) { v.uv.y = 1 - v.uv.y; });
}
void half_texel(Subject& s) {
    change_vertices(s, [](Vertex& v) { v.uv += pipeline::Vec2{Scalar(1.0 / 16), Scalar(1.0 / 16)}; });
}
void reverse_normals(Subject& s) {
    change_vertices(s, [](Vertex& v) { v.normal.v = -v.normal.v; });
}

// Replaces every normal n by `to(M) n`, M being the linear part of eye_from_object. The machine moves normals
// by the inverse transpose of M, so M^T M makes it move them like points, and M^T not at all.
template <class To>
void change_normals(Subject& s, To to) {
    for (raster::Model& model : s.scene.models)
        for (Mesh& mesh : s.meshes) {
            if (&mesh != model.mesh) continue;
            const glm::dmat3 m((s.scene.camera.eye_from_world * model.world_from_object).m);
            for (Vertex& v : mesh.vertices) v.normal.v = pipeline::Vec3(to(m) * glm::dvec3(v.normal.v));
        }
}
void normals_like_points(Subject& s) {
    change_normals(s, [](const glm::dmat3& m) { return glm::transpose(m) * m; });
}
void normals_stay(Subject& s) {
    change_normals(s, [](const glm::dmat3& m) { return glm::transpose(m); });
}

void light_in_eye_space(Subject& s) {
    const glm::dmat4 back = glm::inverse(s.scene.camera.eye_from_world.m);
    for (pipeline::Light& light : s.scene.lights) {
        light.position.v = pipeline::Vec3(back * glm::dvec4(light.position.v, 1));
        light.direction.v = pipeline::Vec3(back * glm::dvec4(light.direction.v, 0));
    }
}
void one_light(Subject& s) { s.scene.lights.resize(1); }
void white_lights(Subject& s) {
    for (pipeline::Light& light : s.scene.lights) light.color = {1, 1, 1};
}
void lights_reversed(Subject& s) {
    for (pipeline::Light& light : s.scene.lights) light.direction.v = -light.direction.v;
}
template <Scalar pipeline::Material::*term>
void without(Subject& s) {
    for (raster::Model& model : s.scene.models) model.material.*term = 0;
}
void dull(Subject& s) {
    for (raster::Model& model : s.scene.models) model.material.shininess = 1;
}
void far_viewer(Subject& s) { s.scene.camera.parallel = true; }
void one_side(Subject& s) {
    for (raster::Model& model : s.scene.models) model.two_sided = false;
}
template <raster::Shading shading>
void shade(Subject& s) {
    s.settings.shading = shading;
}
void other_filter(Subject& s) {
    s.settings.texture_filter = s.settings.texture_filter == raster::Filter::Nearest
                                    ? raster::Filter::Bilinear
                                    : raster::Filter::Nearest;
}
void no_texture(Subject& s) {
    for (raster::Model& model : s.scene.models) model.texture = nullptr;
}
void other_output(Subject& s) {
    s.settings.output = s.settings.output == raster::Output::Raw ? raster::Output::Srgb : raster::Output::Raw;
}

// ------------------------------------------------------------------------------------------------ products
template <class Pixel>
void flip_rows(raster::Image<Pixel>& image) {
    for (int y = 0; y < image.height() / 2; ++y)
        std::swap_ranges(image.row(y), image.row(y) + image.width(), image.row(image.height() - 1 - y));
}
void upside_down(Product& p) { flip_rows(p.picture), flip_rows(p.numbers); }

void blue_green_red(Product& p) {
    for (Rgba8& c : p.picture.pixels()) std::swap(c.r, c.b);
}

// The smallest change that there is, in the middle of the data.
void one_wrong(Product& p) {
    if (!p.text.empty()) {
        const std::size_t digit = p.text.find_last_of("0123456789");
        p.text[digit] = p.text[digit] == '0' ? '1' : '0';
    } else if (!p.numbers.empty()) {
        float& v = p.numbers.at(p.numbers.width() / 2, p.numbers.height() / 2);
        v = std::bit_cast<float>(std::bit_cast<std::uint32_t>(v) ^ 1u);
    } else {
        p.picture.at(p.picture.width() / 2, p.picture.height() / 2).g ^= 1;
    }
}

using Clipping = Rules::Clipping;
using Snapping = Rules::Snapping;
using Fill = Rules::Fill;
using Depth = Rules::Depth;
using Weights = Rules::Weights;

constexpr Mistake mistakes[] = {
    {"y flipped", "the viewport forgets that rows run downwards", negate_row<1>},
    {"x mirrored", "left and right exchanged", negate_row<0>},
    {"half-pixel shift", "pixel centres taken for pixel corners in the viewport", half_pixel},
    {"no aspect", "the projection forgets that the picture is wider than high", no_aspect},
    {"wrong cull sign", "front faces are dropped in place of back faces", cull_front},
    {"no culling", "back faces are drawn", cull_nothing},
    {"culled", "back faces are dropped where they should stay", cull_back},
    {"winding reversed", "corners read in the other order", reverse_winding},
    {"mirror forgotten", "a mirrored model is culled like any other", forget_mirror},
    {"depth test reversed", "the farther one wins", reverse_depth_test},
    {"u and v swapped", "texture coordinates in the other order", swap_uv},
    {"v flipped", "the texture upside down", flip_v},
    {"half-texel shift", "texel corners taken for texel centres", half_texel},
    {"other filter", "nearest for bilinear, or the other way around", other_filter},
    {"no texture", "the texture is not looked up", no_texture},
    {"normals reversed", "normals point inwards", reverse_normals},
    {"normals like points", "normals moved by the matrix of the points", normals_like_points},
    {"normals stay", "normals of object space used in eye space", normals_stay},
    {"light in eye space", "the lights' places are not moved by the view", light_in_eye_space},
    {"one light", "only the first light counts", one_light},
    {"white lights", "the lights' colours are forgotten", white_lights},
    {"direction reversed", "a directional light shines from where it should go", lights_reversed},
    {"no ambient", "the ambient term is missing", without<&pipeline::Material::ambient>},
    {"no diffuse", "the diffuse term is missing", without<&pipeline::Material::diffuse>},
    {"no specular", "the specular term is missing", without<&pipeline::Material::specular>},
    {"no exponent", "the cosine of the highlight is not raised to its power", dull},
    {"far viewer", "the viewer is taken to be infinitely far away", far_viewer},
    {"one side", "back faces are lit by the outward normal", one_side},
    {"unlit", "no light at all", shade<raster::Shading::Unlit>},
    {"flat", "one light a face", shade<raster::Shading::Flat>},
    {"gouraud", "one light a corner", shade<raster::Shading::Gouraud>},
    {"phong", "one light a pixel", shade<raster::Shading::Phong>},
    {"wrong transfer", "linear light written as sRGB codes, or the other way around", other_output},
    {"no near plane", "not clipped at the near plane", nullptr, {.clipping = Clipping::NoNear}},
    {"no far plane", "not clipped at the far plane", nullptr, {.clipping = Clipping::NoFar}},
    {"no guard band", "clipped at the picture's sides", nullptr, {.clipping = Clipping::NoGuardBand}},
    {"clipped in float",
     "new corners computed in single precision",
     nullptr,
     {.clipping = Clipping::InFloat}},
    {"clipped from the first corner",
     "a + t (b - a), whichever end lies inside",
     nullptr,
     {.clipping = Clipping::FromFirstCorner}},
    {"not pinned", "new corners lie beside their plane", nullptr, {.clipping = Clipping::NotPinned}},
    {"snapped down",
     "window coordinates cut off, not rounded, to 1/256",
     nullptr,
     {.snapping = Snapping::Down}},
    {"ties up", "half subpixels rounded up, not to even", nullptr, {.snapping = Snapping::HalfUp}},
    {"sixteenths", "window coordinates rounded to 1/16 pixel", nullptr, {.snapping = Snapping::Sixteenths}},
    {"whole pixels",
     "window coordinates cut off to whole pixels",
     nullptr,
     {.snapping = Snapping::WholePixels}},
    {"no top-left rule", "edges belong to nobody", nullptr, {.fill = Fill::Open}},
    {"inclusive edges", "edges belong to both sides", nullptr, {.fill = Fill::Closed}},
    {"bottom-right rule", "edges belong to the other side", nullptr, {.fill = Fill::BottomRight}},
    {"corner sampled", "the upper left corner of a pixel decides", nullptr, {.sample = 0}},
    {"depth ignored", "the last one drawn wins", nullptr, {.depth = Depth::Ignored}},
    {"later wins ties", "at equal depth the last one drawn wins", nullptr, {.depth = Depth::LaterWinsTies}},
    {"affine", "interpolated in the window, without 1/w", nullptr, {.weights = Weights::Affine}},
    {"weights permuted", "weights at the wrong corners", nullptr, {.weights = Weights::Permuted}},
    {"depth corrected",
     "the perspective correction applied to depth, too",
     nullptr,
     {.weights = Weights::DepthCorrected}},
    {"upside down", "rows stored from bottom to top", nullptr, {}, upside_down},
    {"blue green red", "red and blue exchanged", nullptr, {}, blue_green_red},
    {"one wrong", "one bit of one value", nullptr, {}, one_wrong},
    {"truncated", "colours cut off, not rounded", nullptr, {}, nullptr, true},
};

}  // namespace

std::span<const Mistake> all_mistakes() { return mistakes; }

const Mistake* find_mistake(std::string_view name) {
    const auto found = std::find_if(std::begin(mistakes), std::end(mistakes),
                                    [&](const Mistake& m) { return m.name == name; });
    return found == std::end(mistakes) ? nullptr : &*found;
}

Product mistaken(const Case& which, const Mistake& mistake) {
    Subject subject = which.make();
    if (mistake.to_scene) mistake.to_scene(subject);
    Product product = mistake.truncates          ? truncated_product_of(subject)
                      : mistake.rules == Rules{} ? product_of(which.stage, subject)
                                                 : plain_product_of(which.stage, subject, mistake.rules);
    if (mistake.to_product) mistake.to_product(product);
    return product;
}

}  // namespace relevo::golden
