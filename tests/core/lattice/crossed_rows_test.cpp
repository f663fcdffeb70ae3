// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/crossed_rows.h"

#include "core/surface/consistency/consistency.h"
#include "tests/core/lattice/flipped_meshes.h"
#include "tests/core/surface/scene.h"

namespace ddt::test {
namespace {

bool same(const CrossingTriangle& a, const CrossingTriangle& b) {
    return std::equal(a.vertex, a.vertex + 3, b.vertex) && a.positions == b.positions;
}

TEST(CrossedRows, EachCellHasItsTriangles) {
    size_t crossed = 0;
    each_flipped_mesh([&](const Lattice& flipped, const std::vector<Face>&, Random&) {
        Lattice lattice = flipped;
        lattice.find_divisions(lattice.all());
        CrossedRows rows;
        rows.begin(lattice, mean_positions(), 3);
        for (int y = 0; y + 1 < lattice.height(); ++y) {
            const CrossedRows::Row& row = rows.row(y, 0, lattice.width() - 1);
            auto cell = row.cells.begin();
            for (int x = 0; x + 1 < lattice.width(); ++x) {
                if (lattice.divisions(y)[x] != Division::crossed)
                    continue;
                ++crossed;
                std::vector<CrossingTriangle> expected;
                find_crossing_triangles(lattice, x, y, mean_positions(), expected);
                ASSERT_NE(cell, row.cells.end());
                ASSERT_EQ(cell->x, x);
                ASSERT_EQ(size_t(cell->count), expected.size());
                for (int i = 0; i < cell->count; ++i) {
                    const CellTriangle& kept = row.triangles[size_t(cell->first + i)];
                    const CrossingTriangle t(kept.corners(), lattice.vertex_site(x, y),
                                             lattice.stride(), kept.positions);
                    ASSERT_TRUE(
                        std::any_of(expected.begin(), expected.end(),
                                    [&](const CrossingTriangle& other) { return same(t, other); }));
                }
                ++cell;
            }
            ASSERT_EQ(cell, row.cells.end());
        }
    });
    EXPECT_GT(crossed, 400u);
}

TEST(CrossedRows, RowsAreFoundAgainOnlyWhereTheyAreNotThere) {
    Random random(1);
    Scene scene(12, 9, 400, random);
    Lattice lattice = scene.lattice;
    lattice.find_divisions(lattice.all());
    CrossedRows rows;
    rows.begin(lattice, mean_positions(), 3);
    const auto count = [&](int y, int x0, int x1) { return rows.row(y, x0, x1).cells.size(); };
    size_t before[3];
    for (int y = 2; y < 5; ++y) {
        before[y - 2] = count(y, 1, 10);
        ASSERT_GT(before[y - 2], 0u);
    }
    // What is found from here on has no cell that is crossed.
    lattice.start(12, 9, std::vector<float>(12 * 9).data(), true);
    lattice.find_divisions(lattice.all());
    for (int y = 2; y < 5; ++y) {
        EXPECT_EQ(count(y, 1, 10), before[y - 2]);
        EXPECT_EQ(count(y, 3, 7), before[y - 2]); // its cells among others
    }
    EXPECT_EQ(count(5, 1, 10), 0u); // in the place of row 2
    EXPECT_EQ(count(2, 1, 10), 0u);
    EXPECT_EQ(count(3, 0, 10), 0u); // more of it than is there
    EXPECT_EQ(count(4, 1, 10), before[2]);
    rows.begin(lattice, mean_positions(), 3);
    EXPECT_EQ(count(4, 1, 10), 0u);
}

} // namespace
} // namespace ddt::test
