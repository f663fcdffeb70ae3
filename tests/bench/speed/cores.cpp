// SPDX-License-Identifier: Apache-2.0
// What a machine with more cores than this one would make of a job, as far as that is up to how it
// is cut: who is done takes the next tile, and when there are no more, half of the rows of another.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "core/tiles/grid.h"
#include "core/tiles/tile_io.h"
#include "tables.h"
#include "times.h"

namespace speed {

namespace {

/// Seconds on one thread.
struct TileTime {
    double mesh = 0; ///< which is one thread's work
    double rows = 0; ///< which can be shared
    double all() const { return mesh + rows; }
};
using TileTimes = std::vector<TileTime>;

ddt::ResizeMapping::Axis along(int size, int enlarged) {
    ddt::ResizeMapping::Axis axis;
    axis.from_size = axis.window1 = size;
    axis.to_size = axis.out1 = enlarged;
    return axis;
}

/// Tile by tile. Empty on failure, after a line on stderr.
TileTimes time_tiles(const std::string& filter, Task task) {
    ddt::Statistics statistics;
    const Way way = ddt_way(filter + ",device=cpu", &statistics);
    const OIIO::ImageSpec& spec = task.image.spec();
    const ddt::ResizeMapping mapping(along(spec.width, task.width()),
                                     along(spec.height, task.height()));
    const ddt::Rect window{0, 0, spec.width, spec.height};
    const ddt::Grid grid(window);
    TileTimes times;
    for (int i = 0; i < grid.count(); ++i) {
        const ddt::Rect pixels = ddt::reach_of(grid.tile(i), window, mapping);
        task.part = {pixels.x0, pixels.x1, pixels.y0, pixels.y1, 0, 1, 0, 3};
        if (way.run(task) < 0)
            return {};
        const ddt::StageTimes& t = statistics.times;
        times.push_back(
            {double(t.read + t.triangulate) * 1e-9, double(t.surface + t.sample + t.write) * 1e-9});
    }
    return times;
}

/// When the last of so many threads is done, if rows can be cut as finely as one likes and what is
/// made twice for that costs nothing.
double end_of(const TileTimes& tiles, size_t threads) {
    struct Begun {
        double at;
        const TileTime* tile;
    };
    // Tiles are begun in order. From the moment on at which the last is, rows are anyone's.
    std::priority_queue<double, Times, std::greater<double>> idle_at;
    for (size_t i = 0; i < threads; ++i)
        idle_at.push(0);
    std::vector<Begun> begun;
    for (const TileTime& tile : tiles) {
        begun.push_back({idle_at.top(), &tile});
        idle_at.pop();
        idle_at.push(begun.back().at + tile.all());
    }
    double now = begun.back().at, rows = 0;        // that can be worked on
    std::vector<std::pair<double, double>> meshes; // when they will be there, and their rows
    for (const auto& [at, tile] : begun) {
        const double meshed = at + tile->mesh;
        if (meshed > now)
            meshes.emplace_back(meshed, tile->rows);
        else
            rows += std::max(meshed + tile->rows - now, 0.0);
    }
    std::sort(meshes.begin(), meshes.end());
    for (size_t i = 0; i < meshes.size(); ++i) {
        const double free = double(threads - (meshes.size() - i));
        rows = std::max(rows - (meshes[i].first - now) * free, 0.0) + meshes[i].second;
        now = meshes[i].first;
    }
    return now + rows / double(threads);
}

} // namespace

bool print_cores(const Pictures& pictures, const Plan& plan) {
    const Format format = plan.formats[0];
    const OIIO::ImageBuf image = pictures.make(plan.megapixels, format);
    std::printf("\ntimes as fast as 1 thread, by the tiles' times: %dx%d RGB, %s\n"
                "%-19s %5s %25s %10s",
                image.spec().width, image.spec().height, name_of(format), "", "tiles",
                "ms a tile, least to most", "for meshes");
    constexpr size_t counts[] = {2, 8, 16, 32, 64, 128};
    for (const size_t threads : counts)
        std::printf(" %5zu", threads);
    std::printf("\n");
    for (const double scale : plan.scales) {
        OIIO::ImageBuf into = warm_image({image, scale, 1, nullptr});
        for (const std::string& filter : plan.filters) {
            const TileTimes tiles = time_tiles(filter, {image, scale, 1, &into});
            if (tiles.empty())
                return false;
            Times all;
            double sum = 0, meshes = 0;
            for (const TileTime& tile : tiles) {
                all.push_back(tile.all());
                sum += tile.all();
                meshes += tile.mesh;
            }
            const auto [least, most] = std::minmax_element(all.begin(), all.end());
            std::printf("%-14s %3gx %5zu %9.1f %7.1f %7.1f %9.0f%%", filter.c_str(), scale,
                        tiles.size(), *least * 1e3, median(all) * 1e3, *most * 1e3,
                        100 * meshes / sum);
            for (const size_t threads : counts)
                std::printf(" %5.1f", sum / end_of(tiles, threads));
            std::printf("\n");
            std::fflush(stdout);
        }
    }
    return true;
}

} // namespace speed
