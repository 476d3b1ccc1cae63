// Hills over the square of edge 1 round the origin: a height field of value noise, y upwards.
//
// Source: value noise by K. Perlin's lattice scheme ("An Image Synthesizer", 1985) with random values instead
// of gradients, his blend 6 t^5 - 15 t^4 + 10 t^3 ("Improving Noise", 2002), and octaves of half the size and
// half the height. The random numbers of the lattice are an integer hash of our own constants' choice: no
// table, no library.
#pragma once
#include <cmath>

#include "samples/scene/shapes/grid.hpp"

namespace relevo::scene {

// A well mixed number in [0, 1) for a lattice point: multiplications and shifts by the pattern of
// G. Steele, D. Lea, C. Flood, "Fast Splittable Pseudorandom Number Generators", 2014.
inline double lattice_value(std::int64_t x, std::int64_t z, std::uint32_t seed) {
    std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(z) +
                      (static_cast<std::uint64_t>(seed) << 32);
    for (int round = 0; round < 2; ++round) {
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
        h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
        h ^= h >> 31;
    }
    return static_cast<double>(h >> 11) * 0x1p-53;
}

// Smooth noise in [0, 1]: the four lattice values round the point, blended.
inline double value_noise(double x, double z, std::uint32_t seed) {
    const double fx = std::floor(x), fz = std::floor(z);
    const auto ix = static_cast<std::int64_t>(fx), iz = static_cast<std::int64_t>(fz);
    const auto blend = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    const double u = blend(x - fx), v = blend(z - fz);
    const auto row = [&](std::int64_t k) {
        const double left = lattice_value(ix, k, seed), right = lattice_value(ix + 1, k, seed);
        return left + u * (right - left);
    };
    const double near_row = row(iz), far_row = row(iz + 1);
    return near_row + v * (far_row - near_row);
}

// The height at (x, z) of the unit square, in [0, 1]: 7 octaves, squared so that valleys are wide and peaks
// steep.
inline double terrain_height(double x, double z, std::uint32_t seed) {
    double sum = 0, weight = 0.5, frequency = 3;
    for (std::uint32_t octave = 0; octave < 7; ++octave) {
        sum += weight * value_noise(x * frequency, z * frequency, seed + octave);
        weight /= 2;
        frequency *= 2;
    }
    return sum * sum;
}

// `across` segments along x and `away` along -z (1 to max_segments), `height` of the tallest possible peak (0
// or more). Normals by central differences over the width of a segment; one texture over all.
inline pipeline::Result<Mesh> terrain(int across, int away, double height, std::uint32_t seed) {
    if (across < 1 || across > max_segments || away < 1 || away > max_segments) return segments_error(1);
    if (!(height >= 0)) return pipeline::Error{"height must be 0 or more"};
    return grid_mesh(across, away, [=](int i, int j) {
        const auto at = [&](int k, int l) {
            return height * terrain_height(double(k) / across - 0.5, 0.5 - double(l) / away, seed);
        };
        const double slope_x = (at(i + 1, j) - at(i - 1, j)) * across / 2,
                     slope_z = (at(i, j - 1) - at(i, j + 1)) * away / 2;
        const glm::dvec3 normal =
            glm::dvec3(-slope_x, 1, -slope_z) / std::sqrt(slope_x * slope_x + 1 + slope_z * slope_z);
        const glm::dvec2 uv{double(i) / across, double(j) / away};
        return make_vertex({uv.x - 0.5, at(i, j), 0.5 - uv.y}, normal, uv);
    });
}

}  // namespace relevo::scene
