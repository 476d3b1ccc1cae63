#include "relief/representation.hpp"

#include "pipeline/elementary.hpp"
#include "relief/draw_relief.hpp"
#include "relief/inverse_texels.hpp"
#include "relief/inverse_view.hpp"
#include "relief/map_plane.hpp"
#include "relief/quantize.hpp"
#include "relief/ray_cast.hpp"
#include "relief/relaxed_cone_map.hpp"
#include "relief/screen.hpp"
#include "relief/sprite.hpp"
#include "relief/sprite_with_depth.hpp"
#include "relief/view_morph.hpp"

namespace relevo::relief {
namespace {

using pipeline::Error;

bool is_lit(const raster::Settings& settings) { return settings.shading != raster::Shading::Unlit; }

// The colours of a texture that was captured unlit, for this viewer.
ReliefTexture lit_for(const Represented& object, ReliefTexture texture, const raster::Scene& scene,
                      const raster::Settings& settings) {
    if (object.settings.lit == Lit::Drawn && is_lit(settings))
        light_texture(texture, SceneLight(scene, object.capture.material));
    return texture;
}

// The forms with one plane: warped for the viewer, and what the plane then shows.
struct OnPlane {
    Warp warp;
    Prewarped picture;
};
Result<OnPlane> on_plane(const Represented& object, const ReliefTexture& texture, const Viewer& viewer) {
    const auto warp = make_warp(texture.camera, viewer);
    if (!warp) return warp.error();
    if (object.representation == Representation::Sprite) return OnPlane{*warp, unwarped(texture)};
    const auto window = target_window(texture.camera, *warp, depth_range(texture));
    if (!window) return window.error();
    if (object.representation == Representation::SpriteDepth)
        return OnPlane{*warp, warp_sprite_with_depth(texture, *warp, *window, double{object.jump_depth()})};
    PrewarpSettings settings = object.settings.prewarp;
    settings.jump_depth = object.jump_depth();
    // a thread costs more than a hundred columns
    settings.threads = std::clamp(settings.threads, 1, std::max(window->width / 128, 1));
    return OnPlane{*warp, prewarp(texture, *warp, *window, settings)};
}

Result<ViewImage> inverse(const Represented& object, const ReliefTexture& texture,
                          const ReliefCamera& screen) {
    const ReliefSolid& solid = *object.solid;
    const SliceSettings& slices = object.settings.slices;
    return inverse_view(texture, solid, screen, [&](const ReliefRay& ray) {
        switch (object.settings.search) {
            case Search::Texels:
                return find_by_texels(solid, ray);
            case Search::Cones:
                return find_by_cones(solid, *object.cones, ray);
            case Search::RelaxedCones:
                return find_by_relaxed_cones(solid, *object.cones, ray, slices.bisections);
            case Search::Slices:
                break;
        }
        return find_by_slices(solid, ray, slices);
    });
}

// The view between the two whose eye is nearest to the screen's, as a depth image of its own: a plain morph
// knows no depth, and is flat on the plane through the middle of the object.
Result<ViewImage> morphed(const Represented& object, const std::vector<ReliefTexture>& views,
                          const ReliefCamera& screen) {
    const ReliefCamera &camera0 = views[0].camera, &camera1 = views[1].camera;
    const glm::dvec3 way = camera1.eye - camera0.eye;
    const double s = std::clamp(glm::dot(screen.eye - camera0.eye, way) / glm::dot(way, way), 0.0, 1.0);
    const double jump = double{object.jump_depth()};
    const bool plain = object.settings.morphing == Morphing::Plain;
    const ViewImage view0 = as_seen(views[0]), view1 = as_seen(views[1]);
    const auto picture = plain
                             ? Result<ViewImage>(morph(view0, view1, *object.to1, *object.to0, s, jump))
                             : view_morph(camera0, view0, camera1, view1, *object.to1, *object.to0, s, jump);
    if (!picture) return picture.error();
    ReliefTexture between = make_relief_texture(view_between(camera0, camera1, s));
    const double distance = view_depth(between.camera, between.camera.corner),
                 middle = view_depth(between.camera, object.ball.centre);
    between.color = picture->color, between.coverage = picture->coverage;
    for (std::size_t i = 0; i < between.depth.pixels().size(); ++i)
        if (between.coverage.pixels()[i])
            between.depth.pixels()[i] = static_cast<Scalar>(
                std::min(distance / (plain ? middle : double{picture->depth.pixels()[i]}), 1.0));
    ViewImage image(screen.width, screen.height);
    draw_view_mesh(between, screen, jump, image);
    return image;
}

Viewer viewer_of(const raster::Camera& camera) {
    const glm::dmat4 world_from_eye = glm::inverse(camera.eye_from_world.m);
    return camera.parallel ? viewer_toward(glm::dvec3(world_from_eye[2]))
                           : viewer_at(glm::dvec3(world_from_eye[3]));
}

// Drawn on, or searched from, the plane of the first texture.
bool has_one_plane(Representation representation) {
    using enum Representation;
    return representation == Relief || representation == ReliefInverse || representation == Sprite ||
           representation == SpriteDepth;
}

}  // namespace

BoundingBall bounding_ball(const RepresentedShape& shape) {
    if (shape.surface) return bounding_ball(*shape.surface);
    const auto for_each = [&](auto&& visit) {
        for (const raster::Model& model : shape.models->models)
            for (const pipeline::Vertex& v : model.mesh->vertices) {
                const glm::dvec3 p(model.world_from_object.m * glm::dvec4(glm::dvec3(v.position.v), 1));
                if (is_finite(p)) visit(p);
            }
    };
    bool any = false;
    glm::dvec3 low(0), high(0);
    for_each([&](const glm::dvec3& p) {
        low = any ? glm::min(low, p) : p, high = any ? glm::max(high, p) : p;
        any = true;
    });
    BoundingBall ball{0.5 * (low + high), 0};
    double most = 0;
    for_each([&](const glm::dvec3& p) { most = std::max(most, glm::dot(p - ball.centre, p - ball.centre)); });
    ball.radius = std::sqrt(most);
    return ball;
}

Result<ReliefTexture> ShapeCapture::operator()(const ReliefCamera& camera) const {
    raster::Settings unlit = settings;
    unlit.shading = raster::Shading::Unlit;
    auto texture = shape.surface ? RayCapture{*shape.surface}(camera)
                                 : capture_raster(*shape.models, camera, lit ? settings : unlit);
    if (!texture || !lit || !shape.surface || !is_lit(settings)) return texture;
    raster::Scene seen;
    seen.lights = shape.models->lights;
    seen.camera = raster_camera(camera, 1);
    light_texture(*texture, SceneLight(seen, material));
    return texture;
}

Result<ReliefCamera> source_camera(const RepresentationSettings& settings, const BoundingBall& ball) {
    using pipeline::cos, pipeline::sin;
    const double flat = cos(settings.elevation);
    const glm::dvec3 outwards(flat * sin(settings.azimuth), sin(settings.elevation),
                              flat * cos(settings.azimuth));
    // looking straight down, the picture's upper side is away from where azimuth says the viewer stands
    const glm::dvec3 up =
        std::fabs(flat) > 1e-6
            ? glm::dvec3(0, 1, 0)
            : (outwards.y > 0 ? -1.0 : 1.0) * glm::dvec3(sin(settings.azimuth), 0, cos(settings.azimuth));
    const SourceView view{-outwards, up, settings.texels, settings.texels};
    // from `away` radii the ball's outline is seen under the angle whose tangent is 1 / sqrt(away^2 - 1)
    const bool parallel = settings.projection == Projection::Orthographic;
    const double away = settings.distance;
    const double radii = parallel ? 1 : (away - 1) / std::sqrt(away * away - 1);
    auto camera = orthographic_camera(view, ball.centre + ball.radius * outwards, 2 * radii * ball.radius);
    if (camera && !parallel) {
        camera->projection = Projection::Perspective;
        camera->eye = ball.centre + away * ball.radius * outwards;
    }
    return camera;
}

Result<ReliefTexture> captured_texture(const ShapeCapture& capture, const ReliefCamera& camera,
                                       DepthBits bits) {
    auto texture = capture(camera);
    if (!texture) return texture;
    if (bits == DepthBits::Eight) {
        const auto codes = quantize<std::uint8_t>(*texture);
        return with_depth(*std::move(texture), codes);
    }
    if (bits == DepthBits::Sixteen) {
        const auto codes = quantize<std::uint16_t>(*texture);
        return with_depth(*std::move(texture), codes);
    }
    return texture;
}

Box box_round(const BoundingBall& ball) { return {ball.centre - ball.radius, ball.centre + ball.radius}; }

ReliefSolid solid_of(const std::vector<ReliefTexture>& textures, const RepresentationSettings& settings,
                     double radius) {
    ReliefSolid solid = settings.end == SolidEnd::None ? extruded_solid(textures[0])
                        : settings.end == SolidEnd::Thickness
                            ? solid_of_thickness(textures[0], settings.thickness * radius)
                            : solid_between(textures[0], textures[1], settings.thickness * radius);
    solid.reading = settings.reading;
    solid.jump = double{settings.prewarp.jump_depth} * radius;
    return solid;
}

Result<Represented> represent(Representation representation, const RepresentationSettings& settings,
                              const ShapeCapture& capture) {
    Represented object{representation, settings, capture, bounding_ball(capture.shape), {}, {}, {}, {}, {}};
    object.capture.lit = settings.lit == Lit::Captured;
    if (settings.radius > 0) object.ball.radius = settings.radius;
    if (!(object.ball.radius > 0)) return Error{"the object has no extent"};
    if (representation == Representation::Geometry) return object;
    const auto take = [&](const Result<ReliefCamera>& camera) -> std::optional<Error> {
        if (!camera) return camera.error();
        auto texture = captured_texture(object.capture, *camera, settings.bits);
        if (!texture) return texture.error();
        object.textures.push_back(*std::move(texture));
        return {};
    };
    if (representation == Representation::ReliefBox) {
        for (const Face face : all_faces)
            if (auto error = take(face_camera(box_round(object.ball), face, settings.texels)))
                return *std::move(error);
        return object;
    }
    if (representation == Representation::Morph) {
        RepresentationSettings view = settings;
        view.projection = Projection::Perspective;
        for (const double side : {-1.0, 1.0}) {
            view.azimuth = {settings.azimuth.value + side * settings.aside.value};
            if (auto error = take(source_camera(view, object.ball))) return *std::move(error);
        }
        const auto maps = make_view_morph(object.textures[0].camera, object.textures[1].camera, 0.5);
        if (!maps) return maps.error();
        object.to1 = true_correspondence(object.textures[0], object.textures[1].camera);
        object.to0 = true_correspondence(object.textures[1], object.textures[0].camera);
        return object;
    }
    const auto camera = source_camera(settings, object.ball);
    if (!camera) return camera.error();
    if (representation == Representation::Ldi) {
        if (capture.shape.surface) {
            object.textures = ray_cast_layers(*capture.shape.surface, *camera, settings.layers);
            return object;
        }
        auto layers =
            capture_raster_layers(*capture.shape.models, *camera, settings.layers, capture.settings);
        if (!layers) return layers.error();
        object.textures = *std::move(layers);
        return object;
    }
    if (auto error = take(camera)) return *std::move(error);
    if (representation != Representation::ReliefInverse) return object;
    if (settings.end == SolidEnd::Back)
        if (auto error = take(opposite_camera(*camera, 2 * object.ball.radius))) return *std::move(error);
    object.solid = solid_of(object.textures, settings, object.ball.radius);
    if (settings.search == Search::Cones) object.cones = make_cone_step_map(*object.solid);
    if (settings.search == Search::RelaxedCones) object.cones = make_relaxed_cone_map(*object.solid);
    return object;
}

Result<ViewImage> true_view(const ShapeCapture& capture, const ReliefCamera& screen,
                            const raster::Scene& scene, const raster::Settings& settings, int samples) {
    ShapeCapture unlit = capture;
    unlit.lit = false;
    auto texture = unlit(refined(screen, samples));
    if (!texture) return texture.error();
    if (is_lit(settings)) light_texture(*texture, SceneLight(scene, capture.material));
    return samples == 1 ? as_seen(*texture) : reduced(as_seen(*texture), samples);
}

Result<ViewImage> view_of(const Represented& object, const ReliefCamera& screen, const raster::Scene& scene,
                          const raster::Settings& settings) {
    if (screen.projection != Projection::Perspective) return Error{"a parallel view has no eye"};
    if (object.representation == Representation::Geometry)
        return true_view(object.capture, screen, scene, settings);
    std::vector<ReliefTexture> textures;
    for (const ReliefTexture& texture : object.textures)
        textures.push_back(lit_for(object, texture, scene, settings));
    const double jump = double{object.jump_depth()};
    switch (object.representation) {
        case Representation::ReliefBox: {
            BoxRelief box{box_round(object.ball), {}};
            std::move(textures.begin(), textures.end(), box.face.begin());
            return draw_box(box, screen, {jump, object.settings.composite});
        }
        case Representation::Ldi:
            return draw_layers(textures, screen, jump);
        case Representation::Morph:
            return morphed(object, textures, screen);
        case Representation::ReliefInverse:
            return inverse(object, textures[0], screen);
        default:
            break;
    }
    const auto plane = on_plane(object, textures[0], viewer_at(screen.eye));
    if (!plane) return plane.error();
    return map_plane(plane->picture, textures[0].camera, plane->warp, screen, object.settings.reading,
                     object.jump_depth());
}

std::optional<Error> refusal(const Represented& object, const raster::Camera& camera) {
    if (object.representation == Representation::Morph) {
        // seen from the middle of the object, at most half the way beyond one of the two views
        const glm::dvec3 eye0 = object.textures[0].camera.eye - object.ball.centre,
                         eye1 = object.textures[1].camera.eye - object.ball.centre,
                         eye = glm::dvec3(viewer_of(camera).place) - object.ball.centre, way = eye1 - eye0;
        const double along = glm::dot(eye - eye0, way) / glm::dot(way, way);
        if (std::fabs(along - 0.5) <= 1 && glm::dot(eye, eye0 + eye1) > 0) return {};
        return Error{"the viewer does not stand between the two views of the morph"};
    }
    if (!has_one_plane(object.representation)) return {};
    const ReliefTexture& texture = object.textures[0];
    const auto warp = make_warp(texture.camera, viewer_of(camera));
    if (!warp) return warp.error();
    const bool warped = object.representation == Representation::Relief ||
                        object.representation == Representation::SpriteDepth;
    const auto window = target_window(texture.camera, *warp, depth_range(texture));
    if (warped && !window) return window.error();
    const ReliefCamera& source = texture.camera;
    const double texel = std::sqrt(std::max(glm::dot(source.a, source.a), glm::dot(source.b, source.b))),
                 least = std::min(4.0, std::max(source.width, source.height) / 16.0) * texel;
    if (warped && warp->h < least)
        return Error{"the viewer is too near to the relief's plane: the warped picture is a few texels wide"};
    return {};
}

std::optional<Error> draw_represented(const Represented& object, const raster::Scene& scene,
                                      const raster::Settings& settings, raster::Frame& frame) {
    if (object.representation == Representation::Relief) {
        const Viewer viewer = viewer_of(scene.camera);
        const auto plane = on_plane(object, object.textures[0], viewer);
        if (!plane) return plane.error();
        raster::Settings drawn = settings;
        if (object.settings.lit == Lit::Captured) drawn.shading = raster::Shading::Unlit;
        draw_relief({&plane->picture, object.textures[0].camera, viewer, object.capture.material,
                     object.settings.reading, object.jump_depth()},
                    scene, drawn, frame);
        return {};
    }
    const auto screen =
        screen_camera(scene.camera, settings.depth, frame.depth.width(), frame.depth.height());
    if (!screen) return screen.error();
    const auto image = view_of(object, *screen, scene, settings);
    if (!image) return image.error();
    draw_view_image(*image, scene.camera, settings, frame);
    return {};
}

}  // namespace relevo::relief
