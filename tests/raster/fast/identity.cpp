#include "tests/raster/fast/identity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <map>
#include <memory>
#include <span>
#include <sstream>

namespace relevo::tests::identity {

using pipeline::Scalar;
using raster::Frame;
using raster::Image;

std::string text(const Way& way) {
    std::ostringstream out;
    out << fast::name(way.set) << ", " << way.threads << " threads, tile " << way.tile
        << (way.linear ? ", linear" : "") << (way.visible ? ", visible" : "");
    return out.str();
}

std::vector<Way> all_ways() {
    std::vector<Way> ways;
    for (const fast::InstructionSet set : fast::instruction_sets())
        for (const int threads : thread_counts)
            for (const int tile : tile_sizes) ways.push_back({set, threads, tile});
    return ways;
}

std::vector<Way> few_ways(std::size_t number) {
    std::vector<Way> ways;
    for (const fast::InstructionSet set : fast::instruction_sets()) {
        ways.push_back({set, thread_counts[number % 3], tile_sizes[number / 3 % 3], number / 9 % 2 == 0,
                        number / 18 % 2 == 0});
        number += 4;  // the next one other threads and another tile
    }
    return ways;
}

namespace {

Frame spoiled_frame(Size size, bool with_linear) {
    Frame frame = frame_of(size.width, size.height, with_linear);
    const auto spoil = [](auto& image) {
        const auto bytes = std::as_writable_bytes(std::span(image.pixels()));
        std::ranges::fill(bytes, std::byte{0xa5});
    };
    spoil(frame.color), spoil(frame.depth), spoil(frame.linear);
    return frame;
}

fast::Workers* workers(int threads) {
    static std::map<int, std::unique_ptr<fast::Workers>> pools;
    if (threads == 1) return nullptr;
    auto& pool = pools[threads];
    if (!pool) pool = std::make_unique<fast::Workers>(threads);
    return pool.get();
}

}  // namespace

Answer textbook(const raster::Scene& scene, const raster::Settings& settings, Size size) {
    Answer answer{spoiled_frame(size, true), Image<std::uint32_t>(size.width, size.height), {}};
    raster::draw(scene, settings, answer.frame);

    Frame again = frame_of(size.width, size.height);
    Watch watch(size.width, size.height);
    draw_watched(scene, settings, again, watch);
    fast::Counts& counts = answer.counts;
    counts.vertices = static_cast<std::uint64_t>(watch.transformed);
    counts.clipped = static_cast<std::uint64_t>(watch.clipped);
    for (int i = 0; i < 5; ++i) counts.rejected[i] = static_cast<std::uint64_t>(watch.rejected[i]);
    for (const raster::Model& model : scene.models) counts.triangles += model.mesh->triangles();
    for (std::size_t i = 0; i < watch.seen.pixels().size(); ++i) {
        const int seen = watch.seen.pixels()[i];  // number of the primitive + 1
        counts.shaded_pixels += seen != 0;
        answer.visible.pixels()[i] = seen == 0 ? fast::nothing : static_cast<std::uint32_t>(seen - 1);
    }
    return answer;
}

Answer fast_path(const raster::Scene& scene, const raster::Settings& settings, Size size, const Way& way,
                 fast::Workspace& workspace) {
    Answer answer{spoiled_frame(size, way.linear), {}, {}};
    if (way.visible) answer.visible = Image<std::uint32_t>(size.width, size.height, 0xa5a5a5a5u);
    answer.counts =
        fast::draw(scene, settings, answer.frame, workspace,
                   {way.set, way.tile, workers(way.threads), way.visible ? &answer.visible : nullptr});
    return answer;
}

Answer fast_path(const raster::Scene& scene, const raster::Settings& settings, Size size, const Way& way) {
    static fast::Workspace workspace;
    return fast_path(scene, settings, size, way, workspace);
}

namespace {

// A number by its bits and its value.
std::string value(Scalar x) {
    std::ostringstream out;
    out.precision(9);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof x);
    out << x << " (0x" << std::hex << bits << ")";
    return out.str();
}
std::string value(raster::Rgba8 c) {
    std::ostringstream out;
    out << int{c.r} << ' ' << int{c.g} << ' ' << int{c.b} << ' ' << int{c.a};
    return out.str();
}
std::string value(pipeline::LinearRgb c) { return value(c.r) + ' ' + value(c.g) + ' ' + value(c.b); }
std::string value(std::uint32_t primitive) {
    return primitive == fast::nothing ? "nothing" : std::to_string(primitive);
}

template <class Pixel>
bool same_bits(const Pixel& a, const Pixel& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}
bool same_but_for_nan(const pipeline::LinearRgb& a, const pipeline::LinearRgb& b) {
    const auto same = [](Scalar x, Scalar y) { return same_bits(x, y) || (std::isnan(x) && std::isnan(y)); };
    return same(a.r, b.r) && same(a.g, b.g) && same(a.b, b.b);
}

template <class Pixel, class Same>
std::string difference(const char* what, const Image<Pixel>& right, const Image<Pixel>& got, Same same) {
    if (got.empty()) return "";
    if (right.width() != got.width() || right.height() != got.height()) return std::string(what) + ": size";
    if (std::memcmp(right.pixels().data(), got.pixels().data(), right.pixels().size() * sizeof(Pixel)) == 0)
        return "";
    std::string first;
    std::size_t count = 0;
    for (int y = 0; y < right.height(); ++y)
        for (int x = 0; x < right.width(); ++x) {
            const Pixel &r = right.at(x, y), &g = got.at(x, y);
            if (same(r, g) || ++count > 1) continue;
            first = std::string(what) + " of pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                    ") is " + value(g) + " in place of " + value(r);
        }
    if (count == 0) return "";
    return first + "; " + std::to_string(count) + " of " + std::to_string(right.pixels().size()) + " differ";
}

