// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/guarded.h"
#include "core/base/log.h"
#include "core/base/one_line.h"
#include "core/base/progress.h"
#include "core/base/stopwatch.h"
#include "core/enlarge/thread_count.h"
#include "core/fill/fill.h"
#include "core/fill/whole_source.h"
#include "core/gl/offload.h"
#include "core/tiles/grid.h"
#include "core/tiles/job_state.h"
#include "core/tiles/tile_io.h"
#include "core/tiles/work_line.h"
#include "core/tiles/work_on_cpu.h"
#include "ddt/core.h"
#include "ddt/option_table.h"

namespace ddt {

namespace {

/// Largest number of pixels of a window, so that its tiles can be counted.
constexpr double largest_area = double(int64_t(1) << 45);

bool check(const Job& job, const Mapping& mapping, std::string& error) {
    const Rect& w = job.window;
    if (w.empty() || !w.within_limits())
        error = "ddt: the source window must not be empty, its coordinates within +-" +
                std::to_string(largest_coordinate);
    else if (double(w.width()) * double(w.height()) > largest_area)
        error = "ddt: the source window must not have more than 2^45 pixels";
    else if (const Rect out = output_of(mapping); !out.empty() && !out.within_limits())
        error =
            "ddt: the output's coordinates must be within +-" + std::to_string(largest_coordinate);
    else if (job.channels < 1)
        error = "ddt: there must be at least 1 channel";
    else if (!job.kinds.empty() && job.kinds.size() != size_t(job.channels))
        error = "ddt: Job::kinds must be empty or have one entry a channel";
    else if (std::any_of(job.kinds.begin(), job.kinds.end(),
                         [](Channel kind) { return kind > Channel::nearest; }))
        error = "ddt: Job::kinds must be blend, alpha or nearest";
    else
        return check_options({job.surface, job.mesh, FilterOptions().light, job.device, job.holes},
                             error);
    return false;
}

std::string describe(Outcome outcome) {
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
        return with_prefix(out_of_memory_text);
    case Outcome::device_unavailable:
        return "ddt: the device is unavailable";
    }
    return "ddt: unknown failure";
}

/// Tell of a job.
void report(const Placement& placement, const std::string& failure, const Statistics& statistics,
            double milliseconds) {
    if (!failure.empty())
        say("ddt: %s failed, finished on the CPU: %s", describe(placement).c_str(),
            failure.c_str());
    say_worked(failure.empty() ? describe(placement) : "cpu",
               std::to_string(statistics.pixels) + " pixels", statistics, milliseconds);
}

/// Work on the tiles that are shown. failure: what the GPU failed at, if it did.
Outcome work(const TiledJob& tiled, const Placement& placement, Statistics& statistics,
             std::string& failure) {
    const Job& job = tiled.job;
    JobState state(job, tiled.grid.count());
    if (tiled.grid.count() == 0)
        state.nothing_to_do();
    if (placement.gpu)
        failure = work_on_gpu(*placement.gpu, tiled, state, statistics);
    else
        missed_gpu(job, pixels_a_thread(tiled.grid.pixels().area(), job));
    const bool on_cpu = !placement.gpu || !failure.empty();
    statistics.device = on_cpu ? Device::cpu : placement.device;
    if (on_cpu)
        work_on_cpu(tiled, state, statistics);
    if (job.statistics)
        *job.statistics = statistics;
    return state.outcome();
}

Outcome run(Source& source, Sink& sink, const Mapping& mapping, const Job& job, std::string& why) {
    const Stopwatch watch;
    const Grid grid = shown_tiles(job.window, mapping);
    Placement placement;
    if (!choose_device(job, pixels_a_thread(grid.pixels().area(), job), placement, why))
        return Outcome::device_unavailable;
    Statistics statistics;
    if (job.statistics)
        *job.statistics = statistics; // of work that does not begin
    std::string failure;
    Outcome outcome;
    const int threads = thread_count(job);
    if (job.holes == Holes::keep) {
        outcome = work({source, sink, mapping, job, grid, threads}, placement, statistics, failure);
    } else {
        float filled = 0; // share done by then: that of reading, where nothing is missing
        ProgressCallback filling;
        if (job.progress)
            filling = [&](float share) {
                filled = share * share_of_filling;
                return job.progress(filled);
            };
        WholeSource whole;
        outcome = whole.fill(source, job, threads, filling, why);
        if (outcome != Outcome::done)
            return outcome;
        Job rest = job;
        rest.progress = part_of(job.progress, filled, 1);
        outcome = work({whole, sink, mapping, rest, grid, threads}, placement, statistics, failure);
    }
    if (verbose())
        report(placement, failure, statistics, watch.milliseconds());
    return outcome;
}

} // namespace

Outcome enlarge(Source& source, Sink& sink, const Mapping& mapping, const Job& job,
                std::string* error) noexcept {
    Outcome outcome = Outcome::bad_job;
    const Caught caught = guarded_call(error, [&] {
        std::string why;
        if (check(job, mapping, why)) {
            Job own = job;
            own.progress = until_it_ends(job.progress);
            outcome = run(source, sink, mapping, own, why);
        }
        if (outcome != Outcome::done && why.empty())
            why = describe(outcome);
        if (error)
            *error = one_line(why);
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
