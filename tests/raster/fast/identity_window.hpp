// Scenes whose corners stand on chosen 1/256 of a pixel, whatever the picture's size.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "raster/scene.hpp"
#include "tests/raster/fast/identity.hpp"
#include "tests/support/hard.hpp"

namespace relevo::tests::identity {

// In 1/256 of a pixel, y down. Exact while |x - 128 width| < 2^22, and beyond when width is a power of two.
struct Corner {
    double x, y;
    pipeline::Scalar depth = pipeline::Scalar(0.5);  // Parallel: any, in [0, 1] between near and far
    double w = 1;  // Perspective: a power of two, 1/2 or more; the depth is 1 / (2 w)
};
using Corners = std::array<Corner, 3>;

enum class View { Parallel, Perspective };

class WindowScene {
  public:
    // Every model has colours, a texture or none, and a shininess of its own; every corner a normal and
    // texture coordinates from the random numbers of `seed`.
    WindowScene(Size size, View view, std::uint64_t seed = 1);

    void next_model();
    void without_textures();
    pipeline::Material& material() { return scene_.models.back().material; }  // of the last model
    void add(const Corners& corners);                                         // to the last model
    // The vertices alone; their numbers are those of the order in which they came.
    std::uint32_t add_vertex(const Corner& corner);
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    const raster::Scene& scene();
    Size size() const { return size_; }
    hard::Random& random() { return random_; }
    Corner anywhere(double beyond = 0);  // in the picture, or as many pixels beyond its edge; random depth

  private:
    Size size_;
    View view_;
    hard::Random random_;
    std::vector<std::shared_ptr<pipeline::Mesh>> meshes_;
    raster::Scene scene_;
};

raster::Settings textured_phong();

}  // namespace relevo::tests::identity