std::string difference(const char* what, std::uint64_t right, std::uint64_t got) {
    return right == got
               ? ""
               : std::string(what) + ": " + std::to_string(got) + " in place of " + std::to_string(right);
}

}  // namespace

std::string difference(const Answer& right, const Answer& got, Linear linear) {
    const auto by_bits = [](const auto& a, const auto& b) { return same_bits(a, b); };
    std::vector<std::string> found{
        difference("depth", right.frame.depth, got.frame.depth, by_bits),
        difference("visible primitive", right.visible, got.visible, by_bits),
        linear == Linear::Exact
            ? difference("linear colour", right.frame.linear, got.frame.linear, by_bits)
            : difference("linear colour", right.frame.linear, got.frame.linear, same_but_for_nan),
        difference("colour", right.frame.color, got.frame.color, by_bits),
        difference("vertices", right.counts.vertices, got.counts.vertices),
        difference("triangles", right.counts.triangles, got.counts.triangles),
        difference("clipped triangles", right.counts.clipped, got.counts.clipped),
        difference("shaded pixels", right.counts.shaded_pixels, got.counts.shaded_pixels)};
    static constexpr const char* reasons[] = {"not finite", "outside", "without area", "culled", "no pixel"};
    for (std::size_t i = 0; i < std::size(reasons); ++i)
        found.push_back(difference((std::string("triangles rejected (") + reasons[i] + ')').c_str(),
                                   right.counts.rejected[i], got.counts.rejected[i]));
    std::string all;
    for (const std::string& one : found)
        if (!one.empty()) all += "\n    " + one;
    return all;
}

std::string first_difference(const raster::Scene& scene, const raster::Settings& settings, Size size,
                             const std::vector<Way>& ways, std::uint64_t* drawn, Linear linear) {
    const Answer right = textbook(scene, settings, size);
    if (drawn) *drawn += right.counts.shaded_pixels;
    for (const Way& way : ways) {
        const std::string found = difference(right, fast_path(scene, settings, size, way), linear);
        if (!found.empty())
            return std::to_string(size.width) + " x " + std::to_string(size.height) + ", " + text(way) +
                   found;
    }
    return "";
}

}  // namespace relevo::tests::identity
