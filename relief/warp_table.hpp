// The warp by table: with displacements in 8 bits, all that depends on them is computed 255 times a
// viewer, and a texel costs two sums and two products (Clua 2004, 8.2; its 255 and 1 / (1 + k3) (d)
// corrected).
//
//     coef1[i] = k1 Q(i)   coef2[i] = k2 Q(i)   coef3[i] = 1 / (1 + k3 Q(i))
//     u_i = (u + coef1[i]) coef3[i]             v_i = (v + coef2[i]) coef3[i]
//
// Needs nothing of the axes once k1, k2, k3 are known; ask make_warp_along_axes() for them where skewed
// axes must be refused, as the thesis's own table form does.
#pragma once
#include <array>

#include "relief/quantize.hpp"

namespace relevo::relief {

template <class Code>
struct WarpTable {
    static constexpr std::size_t size = std::size_t{QuantizedDepth<Code>::last} + 1;
    std::vector<Scalar> coef1, coef2, coef3;  // `size` each: the code for empty has no entry
};

template <class Code>
WarpTable<Code> make_warp_table(const Warp& warp, const QuantizedDepth<Code>& q) {
    WarpTable<Code> table;
    for (std::size_t i = 0; i < table.size; ++i) {
        const Scalar d = value(q, static_cast<int>(i));
        const double parameter = warp.projection == Projection::Orthographic ? warp_parameter(Displacement{d})
                                                                             : warp_parameter(Disparity{d});
        table.coef1.push_back(static_cast<Scalar>(warp.k1 * parameter));
        table.coef2.push_back(static_cast<Scalar>(warp.k2 * parameter));
        table.coef3.push_back(static_cast<Scalar>(1 / (1 + warp.k3 * parameter)));
    }
    return table;
}

struct WarpedTexel {
    Scalar u, v;
};
template <class Code>
WarpedTexel warp_texel(const WarpTable<Code>& table, Scalar u, Scalar v, Code code) {
    assert(code != QuantizedDepth<Code>::empty);
    return {(u + table.coef1[code]) * table.coef3[code], (v + table.coef2[code]) * table.coef3[code]};
}

}  // namespace relevo::relief
