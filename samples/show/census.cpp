#include "samples/show/census.hpp"

#include "pipeline/clip_polygon.hpp"

namespace relevo::show {
namespace {

using pipeline::view_volume_planes;

// The planes in the census's order, as indices of view_volume_planes: near, far, left, right, bottom, top.
std::array<std::size_t, 6> plane_order(bool reversed) {
    return reversed ? std::array<std::size_t, 6>{0, 1, 2, 3, 4, 5}
                    : std::array<std::size_t, 6>{1, 0, 2, 3, 4, 5};
}

std::array<std::string, 6> plane_names(bool reversed) {
    return {reversed ? "near z = w" : "near z = 0",
            reversed ? "far  z = 0" : "far  z = w",
            "left  x=-w",
            "right x=+w",
            "below y=-w",
            "above y=+w"};
}

bool finite(const glm::dvec4& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

Fate fate_at(int inside_corners) {
    return inside_corners == 3 ? Fate::Inside : inside_corners == 0 ? Fate::Outside : Fate::Crossing;
}

// The triangle's fate; adds it to the counts of the planes.
Fate fate_of(const std::array<glm::dvec4, 3>& corners, Census& census,
             const std::array<std::size_t, 6>& order) {
    for (const glm::dvec4& p : corners)
        if (!finite(p)) return Fate::NotFinite;
    Fate fate = Fate::Inside;
    for (std::size_t k = 0; k < 6; ++k) {
        int inside = 0;
        for (const glm::dvec4& p : corners)
            inside += pipeline::distance_inside(view_volume_planes[order[k]], p) >= 0;
        const Fate here = fate_at(inside);
        ++census.planes[k].triangles[static_cast<std::size_t>(here)];
        fate = std::max(fate, here);
    }
    return fate;
}

std::array<glm::dvec4, 3> corners_of(const Capture& capture, std::size_t model, std::size_t triangle) {
    const std::vector<std::uint32_t>& i = capture.model(model).mesh->indices;
    const std::vector<SeenVertex>& v = capture.vertices(model);
    return {v[i[3 * triangle]].clip, v[i[3 * triangle + 1]].clip, v[i[3 * triangle + 2]].clip};
}

}  // namespace

Census take_census(const Capture& capture) {
    Census census;
    const std::array<std::size_t, 6> order = plane_order(capture.reversed_depth());
    const std::array<std::string, 6> names = plane_names(capture.reversed_depth());
    for (std::size_t k = 0; k < 6; ++k) census.planes[k].name = names[k];
    for (std::size_t m = 0; m < capture.scene().models.size(); ++m) {
        std::vector<Fate>& fates = census.fates.emplace_back(capture.model(m).mesh->triangles());
        for (std::size_t t = 0; t < fates.size(); ++t) {
            fates[t] = fate_of(corners_of(capture, m, t), census, order);
            ++census.total[static_cast<std::size_t>(fates[t])];
        }
    }
    return census;
}

std::vector<ClippedPiece> clip_to_view_volume(const Capture& capture, const Census& census) {
    std::vector<ClippedPiece> pieces;
    for (std::size_t m = 0; m < census.fates.size(); ++m)
        for (std::size_t t = 0; t < census.fates[m].size(); ++t) {
            const Fate fate = census.fates[m][t];
            if (fate != Fate::Inside && fate != Fate::Crossing) continue;
            pipeline::ClipPolygon<1> polygon;
            for (const glm::dvec4& p : corners_of(capture, m, t)) polygon.push({p, {0}, 0});
            if (fate == Fate::Crossing) polygon = pipeline::clip_polygon(polygon, view_volume_planes, 63u);
            ClippedPiece piece{static_cast<std::uint32_t>(m), fate == Fate::Crossing, {}, {}};
            for (const auto& corner : polygon.span()) {
                if (!(corner.position.w > 0)) break;
                piece.ndc.push_back(glm::dvec3(corner.position) / corner.position.w);
                piece.made.push_back(corner.pinned != 0);
            }
            if (piece.ndc.size() == polygon.span().size() && piece.ndc.size() >= 3)
                pieces.push_back(std::move(piece));
        }
    return pieces;
}

}  // namespace relevo::show
