// SPDX-License-Identifier: Apache-2.0
// What a machine with more cores than this one would make of a job, as far as that is up to how it
// is cut: threads share nothing but a list of tiles, and who is done takes the next.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <queue>

#include "ddt/resize.h"
#include "tables.h"
#include "times.h"

namespace speed {

namespace {

using Clock = std::chrono::steady_clock;

struct TileTimes {
    Times tiles;     ///< seconds, in the order of the tiles
    double rest = 0; ///< before the first and after the last
};

/// On one thread. False on failure, after a line on stderr.
bool time_tiles(const std::string& filter, const OIIO::ImageBuf& image, OIIO::ImageBuf& into,
                TileTimes& times) {
    ddt::Options options;
    std::string error;
    if (!ddt::parse_filter(filter, options, error)) {
        std::fprintf(stderr, "%s\n", error.c_str());
        return false;
    }
    options.device = ddt::Device::cpu;
    Clock::time_point last;
    const auto since_last = [&] {
        const auto now = Clock::now();
        const std::chrono::duration<double> passed = now - last;
        last = now;
        return passed.count();
    };
    times = {};
    options.progress = [&](float) {
        times.tiles.push_back(since_last());
        return true;
    };
    last = Clock::now();
    if (!ddt::resize(into, image, options, into.roi(), 1)) {
        std::fprintf(stderr, "%s: %s\n", filter.c_str(), into.geterror().c_str());
        return false;
    }
    times.rest = since_last();
    return true;
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
            if (!time_tiles(filter, image, into, times))
                return false;
            double sum = times.rest;
            for (const double time : times.tiles)
                sum += time;
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
