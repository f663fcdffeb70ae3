// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/cuts.h"

#include "core/tiles/grid.h"
#include "tests/core/job_helpers.h"

namespace ddt::test {
namespace {

/// A window of so many pixels from -7 on, enlarged so many times.
ResizeMapping::Axis enlarged(int pixels, int times) {
    return {-7, pixels, 30, pixels * times, -7, pixels - 7, 30, 30 + pixels * times};
}

TEST(Cuts, LieBetweenTilesOfTheMesh) {
    for (const int times : {1, 2, 3, 5}) {
        const auto axis = enlarged(3000, times);
        const auto cuts = cuts_between_tiles(axis, 900, 2000);
        ASSERT_GT(cuts.size(), 3u);
        EXPECT_EQ(cuts.front(), axis.out0);
        EXPECT_EQ(cuts.back(), axis.out1);
        for (size_t i = 1; i + 1 < cuts.size(); ++i) {
            const int64_t last = axis.position(cuts[i] - 1) + 7 * position_one,
                          first = axis.position(cuts[i]) + 7 * position_one;
            constexpr int64_t tile = int64_t(tile_size) * position_one;
            EXPECT_EQ(last / tile + 1, first / tile) << times << ", " << cuts[i];
            // The first piece has the pixels beyond the first centre, too.
            EXPECT_GE(cuts[i] - cuts[i - 1], 900 - times) << times << ", " << cuts[i];
        }
    }
}

TEST(Cuts, DivideTilesThatAreLong) {
    const auto axis = enlarged(600, 100);
    const auto cuts = cuts_between_tiles(axis, 900, 2000);
    EXPECT_EQ(cuts.front(), axis.out0);
    EXPECT_EQ(cuts.back(), axis.out1);
    for (size_t i = 1; i < cuts.size(); ++i) {
        EXPECT_GT(cuts[i], cuts[i - 1]);
        EXPECT_LE(cuts[i] - cuts[i - 1], 2500);
    }
    EXPECT_EQ(cuts.size(), 1 + size_t(13 + 13 + 5));
}

TEST(Cuts, PiecesHaveTheirFirstPixelAndNotTheNextPiecesOne) {
    const std::vector<int> cuts{-5, 10, 20};
    EXPECT_EQ(piece_of(cuts, -5), 0u);
    EXPECT_EQ(piece_of(cuts, 9), 0u);
    EXPECT_EQ(piece_of(cuts, 10), 1u);
    EXPECT_EQ(piece_of(cuts, 19), 1u);
}

} // namespace
} // namespace ddt::test
