// The image experiment: a relief texture of 256 x 256, orthographic, its side 2 and its plane touching the
// object's bounding ball of radius 1; a screen of 512 x 512 that sees 45 degrees from distance 3.2; the error
// set against rays cast through the pixel centres.
//
// The source looks along +z. A viewer `azimuth` degrees aside stands 0.4 times as many degrees up: so do the
// viewers of the figures with which the results are compared. (Of those, the flat sprite's depend on nothing
// but the place of the viewer: they agree to 0.02 dB with this elevation, and with no other.)
#pragma once
#include "pipeline/elementary.hpp"
#include "relief/error_set.hpp"
#include "relief/ray_cast.hpp"

namespace relevo::tests {

inline relief::ReliefCamera experiment_source(int size = 256) {
    return *relief::orthographic_camera({{0, 0, 1}, {0, 1, 0}, size, size}, {0, 0, -1}, 2);
}

inline relief::ReliefCamera experiment_viewer(double azimuth, int size = 512, double distance = 3.2) {
    using pipeline::Degrees;
    const Degrees aside{azimuth}, up{0.4 * azimuth};
    const glm::dvec3 eye = distance * glm::dvec3(sin(aside) * cos(up), sin(up), -cos(aside) * cos(up));
    return *relief::perspective_camera({-eye, {0, 1, 0}, size, size}, eye, 1, {45});
}

}  // namespace relevo::tests
