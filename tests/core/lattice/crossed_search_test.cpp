// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/crossed_search.h"

#include "core/base/arith.h"
#include "tests/core/lattice/flipped_meshes.h"

namespace ddt::test {
namespace {

/// n ascending multiples of 2^-16 from 0 to 1, also both of these.
std::vector<float> make_axis(int n, Random& random) {
    std::vector<float> axis;
    const int shift = random.below(17), end = position_one >> shift;
    for (int i = 0; i < n; ++i)
        axis.push_back(float(random.between(0, end) << shift) / position_one);
    std::sort(axis.begin(), axis.end());
    return axis;
}

/// Each position belongs to the one triangle that locate() finds.
void check_cell(const Lattice& lattice, int cx, int cy, const CellPositions& positions,
                const CellTriangle* begin, const CellTriangle* end) {
    unsigned held = 0;
    for (const CellTriangle* t = begin; t < end; ++t) {
        ASSERT_NE(t->positions, 0u);
        ASSERT_EQ(t->positions & held, 0u);
        held |= t->positions;
        const Corners found = t->corners();
        for (int i = 0; i < positions.count(); ++i) {
            if (!(t->positions >> i & 1))
                continue;
            const Point p{int32_t(positions.x()[i] * position_one),
                          int32_t(positions.y()[i] * position_one)};
            const Corners expected = locate(lattice, cx, cy, p);
            for (int k = 0; k < 3; ++k) {
                ASSERT_EQ(found.p[k].x, expected.p[k].x) << p.x << ' ' << p.y << " in cell " << cx;
                ASSERT_EQ(found.p[k].y, expected.p[k].y) << p.x << ' ' << p.y << " in cell " << cx;
            }
        }
    }
    ASSERT_EQ(held, (1u << positions.count()) - 1);
}

TEST(CrossedSearch, EveryPositionIsInTheTriangleThatLocateFinds) {
    on_each_target([] {
        int most = 0;
        each_flipped_mesh([&](const Lattice& lattice, const std::vector<Face>&, Random& random) {
            for (int cy = 0; cy + 1 < lattice.height(); ++cy) {
                const int columns = random.between(1, 5),
                          rows = random.between(1, CrossedSearch::most_positions / columns);
                const auto x = make_axis(columns, random), y = make_axis(rows, random);
                CellPositions positions;
                positions.set(x.data(), columns, y.data(), rows);
                // Some of the row's cells, whether crossed or not.
                std::vector<int> cells;
                for (int cx = 0; cx + 1 < lattice.width(); ++cx)
                    if (random.below(8))
                        cells.push_back(cx);
                if (cells.empty())
                    continue;
                ASSERT_LE(int(cells.size()), CrossedSearch::most_cells_with(1));
                const auto at_once = size_t(CrossedSearch::most_cells_with(positions.count()));
                for (size_t done = 0; done < cells.size(); done += at_once) {
                    const int n = int(std::min(cells.size() - done, at_once));
                    CrossedSearch search;
                    search.find(lattice, cy, cells.data() + done, n, positions);
                    for (int i = 0; i < n; ++i) {
                        most = std::max(most, search.count(i));
                        ASSERT_EQ(search.first(i) + search.count(i),
                                  i + 1 < n ? search.first(i + 1)
                                            : search.end(i) - search.begin(0));
                        check_cell(lattice, cells[done + size_t(i)], cy, positions, search.begin(i),
                                   search.end(i));
                    }
                }
            }
        });
        EXPECT_GT(most, 4);
    });
}

/// As many cells at once as may be, and as many positions.
TEST(CrossedSearch, ManyCellsAreSearchedAtOnce) {
    on_each_target([] {
        Random random(3);
        const auto guide = make_guide(Kind::noise, 260, 3, 7);
        Lattice lattice;
        lattice.start(260, 3, guide.data(), true);
        flip_at_random(lattice, 4000, random);
        for (const int side : {1, 2, 3, 4}) {
            const auto axis = make_axis(side, random);
            CellPositions positions;
            positions.set(axis.data(), side, axis.data(), side);
            const int n = CrossedSearch::most_cells_with(side * side);
            std::vector<int> cells;
            for (int i = 0; i < n; ++i)
                cells.push_back(lattice.width() - 1 - n + i);
            CrossedSearch search;
            search.find(lattice, 1, cells.data(), n, positions);
            for (int i = 0; i < n; ++i)
                check_cell(lattice, cells[size_t(i)], 1, positions, search.begin(i), search.end(i));
        }
    });
}

} // namespace
} // namespace ddt::test
