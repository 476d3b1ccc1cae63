// The light equation (pipeline/light.hpp) at a point of the world, for the lights and the viewer of a scene;
// and with it a relief texture whose colours are lit.
#pragma once
#include "pipeline/light.hpp"
#include "raster/model_setup.hpp"
#include "relief/relief_texture.hpp"

namespace relevo::relief {

class SceneLight {
  public:
    SceneLight(const raster::Scene& scene, const pipeline::Material& material)
        : lights_(raster::lights_in_eye_space(scene)),
          lighting_{lights_,
                    material.ambient,
                    material.diffuse,
                    material.specular,
                    pipeline::exponent(material.shininess),
                    scene.camera.parallel},
          eye_from_world_(scene.camera.eye_from_world),
          eye_normal_(pipeline::normal_map(scene.camera.eye_from_world)) {}
    SceneLight(const SceneLight&) = delete;  // the lighting points into it
    SceneLight& operator=(const SceneLight&) = delete;

    glm::dvec3 to_eye(const glm::dvec3& world) const {
        return glm::dvec3(eye_from_world_.m * glm::dvec4(world, 1));
    }
    // `eye`: the point in eye space; `normal`: in the world, of any length but zero.
    LinearRgb lit(const LinearRgb& base, const Vec3& eye, const Vec3& normal) const {
        const Vec3 n = pipeline::normalize(
            (eye_normal_ * pipeline::Normal<pipeline::World>{pipeline::normalize(normal)}).v);
        return pipeline::reflected(base, pipeline::reflect(lighting_, eye, n));
    }

  private:
    std::vector<pipeline::EyeLight> lights_;
    pipeline::Lighting lighting_;
    pipeline::Affine<pipeline::Eye, pipeline::World> eye_from_world_;
    pipeline::NormalMap<pipeline::Eye, pipeline::World> eye_normal_;
};

// Every texel's colour as the viewer of the scene sees the surface's point, whatever the source's eye saw.
inline void light_texture(ReliefTexture& texture, const SceneLight& light) {
    for (int y = 0; y < texture.camera.height; ++y)
        for (int x = 0; x < texture.camera.width; ++x)
            if (texture.coverage.at(x, y))
                texture.color.at(x, y) =
                    light.lit(texture.color.at(x, y), Vec3(light.to_eye(world_point(texture, x, y))),
                              texture.normal.at(x, y));
}

}  // namespace relevo::relief
