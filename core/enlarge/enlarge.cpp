// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

#include "core/base/guarded.h"
#include "core/base/parallel.h"
#include "core/base/verbose.h"
#include "core/enlarge/whole_source.h"
#include "core/gl/offload.h"
#include "core/tiles/grid.h"
#include "core/tiles/run.h"
#include "core/tiles/tile_worker.h"
#include "ddt/core.h"
#include "ddt/option_table.h"

namespace ddt {

namespace {

/// Workers together take no more than the first, and the second for every thread that is asked for
/// beyond a few; times the meshes. One there is in any case.
constexpr size_t memory_limit = size_t(208) << 20;
constexpr size_t memory_per_thread = size_t(22) << 20;
constexpr size_t few_threads = 16;

/// Largest number of pixels of a window, so that its tiles can be counted.
constexpr double largest_area = double(int64_t(1) << 45);

bool check(const Job& job, std::string& error) {
    const Rect& w = job.window;
    if (w.empty() || std::min(w.x0, w.y0) < -largest_coordinate ||
        std::max(w.x1, w.y1) > largest_coordinate)
        error = "ddt: the source window must not be empty, its coordinates within +-" +
                std::to_string(largest_coordinate);
    else if (double(w.width()) * double(w.height()) > largest_area)
        error = "ddt: the source window must not have more than 2^45 pixels";
    else if (job.channels < 1)
        error = "ddt: there must be at least 1 channel";
    else if (!job.kinds.empty() && job.kinds.size() != size_t(job.channels))
        error = "ddt: Job::kinds must be empty or have one entry a channel";
    else
        return check_options({job.surface, job.mesh, FilterOptions().light, job.device, job.holes},
                             error);
    return false;
}

const char* describe(Outcome outcome) {
    switch (outcome) {
    case Outcome::done:
        return "";
    case Outcome::cancelled:
        return "ddt: cancelled";
    case Outcome::source_failed:
        return "ddt: the source could not be read";
    case Outcome::sink_failed:
        return "ddt: the result could not be written";
    case Outcome::bad_job:
        return "ddt: the job makes no sense";
    case Outcome::out_of_memory:
        return "ddt: out of memory";
    case Outcome::device_unavailable:
        return "ddt: the device is unavailable";
    }
    return "ddt: unknown failure";
}

int thread_count(const Job& job) {
    return job.threads > 0 ? allowed_threads(job.threads) : usual_threads();
}

/// Threads that work on tiles at the same time.
int worker_count(const Job& job, const Mapping& mapping) {
    const auto wanted = size_t(thread_count(job));
    const size_t beyond = wanted - std::min(wanted, few_threads);
    const size_t limit = (memory_limit + beyond * memory_per_thread) * size_t(job.mesh.meshes);
    const size_t fitting = limit / TileWorker::memory(job, mapping.separable());
    return int(std::clamp<size_t>(fitting, 1, wanted));
}

/// Work on all tiles that are not done.
void work_on_cpu(Source& source, Sink& sink, const Mapping& mapping, const Job& job,
                 const Grid& grid, Run& run, Statistics& statistics) {
    const int threads = worker_count(job, mapping);

    auto workers = std::vector<std::unique_ptr<TileWorker>>(size_t(threads));
    for_each_index(threads, grid.count(), [&](int slot, int index) {
        if (!run.going() || run.is_done(index))
            return;
        auto& worker = workers[size_t(slot)];
        if (!worker)
            worker = std::make_unique<TileWorker>(source, sink, mapping, job);
        const Outcome outcome = worker->work(grid.tile(index), run.next_row(index));
        if (outcome == Outcome::done)
            run.tile_done(index);
        else
            run.end(outcome);
    });
    for (const auto& worker : workers)
        if (worker)
            statistics += worker->statistics();
}

/// Tell of a job.
void report(const Placement& placement, const std::string& failure, const Statistics& statistics,
            double seconds) {
    if (!failure.empty())
        say("ddt: %s failed, finished on the CPU: %s", describe(placement).c_str(),
            failure.c_str());
    say("ddt: device %s; %lld pixels, %lld flips, %d iterations, %.1f ms",
        failure.empty() ? describe(placement).c_str() : "cpu",
        static_cast<long long>(statistics.pixels), static_cast<long long>(statistics.flips),
        statistics.iterations, seconds * 1e3);
}

Outcome run(Source& given, Sink& sink, const Mapping& mapping, const Job& job, std::string& why) {
    const auto begin = std::chrono::steady_clock::now();
    Placement placement;
    if (!find_place(job, placement, why))
        return Outcome::device_unavailable;
    WholeSource whole;
    const bool fill = job.holes != Holes::keep;
    if (const Outcome outcome =
            fill ? whole.fill(given, job, thread_count(job), why) : Outcome::done;
        outcome != Outcome::done)
        return outcome;
    Source& source = fill ? whole : given;
    const Grid grid(job.window);
    Run run(job, grid.count());
    Statistics statistics;
    std::string failure;
    if (placement.gpu)
        failure = work_on_gpu(*placement.gpu, source, sink, mapping, job, grid, thread_count(job),
                              run, statistics);
    const bool on_cpu = !placement.gpu || !failure.empty();
    statistics.device = on_cpu ? Device::cpu : placement.device;
    if (on_cpu)
        work_on_cpu(source, sink, mapping, job, grid, run, statistics);
    if (job.statistics)
        *job.statistics = statistics;
    if (verbose())
        report(placement, failure, statistics,
               std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    return run.outcome();
}

} // namespace

Outcome enlarge(Source& source, Sink& sink, const Mapping& mapping, const Job& job,
                std::string* error) {
    Outcome outcome = Outcome::bad_job;
    const Caught caught = guarded_call(error, [&] {
        std::string why;
        if (check(job, why))
            outcome = run(source, sink, mapping, job, why);
        if (outcome != Outcome::done && why.empty())
            why = describe(outcome);
        if (error)
            *error = std::move(why);
    });
    switch (caught) {
    case Caught::nothing:
        return outcome;
    case Caught::out_of_memory:
        return Outcome::out_of_memory;
    case Caught::other:
        break;
    }
    return Outcome::bad_job;
}

} // namespace ddt
