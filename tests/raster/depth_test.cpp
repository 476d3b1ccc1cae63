#include "raster/depth.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace relevo::raster {
namespace {

TEST(Depth, TiesAndNotANumberAreNotNearer) {
    constexpr Scalar nan = std::numeric_limits<Scalar>::quiet_NaN(),
                     tiny = std::numeric_limits<Scalar>::denorm_min();
    for (const DepthFormat format : {DepthFormat::Float32Reversed, DepthFormat::Float32Forward}) {
        const bool reversed = format == DepthFormat::Float32Reversed;
        EXPECT_EQ(nearer(format, Scalar(0.75), Scalar(0.5)), reversed);
        EXPECT_EQ(nearer(format, Scalar(0.5), Scalar(0.75)), !reversed);
        EXPECT_EQ(nearer(format, tiny, 0), reversed) << "the smallest number is in front of nothing";
        for (const Scalar z : {Scalar(0), Scalar(0.5), Scalar(1), tiny}) {
            EXPECT_FALSE(nearer(format, z, z)) << "the first one drawn stays";
            EXPECT_FALSE(nearer(format, nan, z));
            EXPECT_FALSE(nearer(format, z, nan));
        }
        EXPECT_FALSE(nearer(format, Scalar(-0.0), Scalar(0.0)));
        EXPECT_FALSE(nearer(format, Scalar(0.0), Scalar(-0.0)));
        EXPECT_FALSE(nearer(format, cleared_depth(format), cleared_depth(format)));
    }
    EXPECT_EQ(cleared_depth(DepthFormat::Float32Reversed), 0);
    EXPECT_EQ(cleared_depth(DepthFormat::Float32Forward), 1);
}

}  // namespace
}  // namespace relevo::raster
