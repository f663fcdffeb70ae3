// SPDX-License-Identifier: Apache-2.0
// What a machine with more cores than this one would make of a job, as far as that is up to how it
// is cut: who is done takes the next tile, and where there is no more, or no memory for it, half of
// the rows of another.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

#include "core/tiles/crew_size.h"
#include "core/tiles/grid.h"
#include "core/tiles/tile_io.h"
#include "core/tiles/tile_writer.h"
#include "ddt/option_table.h"
#include "tables.h"
#include "times.h"

namespace speed {

namespace {

/// Seconds on one thread.
struct TileTime {
    double mesh = 0; ///< which is one thread's work
    double rows = 0; ///< which can be shared,
    int parts = 1;   ///< by so many
    double all() const { return mesh + rows; }
};
using TileTimes = std::vector<TileTime>;

ddt::ResizeMapping mapping_of(const Task& task) {
    const OIIO::ImageSpec& spec = task.image.spec();
    return {ddt::ResizeMapping::Axis::whole(spec.width, task.width()),
            ddt::ResizeMapping::Axis::whole(spec.height, task.height())};
}

ddt::Rect window_of(const Task& task) {
    return {0, 0, task.image.spec().width, task.image.spec().height};
}

/// The crew that so many threads are.
ddt::CrewSize crew_of(const std::string& filter, const Task& task, size_t threads) {
    ddt::FilterOptions options;
    std::string error;
    ddt::parse_filter(filter, options, error);
    ddt::Job job;
    job.window = window_of(task);
    job.channels = task.image.nchannels();
    job.mesh = options.mesh;
    job.surface = options.surface;
    return ddt::crew_size(mapping_of(task), job, ddt::Grid(job.window), threads);
}

/// Tile by tile, the least of some rounds. Empty on failure, after a line on stderr.
TileTimes time_tiles(const std::string& filter, Task task, int rounds) {
    ddt::Statistics statistics;
    const Way way = ddt_way(filter + ",device=cpu", &statistics);
    const ddt::ResizeMapping mapping = mapping_of(task);
    const ddt::Rect window = window_of(task);
    const ddt::Grid grid(window);
    TileTimes times;
    for (int i = 0; i < grid.count(); ++i) {
        const ddt::Rect pixels = ddt::reach_of(grid.tile(i), window, mapping);
        task.part = {pixels.x0, pixels.x1, pixels.y0, pixels.y1, 0, 1, 0, 3};
        TileTime least;
        least.parts = std::max(1, pixels.height() /
                                      ddt::TileWriter::least_shared_rows(pixels.height(), pixels));
        for (int round = 0; round < rounds; ++round) {
            if (way.run(task) < 0)
                return {};
            const ddt::StageTimes& t = statistics.times;
            const double mesh = double(t.read + t.triangulate) * 1e-9,
                         rows = double(t.surface + t.sample + t.write) * 1e-9;
            if (round == 0 || mesh + rows < least.all()) {
                least.mesh = mesh;
                least.rows = rows;
            }
        }
        times.push_back(least);
    }
    return times;
}

/// When the last member of a crew is done, if rows can be cut as finely as one likes and what is
/// made twice for that costs nothing.
double end_of(const TileTimes& tiles, ddt::CrewSize crew) {
    struct Begun {
        TileTime left;
        double members = 1;
    };
    std::vector<Begun> begun;
    double now = 0;
    for (size_t next = 0;;) {
        for (; next < tiles.size() && begun.size() < crew.places; ++next)
            begun.push_back({tiles[next]});
        if (begun.empty())
            return now;
        // Those who have no tile of their own help to free a place or, where no tile waits for one,
        // join where there is most to do for each.
        for (Begun& tile : begun)
            tile.members = 1;
        const auto rows_for_each = [](const Begun& tile) {
            return tile.left.mesh > 0 ? 0 : tile.left.rows / tile.members;
        };
        const auto has_parts_left = [](const Begun& tile) {
            return tile.left.mesh <= 0 && tile.members < tile.left.parts;
        };
        const auto less = [&](const Begun& a, const Begun& b) {
            return rows_for_each(a) < rows_for_each(b);
        };
        for (size_t i = begun.size(); i < crew.members; ++i) {
            auto join = std::max_element(begun.begin(), begun.end(), less);
            if (next < tiles.size()) {
                const auto first = std::find_if(begun.begin(), begun.end(), has_parts_left);
                join = first != begun.end() ? first : join;
            }
            ++join->members;
        }
        double step = std::numeric_limits<double>::max();
        for (const Begun& tile : begun)
            step = std::min(step, tile.left.mesh > 0 ? tile.left.mesh : rows_for_each(tile));
        now += step;
        for (Begun& tile : begun)
            if (tile.left.mesh > 0)
                tile.left.mesh -= step;
            else
                tile.left.rows -= step * tile.members;
        const auto done = [](const Begun& tile) {
            constexpr double rounding = 1e-12;
            return tile.left.mesh <= rounding && tile.left.rows <= rounding;
        };
        begun.erase(std::remove_if(begun.begin(), begun.end(), done), begun.end());
    }
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
            const Task task{image, scale, 1, &into};
            const TileTimes tiles = time_tiles(filter, task, plan.rounds);
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
                std::printf(" %5.1f", sum / end_of(tiles, crew_of(filter, task, threads)));
            std::printf("\n");
            std::fflush(stdout);
        }
    }
    return true;
}

} // namespace speed
