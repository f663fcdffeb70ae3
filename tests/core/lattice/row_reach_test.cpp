// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/row_reach.h"

#include <algorithm>
#include <cstdlib>

#include "tests/core/lattice/flipped_meshes.h"

namespace ddt::test {
namespace {

/// Rows that an edge is found in.
struct Rows {
    int upper, lower; ///< of its ends
    int midpoint;     ///< of the doubled lattice
};

std::vector<Rows> rows_of(const Lattice& lattice) {
    std::vector<Rows> all;
    lattice.each_edge([&](int m) {
        const EdgeView e = view(lattice, m);
        all.push_back({std::min(e.a.y, e.b.y), std::max(e.a.y, e.b.y), m / lattice.stride()});
    });
    return all;
}

TEST(RowReach, NoEdgeGoesFurther) {
    each_flipped_mesh([&](const Lattice& lattice, const std::vector<Face>&, Random&) {
        RowReach reach;
        reach.find(lattice);
        const std::vector<Rows> edges = rows_of(lattice);
        for (int y = 0; y < lattice.height(); ++y) {
            for (const Rows& e : edges) {
                ASSERT_TRUE(!(e.upper <= y) || e.lower <= reach.last_neighbour(y));
                ASSERT_TRUE(!(e.lower >= y) || e.upper >= reach.first_neighbour(y));
                ASSERT_TRUE(!(e.midpoint <= 2 * y) || e.lower <= reach.last_end(y));
                ASSERT_TRUE(!(e.midpoint >= 2 * y) || e.upper >= reach.first_end(y));
            }
            ASSERT_LE(reach.last_neighbour(y),
                      std::min(y + lattice.longest(), lattice.height() - 1));
            ASSERT_GE(reach.first_neighbour(y), std::max(y - lattice.longest(), 0));
        }
    });
}

TEST(RowReach, LongEdgesElsewhereDoNotCount) {
    constexpr int height = 40;
    Lattice lattice;
    const auto guide = make_guide(Kind::noise, 12, height, 1);
    lattice.start(12, height, guide.data(), true);
    Random random(2);
    for (int k = 0; k < 300; ++k) {
        std::vector<int> upper = flippable_edges(lattice);
        upper.erase(std::remove_if(upper.begin(), upper.end(),
                                   [&](int m) { return m >= lattice.vertex_site(0, 10); }),
                    upper.end());
        lattice.flip(upper[size_t(random.below(int(upper.size())))]);
    }
    ASSERT_GT(lattice.longest(), 2);
    RowReach reach;
    reach.find(lattice);
    EXPECT_GT(reach.last_neighbour(5), 6);
    for (int y = 20; y + 1 < height; ++y) {
        EXPECT_EQ(reach.last_neighbour(y), y + 1);
        EXPECT_EQ(reach.first_neighbour(y), y - 1);
        EXPECT_EQ(reach.last_end(y), y);
        EXPECT_EQ(reach.first_end(y), y);
    }
}

TEST(RowReach, ReachesTheNextRowsWhereNothingWasFlipped) {
    for (const int height : {2, 3, 9}) {
        Lattice lattice;
        const auto guide = make_guide(Kind::noise, 5, height, 1);
        lattice.start(5, height, guide.data(), true);
        RowReach reach;
        reach.find(lattice);
        for (int y = -1; y <= height; ++y) {
            const auto inside = [&](int row) { return std::clamp(row, 0, height - 1); };
            const int row = inside(y);
            EXPECT_EQ(reach.last_neighbour(y), inside(row + 1));
            EXPECT_EQ(reach.first_neighbour(y), inside(row - 1));
            EXPECT_EQ(reach.last_end(y), row);
            EXPECT_EQ(reach.first_end(y), row);
        }
    }
}

} // namespace
} // namespace ddt::test
