#include "raster/cone_table.hpp"

#include <cmath>
#include <cstddef>

#include "pipeline/elementary.hpp"

namespace relevo::raster {
namespace {

ConeTable make_table() {
    ConeTable table{};
    constexpr int n = ConeTable::reach * ConeTable::steps;
    for (int i = 0; i <= n; ++i) {
        const double above = cone_half_plane(static_cast<double>(i) / ConeTable::steps) - 0.5;
        const auto part = static_cast<std::int32_t>(std::floor(above * 0x1p30 + 0.5));
        table.at[static_cast<std::size_t>(n + i)] = (1 << 29) + part;
        table.at[static_cast<std::size_t>(n - i)] = (1 << 29) - part;
    }
    table.at.back() = 1 << 30;
    return table;
}

}  // namespace

double cone_half_plane(double s) {
    if (s < 0) return 1 - cone_half_plane(-s);
    if (s < 0x1p-60) return 0.5;
    if (s >= 1) return 1;
    constexpr double ln2 = 0x1.62e42fefa39efp-1;
    const double length = std::sqrt((1 - s) * (1 + s));
    const double arc_sine = 2 * pipeline::arc_tangent(s / (1 + length));
    const double logarithm = ln2 * pipeline::log2((1 + length) / s);
    return 0.5 + (2 * s * length + arc_sine - s * s * s * logarithm) / pipeline::pi;
}

const ConeTable& cone_table() {
    static const ConeTable table = make_table();
    return table;
}

}  // namespace relevo::raster
