// SPDX-License-Identifier: Apache-2.0
// What several threads make of one image, beside what they make of one each.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <deque>
#include <thread>

#include "print.h"

namespace speed {

namespace {

using Seconds = std::chrono::duration<double>;

/// A core that slept is slow to wake: no time is taken of less than this.
constexpr double least_seconds = 0.3;

/// Seconds until all the tasks' runs are done, each task's `calls` on a thread of its own; negative
/// if one failed.
double run_side_by_side(const Way& way, const std::deque<Task>& tasks, int calls) {
    std::vector<double> spent(tasks.size());
    std::vector<std::thread> threads;
    const auto start = std::chrono::steady_clock::now();
    for (size_t i = 0; i < tasks.size(); ++i)
        threads.emplace_back([&, i] { spent[i] = seconds_of(way, tasks[i], calls); });
    for (std::thread& thread : threads)
        thread.join();
    const Seconds all = std::chrono::steady_clock::now() - start;
    return *std::min_element(spent.begin(), spent.end()) < 0 ? -1 : all.count();
}

bool print_row(const Way& way, const OIIO::ImageBuf& image, double scale, Memory memory,
               int threads, int rounds) {
    std::deque<OIIO::ImageBuf> into;
    std::deque<Task> alone;
    for (int i = 0; i < threads; ++i) {
        alone.push_back({image, scale, 1, nullptr});
        if (memory == Memory::warm)
            alone.back().into = &into.emplace_back(warm_image(alone.back()));
    }
    Task together = alone[0];
    together.threads = threads;

    const double once = seconds_of(way, alone[0], 1);
    if (once < 0)
        return false;
    const int calls = std::max(1, int(std::ceil(least_seconds / once)));
    Times one, several, beside;
    for (int round = 0; round < rounds; ++round) {
        one.push_back(seconds_of(way, alone[0], calls));
        several.push_back(seconds_of(way, together, calls));
        beside.push_back(run_side_by_side(way, alone, calls) / threads);
        if (one.back() < 0 || several.back() < 0 || beside.back() < 0)
            return false;
    }
    std::printf("%-14s %4gx %s", way.name.c_str(), scale, name_of(memory));
    print_ratio(ratios(one, several));
    print_ratio(ratios(one, beside));
    std::printf("\n");
    std::fflush(stdout);
    return true;
}

} // namespace

bool print_threads(const Pictures& pictures, const Plan& plan) {
    const int most = *std::max_element(plan.threads.begin(), plan.threads.end());
    if (most == 1)
        return true;
    const Format format = plan.formats[0];
    const OIIO::ImageBuf image = pictures.make(plan.megapixels, format);
    heading("times as fast as 1 thread", image, format, most);
    std::printf("%-26s %15s %15s\n", "", "on one image", "an image each");
    for (const double scale : plan.scales)
        for (const std::string& filter : plan.filters)
            for (const Memory memory : plan.memory)
                if (!print_row(ddt_way(filter), image, scale, memory, most, plan.rounds))
                    return false;
    return true;
}

} // namespace speed
