#include "relief/capture_raster.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <optional>
#include <utility>

#include "raster/draw.hpp"

namespace relevo::relief {
namespace {

using glm::cross, glm::dot, glm::dmat3, glm::dmat4, glm::dvec3, glm::dvec4;

dvec3 normalized(const dvec3& v) { return v / std::sqrt(dot(v, v)); }

// Columns: the eye's axes in the world. x along a, y upwards in the picture, z towards the viewer.
dmat3 eye_axes(const ReliefCamera& camera) {
    const dvec3 right = normalized(camera.a), back = -forward(camera);
    return {right, cross(back, right), back};
}
dvec3 eye_place(const ReliefCamera& camera) {
    return camera.projection == Projection::Perspective ? camera.eye : camera.corner;
}

// Hears Phong's fragments, which carry point and normal in eye space. The last one of a texel is the visible
// one.
class FragmentKeeper {
  public:
    FragmentKeeper(const raster::Scene& scene, ReliefTexture& texture)
        : scene_(scene), texture_(texture), axes_(eye_axes(texture.camera)), eye_(eye_place(texture.camera)) {
        for (const raster::Model& model : scene.models)
            end_.push_back((end_.empty() ? 0 : end_.back()) + model.mesh->triangles());
    }

    // Point, normal and depth of the fragment's triangle on the texel's own ray; none of another shading.
    struct Seen {
        Vec3 normal;
        Scalar depth;
    };
    std::optional<Seen> seen(const raster::FragmentShaded& fragment) const {
        const auto& carried = fragment.varying;
        if (carried.size() < 6) return {};  // not Phong's
        const dvec3 point = eye_ + axes_ * dvec3(carried[0], carried[1], carried[2]);
        dvec3 normal = axes_ * dvec3(carried[3], carried[4], carried[5]);
        const dvec3 face = face_normal(fragment.primitive);
        if (!(dot(normal, normal) > 0)) normal = face;
        if (dot(normal, normal) > 0) normal = normalized(normal);
        const Ray ray = capture_ray(texture_.camera, fragment.x + 0.5, fragment.y + 0.5);
        return Seen{Vec3(normal), stored_depth(texture_.camera.projection, meet(ray, point, face))};
    }

    void on(const raster::FragmentShaded& fragment) {
        const auto found = seen(fragment);
        if (!found) return;
        texture_.normal.at(fragment.x, fragment.y) = found->normal;
        texture_.depth.at(fragment.x, fragment.y) = found->depth;
        texture_.coverage.at(fragment.x, fragment.y) = 1;
    }

  private:
    // Where the ray meets the plane through the point; for a face that is edge-on, or has no area, where it
    // passes the point.
    static double meet(const Ray& ray, const dvec3& point, const dvec3& face) {
        const dvec3 way = point - ray.origin, d = ray.direction;
        const double across = dot(face, d), squared = dot(d, d);
        const double passes = dot(way, d) / squared;
        const double meets = dot(face, way) / across;
        const bool edge_on = !(across * across > 1e-8 * squared * dot(face, face));
        return edge_on ? passes : meets;
    }

    dvec3 face_normal(std::size_t primitive) const {
        const auto model_number =
            std::size_t(std::upper_bound(end_.begin(), end_.end(), primitive) - end_.begin());
        const raster::Model& model = scene_.models[model_number];
        const std::size_t first = model_number == 0 ? 0 : end_[model_number - 1];
        const std::uint32_t* i = &model.mesh->indices[3 * (primitive - first)];
        const auto corner = [&](int k) {
            return dvec3(model.world_from_object.m * dvec4(dvec3(model.mesh->vertices[i[k]].position.v), 1));
        };
        return cross(corner(1) - corner(0), corner(2) - corner(0));
    }

    const raster::Scene& scene_;
    ReliefTexture& texture_;
    dmat3 axes_;
    dvec3 eye_;
    std::vector<std::size_t> end_;  // the first primitive after each model
};

// Depth peeling without repeating: what wipes the depth buffer after every fragment sees them all, in the
// order in which the machine draws, whatever hides what. A first run notes the colours, a second one sorts
// point and colour into the layers of their texel.
class LayerKeeper {
  public:
    LayerKeeper(const raster::Scene& scene, std::vector<ReliefTexture>& layers, raster::Frame& frame)
        : keeper_(scene, layers.front()), layers_(layers), frame_(frame) {}

    void on(const raster::FragmentShaded& fragment) {
        frame_.depth.at(fragment.x, fragment.y) = raster::cleared_depth(raster::DepthFormat::Float32Reversed);
        const auto seen = keeper_.seen(fragment);
        if (!seen) return colors_.push_back(fragment.color);
        insert(fragment.x, fragment.y, *seen, colors_[next_++]);
    }

