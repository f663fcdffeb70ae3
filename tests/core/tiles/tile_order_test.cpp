// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_order.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/core/random.h"

namespace ddt::test {
namespace {

TEST(TileOrder, IsFromTheFirstToTheLastWhereThereIsOneNode) {
    TileOrder order(12, 4);
    for (int i = 0; i < 12; ++i) {
        ASSERT_FALSE(order.empty());
        EXPECT_EQ(order.next(3), i);
    }
    EXPECT_TRUE(order.empty());
    EXPECT_TRUE(TileOrder(0, 1).empty());
}

TEST(TileOrder, GivesEachNodeWholeRowsOfItsOwn) {
    // 8 rows of 5.
    TileOrder order(40, 5);
    const int nodes[4] = {2, 0, 7, 1}, first[4] = {0, 20, 10, 30};
    for (int k = 0; k < 4; ++k)
        EXPECT_EQ(order.next(nodes[k]), first[k]) << k;
    for (int i = 1; i < 10; ++i)
        for (int k = 0; k < 4; ++k)
            EXPECT_EQ(order.next(nodes[k]), first[k] + i) << k;
    EXPECT_TRUE(order.empty());
}

TEST(TileOrder, GivesWhoHasNoneLeftHalfOfTheMostThatAnotherHas) {
    TileOrder order(64, 4);
    EXPECT_EQ(order.next(0), 0);
    for (int i = 32; i < 64; ++i)
        EXPECT_EQ(order.next(1), i);
    // 31 are left from 1 on: the half is 16, where a row begins.
    EXPECT_EQ(order.next(1), 16);
    EXPECT_EQ(order.next(0), 1);
    // A row that is begun is divided itself.
    TileOrder row(7, 7);
    EXPECT_EQ(row.next(0), 0);
    EXPECT_EQ(row.next(1), 4);
    EXPECT_EQ(row.next(2), 2);
}

TEST(TileOrder, GivesEachTileOnceWhoeverAsks) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        Random random(seed);
        const int columns = 1 + int(random.below(9)), tiles = 1 + int(random.below(90));
        TileOrder order(tiles, columns);
        std::set<int> given;
        while (!order.empty()) {
            const int tile = order.next(int(random.below(5)));
            EXPECT_TRUE(tile >= 0 && tile < tiles);
            EXPECT_TRUE(given.insert(tile).second);
        }
        EXPECT_EQ(given.size(), size_t(tiles));
    }
}

} // namespace
} // namespace ddt::test
