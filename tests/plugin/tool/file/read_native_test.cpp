// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/read_native.h"

#include <climits>

#include <gtest/gtest.h>

namespace ddt::tool {
namespace {

OIIO::ImageSpec file_of(int tile_width, int tile_height) {
    OIIO::ImageSpec spec(100, 80, 1, OIIO::TypeUInt8);
    spec.x = -30;
    spec.y = 7;
    spec.tile_width = tile_width;
    spec.tile_height = tile_height;
    return spec;
}

TEST(Readable, AreWholeTilesOfTheFile) {
    const Rect wanted{0, 20, 10, 30};
    EXPECT_TRUE((readable(file_of(32, 16), wanted) == Rect{-30 + 0, 7 + 0, -30 + 64, 7 + 32}));
    EXPECT_TRUE((readable(file_of(0, 0), wanted) == Rect{-30, 20, 70, 30}));
    EXPECT_TRUE((readable(file_of(32, 16), {-1000, -1000, 1000, 1000}) == Rect{-30, 7, 70, 87}));
}

TEST(Readable, GoNoFurtherThanTheImageWhereItsTilesDo) {
    EXPECT_TRUE((readable(file_of(INT_MAX, INT_MAX), {0, 20, 10, 30}) == Rect{-30, 7, 70, 87}));
}

} // namespace
} // namespace ddt::tool
