#include "samples/io/apng.hpp"

#include <algorithm>
#include <cassert>

#include "samples/io/png.hpp"
#include "samples/io/png_check.hpp"

namespace relevo::io {
namespace {

using Picture = raster::Image<raster::Rgba8>;

std::string big_endian(std::uint32_t number) {
    std::string out;
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(number >> shift & 255);
    return out;
}

std::string chunk(const std::string& type, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc32(type + data));
}

struct Area {
    int x, y, width, height;
};

// The smallest rectangle with all differences; one pixel when there are none, since no frame may be empty.
Area changed_area(const Picture& before, const Picture& now) {
    int left = now.width(), right = -1, top = now.height(), bottom = -1;
    for (int y = 0; y < now.height(); ++y)
        for (int x = 0; x < now.width(); ++x)
            if (before.at(x, y) != now.at(x, y)) {
                left = std::min(left, x), right = std::max(right, x);
                top = std::min(top, y), bottom = y;
            }
    return right < 0 ? Area{0, 0, 1, 1} : Area{left, top, right - left + 1, bottom - top + 1};
}

Picture part_of(const Picture& picture, const Area& area) {
    Picture part(area.width, area.height);
    for (int y = 0; y < area.height; ++y)
        std::copy_n(picture.row(area.y + y) + area.x, area.width, part.row(y));
    return part;
}

// What the chunks of this type hold, joined.
std::string contents(std::string_view png, std::string_view type) {
    std::string out;
    for (std::size_t at = png_signature.size(); at + 12 <= png.size();) {
        const std::size_t size = big_endian_32(png, at);
        if (png.substr(at + 4, 4) == type) out += png.substr(at + 8, size);
        at += 12 + size;
    }
    return out;
}

}  // namespace

void AnimatedPng::add_control(int x, int y, int width, int height, int milliseconds) {
    assert(0 < milliseconds && milliseconds <= 65535);
    std::string control = big_endian(sequence_++);
    for (const int number : {width, height, x, y}) control += big_endian(std::uint32_t(number));
    // the delay as a fraction of a second; the picture stays, the next one replaces its part of it
    control += big_endian(std::uint32_t(milliseconds)).substr(2) + big_endian(1000).substr(2);
    chunks_ += chunk("fcTL", control + std::string(2, '\0'));
}

void AnimatedPng::add(const Picture& picture, int milliseconds) {
    assert(!picture.empty());
    const bool first = frames_++ == 0;
    assert(first || (picture.width() == last_.width() && picture.height() == last_.height()));
    const Area area = first ? Area{0, 0, picture.width(), picture.height()} : changed_area(last_, picture);
    const std::string png = png_bytes(part_of(picture, area), 3, PngContents::Diagram);
    if (first) header_ = contents(png, "IHDR");
    add_control(area.x, area.y, area.width, area.height, milliseconds);
    const std::string pixels = contents(png, "IDAT");
    chunks_ += first ? chunk("IDAT", pixels) : chunk("fdAT", big_endian(sequence_++) + pixels);
    last_ = picture;
}

std::string AnimatedPng::bytes() const {
    if (frames_ == 0) return "";
    const std::uint32_t endless = 0;
    return std::string(png_signature) + chunk("IHDR", header_) +
           chunk("acTL", big_endian(frames_) + big_endian(endless)) + chunks_ + chunk("IEND", "");
}

}  // namespace relevo::io
