// SPDX-License-Identifier: Apache-2.0
#include "core/surface/fan_rows.h"

#include "tests/core/lattice/flipped_meshes.h"
#include "tests/core/surface/scene.h"

namespace ddt::test {
namespace {

std::vector<int> columns_of(const Fans& fans) {
    std::vector<int> columns;
    for (const Fans::Group& group : fans.groups)
        for (const int x : group.x)
            if (columns.empty() || x != columns.back())
                columns.push_back(x);
    return columns;
}

TEST(FanRows, HaveTheVerticesBesideCrossedCells) {
    size_t found = 0;
    each_flipped_mesh([&](const Lattice& flipped, const std::vector<Face>&, Random&) {
        Lattice lattice = flipped;
        lattice.find_divisions(lattice.all());
        lattice.find_walked_first_edges(lattice.all());
        FanRows rows;
        rows.begin(lattice, 2);
        const int last = lattice.width() - 1;
        for (int y = 1; y + 1 < lattice.height(); ++y) {
            std::vector<int> expected;
            for (int x = 1; x < last; ++x)
                for (int cell = 0; cell < 4; ++cell)
                    if (lattice.divisions(y - cell / 2)[x - cell % 2] == Division::crossed) {
                        expected.push_back(x);
                        break;
                    }
            if (last > 1) {
                ASSERT_EQ(columns_of(rows.row(y, 1, last)), expected);
            }
            found += expected.size();
        }
    });
    EXPECT_GT(found, 300u);
}

TEST(FanRows, AreFoundAgainOnlyWhereTheyAreNotThere) {
    Random random(1);
    Scene scene(12, 9, 400, random);
    Lattice lattice = scene.lattice;
    lattice.find_divisions(lattice.all());
    lattice.find_walked_first_edges(lattice.all());
    FanRows rows;
    rows.begin(lattice, 3);
    const auto count = [&](int y, int x0, int x1) {
        return columns_of(rows.row(y, x0, x1)).size();
    };
    size_t before[3];
    for (int y = 2; y < 5; ++y) {
        before[y - 2] = count(y, 2, 10);
        ASSERT_GT(before[y - 2], 0u);
    }
    // What is found from here on has no cell that is crossed.
    lattice.start(12, 9, std::vector<float>(12 * 9).data(), true);
    lattice.find_divisions(lattice.all());
    for (int y = 2; y < 5; ++y) {
        EXPECT_EQ(count(y, 2, 10), before[y - 2]);
        EXPECT_EQ(count(y, 3, 7), before[y - 2]); // its vertices among others
    }
    EXPECT_EQ(count(5, 2, 10), 0u); // in the place of row 2
    EXPECT_EQ(count(2, 2, 10), 0u);
    EXPECT_EQ(count(3, 1, 10), 0u); // more of it than is there
    EXPECT_EQ(count(4, 2, 10), before[2]);
    rows.begin(lattice, 3);
    EXPECT_EQ(count(4, 2, 10), 0u);
}

} // namespace
} // namespace ddt::test
