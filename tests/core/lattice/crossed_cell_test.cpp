// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/crossed_cell.h"

#include "core/base/arith.h"
#include "tests/core/lattice/flipped_meshes.h"

namespace ddt::test {
namespace {

#include "core/lattice/crossed_cell-inl.h"

/// n ascending multiples of 2^-16 from 0 on: below 1, which is the next cell's, or up to it in the
/// last.
std::vector<float> make_axis(int n, bool last, Random& random) {
    std::vector<float> axis;
    const int shift = random.below(17), end = position_one >> shift;
    for (int i = 0; i < n; ++i)
        axis.push_back(float(random.between(0, last ? end : end - 1) << shift) / position_one);
    std::sort(axis.begin(), axis.end());
    return axis;
}

/// Each position belongs to the triangle that locate() finds, and its weights are the same.
void check_cell(const Lattice& lattice, int cx, int cy, const CellPositions& positions,
                const std::vector<CrossingTriangle>& triangles) {
    const uint64_t all = ~uint64_t(0) >> (CellPositions::most - positions.count());
    uint64_t held = 0;
    for (const CrossingTriangle& t : triangles) {
        ASSERT_NE(t.positions, 0u);
        ASSERT_EQ(t.positions & held, 0u);
        held |= t.positions;
        for (int i = 0; i < positions.count(); ++i) {
            if (!(t.positions >> i & 1))
                continue;
            const float x = positions.x()[i], y = positions.y()[i];
            const Point p{int32_t((float(cx) + x) * position_one),
                          int32_t((float(cy) + y) * position_one)};
            const Triangle expected = locate(lattice, p);
            for (int k = 0; k < 3; ++k) {
                ASSERT_EQ(t.vertex[k], expected.vertex[k]) << p.x << ' ' << p.y;
                ASSERT_EQ(t.edge(k), expected.edge[k]);
            }
            int32_t w[3];
            expected.weights(p, w);
            const CrossingWeights<float> b(t.planes, x, y);
            const float found[3] = {b.b0, b.b1, b.b2};
            for (int k = 0; k < 3; ++k) {
                const float exact = float(w[k]) / position_one;
                ASSERT_EQ(std::memcmp(&found[k], &exact, sizeof exact), 0); // not -0 either
            }
        }
    }
    ASSERT_EQ(held, all);
}

TEST(CrossedCell, EveryPositionIsInTheTriangleThatLocateFinds) {
    on_each_target([] {
        int most = 0;
        each_flipped_mesh([&](const Lattice& lattice, const std::vector<Face>&, Random& random) {
            const int last_x = lattice.width() - 2, last_y = lattice.height() - 2;
            CellPositions positions;
            for (int cy = 0; cy <= last_y; ++cy)
                for (int cx = 0; cx <= last_x; ++cx) {
                    const int columns = random.between(1, 9), rows = random.between(1, 7);
                    const auto x = make_axis(columns, cx == last_x, random),
                               y = make_axis(rows, cy == last_y, random);
                    positions.set(x.data(), columns, y.data(), rows);
                    std::vector<CrossingTriangle> triangles;
                    find_crossing_triangles(lattice, cx, cy, positions, triangles);
                    most = std::max(most, int(triangles.size()));
                    check_cell(lattice, cx, cy, positions, triangles);
                }
        });
        EXPECT_GT(most, 4);
    });
}

TEST(CrossedCell, PositionsAreThoseThatWereSetLast) {
    CellPositions positions;
    const float x[] = {0, 0.25f, 0.5f, 1}, y[] = {0.125f, 0.75f, 1};
    const auto check = [&](const float* at_x, int columns, const float* at_y, int rows) {
        positions.set(at_x, columns, at_y, rows);
        ASSERT_EQ(positions.count(), columns * rows);
        for (int r = 0; r < rows; ++r)
            for (int i = 0; i < columns; ++i) {
                EXPECT_EQ(positions.x()[r * columns + i], at_x[i]);
                EXPECT_EQ(positions.y()[r * columns + i], at_y[r]);
            }
    };
    check(x, 4, y, 3);
    check(x, 4, y, 2);
    check(x, 3, y, 2);
    check(x + 1, 3, y, 2);
    check(x + 1, 3, y + 1, 2);
    check(x + 1, 3, y + 1, 2);
}

} // namespace
} // namespace ddt::test
