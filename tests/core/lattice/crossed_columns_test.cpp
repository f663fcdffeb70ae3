// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/crossed_columns.h"

#include "tests/core/lattice/flipped_meshes.h"

namespace ddt::test {
namespace {

TEST(CrossedColumns, AreThoseThatAreCrossed) {
    Random random(7);
    for (int trial = 0; trial < 2000; ++trial) {
        const int n = 1 + random.below(40);
        // From none to all crossed; after the last of them anything.
        const int rarity = 1 + random.below(12);
        std::vector<Division> cells(size_t(n + cells_at_once));
        for (Division& cell : cells)
            cell = random.below(rarity) ? Division(random.below(2)) : Division::crossed;
        const int begin = random.below(n + 1), end = begin + random.below(n + 1 - begin);
        const auto crossed = [&](int x) { return crossed_cells(cells.data() + x); };
        for (int x = 0; x <= n; ++x) {
            int slow = x;
            while (begin <= slow && slow < end && cells[size_t(slow)] != Division::crossed)
                ++slow;
            ASSERT_EQ(next_crossed(x, begin, end, crossed), slow) << begin << " .. " << end;
        }
        std::vector<int> slow, listed(size_t(end - begin + cells_at_once), -1);
        for (int x = begin; x < end; ++x)
            if (cells[size_t(x)] == Division::crossed)
                slow.push_back(x);
        listed.resize(size_t(list_crossed(begin, end, crossed, listed.data())));
        ASSERT_EQ(listed, slow) << begin << " .. " << end;
    }
}

TEST(CrossedColumns, WhatIsBesideARowOfPixelsAreTheCellsRoundIt) {
    each_flipped_mesh([](Lattice& lattice, const auto&, Random&) {
        lattice.find_divisions(lattice.all());
        const int columns = lattice.width() - 1, rows = lattice.height() - 1;
        for (int y = 0; y <= rows; ++y)
            for (int x = 1; x < columns; ++x) {
                bool any = false;
                for (const int cy : {std::max(y - 1, 0), std::min(y, rows - 1)})
                    for (const int cx : {x - 1, x})
                        any = any || lattice.divisions(cy)[cx] == Division::crossed;
                const uint64_t first = NearDivisions(lattice, y).crossed_beside(x) & 255;
                ASSERT_EQ(first != 0, any) << x << ", " << y;
            }
    });
}

} // namespace
} // namespace ddt::test
