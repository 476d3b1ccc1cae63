#include "relief/resample_interleaved.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/relief/random_source.hpp"

namespace relevo::relief {
namespace {

struct Listener {
    std::vector<int> rows;                     // as they were sent
    std::vector<std::pair<int, int>> samples;  // x, row
    bool right = true;                         // samples of a row come before its end
    void on(const SampleSent<false>& sent) {
        samples.push_back({sent.x, sent.row});
        right &= sent.sample.kind == Kind::Sampled && (rows.empty() || rows.back() != sent.row);
    }
    void on(const RowResampled<false>& sent) { rows.push_back(sent.row); }
};

// Without displacement each texel is sent once to its own column each time its row is; rows come towards the
// epipole from both sides, and a probe changes nothing.
TEST(ResampleInterleaved, SendsRowsTowardsTheEpipole) {
    const ReliefCamera camera = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 12, 9}, {0, 0, 1}, 2);
    ReliefTexture texture = make_relief_texture(camera);
    for (std::size_t i = 0; i < texture.coverage.pixels().size(); ++i)
        texture.coverage.pixels()[i] = 1, texture.color.pixels()[i] = {Scalar(i), 0, 1};
    const PreparedRelief prepared = prepare(texture);
    const Warp warp = *make_warp(camera, viewer_at(plane_point(camera, 5.2, 3.3) + glm::dvec3(0, 0, 2)));
    Prewarped plain, heard;
    const PrewarpSettings settings;
    prewarp(prepared, warp, source_window(camera), settings, plain);
    prewarp(prepared, warp, source_window(camera), settings, heard);
    std::fill(heard.color.pixels().begin(), heard.color.pixels().end(), LinearRgb{});
    Listener listener;
    PrewarpMemory memory;
    resample_picture<false>(InterleavedMethod{}, prepared, warp, settings, heard, memory.parts(), listener);
    EXPECT_TRUE(plain.color.pixels() == heard.color.pixels());
    EXPECT_TRUE(listener.right);

    std::vector<int> first_time;
    for (const int row : listener.rows)
        if (std::find(first_time.begin(), first_time.end(), row) == first_time.end())
            first_time.push_back(row);
    EXPECT_EQ(first_time, (std::vector<int>{0, 1, 2, 8, 7, 6, 5, 4, 3}));  // the epipole lies between 2 and 3
    EXPECT_EQ(listener.samples.size(), 12 * listener.rows.size());
    std::vector<int> columns;  // of the first row: towards the epipole, between columns 4 and 5
    for (int i = 0; i < 12; ++i) columns.push_back(listener.samples[std::size_t(i)].first);
    EXPECT_EQ(columns, (std::vector<int>{0, 1, 2, 3, 11, 10, 9, 8, 7, 6, 5, 4}));
}

}  // namespace
}  // namespace relevo::relief
