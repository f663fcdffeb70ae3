// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/file_tiles.h"

#include <gtest/gtest.h>

namespace ddt {
namespace {

TEST(FileTiles, GoAsFarAsTheImage) {
    EXPECT_EQ(tile_side(64, 1000), 64);
    EXPECT_EQ(tile_side(64, 16), 16);
    EXPECT_EQ(tile_side(INT_MAX, 16), 16);
    EXPECT_EQ(tile_side(0, 16), 1);
    EXPECT_EQ(tile_side(-5, 0), 1);
}

TEST(FileTiles, RowsAreRoundedUpToWholeOnes) {
    EXPECT_EQ(rounded_up(64, 48), 96);
    EXPECT_EQ(rounded_up(96, 48), 96);
    EXPECT_EQ(rounded_up(0, 48), 0);
    EXPECT_EQ(rounded_up(64, INT_MAX), INT_MAX);
    EXPECT_EQ(rounded_up(INT_MAX - 1, 1 << 20), INT_MAX);
}

} // namespace
} // namespace ddt
