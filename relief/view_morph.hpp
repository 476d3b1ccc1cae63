// View morphing: two views of an object and what belongs together in them give every view on the way from the
// one eye to the other, true in perspective (Seitz and Dyer, "View morphing", SIGGRAPH 1996; Clua 2004,
// 2.4.2).
//
//   1  prewarp    both pictures are laid onto one plane that is parallel to the way of the eyes: homographies
//   2  morph      there, plain morphing is a view:  W = (1 - s) p0 + s p1 is what the eye (1 - s) C0 + s C1
//                 sees, because with P_i = [ I | -C_i ], C_i = (X_i, 0, 0), the projection is linear in X_i
//   3  postwarp   the picture is laid onto the plane of the new view: another homography
//
// The axes of the common plane: x along the way of the eyes, z the mean direction of sight made perpendicular
// to it, y = z x x (the thesis takes y from the product of the two directions of sight, which says the same
// where it is defined). The three maps are put together, so that pictures are drawn once and not three times.
//
// From the places alone, without a depth, comes what is nearer, too. What no view saw is missing, and
// surfaces must look the same from both sides; but no edge bends.
//
// Measured with the edges of a square: 256 x 256 pixels, 40 degrees, three pairs of eyes 70 to 120 degrees of
// azimuth apart: plain morphing bends them by 1.4, 2.8 and 8.5 pixels, view morphing by 0.002. The view in
// the middle of 40 degrees of arc, against ray casting: a ball 29.9 dB (plain 10.0), `bumpy` 23.6 (10.9).
#pragma once
#include "relief/morph.hpp"

namespace relevo::relief {

// The view at s of the way: eye and plane move in straight lines. 0 and 1 are the two views.
inline ReliefCamera view_between(const ReliefCamera& view0, const ReliefCamera& view1, double s) {
    ReliefCamera between = view0;
    between.eye = (1 - s) * view0.eye + s * view1.eye;
    between.corner = (1 - s) * view0.corner + s * view1.corner;
    between.a = (1 - s) * view0.a + s * view1.a;
    between.b = (1 - s) * view0.b + s * view1.b;
    return between;
}

// The maps of steps 1 and 3: multiply them by (u, v, 1), or by (x, y, 1) of the common plane. The common
// plane is at distance 1 from the eyes.
struct ViewMorph {
    glm::dmat3 plane_from_view0, plane_from_view1, between_from_plane;
    double s, way;         // from eye to eye, world units
    ReliefCamera between;  // what is seen in the end
};

// Errors: eyes that coincide (a homography then does all there is to do), one eye so far aside or behind the
// other that a picture reaches beyond what the common plane can hold, and a view between that relief::refusal
// refuses. The views are perspective cameras of one size.
inline Result<ViewMorph> make_view_morph(const ReliefCamera& view0, const ReliefCamera& view1, double s) {
    assert(view0.projection == Projection::Perspective && view1.projection == Projection::Perspective);
    assert(view0.width == view1.width && view0.height == view1.height);
    const auto normalized = [](const glm::dvec3& v) { return v / std::sqrt(glm::dot(v, v)); };
    const glm::dvec3 way = view1.eye - view0.eye, sight = forward(view0) + forward(view1);
    if (!(glm::dot(way, way) > 0))
        return pipeline::Error{"the two views have the same eye: a view morph needs two places"};
    const glm::dvec3 x = normalized(way), across = sight - glm::dot(sight, x) * x;
    if (!(glm::dot(across, across) > 1e-12))
        return pipeline::Error{
            "the views look along the way from one eye to the other: they cannot be morphed"};
    const glm::dvec3 z = normalized(across);
    const glm::dmat3 plane_from_world = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
    ViewMorph morph{plane_from_world * sight_matrix(view0), plane_from_world * sight_matrix(view1), {}, s,
                    std::sqrt(glm::dot(way, way)),          view_between(view0, view1, s)};
    if (const auto error = refusal(morph.between)) return *error;
    for (const glm::dmat3& plane : {morph.plane_from_view0, morph.plane_from_view1})
        for (const double u : {0, view0.width})
            for (const double v : {0, view0.height})
                if (!((plane * glm::dvec3(u, v, 1)).z > 0))
                    return pipeline::Error{
                        "one view sees beside or behind the other's eye: the two cannot be laid onto one "
                        "plane"};
    morph.between_from_plane = glm::inverse(plane_from_world * sight_matrix(morph.between));
    return morph;
}

// Where the new view sees what view 0 shows at p0 and view 1 at p1; none where it is not in front of all
// three eyes. Its depth follows from the two places alone: on the common plane they lie way / depth apart.
inline std::optional<MovedPoint> view_morph_point(const ViewMorph& morph, const glm::dvec2& p0,
                                                  const glm::dvec2& p1) {
    const glm::dvec3 q0 = morph.plane_from_view0 * glm::dvec3(p0, 1),
                     q1 = morph.plane_from_view1 * glm::dvec3(p1, 1);
    if (!(q0.z > 0 && q1.z > 0)) return {};
    const double apart = q0.x / q0.z - q1.x / q1.z;
    const glm::dvec3 p = morph.between_from_plane * ((1 - morph.s) * (q0 / q0.z) + morph.s * (q1 / q1.z));
    if (!(apart > 0 && p.z > 0)) return {};
    return MovedPoint{p.x / p.z, p.y / p.z,
                      morph.way / apart * p.z * view_depth(morph.between, morph.between.corner)};
}

// The view at s in [0, 1], from two perspective cameras, their pictures and the correspondence of both. The
// rest as for morph(). Errors are those of make_view_morph.
inline Result<ViewImage> view_morph(const ReliefCamera& camera0, const ViewImage& view0,
                                    const ReliefCamera& camera1, const ViewImage& view1,
                                    const Correspondence& to1, const Correspondence& to0, double s,
                                    double jump) {
    assert(0 <= s && s <= 1);
    const auto maps = make_view_morph(camera0, camera1, s);
    if (!maps) return maps.error();
    const auto from0 = [&](const glm::dvec2& here, const glm::dvec2& there, double, double) {
        return view_morph_point(*maps, here, there);
    };
    const auto from1 = [&](const glm::dvec2& here, const glm::dvec2& there, double, double) {
        return view_morph_point(*maps, there, here);
    };
    return morph_detail::faded(view0, view1, to1, to0, s, jump, from0, from1);
}

}  // namespace relevo::relief
