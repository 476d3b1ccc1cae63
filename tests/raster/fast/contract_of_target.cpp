// The shared arithmetic for the lanes of one instruction set: compiled once for each, as CONTRACT.
#include "raster/fast/lanes.hpp"
#include "tests/raster/fast/contract.hpp"

namespace relevo::tests {
namespace {

using namespace raster::fast::HWY_NAMESPACE;

// Rows i .. i + lanes - 1.
struct LaneIo {
    const std::uint32_t* const* in;
    std::uint32_t* const* out;
    int i, column = 0;

    Floats real(int k) const { return bits_float(whole(k)); }
    Ints whole(int k) const { return load(in[k] + i); }
    void put(Ints a) { store(a, out[column++] + i); }
    void put(Words a) { put(to_whole(a)); }
    void put(Floats a) { put(float_bits(a)); }
    void put(Bools a) { put(select(a, Ints(1), Ints(0))); }
    void put(Doubles a) {
        double numbers[lanes];
        store(a, numbers);
        for (int k = 0; k < lanes; ++k) {
            const auto bits = std::bit_cast<std::uint64_t>(numbers[k]);
            out[column][i + k] = static_cast<std::uint32_t>(bits);
            out[column + 1][i + k] = static_cast<std::uint32_t>(bits >> 32);
        }
        column += 2;
    }
    void put(const pipeline::LaneVec3<Floats>& v) { put(v.x), put(v.y), put(v.z); }
    void put(const pipeline::RgbOf<Floats>& c) { put(c.r), put(c.g), put(c.b); }
};

}  // namespace

void CONTRACT(const Setting& s, const std::uint32_t* const* in, std::uint32_t* const* out, int count) {
    for (int i = 0; i < count; i += lanes) {
        LaneIo io{in, out, i};
        apply<Floats>(s, io);
    }
}

}  // namespace relevo::tests
