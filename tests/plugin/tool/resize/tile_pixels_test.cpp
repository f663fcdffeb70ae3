// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/tile_pixels.h"

#include <gtest/gtest.h>

#include "core/tiles/grid.h"

namespace ddt::tool {
namespace {

TEST(TilePixels, EndWhereNoTileIsWorkedTwice) {
    // A data window that begins where it likes, three tiles wide and high.
    ResizeMapping::Axis x;
    x.from0 = -10;
    x.from_size = 700;
    x.to0 = 5;
    x.to_size = 2333;
    x.window0 = -37;
    x.window1 = x.window0 + 3 * tile_size;
    x.out0 = -90;
    x.out1 = 2500;
    const Grid grid({x.window0, x.window0, x.window1, x.window1});
    ASSERT_EQ(grid.columns(), 3);
    int end = x.out0;
    for (int i = 0; i < 3; ++i) {
        const Rect r = pixels_of_tiles({i, 0, i + 1, 3}, 3, 3, x, x);
        EXPECT_EQ(r.x0, end);
        EXPECT_EQ(r.y0, x.out0);
        EXPECT_EQ(r.y1, x.out1);
        end = r.x1;
        // Both ends show cells of this tile alone.
        const Rect cells = grid.tile(i).cells;
        EXPECT_GE(x.position(r.x0), int64_t(cells.x0) << 16);
        EXPECT_LT(x.position(r.x1 - 1), int64_t(cells.x1 + (i == 2)) << 16);
    }
    EXPECT_EQ(end, x.out1);
}

} // namespace
} // namespace ddt::tool
