// SPDX-License-Identifier: Apache-2.0
#include "tables.h"

#include <algorithm>
#include <cstdio>

#include "growth.h"
#include "print.h"
#include "times.h"

namespace speed {

namespace {

double output_pixels(const OIIO::ImageBuf& image, double scale) {
    return double(image.spec().image_pixels()) * scale * scale;
}

/// A row of the stages' medians.
bool print_stages_of(const std::string& filter, const OIIO::ImageBuf& image, double scale,
                     Memory memory, int rounds) {
    ddt::Statistics s;
    const Way way = ddt_way(filter, &s);
    OIIO::ImageBuf into;
    Task task{image, scale, 1, nullptr};
    if (memory == Memory::warm) {
        into = warm_image(task);
        task.into = &into;
    }
    if (way.run(task) < 0) // the first finds caches that others have filled
        return false;
    Times stage[5];
    for (int round = 0; round < rounds; ++round) {
        if (way.run(task) < 0)
            return false;
        const int64_t spent[5] = {s.times.read, s.times.triangulate, s.times.surface,
                                  s.times.sample, s.times.write};
        for (int i = 0; i < 5; ++i)
            stage[i].push_back(double(spent[i]) / output_pixels(image, scale));
    }
    // Halos are worked on too: a pixel of the image is less than one of the tiles'.
    const double source = double(image.spec().image_pixels());
    std::printf("%-14s %4gx %s %7.2f %11.2f %7.2f %7.2f %7.2f   %.2f, %.2f\n", filter.c_str(),
                scale, name_of(memory), median(stage[0]), median(stage[1]), median(stage[2]),
                median(stage[3]), median(stage[4]), double(s.evaluations) / source,
                double(s.flips) / source);
    std::fflush(stdout);
    return true;
}

} // namespace

bool print_ratios(const Pictures& pictures, const Plan& plan) {
    std::vector<Way> ways;
    for (const std::string& filter : plan.filters)
        ways.push_back(ddt_way(filter));
    for (const Way& way : oiio_ways())
        ways.push_back(way);
    for (const Way& way : neighbour_ways())
        ways.push_back(way);
    if (plan.programs)
        for (const Way& way : program_ways())
            ways.push_back(way);
    const size_t ours = plan.filters.size();
    std::vector<Times> times;
    for (const Format format : plan.formats)
        for (const int threads : plan.threads) {
            const OIIO::ImageBuf image = pictures.make(plan.megapixels, format);
            heading("times as fast as (and the middle half of the rounds)", image, format, threads);
            std::printf("%-26s", "");
            for (size_t other = ours; other < ways.size(); ++other)
                std::printf(" %15s", ways[other].name.c_str());
            std::printf(" %15s\n", "ns/output pixel");
            for (const double scale : plan.scales)
                for (const Memory memory : plan.memory) {
                    OIIO::ImageBuf into;
                    Task task{image, scale, threads, nullptr};
                    if (memory == Memory::warm) {
                        into = warm_image(task);
                        task.into = &into;
                    }
                    if (!measure(ways, task, plan.rounds, times))
                        return false;
                    for (size_t i = 0; i < ours; ++i) {
                        std::printf("%-14s %4gx %s", ways[i].name.c_str(), scale, name_of(memory));
                        for (size_t other = ours; other < ways.size(); ++other)
                            print_ratio(ratios(times[other], times[i]));
                        std::printf(" %15.2f\n",
                                    median(times[i]) * 1e9 / output_pixels(image, scale));
                        std::fflush(stdout);
                    }
                }
        }
    return true;
}

bool print_stages(const Pictures& pictures, const Plan& plan) {
    for (const Format format : plan.formats) {
        const OIIO::ImageBuf image = pictures.make(plan.megapixels, format);
        heading("ns/output pixel", image, format, 1);
        std::printf("%-26s %7s %11s %7s %7s %7s   evaluations, flips a source pixel\n", "", "guide",
                    "triangulate", "surface", "sample", "encode");
        for (const double scale : plan.scales)
            for (const std::string& filter : plan.filters)
                for (const Memory memory : plan.memory)
                    if (!print_stages_of(filter, image, scale, memory, plan.rounds))
                        return false;
    }
    return true;
}

bool print_growth(const Pictures& pictures, const Plan& plan) {
    constexpr double scale = 2, smallest = 0.25;
    std::printf("\nns/output pixel over megapixels of source: %gx, %s, 1 thread\n", scale,
                name_of(Format::srgb_8bit));
    std::printf("%-14s", "");
    for (double size = smallest; size <= plan.largest; size *= 4)
        std::printf(" %7g", size);
    std::printf("   exponent\n");
    std::vector<Way> ways;
    for (const std::string& filter : plan.filters)
        ways.push_back(ddt_way(filter));
    std::vector<std::vector<std::pair<double, double>>> points(ways.size()); // pixels, seconds
    for (double size = smallest; size <= plan.largest; size *= 4) {
        const OIIO::ImageBuf image = pictures.make(size, Format::srgb_8bit);
        std::vector<Times> times;
        if (!measure(ways, {image, scale, 1, nullptr}, size > 4 ? 1 : plan.rounds, times))
            return false;
        for (size_t i = 0; i < ways.size(); ++i)
            points[i].emplace_back(double(image.spec().image_pixels()), median(times[i]));
    }
    for (size_t i = 0; i < ways.size(); ++i) {
        std::printf("%-14s", ways[i].name.c_str());
        for (const auto& [pixels, time] : points[i])
            std::printf(" %7.2f", time * 1e9 / (pixels * scale * scale));
        std::printf("   %s\n", bench::exponent_text(points[i]).c_str());
    }
    return true;
}

} // namespace speed
