// The simplest of pre-warps: every texel paints the pixel that it falls into, nearest last. It leaves
// holes where the picture is stretched, and shows the order of painting undisguised.
#pragma once
#include "relief/resample_column.hpp"

namespace relevo::relief {

template <bool maps>
void splat(const PreparedRelief& relief, const Warp& warp, const PrewarpSettings& settings,
           Prewarped& result) {
    const Window& window = result.window;
    clear_columns(result, 0, window.width);
    const Painter<maps> painter(result, settings.depth_test);
    const Scalar width = static_cast<Scalar>(window.width), height = static_cast<Scalar>(window.height);
    const std::unique_ptr<WarpedRow> row = make_warped_row();
    for_each_in_order(occlusion_order(warp, settings.painting), relief.camera.width, relief.camera.height,
                      [&](int x, int y) {
                          if (row->y != y) warp_row(relief, warp, window, whole(window), y, *row);
                          if (!is_covered(relief, x, y)) return;
                          const Scalar u = row->u[x], v = row->v[x];
                          if (!(u >= 0 && u < width && v >= 0 && v < height)) return;
                          painter.paint(static_cast<int>(u), static_cast<int>(v),
                                        carried_by<maps>(relief.carried.at(x, y), x, y), Kind::Sampled);
                      });
}

}  // namespace relevo::relief
