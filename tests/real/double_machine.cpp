#include "tests/real/double_machine.hpp"

#include <deque>

#include "raster/draw.hpp"

// CMakeLists.txt gives the namespace of pipeline/ and raster/ another name here.
static_assert(sizeof(relevo::pipeline::Scalar) == sizeof(double));

namespace double_machine {
namespace {

namespace pipeline = relevo::pipeline;
namespace raster = relevo::raster;

glm::dmat4 matrix(const Matrix& m) {
    glm::dmat4 out;
    for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = m[std::size_t(i)];
    return out;
}
pipeline::Vec3 three(const Three& v) { return {v[0], v[1], v[2]}; }
pipeline::LinearRgb rgb(const Three& v) { return {v[0], v[1], v[2]}; }

pipeline::Mesh mesh_of(const Model& model) {
    pipeline::Mesh mesh;
    for (const auto& v : model.vertices)
        mesh.vertices.push_back({{{v[0], v[1], v[2]}}, {{v[3], v[4], v[5]}}, {v[6], v[7]}});
    mesh.indices = model.indices;
    return mesh;
}

raster::Texture texture_of(const Texture& texture) {
    return {texture.width, texture.height, texture.texels, texture.raw ? 1.0 / 255 : 1.0 / 65535};
}

pipeline::Light light_of(const Light& light) {
    return {light.directional ? pipeline::Light::Kind::Directional : pipeline::Light::Kind::Point,
            {three(light.position)},
            {three(light.direction)},
            rgb(light.color)};
}

}  // namespace

Pictures draw(const Scene& in) {
    std::deque<pipeline::Mesh> meshes;
    std::deque<raster::Texture> textures;
    for (const Texture& texture : in.textures) textures.push_back(texture_of(texture));
    raster::Scene scene;
    for (const Model& model : in.models) {
        meshes.push_back(mesh_of(model));
        scene.models.push_back(
            {&meshes.back(),
             {matrix(model.world_from_object)},
             {model.ambient, model.diffuse, model.specular, model.shininess, rgb(model.color)},
             model.texture < 0 ? nullptr : &textures[std::size_t(model.texture)],
             model.two_sided});
    }
    for (const Light& light : in.lights) scene.lights.push_back(light_of(light));
    scene.camera = {{matrix(in.eye_from_world)}, {matrix(in.clip_from_eye)}, in.parallel};
    scene.background = rgb(in.background);
    const raster::Settings settings{
        static_cast<raster::Shading>(in.shading), static_cast<raster::Filter>(in.filter),
        static_cast<raster::DepthFormat>(in.depth), static_cast<pipeline::Cull>(in.cull),
        static_cast<raster::Output>(in.output)};
    raster::Frame frame{
        raster::Image<raster::Rgba8>(in.width, in.height), raster::Image<double>(in.width, in.height), {}};
    raster::draw(scene, settings, frame);
    Pictures out;
    for (const raster::Rgba8& c : frame.color.pixels()) out.color.push_back({c.r, c.g, c.b, c.a});
    out.depth.assign(frame.depth.pixels().begin(), frame.depth.pixels().end());
    return out;
}

}  // namespace double_machine
