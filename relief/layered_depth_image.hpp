// Layered depth images: behind the first surface of every texel also the second, the third... (Shade,
// Gortler, He and Szeliski, SIGGRAPH 1998; Clua 2004, 3.2). What one relief texture loses when the viewer
// moves, since something else stood before it, is there.
//
// A layer is a relief texture of the same camera. Surfaces that turn their back to the source are layers,
// too: whoever looks from aside sees round the edge at some of them.
#pragma once
#include <vector>

#include "relief/ray_cast.hpp"
#include "relief/view_mesh.hpp"

namespace relevo::relief {

// Depth peeling by rays: each goes on from where the last layer stopped it. Layers may be empty.
template <RayCastable Surface>
std::vector<ReliefTexture> ray_cast_layers(const Surface& surface, const ReliefCamera& camera, int layers) {
    std::vector<ReliefTexture> peeled(std::size_t(layers), make_relief_texture(camera));
    const double hair =
        camera.projection == Projection::Perspective
            ? 1e-7
            : 1e-7 * camera.width * std::sqrt(glm::dot(camera.a, camera.a));  // beyond the surface just met
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            Ray ray = capture_ray(camera, x + 0.5, y + 0.5);
            for (ReliefTexture& texture : peeled) {
                const auto hit = first_hit(surface, ray);
                if (!hit) break;
                ray.from = hit->t + hair;
                texture.color.at(x, y) = hit->color;
                texture.normal.at(x, y) = Vec3(hit->normal);
                texture.depth.at(x, y) = stored_depth(camera.projection, hit->t);
                texture.coverage.at(x, y) = 1;
            }
        }
    return peeled;
}

namespace layers_detail {

// What all drawings of the layers ask of them: behind the plane, along its normal; and which side they show.
struct Samples {
    enum Side : std::uint8_t { None, Front, Back };
    const ReliefTexture& texture;
    Image<double> depth;
    Image<Side> side;
};
inline Samples samples_of(const ReliefTexture& texture) {
    const ReliefCamera& camera = texture.camera;
    Samples samples{texture, {camera.width, camera.height}, {camera.width, camera.height}};
    const glm::dvec3 along = forward(camera);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            if (!texture.coverage.at(x, y)) continue;
            const glm::dvec3 sight = source_ray(camera, x + 0.5, y + 0.5).direction;
            const bool away = glm::dot(glm::dvec3(texture.normal.at(x, y)), sight) > 0;
            samples.depth.at(x, y) = glm::dot(world_point(texture, x, y) - camera.corner, along);
            samples.side.at(x, y) = away ? Samples::Back : Samples::Front;
        }
    return samples;
}

// What one layer has of one side of the surfaces: of those that face the source, or of those that turn their
// back to it.
//
// Its half texels lead to where the surface goes on: half-way to the neighbour, in whichever layer that is.
// Where there is none the surface has its outline, and there the front of a body meets its back: of a ball,
// d = D - c sqrt(s) meets d = D + c sqrt(s), whatever the distance s from the outline. So both lead to
// half-way between them, and whoever looks from aside does not see past the rim, or into the body.
class Grid {
  public:
    Grid(const std::vector<Samples>& layers, const ReliefCamera& viewer, double jump, std::size_t layer,
         Samples::Side side)
        : layers_(layers), grid_(layers[layer].texture, viewer), jump_(jump), layer_(layer), side_(side) {}

    int width() const { return grid_.width(); }
    int height() const { return grid_.height(); }
    bool covered(int x, int y) const { return shows(layer_, x, y, side_); }
    double depth(int x, int y) const { return layers_[layer_].depth.at(x, y); }
    LinearRgb color(int x, int y, double by_u, double by_v) const { return point(x, y, by_u, by_v).color; }
    std::optional<MovedPoint> moved(int x, int y, double by_u, double by_v) const {
        const Point p = point(x, y, by_u, by_v);
        return grid_.moved(p.u, p.v, p.depth);
    }

  private:
    struct Point {
        double u = 0, v = 0;
        Scalar depth = 0;  // as stored
        LinearRgb color{};
    };
    static Point sum(const Point& a, const Point& b) {
        return {a.u + b.u, a.v + b.v, a.depth + b.depth, a.color + b.color};
    }
    static Point times(Scalar k, const Point& a) {
        return {double{k} * a.u, double{k} * a.v, k * a.depth, k * a.color};
    }

    bool shows(std::size_t layer, int x, int y, Samples::Side side) const {
        return layers_[layer].side.holds(x, y) && layers_[layer].side.at(x, y) == side;
    }
    Point sample(std::size_t layer, int x, int y) const {
        const ReliefTexture& texture = layers_[layer].texture;
        return {x + 0.5, y + 0.5, texture.depth.at(x, y), texture.color.at(x, y)};
    }

