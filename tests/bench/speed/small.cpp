// SPDX-License-Identifier: Apache-2.0
// What a call costs beside its pixels: thumbnails, and parts of what is large.
#include <cstdio>

#include "tables.h"
#include "times.h"

namespace speed {

namespace {

struct Small {
    const char* name;
    double megapixels; ///< of the source
    OIIO::ROI part;    ///< of the result at 4x
    int calls;         ///< a round
};

bool print_calls(const Pictures& pictures, const Plan& plan, Format format, int threads,
                 const Small& small) {
    std::vector<Way> ways;
    for (const std::string& filter : plan.filters)
        ways.push_back(ddt_way(filter));
    for (const Way& way : oiio_ways())
        ways.push_back(way);
    if (!small.part.defined())
        for (const Way& way : neighbour_ways())
            ways.push_back(way);
    const OIIO::ImageBuf image = pictures.make(small.megapixels, format);
    Task task{image, 4, threads, nullptr, small.part};
    OIIO::ImageBuf into = warm_image(task);
    task.into = &into;
    std::vector<Times> times;
    if (!measure(ways, task, plan.rounds, times, small.calls))
        return false;
    std::printf("\n%s: %s, %d thread%s\n%-26s %15s %20s\n", small.name, name_of(format), threads,
                threads == 1 ? "" : "s", "", "calls a second",
                ("times of " + ways[0].name + "'s").c_str());
    for (size_t i = 0; i < ways.size(); ++i)
        std::printf("%-26s %15.0f %20.2f\n", ways[i].name.c_str(), small.calls / median(times[i]),
                    ratio(times[i], times[0]));
    std::fflush(stdout);
    return true;
}

} // namespace

bool print_small(const Pictures& pictures, const Plan& plan) {
    {
        const OIIO::ImageBuf image = pictures.make(64 * 64e-6, plan.formats[0]);
        const Task task{image, 4, plan.threads[0], nullptr};
        const Way way = ddt_way(plan.filters[0]);
        const double first = way.run(task), second = way.run(task);
        if (first < 0 || second < 0)
            return false;
        std::printf("first call of %s, 64x64 to 256x256: %.2f ms; the second %.2f ms\n",
                    way.name.c_str(), 1000 * first, 1000 * second);
    }
    const Small smalls[] = {
        {"64x64 to 256x256", 64 * 64e-6, {}, 100},
        {"256x256 to 1024x1024", 256 * 256e-6, {}, 8},
        {"16x16 pixels of 2048x2048", 512 * 512e-6, {1000, 1016, 900, 916, 0, 1, 0, 3}, 40}};
    for (const Format format : plan.formats)
        for (const int threads : plan.threads)
            for (const Small& small : smalls)
                if (!print_calls(pictures, plan, format, threads, small))
                    return false;
    return true;
}

} // namespace speed
