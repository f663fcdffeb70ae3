// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/grid.h"

#include <algorithm>
#include <climits>

#include "core/tiles/tile_io.h"
#include "tests/core/job_helpers.h"
#include "tests/core/mirrored.h"

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

TEST(Grid, NoTileIsLargerThanTheLargest) {
    for (int width = 1; width < 5 * tile_size; ++width) {
        const Grid grid({-7, 0, width - 7, 1});
        int most = 2; // pixels of a lattice, at least
        for (int i = 0; i < grid.count(); ++i)
            most = std::max(most, grid.tile(i).pixels.width());
        ASSERT_LE(most, largest_tile(width));
        if (width <= tile_size || width >= 3 * tile_size) {
            ASSERT_EQ(most, largest_tile(width)) << width;
        }
    }
}

TEST(Grid, ABlockHasTheSameTiles) {
    const Grid grid({-7, 5, 1400, 900});
    ASSERT_EQ(grid.columns(), 6);
    ASSERT_EQ(grid.rows(), 4);
    EXPECT_EQ(grid.pixels(), (Rect{-7, 5, 1400, 900}));
    const Grid block = grid.block({1, 2, 4, 4}), last = block.block({2, 1, 3, 2});
    ASSERT_EQ(block.columns(), 3);
    ASSERT_EQ(block.rows(), 2);
    EXPECT_EQ(block.pixels(), (Rect{249, 517, 1018, 900}));
    for (int i = 0; i < block.count(); ++i) {
        const Tile a = block.tile(i), b = grid.tile((2 + i / 3) * 6 + 1 + i % 3);
        EXPECT_EQ(a.cells, b.cells);
        EXPECT_EQ(a.pixels, b.pixels);
        EXPECT_EQ(a.last_x, b.last_x);
        EXPECT_EQ(a.last_y, b.last_y);
    }
    ASSERT_EQ(last.count(), 1);
    EXPECT_EQ(last.tile(0).cells, grid.tile(3 * 6 + 3).cells);
    EXPECT_EQ(grid.block({}).count(), 0);
    EXPECT_TRUE(grid.block({}).pixels().empty());
}

/// How often it was asked for a rectangle.
class Asked final : public Mapping {
public:
    explicit Asked(const Mapping& mapping) : m_mapping(mapping) {}
    Rect reach(double x0, double y0, double x1, double y1) const override {
        ++times;
        return m_mapping.reach(x0, y0, x1, y1);
    }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        m_mapping.row(y, x0, x1, positions, inside);
    }
    mutable int times = 0;

private:
    const Mapping& m_mapping;
};

/// That no smaller block has all tiles that are shown.
void expect_shown(const Rect& window, const Mapping& mapping) {
    const Grid all(window), shown = shown_tiles(window, mapping);
    int count = 0;
    Rect cells{INT_MAX, INT_MAX, INT_MIN, INT_MIN};
    for (int i = 0; i < all.count(); ++i) {
        const Tile tile = all.tile(i);
        if (reach_of(tile, window, mapping).empty())
            continue;
        ++count;
        cells = {std::min(cells.x0, tile.cells.x0), std::min(cells.y0, tile.cells.y0),
                 std::max(cells.x1, tile.cells.x1), std::max(cells.y1, tile.cells.y1)};
    }
    ASSERT_EQ(shown.count(), count);
    if (count == 0)
        return;
    EXPECT_EQ(shown.tile(0).cells.x0, cells.x0);
    EXPECT_EQ(shown.tile(0).cells.y0, cells.y0);
    EXPECT_EQ(shown.tile(count - 1).cells.x1, cells.x1);
    EXPECT_EQ(shown.tile(count - 1).cells.y1, cells.y1);
}

TEST(Grid, TilesThatAreShown) {
    const Rect window{-40, 9, 1300, 800}, to{0, 0, 2680, 1582};
    for (const Rect& out :
         {to, Rect{0, 0, 1, 1}, Rect{2679, 1581, 2680, 1582}, Rect{1000, 700, 1016, 716},
          Rect{0, 600, 2680, 601}, Rect{511, 0, 514, 1582}, Rect{500, 500, 500, 520}, Rect{}}) {
        const ResizeMapping mapping = mapping_of(window, to, out);
        SCOPED_TRACE(::testing::Message() << out.x0 << " " << out.y0);
        expect_shown(window, mapping);
        expect_shown(window, Mirrored(mapping, out, true, false));
        expect_shown(window, Mirrored(mapping, out, true, true));
    }
}

TEST(Grid, ManyTilesAreNotLookedAtOneByOne) {
    const Rect window{0, 0, 1 << 20, 1 << 20};
    const ResizeMapping resized =
        mapping_of(window, {0, 0, 1 << 21, 1 << 21}, {1000000, 1000000, 1000016, 1000016});
    const Asked mapping(resized);
    EXPECT_EQ(shown_tiles(window, mapping).count(), 1);
    EXPECT_LE(mapping.times, 2 * (4096 + 1));
}

/// 16 x 16 pixels of what 24 tiles make: one tile, in all that is told.
TEST(Grid, AJobGoesThroughTilesThatAreShown) {
    class Black final : public Source {
    public:
        bool read(const Rect& r, float* values, float* guide) override {
            std::fill_n(values, r.area(), 0.0f);
            std::fill_n(guide, r.area(), 0.0f);
            return true;
        }
    } source;
    class Nowhere final : public Sink {
    public:
        bool write(const Rect&, float*) override { return true; }
    } sink;
    const Rect window{0, 0, 1400, 900}, to{0, 0, 2800, 1800}, out{600, 600, 616, 616};
    const ResizeMapping mapping = mapping_of(window, to, out);
    Job job = plain_job();
    job.window = window;
    job.channels = 1;
    job.threads = 4;
    job.device = Device::cpu;
    std::vector<float> told;
    job.progress = [&](float share) {
        told.push_back(share);
        return true;
    };
    ASSERT_EQ(enlarge(source, sink, mapping, job), Outcome::done);
    EXPECT_EQ(told, std::vector<float>{1});
}

} // namespace
} // namespace ddt::test
