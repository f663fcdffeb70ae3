// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/exr_buffers.h"

#include <gtest/gtest.h>

namespace ddt::tool::test {
namespace {

using OIIO::ImageSpec;

int64_t compressed_by(const char* compression, int threads) {
    ImageSpec spec(2048, 1024, 32, OIIO::TypeHalf);
    spec.attribute("compression", compression);
    return exr_buffers(spec, threads);
}

TEST(ExrBuffers, AreTwoBlocksOfRowsAThread) {
    constexpr int64_t row = 2048 * 32 * 2;
    EXPECT_EQ(compressed_by("none", 16), 32 * 3 * row);
    EXPECT_EQ(compressed_by("zip", 1), 3 * 16 * row);
    EXPECT_EQ(compressed_by("zip", 2), 4 * 3 * 16 * row);
    EXPECT_EQ(compressed_by("zip:4", 16), 32 * 3 * 16 * row);
    EXPECT_EQ(compressed_by("dwaa:45", 16), 32 * 3 * 32 * row);
    // No more than there are.
    EXPECT_EQ(compressed_by("dwab", 16), 4 * 3 * 256 * row);
    EXPECT_EQ(exr_buffers(ImageSpec(2048, 8, 32, OIIO::TypeHalf), 16), 3 * 8 * row);
}

TEST(ExrBuffers, AreOfTheTypesInTheFile) {
    ImageSpec spec(100, 1, 3, OIIO::TypeUInt8);
    EXPECT_EQ(exr_buffers(spec, 1), 3 * 100 * 3 * 2);
    spec.set_format(OIIO::TypeDesc::DOUBLE);
    EXPECT_EQ(exr_buffers(spec, 1), 3 * 100 * 3 * 4);
    spec.channelformats = {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeUInt32};
    EXPECT_EQ(exr_buffers(spec, 1), 3 * 100 * (2 + 2 + 4));
}

TEST(ExrBuffers, AreTwoTilesAThread) {
    ImageSpec spec(1000, 1000, 1, OIIO::TypeFloat);
    spec.tile_width = 64;
    spec.tile_height = 32;
    EXPECT_EQ(exr_buffers(spec, 4), 8 * 3 * 64 * 32 * 4);
}

} // namespace
} // namespace ddt::tool::test
