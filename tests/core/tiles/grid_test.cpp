// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/grid.h"

#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

TEST(Grid, CellsAreServedOnceAndTilesHaveTheirHalo) {
    constexpr int t = tile_size;
    for (const int width : {1, 2, 3, t, t + 1, t + 2, t + tile_halo + 1, 2 * t + 1, 2 * t + 2, 700})
        for (const int height : {1, 2, t + 1, t + 2, 600})
            for (const Pixel origin : {Pixel{0, 0}, Pixel{-300, 77}, Pixel{-(1 << 29), 1 << 28}}) {
                SCOPED_TRACE(::testing::Message() << width << " x " << height);
                const Rect window{origin.x, origin.y, origin.x + width, origin.y + height};
                const Grid grid(window);
                // A window one pixel wide still has a column of cells.
                const int columns = std::max(1, width - 1), rows = std::max(1, height - 1);
                std::vector<int> served(size_t(columns) * size_t(rows), 0);
                for (int i = 0; i < grid.count(); ++i) {
                    const Tile tile = grid.tile(i);
                    const Rect &c = tile.cells, &p = tile.pixels;
                    ASSERT_FALSE(c.empty());
                    ASSERT_LE(c.width(), tile_size);
                    ASSERT_LE(c.height(), tile_size);
                    ASSERT_EQ((c.x0 - window.x0) % tile_size, 0);
                    ASSERT_EQ((c.y0 - window.y0) % tile_size, 0);
                    ASSERT_EQ(tile.last_x, c.x1 == window.x0 + columns);
                    ASSERT_EQ(tile.last_y, c.y1 == window.y0 + rows);
                    for (int y = c.y0 - window.y0; y < c.y1 - window.y0; ++y)
                        for (int x = c.x0 - window.x0; x < c.x1 - window.x0; ++x)
                            ++served[size_t(y) * size_t(columns) + size_t(x)];
                    // The cells' pixels and tile_halo more, as far as there are any.
                    ASSERT_EQ(p.x0, std::max(window.x0, c.x0 - tile_halo));
                    ASSERT_EQ(p.y0, std::max(window.y0, c.y0 - tile_halo));
                    ASSERT_EQ(p.x1, std::min(window.x1, c.x1 + 1 + tile_halo));
                    ASSERT_EQ(p.y1, std::min(window.y1, c.y1 + 1 + tile_halo));
                }
                ASSERT_EQ(size_t(std::count(served.begin(), served.end(), 1)), served.size());
            }
}

TEST(Grid, TheConstantsResultsDependOn) {
    EXPECT_EQ(tile_size, 256);
    EXPECT_EQ(tile_halo, 32);
}

} // namespace
} // namespace ddt::test
