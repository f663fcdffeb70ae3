// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/gpu/jobs.h"

#include <chrono>
#include <stdexcept>

namespace ddt::bench {

std::vector<double> time_jobs(Picture& picture, const Job& job, int runs, TwiceTheSize& sink) {
    const ResizeMapping mapping = picture.twofold();
    Statistics statistics;
    Job j = job;
    j.statistics = &statistics;
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        std::string error;
        const auto begin = std::chrono::steady_clock::now();
        const Outcome outcome = enlarge(picture, sink, mapping, j, &error);
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
                .count());
        if (outcome != Outcome::done)
            throw std::runtime_error(error);
        if (statistics.device != job.device)
            throw std::runtime_error("another device did the job");
    }
    return times;
}

} // namespace ddt::bench
