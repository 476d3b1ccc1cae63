// What a cheaper setting costs: flat and Gouraud shading against Phong's, forward depth beside reversed, the
// fast path beside the textbook's.
#include "pipeline/light.hpp"
#include "pipeline/projection.hpp"
#include "raster/path.hpp"
#include "tests/accuracy/measurement.hpp"

namespace relevo::accuracy {
namespace {

using pipeline::Degrees;
using pipeline::Scalar;
using pipeline::Vec3;

// ------------------------------------------------------------------------------------------------- shading
// Directions in one plane: the angle is counted from the viewer.
Vec3 direction(double degrees) {
    return {static_cast<Scalar>(pipeline::sin(Degrees{degrees})), 0,
            static_cast<Scalar>(pipeline::cos(Degrees{degrees}))};
}

enum class Term { Diffuse, Specular };
enum class Instead { Flat, Gouraud };

Scalar lit(Term term, const pipeline::EyeLight& light, const Vec3& normal) {
    const bool diffuse = term == Term::Diffuse;
    const pipeline::Lighting lighting{{&light, 1},
                                      0,
                                      diffuse ? Scalar(1) : Scalar(0),
                                      diffuse ? Scalar(0) : Scalar(1),
                                      pipeline::exponent(32),
                                      true};
    const auto [amount, gloss] = pipeline::reflect(lighting, {0, 0, 0}, normal);
    return diffuse ? amount.r : gloss.r;
}

// Over an edge whose corners' normals stand `apart` degrees from each other, for lights all around.
Measured against_phong(Instead instead, Term term, double apart) {
    Measured worst;
    for (double middle = -60; middle <= 60; middle += 5)
        for (double from = -180; from < 180; from += 2) {
            const pipeline::EyeLight light{true, direction(from), {1, 1, 1}};
            const Vec3 a = direction(middle - apart / 2), b = direction(middle + apart / 2);
            const Scalar at_a = lit(term, light, a), at_b = lit(term, light, b);
            const Scalar flat = lit(term, light, direction(middle));
            for (int i = 0; i <= 20; ++i) {
                const Scalar t = Scalar(i) / 20;
                const Scalar phong = lit(term, light, pipeline::normalize(a + t * (b - a)));
                const Scalar ours = instead == Instead::Flat ? flat : at_a + t * (at_b - at_a);
                worst.see(std::abs(double(ours) - double(phong)), [&] {
                    return text("light %g, middle normal %g degrees from the viewer, %d/20 of the edge", from,
                                middle, i);
                });
            }
        }
    return worst;
}

template <Instead instead, Term term, int apart>
Measured shading() {
    return against_phong(instead, term, apart);
}

// --------------------------------------------------------------------------------------------------- depth
// The widest step between two distances, as a share of the distance, that the depth buffer does not see:
// among the float distances that follow `z`.
Measured unseen_step(pipeline::DepthRange range, float z) {
    const auto map = pipeline::rounded(*pipeline::perspective({60}, 1, 0.1, 10000, range));
    const auto depth_of = [&](float distance) {
        const auto p = map * pipeline::Point<pipeline::Eye>{{0, 0, static_cast<Scalar>(-distance)}};
        return p.v.z / p.v.w;
    };
    Measured worst;
    float first = z;
    Scalar depth = depth_of(first);
    for (int i = 0; i < 1 << 19; ++i) {
        z = std::nextafter(z, 1e30f);
        if (const Scalar next = depth_of(z); next != depth) {
            worst.see((double(z) - first) / first, [&] { return text("from %.9g to %.9g", first, z); });
            first = z, depth = next;
        }
    }
    return worst;
}

template <pipeline::DepthRange range, int tenths>
Measured depth_at() {
    return unseen_step(range, float(tenths) / 10);
}

// ---------------------------------------------------------------------------------------------------- path
// Pixels of random triangles whose colour or depth is another one on the fast path (tests/raster/fast looks
// everywhere).
Measured fast_path() {
    constexpr int width = 203, height = 151;
    Random random(7);
    const auto number = [&] { return static_cast<Scalar>(random.between(-3, 3)); };
    pipeline::Mesh mesh;
    for (std::uint32_t i = 0; i < 600; ++i) {
        mesh.vertices.push_back({{{number(), number(), number() - 4}}, {{number(), number(), number()}}, {}});
        mesh.indices.push_back(i);
    }
    raster::Model model;
    model.mesh = &mesh;
    raster::Scene scene;
    scene.models = {model};
    scene.lights = {{.position = {{4, 8, 6}}}};
    scene.camera.clip_from_eye =
        *pipeline::perspective(Degrees{60}, double(width) / height, 0.5, 100, pipeline::DepthRange::Reversed);
    raster::Settings settings;
    settings.cull = pipeline::Cull::None;
    raster::fast::Workspace workspace;
    raster::Frame frames[2];
    for (raster::Frame& frame : frames) {
        frame = {raster::Image<raster::Rgba8>(width, height), raster::Image<Scalar>(width, height), {}};
        settings.path = &frame == frames ? raster::Path::Textbook : raster::Path::Auto;
        render(scene, settings, frame, workspace);
    }
    int different = 0;
    for (std::size_t i = 0; i < std::size_t(width) * height; ++i)
        different += frames[0].color.pixels()[i] != frames[1].color.pixels()[i] ||
                     frames[0].depth.pixels()[i] != frames[1].depth.pixels()[i];
    return {double(different) / (width * height), text("%d of the pixels", different)};
}

using enum Instead;
using enum Term;
using enum pipeline::DepthRange;
constexpr Measurement measurements[] = {
    {"path, fast", fast_path},
    {"gouraud, diffuse, 10 degrees", shading<Gouraud, Diffuse, 10>},
    {"gouraud, diffuse, 20 degrees", shading<Gouraud, Diffuse, 20>},
    {"gouraud, diffuse, 40 degrees", shading<Gouraud, Diffuse, 40>},
    {"gouraud, specular, 10 degrees", shading<Gouraud, Specular, 10>},
    {"gouraud, specular, 20 degrees", shading<Gouraud, Specular, 20>},
    {"gouraud, specular, 40 degrees", shading<Gouraud, Specular, 40>},
    {"flat, diffuse, 10 degrees", shading<Flat, Diffuse, 10>},
    {"flat, diffuse, 20 degrees", shading<Flat, Diffuse, 20>},
    {"flat, diffuse, 40 degrees", shading<Flat, Diffuse, 40>},
    {"flat, specular, 10 degrees", shading<Flat, Specular, 10>},
    {"flat, specular, 20 degrees", shading<Flat, Specular, 20>},
    {"flat, specular, 40 degrees", shading<Flat, Specular, 40>},
    {"float32-reversed at 0.2", depth_at<Reversed, 2>},
    {"float32-reversed at 30", depth_at<Reversed, 300>},
    {"float32-reversed at 1000", depth_at<Reversed, 10000>},
    {"float32-reversed at 9000", depth_at<Reversed, 90000>},
    {"float32-forward at 0.2", depth_at<Forward, 2>},
    {"float32-forward at 30", depth_at<Forward, 300>},
    {"float32-forward at 1000", depth_at<Forward, 10000>},
    {"float32-forward at 9000", depth_at<Forward, 90000>},
};

}  // namespace

std::span<const Measurement> knob_measurements() { return measurements; }

}  // namespace relevo::accuracy
