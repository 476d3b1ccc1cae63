// The image experiment, every resampler beside the sprite and the inverse, by the error set. A row fails
// where it misses what is asked of it.
#include <gtest/gtest.h>

#include "tests/relief/image_rows.hpp"

namespace relevo::tests {
namespace {

class ImageExperiment : public testing::TestWithParam<std::string_view> {};

TEST_P(ImageExperiment, IsAsGoodAsItWas) {
    for (const double azimuth : image_azimuths) {
        const auto rows = image_rows(GetParam(), azimuth);
        ASSERT_EQ(rows.size(), image_ways.size()) << "no bunny: glmark2-data has it";
        for (const ImageRow& row : rows) {
            const auto text = [](const relief::ErrorSet& e) {
                char line[120];
                std::snprintf(line, sizeof line,
                              "%6.2f dB  missing %5.2f %%  extra %5.2f  depth %.4f  bad %5.2f", e.psnr,
                              e.missing_percent, e.extra_percent, e.mean_depth_error, e.bad_percent);
                return std::string(line);
            };
            std::printf("%-12s %2.0f  %-18s %s\n", std::string(GetParam()).c_str(), azimuth,
                        std::string(row.way).c_str(), text(row.error).c_str());
            EXPECT_GT(row.asked.psnr, 0) << "no figure is written down";
            EXPECT_TRUE(met(row)) << GetParam() << ' ' << azimuth << ' ' << row.way
                                  << (row.psnr_by_design ? ": the design asks for\n" : ": it began with\n")
                                  << text(row.asked) << "\nnow it is\n"
                                  << text(row.error);
        }
    }
}
std::string name_of(const testing::TestParamInfo<std::string_view>& which) {
    return std::string(which.param);
}
INSTANTIATE_TEST_SUITE_P(Of, ImageExperiment, testing::ValuesIn(image_scenes), name_of);

}  // namespace
}  // namespace relevo::tests
