// An object as a box of six relief textures (Oliveira and Bishop 1999; Clua 2004, 3.4.3).
//
// One texture shows one side. Six, on the faces of a box round the object, each looking inwards, show it from
// everywhere; what no face sees (the inside of a bowl behind its rim) stays unseen. The viewer's place
// decides which faces are in front of it: the planes of the six faces cut space into 27 regions, the box
// itself and
//   6 face regions (one face in front), 12 edge regions (two), 8 corner regions (three).
//
// The thesis draws the faces one after another, the one that looks most towards the viewer last, so that it
// overwrites the others. That order is approximate: a point of a side face can be nearer than the front's
// point it is overwritten by. Comparing depths is right, and here costs a z-buffer.
#pragma once
#include <algorithm>
#include <array>
#include <cstdlib>

#include "relief/capture.hpp"
#include "relief/view_mesh.hpp"

namespace relevo::relief {

// Named by the direction in which they lie from the middle.
enum class Face { Left, Right, Bottom, Top, Back, Front };  // -x +x -y +y -z +z
inline constexpr std::array<Face, 6> all_faces = {Face::Left, Face::Right, Face::Bottom,
                                                  Face::Top,  Face::Back,  Face::Front};
constexpr int axis_of(Face face) { return static_cast<int>(face) / 2; }
constexpr int sign_of(Face face) { return static_cast<int>(face) % 2 ? 1 : -1; }

struct Box {
    glm::dvec3 low, high;  // low < high
};

// On which side of the box the viewer is, along x, y and z: -1 below, 0 between, 1 above its faces' planes.
struct BoxRegion {
    std::array<int, 3> side;
    int faces() const { return std::abs(side[0]) + std::abs(side[1]) + std::abs(side[2]); }  // in front: 0..3
    int number() const { return (side[0] + 1) + 3 * (side[1] + 1) + 9 * (side[2] + 1); }  // 0..26, 13: inside
    bool shows(Face face) const { return side[std::size_t(axis_of(face))] == sign_of(face); }
};
inline BoxRegion box_region(const Box& box, const glm::dvec3& viewer) {
    BoxRegion region{};
    for (int k = 0; k < 3; ++k)
        region.side[std::size_t(k)] = viewer[k] > box.high[k] ? 1 : viewer[k] < box.low[k] ? -1 : 0;
    return region;
}

// The camera of a face: its plane is the face, its picture upright (top and bottom: -z upwards and +z).
// `texels` is the number along the longest side of the box; texels are square.
inline Result<ReliefCamera> face_camera(const Box& box, Face face, int texels) {
    const int axis = axis_of(face);
    const glm::dvec3 size = box.high - box.low;
    const double texel = std::max({size.x, size.y, size.z}) / texels;
    glm::dvec3 outwards(0), up(0, 1, 0), center = 0.5 * (box.low + box.high);
    outwards[axis] = sign_of(face);
    if (axis == 1) up = {0, 0, -outwards.y};
    center[axis] = (sign_of(face) > 0 ? box.high : box.low)[axis];
    const int across = axis == 0 ? 2 : 0, upwards = axis == 1 ? 2 : 1;
    const auto count = [&](int k) {
        return std::max(1, static_cast<int>(std::ceil(size[k] / texel - 1e-9)));
    };
    return orthographic_camera({-outwards, up, count(across), count(upwards)}, center,
                               count(upwards) * texel);
}

struct BoxRelief {
    Box box;
    std::array<ReliefTexture, 6> face;  // in the order of all_faces
};

// Errors are those of the capture.
template <Capture C>
Result<BoxRelief> capture_box(const C& capture, const Box& box, int texels) {
    BoxRelief relief{box, {}};
    for (const Face face : all_faces) {
        const auto camera = face_camera(box, face, texels);
        if (!camera) return camera.error();
        auto texture = capture(*camera);
        if (!texture) return texture.error();
        relief.face[std::size_t(face)] = *std::move(texture);
    }
    return relief;
}

enum class Composite { Depth, FaceOrder };

struct BoxSettings {
    double jump = 0.1;  // of view_mesh.hpp
    Composite composite = Composite::Depth;
};

// The picture of a viewer anywhere outside the box; the coverage of a pixel is 1 + its face. By depth all six
// faces are drawn, for beside an overhang a point that only a side face saw can be visible from the front;
// what turns its back to the viewer drops out by itself. In the order of faces those in front of the viewer
// are drawn, the one seen most frontally last.
inline ViewImage draw_box(const BoxRelief& relief, const ReliefCamera& viewer,
                          const BoxSettings& settings = {}) {
    ViewImage image(viewer.width, viewer.height);
    const auto label = [](Face face) { return static_cast<std::uint8_t>(1 + static_cast<int>(face)); };
    if (settings.composite == Composite::Depth) {
        for (const Face face : all_faces)
            draw_view_mesh(relief.face[std::size_t(face)], viewer, settings.jump, image, label(face));
        return image;
    }
    const glm::dvec3 middle = 0.5 * (relief.box.low + relief.box.high), toward = viewer.eye - middle;
    const BoxRegion region = box_region(relief.box, viewer.eye);
    std::array<Face, 6> order = all_faces;
    const auto frontal = [&](Face face) { return sign_of(face) * toward[axis_of(face)]; };
    std::stable_sort(order.begin(), order.end(), [&](Face a, Face b) { return frontal(a) < frontal(b); });
    for (const Face face : order) {
        if (!region.shows(face)) continue;
        ViewImage alone(viewer.width, viewer.height);
        draw_view_mesh(relief.face[std::size_t(face)], viewer, settings.jump, alone, label(face));
        for (std::size_t i = 0; i < alone.coverage.pixels().size(); ++i) {
            if (!alone.coverage.pixels()[i]) continue;
            image.coverage.pixels()[i] = alone.coverage.pixels()[i];
            image.color.pixels()[i] = alone.color.pixels()[i];
            image.depth.pixels()[i] = alone.depth.pixels()[i];
        }
    }
    return image;
}

}  // namespace relevo::relief
