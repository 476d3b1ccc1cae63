#include "tests/raster/fast/identity_window.hpp"

#include "pipeline/elementary.hpp"

namespace relevo::tests::identity {

using pipeline::Scalar;
using pipeline::Vec3;

namespace {

const raster::Texture& noise() {
    static const raster::Texture texture = [] {
        hard::Random random(5);
        std::vector<std::uint8_t> rgb(std::size_t(32 * 21 * 3));
        for (std::uint8_t& c : rgb) c = static_cast<std::uint8_t>(random.integer(0, 255));
        return raster::make_texture(32, 21, 3, rgb, raster::Encoding::Srgb);
    }();
    return texture;
}

}  // namespace

WindowScene::WindowScene(Size size, View view, std::uint64_t seed) : size_(size), view_(view), random_(seed) {
    scene_.background = {Scalar(0.25), 0, Scalar(0.125)};
    const Scalar half = Scalar(0.5);
    const pipeline::LinearRgb color =
        seed % 2 ? pipeline::LinearRgb{half, 0, 1} : pipeline::LinearRgb{half, half, half};  // all are grey
    scene_.lights = {{pipeline::Light::Kind::Point, {{1, 2, 5}}, {{0, 0, -1}}, {1, 1, 1}},
                     {pipeline::Light::Kind::Directional, {{0, 0, 0}}, {{-1, -1, -1}}, color}};
    scene_.camera.parallel = view == View::Parallel;
    if (view == View::Perspective) {  // clip = (x, y, 1/2, z)
        scene_.camera.clip_from_eye.m[2] = {0, 0, 0, 1};
        scene_.camera.clip_from_eye.m[3] = {0, 0, 0.5, 0};
    }
    next_model();
}

void WindowScene::next_model() {
    constexpr Scalar shininess[] = {16, Scalar(3.5), 0, 150};
    const std::size_t number = meshes_.size();
    meshes_.push_back(std::make_shared<pipeline::Mesh>());
    raster::Model model{meshes_.back().get(), {}, {}, number % 3 == 2 ? nullptr : &noise(), number % 2 == 1};
    model.material.shininess = shininess[number % 4];
    model.material.color = {Scalar(random_.unit()), Scalar(random_.unit()), Scalar(random_.unit())};
    model.material.diffuse = Scalar(random_.unit());
    scene_.models.push_back(model);
}

void WindowScene::without_textures() {
    for (raster::Model& model : scene_.models) model.texture = nullptr;
}

std::uint32_t WindowScene::add_vertex(const Corner& c) {
    const double half_width = 128.0 * size_.width, half_height = 128.0 * size_.height;
    const auto ndc = [](double of_half) { return static_cast<double>(static_cast<Scalar>(of_half)); };
    const double x = ndc((c.x - half_width) / half_width), y = ndc((half_height - c.y) / half_height);
    const glm::dvec3 p = view_ == View::Parallel ? glm::dvec3(x, y, c.depth) : glm::dvec3(x, y, 1) * c.w;
    const auto number = [&] { return random_.between(-1, 1); };
    std::vector<pipeline::Vertex>& vertices = meshes_.back()->vertices;
    const glm::dvec3 normal(number(), number(), number());
    const glm::dvec2 uv(3 * number(), 3 * number());
    vertices.push_back({{Vec3(p)}, {Vec3(normal)}, pipeline::Vec2(uv)});
    return static_cast<std::uint32_t>(vertices.size() - 1);
}

void WindowScene::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    for (const std::uint32_t i : {a, b, c}) meshes_.back()->indices.push_back(i);
}

void WindowScene::add(const Corners& corners) {
    const std::uint32_t a = add_vertex(corners[0]), b = add_vertex(corners[1]), c = add_vertex(corners[2]);
    add_triangle(a, b, c);
}

Corner WindowScene::anywhere(double beyond) {
    const auto along = [&](int pixels) {
        return static_cast<double>(
            random_.integer(std::int64_t(-256 * beyond), std::int64_t(256 * (pixels + beyond))));
    };
    const double x = along(size_.width), y = along(size_.height);
    return {x, y, Scalar(random_.unit()), pipeline::exp2(double(random_.integer(-1, 5)))};
}

const raster::Scene& WindowScene::scene() { return scene_; }

raster::Settings textured_phong() {
    raster::Settings settings;
    settings.cull = pipeline::Cull::None;
    return settings;
}

}  // namespace relevo::tests::identity
