// SPDX-License-Identifier: Apache-2.0
// The kernels' times alone, on one tile: seconds an item, which is a source pixel, an edge or an
// output pixel as said with each.
#include <climits>

#include <benchmark/benchmark.h>

#include "core/guide/guide.h"
#include "core/lattice/lattice.h"
#include "core/sample/evaluate.h"
#include "core/tiles/grid.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/one_round.h"
#include "core/triangulate/triangulate.h"
#include "noise.h"
#include "tests/core/surface/whole_net.h"

namespace ddt {
namespace {

constexpr int side = largest_tile(INT_MAX); // of a tile with its halo
constexpr int channels = 3;
constexpr int scale = 4;

/// Clouds, and in front of them the outline of another cloud.
std::vector<float> make_guide() {
    std::vector<float> guide;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            using testimages::cloud;
            const bool front = cloud(x / 120.0, y / 120.0, 40, 5) > 0.55;
            const double texture = cloud(x / 90.0, y / 90.0, 1, 7);
            guide.push_back(guide_step(float(front ? texture : 0.3 + 0.5 * texture * texture)));
        }
    return guide;
}

/// A tile at every stage of its work.
struct Tile {
    const MeshOptions options;
    std::vector<float> guide = make_guide(), values;
    Lattice start, mesh; ///< before and after the flips
    Workspace workspace;
    Statistics statistics;
    ControlNet net;
    test::WholeEdges edges;

    Tile() {
        for (const float v : guide)
            values.insert(values.end(), {v, 0.9f * v, 1 - v});
        ddt::start(start, side, side, guide.data(), options);
        mesh = start;
        triangulate(mesh, options, workspace, statistics);
        mesh.find_divisions(mesh.all());
        mesh.find_first_edges(mesh.all());
        test::set_all_vertices(mesh, {values.data(), channels, 0, channels}, net);
        edges.make(mesh, {0, 0, side, side}, true, false, 0, net);
    }

    /// Positions of output row `row`.
    std::vector<Point> points(int row) const {
        std::vector<Point> p;
        for (int x = 0; x < scale * tile_size; ++x)
            p.push_back({(tile_halo + x / scale) * position_one + x % scale * position_one / scale,
                         tile_halo * position_one + row * (position_one / scale)});
        return p;
    }
};

Tile& tile() {
    static Tile only;
    return only;
}

void count(benchmark::State& state, int64_t items) {
    state.SetItemsProcessed(state.iterations() * items);
}

/// A source pixel: the guide from linear RGB.
void guide(benchmark::State& state) {
    GuideRecipe recipe;
    for (int c = 0; c < 3; ++c) {
        recipe.channel[c] = c;
        recipe.weight[c] = 1.0f / 3;
    }
    std::vector<float> out(side * side);
    for (auto _ : state) {
        make_guide(recipe, tile().values.data(), out.size(), channels, out.data());
        benchmark::DoNotOptimize(out.data());
    }
    count(state, side * side);
}
BENCHMARK(guide);

/// A source pixel.
void start(benchmark::State& state) {
    Lattice lattice;
    for (auto _ : state)
        ddt::start(lattice, side, side, tile().guide.data(), tile().options);
    count(state, side * side);
}
BENCHMARK(start);

/// An edge that can be flipped; of the starting mesh.
void gains_of_all(benchmark::State& state) {
    Lattice lattice = tile().start;
    std::vector<int> sites;
    lattice.each_edge([&](int m) {
        if (lattice.edge(m).flippable())
            sites.push_back(m);
    });
    for (auto _ : state)
        find_gains(lattice, criterion(tile().options), sites.data(), sites.size());
    count(state, int64_t(sites.size()));
}
BENCHMARK(gains_of_all);

/// A source pixel: all flips of the default scheme.
void one_round_whole(benchmark::State& state) {
    Workspace workspace;
    Statistics statistics;
    const MeshOptions& options = tile().options;
    for (auto _ : state) {
        state.PauseTiming();
        Lattice lattice = tile().start;
        state.ResumeTiming();
        one_round(lattice, criterion(options), min_gain(options), options.max_iterations, workspace,
                  statistics);
    }
    count(state, side * side);
}
BENCHMARK(one_round_whole);

/// A source pixel: as jobs do it.
void find_cells(benchmark::State& state) {
    Lattice lattice = tile().mesh;
    for (auto _ : state) {
        lattice.find_divisions(lattice.all());
        lattice.find_walked_first_edges(lattice.all());
    }
    count(state, side * side);
}
BENCHMARK(find_cells);

/// A source pixel, three channels.
void make_edges_whole(benchmark::State& state) {
    ControlNet net = tile().net;
    test::WholeEdges edges;
    for (auto _ : state) {
        edges.make(tile().mesh, {0, 0, side, side}, true, false, 0, net);
    }
    count(state, side * side);
}
BENCHMARK(make_edges_whole);

/// An output pixel at 4x.
void locate_rows(benchmark::State& state) {
    std::vector<std::vector<Point>> rows;
    for (int y = 0; y < scale * 32; ++y)
        rows.push_back(tile().points(y));
    Search search;
    LocatedRow located;
    for (auto _ : state) {
        search.begin();
        for (const auto& points : rows)
            locate_row(tile().mesh, points.data(), int(points.size()), search, located);
    }
    count(state, int64_t(rows.size() * rows[0].size()));
}
BENCHMARK(locate_rows);

/// An output pixel at 4x, three channels.
void evaluate_rows(benchmark::State& state) {
    constexpr int rows = 32;
    std::vector<LocatedRow> located(rows);
    const size_t width = tile().points(0).size();
    Search search;
    search.begin();
    for (int y = 0; y < rows; ++y)
        locate_row(tile().mesh, tile().points(y).data(), int(width), search, located[size_t(y)]);
    std::vector<float> out(width * channels + row_padding);
    for (auto _ : state)
        for (const LocatedRow& row : located) {
            evaluate_row(tile().net, Surface::patch, 0, row,
                         {out.data(), 0, channels, 0, channels});
            benchmark::DoNotOptimize(out.data());
        }
    count(state, int64_t(rows * width));
}
BENCHMARK(evaluate_rows);

/// An output pixel at 4x, three channels: both of the above by blocks, as enlarging does.
void sample_blocks(benchmark::State& state) {
    constexpr int rows = 32;
    std::vector<Point> points = tile().points(0);
    const size_t width = points.size();
    std::vector<int32_t> ys;
    for (int y = 0; y < rows; ++y)
        ys.push_back(tile().points(y)[0].y);
    Columns columns;
    columns.find(points.data(), int(width), tile().mesh.width());
    LocatedBlock block;
    std::vector<float> out(width * channels * LocatedBlock::most_rows + row_padding);
    for (auto _ : state) {
        Search search;
        search.begin();
        for (int y = 0; y < rows;) {
            y += locate_block(tile().mesh, columns, points, ys.data() + y, rows - y, search, block);
            evaluate_block(tile().net, Surface::patch, columns, block,
                           {out.data(), width * channels, channels, 0, channels});
            benchmark::DoNotOptimize(out.data());
        }
    }
    count(state, int64_t(rows * width));
}
BENCHMARK(sample_blocks);

} // namespace
} // namespace ddt
