// The share of a pixel to the right of an edge: the integers against rational numbers, and both forms alike.
#include "raster/edge_share.hpp"

#include "tests/raster/coverage_grid.hpp"
#include "tests/support/exact_area.hpp"

namespace relevo::raster {
namespace {

using tests::exact::Rational;

bool random_piece(tests::RandomPlaces& random, double size, CoverageEdge& edge, EdgePiece& piece) {
    const glm::dvec2 a = random.point(-size, size), b = random.point(-size, size);
    if (!make_edge(to_grid(a.x), to_grid(a.y), to_grid(b.x), to_grid(b.y), edge)) return false;
    const std::int64_t row = random.whole(edge.first_row(), edge.last_row());
    const std::int64_t top = std::max(edge.y0, row * grid_pixel),
                       bottom = std::min(edge.y1, (row + 1) * grid_pixel);
    double below;
    piece = make_piece(edge, top, bottom, edge.x_at(top), below);
    return true;
}

TEST(EdgeShare, IntegersAreTheRationalAreaRoundedOnce) {
    tests::RandomPlaces random(1);
    for (int i = 0; i < 600; ++i) {
        CoverageEdge edge;
        EdgePiece piece;
        if (!random_piece(random, i % 3 == 0 ? 65534 : i % 3 == 1 ? 8 : 1, edge, piece)) continue;
        const int column = random.whole(piece.first - 1, std::min(piece.last, piece.first + 8) + 1);
        const Rational far = Rational(grid_pixel) * (2 * grid_origin + 2);
        const Rational slope = Rational(edge.x1 - edge.x0) / (edge.y1 - edge.y0);
        const Rational x0 = edge.x0 + slope * (piece.y0 - edge.y0),
                       x1 = edge.x0 + slope * (piece.y1 - edge.y0);
        const Rational pixel = grid_pixel, half(1, 2);
        const auto area = tests::exact::area_in_pixel({{x0 / pixel - half, piece.y0 / pixel - half},
                                                       {x1 / pixel - half, piece.y1 / pixel - half},
                                                       {far / pixel, piece.y1 / pixel - half},
                                                       {far / pixel, piece.y0 / pixel - half}},
                                                      column, static_cast<int>(piece.y0 >> 16));
        const Rational off = abs(abs(area) * full_coverage - exact_share(piece, column));
        ASSERT_LE(off, half) << "edge " << i << ", column " << column;
        if (off == half) {
            ASSERT_EQ(exact_share(piece, column) % 2, 0);
        }
    }
}

TEST(EdgeShare, DoublesGiveTheSame) {
    tests::RandomPlaces random(2);
    for (int i = 0; i < 300000; ++i) {
        CoverageEdge edge;
        EdgePiece piece;
        if (!random_piece(random, i % 2 ? 65534 : 12, edge, piece)) continue;
        const int column = random.whole(piece.first, piece.last);
        ASSERT_EQ(edge_share(piece, column), exact_share(piece, column)) << i;
    }
}

// So close to a tie that doubles alone round the wrong way: found by searching through 65 million.
TEST(EdgeShare, NextToATieTheIntegersDecide) {
    struct Case {
        std::int64_t ax, ay, bx, by;
        int row, column, share;
    };
    for (const Case& c : {Case{2882393078, 346753391, 4518810632, 3092671138, 12048, 48008, 8350},
                          Case{5972455591, 2218201861, 3394662203, 5606009191, 66782, 66071, 16063},
                          Case{7527586233, 5669254285, 7130117598, 4902828158, 76716, 109784, 3084}}) {
        CoverageEdge edge;
        ASSERT_TRUE(make_edge(c.ax, c.ay, c.bx, c.by, edge));
        const std::int64_t top = std::max(edge.y0, c.row * grid_pixel),
                           bottom = std::min(edge.y1, (c.row + 1) * grid_pixel);
        double below;
        const EdgePiece piece = make_piece(edge, top, bottom, edge.x_at(top), below);
        EXPECT_EQ(edge_share(piece, c.column), c.share);
    }
}

}  // namespace
}  // namespace relevo::raster