  private:
    // Behind those that are nearer; what falls out at the end is behind the last layer.
    void insert(int x, int y, FragmentKeeper::Seen seen, LinearRgb color) {
        const bool parallel = layers_.front().camera.projection == Projection::Orthographic;
        for (ReliefTexture& layer : layers_) {
            const bool there = layer.coverage.at(x, y) != 0;
            const bool nearer =
                parallel ? seen.depth < layer.depth.at(x, y) : seen.depth > layer.depth.at(x, y);
            if (there && !nearer) continue;
            std::swap(seen.depth, layer.depth.at(x, y)), std::swap(seen.normal, layer.normal.at(x, y));
            std::swap(color, layer.color.at(x, y));
            layer.coverage.at(x, y) = 1;
            if (!there) return;
        }
    }

    FragmentKeeper keeper_;
    std::vector<ReliefTexture>& layers_;
    raster::Frame& frame_;
    std::vector<LinearRgb> colors_;
    std::size_t next_ = 0;
};

}  // namespace

double depth_of_scene(const raster::Scene& scene, const ReliefCamera& camera) {
    const dvec3 f = forward(camera);
    double far = 0;
    for (const raster::Model& model : scene.models)
        for (const pipeline::Vertex& v : model.mesh->vertices) {
            const dvec3 p(model.world_from_object.m * dvec4(dvec3(v.position.v), 1));
            if (const double d = dot(p - camera.corner, f); std::isfinite(d)) far = std::max(far, d);
        }
    return far;
}

raster::Camera raster_camera(const ReliefCamera& camera, double far) {
    const dmat3 axes = eye_axes(camera);
    const dvec3 eye = eye_place(camera);
    const bool parallel = camera.projection == Projection::Orthographic;
    const dmat3 eye_from_world = glm::transpose(axes);
    // (alpha, beta, gamma): u, v and the displacement; or, times gamma = 1 / disparity, u and v.
    const dmat3 texels_from_world =
        glm::inverse(dmat3(camera.a, camera.b, parallel ? forward(camera) : camera.corner - camera.eye));
    const dmat3 texels_from_eye = texels_from_world * axes;
    const auto row = [&](int r) {
        return dvec4(texels_from_eye[0][r], texels_from_eye[1][r], texels_from_eye[2][r], 0);
    };
    // The near plane a little before the source's, as capture_ray has it, and wide enough for float.
    const double slack = 1e-6, near = slack * far, range = far > 0 ? far * (1 + 2 * slack) : 1;
    const dvec4 one(0, 0, 0, 1), w = parallel ? one : row(2);
    const dvec4 x = row(0) * (2.0 / camera.width) - w, y = w - row(1) * (2.0 / camera.height);
    const dvec4 z = parallel ? one - (row(2) + near * one) / range : (1 - slack) * one;
    raster::Camera result;
    result.eye_from_world.m = dmat4(dvec4(eye_from_world[0], 0), dvec4(eye_from_world[1], 0),
                                    dvec4(eye_from_world[2], 0), dvec4(-(eye_from_world * eye), 1));
    result.clip_from_eye.m = glm::transpose(dmat4(x, y, z, w));
    result.parallel = parallel;
    return result;
}

Result<ReliefTexture> capture_raster(const raster::Scene& scene, const ReliefCamera& camera,
                                     raster::Settings settings) {
    if (auto error = refusal(camera)) return *std::move(error);
    ReliefTexture texture = make_relief_texture(camera);
    raster::Scene seen = scene;
    seen.camera = raster_camera(camera, depth_of_scene(scene, camera));
    settings.depth = raster::DepthFormat::Float32Reversed;
    raster::Frame frame{
        {camera.width, camera.height}, {camera.width, camera.height}, {camera.width, camera.height}};
    raster::draw(seen, settings, frame);
    const Image<LinearRgb> color = std::move(frame.linear);
    frame.linear = {};
    settings.shading = raster::Shading::Phong;
    raster::draw(seen, settings, frame, FragmentKeeper(scene, texture));
    for (std::size_t i = 0; i < color.pixels().size(); ++i)
        if (texture.coverage.pixels()[i]) texture.color.pixels()[i] = color.pixels()[i];
    return texture;
}

Result<std::vector<ReliefTexture>> capture_raster_layers(const raster::Scene& scene,
                                                         const ReliefCamera& camera, int layers,
                                                         raster::Settings settings) {
    if (auto error = refusal(camera)) return *std::move(error);
    std::vector<ReliefTexture> peeled(std::size_t(layers), make_relief_texture(camera));
    raster::Scene seen = scene;
    seen.camera = raster_camera(camera, depth_of_scene(scene, camera));
    settings.depth = raster::DepthFormat::Float32Reversed;
    settings.cull = pipeline::Cull::None;
    raster::Frame frame{{camera.width, camera.height}, {camera.width, camera.height}, {}};
    LayerKeeper keeper(scene, peeled, frame);
    settings.shading = raster::Shading::Unlit;
    raster::draw(seen, settings, frame, keeper);
    settings.shading = raster::Shading::Phong;
    raster::draw(seen, settings, frame, keeper);
    return peeled;
}

}  // namespace relevo::relief
