// SPDX-License-Identifier: Apache-2.0
#include "core/sample/evaluate_phases.h"

#include "core/lattice/crossed_search.h"
#include "tests/core/helpers.h"
#include "tests/core/sample/surface_reader.h"
#include "tests/core/surface/scene.h"

namespace ddt::test {
namespace {

/// A grid's values are those of its rows one by one.
void expect_rows(SurfaceReader& reader, const std::vector<int32_t>& x,
                 const std::vector<int32_t>& y) {
    const auto grid = reader.grid(x, y);
    for (size_t r = 0; r < y.size(); ++r) {
        std::vector<Point> points;
        for (const int32_t px : x)
            points.push_back({px, y[r]});
        const auto row = reader.row(points.data(), int(points.size()));
        const auto begin = grid.begin() + ptrdiff_t(r * row.size());
        const std::vector<float> same(begin, begin + ptrdiff_t(row.size()));
        ASSERT_EQ(differing(row, same), 0u) << r;
    }
}

TEST(EvaluatePhases, BlocksHaveTheBitsOfRows) {
    on_each_target([] {
        each_scene([](const Scene& scene, Random& random) {
            const Lattice& l = scene.lattice;
            const auto positions = [&](int size, int step) {
                std::vector<int32_t> p;
                const int32_t last = (size - 1) * position_one;
                for (int32_t at = random.between(0, step); at < last; at += random.between(1, step))
                    p.push_back(at);
                p.push_back(last);
                return p;
            };
            for (const Surface surface : both_surfaces)
                for (const int channels : {1, 2, 3, 4, 7})
                    for (const float tau : {0.0f, 0.5f}) {
                        const auto values =
                            make_values(all_values[size_t(channels) % std::size(all_values)],
                                        scene.pixels() * channels, random);
                        SurfaceReader reader(scene, surface, values, channels, 0, tau);
                        const auto x = positions(l.width(), channels * 20000);
                        const auto y = positions(l.height(), 30000);
                        expect_rows(reader, x, y);
                    }
        });
    });
}

TEST(EvaluatePhases, BlocksOfPositionsThatLieAlikeInCellsHaveTheBitsOfRows) {
    on_each_target([] {
        Random random(5);
        constexpr int few = 70;
        for (const int flips : {0, few, 6000}) {
            const Scene scene(29, 13, flips, random);
            const Lattice& l = scene.lattice;
            for (int phases = least_phases; phases <= most_phases; ++phases)
                for (const int channels : {1, 2, 3, 4, 7})
                    for (const float tau : {0.0f, 0.5f}) {
                        const int rows = random.between(1, LocatedBlock::most_rows);
                        SCOPED_TRACE(::testing::Message()
                                     << flips << " flips, " << phases << " x " << rows << ", "
                                     << channels << ", " << tau);
                        const auto kind = all_values[size_t(channels) % std::size(all_values)];
                        const auto values = make_values(kind, scene.pixels() * channels, random);
                        SurfaceReader reader(scene, both_surfaces[random.below(2)], values,
                                             channels, 0, tau, all_bounds[random.below(3)]);
                        // From anywhere in a cell to anywhere in another; on ties too.
                        const int32_t step = position_one / phases;
                        const int32_t shift = random.below(2) * random.below(step);
                        std::vector<int32_t> x, y;
                        for (int i = random.below(2 * phases);
                             i / phases < l.width() - 1 - random.below(3); ++i)
                            x.push_back(i / phases * position_one + i % phases * step + shift);
                        for (int i = 0; i < (l.height() - 1) * rows; ++i)
                            y.push_back(i / rows * position_one + i % rows * (position_one / rows));
                        expect_rows(reader, x, y);
                        // Few cells fall away at the ends.
                        EXPECT_EQ(reader.alike().phases, phases);
                        EXPECT_GE(reader.alike().cells, l.width() - 1 - 6);
                        const bool fits = phases * rows <= CrossedSearch::most_positions;
                        EXPECT_EQ(reader.crossed() > 0, flips > 0 && fits);
                        if (flips == 0)
                            EXPECT_EQ(reader.together(), reader.blocks());
                        else
                            EXPECT_EQ(reader.mixed() > 0, flips == few && fits);
                    }
        }
    });
}

TEST(Columns, FindTheLongestStretchOfCellsThatAreAlike) {
    const auto alike = [](const std::vector<int32_t>& x) {
        std::vector<Point> points;
        for (const int32_t at : x)
            points.push_back({at, 0});
        Columns columns;
        columns.find(points.data(), int(points.size()), 200);
        return columns.alike;
    };
    // 20 cells with three positions each, one with two, 30 with three.
    std::vector<int32_t> x;
    for (int cell = 5; cell < 56; ++cell)
        for (int k = 0; k < (cell == 25 ? 2 : 3); ++k)
            x.push_back(cell * position_one + 1000 + k * 20000);
    const Columns::Alike found = alike(x);
    EXPECT_EQ(found.cell, 26);
    EXPECT_EQ(found.cells, 30);
    EXPECT_EQ(found.begin, 20 * 3 + 2);
    EXPECT_EQ(found.phases, 3);
    EXPECT_EQ(found.end(), int(x.size()));
    // Elsewhere in every cell, cells with none between, or more in each than are any use.
    for (size_t i = 0; i < x.size(); ++i)
        x[i] = int32_t(i) * 21000;
    EXPECT_EQ(alike(x).cells, 0);
    for (size_t i = 0; i < x.size(); ++i)
        x[i] = int32_t(i) / 2 * 2 * position_one + int32_t(i) % 2 * 30000;
    EXPECT_EQ(alike(x).cells, 0);
    for (size_t i = 0; i < x.size(); ++i)
        x[i] = int32_t(i) / (most_phases + 1) * position_one +
               int32_t(i) % (most_phases + 1) * (position_one / (most_phases + 1));
    EXPECT_EQ(alike(x).cells, 0);
    EXPECT_EQ(alike({}).cells, 0);
}

} // namespace
} // namespace ddt::test