    // The layer in which the surface goes on that lies so deep beside.
    std::optional<std::size_t> layer_near(int x, int y, double depth) const {
        std::optional<std::size_t> nearest;
        double least = jump_;
        for (std::size_t k = 0; k < layers_.size(); ++k) {
            if (!shows(k, x, y, side_)) continue;
            if (const double apart = std::fabs(layers_[k].depth.at(x, y) - depth); apart <= least)
                least = apart, nearest = k;
        }
        return nearest;
    }
    // Half-way between the front of a body and its back.
    Point outline(std::size_t layer, int x, int y) const {
        const Point here = sample(layer, x, y);
        const Samples::Side other = side_ == Samples::Front ? Samples::Back : Samples::Front;
        const std::ptrdiff_t step = side_ == Samples::Front ? 1 : -1;
        for (auto k = std::ptrdiff_t(layer) + step; k >= 0 && k < std::ssize(layers_); k += step)
            if (shows(std::size_t(k), x, y, other))
                return times(Scalar(0.5), sum(here, sample(std::size_t(k), x, y)));
        return here;
    }

    // Where the surface ends on the way that leads from the texel outwards, one step a texel. From front to
    // back it is g = 2 c sqrt(s) here and g1 = 2 c sqrt(s + 1) one step inwards: so the outline is s texels
    // away.
    Point end(std::size_t layer, int x, int y, int step_x, int step_y) const {
        Point end = outline(layer, x, y);
        const double g = std::fabs(double{end.depth} - double{sample(layer, x, y).depth});
        double s = 0.5;
        if (const auto inner = layer_near(x - step_x, y - step_y, layers_[layer].depth.at(x, y));
            inner && g > 0) {
            const Point p = sample(*inner, x - step_x, y - step_y);
            const double g1 = double{outline(*inner, x - step_x, y - step_y).depth} - double{p.depth};
            if (g1 * g1 > g * g) s = std::min(g * g / (g1 * g1 - g * g), 1.0);
        }
        end.u += s * step_x, end.v += s * step_y;
        return end;
    }

    // The point where the pixel's quarter meets those beside it: the mean of the texels round it if the
    // surface goes on in all, else of the ends of all ways that lead from one of them, along rows and
    // columns, to one where it does not.
    Point point(int x, int y, double by_u, double by_v) const {
        const int beside = (by_u > 0) - (by_u < 0), below = (by_v > 0) - (by_v < 0);
        const int columns = beside == 0 ? 1 : 2, rows = below == 0 ? 1 : 2;
        const double here = depth(x, y);
        Point inside, ends;
        int texels = 0, ways = 0;
        for (int i = 0; i < columns; ++i)
            for (int j = 0; j < rows; ++j) {
                const int at_x = x + i * beside, at_y = y + j * below, out_x = i == 0 ? beside : -beside,
                          out_y = j == 0 ? below : -below;
                const auto layer = layer_near(at_x, at_y, here);
                if (!layer) continue;
                inside = sum(inside, sample(*layer, at_x, at_y)), ++texels;
                if (out_x != 0 && !layer_near(at_x + out_x, at_y, here))
                    ends = sum(ends, end(*layer, at_x, at_y, out_x, 0)), ++ways;
                if (out_y != 0 && !layer_near(at_x, at_y + out_y, here))
                    ends = sum(ends, end(*layer, at_x, at_y, 0, out_y)), ++ways;
            }
        return ways == 0 ? times(Scalar(1) / static_cast<Scalar>(texels), inside)
                         : times(Scalar(1) / static_cast<Scalar>(ways), ends);
    }

    const std::vector<Samples>& layers_;
    view_mesh_detail::Grid grid_;
    double jump_;
    std::size_t layer_;
    Samples::Side side_;
};

}  // namespace layers_detail

// All layers by depth; the coverage of a pixel is 1 + its layer. `jump` is that of view_mesh.hpp.
inline ViewImage draw_layers(const std::vector<ReliefTexture>& layers, const ReliefCamera& viewer,
                             double jump) {
    std::vector<layers_detail::Samples> samples;
    for (const ReliefTexture& layer : layers) samples.push_back(layers_detail::samples_of(layer));
    ViewImage image(viewer.width, viewer.height);
    for (std::size_t k = 0; k < layers.size(); ++k)
        for (const auto side : {layers_detail::Samples::Front, layers_detail::Samples::Back})
            draw_grid_mesh(layers_detail::Grid(samples, viewer, jump, k, side), jump, image,
                           static_cast<std::uint8_t>(1 + k), Sides::Both);
    return image;
}

}  // namespace relevo::relief
