// Makes the textures of the sample scenes: make_textures FOLDER. The pictures in this folder were made by it,
// and a test compares them; their numbers are sRGB codes.
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "raster/image.hpp"
#include "samples/io/png.hpp"
#include "samples/scene/shapes/terrain.hpp"

namespace {

using relevo::raster::Image;
using relevo::raster::Rgba8;
using relevo::scene::terrain_height;
using relevo::scene::value_noise;
using Picture = Image<Rgba8>;

Rgba8 mix(Rgba8 a, Rgba8 b, double t) {
    const auto channel = [t](int p, int q) { return static_cast<std::uint8_t>(p + (q - p) * t + 0.5); };
    return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), 255};
}

// In steps, which keeps the files small.
double stepped(double t, int steps) { return std::floor(t * steps) / steps; }

template <class ColorAt>
Picture painted(int width, int height, ColorAt color_at) {
    Picture picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) picture.at(x, y) = color_at(x, y);
    return picture;
}

Picture checker() {
    return painted(256, 256, [](int x, int y) {
        return ((x >> 5) + (y >> 5)) % 2 ? Rgba8{236, 226, 200, 255} : Rgba8{58, 84, 110, 255};
    });
}

// Growth rings round an axis outside the board, bent by noise, with fine grain along it.
Picture wood() {
    return painted(256, 256, [](int x, int y) {
        const double u = x / 256.0, v = y / 256.0;
        const double bend = value_noise(u * 3, v * 1.5, 11) + 0.5 * value_noise(u * 7, v * 3, 12);
        const double dx = u - 0.45 + 0.10 * bend, dy = 0.12 * v + 1.3;
        const double rings = std::sqrt(dx * dx + 0.06 * dy * dy) * 26 + 1.6 * bend;
        const double saw = rings - std::floor(rings);
        const double grain = value_noise(u * 90, v * 6, 13);
        const double ring = saw < 0.8 ? saw * saw * saw * 1.953125 : (1 - saw) * 5;
        const double tone = 0.75 * ring + 0.25 * grain;
        return mix({206, 152, 94, 255}, {118, 70, 34, 255}, stepped(tone, 20));
    });
}

// The colour of heights of the terrain with seed 1, over its whole square.
Picture terrain() {
    constexpr std::array<std::pair<double, Rgba8>, 6> ramp = {{{0.00, {196, 178, 128, 255}},
                                                               {0.135, {196, 178, 128, 255}},
                                                               {0.16, {96, 130, 62, 255}},
                                                               {0.30, {62, 98, 50, 255}},
                                                               {0.37, {118, 106, 96, 255}},
                                                               {0.47, {244, 246, 250, 255}}}};
    return painted(256, 256, [&](int x, int y) {
        const double u = (x + 0.5) / 256 - 0.5, v = (y + 0.5) / 256 - 0.5;
        const double h = terrain_height(u, v, 1) + 0.06 * (value_noise(u * 70, v * 70, 21) - 0.5);
        std::size_t k = 1;
        while (k + 1 < ramp.size() && h > ramp[k].first) ++k;
        const double t = (h - ramp[k - 1].first) / (ramp[k].first - ramp[k - 1].first);
        return mix(ramp[k - 1].second, ramp[k].second, stepped(t < 0 ? 0 : t > 1 ? 1 : t, 8));
    });
}

// The unfolded dice of 4 x 3 cells; opposite faces add up to 7. Rows from above, 0 where no face is.
constexpr int cell = 128;
constexpr int pips_of_cell[3][4] = {{3, 0, 0, 0}, {1, 2, 6, 5}, {4, 0, 0, 0}};

// Whether a face of `pips` has one at column i, row j of its 3 x 3 places.
bool has_pip(int pips, int i, int j) {
    if (i == 1 && j == 1) return pips % 2 == 1;
    if (i == j) return pips >= 4;
    if (i + j == 2) return pips >= 2;
    return j == 1 && pips == 6;
}

// One point of a face, in [0, 1) from its upper left corner.
Rgba8 dice_point(int pips, double x, double y) {
    constexpr Rgba8 nothing{120, 120, 128, 255}, face{240, 232, 212, 255}, rim{214, 200, 172, 255},
        pip{36, 36, 44, 255}, one{178, 30, 36, 255};
    if (pips == 0) return nothing;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            const double dx = x - (0.26 + 0.24 * i), dy = y - (0.26 + 0.24 * j), r = pips == 1 ? 0.15 : 0.095;
            if (has_pip(pips, i, j) && dx * dx + dy * dy < r * r) return pips == 1 ? one : pip;
        }
    const double edge = std::min(std::min(x, 1 - x), std::min(y, 1 - y));
    return edge < 0.03 ? rim : face;
}

// 4 x 4 points a pixel.
Picture dice() {
    return painted(4 * cell, 3 * cell, [](int x, int y) {
        int sum[3] = {0, 0, 0};
        for (int k = 0; k < 16; ++k) {
            const double px = (x % cell + (k % 4 + 0.5) / 4) / cell,
                         py = (y % cell + (k / 4 + 0.5) / 4) / cell;
            const Rgba8 c = dice_point(pips_of_cell[y / cell][x / cell], px, py);
            sum[0] += c.r, sum[1] += c.g, sum[2] += c.b;
        }
        const auto mean = [&](int c) { return static_cast<std::uint8_t>((sum[c] + 8) / 16); };
        return Rgba8{mean(0), mean(1), mean(2), 255};
    });
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::fprintf(stderr, "usage: make_textures FOLDER\n"), 2;
    const std::pair<const char*, Picture> pictures[] = {
        {"checker", checker()}, {"wood", wood()}, {"terrain", terrain()}, {"dice", dice()}};
    for (const auto& [name, picture] : pictures)
        if (const auto failure = relevo::io::write_png(std::string(argv[1]) + "/" + name + ".png", picture))
            return std::fprintf(stderr, "%s\n", failure->text().c_str()), 2;
    return 0;
}
