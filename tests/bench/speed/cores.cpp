// SPDX-License-Identifier: Apache-2.0
// What a machine with more cores than this one would make of a job, as far as that is up to how it
// is cut: threads share nothing but a list of tiles, and who is done takes the next.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <numeric>
#include <queue>

#include "tables.h"
#include "times.h"

namespace speed {

namespace {

using Clock = std::chrono::steady_clock;

struct TileTimes {
    Times tiles;     ///< seconds, in the order of the tiles
    double rest = 0; ///< after the last
};

/// On one thread. False on failure, after a line on stderr.
bool time_tiles(const std::string& filter, const Task& task, TileTimes& times) {
    times = {};
    auto last = Clock::now();
    const Way way = ddt_way(filter + ",device=cpu", nullptr, [&](float) {
        const auto now = Clock::now();
        times.tiles.push_back(std::chrono::duration<double>(now - last).count());
        last = now;
        return true;
    });
    const double all = way.run(task);
    times.rest = all - std::accumulate(times.tiles.begin(), times.tiles.end(), 0.0);
    return all >= 0;
}

/// When the last of so many threads is done.
double end_of(const Times& tiles, int threads) {
    std::priority_queue<double, Times, std::greater<double>> idle_at;
    for (int i = 0; i < threads; ++i)
        idle_at.push(0);
    double end = 0;
    for (const double time : tiles) {
        const double done = idle_at.top() + time;
        idle_at.pop();
        idle_at.push(done);
        end = std::max(end, done);
    }
    return end;
}

} // namespace

bool print_cores(const Pictures& pictures, const Plan& plan) {
    const Format format = plan.formats[0];
    const OIIO::ImageBuf image = pictures.make(plan.megapixels, format);
    std::printf("\ntimes as fast as 1 thread, by the tiles' times: %dx%d RGB, %s\n"
                "%-19s %5s %25s %10s",
                image.spec().width, image.spec().height, name_of(format), "", "tiles",
                "ms a tile, least to most", "beside, ms");
    constexpr int counts[] = {8, 16, 32, 64, 128};
    for (const int threads : counts)
        std::printf(" %5d", threads);
    std::printf("\n");
    for (const double scale : plan.scales) {
        OIIO::ImageBuf into = warm_image({image, scale, 1, nullptr});
        for (const std::string& filter : plan.filters) {
            TileTimes times;
            if (!time_tiles(filter, {image, scale, 1, &into}, times))
                return false;
            const double sum = std::accumulate(times.tiles.begin(), times.tiles.end(), times.rest);
            const auto [least, most] = std::minmax_element(times.tiles.begin(), times.tiles.end());
            std::printf("%-14s %3gx %5zu %9.1f %7.1f %7.1f %10.2f", filter.c_str(), scale,
                        times.tiles.size(), *least * 1e3, median(times.tiles) * 1e3, *most * 1e3,
                        times.rest * 1e3);
            for (const int threads : counts)
                std::printf(" %5.1f", sum / (times.rest + end_of(times.tiles, threads)));
            std::printf("\n");
            std::fflush(stdout);
        }
    }
    return true;
}

} // namespace speed
