// What the choices of relief/ cost in the picture, each at the worst of three objects: one smooth, one of 61
// spheres, one of 40 that hide one another. Where nothing else is said: a source of 128 x 128 texels seen 25
// degrees from its side on 256 x 256 pixels, by the interleaved resampler, float displacements and skins,
// against rays cast at the object. The worst input tells the whole error set.
#include <memory>

#include "relief/box.hpp"
#include "relief/inverse_slices.hpp"
#include "relief/inverse_view.hpp"
#include "relief/layered_depth_image.hpp"
#include "relief/map_plane.hpp"
#include "relief/quantize.hpp"
#include "relief/representation.hpp"
#include "relief/self_shadow.hpp"
#include "relief/view_morph.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/accuracy/measurement.hpp"
#include "tests/relief/image_experiment.hpp"

namespace relevo::accuracy {
namespace {

using namespace relief;

constexpr int source_size = 128, screen_size = 256;
constexpr struct {
    const char* name;
    const Spheres* surface;
} objects[] = {
    {"sphere", &scene::sphere_object}, {"bumpy", &scene::bumpy_object}, {"complex", &scene::complex_object}};

std::string told(const char* name, const ErrorSet& e) {
    return text("%s: missing %.2f %%, extra %.2f %%, PSNR %.2f dB, depth %.4f, bad %.2f %%", name,
                e.missing_percent, e.extra_percent, e.psnr, e.mean_depth_error, e.bad_percent);
}

// `picture(surface, viewer)` of each object, and the number of the error set that counts.
template <class Picture>
Measured worst_of(double ErrorSet::*number, Picture&& picture) {
    Measured worst;
    const ReliefCamera viewer = tests::experiment_viewer(25, screen_size);
    for (const auto& [name, surface] : objects) {
        const ErrorSet error = error_set(picture(*surface, viewer), ray_cast_view(*surface, viewer));
        worst.see(error.*number, [&, name = name] { return told(name, error); });
    }
    return worst;
}

ViewImage warped(const ReliefTexture& texture, const ReliefCamera& viewer,
                 const PrewarpSettings& settings = {}) {
    const Warp warp = *make_warp(texture.camera, viewer_at(viewer.eye));
    const Window window = *target_window(texture.camera, warp, depth_range(texture));
    return map_plane(prewarp(texture, warp, window, settings), texture.camera, warp, viewer,
                     Reading::Bilinear, Scalar(0.3));
}
Measured of_settings(const PrewarpSettings& settings) {
    return worst_of(&ErrorSet::bad_percent, [&](const Spheres& surface, const ReliefCamera& viewer) {
        return warped(ray_cast(surface, tests::experiment_source(source_size)), viewer, settings);
    });
}

template <Resampler resampler>
Measured of_resampler() {
    return of_settings({.resampler = resampler});
}
Measured of_cut() { return of_settings({.jump = Jump::Cut}); }
Measured of_cut_missing() {
    return worst_of(&ErrorSet::missing_percent, [](const Spheres& surface, const ReliefCamera& viewer) {
        return warped(ray_cast(surface, tests::experiment_source(source_size)), viewer, {.jump = Jump::Cut});
    });
}
Measured of_skin_missing() {
    return worst_of(&ErrorSet::missing_percent, [](const Spheres& surface, const ReliefCamera& viewer) {
        return warped(ray_cast(surface, tests::experiment_source(source_size)), viewer);
    });
}

// How far the codes move a texel of the warped picture, in texels; seen from 1.6 radii before the plane.
template <class Code>
Measured of_bits() {
    Measured worst;
    const ReliefCamera viewer = tests::experiment_viewer(25, screen_size, 2.6);
    for (const auto& [name, surface] : objects) {
        const ReliefTexture texture = ray_cast(*surface, tests::experiment_source(256)),
                            coded = with_depth(texture, quantize<Code>(texture));
        const Warp warp = *make_warp(texture.camera, viewer_at(viewer.eye));
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) {
                if (!texture.coverage.at(x, y)) continue;
                const WarpedPoint a = warp_texel(warp, texture, x, y), b = warp_texel(warp, coded, x, y);
                worst.see(std::max(std::abs(a.u - b.u), std::abs(a.v - b.v)),
                          [&, name = name] { return text("%s, texel %d, %d", name, x, y); });
            }
    }
    return worst;
}
template <class Code>
Measured of_bits_in_the_picture() {
    return worst_of(&ErrorSet::bad_percent, [](const Spheres& surface, const ReliefCamera& viewer) {
        const ReliefTexture texture = ray_cast(surface, tests::experiment_source(source_size));
        return warped(with_depth(texture, quantize<Code>(texture)), viewer);
    });
}

// The depth that slices find, seen from the front: no side of a pillar is in the way.
template <int slices, int bisections>
Measured of_slices() {
    Measured worst;
    const ReliefCamera viewer = tests::experiment_viewer(0, screen_size);
    for (const auto& [name, surface] : objects) {
        const ReliefTexture texture = ray_cast(*surface, tests::experiment_source(256));
        ReliefSolid solid = extruded_solid(texture);
        solid.low = 0, solid.high = 2, solid.reading = Reading::Bilinear;
        const ViewImage image = *inverse_view(texture, solid, viewer, [&](const ReliefRay& ray) {
            return find_by_slices(solid, ray, {slices, bisections});
        });
        const ViewImage finest = *inverse_view(texture, solid, viewer, [&](const ReliefRay& ray) {
            return find_by_slices(solid, ray, {slices, 30});
        });
        const ErrorSet error = error_set(image, finest);
        worst.see(error.mean_depth_error, [&, name = name] { return told(name, error); });
    }
    return worst;
}

Measured of_perspective_source() {
    return worst_of(&ErrorSet::bad_percent, [](const Spheres& surface, const ReliefCamera& viewer) {
        const ReliefCamera source = *perspective_camera({{0, 0, 1}, {0, 1, 0}, source_size, source_size},
                                                        {0, 0, -3.2}, 2.2, {2 * 18.3});
        return warped(ray_cast(surface, source), viewer);
    });
}

// What surfaces behind the first `count` would show.
template <int count>
Measured of_layers() {
    return worst_of(&ErrorSet::missing_percent, [](const Spheres& surface, const ReliefCamera& viewer) {
        return draw_layers(ray_cast_layers(surface, tests::experiment_source(source_size), count), viewer,
                           0.3);
    });
}

// The view between two that stand 30 degrees apart.
template <Morphing morphing>
Measured of_morphing() {
    Measured worst;
    const ReliefCamera view0 = tests::experiment_viewer(-15, screen_size),
                       view1 = tests::experiment_viewer(15, screen_size),
                       between = view_between(view0, view1, 0.5);
    for (const auto& [name, surface] : objects) {
        const ReliefTexture texture0 = ray_cast(*surface, view0), texture1 = ray_cast(*surface, view1);
        const ViewImage picture0 = as_seen(texture0), picture1 = as_seen(texture1);
        const Correspondence to1 = true_correspondence(texture0, view1),
                             to0 = true_correspondence(texture1, view0);
        const ViewImage picture = morphing == Morphing::Plain
                                      ? morph(picture0, picture1, to1, to0, 0.5, 0.3)
                                      : *view_morph(view0, picture0, view1, picture1, to1, to0, 0.5, 0.3);
        const ErrorSet error = error_set(picture, ray_cast_view(*surface, between));
        worst.see(error.bad_percent, [&, name = name] { return told(name, error); });
    }
    return worst;
}

// Pixels that a far light reaches and should not, or the other way round.
Measured of_self_shadow() {
    Measured worst;
    const ReliefCamera viewer = tests::experiment_viewer(25, screen_size),
                       source = tests::experiment_source(256);
    const ReliefLight light{{0.8, 0.5, -1, 0}};
    for (const auto& [name, surface] : objects) {
        const ReliefTexture texture = ray_cast(*surface, source);
        ReliefSolid solid = solid_between(texture, ray_cast(*surface, opposite_camera(source, 2)));
        solid.reading = Reading::Bilinear;
        const auto found = *inverse_shadows(
            texture, solid, viewer,
            [&](const ReliefRay& ray) {
                return find_by_slices(solid, ray, {128, 8});
            },
            light);
        const ShadowError error = shadow_error(found, cast_shadows(*surface, viewer, light));
        worst.see(100.0 * error.wrong / error.seen,
                  [&, name = name] { return text("%s: %d of %d pixels", name, error.wrong, error.seen); });
    }
    return worst;
}

// What no face saw, on a full turn and from above and below: the first `count` of front, right, back, left,
// top, bottom.
template <int count>
Measured of_faces() {
    constexpr Face order[] = {Face::Back, Face::Right, Face::Front, Face::Left, Face::Top, Face::Bottom};
    Measured worst;
    for (const auto& [name, surface] : objects) {
        const auto capture = [&, surface = surface](const ReliefCamera& camera) -> Result<ReliefTexture> {
            return ray_cast(*surface, camera);
        };
        BoxRelief box = *capture_box(capture, {glm::dvec3(-1.001), glm::dvec3(1.001)}, source_size);
        for (int i = count; i < 6; ++i) {
            ReliefTexture& face = box.face[std::size_t(order[i])];
            face = make_relief_texture(face.camera);
        }
        for (const double up : {-60.0, 0.0, 60.0})
            for (double aside = 0; aside < 360; aside += up == 0 ? 45 : 90) {
                using pipeline::Degrees;
                const Degrees a{aside}, e{up};
                const glm::dvec3 eye = 3.2 * glm::dvec3(sin(a) * cos(e), sin(e), -cos(a) * cos(e));
                const ReliefCamera viewer =
                    *perspective_camera({-eye, {0, 1, 0}, screen_size, screen_size}, eye, 1, {45});
                const ErrorSet error = error_set(draw_box(box, viewer), ray_cast_view(*surface, viewer));
                worst.see(error.missing_percent, [&, name = name] {
                    return text("%g aside, %g up, ", aside, up) + told(name, error);
                });
            }
    }
    return worst;
}

constexpr Measurement measurements[] = {
    {"relief, splat", of_resampler<Resampler::Splat>},
    {"relief, one-dimensional", of_resampler<Resampler::OneDimensional>},
    {"relief, asymmetric", of_resampler<Resampler::Asymmetric>},
    {"relief, compensated", of_resampler<Resampler::Compensated>},
    {"relief, interleaved", of_resampler<Resampler::Interleaved>},
    {"relief, mesh", of_resampler<Resampler::Mesh>},
    {"relief, skin, missing", of_skin_missing},
    {"relief, cut", of_cut},
    {"relief, cut, missing", of_cut_missing},
    {"relief, perspective source", of_perspective_source},
    {"relief, 16-bit displacement", of_bits_in_the_picture<std::uint16_t>},
    {"relief, 8-bit displacement", of_bits_in_the_picture<std::uint8_t>},
    {"16-bit displacement", of_bits<std::uint16_t>},
    {"8-bit displacement", of_bits<std::uint8_t>},
    {"8 slices", of_slices<8, 0>},
    {"16 slices", of_slices<16, 0>},
    {"32 slices", of_slices<32, 0>},
    {"64 slices", of_slices<64, 0>},
    {"128 slices", of_slices<128, 0>},
    {"256 slices", of_slices<256, 0>},
    {"32 slices, 8 bisections", of_slices<32, 8>},
    {"layers, 1", of_layers<1>},
    {"layers, 2", of_layers<2>},
    {"layers, 4", of_layers<4>},
    {"layers, 6", of_layers<6>},
    {"morphing, plain", of_morphing<Morphing::Plain>},
    {"morphing, view", of_morphing<Morphing::View>},
    {"self-shadow", of_self_shadow},
    {"relief box, 1 face", of_faces<1>},
    {"relief box, 2 faces", of_faces<2>},
    {"relief box, 3 faces", of_faces<3>},
    {"relief box, 4 faces", of_faces<4>},
    {"relief box, 5 faces", of_faces<5>},
    {"relief box, 6 faces", of_faces<6>},
};

}  // namespace

std::span<const Measurement> relief_measurements() { return measurements; }

}  // namespace relevo::accuracy
