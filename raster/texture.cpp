#include "raster/texture.hpp"

#include <cassert>

#include "raster/output.hpp"

namespace relevo::raster {

Texture make_texture(int width, int height, int channels, std::span<const std::uint8_t> top_down,
                     Encoding encoding) {
    assert(0 < width && width <= max_texture_size && 0 < height && height <= max_texture_size &&
           channels >= 3);
    assert(top_down.size() == std::size_t(width) * std::size_t(height) * std::size_t(channels));
    Texture texture{width, height, {}, encoding == Encoding::Raw ? Scalar(1.0 / 255) : Scalar(1.0 / 65535)};
    texture.texels.reserve(std::size_t(width) * std::size_t(height));
    for (int y = height - 1; y >= 0; --y) {
        for (int x = 0; x < width; ++x) {
            const auto* p =
                &top_down[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels)];
            std::array<std::uint16_t, 4> texel{};
            for (std::size_t c = 0; c < 3; ++c)
                texel[c] = encoding == Encoding::Raw ? p[c] : srgb_decoded[p[c]];
            texture.texels.push_back(texel);
        }
    }
    return texture;
}

}  // namespace relevo::raster
